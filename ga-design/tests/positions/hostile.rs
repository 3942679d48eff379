//! Whether anything at all, as a symbol, a change of basis, a list of operations or a point, gives an
//! answer and never a panic.

use ga_design::crystallography::{
    Cell, ChangeOfBasis, Operation, SpaceGroup, SubperiodicGroup, SubperiodicKind,
    SubperiodicOperation, WyckoffPositions, close,
};
use num_rational::Ratio;
use proptest::prelude::*;

fn operation() -> impl Strategy<Value = Operation> {
    let entry = prop_oneof![4 => -1..=1, 1 => -16..=16];
    let matrix = prop::array::uniform3(prop::array::uniform3(entry));
    let shift = prop::array::uniform3((0..5040).prop_map(|part| Ratio::new(part, 5040)));
    (matrix, shift).prop_filter_map("determinant", |(matrix, shift)| {
        Operation::new(matrix, shift)
    })
}

fn ratio() -> impl Strategy<Value = Ratio<i64>> {
    let number = prop_oneof![4 => -3..=3_i64, 1 => -100_000..=100_000_i64, 1 => any::<i64>()];
    let below =
        prop_oneof![3 => Just(1_i64), 2 => 1..=8_i64, 1 => 0..=130_000_i64, 1 => any::<i64>()];
    (number, below).prop_map(|(above, below)| Ratio::new_raw(above, below))
}

fn change() -> impl Strategy<Value = Option<ChangeOfBasis>> {
    let matrix = prop::array::uniform3(prop::array::uniform3(ratio()));
    (matrix, prop::array::uniform3(ratio())).prop_map(|(m, p)| ChangeOfBasis::new(m, p))
}

/// Symbols cut and mixed from real ones, and anything else.
fn text() -> impl Strategy<Value = String> {
    let mixed = "[PCFIRpc]?[ ]?(-?[1-6][1-6]?|[abcdemn]|/|\\(|\\)|:|\\^|_| |[0-9]|D2h|Oh|Td){0,12}";
    prop_oneof![mixed.prop_map(|text| text), any::<String>()]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn any_text_is_looked_up(text in text()) {
        for found in SpaceGroup::find(&text).iter().flatten() {
            prop_assert!((1..=230).contains(&found.number));
        }
        let _ = SpaceGroup::from_hall(&text);
        let _ = SpaceGroup::from_schoenflies(&text);
        for kind in SubperiodicKind::ALL {
            for found in SubperiodicGroup::from_symbol(kind, &text).iter().flatten() {
                prop_assert!((1..=kind.count()).contains(&found.number));
            }
        }
        let _: Result<ChangeOfBasis, _> = text.parse();
    }

    #[test]
    fn any_operations_are_recognised_or_not(list in prop::collection::vec(operation(), 0..4)) {
        let _ = SpaceGroup::recognise(&list);
        if let Ok(closed) = close(&list) {
            // Every finite group of operations is a space group, unless its cell is too odd.
            if let Some(found) = SpaceGroup::recognise(&closed) {
                let standard = SpaceGroup::standard(found.number).expect("1 to 230");
                let operations = standard.operations().expect("a Hall symbol");
                let carried = found.from_standard.operations(&operations);
                prop_assert_eq!(carried.map(|all| all.len()), Some(closed.len()));
                let _ = WyckoffPositions::in_setting(found.number, &found.from_standard);
            }
        }
        for one in list {
            for kind in SubperiodicKind::ALL {
                let _ = SubperiodicOperation::new(kind, one);
            }
        }
    }

    #[test]
    fn any_change_of_basis_can_be_undone(one in change(), other in change(), number in 1..=230_u32) {
        let (Some(one), Some(other)) = (one, other) else {
            return Ok(());
        };
        prop_assert_eq!(one.inverse().inverse(), one);
        prop_assert_eq!(one.then(&one.inverse()), Some(ChangeOfBasis::identity()));
        prop_assert_eq!(one.to_string().parse().ok(), Some(one));
        let _ = one.then(&other);
        let standard = SpaceGroup::standard(number).expect("1 to 230");
        let operations = standard.operations().expect("a Hall symbol");
        if let Some(carried) = one.operations(&operations) {
            let back = one.inverse().operations(&carried);
            prop_assert_eq!(back.map(|all| all.len()), Some(operations.len()));
        }
        let _ = WyckoffPositions::in_setting(number, &one);
        let _ = WyckoffPositions::in_setting(1, &one);
        let _ = WyckoffPositions::in_setting(2, &one);
    }

    #[test]
    fn any_point_is_located_or_refused(
        point in prop::array::uniform3(prop_oneof![4 => -2.0..2.0, 1 => any::<f64>()]),
        tolerance in prop_oneof![4 => 0.0..1.0, 1 => any::<f64>()],
        number in 1..=230_u32,
    ) {
        let cell = Cell::new([5.0, 6.0, 70.0], [70.0, 80.0, 100.0]).expect("a cell");
        let all = WyckoffPositions::standard(number).expect("1 to 230");
        if let Some(site) = all.locate(point, &cell, tolerance) {
            prop_assert!(site.place.iter().all(|value| value.is_finite()));
            prop_assert!(site.distance >= 0.0 && site.distance <= tolerance);
        }
    }
}
