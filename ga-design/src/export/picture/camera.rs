//! Decides where the eye stands: in the scene's view direction, as near as the whole scene fits.

use super::geometry::Geometry;
use crate::export::View;
use glam::{DVec3, Vec3};

/// Half the height of the field of view, as a tangent: a long lens, which keeps parallels parallel.
const HALF_HEIGHT: f64 = 0.24;

/// The part of the picture that the scene fills.
const FILL: f64 = 0.86;

/// The eye's own axes — right, up, and towards the eye — for a view.
#[must_use]
pub fn axes(view: View) -> [DVec3; 3] {
    let (sine, cosine) = view.elevation.sin_cos();
    let (y, x) = view.azimuth.sin_cos();
    let towards = DVec3::new(cosine * x, cosine * y, sine);
    let right = DVec3::new(-y, x, 0.0);
    [right, towards.cross(right), towards]
}

/// A perspective camera.
pub(super) struct Camera {
    pub right: DVec3,
    pub up: DVec3,
    pub towards: DVec3,
    pub eye: DVec3,
    /// Samples per unit of slope.
    pub focal: f64,
    middle: [f64; 2],
}

impl Camera {
    /// The nearest camera in the direction of the view from which every vertex is inside the picture.
    ///
    /// A vertex at height c towards the eye and distance a from the axis is inside when
    /// a ≤ t (d − c), with d the distance of the eye and t the slope of the picture's edge. The
    /// axis is moved to the middle of what is seen, and the distance found anew, until both agree.
    pub fn framing(geometry: &Geometry, view: View, width: usize, height: usize) -> Self {
        let [right, up, towards] = axes(view);
        let [width, height] = [width as f64, height as f64];
        // A tall picture is bounded by its width.
        let focal = width.min(height) / (2.0 * HALF_HEIGHT);
        let slopes = [width, height].map(|side| FILL * side / (2.0 * focal));
        let seen = |point: DVec3| [point.dot(right), point.dot(up), point.dot(towards)];
        let mut shift = [0.0; 2];
        let mut distance = 1.0;
        for _ in 0..5 {
            distance = geometry.points().map(seen).fold(1e-3, |d: f64, [a, b, c]| {
                let across = (a - shift[0]).abs() / slopes[0];
                let along = (b - shift[1]).abs() / slopes[1];
                // Never nearer to a vertex than a fraction of the scene.
                d.max(c + across.max(along).max(0.05))
            });
            let mut least = [f64::INFINITY; 2];
            let mut greatest = [f64::NEG_INFINITY; 2];
            for [a, b, c] in geometry.points().map(seen) {
                let place = [
                    (a - shift[0]) / (distance - c),
                    (b - shift[1]) / (distance - c),
                ];
                least = [least[0].min(place[0]), least[1].min(place[1])];
                greatest = [greatest[0].max(place[0]), greatest[1].max(place[1])];
            }
            for axis in 0..2 {
                let middle = (least[axis] + greatest[axis]) / 2.0;
                if middle.is_finite() {
                    shift[axis] += middle * distance;
                }
            }
        }
        // The last shift may have pushed something out by a hair: the margin takes it.
        Self {
            right,
            up,
            towards,
            eye: right * shift[0] + up * shift[1] + towards * distance,
            focal,
            middle: [width / 2.0, height / 2.0],
        }
    }

    /// Where a point is in the picture, in samples from the top left, and the inverse of its depth.
    pub fn project(&self, point: DVec3) -> DVec3 {
        let offset = point - self.eye;
        let nearness = 1.0 / (-offset.dot(self.towards)).max(1e-6);
        DVec3::new(
            self.middle[0] + self.focal * offset.dot(self.right) * nearness,
            self.middle[1] - self.focal * offset.dot(self.up) * nearness,
            nearness,
        )
    }

    /// The direction of the ray through a sample, with length one along the axis.
    pub fn ray(&self, [x, y]: [usize; 2]) -> DVec3 {
        let right = (x as f64 + 0.5 - self.middle[0]) / self.focal;
        let up = (self.middle[1] - y as f64 - 0.5) / self.focal;
        self.right * right + self.up * up - self.towards
    }

    /// The point that a sample shows, from the inverse of its depth.
    pub fn point(&self, pixel: [usize; 2], nearness: f32) -> Vec3 {
        (self.eye + self.ray(pixel) / f64::from(nearness).max(1e-9)).as_vec3()
    }
}
