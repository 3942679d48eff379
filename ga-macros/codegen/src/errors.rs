//! Mistakes are collected, each with the tokens it is about, and shown all at once.

mod message;
mod mistake;
mod spelling;
mod wording;

pub use mistake::Mistake;
pub use spelling::closest;

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};

/// One mistake, and the first and the last token it is about.
struct Found {
    first: Span,
    last: Span,
    mistake: Mistake,
}

/// Collects all mistakes of one call, each with the tokens it is about.
#[derive(Default)]
pub struct Errors {
    found: Vec<Found>,
}

impl Errors {
    /// Records a mistake at one token.
    pub fn push(&mut self, span: Span, mistake: Mistake) {
        self.push_range((span, span), mistake);
    }

    /// Records a mistake at a run of tokens, given by its first and its last.
    pub fn push_range(&mut self, (first, last): (Span, Span), mistake: Mistake) {
        self.found.push(Found {
            first,
            last,
            mistake,
        });
    }

    /// Records the errors of a `syn` parser.
    pub fn push_syntax(&mut self, error: syn::Error) {
        for one in error {
            self.push(one.span(), Mistake::Syntax(one.to_string()));
        }
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Whether there is a mistake of some kind.
    pub fn any(&self, kind: impl Fn(&Mistake) -> bool) -> bool {
        self.found.iter().any(|found| kind(&found.mistake))
    }

    /// How many mistakes were found so far.
    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// Forgets the mistakes found since `count` that only follow from another one.
    pub fn forget_since(&mut self, count: usize, follows: impl Fn(&Mistake) -> bool) {
        let mut position = 0;
        self.found.retain(|found| {
            position += 1;
            position <= count || !follows(&found.mistake)
        });
    }

    /// One line per mistake, `line:column: message`, from top to bottom.
    pub fn report(&self) -> String {
        self.ordered()
            .iter()
            .map(|found| {
                let start = found.first.start();
                let (line, column) = (start.line, start.column + 1);
                format!("{line}:{column}: {}\n", found.mistake)
            })
            .collect()
    }

    /// The mistakes in the order of their tokens.
    fn ordered(&self) -> Vec<&Found> {
        let mut found: Vec<&Found> = self.found.iter().collect();
        found.sort_by_key(|found| (found.first.start().line, found.first.start().column));
        found
    }

    /// The `compile_error!` items, each at its own tokens.
    ///
    /// The compiler underlines from the first token of an item to its last one.
    pub fn to_tokens(&self) -> TokenStream {
        self.ordered()
            .into_iter()
            .map(|found| {
                let message = found.mistake.to_string();
                let path = quote_spanned!(found.first=> ::core::compile_error!);
                let body = quote_spanned!(found.last=> { #message });
                quote!(#path #body)
            })
            .collect()
    }
}
