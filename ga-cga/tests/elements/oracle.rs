//! Plain vector geometry with nalgebra, which shares no code with what it judges, and random
//! positions.

use std::f64::consts::PI;

use ga_cga::incidence::Figure;
use ga_cga::{Circle, Line, Multivector, Plane, Point, Sphere, Vector3};
use ga_core::Element;
use nalgebra as na;

pub type Position = na::Vector3<f64>;

/// A linear congruential generator: the same numbers on every machine.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        random.signed();
        random
    }

    /// Uniform in [−1, 1).
    pub fn signed(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Uniform in a cube of this half edge.
    pub fn position(&mut self, reach: f64) -> na::Vector3<f64> {
        na::Vector3::from_fn(|_, _| reach * self.signed())
    }

    /// A vector of length 1.
    pub fn direction(&mut self) -> na::Vector3<f64> {
        loop {
            let vector = self.position(1.0);
            let length = vector.norm();
            if (0.1..=1.0).contains(&length) {
                return vector / length;
            }
        }
    }
}

/// How many random elements of each kind make the trip.
pub const TRIPS: usize = 100_000;

/// A factor of either sign between 1e−3 and 1e3.
pub fn weight(random: &mut Random) -> f64 {
    random.signed().signum() * 10_f64.powf(3.0 * random.signed())
}

pub fn vector(v: na::Vector3<f64>) -> Vector3 {
    Vector3::new(v.x, v.y, v.z)
}

pub fn plain(v: Vector3) -> na::Vector3<f64> {
    na::Vector3::from(v.to_array())
}

pub fn point(x: na::Vector3<f64>) -> Point {
    Point::from(vector(x))
}

/// Equal to a relative error against the larger of 1 and the expected length.
#[track_caller]
pub fn close(found: Vector3, expected: na::Vector3<f64>, relative: f64) {
    let miss = (plain(found) - expected).norm();
    let bound = relative * (1.0 + expected.norm());
    assert!(miss <= bound, "{found} is not {expected}: {miss:e} off");
}

/// Equal to a relative error against the larger of 1 and the expected value.
#[track_caller]
pub fn near(found: f64, expected: f64, relative: f64, what: &str) {
    let miss = (found - expected).abs();
    let bound = relative * (1.0 + expected.abs());
    assert!(
        miss <= bound,
        "{what}: {found} is not {expected}: {miss:e} off"
    );
}

/// The largest coefficient.
pub fn size<X: Element<Number = f64>>(x: X) -> f64 {
    (0..X::BLADES.len()).fold(0.0, |size, i| x.at(i).abs().max(size))
}

/// The largest difference of coefficients.
pub fn distance<X: Element<Number = f64>>(x: X, y: X) -> f64 {
    (0..X::BLADES.len()).fold(0.0, |size, i| (x.at(i) - y.at(i)).abs().max(size))
}

/// Centre and radius of the circle through three positions, from the equations of the
/// perpendicular bisectors and of the plane.
pub fn circumcircle(
    a: na::Vector3<f64>,
    b: na::Vector3<f64>,
    c: na::Vector3<f64>,
) -> (na::Vector3<f64>, f64) {
    let (u, v) = (b - a, c - a);
    let rows = na::Matrix3::from_rows(&[u.transpose(), v.transpose(), u.cross(&v).transpose()]);
    let right = na::Vector3::new(u.norm_squared() / 2.0, v.norm_squared() / 2.0, 0.0);
    let from_a = rows.full_piv_lu().solve(&right).expect("not collinear");
    (a + from_a, from_a.norm())
}

/// Centre and radius of the sphere through four positions.
pub fn circumsphere(
    a: na::Vector3<f64>,
    b: na::Vector3<f64>,
    c: na::Vector3<f64>,
    d: na::Vector3<f64>,
) -> (na::Vector3<f64>, f64) {
    let edges = [b - a, c - a, d - a];
    let rows = na::Matrix3::from_rows(&edges.map(|edge| edge.transpose()));
    let right = na::Vector3::from(edges.map(|edge| edge.norm_squared() / 2.0));
    let from_a = rows.full_piv_lu().solve(&right).expect("not coplanar");
    (a + from_a, from_a.norm())
}

/// A place up to 10⁶ from the origin.
pub fn place(random: &mut Random) -> Position {
    let far = 10_f64.powf(6.0 * random.signed().abs());
    random.direction() * far
}

/// How much worse than near the origin results are allowed to be at a place, for flats.
pub fn rounding(place: Position) -> f64 {
    1e-14 * (1.0 + place.norm())
}

/// A figure and a function that gives many of its points.
pub type Sampled = (Multivector, Box<dyn Fn(f64, f64) -> Position>);

/// Random real figures around the origin, with samples from two numbers in [0, 1].
pub fn figures(random: &mut Random) -> Vec<Sampled> {
    let (c, n, r) = (
        random.position(3.0),
        random.direction(),
        0.5 + random.signed().abs(),
    );
    let t = n.cross(&random.direction()).normalize();
    let u = n.cross(&t);
    let wide = |x: f64| 40.0 * (x - 0.5);
    vec![
        (point(c).direct(), Box::new(move |_, _| c)),
        (
            (point(c - t * r) ^ point(c + t * r)).direct(),
            Box::new(move |x, _| if x < 0.5 { c - t * r } else { c + t * r }),
        ),
        (
            Line::along(point(c), vector(t * 2.0)).direct(),
            Box::new(move |x, _| c + t * wide(x)),
        ),
        (
            Plane::with_normal(point(c), vector(n)).direct(),
            Box::new(move |x, y| c + t * wide(x) + u * wide(y)),
        ),
        (
            Circle::with_normal(point(c), r, vector(n))
                .expect("a normal")
                .direct(),
            Box::new(move |x, _| {
                let (sin, cos) = (2.0 * PI * x).sin_cos();
                c + (t * cos + u * sin) * r
            }),
        ),
        (
            Sphere::about(point(c), r * r).direct(),
            Box::new(move |x, y| {
                let ((sin, cos), (up, out)) = ((2.0 * PI * x).sin_cos(), (PI * y).sin_cos());
                c + ((t * cos + u * sin) * up + n * out) * r
            }),
        ),
    ]
}
