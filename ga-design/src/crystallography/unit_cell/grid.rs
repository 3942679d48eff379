//! How coincident points of a periodic cell are found in constant time: bins in fractions of the
//! edges, joined across opposite faces.

use std::collections::HashMap;

use super::super::cell::Cell;

/// Bins are this many merging distances wide, so that most points look into one bin only.
const BIN_WIDTH: f64 = 8.0;

/// The most bins along an edge.
const MOST_BINS: f64 = 1e8;

/// The most points in a bin. A bin is less than half an ångström wide; without a limit hostile
/// input could make searching it take hours.
const MOST_IN_BIN: u32 = 256;

/// Points of a unit cell, and the copies merged into each.
pub struct PeriodicGrid {
    cell: Cell,
    distance: f64,
    /// The merging distance in fractions of the edges.
    reach: [f64; 3],
    bins: [i32; 3],
    /// For each bin that holds points the last of them and their number.
    heads: HashMap<[i32; 3], (usize, u32)>,
    points: Vec<Point>,
}

struct Point {
    fract: [f64; 3],
    /// The sum of the differences of the merged copies from `fract`.
    drift: [f64; 3],
    copies: u32,
    next: Option<usize>,
}

impl PeriodicGrid {
    /// An empty grid in which points closer than `distance` (ångström) coincide.
    pub fn new(cell: &Cell, distance: f64) -> Self {
        // A little more than the distance, so that rounding cannot hide a neighbour.
        let reach = cell
            .face_distances()
            .map(|face| 1.001 * distance / face + 1e-12);
        let bins = reach.map(|part| (1.0 / (BIN_WIDTH * part)).clamp(1.0, MOST_BINS) as i32);
        Self {
            cell: *cell,
            distance,
            reach,
            bins,
            heads: HashMap::new(),
            points: Vec::new(),
        }
    }

    /// Adds a point, whose index is the number of points before it; `false` when there is no
    /// room for it.
    pub fn insert(&mut self, fract: [f64; 3]) -> bool {
        let bin = [0, 1, 2]
            .map(|i| ((fract[i] * f64::from(self.bins[i])) as i32).rem_euclid(self.bins[i]));
        let before = self.heads.get(&bin).copied();
        let count = before.map_or(0, |(_, count)| count);
        if count >= MOST_IN_BIN {
            return false;
        }
        self.heads.insert(bin, (self.points.len(), count + 1));
        let next = before.map(|(last, _)| last);
        self.points.push(Point {
            fract,
            drift: [0.0; 3],
            copies: 1,
            next,
        });
        true
    }

    /// The nearest point within the merging distance that `accept` takes.
    pub fn find(&self, fract: [f64; 3], accept: impl Fn(usize) -> bool) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        let [xs, ys, zs] = [0, 1, 2].map(|i| self.bins_near(i, fract[i]));
        for x in xs {
            for y in ys.clone() {
                for z in zs.clone() {
                    let wrap = |value: i32, i: usize| value.rem_euclid(self.bins[i]);
                    let bin = [wrap(x, 0), wrap(y, 1), wrap(z, 2)];
                    let mut at = self.heads.get(&bin).map(|(last, _)| *last);
                    while let Some((index, point)) = at.and_then(|i| Some((i, self.points.get(i)?)))
                    {
                        let distance = self.length(difference(fract, point.fract));
                        let nearer = best.is_none_or(|(least, _)| distance < least);
                        if distance <= self.distance && nearer && accept(index) {
                            best = Some((distance, index));
                        }
                        at = point.next;
                    }
                }
            }
        }
        best.map(|(_, index)| index)
    }

    /// Counts a copy into a point.
    pub fn merge(&mut self, at: usize, fract: [f64; 3]) {
        if let Some(point) = self.points.get_mut(at) {
            let step = difference(fract, point.fract);
            for (sum, value) in point.drift.iter_mut().zip(step) {
                *sum += value;
            }
            point.copies = point.copies.saturating_add(1);
        }
    }

    /// The mean of a point and the copies merged into it, not reduced to the cell.
    pub fn mean(&self, at: usize) -> [f64; 3] {
        match self.points.get(at) {
            Some(point) => {
                let count = f64::from(point.copies);
                [0, 1, 2].map(|i| point.fract[i] + point.drift[i] / count)
            }
            None => [0.0; 3],
        }
    }

    /// The bins, not yet reduced to the cell, that points near `value` can lie in.
    fn bins_near(&self, i: usize, value: f64) -> std::ops::RangeInclusive<i32> {
        let count = self.bins[i];
        let low = ((value - self.reach[i]) * f64::from(count)).floor() as i32;
        let high = ((value + self.reach[i]) * f64::from(count)).floor() as i32;
        low..=high.min(low + count - 1)
    }

    fn length(&self, fract: [f64; 3]) -> f64 {
        let [x, y, z] = self.cell.cartesian(fract);
        (x * x + y * y + z * z).sqrt()
    }
}

/// From `b` to `a` by the shortest way round each edge. For points closer than half a face
/// distance, as all coincident ones are, this is the nearest periodic image.
fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        let step = a[i] - b[i];
        step - step.round()
    })
}
