//! The declarations of types: a name, and the blades it holds.

use proc_macro2::{Ident, Span, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Lit, LitInt, Token};

use super::{is_braced, is_mark, number, parse_braces, parse_identifier, parse_name, section};
use crate::ast::{Coefficient, Content, TypeDeclaration};
use crate::errors::{Errors, Mistake, closest};

/// Attributes that a type passes on to its struct.
const PASSED_ON: [&str; 5] = ["doc", "deprecated", "allow", "expect", "must_use"];

/// Reads all declarations; after a mistake in one, goes on with the next.
pub fn parse(content: ParseStream<'_>, errors: &mut Errors) -> Vec<TypeDeclaration> {
    let mut list = Vec::new();
    while !content.is_empty() {
        match parse_type(content, errors) {
            Some(declaration) => list.push(declaration),
            None => skip_past_type(content),
        }
    }
    list
}

/// After a mistake, goes on behind the next `{ … }` or `;`.
fn skip_past_type(content: ParseStream<'_>) {
    while let Ok(token) = content.parse::<TokenTree>() {
        if is_braced(&token) || is_mark(&token, ';') {
            return;
        }
    }
}

fn parse_type(content: ParseStream<'_>, errors: &mut Errors) -> Option<TypeDeclaration> {
    let (attributes, unit) = parse_attributes(content, errors);
    let name = parse_identifier(content, errors)?;
    let blades = if content.parse::<Token![=]>().is_ok() {
        let parsed = parse_set(content, errors);
        if content.parse::<Token![;]>().is_err() {
            if !matches!(parsed, Content::Unknown) {
                let mistake = Mistake::MissingSemicolon(name.to_string());
                errors.push(name.span(), mistake);
            }
            // `= grade 2,`: the wrong mark in the right place.
            let _ = content.parse::<Token![,]>();
        }
        parsed
    } else if let Some(list) = parse_braces(content) {
        let blades = section::separated(&list, errors, parse_coefficient);
        let _ = content.parse::<Token![,]>();
        Content::Blades(blades)
    } else {
        let mistake = Mistake::TypeWithoutBlades(name.to_string());
        errors.push(name.span(), mistake);
        if !content.peek(Ident::peek_any) {
            skip_past_type(content);
        }
        Content::Unknown
    };
    Some(TypeDeclaration {
        attributes,
        unit,
        name,
        content: blades,
    })
}

/// The attributes to pass on, and whether `#[unit]` was among them.
fn parse_attributes(content: ParseStream<'_>, errors: &mut Errors) -> (Vec<Attribute>, bool) {
    let mut unit = false;
    let mut attributes = Vec::new();
    let written = content
        .call(Attribute::parse_outer)
        .unwrap_or_else(|error| {
            errors.push_syntax(error);
            Vec::new()
        });
    for attribute in written {
        let path = attribute.path();
        if path.is_ident("unit") && attribute.meta.require_path_only().is_ok() {
            unit = true;
        } else if PASSED_ON.iter().any(|allowed| path.is_ident(allowed)) {
            attributes.push(attribute);
        } else {
            let name = attribute.meta.to_token_stream().to_string();
            let span = path
                .segments
                .first()
                .map_or_else(Span::call_site, |segment| segment.ident.span());
            errors.push(span, Mistake::UnsupportedAttribute(name));
        }
    }
    (attributes, unit)
}

/// `grade 2`, `even`, `odd` or `all`.
fn parse_set(content: ParseStream<'_>, errors: &mut Errors) -> Content {
    let Some(kind) = parse_name(content, errors) else {
        return Content::Unknown;
    };
    match kind.to_string().as_str() {
        "grade" => match content.parse::<LitInt>() {
            Ok(number) => Content::Grade(number),
            Err(_) => {
                errors.push(kind.span(), Mistake::GradeWithoutNumber);
                Content::Unknown
            }
        },
        "even" => Content::Even,
        "odd" => Content::Odd,
        "all" => Content::All,
        other => {
            let mistake = Mistake::UnknownContent {
                name: other.to_owned(),
                suggestion: closest(other, ["grade", "even", "odd", "all"]),
            };
            errors.push(kind.span(), mistake);
            Content::Unknown
        }
    }
}

fn parse_coefficient(entry: ParseStream<'_>, errors: &mut Errors) -> Option<Coefficient> {
    let first = entry.span();
    let mut last = first;
    let mut factors = Vec::new();
    if entry.peek(Token![-]) {
        errors.push(first, Mistake::SignedBlade);
        return None;
    }
    if let Ok(literal) = entry.parse::<Lit>() {
        let text = literal.to_token_stream().to_string();
        if text != "1" {
            errors.push(first, Mistake::NumberAsBlade(text));
            return None;
        }
    } else {
        loop {
            last = entry.span();
            factors.push(parse_name(entry, errors)?);
            if entry.parse::<Token![^]>().is_err() {
                break;
            }
        }
    }
    let fixed = entry
        .parse::<Token![=]>()
        .is_ok()
        .then(|| number::parse(entry, errors));
    Some(Coefficient {
        factors,
        spans: (first, last),
        fixed,
    })
}
