//! The types that are always there keep their standard meaning.

use proc_macro2::{Ident, Span};

use crate::blades;
use crate::errors::{Errors, Mistake};
use crate::model::{COMPLETE_LIMIT, Slot, Type, grade_name};

/// All masks whose grade is wanted, by grade, then by mask.
pub fn masks_where(dimension: usize, wanted: impl Fn(u32) -> bool) -> Vec<u32> {
    let mut masks: Vec<u32> = (0..1_u32 << dimension)
        .filter(|mask| wanted(mask.count_ones()))
        .collect();
    masks.sort_by_key(|mask| (mask.count_ones(), *mask));
    masks
}

/// The coefficient of a blade in increasing order of its vectors.
pub fn slot(mask: u32, names: &[String]) -> Slot {
    Slot {
        mask,
        sign: 1,
        field: blades::field_name(&blades::indices(mask), names),
        fixed: None,
    }
}

fn standard_type(name: &str, masks: &[u32], names: &[String]) -> Type {
    Type {
        attributes: Vec::new(),
        name: Ident::new(name, Span::call_site()),
        unit: false,
        null: false,
        slots: masks.iter().map(|&mask| slot(mask, names)).collect(),
    }
}

/// The type of all blades of one grade.
pub fn grade_type(grade: usize, names: &[String]) -> Type {
    let masks = masks_where(names.len(), |g| g as usize == grade);
    standard_type(grade_name(grade), &masks, names)
}

/// The types that are always there, with the blades that they stand for.
fn standard_masks(dimension: usize) -> Vec<(&'static str, &'static str, Vec<u32>)> {
    let mut list = vec![("Scalar", "the scalar `{ 1 }`", vec![0])];
    if dimension <= COMPLETE_LIMIT {
        let even = masks_where(dimension, |g| g % 2 == 0);
        let odd = masks_where(dimension, |g| g % 2 == 1);
        let all = masks_where(dimension, |_| true);
        list.push(("Even", "all even blades, `= even;`", even));
        list.push(("Odd", "all odd blades, `= odd;`", odd));
        list.push(("Multivector", "all blades, `= all;`", all));
    }
    list
}

/// `Scalar`, `Even`, `Odd` and `Multivector` keep their meaning.
pub fn keeps_meaning(kind: &Type, dimension: usize, errors: &mut Errors) {
    for (name, meaning, masks) in standard_masks(dimension) {
        if kind.name != name || kind.slots.is_empty() {
            continue;
        }
        let mut own: Vec<u32> = kind.slots.iter().map(|slot| slot.mask).collect();
        own.sort_by_key(|mask| (mask.count_ones(), *mask));
        if own != masks || kind.is_constrained() {
            let mistake = Mistake::MisusedName {
                name: name.into(),
                meaning: meaning.into(),
            };
            errors.push(kind.name.span(), mistake);
        }
    }
}

/// Adds those that were not declared.
pub fn add(types: &mut Vec<Type>, names: &[String]) {
    for (name, _, masks) in standard_masks(names.len()) {
        if !types.iter().any(|t| t.name == name) {
            types.push(standard_type(name, &masks, names));
        }
    }
}
