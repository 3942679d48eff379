//! Straight-line kernels, and how a cheaper one is found: constants are moved out of temporaries
//! (`prepare`), shared values are named as long as that saves anything (`divisors`, `extract`) by
//! the model of `cost`, names that turn out to be of no use are taken back (`tidy`), and the rest
//! have the sign that spares negations (`signs`).

mod cost;
mod cube;
mod divisors;
mod extract;
mod network;
mod prepare;
mod signs;
#[cfg(test)]
mod tests;
mod tidy;

use std::borrow::Cow;
use std::ops::Add;

use num_traits::{One, Signed};

use crate::poly::{Poly, Variable};

pub use cost::Cost;
use network::Network;

/// A function body: temporaries first, then one polynomial per field of the result.
///
/// Temporary `n` is the variable of operand [`TEMPORARY`] at slot `n`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// Intermediate values in the order computed.
    pub temporaries: Vec<Poly>,
    /// The fields of the result.
    pub outputs: Vec<Poly>,
    /// How the kernel was derived, for the ledger.
    pub form: Cow<'static, str>,
}

/// The operand number of temporaries.
pub const TEMPORARY: u8 = 2;

/// The operand number of the multiple of a versor whose reverse is the inverse.
pub const MULTIPLE: u8 = 3;

impl Kernel {
    /// A kernel without temporaries.
    pub fn expanded(outputs: Vec<Poly>) -> Kernel {
        Kernel {
            temporaries: Vec::new(),
            outputs,
            form: "expanded".into(),
        }
    }

    /// Every polynomial that is evaluated.
    pub fn polynomials(&self) -> impl Iterator<Item = &Poly> {
        self.temporaries.iter().chain(&self.outputs)
    }

    /// What the kernel costs as it is emitted.
    pub fn cost(&self) -> Cost {
        self.polynomials()
            .map(Cost::of)
            .fold(Cost::default(), Cost::add)
    }

    /// The cheapest kernel found for the same functions: with common factors taken out and shared
    /// values named, or this one where that saves nothing.
    ///
    /// Only ring operations on exact constants, so that integers and rationals give the same values;
    /// nothing is multiplied out, so that no rounding error grows beyond that of the largest term.
    pub fn factored(self) -> Kernel {
        let promising = self.terms() <= MOST_TERMS && shares_anything(&self);
        let found = promising.then(|| factored(&self)).flatten();
        let cheaper = found.filter(|found| found.cost() < self.cost());
        #[cfg(test)]
        tests::note(&self, cheaper.as_ref().unwrap_or(&self));
        cheaper.unwrap_or(self)
    }

    /// The kernel without the temporaries that no output needs, the others numbered anew.
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
        Kernel {
            outputs: outputs.collect(),
            temporaries: kept
                .iter()
                .map(|n| self.temporaries[*n].renamed(renumbered))
                .collect(),
            ..self
        }
    }

    /// How many monomials the kernel writes.
    pub fn terms(&self) -> usize {
        self.polynomials().map(Poly::len).sum()
    }
}

/// How many terms a kernel may have for shared values to be looked for.
const MOST_TERMS: usize = 800;

fn factored(kernel: &Kernel) -> Option<Kernel> {
    let prepared = prepare::prepared(kernel)?;
    let mut network = Network::new(&prepared)?;
    // Names that are taken back can leave products that others share.
    while extract::extract(&mut network) {
        tidy::tidy(&mut network);
    }
    let mut result = network.kernel(&prepared)?;
    // What was written term by term has no other name than what it has become.
    result.form = match &*kernel.form {
        "expanded" => "factored".into(),
        form => format!("{form}, factored").into(),
    };
    Some(signs::opened(result))
}

/// Whether a kernel has anything to share: most products have not, since each of their terms has
/// factors of its own, and this is much quicker to see than to search in vain.
fn shares_anything(kernel: &Kernel) -> bool {
    let mut monomials = Vec::new();
    for poly in kernel.temporaries.iter().chain(&kernel.outputs) {
        let mut variables = Vec::new();
        for (monomial, value) in poly.terms() {
            if monomial.degree() > 2 || !value.abs().is_one() {
                return true;
            }
            monomials.push(*monomial);
            variables.extend(monomial.variables());
        }
        variables.sort_unstable();
        if variables.windows(2).any(|pair| pair[0] == pair[1]) {
            return true;
        }
    }
    monomials.sort_unstable();
    monomials.windows(2).any(|pair| pair[0] == pair[1])
}
