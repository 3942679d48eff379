//! One versor on many elements: its matrix on a type, without the entries that are always zero.

use core::fmt;

use crate::convert::{basis, pick};
use crate::ops::{ApplyUnit, Element, Outermorphism};
use crate::{Field, LengthMismatch, Scalar};

/// What a versor does to elements of one type, as a matrix: the outermorphism `x ↦ V x̂ V⁻¹`.
///
/// Only the entries are stored that can differ from zero; which they are is known at compile
/// time. A conformal motor on a point takes 17 of 25, of which three are added without a
/// multiplication, and a plane-based motor on a point 12 of 16. Building the matrix costs an
/// application per coefficient of the type, and then [`apply`](LinearMap::apply) costs the
/// entries alone: worth it from about ten elements on, which
/// [`Outermorphism::WORTHWHILE`] says for each pair of types. The operation counts are in the
/// ledger, as `Motor.linear_map(Point)`.
///
/// Made by `versor.linear_map::<Point>()`, of any versor type and of [`Unit`](crate::Unit).
///
/// ```
/// use ga_core::LinearMap;
/// use ga_core::ops::Outermorphism;
///
/// /// The greatest of many coefficients after a motion.
/// fn farthest<V, X>(map: &LinearMap<V, X>, elements: &[X]) -> f64
/// where
///     V: Outermorphism<X, Image = X>,
///     X: ga_core::Element<Number = f64>,
/// {
///     let images = elements.iter().map(|x| map.apply(*x));
///     images.map(|image| image.at(0)).fold(f64::MIN, f64::max)
/// }
/// ```
pub struct LinearMap<V: Outermorphism<X>, X> {
    rows: V::Rows,
}

impl<V: Outermorphism<X>, X> LinearMap<V, X> {
    /// The matrix of a versor, given the multiple whose reverse is the inverse.
    #[inline]
    pub(crate) fn with(versor: V, w: V::Multiple) -> Self {
        LinearMap {
            rows: versor.rows_with(w),
        }
    }

    /// The image of an element, as the versor applied to it.
    #[inline(always)]
    pub fn apply(&self, x: X) -> V::Image {
        V::image(&self.rows, x)
    }
}

impl<V: Outermorphism<X>, X: Copy> LinearMap<V, X> {
    /// The images of all elements of a slice.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are of different lengths; nothing is written then.
    #[inline]
    pub fn apply_slice(
        &self,
        elements: &[X],
        images: &mut [V::Image],
    ) -> Result<(), LengthMismatch> {
        into_slice(elements, images, |x| self.apply(x))
    }

    /// Replaces every element of a slice by its image, where that is of the same type.
    #[inline]
    pub fn apply_slice_in_place(&self, elements: &mut [X])
    where
        V: Outermorphism<X, Image = X>,
    {
        for x in elements {
            *x = self.apply(*x);
        }
    }
}

/// Writes the image of every element.
#[inline]
fn into_slice<X: Copy, Y>(
    elements: &[X],
    images: &mut [Y],
    image: impl Fn(X) -> Y,
) -> Result<(), LengthMismatch> {
    if elements.len() != images.len() {
        return Err(LengthMismatch {
            left: elements.len(),
            right: images.len(),
        });
    }
    for (place, x) in images.iter_mut().zip(elements) {
        *place = image(*x);
    }
    Ok(())
}

/// Whether the matrix costs less than applications one by one.
#[inline]
fn is_worthwhile<V: Outermorphism<X>, X>(length: usize) -> bool {
    V::WORTHWHILE.is_some_and(|least| length >= least)
}

/// The images of all elements of a slice under a versor, by its matrix where there are enough.
#[inline]
pub fn apply_slice<V, X>(
    versor: V,
    w: V::Multiple,
    elements: &[X],
    images: &mut [V::Image],
) -> Result<(), LengthMismatch>
where
    V: Outermorphism<X>,
    X: Copy,
{
    if is_worthwhile::<V, X>(elements.len()) {
        return LinearMap::with(versor, w).apply_slice(elements, images);
    }
    into_slice(elements, images, |x| versor.apply_with(w, x))
}

/// The same in place.
#[inline]
pub fn apply_slice_in_place<V, X>(versor: V, w: V::Multiple, elements: &mut [X])
where
    V: Outermorphism<X> + ApplyUnit<X, Image = X>,
    X: Copy,
{
    if is_worthwhile::<V, X>(elements.len()) {
        return LinearMap::<V, X>::with(versor, w).apply_slice_in_place(elements);
    }
    for x in elements {
        *x = versor.apply_with(w, *x);
    }
}

/// The columns of a matrix, given the multiple whose reverse is the inverse: the image of the fixed
/// coefficients, and that of every field's blade.
#[doc(hidden)]
#[inline(always)]
pub fn columns<V, X, L, Y, const FIELDS: usize>(versor: V, w: V::Multiple) -> (Y, [Y; FIELDS])
where
    V: ApplyUnit<L, Image: Element<Number = Y::Number>>,
    X: Element<Number = Y::Number>,
    L: Element<Number = Y::Number> + From<X>,
    Y: Element<Number: Field>,
{
    // Loops here and below, because lanes want no closure: it would not be inlined.
    let fixed = pick(versor.apply_with(w, L::from(X::from_fn(|_| Y::Number::ZERO))));
    let mut columns = [fixed; FIELDS];
    for (place, column) in columns.iter_mut().enumerate() {
        *column = pick(versor.apply_with(w, basis::<X, L>(place)));
    }
    (fixed, columns)
}

/// An entry times a coefficient for each of them.
#[doc(hidden)]
#[inline(always)]
pub fn linear<T: Scalar>(entries: &[T], x: &[T]) -> T {
    let mut products = entries.iter().zip(x);
    let Some((entry, x)) = products.next() else {
        return T::ZERO;
    };
    let mut sum = *entry * *x;
    for (entry, x) in products {
        sum = sum.plus_product(*entry, *x);
    }
    sum
}

/// The first entry, and another times a coefficient for each of these.
#[doc(hidden)]
#[inline(always)]
pub fn affine<T: Scalar>(entries: &[T], x: &[T]) -> T {
    let Some((first, entries)) = entries.split_first() else {
        return T::ZERO;
    };
    let mut sum = *first;
    for (entry, x) in entries.iter().zip(x) {
        sum = sum.plus_product(*entry, *x);
    }
    sum
}

/// The matrix of any versor: of `V/⟨V Ṽ⟩` as the inverse.
#[inline]
pub fn linear_map<V, X>(versor: V) -> LinearMap<V, X>
where
    V: Outermorphism<X, Number: Field>,
{
    LinearMap::with(versor, versor.over_norm())
}

impl<V: Outermorphism<X>, X> Clone for LinearMap<V, X> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: Outermorphism<X>, X> Copy for LinearMap<V, X> {}

impl<V: Outermorphism<X>, X> fmt::Debug for LinearMap<V, X> {
    /// The types, of the versor and of what it acts on.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (versor, element) = (core::any::type_name::<V>(), core::any::type_name::<X>());
        write!(f, "LinearMap<{versor}, {element}>")
    }
}
