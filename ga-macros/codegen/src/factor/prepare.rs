//! What is done to a kernel before divisors are looked for: constants leave the temporaries,
//! temporaries that are no gain go where they are used, and complete squares are written as such.

use ga_core::Rational;
use num_integer::Integer;
use num_traits::{One, Signed};

use super::{Kernel, TEMPORARY};
use crate::poly::{Monomial, Poly, Variable};

/// The same functions with temporaries that have no common constant and more than one use or
/// factor.
pub fn prepared(kernel: &Kernel) -> Option<Kernel> {
    let mut kernel = kernel.clone();
    for slot in 0..kernel.temporaries.len() {
        let poly = &kernel.temporaries[slot];
        if poly.is_zero() {
            substitute(&mut kernel, slot, &Poly::default())?;
            continue;
        }
        let content = content(poly);
        let primitive = poly.scaled(&content.recip());
        let variable = Monomial::of(temporary(slot));
        let uses = uses(&kernel, slot);
        let copied = primitive
            .terms()
            .all(|(monomial, _)| monomial.degree() <= 1);
        let alone = primitive.len() == 1 && (copied || uses.terms == 1);
        if alone || (uses.terms == 1 && uses.plain == 1) {
            let whole = primitive.scaled(&content);
            // Where the product would have too many factors, the temporary stays.
            if substitute(&mut kernel, slot, &whole).is_some() {
                continue;
            }
        }
        if !content.is_one() {
            substitute(&mut kernel, slot, &Poly::term(variable, content))?;
            kernel.temporaries[slot] = primitive;
        }
    }
    complete_squares(&mut kernel);
    let overflowed = kernel.polynomials().any(Poly::overflowed);
    (!overflowed).then_some(kernel)
}

fn temporary(slot: usize) -> Variable {
    Variable {
        operand: TEMPORARY,
        slot: slot as u16,
    }
}

/// The largest number that leaves integers without a common divisor, negative where most terms
/// are.
fn content(poly: &Poly) -> Rational {
    let (mut numerator, mut denominator) = (0_i128, 1_i128);
    let mut signs = 0;
    for (_, value) in poly.terms() {
        numerator = numerator.gcd(value.numer());
        denominator = denominator.lcm(value.denom());
        signs += if value.is_negative() { -1 } else { 1 };
    }
    let leading = poly.terms().next().is_some_and(|(_, v)| v.is_negative());
    let sign = match signs {
        0 if leading => -1,
        0 => 1,
        _ => i128::signum(signs),
    };
    Rational::new(numerator * sign, denominator)
}

/// In how many terms a temporary occurs, and in how many of them alone and without a factor.
struct Uses {
    terms: usize,
    plain: usize,
}

fn uses(kernel: &Kernel, slot: usize) -> Uses {
    let mut uses = Uses { terms: 0, plain: 0 };
    let variable = temporary(slot);
    let bodies = kernel.temporaries.iter().chain(&kernel.outputs);
    for (monomial, value) in bodies.flat_map(Poly::terms) {
        if monomial.variables().any(|v| v == variable) {
            uses.terms += 1;
            uses.plain += usize::from(monomial.degree() == 1 && value.abs().is_one());
        }
    }
    uses
}

/// Writes a polynomial in the place of a temporary, everywhere or, where a product would have too
/// many factors, nowhere.
fn substitute(kernel: &mut Kernel, slot: usize, value: &Poly) -> Option<()> {
    let variable = temporary(slot);
    let mut replaced = Vec::new();
    let bodies = kernel.temporaries.iter().chain(&kernel.outputs);
    for (place, poly) in bodies.enumerate() {
        let has = |monomial: &Monomial| monomial.variables().any(|v| v == variable);
        if !poly.terms().any(|(monomial, _)| has(monomial)) {
            continue;
        }
        let mut result = poly.clone();
        for (monomial, factor) in poly.terms().filter(|(monomial, _)| has(monomial)) {
            let mut product = Poly::constant(*factor);
            for v in monomial.variables() {
                let one = Poly::term(Monomial::of(v), Rational::one());
                product = times(&product, if v == variable { value } else { &one })?;
            }
            result.add_term(*monomial, -*factor);
            result.add_scaled(&product, &Rational::one());
        }
        replaced.push((place, result));
    }
    for (place, poly) in replaced {
        match place.checked_sub(kernel.temporaries.len()) {
            Some(output) => kernel.outputs[output] = poly,
            None => kernel.temporaries[place] = poly,
        }
    }
    Some(())
}

/// The product, unless it has too many factors.
fn times(a: &Poly, b: &Poly) -> Option<Poly> {
    let degree = |poly: &Poly| poly.terms().map(|(m, _)| m.degree()).max().unwrap_or(0);
    if degree(a) + degree(b) > Monomial::LARGEST {
        return None;
    }
    let mut product = Poly::default();
    product.add_product(a, b, &Rational::one());
    Some(product)
}

/// `k a² ± 2 k a b + k b²` becomes `k (a ± b)²`, with a temporary for the sum: one addition and one
/// multiplication instead of three and two, and no difference of squares that were rounded before.
fn complete_squares(kernel: &mut Kernel) {
    let from = kernel.temporaries.len();
    let mut roots: Vec<Poly> = Vec::new();
    for poly in kernel.temporaries.iter_mut().chain(&mut kernel.outputs) {
        while let Some(square) = complete_square(poly) {
            let [a, b] = square.variables.map(Monomial::of);
            let mut sum = Poly::term(a, Rational::one());
            sum.add_term(b, square.sign);
            let root = Monomial::of(temporary(from + roots.len()));
            roots.push(sum);
            poly.add_term(a.times(&a), -square.factor);
            poly.add_term(b.times(&b), -square.factor);
            poly.add_term(a.times(&b), -square.mixed);
            poly.add_term(root.times(&root), square.factor);
        }
    }
    kernel.temporaries.extend(roots);
}

/// `factor (a² + b²) + mixed a b`, the square of `a + sign b`.
struct Square {
    variables: [Variable; 2],
    factor: Rational,
    mixed: Rational,
    sign: Rational,
}

fn complete_square(poly: &Poly) -> Option<Square> {
    let squared = |(monomial, value): (&Monomial, &Rational)| {
        let mut variables = monomial.variables();
        let variable = variables.next()?;
        let is_square = variables.eq([variable]);
        is_square.then_some((variable, *value))
    };
    let squares: Vec<(Variable, Rational)> = poly.terms().filter_map(squared).collect();
    for (i, (a, factor)) in squares.iter().enumerate() {
        for (b, other) in &squares[i + 1..] {
            let mixed = poly.coefficient(&Monomial::of(*a).times(&Monomial::of(*b)));
            let sign = mixed / (*factor * Rational::from_integer(2));
            if factor == other && sign.abs().is_one() {
                return Some(Square {
                    variables: [*a, *b],
                    factor: *factor,
                    mixed,
                    sign,
                });
            }
        }
    }
    None
}
