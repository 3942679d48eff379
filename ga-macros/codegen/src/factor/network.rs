//! A kernel as the optimiser sees it: sums of products of numbered values, some of which are
//! sums themselves.

use std::collections::BTreeMap;

use ga_core::Rational;
use num_traits::{One, Signed};

use super::cost::{Constant, Weight};
use super::cube::{Cube, LARGEST, Name, Sum, Term};
use super::{Kernel, TEMPORARY};
use crate::poly::{Monomial, Poly, Variable};

/// What a number stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A coefficient of an operand.
    Variable(Variable),
    /// A positive constant other than 1.
    Constant(Rational),
    /// The value of the sum at this place.
    Sum(usize),
}

/// Sums of products; the first are the temporaries of the kernel, then come its outputs, and then
/// the sums that were found.
#[derive(Clone)]
pub struct Network {
    meanings: Vec<Meaning>,
    /// What a number contributes to a product, by number.
    constants: Vec<Constant>,
    /// The sums.
    pub sums: Vec<Sum>,
    /// Which sums are outputs, by their places.
    pub outputs: Vec<usize>,
}

impl Network {
    /// The temporaries and outputs of a kernel.
    ///
    /// `None` where there are more values than numbers.
    pub fn new(kernel: &Kernel) -> Option<Network> {
        let temporaries = kernel.temporaries.len();
        let mut network = Network {
            meanings: (0..temporaries).map(Meaning::Sum).collect(),
            constants: vec![Constant::One; temporaries + 1],
            sums: Vec::new(),
            outputs: (temporaries..temporaries + kernel.outputs.len()).collect(),
        };
        let mut variables = BTreeMap::new();
        let mut constants = BTreeMap::new();
        for poly in kernel.temporaries.iter().chain(&kernel.outputs) {
            let mut sum = Sum::new();
            for (monomial, value) in poly.terms() {
                let mut cube = Cube::ONE;
                let factor = value.abs();
                if !factor.is_one() {
                    let name = constants
                        .entry(factor)
                        .or_insert_with(|| network.add(Meaning::Constant(factor)));
                    cube = cube.with(*name);
                }
                for variable in monomial.variables() {
                    let name = match variable.operand {
                        TEMPORARY => variable.slot + 1,
                        _ => *variables
                            .entry(variable)
                            .or_insert_with(|| network.add(Meaning::Variable(variable))),
                    };
                    cube = cube.with(name);
                }
                let negative = value.is_negative();
                sum.push(Term { cube, negative });
            }
            network.sums.push(sum);
        }
        (network.names() <= usize::from(LARGEST)).then_some(network)
    }

    fn add(&mut self, meaning: Meaning) -> Name {
        self.meanings.push(meaning);
        self.constants.push(match meaning {
            Meaning::Constant(value) if value == Rational::from_integer(2) => Constant::Two,
            Meaning::Constant(_) => Constant::Other,
            Meaning::Variable(_) | Meaning::Sum(_) => Constant::One,
        });
        self.meanings.len() as Name
    }

    /// Names a new sum.
    pub fn name(&mut self, sum: Sum) -> Name {
        self.sums.push(sum);
        self.add(Meaning::Sum(self.sums.len() - 1))
    }

    /// What a number stands for.
    pub fn meaning(&self, name: Name) -> Meaning {
        self.meanings[usize::from(name) - 1]
    }

    /// Whether a number stands for a constant.
    pub fn is_constant(&self, name: Name) -> bool {
        self.constants[usize::from(name)] != Constant::One
    }

    /// How many numbers are in use.
    pub fn names(&self) -> usize {
        self.meanings.len()
    }

    /// What a term contributes to the cost of its sum.
    pub fn weight(&self, cube: Cube) -> Weight {
        self.weight_with(cube, 0)
    }

    /// What a term contributes with one more factor, a sum with a name.
    pub fn named_weight(&self, cofactor: Cube) -> Weight {
        self.weight_with(cofactor, 1)
    }

    fn weight_with(&self, cube: Cube, mut degree: usize) -> Weight {
        let mut constant = Constant::One;
        for name in cube.names() {
            match self.constants[usize::from(name)] {
                Constant::One => degree += 1,
                other => constant = other,
            }
        }
        Weight::product(degree, constant)
    }

    /// What a sum costs.
    pub fn sum_weight(&self, sum: &Sum) -> Weight {
        sum.iter()
            .map(|term| self.weight(term.cube))
            .fold(Weight::default(), Weight::plus)
    }

    /// The kernel with temporaries in the order in which they are needed; `None` where a product
    /// has more factors than polynomials hold.
    pub fn kernel(&self, like: &Kernel) -> Option<Kernel> {
        let mut order = Vec::new();
        let mut seen = vec![false; self.sums.len()];
        for output in &self.outputs {
            self.visit(*output, &mut seen, &mut order);
        }
        order.retain(|place| !self.outputs.contains(place));
        let mut slots = vec![0_u16; self.sums.len()];
        for (slot, place) in order.iter().enumerate() {
            slots[*place] = slot as u16;
        }
        let poly = |place: usize| self.poly(&self.sums[place], &slots);
        Some(Kernel {
            temporaries: order
                .iter()
                .map(|place| poly(*place))
                .collect::<Option<_>>()?,
            outputs: self
                .outputs
                .iter()
                .map(|place| poly(*place))
                .collect::<Option<_>>()?,
            form: like.form.clone(),
        })
    }

    /// Notes a sum after those that it needs.
    fn visit(&self, place: usize, seen: &mut [bool], order: &mut Vec<usize>) {
        if std::mem::replace(&mut seen[place], true) {
            return;
        }
        for term in &self.sums[place] {
            for name in term.cube.names() {
                if let Meaning::Sum(needed) = self.meaning(name) {
                    self.visit(needed, seen, order);
                }
            }
        }
        order.push(place);
    }

    fn poly(&self, sum: &Sum, slots: &[u16]) -> Option<Poly> {
        let mut poly = Poly::default();
        for term in sum {
            let mut value = Rational::from_integer(if term.negative { -1 } else { 1 });
            let mut monomial = Monomial::ONE;
            for name in term.cube.names() {
                let variable = match self.meaning(name) {
                    Meaning::Constant(constant) => {
                        value *= constant;
                        continue;
                    }
                    Meaning::Variable(variable) => variable,
                    Meaning::Sum(place) => Variable {
                        operand: TEMPORARY,
                        slot: slots[place],
                    },
                };
                if monomial.degree() == Monomial::LARGEST {
                    return None;
                }
                monomial = monomial.times(&Monomial::of(variable));
            }
            poly.add_term(monomial, value);
        }
        Some(poly)
    }
}
