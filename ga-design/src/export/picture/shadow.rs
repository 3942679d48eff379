//! Decides what the key light reaches: a height map seen from the light, read with a soft edge.

use super::geometry::Geometry;
use super::height_map::HeightMap;
use crate::mesh::perpendicular;
use glam::{DVec3, Vec3};
use std::f32::consts::TAU;

/// Half the width of the map, in units of the scene's radius; a little more than the scene.
const REACH: f64 = 1.02;

/// Taps of each search; more are smoother.
const TAPS: usize = 12;

/// How far around a point a shadow may come from, across the map.
const SEARCH: f32 = 0.07;

/// The key light's view of the scene.
pub(super) struct ShadowMap {
    right: Vec3,
    up: Vec3,
    light: Vec3,
    heights: HeightMap,
}

impl ShadowMap {
    /// See-through things and lines cast no shadow. The map is as fine as a picture of this many
    /// samples along its longer side can show.
    pub fn cast(geometry: &Geometry, light: DVec3, samples: usize) -> Self {
        let [right, up] = perpendicular(light);
        let mut heights = HeightMap::new(samples / 2);
        for part in geometry
            .parts
            .iter()
            .filter(|part| part.look.opacity >= 1.0 && !part.look.is_line)
        {
            for (corners, _) in part.facets() {
                let placed = corners.map(|c| {
                    let [u, v] = [c.dot(right), c.dot(up)].map(across);
                    DVec3::new(u, v, c.dot(light))
                });
                heights.raise(placed);
            }
        }
        Self {
            right: right.as_vec3(),
            up: up.as_vec3(),
            light: light.as_vec3(),
            heights: heights.finished(),
        }
    }

    /// The part of the key light, from 0 to 1, that reaches a point with this normal.
    ///
    /// The farther what stands in the light, the wider the edge of its shadow; the taps are turned
    /// from sample to sample, so that their pattern becomes a fine grain that averaging removes.
    pub fn lit(&self, point: Vec3, normal: Vec3, pixel: [usize; 2]) -> f32 {
        let facing = normal.dot(self.light);
        if facing <= 0.0 {
            return 0.0;
        }
        let at = [
            point.dot(self.right),
            point.dot(self.up),
            point.dot(self.light),
        ];
        // How the surface itself rises towards the light across the map.
        let steepness = facing.max(0.15);
        let slope = [
            -normal.dot(self.right) / steepness,
            -normal.dot(self.up) / steepness,
        ];
        // Where nothing near stands high enough, as on most of a picture, there is no need to search.
        let rise = SEARCH * (slope[0].abs() + slope[1].abs());
        let [u, v] = [at[0], at[1]].map(|side| across(side.into()) as f32);
        if self.heights.highest_near(u, v) < at[2] - rise + 0.008 {
            return 1.0;
        }
        let turn = TAU * grain(pixel);
        let above = |radius: f32, tap: usize| {
            let [du, dv] = spiral(tap, TAPS, turn).map(|c| c * radius);
            let expected = at[2] + slope[0] * du + slope[1] * dv + 0.008 + 0.35 * radius;
            let width = 2.0 * REACH as f32;
            let height = self.heights.at(u + du / width, v + dv / width);
            (height > expected).then_some(height - at[2])
        };
        let blockers = (0..TAPS).filter_map(|tap| above(SEARCH, tap));
        let (count, total) = blockers.fold((0, 0.0), |(n, sum), h| (n + 1, sum + h));
        let radius = if count == 0 {
            0.006
        } else {
            (total / count as f32 * 0.11).clamp(0.006, SEARCH)
        };
        let dark = (0..TAPS)
            .filter(|&tap| above(radius, tap).is_some())
            .count();
        1.0 - dark as f32 / TAPS as f32
    }
}

/// Where a coordinate is across the map, from 0 to 1.
fn across(side: f64) -> f64 {
    (side + REACH) / (2.0 * REACH)
}

/// A fixed value from 0 to 1 for each sample, different from those around it (“interleaved gradient
/// noise”, Jiménez, SIGGRAPH 2014).
pub(super) fn grain([x, y]: [usize; 2]) -> f32 {
    (52.982_918 * (0.067_110_56 * x as f32 + 0.005_837_15 * y as f32).fract()).fract()
}

/// Tap number `tap` of `taps` that cover the unit disc evenly: Vogel's sunflower spiral.
pub(super) fn spiral(tap: usize, taps: usize, turn: f32) -> [f32; 2] {
    const GOLDEN_ANGLE: f32 = 2.399_963_1;
    let radius = ((tap as f32 + 0.5) / taps as f32).sqrt();
    let (sine, cosine) = (tap as f32 * GOLDEN_ANGLE + turn).sin_cos();
    [radius * cosine, radius * sine]
}
