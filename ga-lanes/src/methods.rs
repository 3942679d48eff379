//! The operations as methods of batches and of one element.

use core::marker::PhantomData;

use ga_core::{Element, Scalar};

use crate::batch::Batch;
use crate::number::Number;
use crate::operand::{One, Operand};
use crate::operation::fallible::{self, Attempt, AttemptEverywhere};
use crate::operation::{Everywhere, Map, Mapping, Values, ZipMap, Zipping, named};
use crate::partial::Partial;
use crate::target::Target;
use crate::task::{Fill, Part, Replace, Try, execute};

/// Two batches of different lengths were to be combined element by element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The length of the batch on the left.
    pub left: usize,
    /// The length of the batch on the right.
    pub right: usize,
}

impl core::fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "a batch of {} elements and one of {} cannot be combined element by element",
            self.left, self.right
        )
    }
}

impl core::error::Error for LengthMismatch {}

/// The values of an operation `O` on elements `X` and `Y`.
pub type Of<O, X, Y> = <O as Values<X, Y>>::Output;

/// What an element has next to it where an operation needs no second one.
const fn nothing<F: Scalar>() -> One<F> {
    One(F::ZERO)
}

/// Fills a batch, which takes the length, with the values of an operation.
fn fill<A, B, O, F>(
    a: A,
    b: B,
    operation: &O,
    len: usize,
    out: &mut Batch<Of<O, A::Element, B::Element>>,
) where
    F: Number,
    A: Operand<Element: Element<Number = F>>,
    B: Operand<Element: Element<Number = F>>,
    O: Everywhere<A::Element, B::Element, F>,
{
    out.resize(len);
    let columns = out.view_mut();
    execute::<F, _>(Fill {
        a,
        b,
        operation,
        part: Part { columns, start: 0 },
    });
}

/// Replaces the elements of a batch by the values of an operation.
fn replace<A, Y, O, F>(a: A, operation: &O, batch: &mut Batch<Y>)
where
    F: Number,
    A: Operand<Element: Element<Number = F>>,
    Y: Element<Number = F>,
    O: Everywhere<A::Element, Y, F> + Values<A::Element, Y, Output = Y>,
{
    let columns = batch.view_mut();
    let part = Part { columns, start: 0 };
    execute::<F, _>(Replace {
        a,
        operation,
        part,
        kind: PhantomData,
    });
}

/// The length that two operands have in common; that of the left one, a batch, where there is one
/// on the right.
fn common<X, B>(a: &Batch<X>, b: &B) -> Result<usize, LengthMismatch>
where
    X: Element<Number: Number>,
    B: Operand,
{
    match b.count() {
        Some(right) if right != a.len() => Err(LengthMismatch {
            left: a.len(),
            right,
        }),
        _ => Ok(a.len()),
    }
}

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
                Target::Portable.scope(|| {
                execute::<F, _>(Try { from: self, operation, part, exists: &mut exists });
                });
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

/// Exponentials, whose algorithms are too long to be inlined into the function of a target: they
/// run in the portable lanes, as logarithms and roots do.
impl<X, F> Batch<X>
where
    F: Number,
    X: Element<Number = F> + Send + Sync,
{
    /// The exponentials.
    pub fn exp(&self) -> Batch<Of<named::Exponential, F, X>>
    where
        named::Exponential: Everywhere<F, X, F>,
    {
        let mut out = Batch::new();
        Target::Portable.scope(|| {
            let operation = &named::Exponential;
            fill(nothing::<F>(), self, operation, self.len(), &mut out);
        });
        out
    }
}

/// Functions of one's own.
impl<X, F> Batch<X>
where
    F: Number,
    X: Element<Number = F> + Send + Sync,
{
    /// A function of every element.
    ///
    /// ```
    /// use ga_lanes::{Batch, Lanes, Map};
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    /// use r3::Vector;
    ///
    /// /// The mirror image in the plane through the origin and across a vector, moved by it.
    /// struct Glide(Vector<f32>);
    ///
    /// impl Map<Vector<f32>> for Glide {
    ///     type Output = Vector<f32>;
    ///
    ///     #[inline(always)]
    ///     fn call<L: Lanes<f32>>(&self, x: Vector<L>) -> Vector<L> {
    ///         let normal = self.0.map(L::splat);
    ///         normal.apply(x) + normal
    ///     }
    /// }
    ///
    /// let batch = Batch::from_slice(&[Vector::new(1.0_f32, 2.0, 0.0); 5]);
    /// let images = batch.map(&Glide(Vector::new(2.0, 0.0, 0.0)));
    /// assert_eq!(images.get(4), Some(Vector::new(1.0, 2.0, 0.0)));
    /// ```
    pub fn map<K: Map<X>>(&self, function: &K) -> Batch<K::Output> {
        let mut out = Batch::new();
        self.map_into(function, &mut out);
        out
    }

    /// A function of every element, to a batch that exists, which takes the length.
    pub fn map_into<K: Map<X>>(&self, function: &K, out: &mut Batch<K::Output>) {
        fill(nothing::<F>(), self, &Mapping(function), self.len(), out);
    }

    /// Replaces every element by the value of a function.
    pub fn map_in_place<K: Map<X, Output = X>>(&mut self, function: &K) {
        replace(nothing::<F>(), &Mapping(function), self);
    }

    /// A function of the elements at the same place of two batches.
    ///
    /// ```
    /// use ga_lanes::{Batch, Lanes, ZipMap};
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    /// use r3::Vector;
    ///
    /// /// The squared distance of two positions.
    /// struct SquaredDistance;
    ///
    /// impl ZipMap<Vector<f64>, Vector<f64>> for SquaredDistance {
    ///     type Output = f64;
    ///
    ///     #[inline(always)]
    ///     fn call<L: Lanes<f64>>(&self, x: Vector<L>, y: Vector<L>) -> L {
    ///         (x - y).norm_squared()
    ///     }
    /// }
    ///
    /// let a: Batch<_> = (0..9).map(|n| Vector::new(n as f64, 0.0, 0.0)).collect();
    /// let b: Batch<_> = (0..9).map(|n| Vector::new(0.0, n as f64, 0.0)).collect();
    /// assert_eq!(a.zip_map(&b, &SquaredDistance)?.get(8), Some(128.0));
    /// # Ok::<(), ga_lanes::LengthMismatch>(())
    /// ```
    ///
    /// # Errors
    /// [`LengthMismatch`] where the other batch has another length.
    pub fn zip_map<B, K>(&self, b: B, function: &K) -> Result<Batch<K::Output>, LengthMismatch>
    where
        B: Operand<Element: Element<Number = F>>,
        K: ZipMap<X, B::Element>,
    {
        let mut out = Batch::new();
        self.zip_map_into(b, function, &mut out)?;
        Ok(out)
    }

    /// A function of the elements at the same place of two batches, to a batch that exists, which
    /// takes the length.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the other batch has another length.
    pub fn zip_map_into<B, K>(
        &self,
        b: B,
        function: &K,
        out: &mut Batch<K::Output>,
    ) -> Result<(), LengthMismatch>
    where
        B: Operand<Element: Element<Number = F>>,
        K: ZipMap<X, B::Element>,
    {
        let len = common(self, &b)?;
        fill(self, b, &Zipping(function), len, out);
        Ok(())
    }
}
