//! R3: rotors and vectors.

use ga_core::{Real, Unit};
pub use ga_spaces::euclidean3::{Rotor, Vector};

use crate::data::Rotation;

/// The rotor s − (e₂₃ i + e₃₁ j + e₁₂ k) of a quaternion.
pub fn rotor<T: Real>(q: &Rotation) -> Unit<Rotor<T>> {
    let [w, x, y, z] = q.map(T::from_f64);
    Unit::promised(Rotor::new(w, -x, -y, -z))
}

/// A vector.
pub fn vector<T: Real>(x: &[f64; 3]) -> Vector<T> {
    let [x, y, z] = x.map(T::from_f64);
    Vector::new(x, y, z)
}
