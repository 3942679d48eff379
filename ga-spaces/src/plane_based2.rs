//! R2,0,1, plane-based algebra of the plane: lines are vectors, points are where lines meet,
//! and every rigid motion is a product of reflections in lines.
//!
//! A line a x + b y + c = 0 is the vector a e₁ + b e₂ + c e₀ with e₀² = 0; e₀ itself is the line
//! at infinity. The outer product meets lines, the regressive product joins points, and parallel
//! lines meet too: in a [`Direction`].
//!
//! ```
//! use ga_spaces::plane_based2::{Line, Place, Point};
//!
//! let diagonal: Line = Point::at(0.0, 0.0) & Point::at(1.0, 1.0);
//! let falling: Line = Point::at(0.0, 2.0) & Point::at(2.0, 0.0);
//! assert_eq!((diagonal ^ falling).place(), Place::Point(Point::at(1.0, 1.0)));
//! ```
//!
//! The logarithm of a motion is its centre times minus half its angle:
//!
//! ```
//! use ga_spaces::plane_based2::{Motor, Place, Translator, WeightedPoint};
//! use ga_spaces::plane_based2::Point;
//!
//! let motion: Motor = Translator::by(2.0, 0.0) * Motor::about(Point::at(0.0, 0.0), 1.0);
//! let generator: WeightedPoint = motion.log().unwrap();
//! assert!((generator.e12 + 0.5).abs() < 1e-15);
//! let Place::Point(centre) = generator.place() else { panic!("a turn has a centre") };
//! assert!(motion.apply(centre).distance(centre) < 1e-15);
//! ```
//!
//! Sources: Gunn, *Geometric Algebras for Euclidean Geometry* (2017); Dorst and De Keninck,
//! *A Guided Tour to the Plane-Based Geometric Algebra PGA* (2022).

use ga_core::{Field, Real, Scalar as Ring};

ga_macros::define_algebra! {
    mod algebra: R2_0_1 {
        basis { e0, e1, e2 }
        metric { e1^2 = 1, e2^2 = 1 }
        types {
            /// A line a x + b y + c = 0, as coefficients a, b, c; with (a, b) to the left of its
            /// direction. A mirror, as a versor.
            Line { e1, e2, e0 }
            /// A point of weight 1: its coefficients are its coordinates. A half turn, as a
            /// versor.
            Point { e12 = 1, e20, e01 }
            /// A direction, that is a point at infinity, where parallel lines meet; the
            /// generator of translations across it.
            Direction { e20, e01 }
            /// A point with a weight, or a direction where the weight is zero: what two lines
            /// meet in.
            WeightedPoint { e12, e20, e01 }
            /// A rotation about the origin.
            Rotor { 1, e12 }
            /// A translation, of unit norm.
            #[unit]
            Translator { 1 = 1, e20, e01 }
            /// Any rigid motion without reflection.
            Motor { 1, e12, e20, e01 }
            /// A multiple of the pseudoscalar e₀₁₂, which squares to zero.
            Pseudoscalar { e0^e12 }
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
    /// No place: a line has been met with itself.
    Nowhere,
}

impl<T: Ring> Point<T> {
    /// The point with these Cartesian coordinates.
    pub fn at(x: T, y: T) -> Self {
        Point::new(x, y)
    }
}

impl<T: Real> Point<T> {
    /// The distance to another point, the norm of the line that joins them.
    pub fn distance(self, other: Self) -> T {
        (self & other).norm()
    }
}

impl<T: Field> WeightedPoint<T> {
    /// The point, direction or nothing that this is; decided by what is exactly zero.
    pub fn place(self) -> Place<T> {
        if self.e12.is_invertible() {
            Place::Point(Point::at(self.e20 / self.e12, self.e01 / self.e12))
        } else if self.e20.is_invertible() || self.e01.is_invertible() {
            Place::Direction(Direction::new(self.e20, self.e01))
        } else {
            Place::Nowhere
        }
    }
}

impl<T: Real> Line<T> {
    /// The signed distance of a point, positive on the side of the normal; `None` for the line
    /// at infinity.
    pub fn signed_distance(self, point: Point<T>) -> Option<T> {
        Some((self.normalized()? ^ point).e012)
    }

    /// The angle in radians to another line, in [0, π]; `None` where one is the line at
    /// infinity.
    pub fn angle(self, other: Self) -> Option<T> {
        let turn = other.normalized()? * self.normalized()?;
        Some(turn.e12.abs().atan2(turn.s))
    }
}

impl<T: Field> Translator<T> {
    /// The translation by **v** = (x, y): 1 − ½ e₀∧**v**, the reflections in two lines half as
    /// far apart.
    pub fn by(x: T, y: T) -> Self {
        let half = T::from_ratio(1, 2);
        Translator {
            e20: y * half,
            e01: -x * half,
        }
    }
}

impl<T: Real> Motor<T> {
    /// The rotation about a point by an angle in radians, anticlockwise: e^{−θP/2}.
    pub fn about(point: Point<T>, angle: T) -> Self {
        (WeightedPoint::from(point) * (-angle * T::from_ratio(1, 2))).exp()
    }
}
