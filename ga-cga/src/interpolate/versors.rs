//! Paths from versor to versor: which generator leads which way.

use core::fmt::Debug;

use ga_core::Real;

use super::Way;
use crate::cga3::{
    Bivector3, Dilator, DirectionVector, DualLine, Even, MinkowskiPlane, Motor, PointPair, Rotor,
    TangentVector, Translator, Transversor,
};

/// A versor that is the exponential of a generator and can be gone in part.
pub trait Continuous: Copy {
    /// The type of the numbers.
    type Number: Real;
    /// The type of the generator.
    type Generator: Copy + Debug + PartialEq;

    /// The generator G with e^{G} = ±V for V of norm one, the way that is asked for; `None`
    /// where there is none, and for what is no versor.
    fn generator(self, way: Way) -> Option<Self::Generator>;

    /// The versor e^{tG}.
    fn power(generator: Self::Generator, t: Self::Number) -> Self;

    /// The versor V₁V₀⁻¹ that comes after V₀ = `start` to make V₁ (2.4.5.2); `None` if V₀ is
    /// null.
    fn after(self, start: Self) -> Option<Self>;

    /// The path from this versor to another; `None` where no way of the kind leads there.
    ///
    /// ```
    /// use ga_cga::interpolate::{Continuous, Way};
    /// use ga_cga::{Rotor, Vector3};
    ///
    /// let z = Vector3::new(0.0, 0.0, 1.0);
    /// let [from, to] = [0.5, 1.5].map(|angle| Rotor::about_axis(z, angle).unwrap());
    /// let half_way = from.versor_path_to(to, Way::Short).unwrap().at(0.5);
    /// assert!((half_way.angle() - 1.0_f64).abs() < 1e-15);
    /// let other_way = from.versor_path_to(to, Way::Long).unwrap().at(0.5);
    /// let x = Vector3::new(1.0, 0.0, 0.0);
    /// assert!((other_way.apply(x) + half_way.apply(x)).norm() < 1e-15);
    /// ```
    fn versor_path_to(self, target: Self, way: Way) -> Option<VersorPath<Self>> {
        let generator = target.after(self)?.generator(way)?;
        Some(VersorPath {
            start: self,
            generator,
        })
    }

    /// This versor followed by e^{tG}.
    fn continued(self, generator: Self::Generator, t: Self::Number) -> Self;
}

/// A path V_t = e^{tG} V₀ of versors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VersorPath<V: Continuous> {
    start: V,
    generator: V::Generator,
}

impl<V: Continuous> VersorPath<V> {
    /// The versor at t: the start at 0, and at 1 what does the same as the target.
    pub fn at(&self, t: V::Number) -> V {
        self.start.continued(self.generator, t)
    }

    /// The generator G.
    pub fn generator(&self) -> V::Generator {
        self.generator
    }
}

macro_rules! common {
    ($Versor:ident $Generator:ident) => {
        type Number = T;
        type Generator = $Generator<T>;

        fn power(generator: $Generator<T>, t: T) -> Self {
            (generator * t).exp()
        }

        fn continued(self, generator: $Generator<T>, t: T) -> Self {
            Self::power(generator, t) * self
        }
    };
}

/// Versors with a sign: the short way is that of ⟨V⟩ ≥ 0.
macro_rules! turning {
    ($($Versor:ident $Generator:ident)*) => {$(
        impl<T: Real> Continuous for $Versor<T> {
            common! { $Versor $Generator }

            fn after(self, start: Self) -> Option<Self> {
                Some(self * start.inverse()?)
            }

            fn generator(self, way: Way) -> Option<$Generator<T>> {
                let short = T::ZERO.all_le(self.s);
                let versor = if short == (way == Way::Short) { self } else { -self };
                versor.log()
            }
        }
    )*};
}

/// Versors of scalar part one, which never turn.
macro_rules! straight {
    ($($Versor:ident $Generator:ident)*) => {$(
        impl<T: Real> Continuous for $Versor<T> {
            common! { $Versor $Generator }

            fn after(self, start: Self) -> Option<Self> {
                Some(self * start.reverse())
            }

            fn generator(self, way: Way) -> Option<$Generator<T>> {
                match way {
                    Way::Short => self.log(),
                    Way::Long => None,
                }
            }
        }
    )*};
}

turning! {
    Rotor Bivector3
    Motor DualLine
    Dilator MinkowskiPlane
}
straight! {
    Translator DirectionVector
    Transversor TangentVector
}

impl<T: Real> Continuous for Even<T> {
    common! { Even PointPair }

    fn after(self, start: Self) -> Option<Self> {
        Some(self * start.inverse()?)
    }

    fn generator(self, way: Way) -> Option<PointPair<T>> {
        let positive = T::ZERO.all_le(self.s);
        let versor = if positive { self } else { -self };
        let short = versor.log()?;
        match way {
            Way::Short => Some(short),
            // −e^{G} has a logarithm if G turns; if not, rounding finds one somewhere.
            Way::Long if turns(short) => (-versor).log(),
            Way::Long => None,
        }
    }
}

/// Whether one of the two commuting blades of a generator has a negative square.
fn turns<T: Real>(generator: PointPair<T>) -> bool {
    let Some(blades) = generator.split_commuting().blades() else {
        // Where there is no unique pair both blades turn alike.
        return true;
    };
    let [larger, smaller] = blades.map(|blade| blade.scalar_product(blade));
    let rounding = (larger.abs() + smaller.abs()) * T::EPSILON;
    !(-rounding).all_le(smaller)
}
