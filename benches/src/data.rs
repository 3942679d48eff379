//! The random data that every library gets, in coordinates that belong to none.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

/// A rotation: the unit quaternion as w, x, y, z.
pub type Rotation = [f64; 4];

/// A rigid motion x ↦ q x q⁻¹ + t.
#[derive(Clone, Copy)]
pub struct Motion {
    /// The rotation q.
    pub rotation: Rotation,
    /// The translation t.
    pub translation: [f64; 3],
}

/// Elements in coordinates, the same at every run.
pub struct Data {
    /// Rotations by at most two thirds of a turn, whose logarithms are unique.
    pub rotations: [Vec<Rotation>; 2],
    /// Rigid motions with such rotations.
    pub motions: [Vec<Motion>; 2],
    /// Points of a cube of edge 2.
    pub vectors: [Vec<[f64; 3]>; 4],
    /// Planes as unit normal and offset, n·x + d = 0.
    pub planes: [Vec<[f64; 4]>; 3],
}

impl Data {
    /// So many elements of each kind.
    pub fn new(elements: usize) -> Self {
        let mut random = StdRng::seed_from_u64(1);
        let random = &mut random;
        let motion = |random: &mut StdRng| Motion {
            rotation: rotation(random),
            translation: coordinates(random),
        };
        let plane = |random: &mut StdRng| {
            let ([a, b, c], [d]) = (unit(random), coordinates(random));
            [a, b, c, d]
        };
        Data {
            rotations: lists(elements, || rotation(random)),
            motions: lists(elements, || motion(random)),
            vectors: lists(elements, || coordinates(random)),
            planes: lists(elements, || plane(random)),
        }
    }
}

/// Lists of so many elements each.
fn lists<X, const N: usize>(elements: usize, mut element: impl FnMut() -> X) -> [Vec<X>; N] {
    std::array::from_fn(|_| (0..elements).map(|_| element()).collect())
}

fn coordinates<const N: usize>(random: &mut StdRng) -> [f64; N] {
    std::array::from_fn(|_| random.random_range(-1.0..1.0))
}

fn unit<const N: usize>(random: &mut StdRng) -> [f64; N] {
    loop {
        let x = coordinates(random);
        let norm = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        if norm > 0.1 {
            return x.map(|x| x / norm);
        }
    }
}

fn rotation(random: &mut StdRng) -> Rotation {
    loop {
        let [w, x, y, z] = unit(random);
        if w > 0.5 {
            return [w, x, y, z];
        }
    }
}
