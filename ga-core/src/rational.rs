//! The exact numbers in which metrics and products of basis blades are computed.

/// An exact fraction of two 128-bit integers, in lowest terms with a positive denominator.
///
/// Its operators overflow as those of integers do; the arithmetic of this crate's symbolic
/// part ([`Metric`](crate::Metric), [`product`](crate::product), [`dual`](crate::dual)) is
/// checked and reports overflow instead.
pub type Rational = num_rational::Ratio<i128>;
