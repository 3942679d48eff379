//! Repeatable random elements.

use ga_cga::{DualPlane, DualSphere, Even, Motor, Point, Rotor, Translator, Vector3};
use ga_core::ops::Element;
use ga_core::{Real, Scalar};

/// A source of numbers that is the same in every run (splitmix64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// A number from −1 to 1.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vector3 {
        Vector3::new(self.number(), self.number(), self.number())
    }

    /// A vector of length one.
    pub fn direction(&mut self) -> Vector3 {
        loop {
            let vector = self.vector();
            if vector.norm() > 0.1 {
                return vector / vector.norm();
            }
        }
    }

    pub fn point(&mut self) -> Point {
        Point::from(self.vector() * 3.0)
    }

    pub fn rotor(&mut self) -> Rotor {
        let angle = self.number() * 6.0;
        Rotor::about_axis(self.direction(), angle).expect("a direction has a length")
    }

    pub fn translator(&mut self) -> Translator {
        Translator::by(self.vector() * 4.0)
    }

    pub fn motor(&mut self) -> Motor {
        let rotor = self.rotor();
        self.translator() * rotor
    }

    pub fn plane(&mut self) -> DualPlane {
        let distance = self.number();
        DualPlane::at_distance(self.direction(), distance)
    }

    /// A sphere, real or imaginary, with a radius from 0.5 to 2.
    pub fn sphere(&mut self) -> DualSphere {
        let center = self.point();
        let radius = 1.25 + 0.75 * self.number();
        let sign = if self.number() < 0.3 { -1.0 } else { 1.0 };
        DualSphere::about(center, sign * radius * radius)
    }

    /// The product of a motor and two inversions: any conformal map that keeps orientation or
    /// does not.
    pub fn even(&mut self) -> Even {
        self.motor() * (self.sphere() * self.sphere())
    }

    /// Any element with coefficients from −1 to 1; of a type declared null, one of these is what
    /// the others make it.
    pub fn element<X: Element<Number = f64>>(&mut self) -> X {
        let x = X::from_fn(|_| self.number());
        let one = X::BLADES.len();
        let mut determined = None;
        for (_, form) in X::NULL {
            let is_own = |own: usize| form.iter().filter(|t| t.0 == own || t.1 == own).count() == 1;
            let own = form.iter().find(|term| term.1 == one && is_own(term.0));
            let (own, _, factor, _) = *own.expect("a linear coefficient");
            let value = |position: usize| if position == one { 1.0 } else { x.at(position) };
            let others = form.iter().filter(|term| term.0 != own);
            let sum: f64 = others.map(|t| value(t.0) * value(t.1) * t.2 as f64).sum();
            determined = Some((own, -sum / factor as f64));
        }
        X::from_fn(|i| match determined {
            Some((own, value)) if own == i => value,
            _ => x.at(i),
        })
    }
}

/// The largest coefficient of an element, for relative errors.
pub fn size<X: Element<Number: Real + PartialOrd>>(x: X) -> X::Number {
    let sizes = (0..X::BLADES.len()).map(|i| x.at(i).abs());
    sizes.fold(X::Number::ZERO, |a, b| if a < b { b } else { a })
}
