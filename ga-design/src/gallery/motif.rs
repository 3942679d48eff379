//! Decides what is moved in the figures: a letter F, which no mirror leaves as it is.

use super::GalleryError;
use crate::export::{MaterialId, Scene};
use crate::mesh::{self, Ends};
use ga_cga::{Circle, DualSphere, Point};

/// The strokes of the letter in its own plane: a stem and two arms, one unit high.
const STROKES: [&[[f64; 2]]; 3] = [
    &[[0.0, 0.0], [0.0, 1.0]],
    &[[0.0, 1.0], [0.6, 1.0]],
    &[[0.0, 0.54], [0.44, 0.54]],
];

/// A letter F as points, so that versors can move it.
#[derive(Clone, Debug)]
pub(super) struct Letter {
    strokes: Vec<Vec<Point>>,
}

impl Letter {
    /// The letter with its foot here, its arms along `across` and its stem along `up`.
    pub(super) fn standing(foot: [f64; 3], across: [f64; 3], up: [f64; 3]) -> Self {
        let place = |[u, v]: [f64; 2]| {
            let [x, y, z] = std::array::from_fn(|i| foot[i] + across[i] * u + up[i] * v);
            Point::at(x, y, z)
        };
        let strokes = STROKES.iter();
        Self {
            strokes: strokes
                .map(|stroke| stroke.iter().copied().map(place).collect())
                .collect(),
        }
    }

    /// The letter with every point moved.
    pub(super) fn moved(&self, motion: impl Fn(Point) -> Point) -> Self {
        let strokes = self.strokes.iter();
        Self {
            strokes: strokes
                .map(|stroke| stroke.iter().map(|&point| motion(point)).collect())
                .collect(),
        }
    }

    /// Its points.
    pub(super) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.strokes.iter().flatten().copied()
    }

    /// The point at its foot.
    pub(super) fn foot(&self) -> Point {
        self.points()
            .next()
            .unwrap_or_else(|| Point::at(0.0, 0.0, 0.0))
    }

    /// Adds it to a scene as rods with round ends.
    pub(super) fn draw(
        &self,
        scene: &mut Scene,
        name: &str,
        material: MaterialId,
        radius: f64,
    ) -> Result<(), GalleryError> {
        let mut parts = Vec::new();
        for stroke in &self.strokes {
            let line = coordinates(stroke);
            parts.push(mesh::tube(&line, Ends::Capped, radius, 16)?);
            for &end in &line {
                parts.push(ball(end, radius)?);
            }
        }
        scene.add(name, mesh::Mesh::joined(&parts)?, material)?;
        Ok(())
    }
}

/// The coordinates of points.
pub(super) fn coordinates(points: &[Point]) -> Vec<[f64; 3]> {
    points
        .iter()
        .map(|point| point.position().to_array())
        .collect()
}

/// A sphere as a mesh of its own.
pub(super) fn ball(centre: [f64; 3], radius: f64) -> Result<mesh::Mesh, GalleryError> {
    let unit = mesh::icosphere(2)?;
    let positions = unit.positions().iter();
    let positions = positions.map(|p| std::array::from_fn(|i| centre[i] + radius * p[i]));
    Ok(mesh::Mesh::new(
        positions.collect(),
        unit.normals().to_vec(),
        unit.triangles().to_vec(),
    )?)
}

/// A line through the points as a tube.
pub(super) fn path(points: &[Point], radius: f64) -> Result<mesh::Mesh, GalleryError> {
    Ok(mesh::tube(&coordinates(points), Ends::Capped, radius, 16)?)
}

/// A circle as a ring: its centre and radius are those of the smallest sphere around it, its normal is
/// that of its plane.
pub(super) fn ring(circle: Circle, thickness: f64) -> Result<mesh::Mesh, GalleryError> {
    let carrier = circle ^ DualSphere::infinity();
    let around = circle.left_contract(carrier);
    let plane: DualSphere = carrier.dual();
    let Some((centre, square)) = around.center().zip(around.radius_squared()) else {
        return Err(GalleryError::Degenerate {
            what: "a circle that is a line",
        });
    };
    Ok(mesh::torus(
        centre.position().to_array(),
        [plane.e1, plane.e2, plane.e3],
        square.abs().sqrt(),
        thickness,
        128,
        12,
    )?)
}

/// A real sphere as a mesh of its own.
pub(super) fn shell(sphere: DualSphere) -> Result<mesh::Mesh, GalleryError> {
    let Some((centre, square)) = sphere.center().zip(sphere.radius_squared()) else {
        return Err(GalleryError::Degenerate {
            what: "a sphere that is a plane",
        });
    };
    let unit = mesh::icosphere(5)?;
    let (radius, at) = (square.abs().sqrt(), centre.position().to_array());
    let positions = unit.positions().iter();
    let positions = positions.map(|p| std::array::from_fn(|i| at[i] + radius * p[i]));
    Ok(mesh::Mesh::new(
        positions.collect(),
        unit.normals().to_vec(),
        unit.triangles().to_vec(),
    )?)
}

/// A flat polygon through corners in order, as a fan from the first.
pub(super) fn face(corners: &[Point]) -> Result<mesh::Mesh, GalleryError> {
    let count = u32::try_from(corners.len()).unwrap_or_default();
    let triangles = (2..count).map(|i| [0, i - 1, i]).collect();
    Ok(mesh::Mesh::from_triangles(coordinates(corners), triangles)?)
}
