//! P 4₃32 with the arcs of its screws (figure 3.6): every copy of the motif, and its way to the next along
//! the screw that replaces the rotation ab.

use super::GalleryError;
use super::horn::materials;
use super::lattice_of_horns::{Horns, frames};
use super::motif::path;
use super::palette::solid;
use crate::crystallography::overlay::add_placed_elements;
use crate::crystallography::{Cell, CellRange, Isometry, Motion, SpaceGroup, SymmetryElements};
use crate::export::{Scene, View};
use crate::mesh::Mesh;
use ga_cga::{Motor, Point, Vector3};

/// The points of an arc, less one.
const STEPS: u32 = 24;

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "screw-arcs",
        "Screw arcs of P 4₃32",
        "Space group P 4̅₃3̅2̅ (212), one cell: 24 horns, and from each the arc along which the screw \
         generator, the rotation ab joined with three quarters of an edge, carries it on. The orange \
         axes are the screws 4₃; their arcs wind to the left around all three edges, because the \
         threefold rotations carry the generator itself along.",
    );
    let missing = GalleryError::Degenerate {
        what: "the screw of the figure",
    };
    let group = SpaceGroup::standard(212).ok_or(missing)?;
    let operations = group.generate_operations()?;
    let cell = Cell::new([6.0; 3], [90.0; 3])?;
    let horns = Horns::new(&operations, cell, CellRange::UNIT, None, 0.42)?;
    let materials = materials(&mut scene)?;
    let places = horns.places()?;
    horns.draw(&mut scene, "horn", materials, &places, Vector3::default())?;
    frames(&mut scene, &cell, CellRange::UNIT, Vector3::default())?;
    let ink = scene.add_material(solid("arcs", [44, 48, 58])?);
    let arcs = arcs(&horns, &places)?;
    let arcs = arcs.iter().map(|arc| path(arc, 0.028));
    scene.add(
        "arcs",
        Mesh::joined(&arcs.collect::<Result<Vec<_>, _>>()?)?,
        ink,
    )?;
    let elements = SymmetryElements::of(&operations)?;
    let mut placed = elements.within(CellRange::UNIT)?;
    placed.axes.retain(|segment| segment.axis.order() == 4);
    add_placed_elements(&mut scene, &placed, &cell, Vector3::default())?;
    scene.set_view(View {
        azimuth: -1.2,
        elevation: 0.34,
    })?;
    Ok(scene)
}

/// The way of the horn by the screw, carried to every place: M\[S^t\[p\]\] with S^t = e^{t log S}.
fn arcs(horns: &Horns, places: &[Isometry]) -> Result<Vec<Vec<Point>>, GalleryError> {
    let screw = shortest_screw(horns, places)?;
    let way: Vec<Point> = (0..=STEPS)
        .map(|i| {
            let part: Motor = (screw * (f64::from(i) / f64::from(STEPS))).exp();
            part.apply(horns.at)
        })
        .collect();
    let carried = places
        .iter()
        .map(|place| way.iter().map(|point| place.apply(*point)).collect());
    Ok(carried.collect())
}

/// The logarithm of the quarter turn among the places that moves the horn least.
fn shortest_screw(horns: &Horns, places: &[Isometry]) -> Result<ga_cga::DualLine, GalleryError> {
    let quarter = std::f64::consts::FRAC_PI_2;
    let screws = places.iter().filter(|place| {
        matches!(place.motion(), Motion::Screw { angle, .. } if (angle - quarter).abs() < 1e-9)
    });
    let distance = |place: &&Isometry| place.apply(horns.at).distance(horns.at);
    let nearest = screws.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let logarithm = nearest.and_then(|screw| {
        let motor = screw.motor;
        if motor.s < 0.0 { -motor } else { motor }.log()
    });
    logarithm.ok_or(GalleryError::Degenerate {
        what: "the screw of the figure",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_arc_joins_two_horns_along_a_left_handed_screw() -> Result<(), GalleryError> {
        let group = SpaceGroup::standard(212).expect("a number from 1 to 230");
        let operations = group.generate_operations()?;
        let cell = Cell::new([6.0; 3], [90.0; 3])?;
        let horns = Horns::new(&operations, cell, CellRange::UNIT, None, 0.42)?;
        let places = horns.places()?;
        assert_eq!(places.len(), 24);
        let homes: Vec<Point> = places.iter().map(|place| place.apply(horns.at)).collect();
        for arc in arcs(&horns, &places)? {
            // Both ends are horns, the last one up to a lattice translation.
            for end in [arc[0], arc[STEPS as usize]] {
                let x = cell.fractional(end.position().to_array());
                let is_home = homes.iter().any(|home| {
                    let y = cell.fractional(home.position().to_array());
                    (0..3).all(|i| (x[i] - y[i] - (x[i] - y[i]).round()).abs() < 1e-9)
                });
                assert!(is_home);
            }
        }
        let screw = Isometry::from(Motor::from(shortest_screw(&horns, &places)?.exp()));
        let Motion::Screw { rise, .. } = screw.motion() else {
            panic!("a screw")
        };
        assert!(
            (rise + 1.5).abs() < 1e-9,
            "a quarter of the edge, to the left: {rise}"
        );
        Ok(())
    }
}
