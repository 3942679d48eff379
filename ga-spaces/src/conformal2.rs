//! R3,1, conformal algebra of the plane: points, circles, lines and all transformations that
//! keep angles, which are Möbius' transformations of the complex numbers.
//!
//! A point is the null vector n_o + **x** + ½**x**² n_∞. The outer product of three points is
//! the circle through them, a line where they are collinear; even versors act like
//! (a z + b)/(c z + d), odd ones reflect in circles.
//!
//! ```
//! use ga_spaces::conformal2::{Circle, DualCircle, Point};
//!
//! let circle: Circle = Point::at(1.0, 0.0) ^ Point::at(0.0, 1.0) ^ Point::at(-1.0, 0.0);
//! let dual: DualCircle = circle.dual();
//! assert_eq!(dual.center(), Some(Point::at(0.0, 0.0)));
//! assert_eq!(dual.radius_squared(), Some(1.0));
//! ```
//!
//! Sources: §2.4 of the dissertation with one dimension less; Needham, *Visual Complex Analysis*
//! (1997), chapter 3.

use ga_core::{Field, Real};

ga_macros::define_algebra! {
    mod algebra: R3_1 {
        basis { e1, e2, no, ni }
        metric { e1^2 = 1, e2^2 = 1, no.ni = -1 }
        types {
            /// A vector of the plane.
            Vector2 { e1, e2 }
            /// A point of weight 1.
            #[null]
            Point { no = 1, e1, e2, ni }
            /// A circle as vector, p − ½r² n_∞ times a weight; a line where the weight is zero.
            /// Its versor is the inversion in it.
            DualCircle { no, e1, e2, ni }
            /// A line as vector, **n** + δ n_∞: a mirror.
            DualLine { e1, e2, ni }
            /// A point pair a∧b.
            PointPair = grade 2;
            /// A point together with the one at infinity, p∧n_∞.
            FlatPoint { e1^ni, e2^ni, no^ni }
            /// A circle a∧b∧c.
            Circle = grade 3;
            /// A line a∧b∧n_∞.
            Line { e12^ni, e1^no^ni, e2^no^ni }
            /// A rotation about the origin.
            Rotor { 1, e12 }
            /// A translation, of unit norm.
            #[unit]
            Translator { 1 = 1, e1^ni, e2^ni }
            /// Any rigid motion without reflection.
            Motor { 1, e12, e1^ni, e2^ni }
            /// A scaling about the origin.
            Dilator { 1, no^ni }
        }
    }
}

pub use algebra::*;

/// Any transformation that keeps angles and their sense, and with them every even element.
pub type Conformal<T = f64> = Even<T>;

impl<T: Field> Point<T> {
    /// The point with these Cartesian coordinates.
    pub fn at(x: T, y: T) -> Self {
        Point::from(Vector2::new(x, y))
    }

    /// The position relative to the origin.
    pub fn position(self) -> Vector2<T> {
        Vector2::new(self.e1, self.e2)
    }
}

impl<T: Field> From<Vector2<T>> for Point<T> {
    /// The point n_o + **x** + ½**x**² n_∞ (2.44).
    fn from(x: Vector2<T>) -> Self {
        Point {
            e1: x.e1,
            e2: x.e2,
            ni: x.norm_squared() * T::from_ratio(1, 2),
        }
    }
}

impl<T: Field> DualCircle<T> {
    /// The circle about a point with this squared radius; imaginary where that is negative.
    pub fn about(center: Point<T>, radius_squared: T) -> Self {
        let mut circle = DualCircle::from(center);
        circle.ni -= radius_squared * T::from_ratio(1, 2);
        circle
    }

    /// The point at infinity n_∞.
    pub fn infinity() -> Self {
        DualCircle {
            ni: T::ONE,
            ..DualCircle::default()
        }
    }

    /// The squared radius σ²/(σ·n_∞)²; `None` for a line, which has none.
    pub fn radius_squared(self) -> Option<T> {
        let weight = self.scalar_product(DualCircle::infinity());
        let square = weight * weight;
        square.is_invertible().then(|| self.norm_squared() / square)
    }

    /// The centre; `None` for a line, which has none.
    pub fn center(self) -> Option<Point<T>> {
        self.no
            .is_invertible()
            .then(|| Point::at(self.e1 / self.no, self.e2 / self.no))
    }
}

impl<T: Field> Translator<T> {
    /// The translation by a vector, 1 − ½**v** n_∞.
    pub fn by(v: Vector2<T>) -> Self {
        let half = T::from_ratio(-1, 2);
        Translator::new(v.e1 * half, v.e2 * half)
    }
}

impl<T: Real> Rotor<T> {
    /// The rotation about the origin by an angle in radians, anticlockwise.
    pub fn by_angle(angle: T) -> Self {
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        Rotor::new(cos, -sin)
    }
}

impl<T: Real> Dilator<T> {
    /// The scaling about the origin by a factor; `None` unless that is positive and finite.
    pub fn by_factor(factor: T) -> Option<Self> {
        let wrong = factor.all_le(T::ZERO) || !factor.is_finite();
        // The scaling by s is √s·e^{½E ln s} up to its norm: (1 + s) + (s − 1)E.
        (!wrong)
            .then(|| Dilator::new(factor + T::ONE, factor - T::ONE))?
            .normalized()
    }
}

impl<T: Real> PointPair<T> {
    /// The two points of a∧b, a first (2.57); `None` for an imaginary pair, for one point taken
    /// twice, and where one of the points is at infinity.
    pub fn split(self) -> Option<[Point<T>; 2]> {
        let square = self.scalar_product(self);
        if square.all_le(T::ZERO) || !square.is_finite() {
            return None;
        }
        let root = square.sqrt();
        let toward = DualCircle::infinity().left_contract(self);
        let turned = toward.left_contract(self);
        let points = [toward * root + turned, turned - toward * root];
        let [first, second] = points.map(DualCircle::center);
        Some([first?, second?])
    }
}
