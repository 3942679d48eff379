//! Isometries as versors: products, inverses, their kinds, and operations both ways.

use std::f64::consts::{FRAC_PI_2, PI};

use ga_cga::{DualPlane, Motor, Point, Rotor, Translator, Vector3};
use ga_design::crystallography::{
    Cell, Isometry, Motion, NotOfLattice, Operation, PlacementError, SpaceGroup,
};
use proptest::prelude::*;

fn cell(edges: [f64; 3], angles: [f64; 3]) -> Cell {
    Cell::new(edges, angles).expect("a cell")
}

fn op_trace(w: [[i32; 3]; 3]) -> i32 {
    w[0][0] + w[1][1] + w[2][2]
}

/// A cell with the symmetry of a setting's crystal system, without any more.
fn fitting(group: &SpaceGroup) -> Cell {
    let rhombohedral = group.choice == Some('R');
    match group.number {
        1..=2 => cell([5.1, 6.2, 7.3], [81.0, 97.0, 103.0]),
        3..=15 => {
            let operations = group.operations().expect("operations");
            let unique = operations
                .iter()
                .map(|op| op.rotation())
                .filter_map(|w| {
                    // Along the unique axis the sign differs from the two others.
                    let total = op_trace(w);
                    (0..3).find(|&i| total.abs() == 1 && w[i][i] != total.signum())
                })
                .next()
                .expect("a unique axis");
            let mut angles = [90.0; 3];
            angles[unique] = 107.0;
            cell([5.1, 6.2, 7.3], angles)
        }
        16..=74 => cell([5.1, 6.2, 7.3], [90.0; 3]),
        75..=142 => cell([5.1, 5.1, 7.3], [90.0; 3]),
        143..=194 if rhombohedral => cell([5.1; 3], [77.0; 3]),
        143..=194 => cell([5.1, 5.1, 7.3], [90.0, 90.0, 120.0]),
        _ => cell([5.1; 3], [90.0; 3]),
    }
}

#[test]
fn operations_of_all_settings_become_versors_and_come_back() {
    for group in SpaceGroup::table() {
        let cell = fitting(group);
        for operation in group.operations().expect("operations") {
            let versor = Isometry::of_operation(&operation, &cell)
                .unwrap_or_else(|e| panic!("{} {operation}: {e}", group.symbol));
            assert_eq!(versor.operation(&cell), Ok(operation), "{}", group.symbol);
            assert_eq!(versor.is_proper(), operation.determinant() == 1);
            // The versor does to points what the triplet does to their fractions.
            let fraction = [0.13, 0.29, 0.41];
            let point = Point::from(Vector3::from(cell.cartesian(fraction)));
            let image = cell.cartesian(operation.apply(fraction));
            let apart = versor.apply(point).position() - Vector3::from(image);
            assert!(apart.norm() < 1e-9, "{} {operation}", group.symbol);
        }
    }
}

#[test]
fn products_of_versors_are_products_of_operations() {
    for number in [14, 88, 122, 167, 180, 205, 230] {
        let group = SpaceGroup::standard(number).expect("a space group");
        let cell = fitting(group);
        let operations = group.operations().expect("operations");
        let versors: Vec<Isometry> = operations
            .iter()
            .map(|op| Isometry::of_operation(op, &cell).expect("it fits"))
            .collect();
        for (one, versor) in operations.iter().zip(&versors) {
            let inverse = one.inverse().expect("an inverse");
            assert_eq!(versor.inverse().operation(&cell), Ok(inverse));
            for (other, first) in operations.iter().zip(&versors).step_by(5) {
                let product = one.after(other).expect("a product");
                assert_eq!(versor.after(first).operation(&cell), Ok(product));
            }
        }
    }
}

#[test]
fn what_does_not_belong_to_the_lattice_is_refused() {
    let cubic = cell([4.0; 3], [90.0; 3]);
    let turn =
        Motor::from(Rotor::about_axis(Vector3::new(0.0, 0.0, 1.0), PI / 3.0).expect("an axis"));
    let error = Isometry::from(turn)
        .operation(&cubic)
        .expect_err("no sixfold axis");
    assert!(
        matches!(error, NotOfLattice::Matrix { residual } if residual > 0.1),
        "{error}"
    );
    assert!(
        error
            .to_string()
            .contains("does not carry the lattice to itself")
    );
    let step = Isometry::translation(Vector3::new(0.123_456, 0.0, 0.0));
    let error = step.operation(&cubic).expect_err("no fraction");
    assert!(matches!(error, NotOfLattice::Translation { .. }), "{error}");
    for value in [f64::NAN, f64::INFINITY, 1e300] {
        let broken = Isometry::translation(Vector3::new(value, 0.0, 0.0));
        assert!(broken.operation(&cubic).is_err(), "{value}");
        let mirror = Isometry::from(DualPlane::new(value, 0.0, 0.0, 0.0));
        assert!(
            mirror.operation(&cubic).is_err() || value == 1e300,
            "{value}"
        );
    }
    // A sheared lattice vector is no isometry in any cell.
    let shear: Operation = "x+y,y,z".parse().expect("a matrix of determinant 1");
    let error = Isometry::of_operation(&shear, &cubic).expect_err("no isometry");
    assert!(matches!(error, PlacementError::Misfit { .. }), "{error}");
    let quarter: Operation = "-y,x,z".parse().expect("a quarter turn");
    let oblong = cell([4.0, 5.0, 6.0], [90.0; 3]);
    assert!(Isometry::of_operation(&quarter, &oblong).is_err());
    assert_eq!(Isometry::reflection(Vector3::default()), None);
    assert_eq!(Isometry::reflection(Vector3::new(f64::NAN, 0.0, 0.0)), None);
}

#[test]
fn kinds_and_places_are_those_of_the_tables() {
    let box_cell = cell([4.0, 6.0, 8.0], [90.0; 3]);
    let motion = |text: &str, cell: &Cell| {
        let operation: Operation = text.parse().expect("an operation");
        Isometry::of_operation(&operation, cell)
            .expect("it fits")
            .motion()
    };
    assert_eq!(motion("x,y,z", &box_cell), Motion::Identity);
    let Motion::Translation { vector } = motion("x+1/2,y+1/2,z", &box_cell) else {
        panic!()
    };
    assert!((vector - Vector3::new(2.0, 3.0, 0.0)).norm() < 1e-12);
    // n-glide across the plane y = 1/4.
    let Motion::Glide { plane, vector } = motion("x+1/2,-y+1/2,z+1/2", &box_cell) else {
        panic!()
    };
    assert!((vector - Vector3::new(2.0, 0.0, 4.0)).norm() < 1e-12);
    let height = plane.distance_from_origin().expect("a plane") * plane.normal().e2.signum();
    assert!((height - 1.5).abs() < 1e-12);
    let Motion::Glide { vector, .. } = motion("x,y,-z", &box_cell) else {
        panic!()
    };
    assert_eq!(vector, Vector3::default());
    // 2₁ along z through x = 1/4.
    let Motion::Screw {
        through,
        axis,
        angle,
        rise,
    } = motion("-x+1/2,-y,z+1/2", &box_cell)
    else {
        panic!()
    };
    assert!((angle - PI).abs() < 1e-9 && (rise.abs() - 4.0).abs() < 1e-12);
    assert!((axis.e3.abs() - 1.0).abs() < 1e-12);
    assert!(through.distance(Point::at(1.0, 0.0, 0.0)) < 1e-12);
    let Motion::RotoInversion {
        center,
        axis,
        angle,
    } = motion("-x+1/2,-y,-z+1/2", &box_cell)
    else {
        panic!()
    };
    assert!(center.distance(Point::at(1.0, 0.0, 2.0)) < 1e-12);
    assert_eq!((axis, angle), (None, 0.0));
    // 4₁ and 4₃ differ in their hand.
    let square = cell([4.0, 4.0, 8.0], [90.0; 3]);
    for (text, right) in [("-y,x,z+1/4", true), ("-y,x,z+3/4", false)] {
        let Motion::Screw {
            axis, angle, rise, ..
        } = motion(text, &square)
        else {
            panic!()
        };
        assert!((angle - FRAC_PI_2).abs() < 1e-9);
        let up = rise * axis.e3;
        assert!((up - if right { 2.0 } else { 6.0 }).abs() < 1e-12);
        assert!(axis.e3 > 0.0);
    }
    // -4 about the z axis through the origin, inversion at height 1/8.
    let Motion::RotoInversion {
        center,
        axis,
        angle,
    } = motion("y,-x,-z+1/4", &square)
    else {
        panic!()
    };
    assert!(center.distance(Point::at(0.0, 0.0, 1.0)) < 1e-12);
    assert!((axis.expect("an axis").e3 - 1.0).abs() < 1e-12 && (angle - FRAC_PI_2).abs() < 1e-9);
}

fn isometry() -> impl Strategy<Value = Isometry> {
    let vector = || prop::array::uniform3(-3.0..3.0_f64).prop_map(Vector3::from);
    (vector(), -3.0..3.0_f64, vector(), any::<bool>(), vector()).prop_filter_map(
        "an axis",
        |(axis, angle, shift, mirrored, normal)| {
            let motor = Motor::rigid(Rotor::about_axis(axis, angle)?, Translator::by(shift));
            let proper = Isometry::from(motor);
            Some(if mirrored {
                proper.after(&Isometry::reflection(normal)?)
            } else {
                proper
            })
        },
    )
}

proptest! {
    #[test]
    fn isometries_form_a_group(one in isometry(), two in isometry(), three in isometry()) {
        let left = one.after(&two).after(&three);
        let right = one.after(&two.after(&three));
        prop_assert!(left.is_same(&right, 1e-11));
        prop_assert!(one.inverse().after(&one).is_same(&Isometry::identity(), 1e-11));
        prop_assert!(one.after(&one.inverse()).is_same(&Isometry::identity(), 1e-11));
        prop_assert!(one.after(&Isometry::identity()).is_same(&one, 1e-12));
        prop_assert_eq!(one.after(&two).is_proper(), one.is_proper() == two.is_proper());
        let point = Point::at(0.4, -0.8, 1.3);
        let in_turn = one.apply(two.apply(point));
        prop_assert!(one.after(&two).apply(point).distance(in_turn) < 1e-11);
        prop_assert!(one.renormalized().is_same(&one, 1e-12));
        let split = Isometry::translation(one.shift()).after(&one.about_origin());
        prop_assert!(split.is_same(&one, 1e-11));
        if let Some(odd) = one.odd_versor() {
            let image = point.image_under(odd).expect("no point at infinity");
            prop_assert!(image.distance(one.apply(point)) < 1e-10);
        }
    }

    /// The kind of an isometry says all of it: it can be made again from the parts.
    #[test]
    fn kinds_say_all(isometry in isometry()) {
        let about = |point: Point, axis: Vector3, angle: f64| {
            let turn = Isometry::from(Motor::from(Rotor::about_axis(axis, angle).expect("an axis")));
            turn.moved_by(&Isometry::translation(point.position()))
        };
        let again = match isometry.motion() {
            Motion::Identity => Isometry::identity(),
            Motion::Translation { vector } => Isometry::translation(vector),
            Motion::Screw { through, axis, angle, rise } => {
                Isometry::translation(axis * rise).after(&about(through, axis, angle))
            }
            Motion::Glide { plane, vector } => {
                Isometry::translation(vector).after(&Isometry::from(plane))
            }
            Motion::RotoInversion { center, axis, angle } => {
                let inversion =
                    Isometry::inversion().moved_by(&Isometry::translation(center.position()));
                match axis {
                    Some(axis) => inversion.after(&about(center, axis, angle)),
                    None => inversion,
                }
            }
        };
        prop_assert!(again.is_same(&isometry, 1e-6), "{:?}", isometry.motion());
    }
}
