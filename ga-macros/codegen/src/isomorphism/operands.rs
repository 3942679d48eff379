//! The tables of a product: the operands' coefficients on their way into matrices, and back.

use ga_core::reorder_sign;

use super::blocks::Unit;
use super::generators::Signed;
use super::slots::Representation;
use crate::factor::Cost;

/// Which blades an operand has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// Those of even grade.
    Even,
    /// Those of odd grade.
    Odd,
    /// All.
    Both,
}

/// Whether the matrices stand for the whole algebra or for its even part.
#[derive(Clone, Copy, Debug)]
pub enum Frame {
    /// Blades are those of the algebra.
    Whole,
    /// Blades are those of the even part, whose vectors are products with this one.
    Even(Unit),
}

/// A product through matrices; see [`ga_core::matrix::Isomorphism`].
#[derive(Clone, Debug)]
pub struct Tables {
    /// How many rows the blocks have together.
    pub height: usize,
    /// How many real numbers a row has.
    pub width: usize,
    /// How many units the numbers have.
    pub units: usize,
    /// The stages of the transform that belong to pairs of null vectors, as bits.
    pub pairs: usize,
    /// The products of matrices.
    pub terms: Vec<Term>,
    /// For each entry of each part of the result its blade.
    pub result: Vec<Signed>,
}

/// A product of two matrices.
#[derive(Clone, Debug)]
pub struct Term {
    /// The part of the result that it is added to.
    pub part: usize,
    /// The blade of each entry of the left matrix, before the transform.
    pub left: Vec<Signed>,
    /// The same for the right matrix.
    pub right: Vec<Signed>,
}

impl Tables {
    /// How many multiplications and additions the product takes.
    pub fn cost(&self) -> Cost {
        let rows = self.width / self.units;
        let (size, terms) = (self.height * self.width, self.terms.len());
        let parts = self.result.len() / size;
        let stages = self.height.trailing_zeros() as usize;
        let products = size * rows * self.units * terms;
        let butterflies = size * stages * (2 * terms + parts);
        Cost {
            fused: products + size * parts + butterflies,
            multiplications: products + size * parts,
            additions: products - size * parts + butterflies,
        }
    }

    /// The matrices in words, `4×4 complex matrices`.
    pub fn name(&self) -> String {
        let rows = self.width / self.units;
        let numbers = match self.units {
            1 => "real",
            2 => "complex",
            _ => "quaternion",
        };
        let count = match self.terms.len() * self.height / rows {
            1 => String::new(),
            count => format!("{count} products of "),
        };
        format!("{count}{rows}×{rows} {numbers} matrices")
    }

    /// The position of a blade among the entries of all parts of the result, and whether its
    /// sign changes.
    pub fn entry(&self, mask: u32, negative: bool) -> (usize, bool) {
        let mut blades = self.result.iter().enumerate();
        match blades.find(|(_, blade)| blade.mask == mask) {
            Some((position, blade)) => (position, blade.negative ^ negative),
            None => (0, false),
        }
    }
}

/// The tables of the product of two operands of these parities.
pub fn tables(
    representation: &Representation,
    frame: Frame,
    left: Parity,
    right: Parity,
) -> Tables {
    let null = subsets(&representation.null);
    let (lefts, rights) = (frame.parts(left), frame.parts(right));
    let mut terms = Vec::new();
    let mut parities: Vec<Parity> = Vec::new();
    for &p in lefts {
        for &q in rights {
            let parity = frame.of_product(p, q);
            let first = match parities.iter().position(|known| *known == parity) {
                Some(known) => known,
                None => {
                    parities.push(parity);
                    parities.len() - 1
                }
            };
            for &s in &null {
                for &t in null.iter().filter(|t| **t & s == 0) {
                    // (w_S A)(w_T B) = (w_S w_T) Â B, the involution once for each vector of T.
                    let involved = t.count_ones() % 2 == 1;
                    let outer = reorder_sign(s, t) < 0;
                    let union = null.iter().position(|known| *known == s | t);
                    let slots = || representation.slots.iter().copied();
                    let left = slots().map(|slot| {
                        let odd = slot.mask.count_ones() % 2 == 1;
                        let blade = positive(s).wedge(slot).times(outer ^ (involved && odd));
                        frame.blade(p, blade)
                    });
                    let right = slots().map(|slot| {
                        let blade = positive(t).wedge(slot);
                        frame.blade(q, frame.passed(p, q, blade))
                    });
                    terms.push(Term {
                        part: first * null.len() + union.unwrap_or_default(),
                        left: left.collect(),
                        right: right.collect(),
                    });
                }
            }
        }
    }
    terms.sort_by_key(|term| term.part);
    let mut result = Vec::new();
    for parity in parities {
        for &u in &null {
            let slots = representation.slots.iter();
            result.extend(slots.map(|slot| frame.blade(parity, positive(u).wedge(*slot))));
        }
    }
    Tables {
        height: representation.height,
        width: representation.width,
        units: representation.units,
        pairs: representation.pairs,
        terms,
        result,
    }
}

impl Frame {
    /// The parities that an operand is split into.
    fn parts(self, parity: Parity) -> &'static [Parity] {
        match (self, parity) {
            (Frame::Whole, _) => &[Parity::Both],
            (Frame::Even(_), Parity::Even) => &[Parity::Even],
            (Frame::Even(_), Parity::Odd) => &[Parity::Odd],
            (Frame::Even(_), Parity::Both) => &[Parity::Even, Parity::Odd],
        }
    }

    fn of_product(self, left: Parity, right: Parity) -> Parity {
        match (left == right, self) {
            (_, Frame::Whole) => Parity::Both,
            (true, _) => Parity::Even,
            (false, _) => Parity::Odd,
        }
    }

    /// The blade E f for odd operands, E for even ones, of the algebra for a blade E of the
    /// even part: (e₁ f)(e₂ f) … = (−f²)^⌊k/2⌋ e₁ e₂ … e_k, times f for odd k.
    fn blade(self, parity: Parity, blade: Signed) -> Signed {
        let Frame::Even(f) = self else {
            return blade;
        };
        let count = blade.mask.count_ones();
        let blade = blade.times(!f.negative && count / 2 % 2 == 1);
        match (count % 2 == 1, parity == Parity::Odd) {
            (false, false) => blade,
            (true, true) => blade.times(f.negative),
            _ => blade.wedge(positive(f.bit)),
        }
    }

    /// What f turns a right factor into on its way through: E f E′ = E (f E′ f⁻¹) f, and
    /// f f = f² for two odd factors.
    fn passed(self, left: Parity, right: Parity, blade: Signed) -> Signed {
        match self {
            Frame::Even(f) if left == Parity::Odd => {
                let odd = blade.mask.count_ones() % 2 == 1;
                blade.times(odd ^ (right == Parity::Odd && f.negative))
            }
            _ => blade,
        }
    }
}

/// All outer products of vectors, 1 first.
fn subsets(vectors: &[u32]) -> Vec<u32> {
    let mut subsets = vec![0];
    for vector in vectors {
        for index in 0..subsets.len() {
            subsets.push(subsets[index] | vector);
        }
    }
    subsets
}

fn positive(mask: u32) -> Signed {
    Signed {
        mask,
        negative: false,
    }
}
