//! From what was written to what it means; every mistake is found in one pass.
//!
//! The rules, one function each: the signature is of the form `Rp_q_r` and within the limits;
//! the basis names as many distinct vectors; the metric is symmetric, rational and has the
//! declared signature; type names are distinct, free and in camel case; blades are known,
//! distinct within a type and not all fixed; standard names keep their standard meaning;
//! types with fixed coefficients or of null elements have a type to widen to, and null elements
//! exist; products are known and listed once.

mod metric;
mod null;
mod products;
mod signature;
mod standard;
mod types;

use crate::ast::Input;
use crate::errors::{Errors, Mistake};
use crate::model::Model;

/// Checks a call; a model is returned whenever one can be made sense of, errors or not.
pub fn check(input: Input, errors: &mut Errors) -> Option<Model> {
    let Input { core, algebra } = input;
    let counts = signature::counts(&algebra.signature, errors);
    let dimension = signature::dimension(&algebra, counts, errors);
    let before = errors.count();
    let names = metric::basis_names(&algebra, counts, dimension.vectors, errors);
    let metric = metric::metric(&algebra, counts, &names, errors)?;
    if dimension.known {
        metric::has_signature(&algebra, counts, &metric, errors);
    }
    let mut types = types::declared(&algebra, &names, errors);
    if algebra.types.is_none() {
        types.extend((0..=names.len()).map(|grade| standard::grade_type(grade, &names)));
    }
    standard::add(&mut types, &names);
    types::have_distinct_fields(&mut types, &algebra, errors);
    types::have_sums(&types, names.len(), errors);
    null::can_vanish(&types, &metric, errors);
    if !dimension.known {
        // Blades of a basis that was guessed cannot be held against anyone.
        errors.forget_since(before, Mistake::is_about_blades);
    }
    let (products, apply) = products::products(algebra.products.as_deref(), errors);
    let (p, q, r) = metric.signature();
    Some(Model {
        core: core.unwrap_or_else(|| syn::parse_quote!(::ga_core)),
        attributes: algebra.attributes,
        visibility: algebra.visibility,
        name: algebra.name,
        signature: signature::text(p, q, r),
        metric,
        types,
        products,
        apply,
    })
}
