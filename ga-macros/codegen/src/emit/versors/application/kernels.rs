//! The bodies of versor applications: two products with the value between them named.

use std::collections::BTreeSet;

use ga_core::Product;

use crate::emit::Generator;
use crate::factor::{Kernel, MULTIPLE, TEMPORARY};
use crate::poly::{Element, Monomial, Poly, Variable, general, sum};

/// `x + (V x̂ − x V) V⁻¹` with the difference named: most of its terms cancel before the second
/// product.
pub fn moving(
    generator: &Generator<'_>,
    result: usize,
    difference: &Element,
    inverse: &Element,
    operand: &Element,
    whole: &Element,
) -> Kernel {
    let (named, temporaries) = named(difference);
    let step = onto(generator, result, &named, inverse, whole);
    let image = sum(operand, &step, 1);
    Kernel {
        temporaries,
        outputs: generator.onto_fields(result, &image),
        form: "x + (V x − x V) V⁻¹".into(),
    }
    .without_unused()
}

/// The variable of a temporary.
pub fn temporary(number: usize) -> Variable {
    Variable {
        operand: TEMPORARY,
        slot: number as u16,
    }
}

/// A variable for every coefficient of an element, and what they are.
pub fn named(element: &Element) -> (Element, Vec<Poly>) {
    let one = ga_core::Rational::from_integer(1);
    let variables = element
        .keys()
        .enumerate()
        .map(|(number, mask)| (*mask, Poly::term(Monomial::of(temporary(number)), one)));
    (variables.collect(), element.values().cloned().collect())
}

/// The multiple of a versor type whose reverse is the inverse: on the versor's own blades a
/// variable each, in the slots of the type of its multiples.
pub fn multiple(generator: &Generator<'_>, [v, multiple]: [usize; 2]) -> Element {
    let mut general = general(generator.kind(multiple), MULTIPLE);
    general.retain(|mask, _| generator.kind(v).slot(*mask).is_some());
    general
}

/// How many coefficients of the multiple of the versor a kernel reads.
pub fn multiples_read(kernel: &Kernel) -> usize {
    let variables = kernel.polynomials().flat_map(Poly::terms);
    let variables = variables.flat_map(|(monomial, _)| monomial.variables());
    let read: BTreeSet<Variable> = variables.filter(|v| v.operand == MULTIPLE).collect();
    read.len()
}

/// The geometric product on the blades that a type stores and the image can have.
pub fn onto(
    generator: &Generator<'_>,
    result: usize,
    left: &Element,
    right: &Element,
    whole: &Element,
) -> Element {
    let kind = generator.kind(result);
    generator
        .tables
        .product_onto(Product::Geometric, left, right, |mask| {
            kind.slot(mask).is_some_and(|slot| slot.fixed.is_none()) && whole.contains_key(&mask)
        })
}

/// How many terms an expanded form may have for shared values to be looked for in it.
const MOST_EXPANDED: usize = 240;

/// The cheaper one of the expanded form and of one in steps, once both are factored; of equals the
/// first.
pub fn cheaper(expanded: Kernel, steps: Kernel) -> Kernel {
    let steps = steps.factored();
    let expanded = match expanded.terms() <= MOST_EXPANDED {
        true => expanded.factored(),
        false => expanded,
    };
    if expanded.cost() <= steps.cost() {
        expanded
    } else {
        steps
    }
}
