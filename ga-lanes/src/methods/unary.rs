//! Operations on every element of a batch, those that some elements have no value of among them.

use ga_core::Element;

use super::{Of, fill, in_lanes, nothing};
use crate::batch::Batch;
use crate::number::Number;
use crate::operation::fallible::{self, Attempt, AttemptEverywhere};
use crate::operation::{Everywhere, named};
use crate::partial::Partial;
use crate::task::{Part, Try, execute};

macro_rules! unary {
    ($($(#[$doc:meta])* $name:ident $method:ident)*) => {
        /// Operations on every element.
        impl<X, F> Batch<X>
        where
            F: Number,
            X: Element<Number = F> + Send + Sync,
        {$(
            $(#[$doc])*
            pub fn $method(&self) -> Batch<Of<named::$name, F, X>>
            where
                named::$name: Everywhere<F, X, F>,
            {
                let mut out = Batch::new();
                fill(nothing::<F>(), self, &named::$name, self.len(), &mut out);
                out
            }
        )*}
    };
}

unary! {
    /// The reverses.
    Reverse reverse
    /// The grade involutions.
    Involute involute
    /// The Clifford conjugates.
    Conjugate conjugate
    /// The duals `A I⁻¹`.
    Dual dual
    /// The inverses of the dual, `A I`.
    Undual undual
    /// The left complements.
    LeftComplement left_complement
    /// The right complements.
    RightComplement right_complement
    /// The squared norms `⟨X X̃⟩` with their signs.
    NormSquared norm_squared
    /// The norms `√|⟨X X̃⟩|`.
    Norm norm
    /// The negatives.
    Opposite opposite
    /// The exponentials.
    Exponential exp
}

macro_rules! attempts {
    ($($(#[$doc:meta])* $name:ident $method:ident)*) => {
        /// Operations that some elements have no value of.
        impl<X, F> Batch<X>
        where
            F: Number,
            X: Element<Number = F> + Send + Sync,
        {$(
            $(#[$doc])*
            pub fn $method(&self) -> Partial<<fallible::$name as Attempt<X>>::Output>
            where
                fallible::$name: AttemptEverywhere<X, F>,
            {
                let mut values = Batch::zeros(self.len());
                let mut exists = vec![false; self.len()];
                let (operation, columns) = (&fallible::$name, values.view_mut());
                let part = Part { columns, start: 0 };
                let task = Try { from: self, operation, part, exists: &mut exists };
                in_lanes(<fallible::$name as Attempt<X>>::LONG, || execute::<F, _>(task));
                Partial::new(values, exists)
            }
        )*}
    };
}

attempts! {
    /// The multiplicative inverses.
    Inverse inverse
    /// The elements over their norms; none where the norm is zero or not finite.
    Normalized normalized
    /// The principal logarithms; none where no real one exists or it is not unique.
    Logarithm log
    /// The principal square roots; none where no real one exists or it is not unique.
    SquareRoot sqrt
    /// The unit versors `(X X̃)^(−1/2) X`, without the drift of rounding.
    Renormalize renormalized
}
