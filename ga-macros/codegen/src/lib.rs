//! The code generator behind `define_algebra!`, as an ordinary library.
//!
//! Text flows one way: tokens → `parse` → `ast` → `check` → `model` → `product`, one
//! exact polynomial per blade of a result → `factor`, the body that computes it → `emit`.
//!
//! ```
//! let source = ga_codegen::expand("R2");
//! assert!(source.contains("pub struct Bivector<T = f64>"));
//!
//! let mistakes = ga_codegen::try_expand("R0_0").unwrap_err();
//! assert!(mistakes.contains("has no dimension"));
//! ```

mod ast;
mod blades;
mod check;
mod closure;
mod emit;
mod errors;
mod factor;
pub mod isomorphism;
mod layout;
mod ledger;
mod model;
mod parse;
mod poly;
mod product;

use proc_macro2::TokenStream;
use quote::quote;

pub use ledger::Ledger;

use errors::{Errors, Mistake};

/// The expansion of a call. Mistakes become `compile_error!` items on the tokens that are
/// wrong, followed by the structs that could be made sense of.
pub fn expand_tokens(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(model) = checked(tokens, &mut errors) else {
        return errors.to_tokens();
    };
    if errors.is_empty() {
        let output = emit::emit(&model, &mut errors);
        if errors.is_empty() {
            return output.tokens;
        }
    }
    let (messages, structs) = (errors.to_tokens(), emit::emit_structs(&model));
    quote!(#messages #structs)
}

/// The expansion of a call as formatted Rust, mistakes as `compile_error!` items in it.
pub fn expand(text: &str) -> String {
    match text.parse() {
        Ok(tokens) => format(expand_tokens(tokens)),
        Err(error) => format(quote_error(&unreadable(&error))),
    }
}

/// The expansion of a call as formatted Rust.
///
/// # Errors
/// One line `line:column: message` for each mistake in the call.
pub fn try_expand(text: &str) -> Result<String, String> {
    generated(text).map(|output| format(output.tokens))
}

/// The operation counts of a call.
///
/// # Errors
/// One line `line:column: message` for each mistake in the call.
pub fn ledger(text: &str) -> Result<Ledger, String> {
    generated(text).map(|output| output.ledger)
}

fn generated(text: &str) -> Result<emit::Output, String> {
    let tokens = text.parse().map_err(|error| unreadable(&error))?;
    let mut errors = Errors::default();
    if let Some(model) = checked(tokens, &mut errors)
        && errors.is_empty()
    {
        let output = emit::emit(&model, &mut errors);
        if errors.is_empty() {
            return Ok(output);
        }
    }
    Err(errors.report())
}

fn checked(tokens: TokenStream, errors: &mut Errors) -> Option<model::Model> {
    let input = parse::parse(tokens, errors)?;
    check::check(input, errors)
}

fn unreadable(error: &proc_macro2::LexError) -> String {
    let start = error.span().start();
    let message = Mistake::Syntax("this cannot be read as Rust's tokens".into());
    format!("{}:{}: {message}\n", start.line, start.column + 1)
}

fn quote_error(message: &str) -> TokenStream {
    quote!(::core::compile_error! { #message })
}

/// Tokens as formatted Rust; tokens that are no file are returned as they print.
fn format(tokens: TokenStream) -> String {
    match syn::parse2(tokens.clone()) {
        Ok(file) => layout::source(file),
        Err(_) => tokens.to_string(),
    }
}

/// The expansion of a call as a string literal; mistakes as in [`expand_tokens`].
pub fn source_tokens(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    if let Some(model) = checked(tokens, &mut errors)
        && errors.is_empty()
    {
        let output = emit::emit(&model, &mut errors);
        if errors.is_empty() {
            let source = format(output.tokens);
            return quote!(#source);
        }
    }
    let messages = errors.to_tokens();
    quote!({ #messages "" })
}
