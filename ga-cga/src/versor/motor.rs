//! Rigid motions without reflection.

use ga_core::Real;

use crate::cga3::{Motor, Rotor, Translator};

impl<T: Real> Motor<T> {
    /// The motion that rotates about the origin first and then translates.
    ///
    /// ```
    /// use ga_cga::{Motor, Point, Rotor, Translator, Vector3};
    ///
    /// let half_turn = Rotor::about_axis(Vector3::new(0.0, 0.0, 1.0), core::f64::consts::PI);
    /// let motor = Motor::rigid(half_turn.unwrap(), Translator::by(Vector3::new(1.0, 0.0, 0.0)));
    /// let image: Point = motor.apply(Point::at(1.0, 0.0, 0.0));
    /// assert!(image.distance(Point::at(0.0, 0.0, 0.0)) < 1e-15);
    /// ```
    pub fn rigid(rotation: Rotor<T>, translation: Translator<T>) -> Self {
        translation * rotation
    }

    /// The identity.
    pub fn identity() -> Self {
        Motor::from(Rotor::identity())
    }
}
