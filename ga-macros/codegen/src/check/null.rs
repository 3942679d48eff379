//! A type declared `#[null]` has values other than zero that square to 0.

use ga_core::{Metric, Product, Rational};
use num_traits::{Signed, Zero};

use crate::errors::{Errors, Mistake};
use crate::model::Type;
use crate::poly::{Poly, Variable, general};
use crate::product::Tables;

/// Reports the types declared null whose square vanishes for zero alone or for nothing.
pub fn can_vanish(types: &[Type], metric: &Metric, errors: &mut Errors) {
    let tables = Tables::new(metric);
    for kind in types.iter().filter(|kind| kind.null) {
        let element = general(kind, 0);
        let square = tables.product(Product::Geometric, &element, &element);
        if square.values().any(|form| is_definite(kind, form)) {
            errors.push(kind.name.span(), Mistake::NeverNull(kind.text()));
        }
    }
}

/// Whether a quadratic form in the coefficients of a type, made homogeneous by one more where
/// some are fixed, vanishes for zero alone.
fn is_definite(kind: &Type, form: &Poly) -> bool {
    let stored: Vec<usize> = (0..kind.slots.len())
        .filter(|slot| kind.slots[*slot].fixed.is_none())
        .collect();
    let size = stored.len() + usize::from(kind.has_fixed());
    let place = |variable: Variable| {
        let mut slots = stored.iter();
        slots.position(|slot| *slot == usize::from(variable.slot))
    };
    let mut matrix = vec![vec![Rational::zero(); size]; size];
    for (monomial, value) in form.terms() {
        let mut places: Vec<usize> = monomial.variables().filter_map(place).collect();
        places.resize(2, size - 1);
        let half = *value / Rational::from_integer(2);
        matrix[places[0]][places[1]] += half;
        matrix[places[1]][places[0]] += half;
    }
    // Definite is what has pivots of one sign on the diagonal, whatever their order.
    let mut sign = None;
    for pivot in 0..size {
        let own = matrix[pivot][pivot];
        if own.is_zero() || sign.is_some_and(|sign| sign != own.is_positive()) {
            return false;
        }
        sign = Some(own.is_positive());
        let row = matrix[pivot].clone();
        for below in matrix.iter_mut().skip(pivot + 1) {
            let factor = below[pivot] / own;
            for (entry, above) in below.iter_mut().zip(&row) {
                *entry -= *above * factor;
            }
        }
    }
    size > 0
}
