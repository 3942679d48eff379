//! Operations of two operands, of which one at least is a batch.

use ga_core::{Element, LengthMismatch};

use super::{Of, common, fill, replace};
use crate::batch::Batch;
use crate::number::Number;
use crate::operand::{One, Operand};
use crate::operation::{Everywhere, Values, named};

macro_rules! binary {
    ($($(#[$doc:meta])* $name:ident $method:ident $into:ident $in_place:ident)*) => {
        /// Operations with another batch of the same length, or with [`One`] element.
        ///
        /// `_into` writes to a batch that exists and spares the allocation; `_in_place` replaces
        /// the right operand.
        impl<X, F> Batch<X>
        where
            F: Number,
            X: Element<Number = F> + Send + Sync,
        {$(
            $(#[$doc])*
            ///
            /// # Errors
            /// [`LengthMismatch`] where the other batch has another length.
            pub fn $method<B>(&self, b: B) -> Result<Batch<Of<named::$name, X, B::Element>>, LengthMismatch>
            where
                B: Operand<Element: Element<Number = F>>,
                named::$name: Everywhere<X, B::Element, F>,
            {
                let mut out = Batch::new();
                self.$into(b, &mut out)?;
                Ok(out)
            }

            $(#[$doc])*
            ///
            /// The result goes to a batch that exists, which takes the length.
            ///
            /// # Errors
            /// [`LengthMismatch`] where the other batch has another length.
            pub fn $into<B>(&self, b: B, out: &mut Batch<Of<named::$name, X, B::Element>>) -> Result<(), LengthMismatch>
            where
                B: Operand<Element: Element<Number = F>>,
                named::$name: Everywhere<X, B::Element, F>,
            {
                let len = common(self, &b)?;
                fill(self, b, &named::$name, len, out);
                Ok(())
            }

            $(#[$doc])*
            ///
            /// The result replaces `b`.
            ///
            /// # Errors
            /// [`LengthMismatch`] where the other batch has another length.
            pub fn $in_place<Y>(&self, b: &mut Batch<Y>) -> Result<(), LengthMismatch>
            where
                Y: Element<Number = F> + Send + Sync,
                named::$name: Everywhere<X, Y, F> + Values<X, Y, Output = Y>,
            {
                common(self, &&*b)?;
                replace(self, &named::$name, b);
                Ok(())
            }
        )*}

        /// Operations with every element of a batch.
        ///
        /// `_into` writes to a batch that exists and spares the allocation; `_in_place` replaces
        /// the right operand.
        impl<X, F> One<X>
        where
            F: Number,
            X: Element<Number = F> + Send + Sync,
        {$(
            $(#[$doc])*
            pub fn $method<Y>(&self, b: &Batch<Y>) -> Batch<Of<named::$name, X, Y>>
            where
                Y: Element<Number = F> + Send + Sync,
                named::$name: Everywhere<X, Y, F>,
            {
                let mut out = Batch::new();
                self.$into(b, &mut out);
                out
            }

            $(#[$doc])*
            ///
            /// The result goes to a batch that exists, which takes the length.
            pub fn $into<Y>(&self, b: &Batch<Y>, out: &mut Batch<Of<named::$name, X, Y>>)
            where
                Y: Element<Number = F> + Send + Sync,
                named::$name: Everywhere<X, Y, F>,
            {
                fill(*self, b, &named::$name, b.len(), out);
            }

            $(#[$doc])*
            ///
            /// The result replaces `b`.
            pub fn $in_place<Y>(&self, b: &mut Batch<Y>)
            where
                Y: Element<Number = F> + Send + Sync,
                named::$name: Everywhere<X, Y, F> + Values<X, Y, Output = Y>,
            {
                replace(*self, &named::$name, b);
            }
        )*}
    };
}

binary! {
    /// The geometric product `a b`; also the product with numbers.
    Geometric geometric geometric_into geometric_in_place
    /// The outer product `a ∧ b`.
    Wedge wedge wedge_into wedge_in_place
    /// The left contraction `a ⌋ b`.
    LeftContract left_contract left_contract_into left_contract_in_place
    /// The right contraction `a ⌊ b`.
    RightContract right_contract right_contract_into right_contract_in_place
    /// The inner product `a · b` of (2.71).
    Inner inner inner_into inner_in_place
    /// The scalar product `⟨a b⟩`.
    ScalarProduct scalar_product scalar_product_into scalar_product_in_place
    /// The regressive product `a ∨ b`.
    Regressive regressive regressive_into regressive_in_place
    /// The commutator product `(ab − ba)/2`.
    Commutator commutator commutator_into commutator_in_place
    /// The anticommutator product `(ab + ba)/2`.
    Anticommutator anticommutator anticommutator_into anticommutator_in_place
    /// The quotient `a b⁻¹`; non-finite where `b` has no inverse. Also that by numbers.
    Quotient quotient quotient_into quotient_in_place
    /// The sandwich `V x̂ Ṽ` with this as `V`.
    Sandwich sandwich sandwich_into sandwich_in_place
    /// The versors applied, `V x̂ V⁻¹` (2.28).
    Apply apply apply_into apply_in_place
    /// The sum `a + b`.
    Plus plus plus_into plus_in_place
    /// The difference `a − b`.
    Minus minus minus_into minus_in_place
}
