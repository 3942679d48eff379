//! The sections of an algebra: lists in braces, read entry by entry.

use proc_macro2::{Ident, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Lit, Token, token};

use super::{number, parse_braces, parse_name, skip_all, skip_past_comma, types};
use crate::ast::{Algebra, MetricEntry};
use crate::errors::{Errors, Mistake, closest};

/// Reads one section; what is no section is reported and skipped.
pub fn parse(body: ParseStream<'_>, algebra: &mut Algebra, errors: &mut Errors) {
    if body.peek(Token![,]) && body.peek2(Ident::peek_any) {
        errors.push(body.span(), Mistake::MarkBetweenSections(','));
        let _ = body.parse::<Token![,]>();
    }
    let Ok(name) = body.call(Ident::parse_any) else {
        errors.push(body.span(), Mistake::NotASection);
        skip_to_section(body);
        return;
    };
    let Some(content) = parse_braces(body) else {
        let mistake = Mistake::SectionWithoutBraces(name.to_string());
        let wrong = if body.is_empty() {
            name.span()
        } else {
            body.span()
        };
        errors.push(wrong, mistake);
        skip_to_section(body);
        return;
    };
    // A semicolon behind a section is a habit that harms nobody.
    let _ = body.parse::<Token![;]>();
    let duplicate = match name.to_string().as_str() {
        "basis" => {
            let list = separated(&content, errors, parse_name);
            replace(&mut algebra.basis, list)
        }
        "metric" => {
            let list = separated(&content, errors, parse_metric_entry);
            replace(&mut algebra.metric, list)
        }
        "types" => {
            let list = types::parse(&content, errors);
            replace(&mut algebra.types, list)
        }
        "products" => {
            let list = separated(&content, errors, parse_name);
            replace(&mut algebra.products, list)
        }
        other => {
            skip_all(&content);
            let suggestion = closest(other, ["basis", "metric", "types", "products"]);
            let mistake = Mistake::UnknownSection {
                name: other.into(),
                suggestion,
            };
            errors.push(name.span(), mistake);
            false
        }
    };
    if duplicate {
        errors.push(name.span(), Mistake::DuplicateSection(name.to_string()));
    }
}

/// Adds to a section, and says whether it was there already; nothing that was written is lost.
fn replace<T>(section: &mut Option<Vec<T>>, list: Vec<T>) -> bool {
    let duplicate = section.is_some();
    section.get_or_insert_default().extend(list);
    duplicate
}

/// After a mistake, goes on behind the next `{ … }` or before the next word that has one.
fn skip_to_section(body: ParseStream<'_>) {
    while let Ok(token) = body.parse::<TokenTree>() {
        let section_ahead = body.peek(Ident::peek_any) && body.peek2(token::Brace);
        if super::is_braced(&token) || section_ahead {
            return;
        }
    }
}

/// Entries between commas; after a mistake reading goes on behind the next comma.
pub fn separated<T>(
    content: ParseStream<'_>,
    errors: &mut Errors,
    mut entry: impl FnMut(ParseStream<'_>, &mut Errors) -> Option<T>,
) -> Vec<T> {
    let mut list = Vec::new();
    while !content.is_empty() {
        match entry(content, errors) {
            Some(value) => {
                list.push(value);
                if !content.is_empty() && content.parse::<Token![,]>().is_err() {
                    mend_separator(content, errors);
                }
            }
            None => skip_past_comma(content),
        }
    }
    list
}

/// Goes on after an entry that no comma follows.
fn mend_separator(content: ParseStream<'_>, errors: &mut Errors) {
    let span = content.span();
    if content.parse::<Token![;]>().is_ok() {
        errors.push(span, Mistake::SemicolonForComma);
    } else if content.peek(Ident::peek_any) || content.peek(Lit) {
        // `e1 e2`: the comma alone is missing.
        errors.push(span, Mistake::MissingComma);
    } else {
        // There is no telling what is meant.
        let token = content.parse::<TokenTree>();
        let text = token.map_or_else(|_| String::new(), |token| token.to_string());
        errors.push(span, Mistake::Unexpected(text));
        skip_past_comma(content);
    }
}

fn parse_metric_entry(entry: ParseStream<'_>, errors: &mut Errors) -> Option<MetricEntry> {
    let Ok(left) = entry.call(Ident::parse_any) else {
        errors.push(entry.span(), Mistake::NotAMetricEntry);
        return None;
    };
    if left.to_string().contains('·') {
        errors.push(left.span(), Mistake::MiddleDot(left.to_string()));
        return None;
    }
    let malformed = |errors: &mut Errors| {
        errors.push(entry.span(), Mistake::NotAMetricEntry);
        None
    };
    let right = if entry.parse::<Token![^]>().is_ok() {
        match entry.parse::<Lit>() {
            Ok(Lit::Int(two)) if two.base10_digits() == "2" => {}
            Ok(power) => {
                errors.push(power.span(), Mistake::NotASquare(left.to_string()));
            }
            Err(_) => return malformed(errors),
        }
        None
    } else if entry.parse::<Token![.]>().is_ok() {
        Some(parse_name(entry, errors)?)
    } else {
        return malformed(errors);
    };
    if entry.parse::<Token![=]>().is_err() {
        return malformed(errors);
    }
    let value = number::parse(entry, errors);
    Some(MetricEntry { left, right, value })
}
