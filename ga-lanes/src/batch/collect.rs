//! Batches from iterators and back.

use ga_core::Element;

use super::Batch;
use crate::number::Number;

impl<X: Element<Number: Number>> Extend<X> for Batch<X> {
    fn extend<I: IntoIterator<Item = X>>(&mut self, elements: I) {
        let elements = elements.into_iter();
        self.reserve(elements.size_hint().0);
        elements.for_each(|element| self.push(element));
    }
}

impl<'a, X: Element<Number: Number>> Extend<&'a X> for Batch<X> {
    fn extend<I: IntoIterator<Item = &'a X>>(&mut self, elements: I) {
        self.extend(elements.into_iter().copied());
    }
}

impl<X: Element<Number: Number>> FromIterator<X> for Batch<X> {
    fn from_iter<I: IntoIterator<Item = X>>(elements: I) -> Self {
        let mut batch = Batch::new();
        batch.extend(elements);
        batch
    }
}

impl<X: Element<Number: Number>> From<&[X]> for Batch<X> {
    fn from(elements: &[X]) -> Self {
        Batch::from_slice(elements)
    }
}

impl<X: Element<Number: Number>> From<Batch<X>> for Vec<X> {
    fn from(batch: Batch<X>) -> Self {
        batch.to_vec()
    }
}
