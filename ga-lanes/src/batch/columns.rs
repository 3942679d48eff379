//! Columns stand in whole lines of the cache.

use core::marker::PhantomData;
use core::ptr::NonNull;

use ga_core::Element;

use crate::lanes::Lanes;
use crate::number::Number;

/// As many numbers as a line of the cache holds, at its beginning, so that no lanes straddle two.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(crate) struct Line<F: Number>(F::Line);

impl<F: Number> Line<F> {
    /// Zeros.
    pub(crate) const ZERO: Self = Line(F::ZERO_LINE);
    /// A line has no padding, and its alignment is that of 64 bytes.
    const SOLID: () = assert!(size_of::<Self>() == F::LINE * size_of::<F>());
}

/// The numbers of some lines.
pub(crate) fn numbers<F: Number>(lines: &[Line<F>]) -> &[F] {
    let () = Line::<F>::SOLID;
    let count = lines.len() * F::LINE;
    // SAFETY: a line is `LINE` numbers without padding, as the assertion proves, and numbers
    // need less alignment.
    unsafe { core::slice::from_raw_parts(lines.as_ptr().cast(), count) }
}

/// The numbers of some lines, to be written.
pub(crate) fn numbers_mut<F: Number>(lines: &mut [Line<F>]) -> &mut [F] {
    let () = Line::<F>::SOLID;
    let count = lines.len() * F::LINE;
    // SAFETY: as above, and any numbers make a line.
    unsafe { core::slice::from_raw_parts_mut(lines.as_mut_ptr().cast(), count) }
}

/// Columns of the same length that begin `stride` numbers apart, to be written.
///
/// A slice for each would be a list of slices, which short batches would wait for.
pub(crate) struct ColumnsMut<'a, F> {
    first: NonNull<F>,
    /// How many columns there are.
    count: usize,
    stride: usize,
    /// The length of every column, at most the stride; without a column zero.
    len: usize,
    numbers: PhantomData<&'a mut [F]>,
}

// SAFETY: these are numbers that nobody else has access to, as in a mutable slice.
unsafe impl<F: Send> Send for ColumnsMut<'_, F> {}

impl<'a, F: Number> ColumnsMut<'a, F> {
    /// The first `len` numbers of every `stride`.
    pub(crate) fn new(numbers: &'a mut [F], stride: usize, len: usize) -> Self {
        let count = numbers.len().checked_div(stride).unwrap_or(0);
        ColumnsMut {
            first: NonNull::from(numbers).cast(),
            count,
            stride,
            len: if count == 0 { 0 } else { len.min(stride) },
            numbers: PhantomData,
        }
    }

    /// How many arrays of lanes each column has, if there are as many columns as the type has
    /// coefficients; otherwise none.
    #[inline(always)]
    pub(crate) fn arrays<Z: Element<Number = F>, L: Lanes<F>>(&self) -> usize {
        match Z::BLADES.len() <= self.count {
            true => self.len / L::COUNT,
            false => 0,
        }
    }

    /// The numbers of a column for lanes.
    ///
    /// # Safety
    /// There are more columns than the position, and the index is less than the number of arrays.
    #[inline(always)]
    pub(crate) unsafe fn array<L: Lanes<F>>(
        &mut self,
        position: usize,
        index: usize,
    ) -> &mut L::Array {
        let begin = position * self.stride + index * L::COUNT;
        // SAFETY: the columns lie in the slice that they were made of, which is borrowed; as the
        // caller promises, this one exists, and so many numbers follow there.
        let numbers =
            unsafe { core::slice::from_raw_parts_mut(self.first.as_ptr().add(begin), L::COUNT) };
        // SAFETY: that is as many numbers as an array has.
        unsafe { L::arrays_mut(numbers).get_unchecked_mut(0) }
    }
}

#[cfg(feature = "rayon")]
impl<F: Number> ColumnsMut<'_, F> {
    /// The length of every column.
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// The first numbers of every column, and the others.
    pub(crate) fn split_at(self, middle: usize) -> (Self, Self) {
        let middle = middle.min(self.len);
        let part = |first, len| ColumnsMut { first, len, ..self };
        // SAFETY: the first column, where there is one, has that many numbers; otherwise it is
        // none. The halves have no number in common.
        let behind = unsafe { self.first.add(middle) };
        (part(self.first, middle), part(behind, self.len - middle))
    }
}

/// Columns that begin `stride` numbers apart.
#[derive(Clone, Copy)]
pub(crate) struct View<'a, F> {
    pub(crate) numbers: &'a [F],
    pub(crate) stride: usize,
}
