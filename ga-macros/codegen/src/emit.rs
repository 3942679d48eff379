//! From the model to Rust: one module with structs, products, versors and conversions.
//!
//! Declarations are built from the user's own tokens, so that names lead back to them; the
//! impls are written as text and parsed once.

mod convert;
mod expression;
mod involutions;
mod products;
mod types;
mod unrolled;
mod versors;

use std::collections::HashMap;

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};

use crate::closure;
use crate::errors::{Errors, Mistake};
use crate::factor::Kernel;
use crate::ledger::{Entry, Ledger};
use crate::model::{Model, Type};
use crate::poly::{self, Element, Poly};
use crate::product::Tables;

/// Names that the generated module brings into scope; types cannot have them.
pub const RESERVED: [&str; 35] = [
    "T",
    "Self",
    "Number",
    "Field",
    "Real",
    "Blade",
    "Element",
    "Geometric",
    "Wedge",
    "LeftContract",
    "RightContract",
    "Inner",
    "ScalarProduct",
    "Regressive",
    "Commutator",
    "Anticommutator",
    "Sandwich",
    "Apply",
    "ApplyUnit",
    "Quotient",
    "Reverse",
    "Involute",
    "Conjugate",
    "Dual",
    "Undual",
    "LeftComplement",
    "RightComplement",
    "NormSquared",
    "Inverse",
    "Exponential",
    "Logarithm",
    "SquareRoot",
    "Narrowing",
    "From",
    "TryFrom",
];

/// What an emission gives: the module, and one line per function.
pub struct Output {
    /// The items.
    pub tokens: TokenStream,
    /// Operation counts.
    pub ledger: Ledger,
}

/// Everything that the emitting files share.
struct Generator<'m> {
    model: &'m Model,
    tables: Tables<'m>,
    /// The general value of every type, as the first and as the second operand.
    general: Vec<[Element; 2]>,
    /// For every type, the type of its sums.
    sums: Vec<Option<usize>>,
    /// Bodies emitted so far, by operands, result type and polynomials.
    emitted: HashMap<(usize, usize, usize, Vec<Poly>), &'static str>,
    /// Products of wide types that others are handed on to, by method and operands.
    widened: HashMap<(&'static str, usize, usize), Option<products::Widened>>,
    /// The impls, as text.
    source: String,
    ledger: Ledger,
}

impl<'m> Generator<'m> {
    fn kind(&self, index: usize) -> &'m Type {
        &self.model.types[index]
    }

    fn name(&self, index: usize) -> String {
        self.model.types[index].text()
    }

    /// Notes a kernel whose numbers generated code could not write down.
    fn check(&self, kernel: &Kernel) {
        if !expression::fits(kernel) {
            self.tables.overflow();
        }
    }

    fn record(&mut self, entry: Entry) {
        self.ledger.entries.push(entry);
    }
}

/// Generates the module of a model.
pub fn emit(model: &Model, errors: &mut Errors) -> Output {
    let general = model
        .types
        .iter()
        .map(|t| [poly::general(t, 0), poly::general(t, 1)])
        .collect();
    let sums = (0..model.types.len())
        .map(|i| closure::sum_type(model, i))
        .collect();
    let mut generator = Generator {
        model,
        tables: Tables::new(&model.metric),
        general,
        sums,
        emitted: HashMap::new(),
        widened: HashMap::new(),
        source: String::new(),
        ledger: Ledger::default(),
    };
    let structs = types::declarations(&generator);
    types::elements(&mut generator);
    convert::conversions(&mut generator);
    convert::conveniences(&mut generator);
    involutions::involutions(&mut generator);
    products::products(&mut generator);
    versors::versors(&mut generator);
    if generator.tables.overflowed() {
        errors.push(model.name.span(), Mistake::Overflow);
    }
    let items: TokenStream = match generator.source.parse() {
        Ok(items) => items,
        // Not reachable by input; reported rather than panicking inside the compiler.
        Err(error) => {
            errors.push(
                Span::call_site(),
                Mistake::Syntax(format!("generated code: {error}")),
            );
            TokenStream::new()
        }
    };
    let tokens = module(model, structs, items);
    generator.ledger.tokens = count(&tokens);
    Output {
        tokens,
        ledger: generator.ledger,
    }
}

/// The module with only its structs, for a call that has errors: completion keeps working.
pub fn emit_structs(model: &Model) -> TokenStream {
    let structs = types::bare_declarations(model);
    let (attributes, visibility, name) = (&model.attributes, &model.visibility, &model.name);
    quote!(#(#attributes)* #visibility mod #name { #structs })
}

fn module(model: &Model, structs: TokenStream, items: TokenStream) -> TokenStream {
    let Model {
        core,
        attributes,
        visibility,
        name,
        ..
    } = model;
    let documentation = types::module_documentation(model, attributes.is_empty());
    // A deprecated type is for its users to replace; the module itself goes on using it.
    let is_deprecated = |kind: &Type| {
        let mut attributes = kind.attributes.iter();
        attributes.any(|attribute| attribute.path().is_ident("deprecated"))
    };
    let allowance = model
        .types
        .iter()
        .any(is_deprecated)
        .then(|| quote!(#[allow(deprecated)]));
    // A path that leads nowhere is the path's mistake, not the whole call's.
    let first = core.segments.first().map(|segment| segment.ident.span());
    let span = Span::call_site().located_at(first.unwrap_or_else(Span::call_site));
    let entry = quote_spanned!(span=> use #core as algebra;);
    quote! {
        #(#attributes)*
        #documentation
        #allowance
        #visibility mod #name {
            #entry
            use algebra::{Blade, Element, Field, Real, Scalar as Number};
            use algebra::ops::{
                Anticommutator, ApplyUnit, Commutator, Conjugate, Dual, Exponential, Geometric, Inner,
                Inverse, Involute, LeftComplement, LeftContract, Logarithm, NormSquared, Quotient,
                Regressive, Reverse, RightComplement, RightContract, Sandwich, ScalarProduct,
                SquareRoot, Undual, Wedge,
            };
            #structs
            #items
        }
    }
}

/// The number of tokens of a stream, groups counted with their two delimiters.
pub fn count(tokens: &TokenStream) -> usize {
    tokens
        .clone()
        .into_iter()
        .map(|token| match token {
            proc_macro2::TokenTree::Group(group) => 2 + count(&group.stream()),
            _ => 1,
        })
        .sum()
}
