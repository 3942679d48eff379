//! Decides how a scene becomes Wavefront OBJ and MTL text: one object per node, z up.

use super::{ExportError, Format, Material, Scene, flatten};
use std::collections::HashSet;

/// The two files of a scene in OBJ format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Files {
    /// The text of the `.obj` file.
    pub geometry: String,
    /// The text of the `.mtl` file.
    pub materials: String,
}

/// The scene as OBJ text that names `library` as the file of its materials.
///
/// Surfaces become faces with normals, lines become `l` elements. Numbers are written so that
/// reading them back gives the same double. Colours are written as on a screen (sRGB), which is what
/// most programs expect of `Kd`; roughness and metal use the `Pr` and `Pm` extension. Spaces in names
/// become underscores, because OBJ separates words by spaces.
///
/// # Errors
/// [`ExportError`] if the scene is empty.
pub fn encode(scene: &Scene, library: &str) -> Result<Files, ExportError> {
    flatten::check_drawable(scene, Format::Obj)?;
    let names = material_names(scene.materials());
    let name_of = |material: &Material| {
        let position = scene
            .materials()
            .iter()
            .position(|m| std::ptr::eq(m, material));
        position
            .and_then(|i| names.get(i))
            .map_or("material", String::as_str)
    };
    let mut geometry = format!(
        "# {}\nmtllib {}\n",
        comment(scene.title()),
        comment(library)
    );
    let mut first_vertex = 1_u64;
    let mut first_normal = 1_u64;
    for surface in flatten::surfaces(scene) {
        begin(&mut geometry, surface.name, name_of(surface.material));
        rows(&mut geometry, "v", &surface.positions);
        rows(&mut geometry, "vn", &surface.normals);
        for triangle in surface.triangles {
            let [a, b, c] = triangle.map(|i| {
                let [vertex, normal] = [first_vertex, first_normal].map(|f| f + u64::from(i));
                format!("{vertex}//{normal}")
            });
            geometry += &format!("f {a} {b} {c}\n");
        }
        first_vertex += surface.positions.len() as u64;
        first_normal += surface.normals.len() as u64;
    }
    for line in flatten::lines(scene) {
        begin(&mut geometry, line.name, name_of(line.material));
        rows(&mut geometry, "v", &line.points);
        let count = line.points.len() as u64;
        geometry.push('l');
        let back = line.closed.then_some(first_vertex);
        for vertex in (first_vertex..first_vertex + count).chain(back) {
            geometry += &format!(" {vertex}");
        }
        geometry.push('\n');
        first_vertex += count;
    }
    let materials = scene
        .materials()
        .iter()
        .zip(&names)
        .map(|(material, name)| material_text(material, name))
        .collect();
    Ok(Files {
        geometry,
        materials,
    })
}

fn begin(text: &mut String, name: &str, material: &str) {
    *text += &format!("o {}\nusemtl {material}\n", word(name));
}

fn rows(text: &mut String, keyword: &str, points: &[[f64; 3]]) {
    for [x, y, z] in points {
        *text += &format!("{keyword} {x} {y} {z}\n");
    }
}

fn material_text(material: &Material, name: &str) -> String {
    let [red, green, blue] = material.color().map(|c| f64::from(c) / 255.0);
    // The usual correspondence of Blinn and Phong's exponent with a roughness (Walter et al. 2007).
    let shininess = (2.0 / material.roughness().max(0.05).powi(4) - 2.0).clamp(0.0, 1000.0);
    let mut text = format!("newmtl {name}\n");
    text += &format!("Kd {red:.4} {green:.4} {blue:.4}\n");
    text += &format!("Ks 0.04 0.04 0.04\nNs {shininess:.2}\n");
    text += &format!(
        "Pr {:.4}\nPm {:.4}\n",
        material.roughness(),
        material.metallic()
    );
    text += &format!("d {:.4}\nillum 2\n\n", material.opacity());
    text
}

/// A name for each material: made of one word, and different from all others.
fn material_names(materials: &[Material]) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut names = Vec::with_capacity(materials.len());
    for material in materials {
        let wanted = word(material.name());
        let mut name = wanted.clone();
        let mut number = 2;
        while !taken.insert(name.clone()) {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        names.push(name);
    }
    names
}

/// The text as one word that cannot be read as a comment or a new line.
fn word(text: &str) -> String {
    let mut word = String::with_capacity(text.len());
    for c in text.chars() {
        let plain = !c.is_whitespace() && !c.is_control() && !matches!(c, '#' | '\\');
        word.push(if plain { c } else { '_' });
    }
    if word.is_empty() {
        word.push_str("unnamed");
    }
    word
}

/// The text without line ends and continuations.
fn comment(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() || c == '\\' { ' ' } else { c })
        .collect()
}
