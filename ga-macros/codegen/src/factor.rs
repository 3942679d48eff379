//! Straight-line kernels: which intermediate values are named, and what the result costs.

use std::ops::Add;

use ga_core::Rational;
use num_traits::{One, Signed};

use crate::poly::{Monomial, Poly, Variable};

/// A function body: temporaries first, then one polynomial per field of the result.
///
/// Temporary `n` is the variable of operand [`TEMPORARY`] at slot `n`; the reciprocal of the
/// divisor is the variable of operand [`RECIPROCAL`].
#[derive(Clone)]
pub struct Kernel {
    /// A polynomial whose reciprocal is computed first.
    pub divisor: Option<Poly>,
    /// Intermediate values in the order computed.
    pub temporaries: Vec<Poly>,
    /// The fields of the result.
    pub outputs: Vec<Poly>,
    /// How the kernel was derived, for the ledger.
    pub form: &'static str,
}

/// The operand number of temporaries.
pub const TEMPORARY: u8 = 2;

/// The operand number of the reciprocal of the divisor.
pub const RECIPROCAL: u8 = 3;

/// The operand number of the multiple of a versor whose reverse is the inverse.
pub const MULTIPLE: u8 = 4;

/// Operation counts of a kernel. Doublings are counted with the additions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cost {
    /// Multiplications, doublings apart.
    pub multiplications: usize,
    /// Additions, subtractions and doublings.
    pub additions: usize,
}

impl Cost {
    /// So many multiplications and nothing else.
    pub fn multiplying(multiplications: usize) -> Cost {
        Cost {
            multiplications,
            additions: 0,
        }
    }
}

impl Add for Cost {
    type Output = Cost;

    fn add(self, other: Cost) -> Cost {
        Cost {
            multiplications: self.multiplications + other.multiplications,
            additions: self.additions + other.additions,
        }
    }
}

impl Kernel {
    /// A kernel without temporaries.
    pub fn expanded(outputs: Vec<Poly>) -> Kernel {
        Kernel {
            divisor: None,
            temporaries: Vec::new(),
            outputs,
            form: "expanded",
        }
    }

    /// Every polynomial that is evaluated.
    pub fn polynomials(&self) -> impl Iterator<Item = &Poly> {
        self.divisor
            .iter()
            .chain(&self.temporaries)
            .chain(&self.outputs)
    }

    /// What the kernel costs as it is emitted.
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for poly in self.polynomials() {
            for (factor, group) in by_factor(poly) {
                cost.multiplications += group
                    .iter()
                    .map(|(monomial, _)| monomial.degree().saturating_sub(1))
                    .sum::<usize>();
                let variable = group.iter().any(|(monomial, _)| monomial.degree() > 0);
                if factor == Rational::from_integer(2) && variable {
                    cost.additions += 1;
                } else if !factor.is_one() && variable {
                    cost.multiplications += 1;
                }
            }
            cost.additions += poly.len().saturating_sub(1);
        }
        cost
    }

    /// The kernel without the temporaries that no output needs, the others numbered anew, and
    /// without a divisor whose reciprocal is not used.
    pub fn without_unused(self) -> Kernel {
        let mut used = vec![false; self.temporaries.len()];
        let mark = |used: &mut Vec<bool>, poly: &Poly| {
            let variables = poly.terms().flat_map(|(monomial, _)| monomial.variables());
            for variable in variables.filter(|v| v.operand == TEMPORARY) {
                used[usize::from(variable.slot)] = true;
            }
        };
        for output in &self.outputs {
            mark(&mut used, output);
        }
        // A temporary reads earlier ones only.
        for number in (0..self.temporaries.len()).rev() {
            if used[number] {
                mark(&mut used, &self.temporaries[number]);
            }
        }
        let kept: Vec<usize> = (0..self.temporaries.len()).filter(|n| used[*n]).collect();
        let renumbered = |v: Variable| {
            let new = kept.iter().position(|n| *n == usize::from(v.slot));
            match new.filter(|_| v.operand == TEMPORARY) {
                Some(new) => Variable {
                    slot: new as u16,
                    ..v
                },
                None => v,
            }
        };
        let outputs = self.outputs.iter().map(|poly| poly.renamed(renumbered));
        let mut kernel = Kernel {
            outputs: outputs.collect(),
            temporaries: kept
                .iter()
                .map(|n| self.temporaries[*n].renamed(renumbered))
                .collect(),
            ..self
        };
        let divides = |poly: &Poly| {
            let mut variables = poly.terms().flat_map(|(monomial, _)| monomial.variables());
            variables.any(|v| v.operand == RECIPROCAL)
        };
        let mut bodies = kernel.temporaries.iter().chain(&kernel.outputs);
        if !bodies.any(divides) {
            kernel.divisor = None;
        }
        kernel
    }

    /// How many monomials the kernel writes.
    pub fn terms(&self) -> usize {
        self.polynomials().map(Poly::len).sum()
    }
}

/// The terms of a polynomial grouped by the absolute value of their coefficient, so that a
/// common factor is multiplied once; within a group positive terms stand first.
pub fn by_factor(poly: &Poly) -> Vec<(Rational, Vec<(Monomial, bool)>)> {
    let mut groups: Vec<(Rational, Vec<(Monomial, bool)>)> = Vec::new();
    for (monomial, value) in poly.terms() {
        let factor = value.abs();
        let entry = (*monomial, value.is_negative());
        match groups.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, group)) => group.push(entry),
            None => groups.push((factor, vec![entry])),
        }
    }
    for (_, group) in &mut groups {
        group.sort_by_key(|(_, negative)| *negative);
    }
    groups.sort_by_key(|(_, group)| group[0].1);
    groups
}
