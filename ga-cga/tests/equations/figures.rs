//! Exact points of exact figures: directions, circles and spheres with rational points, and
//! the two null vectors of the basis.

use ga_cga::{DualSphere, Point, Pseudoscalar, Vector3, cga3};
use ga_core::Rational;
use ga_core::ops::Element;

use super::samples::{Samples, unit};

/// Directions as exact fractions.
pub type Direction = Vector3<Rational>;

/// n_o, as a vector of the algebra.
pub fn origin() -> DualSphere<Rational> {
    unit(0)
}

/// n_∞, as a vector of the algebra.
pub fn infinity() -> DualSphere<Rational> {
    unit(4)
}

/// I = e₁₂₃ E.
pub fn pseudoscalar() -> Pseudoscalar<Rational> {
    unit(0)
}

/// A fraction.
pub fn ratio(numerator: i128, denominator: i128) -> Rational {
    Rational::new(numerator, denominator)
}

/// Any element in the type of all elements, to compare elements of different types.
pub fn wide(x: impl Into<cga3::Multivector<Rational>>) -> cga3::Multivector<Rational> {
    x.into()
}

/// An element as a narrower type that holds all of it.
pub fn exactly<A, B>(x: A) -> B
where
    A: Element<Number = Rational> + Into<cga3::Multivector<Rational>>,
    B: Element<Number = Rational> + Into<cga3::Multivector<Rational>>,
{
    let narrow = B::from_fn(|position| {
        let (blade, sign) = B::BLADES[position];
        x.coefficient(blade) * Rational::from_integer(sign.into())
    });
    assert_eq!(wide(narrow), wide(x));
    narrow
}

/// A position with whole coordinates.
pub fn position(samples: &mut Samples) -> Direction {
    Direction::from([(); 3].map(|()| samples.whole(4)))
}

/// Three orthonormal directions.
pub fn frame(samples: &mut Samples) -> [Direction; 3] {
    let turn = cga3::Rotor::from([(); 4].map(|()| samples.whole(2)));
    std::array::from_fn(|axis| turn.apply(unit::<Direction>(axis)))
}

/// A circle: its centre, two orthonormal directions of its plane, the normal and the radius.
pub struct Circular {
    /// The centre.
    pub center: Direction,
    /// Two directions of its plane, and the normal.
    pub frame: [Direction; 3],
    /// The radius, a whole number.
    pub radius: Rational,
}

impl Circular {
    /// A random circle.
    pub fn random(samples: &mut Samples) -> Self {
        Circular {
            center: position(samples),
            frame: frame(samples),
            radius: samples.positive(3),
        }
    }

    /// Five different points of the circle.
    pub fn points(&self) -> [Point<Rational>; 5] {
        let [u, v, _] = self.frame;
        let angles = [(1, 0), (0, 1), (3, 4), (-4, 3), (-3, -4)];
        angles.map(|(cos, sin): (i128, i128)| {
            let hypotenuse = if cos * sin == 0 { 1 } else { 5 };
            let direction = u * ratio(cos, hypotenuse) + v * ratio(sin, hypotenuse);
            Point::from(self.center + direction * self.radius)
        })
    }

    /// Six different points of the sphere of the same centre and radius, no four of the first
    /// five in one plane.
    pub fn points_of_sphere(&self) -> [Point<Rational>; 6] {
        let [u, v, w] = self.frame;
        let directions = [
            (3, 0, 0),
            (0, 3, 0),
            (0, 0, 3),
            (-1, -2, -2),
            (2, -1, 2),
            (-2, 2, 1),
        ];
        directions.map(|(x, y, z): (i128, i128, i128)| {
            let direction = u * ratio(x, 3) + v * ratio(y, 3) + w * ratio(z, 3);
            Point::from(self.center + direction * self.radius)
        })
    }
}
