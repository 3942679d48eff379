//! The versor √(B/A) between elements that have an inverse (2.66).

use ga_core::{Element, Real, Scalar};

use super::null::{Nulls, nulls};
use super::versors::reason;
use super::weight::{both_in_range, factor};
use super::{Carry, NoPath};
use crate::cga3::{
    Circle, DualLine, DualPlane, DualSphere, Even, FlatPoint, Line, Motor, Plane, PointPair, Rotor,
    Sphere, Translator,
};
use crate::classify::Tolerance;

/// Whether the one is the negative of the other to within rounding.
fn opposite<X>(from: X, to: X) -> bool
where
    X: Element<Number: Real>,
{
    factor(from, to).is_ok_and(|factor| factor.all_le(X::Number::ZERO))
}

/// What all elements with a ratio have in common: null ones are moved, and the others must have
/// squares of the same sign.
macro_rules! carried_by {
    ($Versor:ident $root:ident $frame:ident: $($Element:ident)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = $Versor<T>;

            fn versor_near(self, target: Self) -> Result<$Versor<T>, NoPath> {
                let [from, to] = both_in_range(self, target)?;
                let mixed = match nulls(from.into(), to.into()) {
                    Nulls::Both(motor) => return motor.map($Versor::from),
                    Nulls::One => true,
                    Nulls::Neither => false,
                };
                let unit = |x: Self| x.normalized().ok_or(NoPath::Null);
                let versor = unit(from).and_then(|from| {
                    let to = unit(to)?;
                    let [own, other] = [from.norm_squared(), to.norm_squared()];
                    if (own * other).all_le(T::ZERO) {
                        return Err(NoPath::RealToImaginary);
                    }
                    let inverse = from.inverse().ok_or(NoPath::Null)?;
                    let ratio = to * inverse;
                    let versor = match $root!(ratio, $Versor) {
                        Some(versor) => versor,
                        None if opposite(from, to) => return Err(NoPath::Opposite),
                        None if $root!(-ratio, $Versor).is_some() => return Err(NoPath::Reversed),
                        None => return Err(reason(ratio)),
                    };
                    // Where the root is not unique, rounding finds one that need not lead there.
                    match factor(versor.apply(from), to) {
                        Ok(factor) if !factor.all_le(T::ZERO) => Ok(versor),
                        _ if opposite(from, to) => Err(NoPath::Opposite),
                        _ => Err(NoPath::Imprecise),
                    }
                });
                // What is null by rounding has a ratio, if to something else.
                versor.map_err(|reason| if mixed { NoPath::DifferentKinds } else { reason })
            }

            $frame! { T }
        }
    )*};
}

/// The root of any ratio.
macro_rules! root {
    ($ratio:expr, $Versor:ident) => {
        ($ratio).sqrt().and_then($Versor::renormalized)
    };
}

/// The root of a ratio of vectors or their duals, which is one scalar and one blade: the
/// normalised 1 + B/A (2.38). Without a four-vector part there is nothing that rounding could add.
macro_rules! simple_root {
    ($ratio:expr, $Versor:ident) => {{
        let sum = $ratio + $Versor::from(Rotor::identity());
        // A sum with V Ṽ < 0 leads to a sphere of the opposite orientation.
        match sum.norm_squared().all_le(T::ZERO) {
            true => None,
            false => sum.normalized(),
        }
    }};
}

/// Flats keep their precision wherever they are.
macro_rules! anywhere {
    ($T:ident) => {};
}

/// Rounds have squares of distances in their coefficients, but for those that are nearly flat
/// and have none to speak of.
macro_rules! at_center {
    ($T:ident) => {
        fn frame(self) -> Option<[Even<$T>; 2]> {
            let place = self.center()?.position();
            let (away, radius) = (place.norm_squared(), self.radius_squared()?.abs());
            let near = away.all_le(radius * $T::from_integer(4));
            // What may be a tangent must keep the distance that its rounding is judged by.
            let tangent = radius.all_le(away * Tolerance::default().relative);
            if near || tangent {
                return None;
            }
            let there = Translator::by(place);
            Some([there, there.reverse()].map(Even::from))
        }
    };
}

carried_by! { Motor simple_root anywhere: DualPlane Plane }
carried_by! { Even simple_root at_center: DualSphere Sphere }
carried_by! { Motor root anywhere: FlatPoint DualLine Line }
carried_by! { Even root at_center: PointPair Circle }
