//! Five tetragonal space groups (figure 3.4): one rotation, as it is, with a mirror, and as a screw of
//! either hand.

use super::GalleryError;
use super::horn::materials;
use super::lattice_of_horns::{Horns, frames};
use crate::crystallography::overlay::{Style, add_placed_elements};
use crate::crystallography::{Cell, CellRange, SpaceGroup, SymmetryElements};
use crate::export::{Scene, View};
use ga_cga::Vector3;

/// The numbers of the groups, in the order of the figure.
const GROUPS: [u32; 5] = [83, 91, 89, 84, 95];

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "tetragonal",
        "Five tetragonal space groups",
        "Above P 4̅2 (P 4/m), P 4̅₁2̅ (P 4₁22), P 4̅2̅ (P 422), below P 4̅₂2 (P 4₂/m), P 4̅₃2̅ (P 4₃22): one cell \
         of each with its fourfold axes. The word ab is a quarter turn; joined with a quarter, a half or \
         three quarters of the edge c it becomes the screw 4₁, 4₂ or 4₃. The threads along the axes climb \
         to the right for 4₁, to the left for 4₃; 4₂ has two.",
    );
    let materials = materials(&mut scene)?;
    let cells = CellRange::UNIT;
    for (place, number) in GROUPS.into_iter().enumerate() {
        let missing = GalleryError::Degenerate {
            what: "a space group of the figure",
        };
        let group = SpaceGroup::standard(number).ok_or(missing)?;
        let cell = Cell::new([2.9, 2.9, 4.2], [90.0; 3])?;
        let operations = group.generate_operations()?;
        // Three above, two below in the gaps.
        let (column, row) = match place {
            0..3 => (place as f64, 0.0),
            _ => (place as f64 - 2.5, -1.0),
        };
        let origin = Vector3::new(4.7 * column, 0.0, 5.6 * row);
        let horns = Horns::new(&operations, cell, cells, None, 0.46)?;
        horns.draw(
            &mut scene,
            group.symbol,
            materials,
            &horns.places()?,
            origin,
        )?;
        frames(&mut scene, &cell, cells, origin)?;
        let elements = SymmetryElements::of(&operations)?;
        let mut placed = elements.within(cells)?;
        placed.axes.retain(|segment| {
            segment.axis.order() == 4 && segment.axis.line().direction() == [0, 0, 1]
        });
        placed.planes.clear();
        placed.centres.clear();
        let style = Style {
            origin,
            boldness: 2.2,
        };
        add_placed_elements(&mut scene, &placed, &cell, style)?;
    }
    scene.set_view(View {
        azimuth: -1.3,
        elevation: 0.22,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crystallography::SpaceGroupGenerators;

    #[test]
    fn the_symbols_of_the_caption_are_those_of_the_groups() -> Result<(), GalleryError> {
        let geometric = [
            "P b(4)2",
            "P b(4)_1 b(2)",
            "P b(4)b(2)",
            "P b(4)_2 2",
            "P b(4)_3 b(2)",
        ];
        let international = ["P 4/m", "P 41 2 2", "P 4 2 2", "P 42/m", "P 43 2 2"];
        let screws = [0, 1, 0, 2, 3];
        for (place, number) in GROUPS.into_iter().enumerate() {
            let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
            assert_eq!(group.symbol, international[place]);
            let same = SpaceGroupGenerators::from_symbol(geometric[place]).expect("a symbol");
            assert_eq!(same.number, number, "{}", geometric[place]);
            let elements = SymmetryElements::of(&group.generate_operations()?)?;
            let mut fourfold = elements.axes().iter().filter(|axis| axis.order() == 4);
            assert!(
                fourfold.all(|axis| axis.screw() == screws[place]),
                "{number}"
            );
        }
        Ok(())
    }
}
