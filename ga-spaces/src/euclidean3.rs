//! R3, Euclidean space: vectors, areas, volumes and rotors, which are the quaternions.
//!
//! The rotor e^{−θB/2} turns by θ in the plane B, in its sense; rotors compose by their product
//! and act on vectors and areas alike.
//!
//! ```
//! use ga_spaces::euclidean3::{Rotor, Vector};
//!
//! // The shortest rotation from x to y also takes y to −x.
//! let turn = Rotor::between(Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 2.0, 0.0)).unwrap();
//! let image = turn.apply(Vector::new(0.0, 1.0, 0.0));
//! assert!((image - Vector::new(-1.0, 0.0, 0.0)).norm() < 1e-15);
//! ```
//!
//! Source: §2.3 of the dissertation, (2.38).

use ga_core::Real;

ga_macros::define_algebra! {
    mod algebra: R3 {
        types {
            /// A vector of space.
            Vector { e1, e2, e3 }
            /// An area in a plane through the origin, with an orientation. The order of the
            /// blades is that of the normals x, y, z.
            Bivector { e23, e31, e12 }
            /// A volume: a multiple of the unit volume e₁₂₃.
            Trivector { e123 }
            /// An even element: a quaternion s − (e₂₃ i + e₃₁ j + e₁₂ k).
            Rotor { 1, e23, e31, e12 }
        }
    }
}

pub use algebra::*;

impl<T: Real> Rotor<T> {
    /// The rotation by an angle in radians in the plane of a bivector, in its sense;
    /// `None` for a bivector of size zero.
    pub fn turn(plane: Bivector<T>, angle: T) -> Option<Self> {
        Some((plane.normalized()? * (-angle * T::from_ratio(1, 2))).exp())
    }

    /// The rotation about an axis by an angle in radians, anticlockwise seen against the axis;
    /// `None` for an axis of length zero.
    pub fn about_axis(axis: Vector<T>, angle: T) -> Option<Self> {
        Rotor::turn(axis.undual(), angle)
    }

    /// The shortest rotation from the direction of one vector to that of another (2.38);
    /// `None` where one is zero or they are opposite, which leaves the plane open.
    pub fn between(from: Vector<T>, to: Vector<T>) -> Option<Self> {
        let (from, to) = (from.normalized()?, to.normalized()?);
        let (sum, difference) = (from + to, to - from);
        // With the unit vector h half-way, 1 + ba = (a + b) a is a multiple of h a. Near opposite
        // vectors the part of a + b along b − a, which should be zero, is rounding error.
        let half_way: Vector<T> = if difference.norm_squared().all_le(T::ONE) {
            sum
        } else {
            sum.reject(difference)
        };
        let rotor: Rotor<T> = half_way.normalized()? * from;
        rotor.normalized()
    }
}

impl<T: Real> Vector<T> {
    /// The cross product, the normal of the area a∧b.
    pub fn cross(self, other: Self) -> Self {
        (self ^ other).dual()
    }
}
