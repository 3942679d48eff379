//! Applications handed on by duality: `I` passes through versors, so that `(V I)[x] = V[x̂]` and
//! `V[x I] = ±V[x] I`.

use std::collections::HashMap;

use ga_core::Product;
use num_traits::{One, Signed};

use super::costs::Costs;
use super::derivation::SMALL_ALGEBRA;
use crate::emit::Generator;
use crate::emit::involutions::{dual_image, undual_image};
use crate::factor::Cost;
use crate::poly::Element;

/// What is known of the applications emitted so far, and which types stand for others.
pub struct Duality {
    /// For a type whose dual is declared too and comes first, that type.
    primary: Vec<Option<usize>>,
    /// Result type and costs of every application, by versor and operand.
    known: HashMap<[usize; 2], (usize, Option<Costs>)>,
    /// What the matrices cost on one element, and how many entries they have.
    matrices: HashMap<[usize; 2], (Cost, usize)>,
}

/// How an application is handed on.
pub struct HandedOn {
    /// What is replaced by its dual, and the sign of the image, for `ga_core::dual_application!`.
    pub form: &'static str,
    /// The rule, for the ledger and the documentation.
    pub rule: &'static str,
    /// The versor and the operand of the application that does the work.
    pub base: [usize; 2],
    /// The type of the result.
    pub output: usize,
    /// What it costs: duals only move coefficients.
    pub costs: Option<Costs>,
}

impl Duality {
    /// Pairs the types that are each other's duals. In small algebras every application has a
    /// body of its own.
    pub fn new(generator: &Generator<'_>) -> Duality {
        let count = generator.model.types.len();
        let model = generator.model;
        let large = count > SMALL_ALGEBRA && model.is_complete() && !model.metric.is_degenerate();
        let primary = (0..count).map(|a| primary(generator, a).filter(|_| large));
        Duality {
            primary: primary.collect(),
            known: HashMap::new(),
            matrices: HashMap::new(),
        }
    }

    /// All types, those first that others are handed on to.
    pub fn order(&self) -> Vec<usize> {
        let (second, mut all): (Vec<usize>, Vec<usize>) =
            (0..self.primary.len()).partition(|&a| self.primary[a].is_some());
        all.extend(second);
        all
    }

    /// Notes an application with a body.
    pub fn note(&mut self, types: [usize; 2], output: usize, costs: Option<Costs>) {
        self.known.insert(types, (output, costs));
    }

    /// What an application costs, if there is one and that is known.
    pub fn costs(&self, types: [usize; 2]) -> Option<Option<Costs>> {
        self.known.get(&types).map(|(_, costs)| *costs)
    }

    /// Notes the matrix of an application.
    pub fn note_matrix(&mut self, types: [usize; 2], matrix: (Cost, usize)) {
        self.matrices.insert(types, matrix);
    }

    /// What the matrix of an application costs and how many entries it has, if there is one.
    pub fn matrix(&self, types: [usize; 2]) -> Option<(Cost, usize)> {
        self.matrices.get(&types).copied()
    }

    /// The sign of `⟨I Ĩ⟩`, by which the dual of a unit versor is no unit versor where it is −1.
    /// Only where versors are handed on is it asked for, and `I² = ±1` then.
    pub fn sign(generator: &Generator<'_>) -> char {
        let model = generator.model;
        let (_, negative, _) = model.metric.signature();
        if negative % 2 == 0 { '+' } else { '-' }
    }

    /// How the application of one type to another follows from one that is known.
    pub fn hand_on(&self, generator: &Generator<'_>, [v, x]: [usize; 2]) -> Option<HandedOn> {
        let operand = generator.kind(x).parity();
        if let Some(w) = self.primary[v] {
            // Of another I, `V/⟨V Ṽ⟩` has no such dual, and numbers and volumes are still duals.
            if !is_unimodular(generator) {
                return None;
            }
            let base = [w, x];
            let &(output, costs) = self.known.get(&base)?;
            let (form, output) = match operand {
                Some(true) => ("versor +", output),
                Some(false) => ("versor -", generator.sums[output]?),
                None if generator.kind(x).is_constrained() => return None,
                None => ("involuted +", output),
            };
            let costs = costs.map(|costs| match Duality::sign(generator) {
                '+' => costs,
                _ => Costs {
                    unit: costs.with,
                    ..costs
                },
            });
            return Some(HandedOn {
                form,
                rule: "(V I)[x] = V[x̂]",
                base,
                output,
                costs,
            });
        }
        let base = [v, self.primary[x]?];
        let &(output, costs) = self.known.get(&base)?;
        let output = type_of(generator, &undual_image(generator, output)?)?;
        let (form, output) = match generator.kind(v).parity()? {
            true => ("operand +", output),
            false => ("operand -", generator.sums[output]?),
        };
        Some(HandedOn {
            form,
            rule: "V[x I] = ±V[x] I",
            base,
            output,
            costs,
        })
    }
}

/// Whether `I² = ±1`.
fn is_unimodular(generator: &Generator<'_>) -> bool {
    let all = (1_u32 << generator.model.dimension()) - 1;
    let square = generator.tables.blades(Product::Geometric, all, all);
    square.iter().all(|(_, value)| value.abs().is_one())
}

/// The type that an element fits exactly: all of its coefficients and no others.
fn type_of(generator: &Generator<'_>, element: &Element) -> Option<usize> {
    (0..generator.model.types.len()).find(|&i| {
        let kind = generator.kind(i);
        !kind.null
            && kind.slots.len() == element.len()
            && kind.slots.iter().all(|slot| {
                slot.fixed.is_none()
                    && element.get(&slot.mask).is_some_and(|poly| {
                        // Anything but a coefficient moved and signed would cost operations.
                        let one = ga_core::Rational::from_integer(1);
                        poly.len() == 1
                            && poly.terms().all(|(monomial, value)| {
                                monomial.degree() == 1 && (*value == one || *value == -one)
                            })
                    })
            })
    })
}

/// The dual of a type, where that is a type too whose dual is this one, and of lower grade.
fn primary(generator: &Generator<'_>, a: usize) -> Option<usize> {
    let dual = type_of(generator, &dual_image(generator, a)?)?;
    let back = type_of(generator, &undual_image(generator, dual)?)?;
    let rank = |index: usize| {
        let lowest = generator.kind(index).grades().trailing_zeros();
        (lowest, index)
    };
    (back == a && rank(dual) < rank(a)).then_some(dual)
}
