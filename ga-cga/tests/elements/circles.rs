//! Distances of circles, against closed forms and against dense sampling.

use std::f64::consts::TAU;

use ga_cga::incidence::distance;
use ga_cga::{Circle, Line, Plane, Sphere, classify};

use super::oracle::{Position, Random, point, vector};

/// Closed forms of plain vector geometry.
#[test]
fn closed_forms() {
    let mut random = Random::new(74);
    for _ in 0..300 {
        let [c, d] = [(); 2].map(|()| random.position(4.0));
        let (n, m) = (random.direction(), random.direction());
        let (r, s) = (
            0.1 + random.signed().abs(),
            0.1 + 3.0 * random.signed().abs(),
        );
        let circle = Circle::with_normal(point(c), r, vector(n)).expect("a normal");
        // The heights of the circle above the plane are centred on that of its centre.
        let expected = (m.dot(&(c - d)).abs() - r * n.cross(&m).norm()).max(0.0);
        let plane = Plane::with_normal(point(d), vector(m));
        let found = distance(circle, plane).expect("real");
        assert!(
            (found - expected).abs() < 1e-13,
            "plane: {found} {expected}"
        );
        // The distances of the circle from a point are between those of two opposite points.
        let (up, out) = (n.dot(&(d - c)), n.cross(&(d - c)).norm());
        let (least, most) = ((out - r).hypot(up), (out + r).hypot(up));
        let found = distance(circle, point(d)).expect("real");
        assert!((found - least).abs() < 1e-13, "point: {found} {least}");
        let sphere = Sphere::about(point(d), s * s);
        let expected = (least - s).max(s - most).max(0.0);
        let found = distance(sphere, circle).expect("real");
        assert!(
            (found - expected).abs() < 1e-13,
            "sphere: {found} {expected}"
        );
        // Its axis is everywhere at the distance of the radius.
        let axis = Line::along(point(c + n), vector(n));
        let found = distance(axis, circle).expect("real");
        assert!((found - r).abs() < 1e-13, "axis: {found} {r}");
        // A circle about the same axis.
        let other = Circle::with_normal(point(c + n * 0.7), s, vector(n)).expect("a normal");
        let found = distance(circle, other).expect("real");
        assert!(
            (found - (r - s).hypot(0.7)).abs() < 1e-13,
            "circle: {found}"
        );
    }
}

/// The least value of a function of the points of a circle: sampled, with the golden section about
/// each sample that is lower than its neighbours.
fn least(
    (center, radius, normal): (Position, f64, Position),
    function: impl Fn(Position) -> f64,
) -> f64 {
    const SAMPLES: usize = 500;
    let aside = if normal.x.abs() < 0.7 {
        Position::x()
    } else {
        Position::y()
    };
    let t = normal.cross(&aside).normalize();
    let u = normal.cross(&t);
    let at = |angle: f64| function(center + (t * angle.cos() + u * angle.sin()) * radius);
    let step = TAU / SAMPLES as f64;
    let values: Vec<f64> = (0..SAMPLES).map(|i| at(i as f64 * step)).collect();
    let mut best = f64::INFINITY;
    for (i, value) in values.iter().enumerate() {
        let before = values[(i + SAMPLES - 1) % SAMPLES];
        let after = values[(i + 1) % SAMPLES];
        if *value > before || *value > after {
            continue;
        }
        let golden = (5_f64.sqrt() - 1.0) / 2.0;
        let (mut low, mut high) = ((i as f64 - 1.0) * step, (i as f64 + 1.0) * step);
        for _ in 0..75 {
            let (left, right) = (high - (high - low) * golden, low + (high - low) * golden);
            if at(left) <= at(right) {
                high = right;
            } else {
                low = left;
            }
        }
        best = best.min(at((low + high) / 2.0));
    }
    best
}

/// No minimum is missed, over 10⁴ pairs of a circle with another element: of sizes from 1/30 to
/// 30, nearly in one plane every fourth time. What is stored of a small circle far away limits
/// the radius to ε d²/r, and with it the distance.
#[test]
fn the_least_distance_is_found() {
    let mut random = Random::new(75);
    for round in 0..2500 {
        let spread = [0.5, 3.0, 10.0][round % 3];
        let [c, d] = [(); 2].map(|()| random.position(spread));
        let [r, s] = [(); 2].map(|()| 30_f64.powf(random.signed()));
        let n = random.direction();
        let tilt = random.direction() * 10_f64.powf(-6.0 * random.signed().abs());
        let m = if round % 4 == 0 {
            (n + tilt).normalize()
        } else {
            random.direction()
        };
        let circle = Circle::with_normal(point(c), r, vector(n)).expect("a normal");
        let size = spread + r + s;
        let bound = 1e-14 * size * (1.0 + size / r.min(s));

        let to_circle = |x: Position, (c, r, n): (Position, f64, Position)| {
            let height = n.dot(&(x - c));
            ((x - c - n * height).norm() - r).hypot(height)
        };
        let other = Circle::with_normal(point(d), s, vector(m)).expect("a normal");
        let from_one = least((c, r, n), |x| to_circle(x, (d, s, m)));
        let from_two = least((d, s, m), |x| to_circle(x, (c, r, n)));
        let line = Line::along(point(d), vector(m));
        let plane = Plane::with_normal(point(d), vector(m));
        let sphere = Sphere::about(point(d), s * s);
        for (what, figure, expected) in [
            ("circle", classify(other), from_one.min(from_two)),
            (
                "line",
                classify(line),
                least((c, r, n), |x| (x - d).cross(&m).norm()),
            ),
            (
                "plane",
                classify(plane),
                least((c, r, n), |x| m.dot(&(x - d)).abs()),
            ),
            (
                "sphere",
                classify(sphere),
                least((c, r, n), |x| ((x - d).norm() - s).abs()),
            ),
        ] {
            let found = distance(circle, figure.shape().expect("an element")).expect("real");
            assert!(
                (found - expected).abs() <= bound,
                "{what} in round {round}: {found}, but {expected} by sampling"
            );
        }
    }
}

/// Where two minima are close to each other and one of them only touches: a great circle that dips
/// twice through a line or a small circle within a part in 10⁴ of its length.
#[test]
fn close_minima_are_told_apart() {
    let mut random = Random::new(76);
    for _ in 0..300 {
        let (n, big) = (random.direction(), 30.0);
        let t = n.cross(&random.direction()).normalize();
        let u = n.cross(&t);
        let half = 10_f64.powf(-1.5 - 2.5 * random.signed().abs());
        let on = |angle: f64| (t * angle.cos() + u * angle.sin()) * big;
        // The line cuts the circle at one angle and passes it by a little at the other.
        let (touch, miss) = (on(half), on(-half) + n * (0.2 * big * half * half));
        let circle = Circle::with_normal(point(Position::zeros()), big, vector(n));
        let circle = circle.expect("a normal");
        for (start, end) in [(touch, miss), (miss, touch)] {
            let along = (end - start).normalize();
            let line = Line::along(point(touch), vector(along));
            let found = distance(circle, line).expect("real");
            assert!(found < 1e-12, "the line touches, but {found:e} is found");
        }
        // A small circle that the large one passes through, at any of its points.
        let small = 1e-3 * big;
        let m = random.direction();
        let across = m.cross(&random.direction()).normalize();
        let other = Circle::with_normal(point(touch + across * small), small, vector(m));
        let found = distance(circle, other.expect("a normal")).expect("real");
        assert!(found < 1e-10, "the circles touch, but {found:e} is found");
    }
}
