//! Rigid motions without reflection.

use ga_core::Real;

use crate::cga3::{Bivector3, DualLine, Line, Motor, Rotor, Translator, Trivector3, Vector3};
use crate::classify::range::within_range;

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

    /// The rotation by an angle in radians about a dual line λ = **B** + **d** n_∞, in the sense
    /// of **B**: cos(θ/2) − sin(θ/2) λ for a unit line (2.4.4).
    ///
    /// The dual line of the direct line through a and then b, `!(a ^ b ^ n_∞)`, makes it turn
    /// anticlockwise seen against the direction from a to b. `None` if **B** is zero, which is a
    /// line at infinity. Of a λ that is no line, because **B** ∧ **d** is not zero, the axis is
    /// taken and the pitch left out.
    ///
    /// ```
    /// use ga_cga::{DualLine, DualSphere, Motor, Point};
    ///
    /// let (a, b) = (Point::at(1.0, 0.0, 0.0), Point::at(1.0, 0.0, 5.0));
    /// let axis: DualLine = (!(a ^ b ^ DualSphere::infinity())).narrow(1e-9).unwrap();
    /// let quarter = Motor::about_line(axis, core::f64::consts::FRAC_PI_2).unwrap();
    /// let image: Point = quarter.apply(Point::at(3.0, 0.0, 7.0));
    /// assert!(image.distance(Point::at(1.0, 2.0, 7.0)) < 1e-14);
    /// ```
    pub fn about_line(axis: DualLine<T>, angle: T) -> Option<Self> {
        // The unit versor nearest to λ is the half turn about its axis: the unit line itself.
        let line = Motor::from(within_range(axis)?).renormalized()?;
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        let turn = line * -sin + Motor::identity() * cos;
        cos.is_finite().then_some(turn)
    }

    /// The rotation by an angle in radians about a direct line Λ = a∧b∧n_∞, anticlockwise seen
    /// against the direction from a to b; `None` for a line at infinity.
    pub fn about_direct_line(axis: Line<T>, angle: T) -> Option<Self> {
        Motor::about_line(axis.dual(), angle)
    }

    /// The screw about a dual line: a rotation by an angle in radians as
    /// [`about_line`](Motor::about_line) has it, and a translation by `rise` along the line, in
    /// the direction from which the rotation is seen to go clockwise (a right-handed screw if
    /// both are positive). `None` for a line at infinity.
    pub fn screw(axis: DualLine<T>, angle: T, rise: T) -> Option<Self> {
        let plane = within_range(Bivector3::new(axis.e12, axis.e13, axis.e23))?.normalized()?;
        let direction: Vector3<T> = plane * Trivector3::new(-T::ONE);
        Some(Translator::by(direction * rise) * Motor::about_line(axis, angle)?)
    }

    /// The rotation R of the motor M = T R, about the origin; `None` for zero and for motors
    /// without it, which are no versors.
    pub fn rotation(self) -> Option<Rotor<T>> {
        within_range(Rotor::new(self.s, self.e12, self.e13, self.e23))?.normalized()
    }

    /// The translation T of the motor M = T R, which comes after the rotation about the origin;
    /// `None` where there is no [`rotation`](Motor::rotation), or the vector is out of range.
    ///
    /// ```
    /// use ga_cga::{Motor, Rotor, Translator, Vector3};
    ///
    /// let turn = Rotor::about_axis(Vector3::new(0.0, 1.0, 0.0), 0.5).unwrap();
    /// let shift = Vector3::new(1.0, 2.0, 3.0);
    /// let motor = Motor::rigid(turn, Translator::by(shift)) * -2.0;
    /// assert!((motor.translation().unwrap().vector() - shift).norm() < 1e-15);
    /// ```
    pub fn translation(self) -> Option<Translator<T>> {
        let shift = within_range(self)? * self.rotation()?.reverse();
        let weight = shift.s;
        let [x, y, z] = [shift.e1ni, shift.e2ni, shift.e3ni].map(|part| part / weight);
        let finite = [x, y, z].into_iter().all(T::is_finite);
        (weight.is_invertible() && finite).then(|| Translator::new(x, y, z))
    }

    /// The identity.
    pub fn identity() -> Self {
        Motor::from(Rotor::identity())
    }
}
