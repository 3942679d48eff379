//! Decides what is behind the scene: a light gradient, and a floor that shows only its shadow.

use super::camera::Camera;
use super::geometry::Geometry;
use super::raster::{FLOOR, NOTHING, Samples};
use super::shade::Light;
use glam::Vec3;

const TOP: Vec3 = Vec3::new(0.955, 0.962, 0.972);
const BOTTOM: Vec3 = Vec3::new(0.80, 0.82, 0.85);

/// How far below the scene the floor is, in units of the scene's radius.
const GAP: f64 = 0.03;

/// How far from the axis a shadow is seen.
const FLOOR_REACH: f32 = 2.2;

/// Where the floor is, if the eye and the key light are above it.
pub(super) struct Backdrop {
    floor: Option<f64>,
}

impl Backdrop {
    pub fn below(geometry: &Geometry, camera: &Camera, light: &Light) -> Self {
        let lowest = geometry.points().fold(f64::INFINITY, |low, p| low.min(p.z));
        let height = lowest - GAP;
        let above = camera.eye.z > height + 0.05 && light.key.z > 0.1;
        Self {
            floor: (above && height.is_finite()).then_some(height),
        }
    }

    /// Gives the floor to every sample that shows nothing else and looks at it.
    pub fn draw_floor(&self, samples: &mut Samples, camera: &Camera) {
        let Some(height) = self.floor else {
            return;
        };
        let width = samples.width;
        for (index, sample) in samples.iter_mut().enumerate() {
            if sample.surface != NOTHING {
                continue;
            }
            let ray = camera.ray([index % width, index / width]);
            let depth = (height - camera.eye.z) / ray.z;
            let point = camera.eye + ray * depth;
            let near = point.truncate().length() < f64::from(FLOOR_REACH);
            if depth > 0.0 && depth.is_finite() && near {
                sample.nearness = (1.0 / depth) as f32;
                sample.normal = Vec3::Z;
                sample.surface = FLOOR;
            }
        }
    }

    /// The colour behind everything, by row.
    pub fn color(&self, row: usize, height: usize) -> Vec3 {
        let part = row as f32 / height.max(1) as f32;
        TOP.lerp(BOTTOM, part * part)
    }

    /// The colour of the floor: the backdrop, darkened by shadow and by what stands close.
    pub fn floor_color(&self, point: Vec3, lit: f32, open: f32, row: usize, height: usize) -> Vec3 {
        let distance = point.truncate().length() / FLOOR_REACH;
        let fade = (1.0 - distance * distance).max(0.0);
        let shadow = 0.34 * (1.0 - lit) + 0.55 * (1.0 - open);
        self.color(row, height) * (1.0 - shadow.min(0.6) * fade)
    }
}
