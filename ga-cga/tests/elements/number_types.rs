//! Queries in single precision and on lanes answer as in double precision.

use ga_cga::{Line, Point, PointPair, SplitPair};

/// Single precision works alike.
#[test]
fn single_precision() {
    let pair: PointPair<f32> = Point::at(1.0_f32, 2.0, 3.0) ^ Point::at(1.0, 2.0, 7.0);
    assert_eq!(pair.center(), Some(Point::at(1.0, 2.0, 5.0)));
    let SplitPair::Real { first, second } = pair.split() else {
        panic!("two points");
    };
    assert!(first.distance(Point::at(1.0, 2.0, 3.0)) < 1e-5);
    assert!(second.distance(Point::at(1.0, 2.0, 7.0)) < 1e-5);
    let heavy: PointPair<f32> = pair * 1e30;
    assert_eq!(heavy.center(), Some(Point::at(1.0, 2.0, 5.0)));
}

/// Lanes answer like the numbers in them.
#[cfg(feature = "wide")]
#[test]
fn lanes() {
    use wide::f64x4;
    let xs = f64x4::new([0.0, 1.0, -2.0, 1e6]);
    let pair: PointPair<f64x4> =
        Point::at(xs, xs, f64x4::splat(0.0)) ^ Point::at(xs, xs, f64x4::splat(4.0));
    let center = pair.center().expect("round").position().to_array();
    assert_eq!(center, [xs, xs, f64x4::splat(2.0)]);
    let squares = pair.radius_squared().expect("round").to_array();
    assert!(squares.iter().all(|square| (square - 4.0).abs() < 1e-2));
    let line = Line::along(Point::at(xs, xs, xs), pair.attitude().vector());
    let foot = line
        .nearest(Point::at(xs, xs, f64x4::splat(7.0)))
        .expect("a line");
    assert_eq!(foot.position().to_array(), [xs, xs, f64x4::splat(7.0)]);
}
