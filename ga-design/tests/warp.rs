//! Warps by point pairs (3.9): their symmetry, their normals, and what they refuse.

use ga_cga::{Dilator, DualSphere, Even, Point, PointPair, Vector3};
use ga_design::crystallography::PointGroup;
use ga_design::mesh::{self, Ends, Mesh};
use ga_design::warp::{MOST_PAIRS, Warp, WarpError, Weighting};
use proptest::prelude::*;

/// Groups with and without reflections, on and off the crystallographic list.
const GROUPS: [&str; 8] = [
    "b(3)b(3)", "b(4)b(3)", "b(5)b(3)", "b(6)b(2)", "33", "43", "b(42)", "b(5)2",
];

fn group(symbol: &str) -> PointGroup {
    PointGroup::from_geometric(symbol).expect("a group")
}

fn weighting(is_near: bool) -> Weighting {
    if is_near {
        Weighting::Near { reach: 0.7 }
    } else {
        Weighting::SquaredDistance
    }
}

fn place(point: Point) -> Vector3 {
    point.position()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The warp commutes with every element of the group.
    #[test]
    fn warps_have_the_symmetry_of_their_group(
        symbol in prop::sample::select(GROUPS.to_vec()),
        at in prop::array::uniform3(-1.0..1.0_f64),
        along in prop::array::uniform3(-1.0..1.0_f64),
        square in -0.5..0.5_f64,
        start in prop::array::uniform3(-1.0..1.0_f64),
        is_near in any::<bool>(),
    ) {
        prop_assume!(Vector3::from(along).norm() > 0.1);
        let group = group(symbol);
        let pair = PointPair::about(Point::from(Vector3::from(at)), square, Vector3::from(along));
        let amount = 0.3 / group.order() as f64;
        let warp = Warp::generated(group.transformations(), &[pair], weighting(is_near), amount);
        let warp = warp.expect("a warp");
        let start = Point::from(Vector3::from(start));
        let image = warp.apply(start);
        prop_assume!(image.is_some());
        let image = image.unwrap_or(start);
        for isometry in group.transformations() {
            let first = warp.apply(isometry.apply(start)).map(place);
            let last = place(isometry.apply(image));
            let apart = first.map_or(f64::INFINITY, |first| (first - last).norm());
            prop_assert!(apart < 1e-12 * (1.0 + last.norm()), "{} {}", symbol, apart);
        }
    }

    /// Against the definition, put together anew: weights by the distance formula, the exponential by
    /// its series.
    #[test]
    fn points_go_where_the_exponential_takes_them(
        at in prop::array::uniform3(-1.0..1.0_f64),
        along in prop::array::uniform3(-1.0..1.0_f64),
        start in prop::array::uniform3(-1.0..1.0_f64),
        amount in -0.2..0.2_f64,
    ) {
        prop_assume!(Vector3::from(along).norm() > 0.1);
        let (center, start) = (Vector3::from(at), Vector3::from(start));
        let pairs = [center, -center].map(|c| PointPair::tangent(Point::from(c), Vector3::from(along)));
        let warp = Warp::new(pairs.to_vec(), Weighting::SquaredDistance, amount).expect("a warp");
        let mut generator = PointPair::default();
        for (pair, center) in pairs.into_iter().zip([center, -center]) {
            // (2.46): the inner product of two points is −½ of their squared distance.
            let square = Point::from(center).scalar_product(Point::from(start)) * -2.0;
            generator += pair * square;
        }
        let generator = Even::from(generator * -amount);
        let mut term = Even::from(Dilator::identity());
        let mut sum = term;
        for step in 1..30 {
            term = term * generator * (1.0 / f64::from(step));
            sum += term;
        }
        let expected = Point::from(start).image_under(sum).map(place);
        let found = warp.apply(Point::from(start)).map(place);
        let apart = expected.zip(found).map(|(one, other)| (one - other).norm());
        prop_assert!(apart.is_some_and(|apart| apart < 1e-10), "{:?}", apart);
    }
}

/// The largest angle between a normal and the faces around its vertex, weighted by area.
fn largest_tilt(mesh: &Mesh) -> f64 {
    let smooth = Mesh::from_triangles(mesh.positions().to_vec(), mesh.triangles().to_vec());
    let smooth = smooth.expect("a mesh");
    let pairs = mesh.normals().iter().zip(smooth.normals());
    let cosines = pairs.map(|(one, other)| (0..3).map(|i| one[i] * other[i]).sum::<f64>());
    cosines.fold(1.0, f64::min).acos()
}

#[test]
fn normals_stay_at_right_angles_to_the_surface() {
    let sphere = mesh::icosphere(4).expect("a mesh");
    let before = largest_tilt(&sphere);
    for symbol in GROUPS {
        let group = group(symbol);
        let pair = PointPair::tangent(Point::at(0.8, 0.5, 0.3), Vector3::new(0.4, -0.2, 0.6));
        for is_near in [false, true] {
            let amount = 2.0 / group.order() as f64;
            let amount = if is_near { amount } else { 0.1 * amount };
            let warp =
                Warp::generated(group.transformations(), &[pair], weighting(is_near), amount);
            let warped = warp.expect("a warp").mesh(&sphere).expect("a mesh");
            let tilt = largest_tilt(&warped);
            assert!(tilt < 0.15 + before, "{symbol} {is_near}: {tilt}");
            assert_eq!(warped.triangles(), sphere.triangles());
        }
    }
}

#[test]
fn the_edge_of_a_cylinder_stays_sharp() {
    let line: Vec<_> = (0..=20)
        .map(|i| [0.0, 0.0, f64::from(i) / 10.0 - 1.0])
        .collect();
    let cylinder = mesh::tube(&line, Ends::Capped, 1.0, 48).expect("a mesh");
    let group = group("b(6)b(2)");
    let pair = PointPair::tangent(Point::at(1.0, 0.0, 0.0), Vector3::new(0.1, 0.3, 0.0));
    let warp = Warp::generated(group.transformations(), &[pair], weighting(true), 0.2);
    let warped = warp.expect("a warp").mesh(&cylinder).expect("a mesh");
    // Vertices of the side and of the caps in the same places keep normals of their own.
    let mut sharp = 0;
    for (i, one) in warped.positions().iter().enumerate() {
        for (j, other) in warped.positions().iter().enumerate().skip(i + 1) {
            let apart = (0..3)
                .map(|k| (one[k] - other[k]).abs())
                .fold(0.0, f64::max);
            let (n, m) = (warped.normals()[i], warped.normals()[j]);
            let cosine: f64 = (0..3).map(|k| n[k] * m[k]).sum();
            if apart < 1e-12 && cosine < 0.5 {
                sharp += 1;
            }
        }
    }
    assert!(sharp >= 96, "{sharp}");
}

#[test]
fn no_warp_at_all_moves_nothing() {
    let pair = PointPair::tangent(Point::at(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    let warp = Warp::new(vec![pair], Weighting::SquaredDistance, 0.0).expect("a warp");
    let sphere = mesh::icosphere(2).expect("a mesh");
    let warped = warp.mesh(&sphere).expect("a mesh");
    for (one, other) in warped.positions().iter().zip(sphere.positions()) {
        assert!((0..3).all(|i| (one[i] - other[i]).abs() < 1e-15));
    }
    for (one, other) in warped.normals().iter().zip(sphere.normals()) {
        assert!((0..3).all(|i| (one[i] - other[i]).abs() < 1e-12));
    }
}

#[test]
fn a_point_at_a_pair_stays_there_under_the_printed_weights() {
    let at = Point::at(0.3, -0.2, 0.9);
    let pair = PointPair::tangent(at, Vector3::new(1.0, 2.0, 3.0));
    let warp = Warp::new(vec![pair], Weighting::SquaredDistance, 5.0).expect("a warp");
    let image = warp.apply(at).map(place);
    assert!(image.is_some_and(|image| (image - place(at)).norm() < 1e-14));
}

#[test]
fn coincident_images_are_one() {
    // The roots of 4̄2̄ are e₁, b and e₃: four of its rotations turn about e₃, four about axes across.
    let group = group("b(4)b(2)");
    let cases = [
        // On the axis of quarter turns, along it: one image at each end.
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 2),
        // On an axis of half turns, along it: one at each end of the two of its kind.
        ([0.0, 1.0, 0.0], [0.0, 1.0, 0.0], 4),
        ([0.7, 0.2, 0.4], [0.0, 1.0, 0.0], 8),
    ];
    for (at, along, count) in cases {
        let pair = PointPair::tangent(Point::from(Vector3::from(at)), Vector3::from(along));
        let transformations = group.transformations();
        let warp = Warp::generated(transformations, &[pair], Weighting::SquaredDistance, 0.1);
        assert_eq!(warp.expect("a warp").pairs().count(), count, "{at:?}");
    }
}

#[test]
fn what_is_no_warp_is_refused() {
    let pair = PointPair::tangent(Point::at(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    let weighting = Weighting::SquaredDistance;
    assert_eq!(Warp::new(Vec::new(), weighting, 1.0), Err(WarpError::Empty));
    assert_eq!(
        Warp::generated(&[], &[pair], weighting, 1.0),
        Err(WarpError::Empty)
    );
    let many = Warp::new(vec![pair; MOST_PAIRS + 1], weighting, 1.0);
    assert!(matches!(many, Err(WarpError::TooMany { .. })));
    for amount in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = Warp::new(vec![pair], weighting, amount);
        assert!(matches!(refused, Err(WarpError::Number { .. })), "{amount}");
    }
    for reach in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e-300, 1e300] {
        let refused = Warp::new(vec![pair], Weighting::Near { reach }, 1.0);
        assert!(matches!(refused, Err(WarpError::Number { .. })), "{reach}");
    }
    let not_a_number =
        PointPair::tangent(Point::at(f64::NAN, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    for flat in [PointPair::default(), pair * f64::INFINITY, not_a_number] {
        let refused = Warp::new(vec![pair, flat], weighting, 1.0);
        assert_eq!(refused, Err(WarpError::NoCenter { index: 1 }));
    }
    // A flat point: a point and infinity.
    let flat = Point::at(1.0, 2.0, 3.0) ^ DualSphere::infinity();
    assert_eq!(
        Warp::new(vec![flat], weighting, 1.0),
        Err(WarpError::NoCenter { index: 0 })
    );
}

#[test]
fn overflow_and_infinity_are_errors_and_never_nan() {
    let sphere = mesh::icosphere(1).expect("a mesh");
    let pairs = [
        PointPair::tangent(Point::at(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0)),
        PointPair::about(Point::at(1.0, 0.0, 0.0), 0.5, Vector3::new(1.0, 1.0, 0.0)),
        PointPair::about(Point::at(0.2, 0.0, 0.0), -0.5, Vector3::new(0.0, 1.0, 1.0)),
    ];
    for pair in pairs {
        for is_near in [false, true] {
            for exponent in -300..300 {
                let amount = 10.0_f64.powi(exponent);
                let warp = Warp::new(vec![pair], weighting(is_near), amount).expect("a warp");
                match warp.mesh(&sphere) {
                    Ok(warped) => {
                        let mut numbers = warped.positions().iter().chain(warped.normals());
                        assert!(numbers.all(|place| place.iter().all(|n| n.is_finite())));
                    }
                    Err(error) => assert!(
                        matches!(error, WarpError::AtInfinity { .. } | WarpError::Mesh(_)),
                        "{error}"
                    ),
                }
            }
        }
    }
}
