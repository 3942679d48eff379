//! Velocities against the observer: which are possible, and how they compose.

use core::fmt;

use ga_core::convert::pick;
use ga_core::{Field, Real};

use super::{Boost, RelativeVector, Rotation, Vector};

/// Why no observer moves with a velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VelocityError {
    /// The velocity of light: light has no rest frame.
    Lightlike,
    /// A velocity greater than that of light.
    Superluminal,
    /// A velocity with a coefficient that is no finite number.
    NotFinite,
}

impl fmt::Display for VelocityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lightlike => "the velocity is that of light, which has no rest frame",
            Self::Superluminal => "the velocity is greater than that of light",
            Self::NotFinite => "the velocity is not finite",
        })
    }
}

impl core::error::Error for VelocityError {}

impl<T: Real> RelativeVector<T> {
    /// The factor γ = 1/√(1 − **v**²) by which a moving clock is slow.
    ///
    /// # Errors
    /// [`VelocityError`] where **v** is not below the velocity of light, 1.
    ///
    /// ```
    /// use ga_spaces::spacetime::{RelativeVector, VelocityError};
    ///
    /// assert_eq!(RelativeVector::new(0.0, 0.0, 0.6).time_dilation(), Ok(1.25));
    /// let light = RelativeVector::new(0.0, 1.0, 0.0);
    /// assert_eq!(light.time_dilation(), Err(VelocityError::Lightlike));
    /// ```
    pub fn time_dilation(self) -> Result<T, VelocityError> {
        if !self.to_array().into_iter().all(T::is_finite) {
            return Err(VelocityError::NotFinite);
        }
        let square = self.scalar_product(self);
        // The product keeps digits near the velocity of light that 1 − v² would lose.
        let speed = square.sqrt();
        let rest = (T::ONE - speed) * (T::ONE + speed);
        if rest == T::ZERO {
            Err(VelocityError::Lightlike)
        } else if rest.all_le(T::ZERO) || !rest.is_finite() {
            Err(VelocityError::Superluminal)
        } else {
            Ok(T::ONE / rest.sqrt())
        }
    }

    /// The four-velocity γ(1 + **v**)t of a traveller with this velocity.
    ///
    /// # Errors
    /// [`VelocityError`] where **v** is not below the velocity of light.
    pub fn four_velocity(self) -> Result<Vector<T>, VelocityError> {
        let gamma = self.time_dilation()?;
        let seen = Boost::with_half_velocity(self) * Vector::observer();
        Ok(pick::<_, Vector<T>>(seen) * gamma)
    }
}

impl<T: Field> Vector<T> {
    /// The velocity (u∧t)/(u·t) of what moves along this vector; `None` for a vector without
    /// duration.
    pub fn velocity(self) -> Option<RelativeVector<T>> {
        let observer = Vector::observer();
        let duration = self.scalar_product(observer);
        duration
            .is_invertible()
            .then(|| pick::<_, RelativeVector<T>>(self ^ observer) * (T::ONE / duration))
    }
}

impl<T: Field> Boost<T> {
    /// The boost that takes the observer to this four-velocity, 1 + u t, of any norm; `None`
    /// for his own in reverse, −t.
    pub fn to_four_velocity(u: Vector<T>) -> Option<Self> {
        let mut boost: Boost<T> = pick(u * Vector::observer());
        boost.s += T::ONE;
        boost.s.is_invertible().then_some(boost)
    }
}

impl<T: Real> Boost<T> {
    /// The boost of unit norm from rest to this velocity.
    ///
    /// # Errors
    /// [`VelocityError`] where **v** is not below the velocity of light.
    pub fn with_velocity(v: RelativeVector<T>) -> Result<Self, VelocityError> {
        let boost = Boost::to_four_velocity(v.four_velocity()?);
        boost
            .and_then(Boost::normalized)
            .ok_or(VelocityError::NotFinite)
    }
}

/// The velocity **u** ⊕ **v** against the observer of what moves with **v** against a traveller
/// with **u**.
///
/// # Errors
/// [`VelocityError`] where one of them is not below the velocity of light.
pub fn compose_velocities<T: Real>(
    u: RelativeVector<T>,
    v: RelativeVector<T>,
) -> Result<RelativeVector<T>, VelocityError> {
    let moved: Vector<T> = Boost::with_velocity(u)?.apply(v.four_velocity()?);
    moved.velocity().ok_or(VelocityError::NotFinite)
}

/// The rotation R, of unit norm, by which two boosts differ from one: B(**u**) B(**v**) =
/// B(**u** ⊕ **v**) R, after Thomas and Wigner.
///
/// # Errors
/// [`VelocityError`] where one of them is not below the velocity of light.
pub fn thomas_rotation<T: Real>(
    u: RelativeVector<T>,
    v: RelativeVector<T>,
) -> Result<Rotation<T>, VelocityError> {
    let both = Boost::with_velocity(u)? * Boost::with_velocity(v)?;
    let parts = both.boost_and_rotation();
    let rotation = parts.and_then(|(_, rotation)| rotation.normalized());
    rotation.ok_or(VelocityError::NotFinite)
}
