//! Type names are distinct and free; blades are known, distinct and not all fixed.

use ga_core::Rational;
use proc_macro2::Ident;

use super::standard::{self, masks_where};
use crate::ast::{Algebra, Coefficient, Content, Spans, TypeDeclaration};
use crate::blades::{self, Reading, spelled};
use crate::emit;
use crate::errors::{Errors, Mistake, closest};
use crate::model::{COMPLETE_LIMIT, FIELD_LIMIT, Slot, Type};

/// The declared types; of two with one name, the first.
pub fn declared(algebra: &Algebra, names: &[String], errors: &mut Errors) -> Vec<Type> {
    let mut types: Vec<Type> = Vec::new();
    for declaration in algebra.types.iter().flatten() {
        name_is_free(declaration, &types, errors);
        let kind = Type {
            attributes: declaration.attributes.clone(),
            name: declaration.name.clone(),
            unit: declaration.unit,
            null: declaration.null,
            slots: slots(algebra, declaration, names, errors),
        };
        if kind.unit && kind.parity().is_none() {
            errors.push(kind.name.span(), Mistake::UnitMixedParity(kind.text()));
        }
        standard::keeps_meaning(&kind, names.len(), errors);
        // Beside the type parameter of the same name, a struct `T` would be further errors.
        if kind.name != "T" && !types.iter().any(|t| t.name == kind.name) {
            types.push(kind);
        }
    }
    types
}

fn name_is_free(declaration: &TypeDeclaration, types: &[Type], errors: &mut Errors) {
    let name = declaration.name.to_string();
    let span = declaration.name.span();
    if types.iter().any(|t| t.name == declaration.name) {
        errors.push(span, Mistake::DuplicateType(name));
    } else if emit::RESERVED.contains(&name.as_str()) {
        errors.push(span, Mistake::ReservedType(name));
    } else if name.starts_with(|c: char| c.is_lowercase() || c == '_') || name.contains('_') {
        let suggestion = camel_case(&name);
        errors.push(span, Mistake::TypeCase { name, suggestion });
    }
}

fn camel_case(name: &str) -> String {
    name.split('_')
        .map(|word| {
            let mut letters = word.chars();
            letters.next().map_or(String::new(), |first| {
                first.to_uppercase().chain(letters).collect::<String>()
            })
        })
        .collect()
}

/// The coefficients of a type; none where they cannot be made out.
fn slots(
    algebra: &Algebra,
    declaration: &TypeDeclaration,
    names: &[String],
    errors: &mut Errors,
) -> Vec<Slot> {
    let dimension = names.len();
    let masks: Vec<u32> = match &declaration.content {
        Content::Blades(list) => return listed(algebra, declaration, list, names, errors),
        Content::Grade(number) => match number.base10_parse::<u32>() {
            Ok(grade) if grade as usize <= dimension => masks_where(dimension, |g| g == grade),
            _ => {
                let grade = number.base10_digits().to_owned();
                let mistake = Mistake::GradeTooLarge { grade, dimension };
                errors.push(number.span(), mistake);
                return Vec::new();
            }
        },
        Content::Even => masks_where(dimension, |g| g % 2 == 0),
        Content::Odd => masks_where(dimension, |g| g % 2 == 1),
        Content::All => masks_where(dimension, |_| true),
        Content::Unknown => return Vec::new(),
    };
    if too_large(declaration, masks.len(), errors) {
        return Vec::new();
    }
    masks
        .into_iter()
        .map(|mask| standard::slot(mask, names))
        .collect()
}

fn too_large(declaration: &TypeDeclaration, fields: usize, errors: &mut Errors) -> bool {
    let too_large = fields > FIELD_LIMIT;
    if too_large {
        let mistake = Mistake::TypeTooLarge {
            name: declaration.name.to_string(),
            fields,
            limit: FIELD_LIMIT,
        };
        errors.push(declaration.name.span(), mistake);
    }
    too_large
}

fn listed(
    algebra: &Algebra,
    declaration: &TypeDeclaration,
    list: &[Coefficient],
    names: &[String],
    errors: &mut Errors,
) -> Vec<Slot> {
    let name = declaration.name.to_string();
    let mut slots: Vec<(Slot, String)> = Vec::new();
    let before = errors.count();
    for coefficient in list {
        let Some(indices) = blade_indices(algebra, coefficient, names, errors) else {
            continue;
        };
        let text = blade_text(coefficient);
        let mask = indices.iter().fold(0, |mask, i| mask | 1 << i);
        if let Some((_, first)) = slots.iter().find(|(slot, _)| slot.mask == mask) {
            let mistake = Mistake::DuplicateBlade {
                blade: text,
                first: first.clone(),
            };
            errors.push_range(coefficient.spans, mistake);
            continue;
        }
        let fixed = coefficient.fixed.as_ref().map(|number| {
            if number.value.0 == 0 {
                errors.push_range(number.spans, Mistake::FixedZero(text.clone()));
            }
            Rational::new(number.value.0, number.value.1)
        });
        let slot = Slot {
            mask,
            sign: blades::permutation_sign(&indices),
            field: blades::field_name(&indices, names),
            fixed,
        };
        slots.push((slot, text));
    }
    if list.is_empty() {
        errors.push(declaration.name.span(), Mistake::EmptyType(name));
    } else if errors.count() == before && slots.iter().all(|(slot, _)| slot.fixed.is_some()) {
        errors.push(declaration.name.span(), Mistake::NothingFree(name));
    } else if too_large(declaration, slots.len(), errors) {
        return Vec::new();
    }
    slots.into_iter().map(|(slot, _)| slot).collect()
}

fn blade_text(coefficient: &Coefficient) -> String {
    if coefficient.factors.is_empty() {
        return "1".to_owned();
    }
    let words: Vec<String> = coefficient.factors.iter().map(Ident::to_string).collect();
    words.join("^")
}

/// The basis vectors of a blade in the order written, each once.
fn blade_indices(
    algebra: &Algebra,
    coefficient: &Coefficient,
    names: &[String],
    errors: &mut Errors,
) -> Option<Vec<usize>> {
    let mut indices = Vec::new();
    let before = errors.count();
    for factor in &coefficient.factors {
        let name = factor.to_string();
        match blades::read(&name, names) {
            Reading::Blade(found) => indices.extend(found),
            Reading::Unknown => {
                let mistake = Mistake::UnknownBlade {
                    basis: blades::listed(names),
                    named: algebra.basis.is_some(),
                    suggestion: closest(&name, blade_names(names).iter().map(String::as_str)),
                    name,
                };
                errors.push(factor.span(), mistake);
            }
            Reading::Ambiguous(first, second) => {
                let (first, second) = (spelled(&first, names), spelled(&second, names));
                let mistake = Mistake::AmbiguousBlade {
                    name,
                    first,
                    second,
                };
                errors.push(factor.span(), mistake);
            }
        }
    }
    let repeated = indices
        .iter()
        .enumerate()
        .find(|(i, index)| indices[..*i].contains(index));
    if let Some((_, &index)) = repeated {
        let factor = names[index].clone();
        let blade = blade_text(coefficient);
        errors.push_range(coefficient.spans, Mistake::RepeatedFactor { blade, factor });
    }
    (errors.count() == before).then_some(indices)
}

/// Names to suggest from: vectors, and all blades where they are few.
fn blade_names(names: &[String]) -> Vec<String> {
    let few = names.len() <= COMPLETE_LIMIT;
    let count = if few { 1_u32 << names.len() } else { 0 };
    let blades = (1..count).map(|mask| blades::field_name(&blades::indices(mask), names));
    names.iter().cloned().chain(blades).collect()
}

/// No two coefficients of a type are the same field.
pub fn have_distinct_fields(types: &mut [Type], algebra: &Algebra, errors: &mut Errors) {
    let before = errors.count();
    for kind in types {
        let mut fields: Vec<String> = Vec::new();
        let (name, spans) = (kind.text(), spans_of(kind, algebra));
        for slot in &mut kind.slots {
            if fields.contains(&slot.field) {
                // The standard types hold the same blades again: one message is enough.
                if errors.count() == before {
                    let (name, field) = (name.clone(), slot.field.clone());
                    errors.push_range(spans, Mistake::FieldClash { name, field });
                }
                slot.field = format!("{}_{}", slot.field, slot.mask);
            }
            fields.push(slot.field.clone());
        }
    }
}

/// Where a type was declared; a standard type stands with the signature that asks for it.
fn spans_of(kind: &Type, algebra: &Algebra) -> Spans {
    let mut declared = algebra.types.iter().flatten();
    match declared.find(|declaration| declaration.name == kind.name) {
        Some(declaration) => (declaration.name.span(), declaration.name.span()),
        None => algebra.signature.spans,
    }
}

/// A type with fixed coefficients or of null elements has a type that its sums widen to.
pub fn have_sums(types: &[Type], dimension: usize, errors: &mut Errors) {
    if dimension <= COMPLETE_LIMIT {
        return; // `Even`, `Odd` and `Multivector` are there.
    }
    let holds = |other: &Type, kind: &Type| {
        let mut slots = kind.slots.iter();
        !other.is_constrained() && slots.all(|slot| other.slot(slot.mask).is_some())
    };
    for kind in types.iter().filter(|kind| kind.is_constrained()) {
        if !types.iter().any(|other| holds(other, kind)) {
            let blades: Vec<&str> = kind.slots.iter().map(|slot| slot.field.as_str()).collect();
            let mistake = Mistake::FixedCannotBeKept {
                name: kind.text(),
                blades: blades.join(", "),
            };
            errors.push(kind.name.span(), mistake);
        }
    }
}
