//! Decides from where a scene is looked at.

/// The direction from which a scene is looked at, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Angle of the eye around z, from the x axis towards y.
    pub azimuth: f64,
    /// Angle of the eye above the xy plane.
    pub elevation: f64,
}

impl Default for View {
    /// From the front right and somewhat above, the usual view of a structure.
    fn default() -> Self {
        Self {
            azimuth: -1.05,
            elevation: 0.38,
        }
    }
}
