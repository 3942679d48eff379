//! What lies between two joints: a rigid body, told by its length, twist and offset.

use ga_cga::{Motor, Translator, Vector3};
use ga_core::Unit;

use super::Axis;

/// A link of the dissertation (figure 4.2): from the frame of one joint, turned by its joint
/// value, to that of the next,
///
/// L = T(a e₂ + r e₃) e^{−α e₁₃/2}.
///
/// The link lies along the y-axis, and its far end is turned about that axis by −α: e₁₃ is the
/// plane from x to z, and turns about y from x to z are negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// The length a, along the y-axis.
    pub length: f64,
    /// The skew α in radians, in the plane e₁₃.
    pub skew: f64,
    /// The offset r, along the z-axis.
    pub offset: f64,
}

impl Link {
    /// The motion from the frame of one joint to that of the next: a rotation about the y-axis,
    /// then the translation.
    #[must_use]
    pub fn motion(self) -> Unit<Motor> {
        let shift = Translator::by(Vector3::new(0.0, self.length, self.offset));
        Unit::promised(shift * about(Axis::Y, -self.skew))
    }
}

/// The rotation about an axis through the origin.
pub(super) fn about(axis: Axis, angle: f64) -> Motor {
    super::Freedom::Turn(axis).motion(angle).into_inner()
}

/// The translation along an axis.
pub(super) fn along(axis: Axis, distance: f64) -> Motor {
    super::Freedom::Slide(axis).motion(distance).into_inner()
}
