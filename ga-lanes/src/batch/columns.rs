//! Columns stand in whole lines of the cache.

use smallvec::SmallVec;

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

/// Columns of the same length, without an allocation for all types but large multivectors.
pub(crate) type ColumnsMut<'a, F> = SmallVec<[&'a mut [F]; 32]>;

/// Columns that begin `stride` numbers apart.
#[derive(Clone, Copy)]
pub(crate) struct View<'a, F> {
    pub(crate) numbers: &'a [F],
    pub(crate) stride: usize,
}
