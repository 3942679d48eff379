//! The six screws P 6ₛ22, s = 0 … 5 (Table 3.5): twelve horns per cell around one axis.

use super::GalleryError;
use super::horn::materials;
use super::lattice_of_horns::Horns;
use super::motif::path;
use super::palette::solid;
use crate::crystallography::overlay::{Style, add_placed_elements};
use crate::crystallography::{Cell, CellRange, Isometry, SpaceGroup, SymmetryElements};
use crate::export::{Scene, View};
use crate::mesh::{self, Mesh};
use ga_cga::{DualLine, Motor, Point, Vector3};
use std::f64::consts::TAU;

/// The numbers of the groups P 622, P 6₁22, P 6₂22, P 6₃22, P 6₄22, P 6₅22.
const GROUPS: [u32; 6] = [177, 178, 180, 182, 181, 179];

/// The edges a and c.
const EDGES: [f64; 2] = [4.6, 8.0];

/// The points of an arc, less one.
const STEPS: u32 = 24;

/// Where the first horn stands, in fractions of the edges.
const START: [f64; 3] = [0.34, 0.1, 1.0 / 24.0];

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "hexagonal-screws",
        "P 6ₛ22 for s from 0 to 5",
        "Space groups P 6̅ₛ2̅ with s = 0, 1, 2 above (P 622, P 6₁22, P 6₂22) and 3, 4, 5 below \
         (P 6₃22, P 6₄22, P 6₅22): the horns around one axis, as high as one cell, and their ways \
         by the screw. Sixty degrees come with a rise \
         of s sixths of the edge c; 6₁ and 6₅, 6₂ and 6₄ are mirror images, and 6₃ is its own.",
    );
    let materials = materials(&mut scene)?;
    let disc = scene.add_material(solid("ends of the cell", [196, 202, 210])?);
    let ink = scene.add_material(solid("arcs", [44, 48, 58])?);
    for (place, number) in GROUPS.into_iter().enumerate() {
        let (column, row) = ((place % 3) as f64, -((place / 3) as f64));
        let origin = Vector3::new(5.6 * column, 0.0, 9.6 * row);
        let (horns, places) = around_the_axis(number)?;
        let name = format!("6_{place}");
        horns.draw(&mut scene, &name, materials, &places, origin)?;
        let elements = SymmetryElements::of(&operations(number)?)?;
        let mut placed = elements.within(CellRange::UNIT)?;
        placed.axes.retain(|segment| {
            let [[x, y, _], _] = segment.ends;
            segment.axis.order() == 6 && x.abs() + y.abs() < 1e-6
        });
        let style = Style {
            origin,
            boldness: 2.8,
        };
        add_placed_elements(&mut scene, &placed, &horns.cell, style)?;
        let arcs = arcs(place, &horns, &places)?;
        let arcs = arcs.iter().map(|arc| {
            let moved = arc
                .iter()
                .map(|point| Point::from(point.position() + origin));
            path(&moved.collect::<Vec<_>>(), 0.035)
        });
        let arcs = arcs.collect::<Result<Vec<_>, _>>()?;
        scene.add(&format!("arcs of {name}"), Mesh::joined(&arcs)?, ink)?;
        for height in [0.0, EDGES[1]] {
            let centre = (origin + Vector3::new(0.0, 0.0, height)).to_array();
            let ring = mesh::torus(centre, [0.0, 0.0, 1.0], 1.95, 0.04, 96, 8)?;
            scene.add("end of the cell", ring, disc)?;
        }
    }
    scene.set_view(View {
        azimuth: -1.45,
        elevation: 0.26,
    })?;
    Ok(scene)
}

fn operations(number: u32) -> Result<Vec<crate::crystallography::Operation>, GalleryError> {
    let missing = GalleryError::Degenerate {
        what: "a space group of the figure",
    };
    let group = SpaceGroup::standard(number).ok_or(missing)?;
    Ok(group.generate_operations()?)
}

/// The horns of a group around the axis through the origin, in one cell along it.
fn around_the_axis(number: u32) -> Result<(Horns, Vec<Isometry>), GalleryError> {
    let [a, c] = EDGES;
    let cell = Cell::new([a, a, c], [90.0, 90.0, 120.0])?;
    let cells: CellRange = "-1:1x-1:1x0:1".parse()?;
    let horns = Horns::new(&operations(number)?, cell, cells, Some(START), 0.5)?;
    let mut places = horns.places()?;
    let reach = from_axis(&horns.at.position()) + 1e-6;
    places.retain(|place| from_axis(&place.apply(horns.at).position()) < reach);
    Ok((horns, places))
}

/// The ways of the horns by the screw, as far as they are within the cell: by s sixths of c up, or down by
/// the rest where that is nearer.
fn arcs(screw: usize, horns: &Horns, places: &[Isometry]) -> Result<Vec<Vec<Point>>, GalleryError> {
    let [_, c] = EDGES;
    let sixths = if screw <= 3 {
        screw as f64
    } else {
        screw as f64 - 6.0
    };
    let axis = DualLine::along(Point::at(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
    let mut arcs = Vec::new();
    for place in places {
        let mut arc = Vec::new();
        for step in 0..=STEPS {
            let part = f64::from(step) / f64::from(STEPS);
            let motor = Motor::screw(axis, part * TAU / 6.0, part * sixths * c / 6.0);
            let motor = motor.ok_or(GalleryError::Degenerate {
                what: "the screw of the figure",
            })?;
            let point: Point = motor.apply(place.apply(horns.at));
            if (-1e-9..=c + 1e-9).contains(&point.position().e3) {
                arc.push(point);
            }
        }
        if arc.len() > 1 {
            arcs.push(arc);
        }
    }
    Ok(arcs)
}

fn from_axis(position: &Vector3) -> f64 {
    position.e1.hypot(position.e2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twelve_horns_stand_around_every_axis() -> Result<(), GalleryError> {
        for (screw, number) in GROUPS.into_iter().enumerate() {
            let (_, places) = around_the_axis(number)?;
            assert_eq!(places.len(), 12, "{number}");
            assert!(places.iter().all(Isometry::is_proper));
            let elements = SymmetryElements::of(&operations(number)?)?;
            let mut sixfold = elements.axes().iter().filter(|axis| axis.order() == 6);
            assert!(
                sixfold.all(|axis| usize::from(axis.screw()) == screw),
                "{number}"
            );
        }
        Ok(())
    }
}
