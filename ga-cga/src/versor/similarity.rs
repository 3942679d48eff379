//! Similarities: a scaling about any point, and what scales, turns and translates at once.

use ga_core::Real;

use crate::cga3::{Dilator, DualSphere, Even, Point, Rotor, Translator, Vector3};
use crate::classify::range::within_range;

impl<T: Real> Even<T> {
    /// The scaling by a factor about a point p, e^{−c p∧n_∞/2} with e^{−c} for the factor
    /// (2.4.4); a negative factor reflects in the point too. `None` for a factor that
    /// [`Dilator::scaling`] does not take.
    ///
    /// ```
    /// use ga_cga::{Even, Point};
    ///
    /// let double = Even::scaling(Point::at(1.0, 1.0, 1.0), 2.0).unwrap();
    /// let image = Point::at(2.0, 1.0, 0.0).image_under(double).unwrap();
    /// assert!(image.distance(Point::at(3.0, 1.0, -1.0)) < 1e-14);
    /// ```
    pub fn scaling(center: Point<T>, factor: T) -> Option<Self> {
        let there = Translator::by(center.position());
        Some(there * Dilator::scaling(factor)? * there.reverse())
    }

    /// The similarity that scales and rotates about the origin and then translates, T R D.
    pub fn similarity(scaling: Dilator<T>, rotation: Rotor<T>, translation: Translator<T>) -> Self {
        translation * (rotation * scaling)
    }

    /// The scaling, rotation and translation that a similarity consists of, as
    /// [`similarity`](Even::similarity) takes them, up to the sign and weight of the versor; the
    /// scaling is negative where the versor changes right hands into left ones.
    ///
    /// `None` if the versor has no inverse or is no similarity: if the image of n_∞ is not a
    /// multiple of n_∞, up to coefficients within `tolerance` times that multiple.
    ///
    /// ```
    /// use ga_cga::{Dilator, Even, Point, Rotor, Translator, Vector3};
    ///
    /// let turn = Rotor::about_axis(Vector3::new(1.0, 2.0, 3.0), 2.0).unwrap();
    /// let shift = Translator::by(Vector3::new(0.0, 4.0, 0.0));
    /// let given = Even::similarity(Dilator::scaling(2.5).unwrap(), turn, shift);
    /// let (scaling, rotation, translation) = (given * 7.0).similarity_parts(1e-9).unwrap();
    /// assert!((scaling.factor().unwrap() - 2.5_f64).abs() < 1e-14);
    /// assert!((rotation.angle() - 2.0_f64).abs() < 1e-14);
    /// assert!((translation.vector() - shift.vector()).norm() < 1e-14);
    /// ```
    pub fn similarity_parts(self, tolerance: T) -> Option<(Dilator<T>, Rotor<T>, Translator<T>)> {
        let versor = within_range(self)?;
        let infinity = versor.apply(DualSphere::infinity());
        let factor = infinity.ni;
        let place = Vector3::new(infinity.e1, infinity.e2, infinity.e3).norm();
        let off = infinity.no.abs() + place;
        if !factor.is_finite() || !off.all_le(factor.abs() * tolerance) {
            return None;
        }
        let scaling = Dilator::scaling(factor)?;
        let image = Point::at(T::ZERO, T::ZERO, T::ZERO).image_under(versor)?;
        let translation = Translator::by(image.position());
        let turn = translation.reverse() * versor * scaling.inverse()?;
        let rotation = Rotor::new(turn.s, turn.e12, turn.e13, turn.e23).normalized()?;
        Some((scaling, rotation, translation))
    }
}
