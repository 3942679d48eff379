//! Batches as containers: what goes in comes out.

use ga_core::Element;
use ga_lanes::{Batch, Target};

use super::plane::Point;
use super::samples::{LENGTHS, elements};

#[test]
fn elements_come_back_as_they_went_in() {
    for len in LENGTHS {
        let points = elements::<Point<f32>>(len, 1);
        let batch = Batch::from_slice(&points);
        assert_eq!((batch.len(), batch.is_empty()), (len, len == 0));
        assert_eq!(batch.to_vec(), points);
        assert_eq!(Vec::from(batch.clone()), points);
        assert_eq!(batch.iter().len(), len);
        assert_eq!(batch.get(len), None);
        let mut pushed = Batch::new();
        points.iter().for_each(|point| pushed.push(*point));
        assert_eq!(pushed, batch);
        let collected: Batch<_> = points.iter().copied().collect();
        assert_eq!(collected, batch);
        let mut extended = Batch::with_capacity(3);
        extended.extend(&points[..len / 2]);
        extended.extend(points[len / 2..].iter().copied());
        assert_eq!(extended, batch);
        assert_eq!(Batch::from(points.as_slice()), batch);
    }
}

#[test]
fn columns_hold_the_coefficients_of_one_field() {
    for len in LENGTHS {
        let points = elements::<Point<f64>>(len, 2);
        let mut batch = Batch::from_slice(&points);
        assert_eq!(batch.columns().len(), 3);
        for position in 0..3 {
            let column: Vec<_> = points.iter().map(|point| point.at(position)).collect();
            assert_eq!(batch.column(position), Some(column.as_slice()));
            assert_eq!(batch.column_mut(position).map(|c| c.to_vec()), Some(column));
        }
        assert_eq!(batch.column(3), None);
        assert_eq!(batch.column_mut(3), None);
        for column in batch.columns_mut() {
            column.fill(7.0);
        }
        assert!(batch.iter().all(|point| point == Point::new(7.0, 7.0, 7.0)));
    }
}

#[test]
fn single_elements_are_replaced() {
    let points = elements::<Point<f64>>(20, 3);
    let mut batch = Batch::from_slice(&points);
    let other = Point::new(1.0, 2.0, 3.0);
    assert_eq!(batch.replace(17, other), Some(points[17]));
    assert_eq!(batch.replace(20, other), None);
    assert_eq!(batch.get(17), Some(other));
    assert_eq!(
        (batch.get(16), batch.get(18)),
        (Some(points[16]), Some(points[18]))
    );
}

#[test]
fn a_batch_that_grows_again_holds_zeros() {
    let mut batch = Batch::from_slice(&elements::<Point<f32>>(30, 4));
    batch.resize(5);
    assert_eq!(batch.len(), 5);
    batch.resize(40);
    assert!(
        batch
            .iter()
            .skip(5)
            .all(|point| point == Point::new(0.0, 0.0, 0.0))
    );
    batch.clear();
    assert!(batch.is_empty() && batch.get(0).is_none());
    assert_eq!(batch, Batch::default());
    assert_eq!(
        format!("{:?}", Batch::from_slice(&[1.0, 2.0])),
        "[1.0, 2.0]"
    );
}

#[test]
fn targets_are_chosen_for_a_while() {
    let outside = Target::current();
    assert_eq!(outside, Target::widest());
    for target in Target::ALL {
        assert_eq!(
            target.scope(Target::current),
            target.is_available().then_some(target)
        );
        assert_eq!(Target::current(), outside);
    }
    let caught = std::panic::catch_unwind(|| Target::Portable.scope(|| panic!("on purpose")));
    assert!(caught.is_err());
    assert_eq!(Target::current(), outside);
}
