//! Whether changes of basis carry operations as International Tables say, and the stored ones lead
//! from each standard setting to the others.

use std::collections::HashSet;

use ga_design::crystallography::{ChangeOfBasis, ChangeOfBasisError, Operation, SpaceGroup};
use num_rational::Ratio;

fn change(text: &str) -> ChangeOfBasis {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

fn operations(group: &SpaceGroup) -> Vec<Operation> {
    group.operations().expect("a Hall symbol of the table")
}

#[test]
fn every_setting_comes_from_the_standard_one_and_goes_back() {
    for group in SpaceGroup::table() {
        let name = group.qualified_symbol();
        let standard = SpaceGroup::standard(group.number).expect("1 to 230");
        let change = group.from_standard().unwrap_or_else(|| panic!("{name}"));
        assert!(*change.determinant().numer() > 0, "{name} turns the hand");
        let carried = change
            .operations(&operations(standard))
            .unwrap_or_else(|| panic!("{name}: {change}"));
        let ours: HashSet<_> = operations(group).into_iter().collect();
        assert_eq!(carried.into_iter().collect::<HashSet<_>>(), ours, "{name}");

        let back = change
            .inverse()
            .operations(&operations(group))
            .unwrap_or_else(|| panic!("{name}: {change}"));
        let theirs: HashSet<_> = operations(standard).into_iter().collect();
        assert_eq!(back.into_iter().collect::<HashSet<_>>(), theirs, "{name}");
        if group.standard {
            assert_eq!(change, ChangeOfBasis::identity(), "{name}");
        }
        assert_eq!(change.to_string().parse(), Ok(change), "{name}");
    }
}

#[test]
fn changes_chain_and_points_go_along() {
    let first = change("x-y+1/4,x+y,z");
    let second = change("-z,1/2y+1/3,x");
    let both = first.then(&second).expect("small numbers");
    let point = [0.1, -0.7, 2.3];
    let stepwise = first.to_old(second.to_old(point));
    for (one, other) in both.to_old(point).into_iter().zip(stepwise) {
        assert!((one - other).abs() < 1e-14);
    }
    for (one, other) in both.to_new(both.to_old(point)).into_iter().zip(point) {
        assert!((one - other).abs() < 1e-14);
    }
    assert_eq!(both.then(&both.inverse()), Some(ChangeOfBasis::identity()));
    assert_eq!(first.determinant(), Ratio::from_integer(2));
}

#[test]
fn a_cell_that_is_no_cell_of_the_group_is_refused() {
    let cubic = operations(SpaceGroup::standard(221).expect("a number"));
    // Half an edge is no translation of a primitive lattice.
    assert_eq!(change("1/2x,y,z").operations(&cubic), None);
    // A doubled edge breaks the cubic symmetry.
    assert_eq!(change("2x,y,z").operations(&cubic), None);
    // Eight small cells do not: the old translations centre the large cell.
    let eight = change("2x,2y,2z")
        .operations(&cubic)
        .expect("all eight cells");
    assert_eq!(eight.len(), 8 * 48);
}

#[test]
fn what_cannot_be_undone_or_is_beyond_bounds_is_refused() {
    for text in ["x,y,x+y", "0x,y,z", "100000x,y,z"] {
        let read: Result<ChangeOfBasis, _> = text.parse();
        assert_eq!(read, Err(ChangeOfBasisError::Singular), "{text}");
    }
    for text in ["", "x,y", "x,y,w", "x,y,z/0"] {
        let read: Result<ChangeOfBasis, _> = text.parse();
        assert!(
            matches!(read, Err(ChangeOfBasisError::Triplet(_))),
            "{text}"
        );
    }
    let zero = Ratio::new_raw(1, 0);
    let one = Ratio::from_integer(1);
    let nought = Ratio::from_integer(0);
    let unit = [
        [one, nought, nought],
        [nought, one, nought],
        [nought, nought, one],
    ];
    assert_eq!(ChangeOfBasis::new(unit, [zero, nought, nought]), None);
    let huge = Ratio::from_integer(i64::MAX);
    assert_eq!(ChangeOfBasis::new(unit, [huge, nought, nought]), None);
    let least = Ratio::from_integer(i64::MIN);
    assert_eq!(ChangeOfBasis::new(unit, [least, nought, nought]), None);
}
