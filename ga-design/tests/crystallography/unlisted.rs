//! Whether settings that are in no table are recognised, and their groups grown as the independent
//! program moyo has them.

use std::collections::BTreeSet;

use crate::groups::{key, operations_of_moyo};
use ga_cga::{Point, Vector3};
use ga_design::crystallography::{
    Cell, GenerationError, Operation, Recognition, SpaceGroup, WyckoffPositions,
};

fn recognised(hall: &str) -> Recognition {
    Recognition::of_hall(hall).unwrap_or_else(|| panic!("{hall} is not recognised"))
}

/// A cell of the setting in a lattice of the group.
fn cell_of(setting: &Recognition) -> Cell {
    let standard = SpaceGroup::standard(setting.number).expect("1 to 230");
    let cell = standard.cell_shape().example().cell().expect("a cell");
    setting.cell(&cell).expect("a cell")
}

/// Grows the group in its cell and compares it with moyo's.
fn compare(hall: &str) -> Recognition {
    let setting = recognised(hall);
    let cell = cell_of(&setting);
    let generation = setting
        .generate(&cell)
        .unwrap_or_else(|error| panic!("{hall}: {error}"));
    let operations = generation.operations();
    let grown: BTreeSet<_> = operations.iter().map(key).collect();
    assert_eq!(grown.len(), operations.len(), "{hall}: one twice");
    assert_eq!(grown, operations_of_moyo(hall), "{hall}");
    // In space the versors do what the operations do in fractions of the edges.
    for (operation, versor) in operations.iter().zip(generation.versors()) {
        let place = [0.13, 0.29, 0.41];
        let point = Point::from(Vector3::from(cell.cartesian(place)));
        let wanted = cell.cartesian(operation.apply(place));
        let apart = versor.apply(point).position() - Vector3::from(wanted);
        assert!(apart.norm() < 1e-9, "{hall}: {operation}");
    }
    setting
}

#[test]
fn every_group_is_grown_about_an_unusual_origin() {
    let mut unlisted = 0;
    for number in 1..=230 {
        let standard = SpaceGroup::standard(number).expect("1 to 230");
        if standard.hall.contains('(') {
            continue;
        }
        // By 1/12, 1/6 and 5/12 of the edges.
        let hall = format!("{} (1 2 5)", standard.hall);
        assert_eq!(compare(&hall).number, number, "{hall}");
        unlisted += usize::from(SpaceGroup::from_hall(&hall).is_none());
        let setting = recognised(&hall);
        let positions = WyckoffPositions::in_setting(number, &setting.from_standard);
        let usual = WyckoffPositions::standard(number).expect("positions");
        assert_eq!(
            positions.map(|all| all.positions().len()),
            Some(usual.positions().len())
        );
    }
    assert!(unlisted > 200, "only {unlisted}");
}

#[test]
fn every_group_is_grown_in_an_unusual_cell() {
    // The larger cells of tetragonal groups (International Tables, 1.5.4), and stranger ones.
    for (hall, number) in [
        ("C 4", 75),
        ("-C 4 2", 123),
        ("F 4 2", 97),
        ("-F 4 2", 139),
        ("C -4 2", 115),
        ("F 2 2 3", 196),
        ("A 2 2", 21),
    ] {
        assert_eq!(compare(hall).number, number, "{hall}");
    }
}

#[test]
fn what_is_no_hall_symbol_or_no_cell_is_refused() {
    for wrong in [
        "",
        "P",
        "F",
        "P 21/c",
        "P 2 (",
        "P 2 (1 2)",
        "X 2",
        "227",
        "P 99",
    ] {
        assert_eq!(Recognition::of_hall(wrong), None, "{wrong}");
    }
    let setting = recognised("-P 4 2 (1 2 5)");
    let long = Cell::new([4.0, 5.0, 6.0], [90.0; 3]).expect("a cell");
    let error = setting.generate(&long).expect_err("no tetragonal cell");
    assert!(matches!(error, GenerationError::Constraint(_)), "{error}");
    assert!(error.to_string().contains("a = b"), "{error}");
    // Rounding is taken out.
    let rounded = Cell::new([4.0, 4.0001, 6.0], [90.0, 90.0, 90.01]).expect("a cell");
    let exact = setting.idealized(&rounded).expect("a cell");
    assert!((exact.edges()[0] - exact.edges()[1]).abs() < 1e-12);
    assert!(
        exact
            .angles()
            .iter()
            .all(|angle| (angle - 90.0).abs() < 1e-9)
    );
    let identity: Operation = "x,y,z".parse().expect("an operation");
    assert_eq!(
        SpaceGroup::recognise(&[identity]).map(|found| found.number),
        Some(1)
    );
}
