//! Decides where a shape stands in a scene: scaled, then turned, then moved.

use super::ExportError;
use crate::mesh::{LARGEST_COORDINATE, MeshError, checked_point};
use glam::{DQuat, DVec3};

/// The smallest scale: below it a shape vanishes in single precision.
const SMALLEST_SCALE: f64 = 1e-18;

/// Where a shape stands: each point x goes to translation + rotation(scale · x).
///
/// ```
/// use ga_design::export::Placement;
/// let quarter_turn_about_z = [0.5_f64.sqrt(), 0.0, 0.0, 0.5_f64.sqrt()];
/// let placement = Placement::at([0.0, 0.0, 5.0])?
///     .rotated(quarter_turn_about_z)?
///     .scaled([2.0; 3])?;
/// let [x, y, z] = placement.apply([1.0, 0.0, 0.0]);
/// assert!(x.abs() < 1e-12 && (y - 2.0).abs() < 1e-12 && z == 5.0);
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    translation: DVec3,
    rotation: DQuat,
    scale: DVec3,
}

impl Default for Placement {
    fn default() -> Self {
        Self {
            translation: DVec3::ZERO,
            rotation: DQuat::IDENTITY,
            scale: DVec3::ONE,
        }
    }
}

impl Placement {
    /// Moved to a point, neither turned nor scaled.
    ///
    /// # Errors
    /// [`ExportError::Mesh`] if a coordinate is not finite or too large.
    pub fn at(translation: [f64; 3]) -> Result<Self, ExportError> {
        Ok(Self {
            translation: checked_point("the place of a node", translation)?,
            ..Self::default()
        })
    }

    /// The same with this rotation, a quaternion w x y z of any length but zero.
    ///
    /// # Errors
    /// [`ExportError::Number`] if the quaternion is zero or not finite.
    pub fn rotated(mut self, [w, x, y, z]: [f64; 4]) -> Result<Self, ExportError> {
        let largest = [w, x, y, z]
            .into_iter()
            .fold(0.0, |m: f64, c| m.max(c.abs()));
        let finite = [w, x, y, z].into_iter().all(f64::is_finite);
        if !finite || largest == 0.0 {
            return Err(ExportError::Number {
                what: "the length of a rotation's quaternion",
                value: if finite { 0.0 } else { f64::NAN },
                remedy: "give four finite numbers w x y z, not all zero",
            });
        }
        let [w, x, y, z] = [w, x, y, z].map(|c| c / largest);
        self.rotation = DQuat::from_xyzw(x, y, z, w).normalize();
        Ok(self)
    }

    /// The same with these factors along the shape's own x, y and z.
    ///
    /// # Errors
    /// [`ExportError::Number`] if a factor is not positive, not finite, or outside 1e-18 to 1e18.
    pub fn scaled(mut self, scale: [f64; 3]) -> Result<Self, ExportError> {
        for value in scale {
            if !(SMALLEST_SCALE..=LARGEST_COORDINATE).contains(&value) {
                return Err(ExportError::Number {
                    what: "the scale of a node",
                    value,
                    remedy: "it must be from 1e-18 to 1e18; to mirror a shape, mirror its mesh",
                });
            }
        }
        self.scale = DVec3::from(scale);
        Ok(self)
    }

    /// The point that a point of the shape goes to.
    #[must_use]
    pub fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        (self.translation + self.rotation * (self.scale * DVec3::from(point))).to_array()
    }

    /// The unit normal that a unit normal of the shape goes to.
    #[must_use]
    pub fn apply_normal(&self, normal: [f64; 3]) -> [f64; 3] {
        let unscaled = DVec3::from(normal) / self.scale;
        let unit = crate::mesh::direction(unscaled).unwrap_or(DVec3::Z);
        (self.rotation * unit).to_array()
    }

    /// The translation.
    #[must_use]
    pub fn translation(&self) -> [f64; 3] {
        self.translation.to_array()
    }

    /// The rotation as a unit quaternion w x y z.
    #[must_use]
    pub fn rotation(&self) -> [f64; 4] {
        let [x, y, z, w] = self.rotation.to_array();
        [w, x, y, z]
    }

    /// The scale along the shape's own x, y and z.
    #[must_use]
    pub fn scale(&self) -> [f64; 3] {
        self.scale.to_array()
    }

    /// Whether every one of the points still has coordinates that may stand in a mesh.
    pub(super) fn check(&self, bounds: [[f64; 3]; 2]) -> Result<(), MeshError> {
        // Far inside the limits, as nearly always, nothing need be computed.
        let size = bounds
            .as_flattened()
            .iter()
            .fold(0.0, |m: f64, c| m.max(c.abs()));
        let farthest = self.translation.abs().max_element() + 2.0 * size * self.scale.max_element();
        if farthest < LARGEST_COORDINATE {
            return Ok(());
        }
        // A placement is affine, so the corners of the bounding box decide for all points.
        for corner in 0..8_u8 {
            let point = std::array::from_fn(|axis| {
                let side = usize::from(corner >> axis & 1);
                bounds
                    .get(side)
                    .and_then(|b| b.get(axis))
                    .copied()
                    .unwrap_or_default()
            });
            checked_point("a placed vertex", self.apply(point))?;
        }
        Ok(())
    }
}
