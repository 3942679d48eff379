//! A basis blade is a set of basis vectors, written as the bits of an integer.

use core::cmp::Ordering;

/// The outer product of a set of basis vectors in increasing order; bit `i` of the mask says
/// whether basis vector number `i` (counted from zero) takes part.
///
/// Blades are ordered by grade first and by mask within a grade, so that a sorted list reads
/// scalar, vectors, bivectors … (the intent of algorithm A.6).
///
/// ```
/// use ga_core::Blade;
///
/// let e13 = Blade::new(0b101);
/// assert_eq!(e13.grade(), 2);
/// assert!(e13.indices().eq([0, 2]));
/// assert!(Blade::new(0b100) < Blade::new(0b011));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Blade(pub u32);

impl Blade {
    /// The empty outer product, 1.
    pub const SCALAR: Blade = Blade(0);

    /// The blade of the basis vectors whose bits are set.
    pub const fn new(mask: u32) -> Blade {
        Blade(mask)
    }

    /// The outer product of the first `dimension` basis vectors, I. From 32 on all bits are set.
    ///
    /// ```
    /// assert_eq!(ga_core::Blade::pseudoscalar(3).mask(), 0b111);
    /// ```
    pub const fn pseudoscalar(dimension: usize) -> Blade {
        if dimension >= u32::BITS as usize {
            Blade(u32::MAX)
        } else {
            Blade((1 << dimension) - 1)
        }
    }

    /// The set of basis vectors as bits.
    pub const fn mask(self) -> u32 {
        self.0
    }

    /// The number of basis vectors (algorithm A.1).
    pub const fn grade(self) -> u32 {
        self.0.count_ones()
    }

    /// Whether basis vector number `index`, counted from zero, takes part.
    pub const fn contains(self, index: usize) -> bool {
        index < u32::BITS as usize && self.0 >> index & 1 == 1
    }

    /// The numbers of the basis vectors, counted from zero, in increasing order.
    pub fn indices(self) -> impl DoubleEndedIterator<Item = usize> + Clone {
        (0..u32::BITS as usize).filter(move |&index| self.contains(index))
    }
}

impl Ord for Blade {
    fn cmp(&self, other: &Blade) -> Ordering {
        (self.grade(), self.0).cmp(&(other.grade(), other.0))
    }
}

impl PartialOrd for Blade {
    fn partial_cmp(&self, other: &Blade) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The sign of the permutation that brings the basis vectors of `a` followed by those of `b`
/// into increasing order: 1 or −1 (algorithm A.3).
///
/// Each vector of `b` passes every vector of `a` with a higher number. Vectors that are in both
/// masks end up side by side.
///
/// ```
/// use ga_core::reorder_sign;
///
/// assert_eq!(reorder_sign(0b01, 0b10), 1); // e1 e2
/// assert_eq!(reorder_sign(0b10, 0b01), -1); // e2 e1
/// ```
pub const fn reorder_sign(a: u32, b: u32) -> i32 {
    let mut swaps = 0;
    let mut higher = a >> 1;
    while higher != 0 {
        swaps += (higher & b).count_ones();
        higher >>= 1;
    }
    if swaps % 2 == 0 { 1 } else { -1 }
}
