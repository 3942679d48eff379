//! Many elements of one type, coefficient by coefficient.

mod collect;
mod columns;

use core::fmt;
use core::marker::PhantomData;

use ga_core::{Element, Scalar};

use crate::number::Number;
use columns::Line;
pub(crate) use columns::{ColumnsMut, View};

/// Elements of one type stored coefficient by coefficient: all first coefficients, then all
/// second ones, so that lanes load what belongs together.
///
/// Operations of two batches act on elements at the same place, operations of a batch and
/// [`One`](crate::One) element on that and every element. Those that may fail for single elements
/// give a [`Partial`](crate::Partial) batch.
///
/// ```
/// use ga_lanes::{Batch, One};
/// # ga_macros::define_algebra! { crate = ga_core; R3 }
/// use r3::{Bivector, Vector};
///
/// let vectors: Batch<Vector<f32>> =
///     (0..100).map(|n| Vector::new(n as f32, 1.0, 0.0)).collect();
/// let quarter = (Bivector::new(1.0_f32, 0.0, 0.0) * -std::f32::consts::FRAC_PI_4).exp();
/// let turned = One(quarter).apply(&vectors);
/// assert!((turned.get(7).unwrap() - Vector::new(-1.0, 7.0, 0.0)).norm() < 1e-5);
/// ```
#[derive(Clone)]
pub struct Batch<X: Element<Number: Number>> {
    /// One column after the other, each `stride` lines long; of odd stride, because columns that
    /// begin a power of two apart would contend for the same places of the cache.
    lines: Vec<Line<X::Number>>,
    stride: usize,
    len: usize,
    kind: PhantomData<fn() -> X>,
}

impl<X: Element<Number: Number>> Batch<X> {
    /// How many columns there are: the stored coefficients of the type.
    const COLUMNS: usize = X::BLADES.len();

    /// No elements.
    pub const fn new() -> Self {
        Batch {
            lines: Vec::new(),
            stride: 0,
            len: 0,
            kind: PhantomData,
        }
    }

    /// No elements, with place for some.
    pub fn with_capacity(capacity: usize) -> Self {
        let mut batch = Batch::new();
        batch.reserve(capacity);
        batch
    }

    /// As many elements, all coefficients 0.
    pub fn zeros(len: usize) -> Self {
        let mut batch = Batch::with_capacity(len);
        batch.len = len;
        batch
    }

    /// The elements of a slice.
    pub fn from_slice(elements: &[X]) -> Self {
        let mut batch = Batch::zeros(elements.len());
        for (position, column) in batch.columns_mut().enumerate() {
            for (value, element) in column.iter_mut().zip(elements) {
                *value = element.at(position);
            }
        }
        batch
    }

    /// The elements in a vector.
    pub fn to_vec(&self) -> Vec<X> {
        self.iter().collect()
    }

    /// How many elements there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The element at an index; `None` beyond the last.
    pub fn get(&self, index: usize) -> Option<X> {
        let numbers = self.numbers();
        let stride = self.stride * X::Number::LINE;
        (index < self.len).then(|| X::from_fn(|position| numbers[position * stride + index]))
    }

    /// Replaces the element at an index and gives the former one; `None`, without a change,
    /// beyond the last.
    pub fn replace(&mut self, index: usize, element: X) -> Option<X> {
        let former = self.get(index)?;
        for (position, column) in self.columns_mut().enumerate() {
            column[index] = element.at(position);
        }
        Some(former)
    }

    /// Adds an element at the end.
    pub fn push(&mut self, element: X) {
        self.reserve(1);
        self.len += 1;
        let index = self.len - 1;
        for (position, column) in self.columns_mut().enumerate() {
            column[index] = element.at(position);
        }
    }

    /// Makes place for more elements.
    pub fn reserve(&mut self, additional: usize) {
        let needed = (self.len + additional).div_ceil(X::Number::LINE);
        if needed <= self.stride {
            return;
        }
        let stride = needed.max(2 * self.stride) | 1;
        let mut lines = vec![Line::ZERO; Self::COLUMNS * stride];
        if self.stride > 0 {
            let former = self.lines.chunks_exact(self.stride);
            for (column, former) in lines.chunks_exact_mut(stride).zip(former) {
                column[..self.stride].copy_from_slice(former);
            }
        }
        self.lines = lines;
        self.stride = stride;
    }

    /// Removes all elements and keeps their place.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Shortens to a length, or lengthens by elements whose coefficients are all 0.
    pub fn resize(&mut self, len: usize) {
        self.reserve(len.saturating_sub(self.len));
        let former = self.len;
        self.len = len;
        if former < len {
            for column in self.columns_mut() {
                column[former..].fill(X::Number::ZERO);
            }
        }
    }

    /// All coefficients of one field, the position as in [`Element::BLADES`]; `None` beyond.
    ///
    /// ```
    /// use ga_lanes::Batch;
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    ///
    /// let vectors = Batch::from_slice(&[r3::Vector::new(1.0, 2.0, 3.0), r3::Vector::new(4.0, 5.0, 6.0)]);
    /// assert_eq!(vectors.column(1), Some([2.0, 5.0].as_slice()));
    /// ```
    pub fn column(&self, position: usize) -> Option<&[X::Number]> {
        self.columns().nth(position)
    }

    /// All coefficients of one field, to be written.
    pub fn column_mut(&mut self, position: usize) -> Option<&mut [X::Number]> {
        self.columns_mut().nth(position)
    }

    /// The columns in the order of the fields, all of the batch's length.
    pub fn columns(&self) -> impl ExactSizeIterator<Item = &[X::Number]> {
        let (stride, len) = (self.stride * X::Number::LINE, self.len);
        let numbers = self.numbers();
        (0..Self::COLUMNS).map(move |position| &numbers[position * stride..][..len])
    }

    /// The columns in the order of the fields, to be written.
    pub fn columns_mut(&mut self) -> impl ExactSizeIterator<Item = &mut [X::Number]> {
        let (stride, len) = (self.stride * X::Number::LINE, self.len);
        let mut rest = columns::numbers_mut(&mut self.lines);
        (0..Self::COLUMNS).map(move |_| {
            let (column, behind) = core::mem::take(&mut rest).split_at_mut(stride);
            rest = behind;
            &mut column[..len]
        })
    }

    /// The elements one after the other.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = X> {
        let numbers = self.numbers();
        let stride = self.stride * X::Number::LINE;
        (0..self.len).map(move |index| X::from_fn(|position| numbers[position * stride + index]))
    }

    fn numbers(&self) -> &[X::Number] {
        columns::numbers(&self.lines)
    }

    /// The columns for lanes, up to whole lines.
    pub(crate) fn view(&self) -> View<'_, X::Number> {
        View {
            numbers: self.numbers(),
            stride: self.stride * X::Number::LINE,
        }
    }

    /// The columns for lanes, up to whole lines, to be written.
    pub(crate) fn view_mut(&mut self) -> ColumnsMut<'_, X::Number> {
        let stride = self.stride * X::Number::LINE;
        let whole = self.len.next_multiple_of(X::Number::LINE);
        ColumnsMut::new(columns::numbers_mut(&mut self.lines), stride, whole)
    }
}

impl<X: Element<Number: Number>> Default for Batch<X> {
    fn default() -> Self {
        Batch::new()
    }
}

impl<X: Element<Number: Number>> PartialEq for Batch<X> {
    fn eq(&self, other: &Self) -> bool {
        self.len == other.len && self.columns().eq(other.columns())
    }
}

impl<X: Element<Number: Number> + fmt::Debug> fmt::Debug for Batch<X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
