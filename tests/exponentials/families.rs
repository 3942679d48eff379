//! Bivectors of every kind that a metric has, in the frame and turned away from it.

use crate::space::{Space, Value, largest, times};
use crate::wide::Wide;

/// A bivector and how far it is from the edge of the principal logarithm.
pub struct Sample {
    pub bivector: Value,
    pub gap: f64,
    /// How much longer its coefficients are than in the frame: rounding grows with the square.
    pub growth: f64,
    pub kind: String,
}

/// Sizes of angles, and of rapidities and translations.
const SIZES: [f64; 7] = [0.0, 1e-200, 1e-8, 1e-3, 0.3, 1.5, 3.0];
/// Further sizes of rapidities and translations.
const LARGE: [f64; 2] = [5.0, 16.0];
/// Distances of angles from the edge.
const GAPS: [f64; 5] = [1e-1, 1e-2, 1e-4, 1e-5, 1e-6];

/// Random numbers, the same in every run.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// A number between −1 and 1.
    pub fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The product of two vectors of the frame, which are orthogonal.
fn plane(space: &Space, [i, j]: [usize; 2]) -> Value {
    times(&space.frame[i], &space.frame[j])
}

/// Minus one for planes of rotations, 1 for boosts, 0 for null planes.
fn square(space: &Space, [i, j]: [usize; 2]) -> f64 {
    -space.sign(i) * space.sign(j)
}

/// All pairs of an index below `count`.
fn pairs(count: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..count).flat_map(move |j| (0..j).map(move |i| [i, j]))
}

/// Every kind of bivector of up to two commuting planes.
pub fn families(space: &Space) -> Vec<Sample> {
    let mut samples = Vec::new();
    let count = space.frame.len();
    // Planes of the same signatures differ by a turn only.
    let mut seen = Vec::new();
    let mut is_new = |planes: &[[usize; 2]]| {
        let signs = |at: &[usize; 2]| at.map(|i| space.sign(i) as i32);
        let signature: Vec<[i32; 2]> = planes.iter().map(signs).collect();
        let new = !seen.contains(&signature);
        seen.push(signature);
        new
    };
    for first in pairs(count) {
        if is_new(&[first]) {
            single(space, first, &mut samples);
        }
        let apart = |second: &[usize; 2]| second.iter().all(|i| !first.contains(i));
        for second in pairs(count).filter(|second| apart(second) && first < *second) {
            if is_new(&[first, second]) {
                double(space, first, second, &mut samples);
            }
        }
    }
    nearly_null(space, &mut samples);
    turned(space, samples)
}

fn single(space: &Space, at: [usize; 2], samples: &mut Vec<Sample>) {
    let elliptic = square(space, at) < 0.0;
    let mut add = |size: f64, gap: f64| {
        let bivector = plane(space, at).scale(Wide::from(size));
        let kind = format!("{size} of {at:?}");
        samples.push(Sample {
            bivector,
            gap,
            growth: 1.0,
            kind,
        });
    };
    for size in SIZES {
        add(size, std::f64::consts::PI - size);
    }
    for (large, gap) in LARGE.into_iter().zip(GAPS) {
        match elliptic {
            true => add(std::f64::consts::PI - gap, gap),
            false => add(large, 1.0),
        }
    }
    if elliptic {
        add(std::f64::consts::PI - GAPS[3], GAPS[3]);
        add(std::f64::consts::PI - GAPS[4], GAPS[4]);
    }
}

fn double(space: &Space, first: [usize; 2], second: [usize; 2], samples: &mut Vec<Sample>) {
    let squares = [first, second].map(|at| square(space, at));
    let (one, other) = (plane(space, first), plane(space, second));
    let mut add = |x: f64, y: f64, gap: f64| {
        let both = one.scale(Wide::from(x)).add(&other.scale(Wide::from(y)));
        samples.push(Sample {
            bivector: both.expect("the same algebra"),
            gap,
            growth: 1.0,
            kind: format!("{x} of {first:?} with {y} of {second:?}"),
        });
    };
    let edge = std::f64::consts::PI;
    // Angles count towards the edge, rapidities do not.
    let angle = |index: usize, size: f64| if squares[index] < 0.0 { size } else { 0.0 };
    // Two boosts lose the smaller component of their sum and difference, as large numbers do.
    let bounded = squares.iter().all(|&s| s > 0.0);
    let sizes = || {
        SIZES
            .into_iter()
            .chain(LARGE)
            .filter(move |&s| !bounded || s <= 3.0)
    };
    for x in sizes() {
        for y in sizes() {
            let gap = edge - angle(0, x) - angle(1, y);
            if gap > 0.05 {
                add(x, y, gap.min(1.0));
                add(x, -y, gap.min(1.0));
            }
        }
    }
    if squares.iter().all(|&s| s < 0.0) {
        for gap in GAPS {
            for share in [0.5, 0.3, 0.1, 1e-3, 0.5 + 1e-5] {
                let x = (edge - gap) * share;
                add(x, edge - gap - x, gap);
                add(-x, edge - gap - x, gap);
            }
            add(edge - 2.0 * gap, 0.5 * gap, gap);
        }
    } else if let Some(index) = squares.iter().position(|&s| s < 0.0) {
        for gap in GAPS {
            for size in [1e-8, 1e-4, 0.1, 1.0, 5.0] {
                match index {
                    0 => add(edge - gap, size, gap),
                    _ => add(size, edge - gap, gap),
                }
            }
        }
    }
}

/// Planes of two vectors of which one is nearly null, alone and with the plane of two others.
fn nearly_null(space: &Space, samples: &mut Vec<Sample>) {
    let count = space.frame.len();
    let mixed = |[i, j]: &[usize; 2]| space.sign(*i) * space.sign(*j) == -1.0;
    for [i, j] in pairs(count).filter(mixed).take(2) {
        for k in (0..count).filter(|k| ![i, j].contains(k)) {
            for away in [0.0, 1e-16, 1e-12, 1e-8, -1e-8, 1e-5, -1e-3] {
                let tilted = space.frame[j].scale(Wide::from(1.0 + away));
                let vector = space.frame[i].add(&tilted).expect("the same algebra");
                let null = times(&vector, &space.frame[k]);
                for size in [0.3, 1.7] {
                    let alone = null.scale(Wide::from(size));
                    for other in pairs(count).filter(|o| !o.iter().any(|x| [i, j, k].contains(x))) {
                        let both = alone.add(&plane(space, other).scale(Wide::from(0.8)));
                        samples.push(Sample {
                            bivector: both.expect("the same algebra"),
                            gap: 1.0,
                            growth: 1.0,
                            kind: format!("{size} of null {away} in {i} {j} {k} with {other:?}"),
                        });
                    }
                    samples.push(Sample {
                        bivector: alone,
                        gap: 1.0,
                        growth: 1.0,
                        kind: format!("{size} of null {away} in {i} {j} {k}"),
                    });
                }
            }
        }
    }
}

/// The samples, and each once more turned by a versor.
fn turned(space: &Space, samples: Vec<Sample>) -> Vec<Sample> {
    let mut random = Random::new(space.frame.len() as u64 + 17);
    let versors: Vec<(Value, f64)> = std::iter::repeat_with(|| versor(space, &mut random))
        .filter_map(|versor| {
            let growths = space.frame.iter().map(|vector| {
                let image = versor.apply(vector).expect("an invertible versor");
                largest(&image)
            });
            let growth = growths.fold(1.0, f64::max);
            (growth <= 1.5).then_some((versor, growth))
        })
        .take(4)
        .collect();
    let mut all = Vec::new();
    for (sample, (versor, growth)) in samples.into_iter().zip(versors.iter().cycle()) {
        let image = versor
            .apply(&sample.bivector)
            .expect("an invertible versor");
        all.push(Sample {
            bivector: image.grade(2),
            gap: sample.gap,
            growth: *growth,
            kind: format!("{} turned", sample.kind),
        });
        all.push(sample);
    }
    all
}

/// The product of four vectors that are not null.
fn versor(space: &Space, random: &mut Random) -> Value {
    let mut product = space.algebra.scalar(Wide::from(1.0));
    let mut factors = 0;
    while factors < 4 {
        let mut vector = space.algebra.zero();
        for own in &space.frame {
            let term = own.scale(Wide::from(random.number()));
            vector = vector.add(&term).expect("the same algebra");
        }
        let square = times(&vector, &vector).coefficient(ga::core::Blade::SCALAR);
        if square.to_f64().abs() > 0.2 {
            product = times(&product, &vector);
            factors += 1;
        }
    }
    product
}
