//! How all pairs of nearby atoms of a periodic cell are found in time proportional to their number:
//! bins at least as wide as the search is far, in fractions of the edges.

use super::super::Cell;
use super::{Bond, BondError};

/// The most distances that are computed for each atom. Close packing needs some hundreds; without
/// a limit hostile input could make the search take hours.
const MOST_PER_ATOM: u64 = 5_000;

/// As much may be computed whatever the number of atoms.
const FREE_DISTANCES: u64 = 10_000_000;

/// The most bins along an edge that a search looks into on either side.
const MOST_STEPS: f64 = 64.0;

/// Fractions beyond this cannot be reduced to the cell without losing their digits.
const FARTHEST: f64 = 1e6;

/// Points of a periodic cell, sorted into bins.
pub struct Neighbourhood {
    cell: Cell,
    reach: f64,
    /// The positions as given, in fractions.
    positions: Vec<[f64; 3]>,
    /// The cell in which each position lies.
    floors: Vec<[i32; 3]>,
    bins: [i32; 3],
    /// How many bins away a point within reach can be.
    steps: [i32; 3],
    /// Where the points of each bin begin in `members`, and the end.
    starts: Vec<usize>,
    members: Vec<usize>,
}

impl Neighbourhood {
    /// Sorts points, given in fractions of the edges, for a search up to `reach` ångström.
    pub fn new(cell: Cell, positions: &[[f64; 3]], reach: f64) -> Result<Self, BondError> {
        let faces = cell.face_distances();
        let mut bins = faces.map(|face| (face / reach).floor().clamp(1.0, 1e6));
        // No more bins than memory for the points themselves.
        let most = 4.0 * positions.len() as f64 + 64.0;
        while bins.iter().product::<f64>() > most {
            let largest = bins.iter().copied().fold(1.0, f64::max);
            bins = bins.map(|count| {
                if count == largest {
                    (count / 2.0).ceil()
                } else {
                    count
                }
            });
        }
        let steps = [0, 1, 2].map(|i| (reach * bins[i] / faces[i]).ceil());
        if steps.iter().any(|step| step.is_nan() || *step > MOST_STEPS) {
            return Err(BondError::Crowded);
        }
        let mut made = Self {
            cell,
            reach,
            positions: positions.to_vec(),
            floors: Vec::with_capacity(positions.len()),
            bins: bins.map(|count| count as i32),
            steps: steps.map(|step| step as i32),
            starts: Vec::new(),
            members: vec![0; positions.len()],
        };
        let mut homes = Vec::with_capacity(positions.len());
        for (at, fract) in positions.iter().enumerate() {
            if !fract.iter().all(|value| value.abs() <= FARTHEST) {
                return Err(BondError::Place(at));
            }
            made.floors.push(fract.map(|value| value.floor() as i32));
            homes.push(made.number(made.bin(*fract)));
        }
        made.sort(&homes);
        Ok(made)
    }

    /// A counting sort of the points by their bins.
    fn sort(&mut self, homes: &[usize]) {
        let count = self.bins.iter().map(|n| *n as usize).product::<usize>();
        let mut starts = vec![0; count + 1];
        for home in homes {
            if let Some(next) = starts.get_mut(home + 1) {
                *next += 1;
            }
        }
        for at in 1..starts.len() {
            starts[at] += starts[at - 1];
        }
        let mut free = starts.clone();
        for (point, home) in homes.iter().enumerate() {
            if let Some(place) = free.get_mut(*home) {
                if let Some(member) = self.members.get_mut(*place) {
                    *member = point;
                }
                *place += 1;
            }
        }
        self.starts = starts;
    }

    fn bin(&self, fract: [f64; 3]) -> [i32; 3] {
        [0, 1, 2].map(|i| {
            let inside = fract[i] - fract[i].floor();
            ((inside * f64::from(self.bins[i])) as i32).min(self.bins[i] - 1)
        })
    }

    fn number(&self, [x, y, z]: [i32; 3]) -> usize {
        ((x * self.bins[1] + y) as usize) * self.bins[2] as usize + z as usize
    }

    fn members(&self, bin: [i32; 3]) -> &[usize] {
        let number = self.number(bin);
        match (self.starts.get(number), self.starts.get(number + 1)) {
            (Some(from), Some(to)) => self.members.get(*from..*to).unwrap_or_default(),
            _ => &[],
        }
    }

    /// Calls `take` for every pair of points within reach, each pair once, first points in order.
    pub fn pairs(&self, mut take: impl FnMut(Bond)) -> Result<(), BondError> {
        let mut left = FREE_DISTANCES + MOST_PER_ATOM * self.positions.len() as u64;
        for (one, fract) in self.positions.iter().enumerate() {
            let home = self.bin(*fract);
            let ranges = self.steps.map(|step| -step..=step);
            let [xs, ys, zs] = ranges;
            for x in xs {
                for y in ys.clone() {
                    for z in zs.clone() {
                        let far = [home[0] + x, home[1] + y, home[2] + z];
                        let bin = [0, 1, 2].map(|i| far[i].rem_euclid(self.bins[i]));
                        let turns = [0, 1, 2].map(|i| far[i].div_euclid(self.bins[i]));
                        let others = self.members(bin);
                        left = left
                            .checked_sub(1 + others.len() as u64)
                            .ok_or(BondError::Crowded)?;
                        for &other in others {
                            if let Some(bond) = self.pair(one, other, turns) {
                                take(bond);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// The pair, where it is within reach and not counted from its other end.
    fn pair(&self, one: usize, other: usize, turns: [i32; 3]) -> Option<Bond> {
        if other < one || (other == one && turns <= [0; 3]) {
            return None;
        }
        let (from, to) = (self.floors.get(one)?, self.floors.get(other)?);
        let image = [0, 1, 2].map(|i| turns[i] + from[i] - to[i]);
        let length = self.distance(one, other, image);
        (length <= self.reach).then_some(Bond {
            atoms: [one, other],
            image,
            length,
        })
    }

    /// The distance from a point to another in a cell `image` edges away, in ångström.
    pub fn distance(&self, one: usize, other: usize, image: [i32; 3]) -> f64 {
        match (self.positions.get(one), self.positions.get(other)) {
            (Some(from), Some(to)) => {
                let step = [0, 1, 2].map(|i| to[i] - from[i] + f64::from(image[i]));
                let [x, y, z] = self.cell.cartesian(step);
                (x * x + y * y + z * z).sqrt()
            }
            _ => f64::INFINITY,
        }
    }
}
