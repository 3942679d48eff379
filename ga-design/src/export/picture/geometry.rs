//! Decides what the renderer sees of a scene: placed triangles, moved and scaled into the unit ball.

use crate::export::{Material, Scene, flatten};
use crate::mesh::{self, Ends, tube};
use glam::{DVec3, Vec3};

/// The radius of the rod that stands for a line, where the scene has radius one.
const LINE_RADIUS: f64 = 0.0045;

/// How something looks, in the numbers that shading needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    pub color: Vec3,
    pub roughness: f32,
    pub metallic: f32,
    pub opacity: f32,
    pub is_line: bool,
}

impl Look {
    fn of(material: &Material, is_line: bool) -> Self {
        Self {
            color: Vec3::from(material.linear_color().map(|c| c as f32)),
            roughness: material.roughness() as f32,
            metallic: material.metallic() as f32,
            opacity: material.opacity() as f32,
            is_line,
        }
    }
}

/// One thing to draw.
pub(super) struct Part {
    pub positions: Vec<DVec3>,
    pub normals: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    pub look: Look,
}

impl Part {
    /// The corners of each triangle with their normals.
    pub fn facets(&self) -> impl Iterator<Item = ([DVec3; 3], [Vec3; 3])> {
        self.triangles.iter().map(|triangle| {
            let corners = triangle.map(|i| self.positions.get(i as usize).copied());
            let normals = triangle.map(|i| self.normals.get(i as usize).copied());
            (
                corners.map(Option::unwrap_or_default),
                normals.map(|n| n.unwrap_or(Vec3::Z)),
            )
        })
    }
}

/// Everything to draw, centred, and of radius one at most.
pub(super) struct Geometry {
    pub parts: Vec<Part>,
}

impl Geometry {
    pub fn of(scene: &Scene) -> Self {
        let (centre, radius) = ball(scene);
        let normalised = |point: [f64; 3]| (DVec3::from(point) - centre) / radius;
        let mut parts = Vec::new();
        for surface in flatten::surfaces(scene) {
            parts.push(Part {
                positions: surface.positions.into_iter().map(normalised).collect(),
                normals: surface.normals.into_iter().map(to_single).collect(),
                triangles: surface.triangles.to_vec(),
                look: Look::of(surface.material, false),
            });
        }
        for line in flatten::lines(scene) {
            let points: Vec<_> = line
                .points
                .into_iter()
                .map(|p| normalised(p).to_array())
                .collect();
            let ends = if line.closed {
                Ends::Closed
            } else {
                Ends::Capped
            };
            let rod = tube(&points, ends, LINE_RADIUS, 8)
                .or_else(|_| tube(&points, Ends::Capped, LINE_RADIUS, 8));
            // A line all of whose points coincide has no direction and shows nothing.
            let Ok(rod) = rod else { continue };
            parts.push(Part {
                positions: rod.positions().iter().map(|&p| DVec3::from(p)).collect(),
                normals: rod.normals().iter().map(|&n| to_single(n)).collect(),
                triangles: rod.triangles().to_vec(),
                look: Look::of(line.material, true),
            });
        }
        Self { parts }
    }

    pub fn look_of(&self, surface: u32) -> Option<&Look> {
        self.parts.get(surface as usize).map(|part| &part.look)
    }

    pub fn points(&self) -> impl Iterator<Item = DVec3> {
        self.parts
            .iter()
            .flat_map(|part| part.positions.iter().copied())
    }
}

/// Centre and radius of the ball around the bounding box.
fn ball(scene: &Scene) -> (DVec3, f64) {
    let points = scene.placed().flat_map(|(node, shape, _)| {
        let points = shape.points().iter();
        points.map(|&point| DVec3::from(node.placement.apply(point)))
    });
    let [least, greatest] = mesh::bounds(points).unwrap_or_default().map(DVec3::from);
    let diagonal = greatest - least;
    let radius = diagonal.length() / 2.0;
    // A scene without extent is a dot in the middle of the picture.
    let radius = if radius > 0.0 { radius } else { 1.0 };
    (least + diagonal / 2.0, radius)
}

fn to_single(vector: [f64; 3]) -> Vec3 {
    DVec3::from(vector).as_vec3()
}
