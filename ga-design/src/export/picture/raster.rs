//! Decides which triangle each sample shows: the nearest, found with a depth buffer.

use super::camera::Camera;
use super::geometry::{Geometry, Look};
use glam::{DVec2, DVec3, Vec3};

/// The surface of a sample that shows none.
pub(super) const NOTHING: u32 = u32::MAX;

/// The surface of a sample that shows the floor.
pub(super) const FLOOR: u32 = u32::MAX - 1;

/// What one sample shows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The inverse of the depth; zero at infinity.
    pub nearness: f32,
    /// The unit normal, turned to the eye.
    pub normal: Vec3,
    /// The position of the part in the geometry, or [`NOTHING`] or [`FLOOR`].
    pub surface: u32,
}

/// All samples of a picture, row by row from the top.
pub(super) struct Samples {
    pub width: usize,
    pub height: usize,
    samples: Vec<Sample>,
}

impl Samples {
    pub fn new(width: usize, height: usize) -> Self {
        let empty = Sample {
            nearness: 0.0,
            normal: Vec3::Z,
            surface: NOTHING,
        };
        Self {
            width,
            height,
            samples: vec![empty; width * height],
        }
    }

    pub fn get(&self, index: usize) -> Option<Sample> {
        self.samples.get(index).copied()
    }

    pub fn at(&self, x: usize, y: usize) -> Option<Sample> {
        if x < self.width && y < self.height {
            self.get(y * self.width + x)
        } else {
            None
        }
    }

    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut Sample> {
        self.samples.iter_mut()
    }
}

/// Draws every part that hides what is behind it.
pub(super) fn draw_opaque(samples: &mut Samples, geometry: &Geometry, camera: &Camera) {
    let size = [samples.width, samples.height];
    for (number, part) in geometry.parts.iter().enumerate() {
        if part.look.opacity < 1.0 {
            continue;
        }
        let surface = number as u32;
        for (corners, normals) in part.facets() {
            fill(corners, normals, camera, size, |index, nearness, normal| {
                let sample = samples.samples.get_mut(index);
                if let Some(sample) = sample.filter(|sample| nearness > sample.nearness) {
                    *sample = Sample {
                        nearness,
                        normal,
                        surface,
                    };
                }
            });
        }
    }
}

/// Lays every see-through triangle over the colours, the farthest first.
pub(super) fn blend_transparent(
    colors: &mut [Vec3],
    samples: &Samples,
    geometry: &Geometry,
    camera: &Camera,
    shade: impl Fn(&Look, Vec3, Vec3, [usize; 2]) -> Vec3,
) {
    let mut facets = Vec::new();
    for part in geometry.parts.iter().filter(|part| part.look.opacity < 1.0) {
        for (corners, normals) in part.facets() {
            let depth = corners
                .iter()
                .map(|&c| (camera.eye - c).dot(camera.towards))
                .sum::<f64>();
            facets.push((depth, corners, normals, &part.look));
        }
    }
    facets.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (_, corners, normals, look) in facets {
        let size = [samples.width, samples.height];
        fill(corners, normals, camera, size, |index, nearness, normal| {
            let hidden = samples
                .get(index)
                .is_none_or(|s| s.nearness >= nearness && s.surface != FLOOR);
            if hidden {
                return;
            }
            let pixel = [index % samples.width, index / samples.width];
            let point = camera.point(pixel, nearness);
            // Glass looks denser where it is seen at a slant.
            let slant = 1.0
                - normal
                    .dot((camera.eye.as_vec3() - point).normalize_or_zero())
                    .abs();
            let opacity = look.opacity + (1.0 - look.opacity) * 0.35 * slant.powi(3);
            if let Some(color) = colors.get_mut(index) {
                *color = color.lerp(shade(look, point, normal, pixel), opacity);
            }
        });
    }
}

/// Calls `each` with the index, the nearness and the normal of every sample inside a triangle.
///
/// A sample is inside when it is on the inner side of all three edges; nearness is linear in the
/// picture, and other quantities divided by depth are too.
fn fill(
    corners: [DVec3; 3],
    normals: [Vec3; 3],
    camera: &Camera,
    [width, height]: [usize; 2],
    mut each: impl FnMut(usize, f32, Vec3),
) {
    let mut placed = corners.map(|corner| camera.project(corner));
    let mut normals = normals;
    let mut area = cross(placed[0], placed[1], placed[2].truncate());
    if area < 0.0 {
        placed.swap(1, 2);
        normals.swap(1, 2);
        area = -area;
    }
    if area == 0.0 || !area.is_finite() {
        return;
    }
    let least = placed[0].min(placed[1]).min(placed[2]);
    let greatest = placed[0].max(placed[1]).max(placed[2]);
    // Saturating conversion keeps all of these inside the picture.
    let [left, top] = [
        (least.x - 0.5).ceil() as usize,
        (least.y - 0.5).ceil() as usize,
    ];
    let right = ((greatest.x + 0.5).floor() as usize).min(width);
    let bottom = ((greatest.y + 0.5).floor() as usize).min(height);
    let towards_eye = |normal: Vec3, ray: DVec3| {
        if normal.dot(ray.as_vec3()) > 0.0 {
            -normal
        } else {
            normal
        }
    };
    for y in top..bottom {
        for x in left..right {
            let place = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
            let parts = [
                cross(placed[1], placed[2], place),
                cross(placed[2], placed[0], place),
                cross(placed[0], placed[1], place),
            ];
            if parts.iter().any(|&part| part < 0.0) {
                continue;
            }
            let weights = [
                parts[0] / area * placed[0].z,
                parts[1] / area * placed[1].z,
                parts[2] / area * placed[2].z,
            ];
            let nearness = weights[0] + weights[1] + weights[2];
            let normal = normals[0] * weights[0] as f32
                + normals[1] * weights[1] as f32
                + normals[2] * weights[2] as f32;
            let normal = towards_eye(normal.normalize_or(Vec3::Z), camera.ray([x, y]));
            each(y * width + x, nearness as f32, normal);
        }
    }
}

/// Twice the signed area of the triangle a, b, c in the picture.
fn cross(a: DVec3, b: DVec3, c: DVec2) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}
