//! Values of which some do not exist.

use ga_core::Element;

use crate::batch::Batch;
use crate::number::Number;

/// The values of an operation that some elements have none of: an `Option` for each.
#[derive(Clone, Debug, PartialEq)]
pub struct Partial<X: Element<Number: Number>> {
    values: Batch<X>,
    exists: Vec<bool>,
}

impl<X: Element<Number: Number>> Partial<X> {
    /// The values, each valid where it exists.
    pub(crate) fn new(values: Batch<X>, exists: Vec<bool>) -> Self {
        Partial { values, exists }
    }

    /// How many elements were asked.
    pub fn len(&self) -> usize {
        self.exists.len()
    }

    /// Whether none was asked.
    pub fn is_empty(&self) -> bool {
        self.exists.is_empty()
    }

    /// The value of the element at an index; `None` where there is none, and beyond the last.
    pub fn get(&self, index: usize) -> Option<X> {
        self.exists
            .get(index)
            .and_then(|exists| exists.then(|| self.values.get(index)))
            .flatten()
    }

    /// The values one after the other.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Option<X>> {
        let values = self.exists.iter().zip(self.values.iter());
        values.map(|(exists, value)| exists.then_some(value))
    }

    /// Which values exist.
    pub fn exists(&self) -> &[bool] {
        &self.exists
    }

    /// All values, if every element has one.
    ///
    /// # Errors
    /// The index of the first element without a value.
    pub fn all(self) -> Result<Batch<X>, usize> {
        match self.exists.iter().position(|exists| !exists) {
            Some(missing) => Err(missing),
            None => Ok(self.values),
        }
    }

    /// The values, and zeros in all coefficients where there is none.
    pub fn or_zeros(self) -> Batch<X> {
        self.values
    }
}
