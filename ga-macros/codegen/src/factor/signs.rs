//! Which sign a named value has: the one that opens its sum without a negation.

use ga_core::Rational;
use num_traits::{One, Signed};

use super::{Kernel, TEMPORARY};
use crate::poly::{Monomial, Poly};

/// The kernel with the signs of its temporaries chosen so that none is opened by a negative term
/// where another sign would open it by a positive one; their uses make up for it.
pub fn opened(mut kernel: Kernel) -> Kernel {
    let minus = -Rational::one();
    for number in 0..kernel.temporaries.len() {
        if !opens_negative(&kernel.temporaries[number]) {
            continue;
        }
        kernel.temporaries[number] = kernel.temporaries[number].scaled(&minus);
        let later = kernel.temporaries.iter_mut().skip(number + 1);
        for poly in later.chain(&mut kernel.outputs) {
            *poly = negated_in(poly, number);
        }
    }
    kernel
}

/// Whether the sum as it is written begins with a negation: what is no product stands first, and
/// of the rest what is added.
fn opens_negative(poly: &Poly) -> bool {
    let is_plain = |monomial: &Monomial, value: &Rational| {
        monomial.degree() == 0 || (monomial.degree() == 1 && value.abs().is_one())
    };
    let signs = |plain: bool| {
        let terms = poly.terms();
        let chosen = terms.filter(move |(monomial, value)| is_plain(monomial, value) == plain);
        let mut negative = chosen.map(|(_, value)| value.is_negative()).peekable();
        let any = negative.peek().is_some();
        any.then(|| negative.all(|negative| negative))
    };
    signs(true).or_else(|| signs(false)).unwrap_or(false)
}

/// The polynomial for a temporary of the opposite sign.
fn negated_in(poly: &Poly, number: usize) -> Poly {
    let mut result = Poly::default();
    for (monomial, value) in poly.terms() {
        let times = monomial
            .variables()
            .filter(|v| v.operand == TEMPORARY && usize::from(v.slot) == number)
            .count();
        let sign = if times % 2 == 0 { *value } else { -*value };
        result.add_term(*monomial, sign);
    }
    result
}
