//! Queries in single precision and on lanes answer as in double precision.

use ga_cga::{Circle, Line, Plane, Point, PointPair, Sphere, SplitPair, Vector3};

use super::oracle::{Random, vector, weight};

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

/// Construct, query, construct in single precision: to 1e−5 of the size of the element.
#[test]
fn single_precision_round_trips() {
    let mut random = Random::new(47);
    let short = |v: Vector3| v.map(|c| c as f32);
    for _ in 0..20_000 {
        let at = Point::from(short(vector(random.position(10.0))));
        let t = short(vector(random.direction() * weight(&mut random)));
        let square = (25.0 * random.signed()) as f32;
        let plane = t.orthogonal_plane();
        macro_rules! same {
            ($x:expr, $again:expr) => {
                let (x, again) = ($x, $again);
                let size = x
                    .to_array()
                    .into_iter()
                    .fold(0.0_f32, |a, c| a.max(c.abs()));
                let off = (x - again).to_array();
                assert!(
                    off.into_iter().all(|c| c.abs() <= 1e-5 * size),
                    "{x} {again}"
                );
                assert_eq!(x.dual().undual(), x);
            };
        }
        let pair = PointPair::about(at, square, t);
        let place = pair.center().zip(pair.radius_squared()).expect("round");
        same!(
            pair,
            PointPair::about(place.0, place.1, pair.attitude().vector())
        );
        let circle = Circle::about(at, square, plane);
        let place = circle.center().zip(circle.radius_squared()).expect("round");
        same!(
            circle,
            Circle::about(place.0, place.1, circle.attitude().bivector())
        );
        let sphere = Sphere::about(at, square);
        let place = sphere.center().zip(sphere.radius_squared()).expect("round");
        same!(sphere, Sphere::about(place.0, place.1));
        let tangent = PointPair::tangent(at, t);
        let place = tangent.center().expect("round");
        same!(
            tangent,
            PointPair::tangent(place, tangent.attitude().vector())
        );
        let line = Line::along(at, t);
        let place = line.nearest(at).expect("a line");
        same!(line, Line::along(place, line.direction()));
        let level = Plane::with_normal(at, t);
        let place = level.nearest(at).expect("a plane");
        same!(level, Plane::with_normal(place, level.normal()));
    }
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
