//! R3,0,1, plane-based algebra of space: planes are vectors, lines and points are where planes
//! meet, and every rigid motion is a product of reflections in planes.
//!
//! A plane a x + b y + c z + d = 0 is the vector a e₁ + b e₂ + c e₃ + d e₀ with e₀² = 0; e₀ is
//! the plane at infinity. The outer product meets planes in lines and points, the regressive
//! product joins points to lines and planes. The exponential of a line is a screw about it.
//!
//! ```
//! use ga_spaces::plane_based3::{Line, Motor, Point, Translator};
//!
//! let axis: Line = Point::at(1.0, 0.0, 0.0) & Point::at(1.0, 0.0, 5.0);
//! let quarter = Motor::about(axis, core::f64::consts::FRAC_PI_2).unwrap();
//! let screw: Motor = Translator::by(0.0, 0.0, 2.0) * quarter;
//! let image: Point = screw.apply(Point::at(2.0, 0.0, 0.0));
//! assert!(image.distance(Point::at(1.0, 1.0, 2.0)) < 1e-15);
//!
//! // The logarithm is the line of the screw; a fraction of it is a fraction of the motion.
//! let generator: Line = screw.log().unwrap();
//! let half: Point = Motor::screw(generator * 0.5).apply(Point::at(2.0, 0.0, 0.0));
//! let corner = core::f64::consts::FRAC_1_SQRT_2;
//! assert!(half.distance(Point::at(1.0 + corner, corner, 1.0)) < 1e-15);
//! ```
//!
//! A [`Motor`] and its negative are the same motion, and `log` and `sqrt` take the sign as it is:
//! of a rotation by θ about a line L, in (−2π, 2π), the logarithm is −θL/2.
//!
//! Sources: Gunn, *Geometric Algebras for Euclidean Geometry* (2017); Dorst and De Keninck,
//! *A Guided Tour to the Plane-Based Geometric Algebra PGA* (2022).

mod measure;

use ga_core::convert::pick;
use ga_core::{Field, Real, Scalar as Ring};

ga_macros::define_algebra! {
    mod algebra: R3_0_1 {
        basis { e0, e1, e2, e3 }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1 }
        types {
            /// A plane a x + b y + c z + d = 0, as coefficients a, b, c, d. A mirror, as a
            /// versor.
            Plane { e1, e2, e3, e0 }
            /// A line, or any other element of grade 2: the generator of motors. The first
            /// three coefficients are its direction, the others its moment about the origin.
            Line { e23, e31, e12, e01, e02, e03 }
            /// A line through the origin.
            OriginLine { e23, e31, e12 }
            /// A line at infinity, where parallel planes meet; the generator of translations.
            IdealLine { e01, e02, e03 }
            /// A point of weight 1: its coefficients are its coordinates. A point reflection,
            /// as a versor.
            Point { e123 = 1, e032, e013, e021 }
            /// A direction, that is a point at infinity, where parallel lines meet.
            Direction { e032, e013, e021 }
            /// A point with a weight, or a direction where the weight is zero: what three
            /// planes meet in.
            WeightedPoint { e123, e032, e013, e021 }
            /// A rotation about a line through the origin.
            Rotor { 1, e23, e31, e12 }
            /// A translation, of unit norm.
            #[unit]
            Translator { 1 = 1, e01, e02, e03 }
            /// Any rigid motion without reflection.
            Motor { 1, e23, e31, e12, e01, e02, e03, e0^e123 }
            /// A multiple of the pseudoscalar e₀₁₂₃, which squares to zero.
            Pseudoscalar { e0^e123 }
        }
    }
}

pub use algebra::*;

/// What a [`WeightedPoint`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place<T = f64> {
    /// A point at a finite place.
    Point(Point<T>),
    /// A direction, where parallel lines meet.
    Direction(Direction<T>),
    /// No place: what was met has more than a point in common.
    Nowhere,
}

impl<T: Ring> Point<T> {
    /// The point with these Cartesian coordinates.
    pub fn at(x: T, y: T, z: T) -> Self {
        Point::new(x, y, z)
    }
}

impl<T: Field> WeightedPoint<T> {
    /// The point, direction or nothing that this is; decided by what is exactly zero.
    pub fn place(self) -> Place<T> {
        let [weight, x, y, z] = self.to_array();
        if weight.is_invertible() {
            Place::Point(Point::at(x / weight, y / weight, z / weight))
        } else if [x, y, z].into_iter().any(T::is_invertible) {
            Place::Direction(Direction::new(x, y, z))
        } else {
            Place::Nowhere
        }
    }
}

impl<T: Real> Plane<T> {
    /// The plane through a point with this normal vector; `None` for a normal of length zero.
    pub fn through(point: Point<T>, normal: Direction<T>) -> Option<Self> {
        let [a, b, c] = normal.to_array();
        let plane = Plane::new(a, b, c, T::ZERO).normalized()?;
        let height = (plane ^ point).e0123;
        Some(Plane {
            e0: plane.e0 - height,
            ..plane
        })
    }
}

impl<T: Real> Rotor<T> {
    /// The rotation by an angle in radians about a line through the origin, anticlockwise seen
    /// against its direction: e^{−θL/2}; `None` for a line of size zero.
    pub fn about(axis: OriginLine<T>, angle: T) -> Option<Self> {
        Some((axis.normalized()? * (-angle * T::from_ratio(1, 2))).exp())
    }
}

impl<T: Field> Translator<T> {
    /// The translation by **v** = (x, y, z): 1 − ½ e₀∧**v**, the reflections in two planes half
    /// as far apart.
    pub fn by(x: T, y: T, z: T) -> Self {
        let half = T::from_ratio(-1, 2);
        Translator::new(x * half, y * half, z * half)
    }
}

impl<T: Real> Motor<T> {
    /// The rotation by an angle in radians about a line, anticlockwise seen against its
    /// direction: e^{−θL/2}; `None` for a line at infinity.
    pub fn about(axis: Line<T>, angle: T) -> Option<Self> {
        Some(Motor::screw(
            axis.normalized()? * (-angle * T::from_ratio(1, 2)),
        ))
    }

    /// The exponential of a line of any kind: a rotation, a translation or a screw.
    // A motor handed back through memory takes longer than the exponential.
    #[inline(always)]
    pub fn screw(generator: Line<T>) -> Self {
        pick(generator.exp())
    }
}
