//! Decides how the heights of triangles over a square are kept: one per cell, and the highest per block.

use glam::DVec3;

/// Blocks along each side of the square: a sixteenth of it is as far as [`HeightMap::highest_near`]
/// sees in every direction.
const BLOCKS: usize = 16;

/// The fewest and the most cells along each side of a block.
const CELLS: [usize; 2] = [16, 64];

/// The greatest height in each cell of the square from 0 to 1 in u and v.
pub(super) struct HeightMap {
    size: usize,
    heights: Vec<f32>,
    highest: Vec<f32>,
}

impl HeightMap {
    /// A map without heights, of about this many cells along each side.
    pub fn new(size: usize) -> Self {
        let size = BLOCKS * (size / BLOCKS).clamp(CELLS[0], CELLS[1]);
        Self {
            size,
            heights: vec![f32::NEG_INFINITY; size * size],
            highest: vec![f32::NEG_INFINITY; BLOCKS * BLOCKS],
        }
    }

    /// Raises the map to a triangle with corners u, v, height.
    pub fn raise(&mut self, corners: [DVec3; 3]) {
        let scale = DVec3::new(self.size as f64, self.size as f64, 1.0);
        let [a, b, c] = corners.map(|corner| corner * scale);
        let area = cross(a, b, c.x, c.y);
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let [least, greatest] = [a.min(b).min(c), a.max(b).max(c)];
        // Only cells whose middle may be inside; saturating conversion keeps them on the map.
        let cells = |low: f64, high: f64| {
            ((low - 0.5).ceil() as usize)..((high + 0.5).floor() as usize).min(self.size)
        };
        for y in cells(least.y, greatest.y) {
            for x in cells(least.x, greatest.x) {
                let [u, v] = [x as f64 + 0.5, y as f64 + 0.5];
                let weights = [cross(b, c, u, v), cross(c, a, u, v), cross(a, b, u, v)];
                let [first, second, third] = weights.map(|weight| weight / area);
                if first < 0.0 || second < 0.0 || third < 0.0 {
                    continue;
                }
                let height = (first * a.z + second * b.z + third * c.z) as f32;
                if let Some(highest) = self.heights.get_mut(y * self.size + x) {
                    *highest = highest.max(height);
                }
            }
        }
    }

    /// The same with the highest of each block and its eight neighbours, to be asked from now on.
    pub fn finished(mut self) -> Self {
        let cells = self.size / BLOCKS;
        for (row, line) in self.heights.chunks(self.size).enumerate() {
            for (column, part) in line.chunks(cells).enumerate() {
                let top = part.iter().fold(f32::NEG_INFINITY, |a, &b| a.max(b));
                let around = |middle: usize| middle.saturating_sub(1)..(middle + 2).min(BLOCKS);
                for y in around(row / cells) {
                    for x in around(column) {
                        if let Some(highest) = self.highest.get_mut(y * BLOCKS + x) {
                            *highest = highest.max(top);
                        }
                    }
                }
            }
        }
        self
    }

    /// The height of a place; minus infinity where there is none, and outside the square.
    pub fn at(&self, u: f32, v: f32) -> f32 {
        let [u, v] = [u, v].map(|side| side * self.size as f32);
        let inside = 0.0..self.size as f32;
        if inside.contains(&u) && inside.contains(&v) {
            let cell = v as usize * self.size + u as usize;
            self.heights.get(cell).copied().unwrap_or(f32::NEG_INFINITY)
        } else {
            f32::NEG_INFINITY
        }
    }

    /// At least the greatest height within a sixteenth of the square from a place; a place outside
    /// belongs to the block at the edge.
    pub fn highest_near(&self, u: f32, v: f32) -> f32 {
        let [u, v] = [u, v].map(|side| ((side * BLOCKS as f32) as usize).min(BLOCKS - 1));
        let block = v * BLOCKS + u;
        self.highest.get(block).copied().unwrap_or(f32::INFINITY)
    }
}

/// Twice the signed area of the triangle a, b, (x, y) seen from above.
fn cross(a: DVec3, b: DVec3, x: f64, y: f64) -> f64 {
    (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)
}
