//! Paths from versor to versor: which generator leads which way.

use core::fmt::Debug;

use ga_core::ops::Apply;
use ga_core::{Element, Real, Scalar};

use super::weight::{Weight, both_in_range, factor, finite, in_range, scaled};
use super::{NoPath, Way};
use crate::cga3::{
    Bivector3, Dilator, DirectionVector, DualLine, Even, MinkowskiPlane, Motor, Multivector, Odd,
    PointPair, Rotor, TangentVector, Translator, Transversor,
};
use crate::classify::range::largest;

/// A versor that is the exponential of a generator and can be gone in part.
pub trait Continuous:
    Connect<Step = Self> + Debug + Apply<Self::Generator, Output = Self::Generator>
{
    /// The type of the generator.
    type Generator: Copy + Debug + PartialEq;

    /// The generator G with e^{G} = ±V for V of norm one, the way that is asked for.
    ///
    /// # Errors
    /// Every reason of [`NoPath`] that concerns a versor: that it is null, none at all, not
    /// within reach of the identity, half a turn in many planes, or without a turn.
    fn generator(self, way: Way) -> Result<Self::Generator, NoPath>;

    /// The versor e^{tG}.
    fn power(generator: Self::Generator, t: Self::Number) -> Self;
}

/// Versors with paths between them: the even ones, and the odd ones, from each of which an even
/// versor leads to any other.
pub trait Connect: Element<Number: Real> {
    /// The type of the versor from one to the other.
    type Step: Continuous + Element<Number = Self::Number>;

    /// The versor V₁V₀⁻¹ that comes after V₀ = `start` to make V₁ (2.4.5.2); `None` if V₀ is
    /// null.
    fn after(self, start: Self) -> Option<Self::Step>;

    /// This versor followed by another one.
    fn followed_by(self, step: Self::Step) -> Self;

    /// The path e^{tG} V₀ from this versor to another.
    ///
    /// # Errors
    /// The reason why there is none, a [`NoPath`].
    ///
    /// ```
    /// use ga_cga::interpolate::{Connect, NoPath, Way};
    /// use ga_cga::{Dilator, DualPlane, OddVersor, Point, Rotor, Translator, Vector3};
    ///
    /// let z = Vector3::new(0.0, 0.0, 1.0);
    /// let [from, to] = [0.5, 1.5].map(|angle| Rotor::about_axis(z, angle).unwrap());
    /// let half_way = from.versor_path_to(to, Way::Short)?.at(0.5);
    /// assert!((half_way.angle() - 1.0_f64).abs() < 1e-15);
    /// let other_way = from.versor_path_to(to, Way::Long)?.at(0.5);
    /// let x = Vector3::new(1.0, 0.0, 0.0);
    /// assert!((other_way.apply(x) + half_way.apply(x)).norm() < 1e-15);
    ///
    /// // From one glide to another: the reflection stays, the step is even.
    /// let mirror = DualPlane::new(0.0, 0.0, 1.0, 0.0);
    /// let glide = |x| -> OddVersor { Translator::by(Vector3::new(x, 0.0, 0.0)) * mirror };
    /// let glide = glide(1.0).versor_path_to(glide(5.0), Way::Short)?.at(0.5);
    /// let image = Point::at(0.0, 0.0, 2.0).image_under(glide).unwrap();
    /// assert!(image.distance(Point::at(3.0, 0.0, -2.0)) < 1e-14);
    ///
    /// // Nothing leads continuously to a scaling that reflects as well.
    /// let [small, mirrored] = [1.0, -1.0].map(|factor| Dilator::scaling(factor).unwrap());
    /// assert_eq!(small.versor_path_to(mirrored, Way::Short), Err(NoPath::Reversed));
    /// # Ok::<(), NoPath>(())
    /// ```
    fn versor_path_to(self, target: Self, way: Way) -> Result<VersorPath<Self>, NoPath> {
        let [from, to] = both_in_range(self, target)?;
        let generator = to.after(from).ok_or(NoPath::Null)?.generator(way)?;
        let (start, unit) = in_range(self)?;
        let (_, end) = in_range(target)?;
        let image = start.followed_by(Self::Step::power(generator, Self::Number::ONE));
        let growth = factor(image, to)?.abs();
        let weight = Weight::constant(unit).grown(growth, end)?;
        let path = VersorPath {
            start,
            weight,
            generator,
        };
        finite(path.at(Self::Number::ONE)).map(|_| path)
    }
}

/// A path V_t = w^t e^{tG} V₀ of versors, with w for the norm of the target over that of the
/// start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VersorPath<V: Connect> {
    start: V,
    weight: Weight<V::Number>,
    generator: <V::Step as Continuous>::Generator,
}

impl<V: Connect> VersorPath<V> {
    /// The versor at t: the start at 0, and at 1 the target or its negative, which does the same.
    /// The norm goes geometrically from that of the start to that of the target.
    ///
    /// It is finite at 0 and 1, and elsewhere unless what it should be is out of range.
    pub fn at(&self, t: V::Number) -> V {
        let step = V::Step::power(self.generator, t);
        scaled(self.start.followed_by(step), self.weight.at(t))
    }

    /// The generator G.
    pub fn generator(&self) -> <V::Step as Continuous>::Generator {
        self.generator
    }
}

/// Why a versor has no logarithm of either sign.
pub(super) fn reason<T: Real>(versor: impl Into<Multivector<T>>) -> NoPath {
    let Ok((versor, _)) = in_range::<Multivector<T>>(versor.into()) else {
        return NoPath::NotFinite;
    };
    let square = versor * versor.reverse();
    let norm = square.s;
    let rest = square.to_array().into_iter().skip(1);
    let rest = rest.fold(T::ZERO, |sum, c| sum + c.abs());
    let rounding = T::EPSILON * T::from_integer(64);
    if !rest.all_le(norm.abs() * T::from_f64(1e-6) + rounding) {
        // The coefficients of a versor that stretches much cancel in V Ṽ.
        if !rest.all_le(T::EPSILON.sqrt()) {
            NoPath::NotAVersor
        } else if (norm + rest).all_le(T::ZERO) {
            NoPath::Reversed
        } else {
            NoPath::Imprecise
        }
    } else if norm.abs().all_le(rounding) {
        NoPath::Null
    } else if norm.all_le(T::ZERO) {
        NoPath::Reversed
    } else {
        NoPath::ManyWays
    }
}

/// Versors that follow on one another by their ratio.
macro_rules! by_ratio {
    ($($Versor:ident => $Step:ident)*) => {$(
        impl<T: Real> Connect for $Versor<T> {
            type Step = $Step<T>;

            fn after(self, start: Self) -> Option<$Step<T>> {
                Some(self * start.inverse()?)
            }

            fn followed_by(self, step: $Step<T>) -> Self {
                step * self
            }
        }
    )*};
}

/// Versors that turn by their Euclidean bivector, if by any: the short way is that of ⟨V⟩ ≥ 0.
macro_rules! turning {
    ($($Versor:ident $Generator:ident)*) => {$(
        impl<T: Real> Continuous for $Versor<T> {
            type Generator = $Generator<T>;

            fn generator(self, way: Way) -> Result<$Generator<T>, NoPath> {
                let (versor, _) = in_range(self)?;
                let short = if T::ZERO.all_le(versor.s) { versor } else { -versor };
                let short_log = short.log().ok_or_else(|| reason(short))?;
                if way == Way::Short {
                    return Ok(short_log);
                }
                // What is left of a turn by rounding has no plane.
                let plane: Bivector3<T> = ga_core::convert::pick(short_log);
                let rounding = T::EPSILON * T::from_integer(8);
                if plane.norm().all_le(rounding) {
                    return Err(NoPath::DoesNotTurn);
                }
                (-short).log().ok_or(NoPath::DoesNotTurn)
            }

            fn power(generator: $Generator<T>, t: T) -> Self {
                (generator * t).exp()
            }
        }
    )*};
}

/// Versors of scalar part one, which never turn.
macro_rules! straight {
    ($($Versor:ident $Generator:ident)*) => {$(
        impl<T: Real> Continuous for $Versor<T> {
            type Generator = $Generator<T>;

            fn generator(self, way: Way) -> Result<$Generator<T>, NoPath> {
                let log = self.log().ok_or(NoPath::NotFinite)?;
                if way == Way::Long { Err(NoPath::DoesNotTurn) } else { Ok(log) }
            }

            fn power(generator: $Generator<T>, t: T) -> Self {
                (generator * t).exp()
            }
        }

        impl<T: Real> Connect for $Versor<T> {
            type Step = Self;

            fn after(self, start: Self) -> Option<Self> {
                Some(self * start.reverse())
            }

            fn followed_by(self, step: Self) -> Self {
                step * self
            }
        }
    )*};
}

by_ratio! {
    Rotor => Rotor
    Motor => Motor
    Dilator => Dilator
    Even => Even
    Odd => Even
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
    type Generator = PointPair<T>;

    fn generator(self, way: Way) -> Result<PointPair<T>, NoPath> {
        let (versor, _) = in_range(self)?;
        let positive = T::ZERO.all_le(versor.s);
        let versor = if positive { versor } else { -versor };
        let short = logarithm(versor)?;
        match way {
            Way::Short => Ok(short),
            // −e^{G} has a logarithm if G turns; if not, rounding finds one somewhere.
            Way::Long if turns(short) => logarithm(-versor),
            Way::Long => Err(NoPath::DoesNotTurn),
        }
    }

    fn power(generator: PointPair<T>, t: T) -> Self {
        (generator * t).exp()
    }
}

/// The logarithm of a versor, also where the rounding of a ratio is more than drift.
fn logarithm<T: Real>(versor: Even<T>) -> Result<PointPair<T>, NoPath> {
    if let Some(log) = versor.log() {
        return Ok(log);
    }
    match reason(versor) {
        NoPath::Imprecise => {
            let nearest = versor.renormalized().ok_or(NoPath::Imprecise)?;
            nearest.log().ok_or(NoPath::Imprecise)
        }
        reason => Err(reason),
    }
}

/// Whether one of the two commuting blades of a generator has a negative square.
fn turns<T: Real>(generator: PointPair<T>) -> bool {
    let rounding = T::EPSILON * T::from_integer(8);
    if largest(&generator).is_some_and(|size| size.all_le(rounding)) {
        return false;
    }
    let Some(blades) = generator.split_commuting().blades() else {
        // Where there is no unique pair both blades turn alike.
        return true;
    };
    let [larger, smaller] = blades.map(|blade| blade.scalar_product(blade));
    let rounding = (larger.abs() + smaller.abs()) * T::EPSILON;
    !(-rounding).all_le(smaller)
}
