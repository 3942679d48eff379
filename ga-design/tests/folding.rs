//! Folding by spheres (2.6) against the closed forms of trigonometry, and the camera of
//! algorithm 2.1.

use ga_cga::{DualSphere, Point, Vector3};
use ga_design::camera::{directly, without_roll};
use ga_design::folding::{FoldError, FoldMode, FoldedSheet, Meeting, Miura, Vertex};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// A vertex that folds flat: sectors A, B and their supplements across.
fn flat_foldable() -> impl Strategy<Value = (f64, f64)> {
    (0.3..2.8_f64, 0.3..2.8_f64).prop_filter("two different modes", |(a, b)| {
        (a - b).abs() > 0.05 && (a + b - PI).abs() > 0.05
    })
}

proptest! {
    /// Both modes of a flat-foldable vertex: opposite folds are equal in size, and the halves of
    /// the two sizes have tangents in a constant ratio.
    #[test]
    fn both_modes_fold_as_the_closed_forms_say(
        (a, b) in flat_foldable(), fold in 0.05..3.0_f64, down in any::<bool>(),
    ) {
        let vertex = Vertex::new([a, b, PI - a, PI - b]).expect("a flat vertex");
        let driven = if down { -fold } else { fold };
        let alike = ((a + b) / 2.0).sin() / ((a - b) / 2.0).sin();
        let opposed = -((a + b) / 2.0).cos() / ((a - b) / 2.0).cos();
        for (mode, across) in [(FoldMode::Alike, 1.0), (FoldMode::Opposed, -1.0)] {
            let folded = vertex.fold(driven, mode).expect("it folds all the way");
            let [first, second, third, fourth] = folded.fold_angles();
            prop_assert!((second - driven).abs() < 1e-12);
            prop_assert!((fourth - across * driven).abs() < 1e-10, "{:?} {:?}", mode, folded.fold_angles());
            prop_assert!((third + across * first).abs() < 1e-10);
            let ratio = (second / 2.0).tan() / (first / 2.0).tan();
            let expected = if mode == FoldMode::Alike { alike } else { opposed };
            prop_assert!(
                (1.0 / ratio - 1.0 / expected).abs() < 1e-9 * (1.0 + 1.0 / expected.abs()),
                "{:?}: {} is not {}", mode, ratio, expected
            );
        }
    }

    /// Whatever the sectors, no length changes: neither the edges nor the sector angles.
    #[test]
    fn folding_keeps_the_paper(
        a in 0.4..2.5_f64, b in 0.4..2.5_f64, c in 0.4..2.5_f64, fold in -2.5..2.5_f64,
    ) {
        let sectors = [a, b, c, 2.0 * PI - a - b - c];
        prop_assume!(sectors[3] > 0.2 && sectors[3] < 3.0);
        let vertex = Vertex::new(sectors).expect("a flat vertex");
        for mode in [FoldMode::Alike, FoldMode::Opposed] {
            let Ok(folded) = vertex.fold(fold, mode) else { continue };
            for corner in folded.corners() {
                prop_assert!((corner.distance(Point::at(0.0, 0.0, 0.0)) - 1.0).abs() < 1e-12);
            }
            for (after, before) in folded.sectors().into_iter().zip(sectors) {
                prop_assert!((after - before).abs() < 1e-7, "{after} is not {before}");
            }
        }
    }

    /// H, S, L and V of the Miura cell, at every corner of the sheet.
    #[test]
    fn the_sheet_has_the_measures_of_the_closed_form(
        straight in 0.5..2.0_f64, zigzag in 0.5..2.0_f64, angle in 0.3..1.4_f64,
        inclination in 0.02..1.5_f64, rows in 2..7_usize, columns in 2..7_usize,
    ) {
        let pattern = Miura::new(straight, zigzag, angle, [rows, columns]).expect("a pattern");
        let folded = pattern.fold(inclination).expect("it folds");
        let expected = closed_form(straight, zigzag, angle, inclination, [rows, columns]);
        prop_assert!(off(&folded, &expected) < 1e-9, "{}", off(&folded, &expected));
    }

    #[test]
    fn nothing_finite_or_not_breaks_a_pattern(
        numbers in prop::array::uniform4(any::<f64>()), fold in any::<f64>(),
    ) {
        if let Ok(vertex) = Vertex::new(numbers) {
            let _ = vertex.fold(fold, FoldMode::Alike);
        }
        let [a, b, angle, _] = numbers;
        let pattern = Miura::new(a, b, angle, [2, 3]);
        if let Ok(sheet) = pattern.and_then(|pattern| pattern.fold(fold)) {
            for corner in sheet.rows().iter().flatten() {
                prop_assert!(corner.position().to_array().iter().all(|c| !c.is_nan()));
            }
        }
    }
}

/// Schenk and Guest, “Geometry of Miura-folded metamaterials”, PNAS 110 (2013): the corners of
/// the folded pattern.
fn closed_form(
    straight: f64,
    zigzag: f64,
    angle: f64,
    inclination: f64,
    [rows, columns]: [usize; 2],
) -> Vec<Vec<Point>> {
    let (sin, cos) = inclination.sin_cos();
    let root = (1.0 + (cos * angle.tan()).powi(2)).sqrt();
    let height = straight * sin * angle.sin();
    let width = zigzag * cos * angle.tan() / root;
    let length = straight * (1.0 - (sin * angle.sin()).powi(2)).sqrt();
    let offset = zigzag / root;
    let corner = |i: usize, j: usize| {
        let (odd_row, odd_column) = ((i % 2) as f64, (j % 2) as f64);
        Point::at(
            width * j as f64,
            length * i as f64 + offset * odd_column,
            height * odd_row,
        )
    };
    (0..=rows)
        .map(|i| (0..=columns).map(|j| corner(i, j)).collect())
        .collect()
}

/// The largest difference of any distance between two corners.
fn off(sheet: &FoldedSheet, expected: &[Vec<Point>]) -> f64 {
    let (have, want): (Vec<_>, Vec<_>) = (
        sheet.rows().iter().flatten().collect(),
        expected.iter().flatten().collect(),
    );
    assert_eq!(have.len(), want.len());
    let mut worst: f64 = 0.0;
    for i in 0..have.len() {
        for j in 0..i {
            worst = worst.max((have[i].distance(*have[j]) - want[i].distance(*want[j])).abs());
        }
    }
    worst
}

#[test]
fn a_large_sheet_stays_whole() {
    for panels in [[40, 40], [200, 2], [2, 200]] {
        let pattern = Miura::new(1.0, 1.2, 1.0, panels).expect("a pattern");
        let folded = pattern.fold(0.8).expect("it folds");
        let expected = closed_form(1.0, 1.2, 1.0, 0.8, panels);
        let off = off(&folded, &expected);
        assert!(off < 1e-6, "{off} for {panels:?}");
        assert_eq!(folded.panels().count(), panels[0] * panels[1]);
    }
    let pattern = Miura::new(1.0, 1.2, 1.0, [4, 5]).expect("a pattern");
    let flat = pattern.fold(0.0).expect("flat");
    assert!(off(&flat, &closed_form(1.0, 1.2, 1.0, 0.0, [4, 5])) < 1e-14);
}

#[test]
fn what_does_not_fold_is_named() {
    assert!(matches!(
        Vertex::new([1.0, 1.0, 1.0, 1.0]),
        Err(FoldError::Sectors { .. })
    ));
    assert!(Vertex::new([PI, 1.0, 1.0, PI - 2.0]).is_err());
    assert!(Vertex::new([f64::NAN; 4]).is_err());
    let right = Vertex::new([FRAC_PI_2; 4]).expect("a flat vertex");
    assert!(matches!(
        right.fold(4.0, FoldMode::Alike),
        Err(FoldError::Angle { .. })
    ));
    assert!(right.fold(f64::NAN, FoldMode::Opposed).is_err());
    // Folded in half, the third corner is where the first is, and the other half may turn.
    for mode in [FoldMode::Alike, FoldMode::Opposed] {
        let open = right.fold(PI, mode);
        assert!(matches!(open, Err(FoldError::Open { .. })), "{open:?}");
    }
    for (a, b, angle, panels) in [
        (0.0, 1.0, 1.0, [2, 2]),
        (1.0, f64::INFINITY, 1.0, [2, 2]),
        (1.0, 1.0, 1.6, [2, 2]),
        (1.0, 1.0, f64::NAN, [2, 2]),
        (1.0, 1.0, 1.0, [1, 2]),
        (1.0, 1.0, 1.0, [2, 2000]),
    ] {
        assert!(Miura::new(a, b, angle, panels).is_err());
    }
    let pattern = Miura::new(1.0, 1.0, 1.0, [2, 2]).expect("a pattern");
    assert!(pattern.fold(FRAC_PI_2).is_err());
    assert!(pattern.fold(-0.1).is_err());
}

/// Where three spheres meet does not depend on where they are: the places are as good as the
/// coordinates, near and far.
#[test]
fn spheres_meet_as_well_far_away() {
    for far in [0.0, 1e2, 1e4, 1e6] {
        let [a, b, c, top] = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.25, 0.5, 0.125],
        ]
        .map(|[x, y, z]| Point::at(x + far, y - far, z + far));
        let Meeting::Two([above, below]) = Meeting::of_moved([a, b, c], top, [a, b, c]) else {
            panic!("they meet twice")
        };
        let bound = 1e-14 * (1.0 + far * far);
        assert!(
            above.distance(top) < bound,
            "{far}: {}",
            above.distance(top)
        );
        let mirrored = Point::at(0.25 + far, 0.5 - far, far - 0.125);
        assert!(below.distance(mirrored) < bound, "{far}");
    }
}

#[test]
fn spheres_meet_twice_once_or_not() {
    let sphere = |x: f64, y: f64, r: f64| DualSphere::about(Point::at(x, y, 0.0), r * r);
    let touching = [
        sphere(0.0, 0.0, 1.0),
        sphere(2.0, 0.0, 1.0),
        sphere(1.0, 1.0, 1.0),
    ];
    let Meeting::One(point) = Meeting::of(touching) else {
        panic!("they touch")
    };
    assert!(point.distance(Point::at(1.0, 0.0, 0.0)) < 1e-14);
    let apart = [
        sphere(0.0, 0.0, 1.0),
        sphere(3.0, 0.0, 1.0),
        sphere(1.0, 1.0, 1.0),
    ];
    assert!(matches!(Meeting::of(apart), Meeting::Apart));
    let aligned = [
        sphere(0.0, 0.0, 1.0),
        sphere(1.0, 0.0, 1.0),
        sphere(2.0, 0.0, 1.0),
    ];
    assert_eq!(Meeting::of(aligned), Meeting::Aligned);
    assert_eq!(Meeting::of([DualSphere::default(); 3]), Meeting::Aligned);
    assert_eq!(Meeting::of([DualSphere::infinity(); 3]), Meeting::Aligned);
}

/// Algorithm 2.1: z towards the target, y upright, x level.
#[test]
fn the_camera_does_not_roll() {
    let [x, y, z] = [
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, 1.0, 0.0),
        Vector3::new(0.0, 0.0, 1.0),
    ];
    for i in 0..400 {
        let (azimuth, height) = (0.1 + f64::from(i) * 0.37, f64::from(i % 41) / 21.0 - 0.97);
        let sight = Vector3::new(azimuth.sin(), height, azimuth.cos());
        let camera = Point::at(3.0, -1.0, 2.0);
        let target = Point::from(camera.position() + sight * 4.0);
        let turn = without_roll(camera, target).expect("not straight up");
        let sight = sight / sight.norm();
        assert!((turn.apply(z) - sight).norm() < 1e-13);
        assert!(turn.apply(x).scalar_product(y).abs() < 1e-13);
        let upright = turn.apply(y).scalar_product(y);
        assert!(upright > 0.0 && (upright - (1.0 - sight.e2 * sight.e2).sqrt()).abs() < 1e-13);
    }
    // Straight behind: no roll either.
    let back = without_roll(Point::at(0.0, 0.0, 0.0), Point::at(0.0, 0.0, -1.0));
    let back = back.expect("a target");
    assert!((back.apply(y) - y).norm() < 1e-15 && (back.apply(z) + z).norm() < 1e-15);
    let here = Point::at(1.0, 1.0, 1.0);
    assert_eq!(without_roll(here, here), None);
    assert_eq!(directly(Vector3::default()), None);
}
