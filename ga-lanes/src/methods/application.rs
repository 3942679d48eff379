//! One versor on many elements, by its matrix.

use ga_core::Element;

use super::{Of, fill, replace};
use crate::batch::Batch;
use crate::number::Number;
use crate::operand::One;
use crate::operation::{Everywhere, Values, named};

/// One versor on every element of a batch, by its matrix on their type.
///
/// The matrix is built once: it costs some applications, and a division unless the versor's type
/// promises that it is unit. Then an element costs its entries alone, half of what
/// [`apply`](One::apply) takes or less. Where the matrix has more entries than an application has
/// multiplications, elements are applied to without it, and the versor is inverted once.
///
/// `_into` writes to a batch that exists and spares the allocation; `_in_place` replaces the
/// elements.
impl<V, F> One<V>
where
    F: Number,
    V: Element<Number = F> + Send + Sync,
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
    /// let half = Even::new(0.0, 3.0, 0.0, 0.0);
    /// let turned = One(half).apply_linear(&vectors);
    /// assert_eq!(turned.get(7), Some(Vector::new(-7.0, -1.0, 2.0)));
    /// ```
    pub fn apply_linear<Y>(&self, elements: &Batch<Y>) -> Batch<Of<named::ApplyLinear, V, Y>>
    where
        Y: Element<Number = F> + Send + Sync,
        named::ApplyLinear: Everywhere<V, Y, F>,
    {
        let mut out = Batch::new();
        self.apply_linear_into(elements, &mut out);
        out
    }

    /// The versor applied to every element, as by [`LinearMap`](ga_core::LinearMap).
    ///
    /// The result goes to a batch that exists, which takes the length.
    pub fn apply_linear_into<Y>(
        &self,
        elements: &Batch<Y>,
        out: &mut Batch<Of<named::ApplyLinear, V, Y>>,
    ) where
        Y: Element<Number = F> + Send + Sync,
        named::ApplyLinear: Everywhere<V, Y, F>,
    {
        fill(*self, elements, &named::ApplyLinear, elements.len(), out);
    }

    /// The versor applied to every element, as by [`LinearMap`](ga_core::LinearMap).
    ///
    /// The result replaces the elements.
    pub fn apply_linear_in_place<Y>(&self, elements: &mut Batch<Y>)
    where
        Y: Element<Number = F> + Send + Sync,
        named::ApplyLinear: Everywhere<V, Y, F> + Values<V, Y, Output = Y>,
    {
        replace(*self, &named::ApplyLinear, elements);
    }
}
