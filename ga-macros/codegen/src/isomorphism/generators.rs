//! Commuting blades of square 1 and their partners, in the algebra of orthogonal vectors of
//! square ±1: what remains commutes with all of them and is ℝ, ℂ or ℍ, once or twice.

use ga_core::reorder_sign;

use super::blocks::Unit;

/// A basis blade with its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signed {
    /// The vectors.
    pub mask: u32,
    /// Whether the sign is −1.
    pub negative: bool,
}

impl Signed {
    /// The number 1.
    pub const ONE: Signed = Signed {
        mask: 0,
        negative: false,
    };

    /// The blade with this sign on top of its own.
    pub fn times(self, negative: bool) -> Signed {
        Signed {
            negative: self.negative ^ negative,
            ..self
        }
    }

    /// The outer product with a blade that has no vector in common with this one.
    pub fn wedge(self, other: Signed) -> Signed {
        Signed {
            mask: self.mask | other.mask,
            negative: self.negative ^ other.negative ^ (reorder_sign(self.mask, other.mask) < 0),
        }
    }
}

/// What generates the algebra.
#[derive(Clone, Debug, Default)]
pub struct Generators {
    /// Pairs (g, h): g² = h² = 1, g h = −h g, everything else commutes.
    pub pairs: Vec<[Signed; 2]>,
    /// A blade of square 1 that commutes with all, if there is one beside 1.
    pub split: Option<Signed>,
    /// The units beside 1 that generate the numbers: none, i, or i and j.
    pub units: Vec<Signed>,
    negative: u32,
}

impl Generators {
    /// The generators of the algebra of these vectors.
    pub fn of(vectors: &[Unit]) -> Generators {
        let all = vectors.iter().fold(0, |mask, unit| mask | unit.bit);
        let negative = vectors.iter().filter(|unit| unit.negative);
        let mut generators = Generators {
            negative: negative.fold(0, |mask, unit| mask | unit.bit),
            ..Generators::default()
        };
        let mut rest: Vec<u32> = (0..=all).filter(|mask| mask & !all == 0).collect();
        while let Some((g, h)) = generators.pair(&rest) {
            rest.retain(|x| generators.commute(*x, g) && generators.commute(*x, h));
            let (g, mut h) = (positive(g), positive(h));
            if generators.square_is_negative(h.mask) {
                h = generators.product(g, h);
            }
            generators.pairs.push([g, h]);
        }
        let central = |x: &u32| rest.iter().all(|y| generators.commute(*x, *y));
        let mut split = rest.iter().copied().filter(central);
        let split = split.find(|x| *x != 0 && !generators.square_is_negative(*x));
        let units = rest.iter().copied();
        let units: Vec<u32> = units
            .filter(|x| generators.square_is_negative(*x))
            .collect();
        let i = units.first().copied();
        let j = i.and_then(|i| units.iter().copied().find(|x| !generators.commute(*x, i)));
        generators.split = split.map(positive);
        generators.units = [i, j].into_iter().flatten().map(positive).collect();
        generators
    }

    /// Two blades that anticommute, the first of square 1.
    fn pair(&self, blades: &[u32]) -> Option<(u32, u32)> {
        let mut squares = blades.iter().filter(|g| !self.square_is_negative(**g));
        squares.find_map(|g| {
            let mut partners = blades.iter().filter(|h| !self.commute(*g, **h));
            partners.next().map(|h| (*g, *h))
        })
    }

    fn commute(&self, a: u32, b: u32) -> bool {
        reorder_sign(a, b) == reorder_sign(b, a)
    }

    fn square_is_negative(&self, a: u32) -> bool {
        self.product(positive(a), positive(a)).negative
    }

    /// The geometric product of two blades.
    pub fn product(&self, a: Signed, b: Signed) -> Signed {
        let minus = (a.mask & b.mask & self.negative).count_ones() % 2 == 1;
        let reordered = reorder_sign(a.mask, b.mask) < 0;
        Signed {
            mask: a.mask ^ b.mask,
            negative: a.negative ^ b.negative ^ minus ^ reordered,
        }
    }

    /// The product of those generators whose bits are set.
    pub fn power(&self, generators: impl Iterator<Item = Signed>, bits: usize) -> Signed {
        let chosen = generators
            .enumerate()
            .filter(|(number, _)| bits >> number & 1 == 1);
        chosen.fold(Signed::ONE, |product, (_, generator)| {
            self.product(product, generator)
        })
    }
}

fn positive(mask: u32) -> Signed {
    Signed {
        mask,
        negative: false,
    }
}
