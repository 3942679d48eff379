//! How an operation walks over slices: block by block of as many structs as there are lanes.

use ga_core::Element;

use super::elements::{Blocks, Elements, NumberOf};
use super::parts::{Part, Parts};
use super::transpose::{gathered, scatter};
use crate::dispatch::{On, Task};
use crate::lanes::Lanes;
use crate::operation::{Operation, Values};

/// `operation(a, b)` into a slice.
pub struct Fill<'t, A, B, O, Z> {
    pub a: A,
    pub b: B,
    pub operation: &'t O,
    pub out: &'t mut [Z],
}

impl<A, B, O, Z> Task for Fill<'_, A, B, O, Z> {
    type Output = ();
}

impl<A, B, O, L> On<L> for Fill<'_, A, B, O, O::Output>
where
    A: Elements,
    B: Elements<Element: Element<Number = NumberOf<A>>>,
    L: Lanes<NumberOf<A>>,
    O: Operation<A::Element, B::Element, L>
        + Values<A::Element, B::Element, Output: Element<Number = NumberOf<A>>>,
{
    #[inline(always)]
    fn run(self) {
        let (a, b) = (self.a.blocks::<L>(), self.b.blocks::<L>());
        let mut parts = Parts::<_, L>::of(self.out);
        for part in Part::BOTH {
            let blocks = parts.of_mut(part).chunks_exact_mut(L::COUNT);
            for (index, block) in blocks.enumerate() {
                let (x, y) = (a.read(part, index), b.read(part, index));
                scatter::<O::Output, L>(self.operation.call(O::left(x), y), block);
            }
        }
        parts.finish();
    }
}

/// `operation(a, b)` in the place of `b`.
pub struct Replace<'t, A, Y, O> {
    pub a: A,
    pub operation: &'t O,
    pub elements: &'t mut [Y],
}

impl<A, Y, O> Task for Replace<'_, A, Y, O> {
    type Output = ();
}

impl<A, Y, O, L> On<L> for Replace<'_, A, Y, O>
where
    A: Elements,
    Y: Element<Number = NumberOf<A>>,
    L: Lanes<NumberOf<A>>,
    O: Operation<A::Element, Y, L, Output = Y>,
{
    #[inline(always)]
    fn run(self) {
        let a = self.a.blocks::<L>();
        let mut parts = Parts::<_, L>::of(self.elements);
        for part in Part::BOTH {
            let blocks = parts.of_mut(part).chunks_exact_mut(L::COUNT);
            for (index, block) in blocks.enumerate() {
                let (x, y) = (a.read(part, index), gathered::<Y, L>(block));
                scatter::<Y, L>(self.operation.call(O::left(x), y), block);
            }
        }
        parts.finish();
    }
}
