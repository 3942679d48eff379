//! The algebra of space, with the rotor a unit versor.

use crate::data::Rotation;
use crate::ours::unit;
use ga_core::Real;

ga_macros::define_algebra! {
    pub mod algebra: R3 {
        types {
            /// A vector.
            Vector { e1, e2, e3 }
            /// An area.
            Bivector { e23, e31, e12 }
            /// A volume.
            Trivector { e123 }
            /// A rotation.
            #[unit]
            Rotor { 1, e23, e31, e12 }
        }
    }
}
pub use algebra::*;

/// The rotor s − (e₂₃ i + e₃₁ j + e₁₂ k) of a quaternion.
pub fn rotor<T: Real>(q: &Rotation) -> Rotor<T> {
    let [w, x, y, z] = q.map(T::from_f64);
    unit(Rotor::new(w, -x, -y, -z))
}

/// A vector.
pub fn vector<T: Real>(x: &[f64; 3]) -> Vector<T> {
    let [x, y, z] = x.map(T::from_f64);
    Vector::new(x, y, z)
}
