//! Where the coefficients of the blades stand among the entries of the matrices.

use super::blocks::{Blocks, Pair};
use super::generators::{Generators, Signed};

/// The shortest rows that the kernel takes.
const NARROWEST: usize = 4;

/// The most vectors that are orthogonal to all: each multiplies the number of products by three.
const NULL_LIMIT: usize = 2;

/// An algebra without vectors that are orthogonal to all, as blocks of matrices, times the
/// exterior algebra of these.
#[derive(Clone, Debug)]
pub struct Representation {
    /// How many rows the blocks have together.
    pub height: usize,
    /// How many real numbers a row has.
    pub width: usize,
    /// How many units the numbers have: 1, 2 or 4.
    pub units: usize,
    /// The stages of the transform that belong to pairs of null vectors, as bits.
    pub pairs: usize,
    /// The blade of each entry, before the transform.
    pub slots: Vec<Signed>,
    /// The vectors that are orthogonal to all.
    pub null: Vec<u32>,
}

impl Representation {
    /// The representation of an algebra; `None` where its matrices are tiny, or too many
    /// vectors are orthogonal to all.
    pub fn of(blocks: &Blocks) -> Option<Representation> {
        let generators = Generators::of(&blocks.units);
        // The transform's stages: generators, then pairs of null vectors, then the split.
        let stages = generators.pairs.len() + blocks.pairs.len();
        let rows = 1 << stages;
        let units = 1 << generators.units.len();
        let height = rows << usize::from(generators.split.is_some());
        let width = rows * units;
        if height == 1 || width < NARROWEST || blocks.null.len() > NULL_LIMIT {
            return None;
        }
        let slots = (0..height * width).map(|position| {
            let (a, w) = (position / width, position % width);
            slot(blocks, &generators, a, w / rows, w % rows)
        });
        Some(Representation {
            height,
            width,
            units,
            pairs: ((1 << blocks.pairs.len()) - 1) << generators.pairs.len(),
            slots: slots.collect(),
            null: blocks.null.clone(),
        })
    }
}

/// The blade g^a κ^c h^b.
fn slot(blocks: &Blocks, generators: &Generators, a: usize, c: usize, b: usize) -> Signed {
    let (count, pairs) = (generators.pairs.len(), &blocks.pairs);
    let of = |index: usize| generators.pairs.iter().map(move |pair| pair[index]);
    let parts = [
        generators.power(of(0), a),
        generators.power(generators.split.into_iter(), a >> (count + pairs.len())),
        generators.power(of(1), b),
        generators.power(generators.units.iter().copied(), c),
    ];
    let rest = parts.into_iter().fold(Signed::ONE, |product, part| {
        generators.product(product, part)
    });
    // Vectors after a pair u, v of null vectors take the factor u∧v, so that they commute with
    // u and v; it moves to its pair.
    let mut odd = rest.mask.count_ones() % 2 == 1;
    let mut product = rest;
    for (number, pair) in pairs.iter().enumerate().rev() {
        let bit = |bits: usize| bits >> (count + number) & 1 == 1;
        product = component(*pair, bit(a), bit(b), odd).wedge(product);
        odd ^= bit(b);
    }
    product
}

/// 1, γ m, u or γ v, times m = u∧v for `odd`, where γ = u·v is ±1: m² = 1, u m = −γ u, v m = γ v.
fn component(pair: Pair, a: bool, b: bool, odd: bool) -> Signed {
    let both = pair.first | pair.second;
    let (mask, negative) = match (a, b, odd) {
        (false, false, false) => (0, false),
        (false, false, true) => (both, false),
        (true, false, false) => (both, pair.negative),
        (true, false, true) => (0, pair.negative),
        (false, true, false) => (pair.first, false),
        (false, true, true) => (pair.first, !pair.negative),
        (true, true, false) => (pair.second, pair.negative),
        (true, true, true) => (pair.second, false),
    };
    Signed { mask, negative }
}
