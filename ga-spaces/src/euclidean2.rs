//! R2, the Euclidean plane: vectors, areas and rotors, which are the complex numbers.
//!
//! The product of two vectors is an even element; even elements multiply like complex numbers
//! with e₁₂ as the imaginary unit, and a rotor turns vectors. It is the smallest algebra in
//! which everything of the larger ones can be watched.
//!
//! ```
//! use ga_spaces::euclidean2::{Rotor, Vector};
//!
//! let quarter = Rotor::by_angle(core::f64::consts::FRAC_PI_2);
//! let turned = quarter.apply(Vector::new(1.0, 0.0));
//! assert!((turned - Vector::new(0.0, 1.0)).norm() < 1e-15);
//! ```
//!
//! Source: §2.3 of the dissertation; Hestenes, *New Foundations for Classical Mechanics*, §2.3.

use ga_core::{Field, Real};

ga_macros::define_algebra! {
    mod algebra: R2 {
        types {
            /// A vector of the plane.
            Vector { e1, e2 }
            /// An area with an orientation: a multiple of the unit area e₁₂.
            Bivector { e12 }
            /// An even element, scalar and area: a complex number; of unit norm it turns by
            /// twice its argument, clockwise, because V = e^{−θ e₁₂/2} turns by θ.
            Rotor { 1, e12 }
        }
    }
}

pub use algebra::*;

impl<T: Real> Rotor<T> {
    /// The rotation by an angle in radians, anticlockwise: e^{−θ e₁₂/2}.
    pub fn by_angle(angle: T) -> Self {
        Bivector::new(-angle * T::from_ratio(1, 2)).exp()
    }

    /// The angle in radians by which the rotor turns, anticlockwise, in (−2π, 2π].
    pub fn angle(self) -> T {
        T::from_integer(2) * (-self.e12).atan2(self.s)
    }
}

impl<T: Field> Rotor<T> {
    /// The rotation by twice the angle from `a` to `b`, the reflections in the lines across
    /// them one after the other: `b a`. Not of unit norm unless the vectors are.
    pub fn between_mirrors(a: Vector<T>, b: Vector<T>) -> Self {
        b * a
    }
}
