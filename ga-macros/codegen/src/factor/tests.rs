//! Whether factored kernels are the same functions, and cost no more.

mod accuracy;

use std::cell::RefCell;
use std::collections::BTreeMap;

use ga_core::Rational;
use num_traits::{One, Zero};

use super::{Cost, Kernel, TEMPORARY};
use crate::poly::{Monomial, Poly, Variable};

thread_local! {
    /// Every kernel that was factored on this thread, before and after.
    static SEEN: RefCell<Vec<[Kernel; 2]>> = const { RefCell::new(Vec::new()) };
}

/// Notes a kernel before and after.
pub fn note(before: &Kernel, after: &Kernel) {
    SEEN.with_borrow_mut(|seen| seen.push([before.clone(), after.clone()]));
}

/// The body of the one declaration of the conformal model.
fn conformal() -> &'static str {
    let source = include_str!("../../../../ga-cga/src/algebra.rs");
    let (_, call) = source
        .split_once("define_algebra! {")
        .unwrap_or(("", source));
    call.trim_end().strip_suffix('}').unwrap_or(call)
}

/// The kernels of all functions of an algebra, before and after.
fn kernels(declaration: &str) -> Vec<[Kernel; 2]> {
    SEEN.with_borrow_mut(Vec::clear);
    let ledger = crate::ledger(declaration);
    assert!(ledger.is_ok(), "{ledger:?}");
    SEEN.with_borrow_mut(std::mem::take)
}

/// A polynomial of any degree: the coefficient of each product of variables.
type Whole = BTreeMap<Vec<Variable>, Rational>;

/// Adds `factor` times the product of two polynomials.
fn add_product(sum: &mut Whole, a: &Whole, b: &Whole, factor: Rational) {
    for (left, value) in a {
        for (right, other) in b {
            let mut product = [left.as_slice(), right].concat();
            product.sort_unstable();
            let coefficient = sum.entry(product).or_insert_with(Rational::zero);
            *coefficient += factor * value * other;
        }
    }
    sum.retain(|_, coefficient| !coefficient.is_zero());
}

/// The outputs without temporaries: everything multiplied out.
fn multiplied_out(kernel: &Kernel) -> Vec<Whole> {
    let one = || Whole::from([(Vec::new(), Rational::one())]);
    let mut wholes: Vec<Whole> = Vec::new();
    for poly in kernel.polynomials() {
        assert!(!poly.overflowed());
        let mut whole = Whole::new();
        for (monomial, value) in poly.terms() {
            let term = monomial.variables().fold(one(), |term, variable| {
                let single = Whole::from([(vec![variable], Rational::one())]);
                let factor = match variable.operand {
                    TEMPORARY => &wholes[usize::from(variable.slot)],
                    _ => &single,
                };
                let mut product = Whole::new();
                add_product(&mut product, &term, factor, Rational::one());
                product
            });
            add_product(&mut whole, &term, &one(), *value);
        }
        wholes.push(whole);
    }
    wholes.split_off(kernel.temporaries.len())
}

fn check(declaration: &str) {
    let kernels = kernels(declaration);
    assert!(kernels.len() > 100);
    for [before, after] in &kernels {
        assert!(after.cost() <= before.cost(), "{after:?}");
        assert_eq!(multiplied_out(before), multiplied_out(after), "{after:?}");
    }
    assert!(
        kernels
            .iter()
            .any(|[before, after]| after.cost() < before.cost())
    );
}

#[test]
fn factored_functions_are_the_same_polynomials() {
    for declaration in ["R2", "R3", "R3_0_1", "R4_1"] {
        check(declaration);
    }
}

#[test]
fn factored_functions_of_the_conformal_model_are_the_same_polynomials() {
    check(conformal());
}

#[test]
fn a_metric_with_many_entries_gives_the_same_polynomials() {
    check(
        "mod oblique: R3 { basis { a, b, c }
         metric { a^2 = 1, b^2 = 1, c^2 = 2, a.b = 1/2, b.c = -1 } types { Vector = grade 1; } }",
    );
}

#[test]
fn the_same_declaration_is_factored_the_same_way() {
    for declaration in ["R3_0_1", conformal()] {
        let [first, second] = [(); 2].map(|()| kernels(declaration));
        assert!(first == second);
    }
}

/// What the products and linear functions of the conformal model were brought to, from 27,193
/// multiplications as they stand in the multiplication table.
const MULTIPLICATIONS: usize = 24_979;
const FUSED: usize = 25_577;

#[test]
fn products_of_the_conformal_model_stay_cheap() {
    let ledger = crate::ledger(conformal()).expect("it is correct");
    let total = ledger
        .entries
        .iter()
        .filter(|entry| {
            let versors = ["apply", "sandwich", "linear_map"];
            !versors.iter().any(|name| entry.function.contains(name))
        })
        .filter_map(|entry| entry.cost)
        .fold(Cost::default(), |total, cost| total + cost);
    assert!(total.multiplications <= MULTIPLICATIONS, "{total:?}");
    assert!(total.fused <= FUSED, "{total:?}");
}

fn variable(slot: u16) -> Monomial {
    Monomial::of(Variable { operand: 0, slot })
}

/// A polynomial of terms with two variables at most, `(coefficient, variables)`.
fn poly(terms: &[(i128, &[u16])]) -> Poly {
    let mut poly = Poly::default();
    for (value, slots) in terms {
        let factors = slots.iter().map(|slot| variable(*slot));
        let monomial = factors.fold(Monomial::ONE, |all, factor| all.times(&factor));
        poly.add_term(monomial, Rational::from_integer(*value));
    }
    poly
}

fn counts(outputs: &[Poly]) -> [usize; 3] {
    let kernel = Kernel::expanded(outputs.to_vec());
    let factored = kernel.clone().factored();
    assert_eq!(multiplied_out(&kernel), multiplied_out(&factored));
    let cost = factored.cost();
    [cost.fused, cost.multiplications, cost.additions]
}

#[test]
fn common_factors_are_taken_out() {
    // a b + a c = a (b + c)
    assert_eq!(counts(&[poly(&[(1, &[0, 1]), (1, &[0, 2])])]), [2, 1, 1]);
    // 2 a b − 2 a c + 2 a d = a (2 (b − c + d))
    let three = poly(&[(2, &[0, 1]), (-2, &[0, 2]), (2, &[0, 3])]);
    assert_eq!(counts(&[three]), [4, 1, 3]);
}

#[test]
fn sums_are_shared_up_to_sign_and_factor() {
    // d (a + b) and −e (a + b) with everything multiplied out
    let one = poly(&[(1, &[0, 3]), (1, &[1, 3])]);
    let other = poly(&[(-1, &[0, 4]), (-1, &[1, 4])]);
    assert_eq!(counts(&[one, other]), [3, 2, 1]);
}

#[test]
fn squares_of_sums_are_written_as_such() {
    // 3 a² − 6 a b + 3 b² = 3 (a − b)²
    let square = poly(&[(3, &[0, 0]), (-6, &[0, 1]), (3, &[1, 1])]);
    assert_eq!(counts(&[square]), [3, 2, 1]);
    // a² + b² − a b is no square
    let other = poly(&[(1, &[0, 0]), (-1, &[0, 1]), (1, &[1, 1])]);
    assert_eq!(counts(&[other]), [3, 2, 2]);
}

#[test]
fn a_product_that_joins_two_sums_is_computed_twice() {
    // c + a b and d + a b are two fused operations; naming a b would take three
    let sums = [
        poly(&[(1, &[2]), (1, &[0, 1])]),
        poly(&[(1, &[3]), (1, &[0, 1])]),
    ];
    assert_eq!(counts(&sums), [2, 2, 2]);
    // standing alone it is named: a b and d + a b are a product and an addition
    let sums = [poly(&[(1, &[0, 1])]), poly(&[(1, &[3]), (1, &[0, 1])])];
    assert_eq!(counts(&sums), [2, 1, 1]);
}

#[test]
fn differences_are_never_multiplied_out() {
    // (a + b)(c + d) would take one multiplication less than a c + a d + b c, but needs − b d
    let three = poly(&[(1, &[0, 2]), (1, &[0, 3]), (1, &[1, 2])]);
    assert_eq!(counts(&[three]), [3, 2, 2]);
}
