//! What is not finite in one element stays there.

use ga_core::Element;
use ga_lanes::{Batch, One};

use super::plane;
use super::r3;
use super::samples::{assert_same, elements, on_every_target};

#[test]
fn elements_that_are_not_finite_leave_their_neighbours_alone() {
    on_every_target(|| {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
            for place in [0, 1, 6, 18] {
                let motors = elements::<plane::Motor<f64>>(19, 1);
                let mut points = elements::<plane::Point<f64>>(19, 2);
                points[place] = Element::from_fn(|_| bad);
                let images = Batch::from_slice(&motors)
                    .apply(&Batch::from_slice(&points))
                    .unwrap();
                let (mut images, mut expected): (Vec<_>, Vec<_>) = (
                    images.to_vec(),
                    motors
                        .iter()
                        .zip(&points)
                        .map(|(m, p)| m.apply(*p))
                        .collect(),
                );
                images.remove(place);
                expected.remove(place);
                assert_same(&Batch::from_slice(&images), &expected, "apply");

                let mut planes = elements::<r3::Bivector<f64>>(19, 3);
                planes[place] = Element::from_fn(|_| bad);
                let mut own = Batch::from_slice(&planes).exp().to_vec();
                let mut expected: Vec<_> = planes.iter().map(|plane| plane.exp()).collect();
                own.remove(place);
                expected.remove(place);
                assert_same(&Batch::from_slice(&own), &expected, "exp");
            }
        }
    });
}

#[test]
fn division_by_zero_is_that_of_floats() {
    on_every_target(|| {
        let quotients = Batch::from_slice(&[r3::Vector::new(1.0, -1.0, 0.0); 5])
            .quotient(One(0.0_f64))
            .unwrap();
        for quotient in quotients.iter() {
            assert_eq!(
                (quotient.e1, quotient.e2),
                (f64::INFINITY, f64::NEG_INFINITY)
            );
            assert!(quotient.e3.is_nan());
        }
    });
}
