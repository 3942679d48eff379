//! Decides the colours of the drawn figures: a few that stay apart for every kind of eyesight.

use crate::export::{ExportError, Material};

/// Blue, for what is given.
pub(super) const BLUE: [u8; 3] = [38, 104, 178];
/// Orange, for what comes out.
pub(super) const ORANGE: [u8; 3] = [226, 112, 36];
/// Teal, for what lies between.
pub(super) const TEAL: [u8; 3] = [30, 148, 132];
/// Yellow, for a second result.
pub(super) const YELLOW: [u8; 3] = [236, 178, 46];
/// Slate, for axes and paths.
pub(super) const SLATE: [u8; 3] = [92, 102, 118];

/// A smooth solid of this colour.
pub(super) fn solid(name: &str, color: [u8; 3]) -> Result<Material, ExportError> {
    Material::new(name, color).with_roughness(0.38)
}

/// A clear sheet of this colour.
pub(super) fn glass(name: &str, color: [u8; 3], opacity: f64) -> Result<Material, ExportError> {
    Material::new(name, color)
        .with_roughness(0.6)?
        .with_opacity(opacity)
}

/// The colour at this part of a course from blue through teal and yellow to orange.
pub(super) fn course(part: f64) -> [u8; 3] {
    match 3.0 * part {
        far if far < 1.0 => between(BLUE, TEAL, far),
        far if far < 2.0 => between(TEAL, YELLOW, far - 1.0),
        far => between(YELLOW, ORANGE, (far - 2.0).min(1.0)),
    }
}

/// The colour this part of the way from one to the other.
pub(super) fn between(from: [u8; 3], to: [u8; 3], part: f64) -> [u8; 3] {
    std::array::from_fn(|i| {
        let [from, to] = [from, to].map(|color| f64::from(color.get(i).copied().unwrap_or(0)));
        // A float becomes an integer by saturating, so that no part can leave the range.
        (from + (to - from) * part).round() as u8
    })
}
