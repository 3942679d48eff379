//! How a product of many versors becomes a unit versor again.

use ga_core::Real;

use crate::cga3::{Even, Motor};

/// Polar normalisation `X (X X̃)^{−1/2}`: the unit versor nearest to X.
///
/// S = X X̃ has the grades 0 and 4 only, and S₄² is a number, so that with
/// |S| = √(S₀² − S₄²) its root is (S + |S|)/√(2(S₀ + |S|)).
macro_rules! polar {
    ($($Versor:ident)*) => {$(
        impl<T: Real> $Versor<T> {
            /// The unit versor V with V Ṽ = 1 nearest to this one: what rounding has added in a
            /// long chain of products is taken away. A weight goes too, but not its sign.
            ///
            /// `None` where there is none: for zero, and for what is far from every versor or
            /// only a versor with V Ṽ < 0.
            pub fn without_drift(self) -> Option<Self> {
                // The size goes first: the square of a large or small one may not be a number.
                let sum = |sum: T, coefficient: T| sum + coefficient.abs();
                let size = self.to_array().into_iter().fold(T::ZERO, sum);
                if !size.is_invertible() || !size.is_finite() {
                    return None;
                }
                let scaled = self.map(|coefficient| coefficient / size);
                let square = scaled * scaled.reverse();
                let scalar = square.s;
                let quadvector = square - square.grade(0);
                let size_squared = scalar * scalar - (quadvector * quadvector).s;
                let size = size_squared.abs().sqrt();
                let root = ((scalar + size) * T::from_integer(2)).sqrt();
                let divisor = size * root;
                let null = size_squared.all_le(T::ZERO) || (scalar + size).all_le(T::ZERO);
                if null || !divisor.is_invertible() || !divisor.is_finite() {
                    return None;
                }
                let conjugate = square.grade(0) - quadvector;
                let mut inverse_root = conjugate * (T::ONE / divisor);
                inverse_root.s += size / divisor;
                Some(scaled * inverse_root)
            }
        }
    )*};
}

polar! { Motor Even }
