//! R1,3, spacetime: events, velocities, boosts and electromagnetic fields, after Hestenes.
//!
//! The vector `t` is the observer; time squares to 1, space to −1, and the speed of light is 1.
//! What the observer sees as a vector of space is a bivector with `t`, a [`RelativeVector`]:
//! the velocity (u∧t)/(u·t) of a traveller u, an electric field. The exponential of a relative
//! vector is a boost, that of any bivector a Lorentz transformation, and boosts compose to a
//! boost and a rotation: Thomas' and Wigner's.
//!
//! ```
//! use ga_spaces::spacetime::{RelativeVector, compose_velocities, thomas_rotation};
//!
//! let east = RelativeVector::new(0.5_f64, 0.0, 0.0);
//! let twice = compose_velocities(east, east).unwrap();
//! assert!((twice.xt - 0.8).abs() < 1e-15);
//!
//! // Velocities at right angles do not commute: the frame turns.
//! let north = RelativeVector::new(0.0, 0.5, 0.0);
//! let turn = thomas_rotation(east, north).unwrap();
//! assert!(turn.angle() > 0.1);
//! ```
//!
//! Sources: Hestenes, *Space-Time Algebra* (1966); Doran and Lasenby, *Geometric Algebra for
//! Physicists* (2003), chapter 5; Gull, Lasenby and Doran, *Imaginary numbers are not real* (1993).

mod character;
mod velocity;

use ga_core::convert::pick;
use ga_core::{Field, Real, Scalar as Ring};

ga_macros::define_algebra! {
    mod algebra: R1_3 {
        basis { t, x, y, z }
        metric { t^2 = 1, x^2 = -1, y^2 = -1, z^2 = -1 }
        types {
            /// A vector of spacetime: an event, a four-velocity, the wave vector of light.
            Vector { t, x, y, z }
            /// A vector of the observer's space, as bivector with his time: a velocity, a
            /// rapidity, an electric field. It squares to plus its length squared.
            RelativeVector { x^t, y^t, z^t }
            /// An area of the observer's space: the generator of rotations, a magnetic field.
            RelativeBivector { x^y, x^z, y^z }
            /// A boost, the exponential of a relative vector.
            Boost { 1, x^t, y^t, z^t }
            /// A rotation of the observer's space.
            Rotation { 1, x^y, x^z, y^z }
            /// Any bivector: the generator of a Lorentz transformation, an electromagnetic field.
            Bivector { x^t, y^t, z^t, x^y, x^z, y^z }
            /// A volume, the dual of a vector.
            Trivector = grade 3;
            /// A multiple of the pseudoscalar I = t∧x∧y∧z, which squares to −1.
            Pseudoscalar { t^x^y^z }
        }
    }
}

pub use algebra::*;
pub use character::Character;
pub use velocity::{VelocityError, compose_velocities, thomas_rotation};

/// Any Lorentz transformation that keeps the senses of space and of time, and with them every
/// even element.
pub type Lorentz<T = f64> = Even<T>;

impl<T: Ring> Vector<T> {
    /// The observer's own four-velocity, the unit vector of time.
    pub fn observer() -> Self {
        Vector {
            t: T::ONE,
            ..Vector::default()
        }
    }
}

impl<T: Field> Boost<T> {
    /// The boost 1 + **w** of any norm: from rest to the velocity 2**w**/(1 + **w**²), to which
    /// **w** composes with itself. It needs no root, so it is exact where numbers are.
    /// [`apply`](Self::apply) is no boost for a **w** that is as fast as light or faster.
    pub fn with_half_velocity(w: RelativeVector<T>) -> Self {
        let [xt, yt, zt] = w.to_array();
        Boost::new(T::ONE, xt, yt, zt)
    }
}

impl<T: Real> Boost<T> {
    /// The boost with this rapidity along its direction, e^{**φ**/2}. Rapidities along one
    /// direction add; the velocity is tanh φ.
    pub fn with_rapidity(rapidity: RelativeVector<T>) -> Self {
        (rapidity * T::from_ratio(1, 2)).exp()
    }
}

impl<T: Real> Rotation<T> {
    /// The rotation by an angle in radians in a plane of space, in its sense;
    /// `None` for an area of size zero.
    pub fn turn(plane: RelativeBivector<T>, angle: T) -> Option<Self> {
        // The sense of x∧y is from x to y although x and y square to −1: the sign of the
        // exponent is that of Euclidean space reversed.
        Some((plane.normalized()? * (angle * T::from_ratio(1, 2))).exp())
    }

    /// The size of the angle in radians by which the rotation turns, in [0, 2π].
    pub fn angle(self) -> T {
        let plane = RelativeBivector::new(self.xy, self.xz, self.yz);
        T::from_integer(2) * plane.norm().atan2(self.s)
    }
}

impl<T: Field> Lorentz<T> {
    /// The boost and the rotation that this transformation is, rotation first: L = B R, both up
    /// to positive factors. The boost is the one to the observer's image.
    ///
    /// `None` for an element that has no inverse, or that turns the observer to the past.
    pub fn boost_and_rotation(self) -> Option<(Boost<T>, Rotation<T>)> {
        if !self.norm_squared().is_invertible() {
            return None;
        }
        let moved = self.apply(Vector::observer());
        let boost = Boost::to_four_velocity(moved)?;
        let rotation = boost.inverse()? * self;
        Some((boost, pick(rotation)))
    }
}
