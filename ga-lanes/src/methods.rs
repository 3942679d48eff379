//! The operations as methods of batches and of one element.

mod application;
mod binary;
mod functions;
mod unary;

use core::marker::PhantomData;

use ga_core::{Element, LengthMismatch, Scalar};

use crate::batch::Batch;
use crate::number::Number;
use crate::operand::{One, Operand};
use crate::operation::{Everywhere, Values};
use crate::target::Target;
use crate::task::{Fill, Part, Replace, execute};

/// The values of an operation `O` on elements `X` and `Y`.
pub type Of<O, X, Y> = <O as Values<X, Y>>::Output;

/// What an element has next to it where an operation needs no second one.
const fn nothing<F: Scalar>() -> One<F> {
    One(F::ZERO)
}

/// Calls a function on the current target; a long computation on the portable one, because in the
/// wider lanes what is not inlined calls a function for every operation.
fn in_lanes(long: bool, function: impl FnOnce()) {
    // The portable target is on every machine.
    match long {
        true => Target::Portable.scope(function).unwrap_or_default(),
        false => function(),
    }
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
    let task = Fill {
        a,
        b,
        operation,
        part: Part { columns, start: 0 },
    };
    in_lanes(O::LONG, || execute::<F, _>(task));
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
