//! Why there is no path from one element or versor to another.

use core::fmt;

/// Why there is no path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPath {
    /// One of the two is zero or null: an element without a ratio to the other, or a versor
    /// without an inverse.
    Null,
    /// A coefficient is not finite, or so large or small that what is computed from it is not.
    NotFinite,
    /// The two have squares of opposite signs, as real and imaginary rounds: versors keep the
    /// square.
    RealToImaginary,
    /// The two are of different kinds: of radius zero and not, or at infinity and not.
    DifferentKinds,
    /// The target is oriented against the start: only its negative is within reach, or for a
    /// versor only one that does not change right hands into left ones as it does.
    Reversed,
    /// The target is the negative of the start, or points the opposite way: half turns about
    /// many axes lead there.
    Opposite,
    /// Many ways are equally short, as to a circle that is linked with this one at a right
    /// angle, or from one versor to another of opposite rotation.
    ManyWays,
    /// The way does not turn, so that there is no long one.
    DoesNotTurn,
    /// One of the two is a sum that is no versor, or no blade.
    NotAVersor,
    /// Rounding leaves no versor that leads there.
    Imprecise,
}

impl fmt::Display for NoPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NoPath::Null => "one of the two is zero or has no inverse",
            NoPath::NotFinite => "a coefficient is not finite or out of range",
            NoPath::RealToImaginary => "one of the two is real and the other imaginary",
            NoPath::DifferentKinds => "the two are of different kinds",
            NoPath::Reversed => "the target has the opposite orientation",
            NoPath::Opposite => {
                "the target points the opposite way, and many half turns lead there"
            }
            NoPath::ManyWays => "many ways to the target are equally short",
            NoPath::DoesNotTurn => "the way does not turn, and there is no long one",
            NoPath::NotAVersor => "one of the two is no versor or blade",
            NoPath::Imprecise => "rounding leaves no way that leads to the target",
        })
    }
}

impl core::error::Error for NoPath {}
