//! Decides how much of the sky a sample sees: less in corners and gaps.

use super::camera::Camera;
use super::raster::{NOTHING, Sample, Samples};
use super::shadow::{grain, spiral};
use std::f32::consts::TAU;

/// How far a thing darkens its surroundings, in units of the scene's radius.
const REACH: f32 = 0.16;

/// Neighbours looked at for each sample.
const TAPS: usize = 14;

/// How dark the deepest corner is.
const STRENGTH: f32 = 1.9;

/// The openness of every sample, from 0 to 1: a neighbour within reach that stands above the
/// sample's own plane takes away a part of its sky (screen-space ambient occlusion).
///
/// It is found for every second sample of every second row and spread to the others, because it
/// varies slowly within a surface.
pub(super) fn openness(samples: &Samples, camera: &Camera) -> Vec<f32> {
    let [across, down] = [samples.width.div_ceil(2), samples.height.div_ceil(2)];
    let mut coarse = Vec::with_capacity(across * down);
    for y in 0..down {
        for x in 0..across {
            coarse.push(openness_at(samples, camera, [2 * x, 2 * y]));
        }
    }
    let mut open = vec![1.0; samples.width * samples.height];
    for (index, open) in open.iter_mut().enumerate() {
        if let Some(here) = samples.get(index).filter(|s| s.surface != NOTHING) {
            let pixel = [index % samples.width, index / samples.width];
            *open = smoothed(samples, &coarse, across, pixel, here);
        }
    }
    open
}

fn openness_at(samples: &Samples, camera: &Camera, pixel: [usize; 2]) -> f32 {
    let visible = samples
        .at(pixel[0], pixel[1])
        .filter(|s| s.surface != NOTHING);
    let Some(here) = visible else {
        return 1.0;
    };
    let point = camera.point(pixel, here.nearness);
    // The grain of neighbours must differ, and neighbours here are two samples apart.
    let turn = TAU * grain(pixel.map(|side| side / 2));
    // A thing that fills the picture would otherwise be searched across all of it.
    let reach = (REACH * camera.focal as f32 * here.nearness).min(0.25 * samples.width as f32);
    let mut hidden = 0.0;
    for tap in 0..TAPS {
        let [dx, dy] = spiral(tap, TAPS, turn).map(|c| (c * reach).round() as isize);
        let [x, y] = [
            pixel[0].wrapping_add_signed(dx),
            pixel[1].wrapping_add_signed(dy),
        ];
        let Some(there) = samples.at(x, y).filter(|s| s.surface != NOTHING) else {
            continue;
        };
        let offset = camera.point([x, y], there.nearness) - point;
        let distance = offset.length();
        if !(1e-5..=1.5 * REACH).contains(&distance) {
            continue;
        }
        let fade = 1.0 - (distance / (1.5 * REACH)).powi(2);
        hidden += (here.normal.dot(offset) / distance - 0.12).max(0.0) * fade;
    }
    (1.0 - STRENGTH * hidden / TAPS as f32).clamp(0.15, 1.0)
}

/// The mean of the nearest nine that lie on the same surface, which also removes the grain of the
/// taps; a thing so thin that none of them hits it is taken as open.
fn smoothed(
    samples: &Samples,
    coarse: &[f32],
    across: usize,
    [x, y]: [usize; 2],
    here: Sample,
) -> f32 {
    let mut sum = 0.0;
    let mut weight = 0.0;
    for [dx, dy] in (0..9).map(|i| [i % 3 - 1, i / 3 - 1]) {
        let [column, row] = [
            (x / 2).wrapping_add_signed(dx),
            (y / 2).wrapping_add_signed(dy),
        ];
        // Also false left of the first column and above the first row, where the subtraction wraps.
        if column >= across || row >= samples.height {
            continue;
        }
        let Some(there) = samples.at(2 * column, 2 * row) else {
            continue;
        };
        let near = (there.nearness - here.nearness).abs() < 0.02 * here.nearness;
        if near && there.normal.dot(here.normal) > 0.8 {
            sum += coarse.get(row * across + column).copied().unwrap_or(1.0);
            weight += 1.0;
        }
    }
    if weight > 0.0 { sum / weight } else { 1.0 }
}
