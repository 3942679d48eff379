//! The smallest declared type that holds a result.

use ga_core::Rational;

use crate::model::{Model, Type};
use crate::poly::{Element, Poly};

/// Whether every value of the element is a value of the type, fixed coefficients included. No
/// element is known to be null.
pub fn holds(kind: &Type, element: &Element) -> bool {
    !kind.null && fits(kind, element)
}

/// Whether the type has all blades of the element, and the fixed coefficients are its own.
pub fn fits(kind: &Type, element: &Element) -> bool {
    let all_stored = element.keys().all(|mask| kind.slot(*mask).is_some());
    let fixed_agree = kind.slots.iter().all(|slot| match slot.fixed {
        None => true,
        Some(value) => {
            let canonical = value * Rational::from_integer(i128::from(slot.sign));
            element.get(&slot.mask).and_then(Poly::as_constant) == Some(canonical)
        }
    });
    all_stored && fixed_agree
}

/// The type with the fewest fields that holds the element; of equals the one declared first.
/// What vanishes is a scalar, whatever else could hold it.
pub fn smallest(model: &Model, element: &Element) -> Option<usize> {
    if element.is_empty() {
        return model.type_named("Scalar");
    }
    (0..model.types.len())
        .filter(|&i| holds(&model.types[i], element))
        .min_by_key(|&i| model.types[i].field_count())
}

/// The type that sums and multiples of a type belong to: itself, or the smallest without its
/// fixed coefficients and promises.
pub fn sum_type(model: &Model, index: usize) -> Option<usize> {
    if !model.types[index].is_constrained() {
        return Some(index);
    }
    sum_type_of_both(model, index, index)
}

/// The smallest type without fixed coefficients and promises that holds all blades of two types.
pub fn sum_type_of_both(model: &Model, a: usize, b: usize) -> Option<usize> {
    let slots = || model.types[a].slots.iter().chain(&model.types[b].slots);
    let holds_all = |other: &Type| {
        !other.is_constrained() && slots().all(|slot| other.slot(slot.mask).is_some())
    };
    (0..model.types.len())
        .filter(|&i| holds_all(&model.types[i]))
        .min_by_key(|&i| model.types[i].field_count())
}
