//! The bodies of versor applications: two products with the value between them named.

use ga_core::Product;

use crate::emit::Generator;
use crate::factor::{Kernel, RECIPROCAL, TEMPORARY};
use crate::poly::{Element, Monomial, Poly, Variable, sum};

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
    let (named, temporaries) = named(difference, 0);
    let step = onto(generator, result, &named, inverse, whole);
    let image = sum(operand, &step, 1);
    let kernel = Kernel {
        divisor: None,
        temporaries,
        outputs: generator.onto_fields(result, &image),
        form: "x + (V x − x V) V⁻¹",
    };
    // With a divided reverse there are more temporaries to come.
    let ready = inverse
        .values()
        .flat_map(Poly::terms)
        .all(|(monomial, _)| monomial.variables().all(|v| v.operand != TEMPORARY));
    if ready {
        kernel.without_unused()
    } else {
        kernel
    }
}

/// A variable for every coefficient of an element, counted from a number on, and what they are.
pub fn named(element: &Element, from: usize) -> (Element, Vec<Poly>) {
    let one = ga_core::Rational::from_integer(1);
    let variables = element.keys().enumerate().map(|(number, mask)| {
        let slot = (from + number) as u16;
        let variable = Variable {
            operand: TEMPORARY,
            slot,
        };
        (*mask, Poly::term(Monomial::of(variable), one))
    });
    (variables.collect(), element.values().cloned().collect())
}

/// The reverse times the reciprocal of the norm, in temporaries counted from a number on.
pub fn divided_by_norm(back: &Element, from: usize) -> (Element, Vec<Poly>) {
    let one = ga_core::Rational::from_integer(1);
    let reciprocal = Variable {
        operand: RECIPROCAL,
        slot: 0,
    };
    let factor = Poly::term(Monomial::of(reciprocal), one);
    let scaled = back.iter().map(|(mask, poly)| {
        let mut product = Poly::default();
        product.add_product(poly, &factor, &one);
        (*mask, product)
    });
    named(&scaled.collect(), from)
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

/// The kernel that costs less; of equals the first.
pub fn cheaper(a: Kernel, b: Kernel) -> Kernel {
    if a.cost() <= b.cost() { a } else { b }
}
