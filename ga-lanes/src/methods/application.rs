//! One versor on many elements, by its matrix.

use ga_core::{Element, ops};

use super::{fill, replace};
use crate::batch::Batch;
use crate::number::Number;
use crate::operand::One;
use crate::operation::{Everywhere, Values, named};

/// The images of elements `Y` under versors `V`.
type Image<V, Y> = <V as ops::ApplyUnit<Y>>::Image;

/// Versors with a matrix, for the lanes of every target.
pub trait Linear<Y: Element, F: Number>:
    Element<Number = F> + ops::Outermorphism<Y, Image: Element<Number = F>> + Send + Sync
{
    /// Whether so many elements are worth the building of the matrix, once for every lane.
    fn is_worthwhile(count: usize) -> bool {
        Self::WORTHWHILE.is_some_and(|least| count >= least.saturating_mul(F::LINE))
    }
}

impl<V, Y, F> Linear<Y, F> for V
where
    F: Number,
    V: Element<Number = F> + ops::Outermorphism<Y, Image: Element<Number = F>> + Send + Sync,
    Y: Element,
{
}

/// One versor on every element of a batch, by its matrix on their type where there are enough.
///
/// The matrix is built once: it costs an application for each coefficient, and a division unless
/// the versor's type promises that it is unit. Then an element costs its entries alone, half of
/// what [`apply`](One::apply) takes or less. Short batches, and elements on which the matrix has
/// more entries than an application has multiplications, are applied to without it; then too the
/// versor is inverted once.
///
/// `_into` writes to a batch that exists and spares the allocation; `_in_place` replaces the
/// elements.
impl<V, F> One<V>
where
    F: Number,
    V: Element<Number = F>,
{
    /// The versor applied to every element, `V x̂ V⁻¹` (2.28), as by
    /// [`LinearMap`](ga_core::LinearMap).
    ///
    /// ```
    /// use ga_lanes::{Batch, One};
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    /// use r3::{Even, Vector};
    ///
    /// let vectors: Batch<Vector> = (0..100).map(|n| Vector::new(n as f64, 1.0, 2.0)).collect();
    /// let half = Even::new(0.0, 2.0, 0.0, 0.0);
    /// let turned = One(half).apply_linear(&vectors);
    /// assert_eq!(turned.get(7), Some(Vector::new(-7.0, -1.0, 2.0)));
    /// ```
    pub fn apply_linear<Y>(&self, elements: &Batch<Y>) -> Batch<Image<V, Y>>
    where
        Y: Element<Number = F> + Send + Sync,
        V: Linear<Y, F>,
        named::ByMatrix: Everywhere<V, Y, F> + Values<V, Y, Output = Image<V, Y>>,
        named::ByVersor: Everywhere<V, Y, F> + Values<V, Y, Output = Image<V, Y>>,
    {
        let mut out = Batch::new();
        self.apply_linear_into(elements, &mut out);
        out
    }

    /// The versor applied to every element, as by [`LinearMap`](ga_core::LinearMap).
    ///
    /// The result goes to a batch that exists, which takes the length.
    pub fn apply_linear_into<Y>(&self, elements: &Batch<Y>, out: &mut Batch<Image<V, Y>>)
    where
        Y: Element<Number = F> + Send + Sync,
        V: Linear<Y, F>,
        named::ByMatrix: Everywhere<V, Y, F> + Values<V, Y, Output = Image<V, Y>>,
        named::ByVersor: Everywhere<V, Y, F> + Values<V, Y, Output = Image<V, Y>>,
    {
        let len = elements.len();
        if V::is_worthwhile(len) {
            fill(*self, elements, &named::ByMatrix, len, out);
        } else {
            fill(*self, elements, &named::ByVersor, len, out);
        }
    }

    /// The versor applied to every element, as by [`LinearMap`](ga_core::LinearMap).
    ///
    /// The result replaces the elements.
    pub fn apply_linear_in_place<Y>(&self, elements: &mut Batch<Y>)
    where
        Y: Element<Number = F> + Send + Sync,
        V: Linear<Y, F>,
        named::ByMatrix: Everywhere<V, Y, F> + Values<V, Y, Output = Y>,
        named::ByVersor: Everywhere<V, Y, F> + Values<V, Y, Output = Y>,
    {
        if V::is_worthwhile(elements.len()) {
            replace(*self, &named::ByMatrix, elements);
        } else {
            replace(*self, &named::ByVersor, elements);
        }
    }
}
