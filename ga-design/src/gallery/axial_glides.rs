//! A lattice with mirrors and with axial glides in their place (figure 3.3): what a translator joined to
//! one reflection does.

use super::GalleryError;
use super::horn::materials;
use super::lattice_of_horns::{Horns, frames};
use crate::crystallography::overlay::{Style, add_placed_elements};
use crate::crystallography::{Cell, CellRange, Operation, SymmetryElements, close};
use crate::export::{Scene, View};
use ga_cga::Vector3;

/// The groups by what the mirror a becomes: itself, a glide along b, a glide along c. The mirrors b and c
/// stay, and go through the same point.
const GROUPS: [(&str, &str); 3] = [
    ("P m m m", "-x,y,z"),
    ("P b m m", "-x,y+1/2,z"),
    ("P c m m", "-x,y,z+1/2"),
];

const CELLS: &str = "1x2x2";

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "axial-glides",
        "Mirror, b-glide, c-glide",
        "The group 22 on a primitive lattice, and what becomes of it when the mirror across a (slate, \
         left) is joined with half of the edge b (middle) or of the edge c (right): the yellow planes \
         mirror and shift along their arrows. Space groups P m m m, P b m m, P c m m; two by two cells \
         of each, all their other operations shown by the horns only.",
    );
    let materials = materials(&mut scene)?;
    let cells: CellRange = CELLS.parse()?;
    for (number, (symbol, glide)) in GROUPS.into_iter().enumerate() {
        let operations = operations(glide)?;
        let cell = Cell::new([3.4, 2.6, 2.9], [90.0; 3])?;
        let origin = Vector3::new(4.6 * number as f64, 0.0, 0.0);
        let horns = Horns::new(&operations, cell, cells, Some([0.24, 0.23, 0.26]), 0.5)?;
        horns.draw(&mut scene, symbol, materials, &horns.places()?, origin)?;
        frames(&mut scene, &cell, cells, origin)?;
        let across = SymmetryElements::of(&across_a(&operations))?;
        let placed = across.within(cells)?;
        let style = Style {
            origin,
            boldness: 2.0,
        };
        add_placed_elements(&mut scene, &placed, &cell, style)?;
    }
    scene.set_view(View {
        azimuth: -1.2,
        elevation: 0.34,
    })?;
    Ok(scene)
}

/// All operations of the group that a joined mirror generates with the mirrors b and c.
fn operations(joined: &str) -> Result<Vec<Operation>, GalleryError> {
    let mut generators = Vec::new();
    for text in [joined, "x,-y,z", "x,y,-z"] {
        let generator: Operation = text.parse().map_err(|_| MISSING)?;
        generators.push(generator);
    }
    close(&generators).map_err(|_| MISSING)
}

const MISSING: GalleryError = GalleryError::Degenerate {
    what: "a space group of the figure",
};

/// The identity and the reflections across a.
fn across_a(operations: &[Operation]) -> Vec<Operation> {
    let mirror = [[-1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let kept = operations
        .iter()
        .filter(|operation| operation.is_translation() || operation.rotation() == mirror);
    kept.copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_planes_across_a_are_a_mirror_a_b_glide_and_a_c_glide() -> Result<(), GalleryError> {
        for ((symbol, joined), letter) in GROUPS.into_iter().zip(['m', 'b', 'c']) {
            let all = operations(joined)?;
            assert_eq!(all.len(), 8, "{symbol}");
            let elements = SymmetryElements::of(&across_a(&all))?;
            let letters: Vec<_> = elements.planes().iter().map(|p| p.letter()).collect();
            assert_eq!(letters, [letter; 2], "{symbol}");
        }
        Ok(())
    }
}
