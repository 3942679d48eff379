//! Six point groups on one motif (figure 3.2): every transformation a versor that grew from three roots.

use super::GalleryError;
use super::horn::{frame, horn, materials, roomy};
use super::palette::glass;
use crate::crystallography::motif::add_instances;
use crate::crystallography::{Isometry, PointGroup};
use crate::export::{Placement, Scene, View};
use crate::mesh;
use ga_cga::Vector3;

/// The groups of the figure in geometric notation, two rows of three.
const GROUPS: [&str; 6] = ["42", "b(6)b(2)", "b(3)b(3)", "4b(3)", "33", "43"];

/// The distance of the motif from the centre of its group, and of the centres from each other.
const RADIUS: f64 = 1.0;
const SPACING: f64 = 3.1;

/// The largest size of the motif.
const LARGEST: f64 = 0.34;

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "point-groups",
        "Six point groups on a motif",
        "A horn, carried by all transformations that three mirrors a, b, c generate: blue where it was \
         turned, orange where it was mirrored. Above 42 (4/mmm), 6̅2̅ (622), 3̅3̅ (23); below 43̅ (m-3), 33 \
         (-43m), 43 (m-3m): a number with a bar takes the two mirrors only together, as a rotation.",
    );
    let materials = materials(&mut scene)?;
    let core = scene.add_material(glass("core", [214, 220, 228], 0.35)?);
    let sphere = scene.add_shape("core", mesh::icosphere(4)?);
    for (number, symbol) in GROUPS.into_iter().enumerate() {
        let group = PointGroup::from_geometric(symbol)?;
        let (column, row) = ((number % 3) as f64 - 1.0, 0.5 - (number / 3) as f64);
        let centre = Vector3::new(column * SPACING, 0.0, row * SPACING);
        let (at, room) = roomy(group.transformations(), RADIUS);
        let [out, aside] = frame(at.position())?;
        let piece = horn(at, out, aside, (0.55 * room).min(LARGEST))?;
        let shift = Isometry::translation(centre);
        let places = group.transformations().iter().map(|t| shift.after(t));
        add_instances(&mut scene, symbol, &piece, materials, places)?;
        let place = Placement::at(centre.to_array())?.scaled([0.62 * RADIUS; 3])?;
        scene.add_node(format!("core of {symbol}"), sphere, core, place)?;
    }
    scene.set_view(View {
        azimuth: -1.42,
        elevation: 0.2,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_group_shows_as_many_horns_as_its_order() -> Result<(), GalleryError> {
        let scene = scene()?;
        // International Tables A, table 3.2.1.3: 4/mmm, 622, 23, m-3, -43m, m-3m.
        for (symbol, order, mirrored) in [
            ("42", 16, 8),
            ("b(6)b(2)", 12, 0),
            ("b(3)b(3)", 12, 0),
            ("4b(3)", 24, 12),
            ("33", 24, 12),
            ("43", 48, 24),
        ] {
            let prefix = format!("{symbol} ");
            let nodes = scene
                .placed()
                .filter(|(node, ..)| node.name.starts_with(&prefix));
            let names: Vec<_> = nodes.map(|(_, _, material)| material.name()).collect();
            assert_eq!(names.len(), order, "{symbol}");
            let found = names.iter().filter(|name| **name == "mirrored").count();
            assert_eq!(found, mirrored, "{symbol}");
        }
        Ok(())
    }
}
