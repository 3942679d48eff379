//! Decides how surfaces become a binary STL file: bare triangles with their facet normals, z up.

use super::{ExportError, Format, Scene, flatten};
use crate::mesh::direction;
use glam::DVec3;

/// The bytes of a binary STL file with every surface of the scene; lines are left out.
///
/// 80 bytes of text, the number of triangles, and for each of them its normal, its corners and two
/// bytes of zero, all little-endian in single precision. A triangle without area has normal zero.
///
/// # Errors
/// [`ExportError`] if the scene has no surface or too many triangles.
pub fn encode(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    let [_, count] = flatten::counts(scene, Format::Stl)?;
    // A header that began with “solid” would make readers take the file for text.
    let mut header = [b' '; 80];
    let text = format!("binary STL by {}", env!("CARGO_PKG_NAME"));
    for (slot, byte) in header.iter_mut().zip(text.bytes()) {
        *slot = byte;
    }
    let mut bytes = Vec::with_capacity(84 + 50 * count as usize);
    bytes.extend(header);
    bytes.extend(count.to_le_bytes());
    for surface in flatten::surfaces(scene) {
        for triangle in surface.triangles {
            let corners = triangle.map(|i| {
                let position = surface.positions.get(i as usize);
                DVec3::from(position.copied().unwrap_or_default())
            });
            let sides = [corners[1] - corners[0], corners[2] - corners[0]];
            let normal = match sides.map(direction) {
                [Some(a), Some(b)] => direction(a.cross(b)).unwrap_or(DVec3::ZERO),
                _ => DVec3::ZERO,
            };
            for vector in [normal, corners[0], corners[1], corners[2]] {
                for coordinate in vector.to_array() {
                    bytes.extend((coordinate as f32).to_le_bytes());
                }
            }
            bytes.extend([0; 2]);
        }
    }
    Ok(bytes)
}
