//! What carries elements that have an attitude or a size and no place of their own.

use ga_core::Real;

use super::weight::both_in_range;
use super::{Carry, NoPath};
use crate::cga3::{
    Bivector3, DirectionBivector, DirectionTrivector, DirectionVector, MinkowskiPlane, Point,
    Pseudoscalar, Rotor, Scalar, TangentBivector, TangentTrivector, TangentVector, Translator,
    Trivector3, Vector3,
};

/// The rotor from one direction to another.
///
/// # Errors
/// [`NoPath::Opposite`], and [`NoPath::Null`] for a vector of length zero.
pub(super) fn rotor_between<T: Real>(from: Vector3<T>, to: Vector3<T>) -> Result<Rotor<T>, NoPath> {
    let [from, to] = both_in_range(from, to)?;
    Rotor::between(from, to).ok_or(NoPath::Opposite)
}

/// The identity, for two numbers of the same sign.
///
/// # Errors
/// [`NoPath::Reversed`] where the signs differ.
pub(super) fn same_sign<T: Real>(from: T, to: T) -> Result<Rotor<T>, NoPath> {
    let positive = |x: T| T::ZERO.all_le(x);
    if positive(from) == positive(to) {
        Ok(Rotor::identity())
    } else {
        Err(NoPath::Reversed)
    }
}

/// Elements that are a Euclidean vector or bivector at the origin or at infinity.
macro_rules! by_direction {
    ($($Element:ident: $vector:expr;)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = Rotor<T>;

            fn versor_near(self, target: Self) -> Result<Rotor<T>, NoPath> {
                let [from, to] = both_in_range(self, target)?.map($vector);
                rotor_between(from, to)
            }
        }
    )*};
}

by_direction! {
    Vector3: |x| x;
    DirectionVector: DirectionVector::vector;
    TangentVector: TangentVector::vector;
    Bivector3: Bivector3::normal;
    DirectionBivector: |x| DirectionBivector::bivector(x).normal();
    TangentBivector: |x| TangentBivector::bivector(x).normal();
}

/// Elements of one coefficient, which have a weight and nothing else.
macro_rules! by_weight {
    ($($Element:ident)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = Rotor<T>;

            fn versor_near(self, target: Self) -> Result<Rotor<T>, NoPath> {
                let [[from], [to]] = both_in_range(self, target)?.map(Self::to_array);
                same_sign(from, to)
            }
        }
    )*};
}

by_weight! {
    Scalar Trivector3 DirectionTrivector TangentTrivector MinkowskiPlane Pseudoscalar
}

impl<T: Real> Carry for Point<T> {
    type Versor = Translator<T>;

    fn versor_near(self, target: Self) -> Result<Translator<T>, NoPath> {
        let [from, to] = both_in_range(self, target)?;
        Ok(Translator::between(from, to))
    }
}
