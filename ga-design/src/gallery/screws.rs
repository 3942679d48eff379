//! The screws of P 2₁2₁2₁ (figure 3.5): three families of axes that never meet.

use super::GalleryError;
use super::lattice_of_horns::{Horns, frames};
use super::palette::{YELLOW, solid};
use crate::crystallography::overlay::{Shown, add_symmetry_elements};
use crate::crystallography::{Cell, CellRange, SpaceGroup, SymmetryElements};
use crate::export::{Scene, View};
use ga_cga::Vector3;

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "screws",
        "Screws of P 2₁2₁2₁",
        "Space group P 2̅₁2̅₁2̅₁ (19), one cell. Half turns joined with half an edge along each of the three \
         edges; the axes pass each other at a quarter of an edge, so that nothing stays in place and \
         every horn is one of four.",
    );
    let missing = GalleryError::Degenerate {
        what: "a space group of the figure",
    };
    let group = SpaceGroup::standard(19).ok_or(missing)?;
    let operations = group.generate_operations()?;
    let cell = Cell::new([3.6, 4.3, 5.0], [90.0; 3])?;
    let horns = Horns::new(&operations, cell, CellRange::UNIT, None, 0.8)?;
    // All are turned; blue is for the axes here.
    let yellow = scene.add_material(solid("turned", YELLOW)?);
    let places = horns.places()?;
    horns.draw(&mut scene, "horn", [yellow; 2], &places, Vector3::default())?;
    frames(&mut scene, &cell, CellRange::UNIT, Vector3::default())?;
    let elements = SymmetryElements::of(&operations)?;
    add_symmetry_elements(
        &mut scene,
        &elements,
        &cell,
        CellRange::UNIT,
        Shown::default(),
    )?;
    scene.set_view(View {
        azimuth: -1.18,
        elevation: 0.26,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_screws_meet() -> Result<(), GalleryError> {
        let group = SpaceGroup::standard(19).expect("a number from 1 to 230");
        let elements = SymmetryElements::of(&group.generate_operations()?)?;
        let cell = Cell::new([3.6, 4.3, 5.0], [90.0; 3])?;
        let placed = elements.within(CellRange::UNIT)?;
        let lines: Vec<_> = placed
            .axes
            .iter()
            .map(|segment| {
                let [from, to] = segment.ends.map(|end| {
                    let [x, y, z] = cell.cartesian(end);
                    ga_cga::Point::at(x, y, z)
                });
                ga_cga::Line::through(from, to).expect("of some length")
            })
            .collect();
        for (i, one) in lines.iter().enumerate() {
            for other in &lines[i + 1..] {
                let near = ga_cga::incidence::nearest_points(*one, *other);
                let (p, q) = near.expect("lines have points");
                assert!(p.distance(q) > 0.89, "{}", p.distance(q));
            }
        }
        Ok(())
    }
}
