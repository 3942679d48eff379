//! A Miura pattern folding up, with the network of circles that it is constructed by (figures 2.18,
//! 2.19).

use super::GalleryError;
use super::motif::{face, ring};
use super::palette::{SLATE, between, course, solid};
use crate::export::{Scene, View};
use crate::folding::{FoldedSheet, Miura};
use crate::mesh::Mesh;
use ga_cga::{Bivector3, Circle, DualPlane, DualSphere, Motor, Rotor, Translator, Vector3};

/// The inclinations of the panels, from flat to nearly closed.
const INCLINATIONS: [f64; 4] = [0.0, 0.5, 0.95, 1.3];

/// The lengths of the edges, the angle between them, and the number of panels.
const STRAIGHT: f64 = 1.0;
const ZIGZAG: f64 = 1.1;
const ANGLE: f64 = 1.1;
const PANELS: [usize; 2] = [6, 6];

fn pattern() -> Result<Miura, GalleryError> {
    Ok(Miura::new(STRAIGHT, ZIGZAG, ANGLE, PANELS)?)
}

/// The motor that lays a sheet down: its first corner goes to a place, the corners that are two
/// steps away from it into the directions x and y.
fn laid_down(sheet: &FoldedSheet, place: Vector3) -> Option<Motor> {
    let origin = sheet.corner([0, 0])?.position();
    let along = sheet.corner([0, 2])?.position() - origin;
    let across = sheet.corner([2, 0])?.position() - origin;
    let (x, y) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    let first = Rotor::between_in(along, x, Bivector3::new(1.0, 0.0, 0.0))?;
    let second = Rotor::between_in(first.apply(across), y, Bivector3::new(0.0, 0.0, 1.0))?;
    Some(Translator::by(place) * (second * first) * Translator::by(-origin))
}

/// The sheets in two rows of two, each with the motor that lays it there.
fn sheets() -> Result<Vec<(FoldedSheet, Motor)>, GalleryError> {
    let places = [[0.0, 0.0], [9.0, 0.0], [1.2, -9.2], [9.6, -8.4]];
    let mut sheets = Vec::new();
    for (inclination, [x, y]) in INCLINATIONS.into_iter().zip(places) {
        let sheet = pattern()?.fold(inclination)?;
        let motor = laid_down(&sheet, Vector3::new(x, y, 0.0));
        let motor = motor.ok_or(GalleryError::Degenerate {
            what: "the frame of a folded sheet",
        })?;
        sheets.push((sheet, motor));
    }
    Ok(sheets)
}

/// The circles in which the spheres about a corner, through its neighbours, cut the paper.
fn network(sheet: &FoldedSheet, motor: Motor) -> Vec<Circle> {
    let paper = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.0);
    let mut circles = Vec::new();
    for row in sheet.rows() {
        for &corner in row {
            for length in [STRAIGHT, ZIGZAG] {
                let sphere = DualSphere::about(motor.apply(corner), length * length);
                circles.push((sphere ^ paper).undual());
            }
        }
    }
    circles
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "miura",
        "A Miura pattern folds",
        "One pattern of parallelograms, flat and folded further and further. Each corner is found where \
         three spheres about its neighbours meet, so that all edges keep their length; the circles on \
         the flat sheet are those spheres, cut by the paper. One degree of freedom moves it all.",
    );
    for (number, (sheet, motor)) in sheets()?.into_iter().enumerate() {
        let part = number as f64 / (INCLINATIONS.len() - 1) as f64;
        let color = course(part);
        let shades = [
            between(color, [255; 3], 0.15),
            between(color, [255; 3], 0.5),
        ];
        for (parity, shade) in shades.into_iter().enumerate() {
            let name = format!("sheet {number} {parity}");
            let panels = sheet.panels().enumerate();
            let panels = panels.filter(|(i, _)| (i / PANELS[1] + i % PANELS[1]) % 2 == parity);
            let faces = panels.map(|(_, corners)| face(&corners.map(|p| motor.apply(p))));
            let faces = faces.collect::<Result<Vec<Mesh>, _>>()?;
            let material = scene.add_material(solid(&name, shade)?);
            scene.add(&name, Mesh::joined(&faces)?, material)?;
        }
        if number == 0 {
            let rings = network(&sheet, motor);
            let rings = rings.into_iter().map(|circle| ring(circle, 0.014));
            let rings = rings.collect::<Result<Vec<Mesh>, _>>()?;
            let slate = scene.add_material(solid("network", SLATE)?);
            scene.add("network", Mesh::joined(&rings)?, slate)?;
        }
    }
    scene.set_view(View {
        azimuth: -1.45,
        elevation: 0.85,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ga_cga::Point;

    #[test]
    fn every_edge_keeps_its_length() -> Result<(), GalleryError> {
        for (sheet, motor) in sheets()? {
            for corners in sheet.panels() {
                let [a, b, c, d] = corners.map(|corner| motor.apply(corner));
                for (from, to, length) in [
                    (a, b, ZIGZAG),
                    (b, c, STRAIGHT),
                    (c, d, ZIGZAG),
                    (d, a, STRAIGHT),
                ] {
                    assert!((from.distance(to) - length).abs() < 1e-9);
                }
            }
        }
        Ok(())
    }

    #[test]
    fn the_neighbours_of_a_corner_are_on_its_circles() -> Result<(), GalleryError> {
        let (sheet, motor) = sheets()?.remove(0);
        let circles = network(&sheet, motor);
        let beside = |place: [usize; 2]| {
            let corner = sheet.corner(place);
            motor.apply(corner.unwrap_or_else(|| Point::at(f64::NAN, 0.0, 0.0)))
        };
        // The circles of the first corner reach ahead and aside.
        assert!((beside([1, 0]) ^ circles[0]).norm() < 1e-12);
        assert!((beside([0, 1]) ^ circles[1]).norm() < 1e-12);
        Ok(())
    }
}
