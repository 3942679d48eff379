//! Versors of norm 1, which apply without a division.

use core::fmt;
use core::ops::{Deref, Mul, Neg};

use crate::ops::{
    Apply, ApplyUnit, Element, Geometric, Involute, Logarithm, Outermorphism, Reverse, Versor,
};
use crate::{Blade, LengthMismatch, LinearMap, Real, Scalar, linear_map};

/// A versor `V` with `V Ṽ = 1`, by normalisation or by promise.
///
/// Every versor applies by `V x̂ V⁻¹`; of a unit versor the inverse is the reverse, so that
/// [`apply`](Unit::apply) spares the norm, a division and a multiplication a coefficient. That
/// pays where one versor meets many objects and in hot loops; elsewhere a plain versor is as good,
/// and right whatever its norm.
///
/// The wrapper changes nothing else: it dereferences to the versor, and products, reverses and
/// negatives of unit versors are unit again. Rounding adds up over long products;
/// [`new`](Unit::new) takes the product back to norm 1, and `renormalized` of the versor types
/// removes every other drift.
///
/// ```
/// use ga_core::Unit;
/// use ga_core::ops::{ApplyUnit, Versor};
///
/// /// Many objects moved by one versor, which is normalised once.
/// fn moved<V, X>(versor: V, objects: &[X]) -> Option<Vec<<V::Multiple as ApplyUnit<X>>::Image>>
/// where
///     V: Versor<Number = f64, Multiple: ApplyUnit<X>>,
///     X: Copy,
/// {
///     let unit = Unit::new(versor)?;
///     Some(objects.iter().map(|x| unit.apply(*x)).collect())
/// }
/// ```
///
/// Named and built like `nalgebra::Unit`. With the feature `serde` it reads and writes as the
/// versor in it, taken as it is. There is no cast from bytes: they promise nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Unit<V>(V);

impl<M> Unit<M> {
    /// The positive multiple with `V Ṽ = 1`; `None` where `⟨V Ṽ⟩` is not a positive finite number.
    ///
    /// A type with fixed coefficients that do not make it unit has no multiples of its own; theirs
    /// are of the type that its sums have. That the element is a versor, so that `V Ṽ` has no
    /// other part than the scalar, is taken for granted.
    #[inline(always)]
    pub fn new<V>(versor: V) -> Option<Unit<M>>
    where
        V: Versor<Multiple = M, Number: Real>,
    {
        versor.unit().map(Unit)
    }
}

impl<V> Unit<V> {
    /// The versor as it is, of which the caller promises `V Ṽ = 1`.
    ///
    /// Nothing is checked. What a versor of another norm does to elements is not (2.28).
    #[inline(always)]
    pub const fn promised(versor: V) -> Self {
        Unit(versor)
    }

    /// The versor.
    #[inline(always)]
    pub fn into_inner(self) -> V {
        self.0
    }

    /// The same versor as a wider type, a rotor as a motor.
    #[inline(always)]
    pub fn widened<W: From<V>>(self) -> Unit<W> {
        Unit(W::from(self.0))
    }

    /// The image `V x̂ Ṽ` of an element (2.28), by its shortest form.
    ///
    /// Formula and operation count stand with the implementation of [`ApplyUnit`] for the versor
    /// and the element.
    #[inline(always)]
    pub fn apply<X>(self, x: X) -> V::Image
    where
        V: ApplyUnit<X>,
    {
        self.0.apply_unit(x)
    }

    /// The matrix of this versor on elements of type `X`; an application for each coefficient.
    #[inline(always)]
    pub fn linear_map<X>(self) -> LinearMap<V, X>
    where
        V: Outermorphism<X>,
    {
        LinearMap::with(self.0, self.0.multiple())
    }

    /// The images of all elements of a slice, by the matrix where that takes fewer
    /// multiplications.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are of different lengths; nothing is written then.
    #[inline(always)]
    pub fn apply_slice<X: Copy>(
        self,
        elements: &[X],
        images: &mut [V::Image],
    ) -> Result<(), LengthMismatch>
    where
        V: Outermorphism<X>,
    {
        linear_map::apply_slice(self.0, self.0.multiple(), elements, images)
    }

    /// Replaces every element of a slice by its image, where that is of the same type; by the
    /// matrix where that takes fewer multiplications.
    #[inline(always)]
    pub fn apply_slice_in_place<X: Copy>(self, elements: &mut [X])
    where
        V: Outermorphism<X, Image = X>,
    {
        linear_map::apply_slice_in_place(self.0, self.0.multiple(), elements);
    }

    /// The reverse, which is the inverse.
    #[inline(always)]
    pub fn reverse(self) -> Unit<V::Output>
    where
        V: Reverse,
    {
        Unit(self.0.reverse())
    }

    /// The inverse, which is the reverse: it always exists and takes no division.
    #[inline(always)]
    pub fn inverse(self) -> Unit<V::Output>
    where
        V: Reverse,
    {
        self.reverse()
    }

    /// The principal logarithm, without asking for the norm; `None` where there is no real one or
    /// it is not unique.
    #[inline(always)]
    pub fn log(self) -> Option<V::Output>
    where
        V: Logarithm,
    {
        self.0.log_of_unit()
    }

    /// The geometric product, a unit versor again: first `b`, then this one.
    #[inline(always)]
    pub fn geometric<B>(self, b: Unit<B>) -> Unit<V::Output>
    where
        V: Geometric<B>,
    {
        Unit(self.0.geometric(b.0))
    }
}

impl<V> Deref for Unit<V> {
    type Target = V;

    #[inline(always)]
    fn deref(&self) -> &V {
        &self.0
    }
}

/// The coefficients of the versor; whoever makes one of coefficients promises that it is unit, as
/// with [`promised`](Unit::promised).
impl<V: Element> Element for Unit<V> {
    type Number = V::Number;
    type Over<U: Scalar> = Unit<V::Over<U>>;
    const BLADES: &'static [(Blade, i8)] = V::BLADES;
    const FIXED: &'static [(Blade, i8, i64, i64)] = V::FIXED;
    const LABELS: &'static [&'static str] = V::LABELS;

    #[inline(always)]
    fn at(&self, position: usize) -> V::Number {
        self.0.at(position)
    }

    #[inline(always)]
    fn from_fn(coefficient: impl FnMut(usize) -> V::Number) -> Self {
        Unit(V::from_fn(coefficient))
    }

    #[inline(always)]
    fn place(&self, position: usize) -> Option<&V::Number> {
        self.0.place(position)
    }

    #[inline(always)]
    fn place_mut(&mut self, position: usize) -> Option<&mut V::Number> {
        self.0.place_mut(position)
    }
}

impl<V: fmt::Display> fmt::Display for Unit<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<V: ApplyUnit<X>, X> Apply<X> for Unit<V> {
    type Output = V::Image;

    #[inline(always)]
    fn apply(self, x: X) -> V::Image {
        self.0.apply_unit(x)
    }
}

impl<V: Logarithm> Logarithm for Unit<V> {
    type Output = V::Output;
    const LONG: bool = V::LONG;

    #[inline(always)]
    fn log(self) -> Option<V::Output> {
        self.0.log_of_unit()
    }
}

impl<V: Reverse> Reverse for Unit<V> {
    type Output = Unit<V::Output>;

    #[inline(always)]
    fn reverse(self) -> Unit<V::Output> {
        Unit(self.0.reverse())
    }
}

impl<V: Involute> Involute for Unit<V> {
    type Output = Unit<V::Output>;

    #[inline(always)]
    fn involute(self) -> Unit<V::Output> {
        Unit(self.0.involute())
    }
}

impl<A: Geometric<B>, B> Geometric<Unit<B>> for Unit<A> {
    type Output = Unit<A::Output>;

    #[inline(always)]
    fn geometric(self, b: Unit<B>) -> Unit<A::Output> {
        Unit(self.0.geometric(b.0))
    }
}

impl<A: Geometric<B>, B> Mul<Unit<B>> for Unit<A> {
    type Output = Unit<A::Output>;

    #[inline(always)]
    fn mul(self, b: Unit<B>) -> Unit<A::Output> {
        self.geometric(b)
    }
}

impl<V: Neg> Neg for Unit<V> {
    type Output = Unit<V::Output>;

    /// The negative, which applies as the versor itself does.
    #[inline(always)]
    fn neg(self) -> Unit<V::Output> {
        Unit(-self.0)
    }
}

#[cfg(feature = "serde")]
impl<V: serde_core::Serialize> serde_core::Serialize for Unit<V> {
    fn serialize<S: serde_core::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de, V: serde_core::Deserialize<'de>> serde_core::Deserialize<'de> for Unit<V> {
    fn deserialize<D: serde_core::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        V::deserialize(deserializer).map(Unit)
    }
}
