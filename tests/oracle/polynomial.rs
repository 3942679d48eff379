//! Results for all values of the operands at once: a polynomial in their coefficients per blade.

use std::collections::BTreeMap;

use ga::core::{Product, Rational};

use crate::kind::{Kind, smallest};
use crate::reference::Oracle;

/// Up to three coefficients of the operands, in decreasing order; 0 stands for none.
pub type Monomial = [u32; 3];

/// A polynomial without terms that vanish.
pub type Polynomial = BTreeMap<Monomial, Rational>;

/// A polynomial for every blade where it does not vanish.
pub type General = BTreeMap<u32, Polynomial>;

/// The coefficient of a blade of the first or second operand.
pub fn variable(operand: u32, mask: u32) -> u32 {
    (mask << 1 | operand) + 1
}

fn times(a: &Monomial, b: &Monomial) -> Monomial {
    let mut all = [a[0], a[1], a[2], b[0], b[1], b[2]];
    all.sort_unstable_by(|x, y| y.cmp(x));
    assert_eq!(all[3], 0, "no operation has degree four");
    [all[0], all[1], all[2]]
}

fn without_zeros(mut element: General) -> General {
    for polynomial in element.values_mut() {
        polynomial.retain(|_, value| *value != Rational::ZERO);
    }
    element.retain(|_, polynomial| !polynomial.is_empty());
    element
}

/// A product of two general elements.
pub fn product(oracle: &Oracle, product: Product, a: &General, b: &General) -> General {
    let mut result = General::new();
    for (left, x) in a {
        for (right, y) in b {
            for (mask, factor) in oracle.blades(product, *left, *right).iter() {
                let polynomial = result.entry(*mask).or_default();
                for (i, u) in x {
                    for (j, v) in y {
                        *polynomial.entry(times(i, j)).or_insert(Rational::ZERO) +=
                            *u * *v * *factor;
                    }
                }
            }
        }
    }
    without_zeros(result)
}

/// The sum `a + factor b`.
fn sum(a: &General, b: &General, factor: Rational) -> General {
    let mut result = a.clone();
    for (mask, polynomial) in b {
        let entry = result.entry(*mask).or_default();
        for (monomial, value) in polynomial {
            *entry.entry(*monomial).or_insert(Rational::ZERO) += *value * factor;
        }
    }
    without_zeros(result)
}

/// The image of a linear map that is given on basis blades.
pub fn linear(element: &General, map: impl Fn(u32) -> Vec<(u32, Rational)>) -> General {
    let mut result = General::new();
    for (mask, polynomial) in element {
        for (image, factor) in map(*mask) {
            let one: General = [(image, polynomial.clone())].into();
            result = sum(&result, &one, factor);
        }
    }
    result
}

/// The sign (−1)^{k(k−1)/2} of the reverse.
pub fn reversal(mask: u32) -> Rational {
    match mask.count_ones() % 4 {
        0 | 1 => Rational::ONE,
        _ => -Rational::ONE,
    }
}

fn reversed(element: &General) -> General {
    linear(element, |mask| vec![(mask, reversal(mask))])
}

/// The type of a product of two types; `None` where no type holds it.
pub fn product_kind<'o>(
    oracle: &'o Oracle,
    operation: Product,
    a: &Kind,
    b: &Kind,
) -> Option<&'o Kind> {
    smallest(
        oracle,
        &product(oracle, operation, &a.general(0), &b.general(1)),
    )
}

/// Whether some value of the type may be a versor: ⟨X X̃⟩ is not always zero.
pub fn has_norm(oracle: &Oracle, a: &Kind) -> bool {
    // Of one grade, X X̃ is the square up to sign.
    if !a.null.is_empty() && a.grades().is_power_of_two() {
        return false;
    }
    let general = a.general(0);
    !product(
        oracle,
        Product::ScalarProduct,
        &general,
        &reversed(&general),
    )
    .is_empty()
}

/// Whether V Ṽ = 1 for every value of the type.
fn is_unit(oracle: &Oracle, versor: &General) -> bool {
    let square = product(oracle, Product::Geometric, versor, &reversed(versor));
    square == General::from([(0, [([0; 3], Rational::ONE)].into())])
}

/// The types of `V x̂ Ṽ` and of `V x̂ V⁻¹`, both restricted to the grades of `x`; `None` where no
/// declared type holds them.
pub struct Images {
    pub sandwich: Kind,
    pub applied: Kind,
}

/// The types of the images, from the operation as a polynomial of degree three.
pub fn images(oracle: &Oracle, versor: &Kind, operand: &Kind) -> Option<Images> {
    let (v, x) = (versor.general(0), operand.general(1));
    let sign = |mask: u32| match versor.is_odd() && mask.count_ones() % 2 == 1 {
        true => -Rational::ONE,
        false => Rational::ONE,
    };
    let geometric = |a: &General, b: &General| product(oracle, Product::Geometric, a, b);
    let restricted = |mut element: General| {
        element.retain(|mask, _| operand.grades() >> mask.count_ones() & 1 == 1);
        element
    };
    let first = geometric(&v, &linear(&x, |mask| vec![(mask, sign(mask))]));
    let whole = restricted(geometric(&first, &reversed(&v)));
    let sandwich = match operand.fits(&whole) {
        true => operand,
        false => smallest(oracle, &whole)?,
    };
    // x + (V x̂ − x V) V⁻¹ shows which fixed coefficients stay.
    let difference = sum(&first, &geometric(&x, &v), -Rational::ONE);
    let moved = restricted(geometric(&difference, &reversed(&v)));
    let keeps = operand.is_constrained() && operand.fits(&sum(&x, &moved, Rational::ONE));
    let unit = oracle.units.contains(&versor.name.as_str())
        || !versor.fixed.is_empty() && is_unit(oracle, &v);
    let applied = if keeps {
        operand
    } else if unit || sandwich.fixed.is_empty() {
        sandwich
    } else {
        crate::kind::free(oracle, &sandwich.blades())?
    };
    Some(Images {
        sandwich: if unit { applied } else { sandwich }.clone(),
        applied: applied.clone(),
    })
}
