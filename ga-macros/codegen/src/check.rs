//! From what was written to what it means; every mistake is found in one pass.
//!
//! The rules, one function each: the signature is of the form `Rp_q_r` and within the limits;
//! the basis names as many distinct vectors; the metric is symmetric, rational and has the
//! declared signature; type names are distinct, free and in camel case; blades are known,
//! distinct within a type and not all fixed; standard names keep their standard meaning;
//! types with fixed coefficients have a type to widen to; products are known and listed once.

use std::collections::HashMap;

use ga_core::{Metric, MetricError, Product, Rational};
use proc_macro2::{Ident, Span};

use crate::ast::{Algebra, Coefficient, Content, Input, MetricEntry, Signature, TypeDeclaration};
use crate::blades::{self, Reading};
use crate::emit;
use crate::errors::{Errors, Mistake, closest};
use crate::model::{COMPLETE_LIMIT, DECLARED_LIMIT, FIELD_LIMIT, Model, Slot, Type, grade_name};

/// Checks a call; a model is returned whenever one can be made sense of, errors or not.
pub fn check(input: Input, errors: &mut Errors) -> Option<Model> {
    let Input { core, algebra } = input;
    let counts = signature_counts(&algebra.signature, errors);
    let dimension = dimension(&algebra, counts, errors)?;
    let names = basis_names(&algebra, dimension, errors);
    let metric = metric(&algebra, counts, &names, errors)?;
    signature_matches(&algebra, &metric, errors);
    let mut types = declared_types(&algebra, &names, errors);
    if algebra.types.is_none() {
        types.extend((0..=dimension).map(|grade| grade_type(grade, &names)));
    }
    add_standard_types(&mut types, &names);
    sums_have_a_type(&types, dimension, errors);
    let (products, apply) = products(algebra.products.as_deref(), errors);
    let (p, q, r) = metric.signature();
    Some(Model {
        core: core.unwrap_or_else(|| syn::parse_quote!(::ga_core)),
        attributes: algebra.attributes,
        visibility: algebra.visibility,
        name: algebra.name,
        signature: signature_text(p, q, r),
        metric,
        types,
        products,
        apply,
    })
}

/// The shortest name of a signature: `R3`, `R4_1`, `R3_0_1`.
fn signature_text(p: usize, q: usize, r: usize) -> String {
    match (q, r) {
        (0, 0) => format!("R{p}"),
        (_, 0) => format!("R{p}_{q}"),
        _ => format!("R{p}_{q}_{r}"),
    }
}

/// The signature is of the form `Rp_q_r`.
fn signature_counts(signature: &Signature, errors: &mut Errors) -> Option<(usize, usize, usize)> {
    let counts = (|| {
        let mut parts = signature.text.strip_prefix('R')?.split('_');
        let mut next = || match parts.next() {
            None => Some(0),
            Some(part) if part.bytes().all(|b| b.is_ascii_digit()) => part.parse().ok(),
            Some(_) => None,
        };
        let counts: (usize, usize, usize) = (next()?, next()?, next()?);
        (parts.next().is_none()).then_some(counts)
    })();
    if counts.is_none() {
        errors.push(
            signature.span,
            Mistake::UnknownSignature(signature.text.clone()),
        );
    }
    counts
}

/// The dimension is at least one and within the limits.
fn dimension(
    algebra: &Algebra,
    counts: Option<(usize, usize, usize)>,
    errors: &mut Errors,
) -> Option<usize> {
    let signature = &algebra.signature;
    let Some((p, q, r)) = counts else {
        // The rest of the call is still checked against the basis, where one is given.
        return algebra
            .basis
            .as_ref()
            .map(Vec::len)
            .filter(|n| (1..=DECLARED_LIMIT).contains(n));
    };
    let dimension = p.saturating_add(q).saturating_add(r);
    let complete = algebra.types.is_none();
    let limit = if complete {
        COMPLETE_LIMIT
    } else {
        DECLARED_LIMIT
    };
    if dimension == 0 {
        errors.push(signature.span, Mistake::NoDimension(signature.text.clone()));
        return None;
    }
    if dimension > limit {
        let mistake = Mistake::TooManyDimensions {
            dimension,
            limit,
            preset: complete,
        };
        errors.push(signature.span, mistake);
        return None;
    }
    Some(dimension)
}

/// The basis names as many distinct vectors as the signature counts.
fn basis_names(algebra: &Algebra, dimension: usize, errors: &mut Errors) -> Vec<String> {
    let standard = || (1..=dimension).map(|i| format!("e{i}")).collect::<Vec<_>>();
    let Some(basis) = &algebra.basis else {
        return standard();
    };
    let names: Vec<String> = basis.iter().map(Ident::to_string).collect();
    for (i, (name, token)) in names.iter().zip(basis).enumerate() {
        if names[..i].contains(name) {
            errors.push(token.span(), Mistake::DuplicateBasisName(name.clone()));
        } else if name == "s" || name == "T" || syn::parse_str::<Ident>(name).is_err() {
            errors.push(token.span(), Mistake::ReservedBasisName(name.clone()));
        } else {
            let others: Vec<String> = names.iter().filter(|n| *n != name).cloned().collect();
            let reads = blades::read(name, &others);
            // From ten dimensions on `e12` is a vector, and blades are spelled with `^`.
            if reads != Reading::Unknown && dimension < 10 {
                let reading = reading_text(&reads, &others);
                errors.push(
                    token.span(),
                    Mistake::AmbiguousBasisName {
                        name: name.clone(),
                        reading,
                    },
                );
            }
        }
    }
    if names.len() != dimension {
        let span = basis
            .get(dimension)
            .map_or(algebra.signature.span, Ident::span);
        errors.push(
            span,
            Mistake::BasisCount {
                signature: algebra.signature.text.clone(),
                expected: dimension,
                found: names.len(),
            },
        );
    }
    let mut distinct = names.clone();
    distinct.sort();
    distinct.dedup();
    if distinct.len() == dimension && names.len() == dimension {
        names
    } else {
        standard()
    }
}

fn reading_text(reading: &Reading, names: &[String]) -> String {
    match reading {
        Reading::Blade(indices) | Reading::Ambiguous(indices, _) => spelled(indices, names),
        Reading::Unknown => String::new(),
    }
}

fn spelled(indices: &[usize], names: &[String]) -> String {
    let words: Vec<&str> = indices.iter().map(|&i| names[i].as_str()).collect();
    format!("`{}`", words.join("^"))
}

/// The metric is symmetric and rational; without one, the vectors are orthonormal.
fn metric(
    algebra: &Algebra,
    counts: Option<(usize, usize, usize)>,
    names: &[String],
    errors: &mut Errors,
) -> Option<Metric> {
    let dimension = names.len();
    let mut gram = vec![vec![Rational::from_integer(0); dimension]; dimension];
    match &algebra.metric {
        None => {
            let (p, q, _) = counts.unwrap_or((dimension, 0, 0));
            for (i, row) in gram.iter_mut().enumerate().take(p + q) {
                row[i] = Rational::from_integer(if i < p { 1 } else { -1 });
            }
        }
        Some(entries) => fill(entries, names, &mut gram, errors),
    }
    match Metric::new(names.to_vec(), gram) {
        Ok(metric) => Some(metric),
        Err(MetricError::Overflow) => {
            errors.push(algebra.signature.span, Mistake::Overflow);
            None
        }
        Err(error) => {
            errors.push(algebra.signature.span, Mistake::Syntax(error.to_string()));
            None
        }
    }
}

fn fill(
    entries: &[MetricEntry],
    names: &[String],
    gram: &mut [Vec<Rational>],
    errors: &mut Errors,
) {
    let mut given: HashMap<(usize, usize), Rational> = HashMap::new();
    for entry in entries {
        let mut find = |token: &Ident| {
            let name = token.to_string();
            let index = names.iter().position(|n| *n == name);
            if index.is_none() {
                let suggestion = closest(&name, names.iter().map(String::as_str));
                errors.push(
                    token.span(),
                    Mistake::UnknownBasisVector { name, suggestion },
                );
            }
            index
        };
        let (Some(i), Some(j)) = (find(&entry.left), find(&entry.right)) else {
            continue;
        };
        let (numerator, denominator) = entry.value.value;
        let value = Rational::new(numerator, denominator);
        let (left, right) = (entry.left.to_string(), entry.right.to_string());
        match given.insert((i.min(j), i.max(j)), value) {
            Some(before) if before != value => {
                errors.push(entry.value.span, Mistake::NotSymmetric { left, right });
            }
            Some(_) => {
                errors.push(
                    entry.left.span(),
                    Mistake::DuplicateMetricEntry { left, right },
                );
            }
            None => {}
        }
        gram[i][j] = value;
        gram[j][i] = value;
    }
}

/// The metric has the signature that is declared.
fn signature_matches(algebra: &Algebra, metric: &Metric, errors: &mut Errors) {
    let mut silent = Errors::default();
    let declared = signature_counts(&algebra.signature, &mut silent);
    let Some(declared) = declared else {
        return;
    };
    let actual = metric.signature();
    // A wrong number of basis vectors has been reported already and says more.
    let counted = algebra
        .basis
        .as_ref()
        .is_none_or(|basis| basis.len() == metric.dimension());
    if declared != actual && counted {
        errors.push(
            algebra.signature.span,
            Mistake::SignatureMismatch {
                declared: algebra.signature.text.clone(),
                actual: signature_text(actual.0, actual.1, actual.2),
            },
        );
    }
}

/// Type names are distinct and free, blades known and distinct.
fn declared_types(algebra: &Algebra, names: &[String], errors: &mut Errors) -> Vec<Type> {
    let mut types: Vec<Type> = Vec::new();
    for declaration in algebra.types.iter().flatten() {
        let before = errors.count();
        type_name(declaration, &types, errors);
        let slots = slots(declaration, names, errors);
        let kind = Type {
            attributes: declaration.attributes.clone(),
            name: declaration.name.clone(),
            unit: declaration.unit,
            slots,
        };
        if kind.unit && kind.parity().is_none() {
            errors.push(kind.name.span(), Mistake::UnitMixedParity(kind.text()));
        }
        standard_meaning(&kind, names.len(), errors);
        if errors.count() == before || !types.iter().any(|t| t.name == kind.name) {
            types.push(kind);
        }
    }
    types
}

fn type_name(declaration: &TypeDeclaration, types: &[Type], errors: &mut Errors) {
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

fn slots(declaration: &TypeDeclaration, names: &[String], errors: &mut Errors) -> Vec<Slot> {
    let name = declaration.name.to_string();
    let dimension = names.len();
    let masks: Vec<u32> = match &declaration.content {
        Content::Blades(list) => return listed_slots(declaration, list, names, errors),
        Content::Grade(grade, span) if *grade as usize > dimension => {
            errors.push(
                *span,
                Mistake::GradeTooLarge {
                    grade: *grade,
                    dimension,
                },
            );
            return Vec::new();
        }
        Content::Grade(grade, _) => masks_where(dimension, |g| g == *grade),
        Content::Even => masks_where(dimension, |g| g % 2 == 0),
        Content::Odd => masks_where(dimension, |g| g % 2 == 1),
        Content::All => masks_where(dimension, |_| true),
    };
    let fields = masks.len();
    if fields > FIELD_LIMIT {
        errors.push(
            declaration.name.span(),
            Mistake::TypeTooLarge {
                name,
                fields,
                limit: FIELD_LIMIT,
            },
        );
        return Vec::new();
    }
    masks
        .into_iter()
        .map(|mask| standard_slot(mask, names))
        .collect()
}

fn listed_slots(
    declaration: &TypeDeclaration,
    list: &[Coefficient],
    names: &[String],
    errors: &mut Errors,
) -> Vec<Slot> {
    let name = declaration.name.to_string();
    let mut slots: Vec<(Slot, String)> = Vec::new();
    for coefficient in list {
        let Some(indices) = blade_indices(coefficient, names, errors) else {
            continue;
        };
        let text = blade_text(coefficient);
        let mask = indices.iter().fold(0, |mask, i| mask | 1 << i);
        if let Some((_, first)) = slots.iter().find(|(slot, _)| slot.mask == mask) {
            let mistake = Mistake::DuplicateBlade {
                blade: text,
                first: first.clone(),
            };
            errors.push(coefficient.span, mistake);
            continue;
        }
        let fixed = coefficient.fixed.as_ref().map(|number| {
            if number.value.0 == 0 {
                errors.push(number.span, Mistake::FixedZero(text.clone()));
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
    } else if !slots.is_empty() && slots.iter().all(|(slot, _)| slot.fixed.is_some()) {
        errors.push(declaration.name.span(), Mistake::NothingFree(name));
    } else if slots.len() > FIELD_LIMIT {
        let fields = slots.len();
        let mistake = Mistake::TypeTooLarge {
            name,
            fields,
            limit: FIELD_LIMIT,
        };
        errors.push(declaration.name.span(), mistake);
        slots.clear();
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
    coefficient: &Coefficient,
    names: &[String],
    errors: &mut Errors,
) -> Option<Vec<usize>> {
    let mut indices = Vec::new();
    for factor in &coefficient.factors {
        let word = factor.to_string();
        match blades::read(&word, names) {
            Reading::Blade(found) => indices.extend(found),
            Reading::Unknown => {
                let suggestion = closest(&word, blade_names(names).iter().map(String::as_str));
                errors.push(
                    factor.span(),
                    Mistake::UnknownBlade {
                        name: word,
                        suggestion,
                    },
                );
                return None;
            }
            Reading::Ambiguous(first, second) => {
                let (first, second) = (spelled(&first, names), spelled(&second, names));
                errors.push(
                    factor.span(),
                    Mistake::AmbiguousBlade {
                        name: word,
                        first,
                        second,
                    },
                );
                return None;
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
        errors.push(coefficient.span, Mistake::RepeatedFactor { blade, factor });
        return None;
    }
    Some(indices)
}

/// Names to suggest from: vectors, and all blades where they are few.
fn blade_names(names: &[String]) -> Vec<String> {
    let count = if names.len() <= COMPLETE_LIMIT {
        1_u32 << names.len()
    } else {
        0
    };
    let blades = (1..count).map(|mask| blades::field_name(&blades::indices(mask), names));
    names.iter().cloned().chain(blades).collect()
}

/// All masks whose grade is wanted, by grade, then by mask.
fn masks_where(dimension: usize, wanted: impl Fn(u32) -> bool) -> Vec<u32> {
    let mut masks: Vec<u32> = (0..1_u32 << dimension)
        .filter(|mask| wanted(mask.count_ones()))
        .collect();
    masks.sort_by_key(|mask| (mask.count_ones(), *mask));
    masks
}

fn standard_slot(mask: u32, names: &[String]) -> Slot {
    let field = blades::field_name(&blades::indices(mask), names);
    Slot {
        mask,
        sign: 1,
        field,
        fixed: None,
    }
}

fn standard_type(name: &str, masks: &[u32], names: &[String]) -> Type {
    Type {
        attributes: Vec::new(),
        name: Ident::new(name, Span::call_site()),
        unit: false,
        slots: masks
            .iter()
            .map(|&mask| standard_slot(mask, names))
            .collect(),
    }
}

fn grade_type(grade: usize, names: &[String]) -> Type {
    let masks = masks_where(names.len(), |g| g as usize == grade);
    standard_type(grade_name(grade), &masks, names)
}

/// The types that are always there, with the blades that they stand for.
fn standard_masks(dimension: usize) -> Vec<(&'static str, &'static str, Vec<u32>)> {
    let mut list = vec![("Scalar", "the scalar `{ 1 }`", vec![0])];
    if dimension <= COMPLETE_LIMIT {
        let even = masks_where(dimension, |g| g % 2 == 0);
        let odd = masks_where(dimension, |g| g % 2 == 1);
        list.push(("Even", "all even blades, `= even;`", even));
        list.push(("Odd", "all odd blades, `= odd;`", odd));
        list.push((
            "Multivector",
            "all blades, `= all;`",
            masks_where(dimension, |_| true),
        ));
    }
    list
}

/// `Scalar`, `Even`, `Odd` and `Multivector` keep their meaning.
fn standard_meaning(kind: &Type, dimension: usize, errors: &mut Errors) {
    for (name, meaning, masks) in standard_masks(dimension) {
        if kind.name != name || kind.slots.is_empty() {
            continue;
        }
        let mut own: Vec<u32> = kind.slots.iter().map(|slot| slot.mask).collect();
        own.sort_by_key(|mask| (mask.count_ones(), *mask));
        if own != masks || kind.has_fixed() {
            let mistake = Mistake::MisusedName {
                name: name.into(),
                meaning: meaning.into(),
            };
            errors.push(kind.name.span(), mistake);
        }
    }
}

fn add_standard_types(types: &mut Vec<Type>, names: &[String]) {
    for (name, _, masks) in standard_masks(names.len()) {
        if !types.iter().any(|t| t.name == name) {
            types.push(standard_type(name, &masks, names));
        }
    }
}

/// A type with fixed coefficients has a type that its sums widen to.
fn sums_have_a_type(types: &[Type], dimension: usize, errors: &mut Errors) {
    if dimension <= COMPLETE_LIMIT {
        return;
    }
    for kind in types.iter().filter(|t| t.has_fixed()) {
        let holds = |other: &Type| {
            !other.has_fixed()
                && kind
                    .slots
                    .iter()
                    .all(|slot| other.slot(slot.mask).is_some())
        };
        if !types.iter().any(holds) {
            let blades: Vec<&str> = kind.slots.iter().map(|slot| slot.field.as_str()).collect();
            errors.push(
                kind.name.span(),
                Mistake::FixedCannotBeKept {
                    name: kind.text(),
                    blades: blades.join(", "),
                },
            );
        }
    }
}

/// Products are known and listed once; without a list, all are generated.
fn products(listed: Option<&[Ident]>, errors: &mut Errors) -> (Vec<Product>, bool) {
    let Some(listed) = listed else {
        return (Product::ALL.to_vec(), true);
    };
    let mut products = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    let (mut apply, mut project) = (false, false);
    for token in listed {
        let name = token.to_string();
        if seen.contains(&name) {
            errors.push(token.span(), Mistake::DuplicateProduct(name));
            continue;
        }
        match name.as_str() {
            "apply" | "sandwich" => apply = true,
            "project" | "reject" => project = true,
            _ => match Product::ALL.iter().find(|product| product.method() == name) {
                Some(product) => products.push(*product),
                None => {
                    let suggestion = product_suggestion(&name);
                    let name = name.clone();
                    errors.push(token.span(), Mistake::UnknownProduct { name, suggestion });
                }
            },
        }
        seen.push(name);
    }
    // Projection is a contraction, and a sandwich is two geometric products.
    let mut require = |product: Product, wanted: bool| {
        if wanted && !products.contains(&product) {
            products.push(product);
        }
    };
    require(Product::Geometric, apply || project);
    require(Product::LeftContract, project);
    (products, apply)
}

/// The product meant by another library's name, or the closest name.
fn product_suggestion(name: &str) -> Option<String> {
    const SYNONYMS: [(&str, &str); 12] = [
        ("outer", "wedge"),
        ("exterior", "wedge"),
        ("join", "wedge"),
        ("meet", "regressive"),
        ("vee", "regressive"),
        ("antiwedge", "regressive"),
        ("dot", "inner"),
        ("contract", "left_contract"),
        ("left_contraction", "left_contract"),
        ("right_contraction", "right_contract"),
        ("scalar", "scalar_product"),
        ("gp", "geometric"),
    ];
    if let Some((_, ours)) = SYNONYMS.iter().find(|(theirs, _)| *theirs == name) {
        return Some((*ours).to_owned());
    }
    let methods = Product::ALL.iter().map(|product| product.method());
    closest(
        name,
        methods.chain(["apply", "sandwich", "project", "reject"]),
    )
}
