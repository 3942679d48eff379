//! Decides how surfaces become a binary PLY file: vertices with normals and colours, and faces, z up.

use super::{ExportError, Format, Scene, flatten};

/// The bytes of a binary little-endian PLY file with every surface of the scene; lines are left out.
///
/// Each vertex holds x y z and nx ny nz in single precision and red green blue alpha in bytes (sRGB
/// and opacity of the material).
///
/// # Errors
/// [`ExportError`] if the scene has no surface or too many vertices.
pub fn encode(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    let [vertices, triangles] = flatten::counts(scene, Format::Ply)?;
    let mut header = String::from("ply\nformat binary_little_endian 1.0\n");
    header += &format!("comment {}\n", one_line(scene.title()));
    header += &format!("element vertex {vertices}\n");
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        header += &format!("property float {name}\n");
    }
    for name in ["red", "green", "blue", "alpha"] {
        header += &format!("property uchar {name}\n");
    }
    header += &format!("element face {triangles}\n");
    header += "property list uchar int vertex_indices\nend_header\n";

    let mut bytes = header.into_bytes();
    bytes.reserve(28 * vertices as usize + 13 * triangles as usize);
    let mut faces = Vec::with_capacity(13 * triangles as usize);
    let mut first = 0_u32;
    for surface in flatten::surfaces(scene) {
        let opacity = (surface.material.opacity() * 255.0).round() as u8;
        for (position, normal) in surface.positions.iter().zip(&surface.normals) {
            for &coordinate in position.iter().chain(normal) {
                bytes.extend((coordinate as f32).to_le_bytes());
            }
            bytes.extend(surface.material.color());
            bytes.push(opacity);
        }
        for triangle in surface.triangles {
            faces.push(3);
            for index in triangle {
                faces.extend((first + index).to_le_bytes());
            }
        }
        first += surface.positions.len() as u32;
    }
    bytes.extend(faces);
    Ok(bytes)
}

/// The text in printable ASCII, as old readers of the header expect, and without line ends, which
/// would break it.
fn one_line(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_ascii_graphic() { c } else { ' ' })
        .collect()
}
