//! `define_algebra!`: a metric in, structs with unrolled products out.
//!
//! The grammar and everything behind it is in the library `ga_codegen`.

use proc_macro::TokenStream;

/// Declares a geometric algebra.
///
/// See the README of the project for the whole syntax. The expansion refers to `::ga_core`
/// unless the call opens with `crate = path;`.
#[proc_macro]
pub fn define_algebra(input: TokenStream) -> TokenStream {
    ga_codegen::expand_tokens(input.into()).into()
}

/// The expansion of `define_algebra!` with the same body, as a formatted `&'static str`.
#[proc_macro]
pub fn algebra_source(input: TokenStream) -> TokenStream {
    ga_codegen::source_tokens(input.into()).into()
}
