//! Rotations about the origin.

use ga_core::Real;

use crate::cga3::{Bivector3, Rotor, Vector3};

impl<T: Real> Rotor<T> {
    /// The rotation by an angle in radians in the plane of a bivector, in its sense:
    /// e^{−θB/2}; `None` for a bivector of size zero.
    ///
    /// ```
    /// use ga_cga::{Bivector3, Rotor, Vector3};
    ///
    /// // e12 turns the x axis towards the y axis.
    /// let quarter = Rotor::turn(Bivector3::new(2.0, 0.0, 0.0), core::f64::consts::FRAC_PI_2);
    /// let image = quarter.unwrap().apply(Vector3::new(1.0, 0.0, 0.0));
    /// assert!((image - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-15);
    /// ```
    pub fn turn(plane: Bivector3<T>, angle: T) -> Option<Self> {
        let plane = plane.normalized()?;
        Some((plane * (-angle * T::from_ratio(1, 2))).exp())
    }

    /// The rotation by an angle in radians about an axis through the origin, anticlockwise
    /// seen against its direction; `None` for an axis of length zero.
    pub fn about_axis(axis: Vector3<T>, angle: T) -> Option<Self> {
        // The Euclidean dual: the plane whose normal the axis is.
        let [x, y, z] = axis.to_array();
        Rotor::turn(Bivector3::new(z, -y, x), angle)
    }

    /// The identity.
    pub fn identity() -> Self {
        Rotor {
            s: T::ONE,
            ..Rotor::default()
        }
    }
}
