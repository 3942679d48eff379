//! The declarations of types: a name, and the blades it holds.

use proc_macro2::{Ident, Span, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Lit, LitInt, Token, Visibility, token};

use super::{
    is_braced, is_mark, number, parse_braces, parse_identifier, parse_name, section, skip_all,
};
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
    let (attributes, promises) = parse_attributes(content, errors);
    skip_leading_words(content, errors);
    if let Some(name) = section_ahead(content) {
        errors.push(content.span(), Mistake::SectionAmongTypes(name));
        return None;
    }
    let name = parse_identifier(content, errors)?;
    if content.peek(Token![<]) {
        errors.push(content.span(), Mistake::TypeParameters);
        skip_before_blades(content);
    }
    let blades = if content.peek(Token![=]) {
        parse_definition(&name, content, errors)
    } else if let Some(list) = parse_braces(content) {
        parse_list(&list, content, errors)
    } else if content.peek(token::Paren) || content.peek(token::Bracket) || content.peek(Token![:])
    {
        let mistake = Mistake::BladesWithoutBraces(name.to_string());
        errors.push(content.span(), mistake);
        let _ = content.parse::<TokenTree>();
        let _ = parse_braces(content).map(|list| skip_all(&list));
        let _ = content.parse::<Token![,]>();
        let _ = content.parse::<Token![;]>();
        Content::Unknown
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
        unit: promises.unit,
        null: promises.null,
        name,
        content: blades,
    })
}

/// Passes over `pub` and `struct`, which are not needed.
fn skip_leading_words(content: ParseStream<'_>, errors: &mut Errors) {
    loop {
        let span = content.span();
        let word = if content.peek(Token![pub]) {
            let _ = content.parse::<Visibility>();
            "pub"
        } else if content.parse::<Token![struct]>().is_ok() {
            "struct"
        } else {
            return;
        };
        errors.push(span, Mistake::WordBeforeType(word.to_owned()));
    }
}

/// The name of a section that stands among the types.
fn section_ahead(content: ParseStream<'_>) -> Option<String> {
    let name = content.fork().call(Ident::parse_any).ok()?.to_string();
    let known = ["basis", "metric", "types", "products"].contains(&name.as_str());
    (known && content.peek2(token::Brace)).then_some(name)
}

/// Goes on before the braces, the `=` or the `;` of a type.
fn skip_before_blades(content: ParseStream<'_>) {
    while !content.is_empty()
        && !content.peek(token::Brace)
        && !content.peek(Token![=])
        && !content.peek(Token![;])
        && content.parse::<TokenTree>().is_ok()
    {}
}

/// The blades in the braces that were opened, and what may follow them.
fn parse_list(list: ParseStream<'_>, content: ParseStream<'_>, errors: &mut Errors) -> Content {
    let before = errors.count();
    let blades = section::separated(list, errors, parse_coefficient);
    let unread = errors.count() > before;
    let _ = content.parse::<Token![,]>();
    let span = content.span();
    if content.parse::<Token![;]>().is_ok() {
        errors.push(span, Mistake::SemicolonAfterBraces);
    }
    // A list of which nothing could be read is not the same as an empty one.
    if blades.is_empty() && unread {
        Content::Unknown
    } else {
        Content::Blades(blades)
    }
}

/// What follows `Name`, from the `=` on.
fn parse_definition(name: &Ident, content: ParseStream<'_>, errors: &mut Errors) -> Content {
    let equals = content.span();
    let _ = content.parse::<Token![=]>();
    if let Some(list) = parse_braces(content) {
        let mistake = Mistake::EqualsBeforeBraces(name.to_string());
        errors.push(equals, mistake);
        let _ = content.parse::<Token![;]>();
        return parse_list(&list, content, errors);
    }
    let (parsed, last) = parse_set(content, errors);
    if content.parse::<Token![;]>().is_ok() {
        return parsed;
    }
    let known = !matches!(parsed, Content::Unknown);
    // `= grade 2,`: the wrong mark in the right place.
    let (mark, comma) = (content.span(), content.parse::<Token![,]>().is_ok());
    if content.is_empty() || content.peek(Ident::peek_any) || content.peek(Token![#]) {
        if known {
            let wrong = if comma { mark } else { last };
            errors.push(wrong, Mistake::MissingSemicolon);
        }
    } else {
        if known {
            errors.push(mark, Mistake::SetGoesOn(name.to_string()));
        }
        skip_past_type(content);
    }
    parsed
}

/// What the attributes of a type promise of its values.
#[derive(Default)]
struct Promises {
    /// `#[unit]`.
    unit: bool,
    /// `#[null]`.
    null: bool,
}

/// The attributes to pass on, and what the others promise.
fn parse_attributes(content: ParseStream<'_>, errors: &mut Errors) -> (Vec<Attribute>, Promises) {
    let mut promises = Promises::default();
    let mut attributes = Vec::new();
    let written = super::parse_attributes(content, errors);
    for attribute in written {
        let path = attribute.path();
        let alone = attribute.meta.require_path_only().is_ok();
        if path.is_ident("unit") && alone {
            promises.unit = true;
        } else if path.is_ident("null") && alone {
            promises.null = true;
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
    (attributes, promises)
}

/// Words for a set that has another name here.
const SETS: [(&str, &str); 6] = [
    ("scalar", "grade 0"),
    ("vector", "grade 1"),
    ("bivector", "grade 2"),
    ("trivector", "grade 3"),
    ("full", "all"),
    ("multivector", "all"),
];

/// `grade 2`, `even`, `odd` or `all`, and its last token.
fn parse_set(content: ParseStream<'_>, errors: &mut Errors) -> (Content, Span) {
    let span = content.span();
    let Ok(kind) = content.call(Ident::parse_any) else {
        let token = content.fork().parse::<TokenTree>();
        let name = token.map_or_else(|_| String::new(), |token| token.to_string());
        let suggestion = None;
        errors.push(span, Mistake::UnknownContent { name, suggestion });
        return (Content::Unknown, span);
    };
    let set = match kind.to_string().as_str() {
        "grade" => {
            let wrong = content.span();
            match content.parse::<LitInt>() {
                Ok(number) => return (Content::Grade(number), wrong),
                Err(_) => {
                    let nothing = content.is_empty() || content.peek(Token![;]);
                    let wrong = if nothing { kind.span() } else { wrong };
                    errors.push(wrong, Mistake::GradeWithoutNumber);
                    if !nothing {
                        let _ = content.parse::<TokenTree>();
                    }
                    Content::Unknown
                }
            }
        }
        "even" => Content::Even,
        "odd" => Content::Odd,
        "all" => Content::All,
        other => {
            let grade = other
                .strip_prefix("grade")
                .map(|digits| digits.trim_matches('_'));
            let grade = grade.filter(|digits| digits.parse::<u8>().is_ok());
            let synonym = SETS.iter().find(|(theirs, _)| *theirs == other);
            let suggestion = match (grade, synonym) {
                (Some(digits), _) => Some(format!("grade {digits}")),
                (None, Some((_, ours))) => Some((*ours).to_owned()),
                (None, None) => closest(other, ["grade", "even", "odd", "all"]),
            };
            let name = other.to_owned();
            errors.push(kind.span(), Mistake::UnknownContent { name, suggestion });
            Content::Unknown
        }
    };
    (set, kind.span())
}

fn parse_coefficient(entry: ParseStream<'_>, errors: &mut Errors) -> Option<Coefficient> {
    while entry.peek(Token![#]) {
        let span = entry.span();
        let read = entry.call(Attribute::parse_outer);
        errors.push(span, Mistake::AttributeOnBlade);
        if !read.is_ok_and(|attributes| !attributes.is_empty()) {
            return None;
        }
    }
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
            if let Ok(literal) = entry.parse::<Lit>() {
                let text = literal.to_token_stream().to_string();
                errors.push(last, Mistake::NumberAsBlade(text));
                return None;
            }
            factors.push(parse_name(entry, errors)?);
            if !parse_wedge(entry, errors) {
                break;
            }
        }
    }
    let before = errors.count();
    let number = entry
        .parse::<Token![=]>()
        .is_ok()
        .then(|| number::parse(entry, errors));
    // A value that could not be read is none that other rules could judge.
    let fixed = number.filter(|_| errors.count() == before);
    Some(Coefficient {
        factors,
        spans: (first, last),
        fixed,
    })
}

/// The mark between the vectors of a blade; one that others use is reported and taken for it.
fn parse_wedge(entry: ParseStream<'_>, errors: &mut Errors) -> bool {
    if entry.parse::<Token![^]>().is_ok() {
        return true;
    }
    let span = entry.span();
    let mark = if entry.parse::<Token![*]>().is_ok() {
        '*'
    } else if entry.parse::<Token![.]>().is_ok() {
        '.'
    } else if entry.parse::<Token![&]>().is_ok() {
        '&'
    } else {
        return false;
    };
    errors.push(span, Mistake::BladeJoinedBy(mark));
    true
}
