//! How an operation walks over batches: line by line, on several threads where that pays.

use core::marker::PhantomData;

use ga_core::{Computation, Element, Scalar};

use crate::batch::{Batch, ColumnsMut};
use crate::dispatch::{On, OnEveryTarget, Task, run};
use crate::lanes::Lanes;
use crate::number::Number;
use crate::operand::{NumberOf, Operand, Reader};
use crate::operation::fallible::{Attempt, AttemptIn};
use crate::operation::{Operation, Values};
use crate::target::Found;

/// The columns that a task writes, which begin at `start` of the operands.
pub(crate) struct Part<'t, F> {
    pub(crate) columns: ColumnsMut<'t, F>,
    pub(crate) start: usize,
}

/// Stores the coefficients of an element in the columns at an index.
///
/// # Safety
/// The index is less than the number of arrays that the columns have for this type.
#[inline(always)]
unsafe fn write<Z: Element, L: Lanes<Z::Number>>(
    value: Z::Over<L>,
    columns: &mut ColumnsMut<'_, Z::Number>,
    index: usize,
) where
    Z::Number: Number,
{
    for position in 0..Z::BLADES.len() {
        // SAFETY: there are arrays for this type, so that it has no more coefficients than there
        // are columns; the caller promises the rest.
        value
            .at(position)
            .store(unsafe { columns.array::<L>(position, index) });
    }
}

/// `operation(a, b)` into the columns of a third batch.
pub(crate) struct Fill<'t, A: Operand, B, O> {
    pub(crate) a: A,
    pub(crate) b: B,
    pub(crate) operation: &'t O,
    pub(crate) part: Part<'t, NumberOf<A>>,
}

impl<A: Operand, B, O> Task for Fill<'_, A, B, O> {
    type Output = ();
}

impl<A, B, O, L> On<L> for Fill<'_, A, B, O>
where
    A: Operand,
    B: Operand<Element: Element<Number = NumberOf<A>>>,
    L: Lanes<NumberOf<A>>,
    O: Operation<A::Element, B::Element, L>
        + Values<A::Element, B::Element, Output: Element<Number = NumberOf<A>>>,
{
    #[inline(always)]
    fn run(self) {
        let Part { mut columns, start } = self.part;
        let first = start / L::COUNT;
        let (a, b) = (self.a.reader::<L>(), self.b.reader::<L>());
        let count = columns.arrays::<O::Output, L>();
        let readable = a.count().min(b.count()).saturating_sub(first);
        // A call of `map` would not be inlined.
        let mut constant = None;
        if let Some(x) = a.constant() {
            constant = Some(O::left(x));
        }
        for index in 0..count.min(readable) {
            let x = match constant {
                Some(x) => x,
                // SAFETY: `first + index` is less than the count.
                None => O::left(unsafe { a.read(first + index) }),
            };
            // SAFETY: `first + index` is less than the count.
            let y = unsafe { b.read(first + index) };
            let value = self.operation.call(x, y);
            // SAFETY: the index is less than the number of arrays for this type.
            unsafe { write::<O::Output, L>(value, &mut columns, index) };
        }
    }
}

/// `operation(a, b)` in the place of `b`, whose columns these are.
pub(crate) struct Replace<'t, A: Operand, Y, O> {
    pub(crate) a: A,
    pub(crate) operation: &'t O,
    pub(crate) part: Part<'t, NumberOf<A>>,
    pub(crate) kind: PhantomData<fn() -> Y>,
}

impl<A: Operand, Y, O> Task for Replace<'_, A, Y, O> {
    type Output = ();
}

impl<A, Y, O, L> On<L> for Replace<'_, A, Y, O>
where
    A: Operand,
    Y: Element<Number = NumberOf<A>>,
    L: Lanes<NumberOf<A>>,
    O: Operation<A::Element, Y, L, Output = Y>,
{
    #[inline(always)]
    fn run(self) {
        let Part { mut columns, start } = self.part;
        let first = start / L::COUNT;
        let a = self.a.reader::<L>();
        let count = columns.arrays::<Y, L>();
        let readable = a.count().saturating_sub(first);
        // A call of `map` would not be inlined.
        let mut constant = None;
        if let Some(x) = a.constant() {
            constant = Some(O::left(x));
        }
        for index in 0..count.min(readable) {
            let x = match constant {
                Some(x) => x,
                // SAFETY: `first + index` is less than the count.
                None => O::left(unsafe { a.read(first + index) }),
            };
            let y = Y::Over::<L>::from_fn(|position| {
                if position >= Y::BLADES.len() {
                    return L::ZERO;
                }
                // SAFETY: there are arrays for this type, so that it has no more coefficients than
                // there are columns, and the index is less than their number.
                L::load(unsafe { columns.array::<L>(position, index) })
            });
            let value = self.operation.call(x, y);
            // SAFETY: the index is less than the number of arrays for this type.
            unsafe { write::<Y, L>(value, &mut columns, index) };
        }
    }
}

/// An operation that some elements have no value of, into the columns of another batch and a
/// list of which exist. Where one of the lanes has no value, each is asked alone.
pub(crate) struct Try<'t, X: Element<Number: Number>, O> {
    pub(crate) from: &'t Batch<X>,
    pub(crate) operation: &'t O,
    pub(crate) part: Part<'t, X::Number>,
    pub(crate) exists: &'t mut [bool],
}

impl<X: Element<Number: Number>, O> Task for Try<'_, X, O> {
    type Output = ();
}

impl<X, O, L> On<L> for Try<'_, X, O>
where
    X: Element<Number: Number> + Send + Sync,
    L: Lanes<X::Number>,
    O: AttemptIn<X, L> + Attempt<X, Output: Element<Number = X::Number>>,
{
    #[inline(always)]
    fn run(self) {
        let Part { mut columns, start } = self.part;
        let from = self.from.reader::<L>();
        let count = columns.arrays::<O::Output, L>();
        let readable = from.count().saturating_sub(start / L::COUNT);
        let exists = self.exists.chunks_mut(L::COUNT).enumerate();
        for (index, exists) in exists.take(count.min(readable)) {
            // SAFETY: the index from the start on is less than the count.
            let x = unsafe { from.read(start / L::COUNT + index) };
            if let Some(value) = self.operation.call(x) {
                // SAFETY: the index is less than the number of arrays for this type.
                unsafe { write::<O::Output, L>(value, &mut columns, index) };
                exists.fill(true);
                continue;
            }
            for (lane, exists) in exists.iter_mut().enumerate() {
                let element = self.from.get(start + index * L::COUNT + lane);
                let value = element.and_then(|element| {
                    L::outlined(Alone {
                        element,
                        operation: self.operation,
                        lanes: PhantomData::<L>,
                    })
                });
                *exists = value.is_some();
                for position in 0..O::Output::BLADES.len() {
                    let mut values = L::array(|_| X::Number::ZERO);
                    if let Some(value) = &value {
                        value.at(position).store(&mut values);
                    }
                    // SAFETY: there are arrays for this type, so that it has no more coefficients
                    // than there are columns, and the index is less than their number.
                    let array = unsafe { columns.array::<L>(position, index) };
                    array.as_mut()[lane] = values.as_ref()[lane];
                }
            }
        }
    }
}

/// One element in all lanes, where a neighbour has no value: its own is rounded as beside others.
struct Alone<'t, X, O, L> {
    element: X,
    operation: &'t O,
    lanes: PhantomData<L>,
}

impl<X, O, L> Computation for Alone<'_, X, O, L>
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
    O: AttemptIn<X, L>,
{
    type Output = Option<<O::Output as Element>::Over<L>>;

    #[inline(always)]
    fn run(self) -> Self::Output {
        let element = self.element;
        let x =
            X::Over::<L>::from_fn(|position| <L as Lanes<X::Number>>::splat(element.at(position)));
        self.operation.call(x)
    }
}

/// Runs a task on the current target.
#[cfg(not(feature = "rayon"))]
pub(crate) fn execute<F: Number, T: Split<F> + OnEveryTarget<F, Output = ()>>(task: T) {
    run::<F, T>(Found::current(), task);
}

/// Runs a task on the current target, on several threads where it is long.
#[cfg(feature = "rayon")]
pub(crate) fn execute<F: Number, T: Split<F> + OnEveryTarget<F, Output = ()>>(task: T) {
    fn halves<F: Number, T: Split<F> + OnEveryTarget<F, Output = ()>>(target: Found, task: T) {
        let len = task.len();
        if len < 2 * SHARE {
            return run::<F, T>(target, task);
        }
        let (low, high) = task.split_at((len / 2).next_multiple_of(F::LINE));
        rayon::join(|| halves(target, low), || halves(target, high));
    }
    halves(Found::current(), task);
}

/// The least number of elements for which another thread is asked.
#[cfg(feature = "rayon")]
const SHARE: usize = 4096;

/// A task that two threads can share.
pub(crate) trait Split<F: Number>: Send + Sized {
    /// How many numbers a column has.
    #[cfg(feature = "rayon")]
    fn len(&self) -> usize;
    /// The task for the first numbers of the columns, and that for the others.
    #[cfg(feature = "rayon")]
    fn split_at(self, middle: usize) -> (Self, Self);
}

#[cfg(feature = "rayon")]
impl<'t, F: Number> Part<'t, F> {
    /// The first numbers of the columns, and the others.
    fn split_at(self, middle: usize) -> (Part<'t, F>, Part<'t, F>) {
        let (low, high) = self.columns.split_at(middle);
        let part = |columns, start| Part { columns, start };
        (part(low, self.start), part(high, self.start + middle))
    }
}

impl<A, B, O> Split<NumberOf<A>> for Fill<'_, A, B, O>
where
    A: Operand,
    B: Operand,
    O: Sync,
{
    #[cfg(feature = "rayon")]
    fn len(&self) -> usize {
        self.part.columns.len()
    }

    #[cfg(feature = "rayon")]
    fn split_at(self, middle: usize) -> (Self, Self) {
        let (low, high) = self.part.split_at(middle);
        let half = |part| Fill { part, ..self };
        (half(low), half(high))
    }
}

impl<A, Y, O> Split<NumberOf<A>> for Replace<'_, A, Y, O>
where
    A: Operand,
    O: Sync,
{
    #[cfg(feature = "rayon")]
    fn len(&self) -> usize {
        self.part.columns.len()
    }

    #[cfg(feature = "rayon")]
    fn split_at(self, middle: usize) -> (Self, Self) {
        let (low, high) = self.part.split_at(middle);
        let half = |part| Replace { part, ..self };
        (half(low), half(high))
    }
}

impl<X, O> Split<X::Number> for Try<'_, X, O>
where
    X: Element<Number: Number>,
    O: Sync,
{
    #[cfg(feature = "rayon")]
    fn len(&self) -> usize {
        self.part.columns.len()
    }

    #[cfg(feature = "rayon")]
    fn split_at(self, middle: usize) -> (Self, Self) {
        let Try {
            from,
            operation,
            part,
            exists,
        } = self;
        let (low, high) = part.split_at(middle);
        let (exists_low, exists_high) = exists.split_at_mut(middle.min(exists.len()));
        let half = |part, exists| Try {
            from,
            operation,
            part,
            exists,
        };
        (half(low, exists_low), half(high, exists_high))
    }
}
