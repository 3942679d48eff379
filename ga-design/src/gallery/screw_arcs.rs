//! P 4₃32 with the arcs of its screws (figure 3.6): every copy of the motif, and its way to the next along
//! the screw that replaces the rotation ab.

use super::GalleryError;
use super::horn::materials;
use super::lattice_of_horns::{Horns, frames};
use super::motif::path;
use super::palette::solid;
use crate::crystallography::overlay::{Style, add_placed_elements};
use crate::crystallography::{
    Cell, CellRange, Isometry, Motion, Operation, SpaceGroup, SymmetryElements,
};
use crate::export::{Scene, View};
use crate::mesh::Mesh;
use ga_cga::{DualLine, Motor, Point, Vector3};

/// The points of an arc, less one.
const STEPS: u32 = 24;

/// How far the horns stand from the screws that arcs are drawn of, in cell edges.
const NEAR: f64 = 0.16;

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "screw-arcs",
        "Screw arcs of P 4₃32",
        "Space group P 4̅₃3̅2̅ (212), one cell: 24 horns, and from each the arc along which the screw \
         generator, the rotation ab joined with three quarters of an edge, carries it on to the next. The \
         orange axes are the screws 4₃; the arcs wind to the left around those along all three edges, \
         because the threefold rotations carry the generator itself along.",
    );
    let group = SpaceGroup::standard(212).ok_or(MISSING)?;
    let operations = group.generate_operations()?;
    let cell = Cell::new([6.0; 3], [90.0; 3])?;
    let horns = horns(&operations, cell, CellRange::UNIT)?;
    let materials = materials(&mut scene)?;
    let places = horns.places()?;
    horns.draw(&mut scene, "horn", materials, &places, Vector3::default())?;
    frames(&mut scene, &cell, CellRange::UNIT, Vector3::default())?;
    let ink = scene.add_material(solid("arcs", [44, 48, 58])?);
    let screw = shortest_screw(&operations, cell)?;
    let arcs = arcs(screw, &horns, &places);
    let arcs = arcs.iter().map(|arc| path(arc, 0.028));
    scene.add(
        "arcs",
        Mesh::joined(&arcs.collect::<Result<Vec<_>, _>>()?)?,
        ink,
    )?;
    let elements = SymmetryElements::of(&operations)?;
    let mut placed = elements.within(CellRange::UNIT)?;
    placed.axes.retain(|segment| segment.axis.order() == 4);
    add_placed_elements(&mut scene, &placed, &cell, Style::default())?;
    scene.set_view(View {
        azimuth: -1.2,
        elevation: 0.34,
    })?;
    Ok(scene)
}

/// The horns of the figure, the first of them near a screw axis along c, where around it there is most room.
fn horns(operations: &[Operation], cell: Cell, cells: CellRange) -> Result<Horns, GalleryError> {
    let elements = SymmetryElements::of(operations)?;
    let upright = elements
        .axes()
        .iter()
        .find(|axis| axis.order() == 4 && axis.line().direction() == [0, 0, 1]);
    let [x, y, _] = upright.ok_or(MISSING)?.line().point();
    let [x, y] = [x, y].map(|part| *part.numer() as f64 / *part.denom() as f64);
    let around = (0..384).map(|i| {
        let (turn, height) = (f64::from(i % 24) / 24.0, f64::from(i / 24) / 64.0);
        let (sine, cosine) = (std::f64::consts::TAU * turn).sin_cos();
        [x + NEAR * cosine, y + NEAR * sine, height]
    });
    let (at, _) = around.fold(([x, y, 0.0], 0.0), |(best, most), at| {
        let room = room(operations, at);
        if room > most {
            (at, room)
        } else {
            (best, most)
        }
    });
    Horns::new(operations, cell, cells, Some(at), 0.42)
}

/// The distance of the nearest image in cell edges, by the shortest way round each edge.
fn room(operations: &[Operation], at: [f64; 3]) -> f64 {
    let others = operations
        .iter()
        .filter(|operation| **operation != Operation::IDENTITY);
    let distances = others.map(|operation| {
        let image = operation.apply(at);
        let step = [0, 1, 2].map(|i| (image[i] - at[i]) - (image[i] - at[i]).round());
        step.iter().map(|part| part * part).sum::<f64>().sqrt()
    });
    distances.fold(f64::INFINITY, f64::min)
}

const MISSING: GalleryError = GalleryError::Degenerate {
    what: "the screw of the figure",
};

/// The way of the horn by the screw, carried to every place: M\[S^t\[p\]\] with S^t = e^{t log S}.
fn arcs(logarithm: DualLine, horns: &Horns, places: &[Isometry]) -> Vec<Vec<Point>> {
    let way: Vec<Point> = (0..=STEPS)
        .map(|i| {
            let part: Motor = (logarithm * (f64::from(i) / f64::from(STEPS))).exp();
            part.apply(horns.at)
        })
        .collect();
    let carried = places
        .iter()
        .map(|place| way.iter().map(|point| place.apply(*point)).collect());
    carried.collect()
}

/// The logarithm of the quarter turn of the group that moves the horn least.
fn shortest_screw(operations: &[Operation], cell: Cell) -> Result<DualLine, GalleryError> {
    let horns = horns(operations, cell, "-1:2".parse()?)?;
    let quarter = std::f64::consts::FRAC_PI_2;
    let places = horns.places()?;
    let screws = places.iter().filter(|place| {
        matches!(place.motion(), Motion::Screw { angle, .. } if (angle - quarter).abs() < 1e-9)
    });
    let distance = |place: &&Isometry| place.apply(horns.at).distance(horns.at);
    let nearest = screws.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let logarithm = nearest.and_then(|screw| {
        let motor = screw.motor;
        if motor.s < 0.0 { -motor } else { motor }.log()
    });
    logarithm.ok_or(MISSING)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_arc_joins_two_horns_along_a_left_handed_screw() -> Result<(), GalleryError> {
        let group = SpaceGroup::standard(212).expect("a number from 1 to 230");
        let operations = group.generate_operations()?;
        let cell = Cell::new([6.0; 3], [90.0; 3])?;
        let horns = horns(&operations, cell, CellRange::UNIT)?;
        let screw = shortest_screw(&operations, cell)?;
        let places = horns.places()?;
        assert_eq!(places.len(), 24);
        let homes: Vec<Point> = places.iter().map(|place| place.apply(horns.at)).collect();
        for arc in arcs(screw, &horns, &places) {
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
        let screw = Isometry::from(screw.exp());
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
