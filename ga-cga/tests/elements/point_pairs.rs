//! Point pairs come apart into their points, in order, and say where they do not.

use ga_cga::{DualSphere, FlatPoint, Line, PointPair, SplitPair};

use super::oracle::{Random, TRIPS, close, point, vector, weight};

/// (2.57) corrected: the points of a pair, in order, whatever its weight.
#[test]
fn equation_2_57_pairs_split_in_order() {
    let mut random = Random::new(21);
    for _ in 0..TRIPS {
        let (a, b) = (random.position(10.0), random.position(10.0));
        if (a - b).norm() < 0.5 {
            continue;
        }
        let heavy = weight(&mut random);
        let pair: PointPair = (point(a) ^ point(b)) * heavy;
        let SplitPair::Real { first, second } = pair.split() else {
            panic!("two points apart");
        };
        let (start, end) = if heavy > 0.0 { (a, b) } else { (b, a) };
        close(first.position(), start, 3e-12);
        close(second.position(), end, 3e-12);
    }
}

/// Imaginary and touching pairs are told apart, and say where they are.
#[test]
fn equation_2_57_imaginary_and_tangent_pairs() {
    let mut random = Random::new(22);
    for _ in 0..10_000 {
        let (at, t) = (random.position(10.0), random.direction() * 3.0);
        let radius_squared = -0.01 - 9.0 * random.signed().abs();
        match PointPair::about(point(at), radius_squared, vector(t)).split() {
            SplitPair::Imaginary {
                center,
                radius_squared: found,
                direction,
            } => {
                close(center.position(), at, 1e-13);
                assert!((found - radius_squared).abs() < 1e-11);
                close(direction, t, 1e-14);
            }
            other => panic!("{other:?} is not imaginary"),
        }
        match PointPair::tangent(point(at), vector(t)).split() {
            SplitPair::Tangent { point, direction } => {
                close(point.position(), at, 1e-13);
                close(direction, t, 1e-14);
            }
            other => panic!("{other:?} is not tangent"),
        }
        match PointPair::from(FlatPoint::at(point(at))).split() {
            SplitPair::WithInfinity(point) => close(point.position(), at, 1e-15),
            other => panic!("{other:?} is not flat"),
        }
    }
    assert!(matches!(
        PointPair::<f64>::default().split(),
        SplitPair::NoPair(_)
    ));
}

/// (2.58): dualising gives the two points in the order in which the line meets them.
#[test]
fn equation_2_58_line_through_sphere() {
    let mut random = Random::new(23);
    for _ in 0..10_000 {
        let (center, t) = (random.position(4.0), random.direction());
        let across = random.direction().cross(&t).normalize();
        let (r, h) = (2.0, 1.9 * random.signed());
        let middle = center + across * h;
        let line = Line::along(point(middle + t * random.signed()), vector(t * 1.5));
        let sphere = DualSphere::with_radius(vector(center), r);
        let pair: PointPair = (line.dual() ^ sphere).dual();
        let SplitPair::Real { first, second } = pair.split() else {
            panic!("the line meets the sphere");
        };
        let half = (r * r - h * h).sqrt();
        close(first.position(), middle - t * half, 1e-11);
        close(second.position(), middle + t * half, 1e-11);
    }
}
