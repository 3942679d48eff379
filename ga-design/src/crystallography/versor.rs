//! How a symmetry operation becomes versors of the conformal model: a motor, after one
//! reflection where the operation changes handedness.
//!
//! # Which hand
//! This is the one place where it is decided; all of crystallography follows it.
//!
//! * A versor acts as `x ↦ V x̂ V⁻¹` (2.28). A product acts **from the right**: in the word `ab`
//!   the reflection in **b** comes first, then that in **a**, and in `T ab` the translation comes
//!   last.
//! * So `ab` turns by twice the angle from **b** to **a**. With the roots of (3.1), **a** = e₁ and
//!   **b** at +π/p from it towards e₂, the rotation `ab` goes by −2π/p about e₃: clockwise, seen
//!   against e₃.
//! * A screw is right-handed where a turn anticlockwise, seen against its axis, comes with a
//!   positive rise along it: `4₁` of *International Tables* is right-handed.
//!
//! The opposite rule `Ṽ x V` would exchange the eleven enantiomorphic pairs, `P 41 21 2` with
//! `P 43 21 2` and so on; the tests hold each of them to its hand.

mod fractional;
mod motion;
mod movable;

pub use fractional::NotOfLattice;
pub use motion::Motion;
pub use movable::Movable;

use std::fmt;

use ga_cga::{Bivector3, DualPlane, Motor, OddVersor, Point, Rotor, Translator, Vector3};

use super::Placement;

/// A rigid motion with or without reflection, as the versors that carry it out.
///
/// By Cartan and Dieudonné an operation is at most three reflections in planes through the
/// origin and a translation. An even number of reflections is a rotor, the product of their
/// normals; of an odd number the reflection that acts first is kept as a dual plane. Rotor and
/// translator together are a motor.
///
/// The versors are of unit size, and `V` and `−V` are the same isometry: `==` compares
/// coefficients, [`is_same`](Isometry::is_same) what they do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isometry {
    /// The plane of the reflection that acts first, if the motion changes handedness.
    pub mirror: Option<DualPlane>,
    /// The proper motion that follows.
    pub motor: Motor,
}

impl Isometry {
    /// What moves nothing.
    pub fn identity() -> Self {
        Self::from(Motor::identity())
    }

    /// The reflection in the plane through the origin that is perpendicular to `normal`, or
    /// `None` for a vector without direction.
    pub fn reflection(normal: Vector3) -> Option<Self> {
        let normal = normal.normalized()?;
        let finite = normal.to_array().iter().all(|part| part.is_finite());
        finite.then(|| Self::from(DualPlane::at_distance(normal, 0.0)))
    }

    /// The translation by a vector.
    pub fn translation(vector: Vector3) -> Self {
        Self::from(Motor::from(Translator::by(vector)))
    }

    /// The inversion in the origin: three reflections in planes at right angles.
    pub fn inversion() -> Self {
        let half_turn = Rotor::from(Bivector3::new(1.0, 0.0, 0.0));
        Self {
            mirror: Some(DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.0)),
            motor: half_turn.into(),
        }
    }

    /// The image of an element of any kind; [`Movable`] says which.
    ///
    /// ```
    /// use ga_cga::Point;
    /// use ga_design::crystallography::{Isometry, Placement};
    ///
    /// // A glide: reflection in the plane z = 0, then a step along x.
    /// let glide = Placement { reflections: vec![[0.0, 0.0, 1.0]], translation: [2.0, 0.0, 0.0] };
    /// let image = Isometry::from(&glide).apply(Point::at(1.0, 1.0, 1.0));
    /// assert_eq!(image, Point::at(3.0, 1.0, -1.0));
    /// ```
    pub fn apply<X: Movable>(&self, element: X) -> X {
        element.moved_by(self)
    }

    /// The product of the versors: this isometry after `first`.
    ///
    /// ```
    /// use ga_cga::{Point, Vector3};
    /// use ga_design::crystallography::Isometry;
    ///
    /// let mirror = Isometry::reflection(Vector3::new(1.0, 0.0, 0.0)).unwrap();
    /// let step = Isometry::translation(Vector3::new(2.0, 0.0, 0.0));
    /// let image = step.after(&mirror).apply(Point::at(0.5, 0.0, 0.0));
    /// assert_eq!(image, Point::at(1.5, 0.0, 0.0));
    /// ```
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        // A mirror passes a motor by reflecting it, μ M = μ[M] μ, and two mirrors are a motor.
        match (self.mirror, first.mirror) {
            (None, mirror) => Self {
                mirror,
                motor: self.motor * first.motor,
            },
            (Some(mirror), None) => Self {
                mirror: Some(mirror),
                motor: self.motor * mirror.apply(first.motor),
            },
            (Some(second), Some(mirror)) => {
                let reflected: Motor = second.apply(first.motor);
                let both: Motor = second * mirror;
                Self::from(self.motor * reflected * both)
            }
        }
    }

    /// What undoes this isometry.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let motor = self.motor.reverse();
        match self.mirror {
            None => Self::from(motor),
            Some(mirror) => Self {
                mirror: Some(mirror),
                motor: mirror.apply(motor),
            },
        }
    }

    /// This isometry as seen from where `frame` leads: `frame · self · frame⁻¹`.
    #[must_use]
    pub fn moved_by(&self, frame: &Self) -> Self {
        frame.after(self).after(&frame.inverse())
    }

    /// Whether it keeps left hands left.
    pub fn is_proper(&self) -> bool {
        self.mirror.is_none()
    }

    /// The one odd versor of an isometry that changes handedness, motor times mirror.
    pub fn odd_versor(&self) -> Option<OddVersor> {
        self.mirror.map(|mirror| self.motor * mirror)
    }

    /// The image of the origin, as a vector from there: what follows when the rest is done about
    /// the origin.
    pub fn shift(&self) -> Vector3 {
        self.apply(Point::at(0.0, 0.0, 0.0)).position()
    }

    /// The same turn or reflection in a place where the origin stays: [`shift`](Isometry::shift)
    /// undone.
    #[must_use]
    pub fn about_origin(&self) -> Self {
        Self::translation(-self.shift()).after(self)
    }

    /// Whether both do the same to all points up to `tolerance`, at the distance 1 from the
    /// origin.
    pub fn is_same(&self, other: &Self, tolerance: f64) -> bool {
        let frame = [
            Point::at(0.0, 0.0, 0.0),
            Point::at(1.0, 0.0, 0.0),
            Point::at(0.0, 1.0, 0.0),
            Point::at(0.0, 0.0, 1.0),
        ];
        frame.iter().all(|point| {
            let apart = self.apply(*point).position() - other.apply(*point).position();
            apart.norm() <= tolerance
        })
    }

    /// The same isometry with rounding taken out of its versors; needed after thousands of
    /// products only. Unchanged where there is no versor near.
    #[must_use]
    pub fn renormalized(&self) -> Self {
        let unit_mirror = |plane: DualPlane| plane.normalized().unwrap_or(plane);
        Self {
            mirror: self.mirror.map(unit_mirror),
            motor: self.motor.renormalized().unwrap_or(self.motor),
        }
    }
}

/// The one versor: the motor, or motor times mirror.
///
/// ```
/// use ga_cga::Vector3;
/// use ga_design::crystallography::Isometry;
///
/// let mirror = Isometry::reflection(Vector3::new(0.0, 2.0, 0.0)).unwrap();
/// assert_eq!(mirror.to_string(), "e2");
/// ```
impl fmt::Display for Isometry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.odd_versor() {
            Some(odd) => odd.fmt(f),
            None => self.motor.fmt(f),
        }
    }
}

impl From<Motor> for Isometry {
    fn from(motor: Motor) -> Self {
        Self {
            mirror: None,
            motor,
        }
    }
}

/// The reflection in a plane, of unit weight.
impl From<DualPlane> for Isometry {
    fn from(mirror: DualPlane) -> Self {
        Self {
            mirror: Some(mirror),
            motor: Motor::identity(),
        }
    }
}

impl From<&Placement> for Isometry {
    fn from(placement: &Placement) -> Self {
        let normal = |n: &[f64; 3]| Vector3::from(*n);
        let (rotor, mirror) = match placement.reflections.as_slice() {
            [] => (Rotor::identity(), None),
            [only] => (Rotor::identity(), Some(normal(only))),
            [last, first] => (normal(last) * normal(first), None),
            [last, second, first, ..] => (normal(last) * normal(second), Some(normal(first))),
        };
        let translator = Translator::by(Vector3::from(placement.translation));
        Isometry {
            mirror: mirror.map(|normal| DualPlane::at_distance(normal, 0.0)),
            motor: Motor::rigid(rotor, translator),
        }
    }
}
