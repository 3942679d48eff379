//! Tokens into the syntax tree; a mistake in one entry does not hide those in the next.
//!
//! ```ebnf
//! input       = { "crate" "=" path ";" } ( signature | algebra ) ;   (* the last path counts *)
//! algebra     = { attribute } [ visibility ] "mod" name ":" signature "{" { section } "}" ;
//! signature   = "R" p [ "_" q [ "_" r ] ] ;                  (* one word: R3, R4_1, R3_0_1 *)
//! section     = "basis"    "{" [ name { "," name } [ "," ] ] "}"
//!             | "metric"   "{" [ entry { "," entry } [ "," ] ] "}"
//!             | "types"    "{" { type } "}"
//!             | "products" "{" [ name { "," name } [ "," ] ] "}" ;
//! entry       = name "^" "2" "=" number | name "." name "=" number ;
//! type        = { attribute | "#[unit]" | "#[null]" }
//!               Name ( "{" [ coefficient { "," coefficient } [ "," ] ] "}" [ "," ]
//!                    | "=" ( "grade" integer | "even" | "odd" | "all" ) ";" ) ;
//! coefficient = blade [ "=" number ] ;
//! blade       = "1" | name { "^" name } ;                    (* e12, e1^ni, e31, e12ni *)
//! number      = [ "-" ] ( integer [ "/" integer ] | decimal ) ;
//! ```
//!
//! What a section leaves out is filled in: without `basis` the vectors are `e1`, `e2`, …;
//! without `metric` they are orthonormal, positive squares first, then negative, then zero;
//! metric entries not written are 0; without `types` there is one type per grade; without
//! `products` there are all, and the geometric product is there in any case.
//!
//! `#[unit]` promises `V Ṽ = 1` of every value of a type, `#[null]` promises `x² = 0`; applications
//! rely on it, products never claim it of their results.

mod number;
mod section;
mod types;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream, Parser};
use syn::{Attribute, Token, Visibility, braced, token};

use crate::ast::{Algebra, Input, Signature};
use crate::errors::{Errors, Mistake};

/// How deep brackets may be nested: the parser and the compiler recurse into them.
const DEPTH_LIMIT: usize = 32;

/// Parses a call; what could be read is returned even where errors were found.
pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Option<Input> {
    if let Some(span) = too_deep(&tokens) {
        errors.push(span, Mistake::TooDeep { limit: DEPTH_LIMIT });
        return None;
    }
    let parser = |input: ParseStream<'_>| Ok(parse_input(input, errors));
    match parser.parse2(tokens) {
        Ok(input) => input,
        Err(error) => {
            errors.push_syntax(error);
            None
        }
    }
}

/// The first bracket beyond the limit, found without recursion.
fn too_deep(tokens: &TokenStream) -> Option<Span> {
    let mut levels = vec![tokens.clone().into_iter()];
    while let Some(level) = levels.last_mut() {
        match level.next() {
            Some(TokenTree::Group(group)) => {
                if levels.len() > DEPTH_LIMIT {
                    return Some(group.span_open());
                }
                levels.push(group.stream().into_iter());
            }
            Some(_) => {}
            None => {
                levels.pop();
            }
        }
    }
    None
}

fn parse_input(input: ParseStream<'_>, errors: &mut Errors) -> Option<Input> {
    match parse_call(input, errors) {
        Ok(parsed) => {
            let parsed = parsed?;
            if !input.is_empty() {
                errors.push(input.span(), Mistake::Trailing);
                skip_all(input);
            }
            Some(parsed)
        }
        Err(error) => {
            errors.push_syntax(error);
            skip_all(input);
            None
        }
    }
}

fn parse_call(input: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Option<Input>> {
    let mut core = None;
    // A wrapper such as `ga::define_algebra!` gives a path that the user may override.
    while input.peek(Token![crate]) && input.peek2(Token![=]) {
        input.parse::<Token![crate]>()?;
        input.parse::<Token![=]>()?;
        let span = input.span();
        let path = syn::Path::parse_mod_style(input);
        let Ok(path) = path else {
            errors.push(span, Mistake::NotAPath);
            skip_all(input);
            return Ok(None);
        };
        core = Some(path);
        let end = if input.is_empty() { span } else { input.span() };
        if input.parse::<Token![;]>().is_err() {
            errors.push(end, Mistake::PathWithoutSemicolon);
            if input.parse::<Token![,]>().is_err() {
                skip_past_mark(input, ';');
            }
            if input.is_empty() {
                return Ok(None);
            }
        }
    }
    Ok(parse_algebra(input, errors)?.map(|algebra| Input { core, algebra }))
}

fn parse_algebra(input: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Option<Algebra>> {
    let attributes = parse_attributes(input, errors);
    let visibility: Visibility = input.parse()?;
    if !input.peek(Token![mod]) {
        let mut signature = parse_signature(input, errors);
        let name = Ident::new(&module_name(&signature.text), signature.spans.0);
        let visibility = match visibility {
            Visibility::Inherited => syn::parse_quote!(pub),
            given => given,
        };
        if input.peek(token::Brace) && !signature.text.is_empty() {
            if signature.text.contains([' ', ':']) {
                // `struct name: R3 { … }`: whatever it is, the signature is not what is wrong.
                errors.push(signature.spans.0, Mistake::NotAModule);
                signature.text.clear();
            } else {
                let mistake = Mistake::SectionsOfPreset(signature.text.clone());
                errors.push(input.span(), mistake);
            }
            skip_all(input);
        }
        return Ok(Some(Algebra::without_sections(
            attributes, visibility, name, signature,
        )));
    }
    input.parse::<Token![mod]>()?;
    let Some(name) = parse_identifier(input, errors) else {
        skip_all(input);
        return Ok(None);
    };
    let signature = if input.parse::<Token![:]>().is_ok() {
        parse_signature(input, errors)
    } else if !input.is_empty() && !input.peek(token::Brace) && !input.peek(Token![;]) {
        let mistake = Mistake::ModuleWithoutColon(name.to_string());
        errors.push(input.span(), mistake);
        if !input.peek(Ident::peek_any) && !skip_past_mark(input, ':') {
            let _ = input.parse::<TokenTree>();
        }
        parse_signature(input, errors)
    } else {
        let mistake = Mistake::ModuleWithoutSignature(name.to_string());
        errors.push(name.span(), mistake);
        Signature {
            text: String::new(),
            spans: (name.span(), name.span()),
        }
    };
    let mut algebra = Algebra::without_sections(attributes, visibility, name, signature);
    let Some(body) = parse_braces(input) else {
        let name = algebra.name.to_string();
        if is_wrong_body(input) {
            errors.push(input.span(), Mistake::BodyWithoutBraces(name));
        } else if !algebra.signature.text.is_empty() {
            // Where the signature is missing as well, its example shows the body.
            errors.push(algebra.name.span(), Mistake::ModuleWithoutBody(name));
        }
        skip_all(input);
        return Ok(Some(algebra));
    };
    while !body.is_empty() {
        section::parse(&body, &mut algebra, errors);
    }
    Ok(Some(algebra))
}

/// The module of a preset: its signature in lower case, if that can be an identifier.
fn module_name(signature: &str) -> String {
    let lower = signature.to_lowercase();
    if is_plain_identifier(&lower) {
        lower
    } else {
        "algebra".to_owned()
    }
}

/// Whether a word can be a name in generated code: no keyword, not raw.
pub fn is_plain_identifier(word: &str) -> bool {
    !word.starts_with("r#") && syn::parse_str::<Ident>(word).is_ok_and(|name| name == word)
}

/// Reads everything up to the module's braces as the signature, so that `R4-1`, `R(4, 1)` or
/// `Cl 4 1` is one mistake.
fn parse_signature(input: ParseStream<'_>, errors: &mut Errors) -> Signature {
    let mut text = String::new();
    let mut spans = None;
    while !input.is_empty()
        && !input.peek(token::Brace)
        && !input.peek(Token![;])
        && (text.is_empty() || !is_wrong_body(input))
    {
        let Ok(token) = input.parse::<TokenTree>() else {
            break;
        };
        let (first, last) = match &token {
            TokenTree::Group(group) => (group.span_open(), group.span_close()),
            other => (other.span(), other.span()),
        };
        spans = Some((spans.map_or(first, |(start, _)| start), last));
        let word = token.to_string();
        if text.ends_with(char::is_alphanumeric) && word.starts_with(char::is_alphanumeric) {
            text.push(' ');
        }
        text.push_str(&word);
    }
    let Some(spans) = spans else {
        errors.push(input.span(), Mistake::MissingSignature);
        return Signature {
            text,
            spans: (input.span(), input.span()),
        };
    };
    Signature { text, spans }
}

/// Whether sections stand here in brackets or parentheses: empty ones, or with braces inside.
fn is_wrong_body(input: ParseStream<'_>) -> bool {
    match input.fork().parse::<TokenTree>() {
        Ok(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
            let content = group.stream();
            content.is_empty() || content.into_iter().any(|token| is_braced(&token))
        }
        _ => false,
    }
}

/// Attributes and doc comments; those of the form `#![…]` are reported and passed over.
fn parse_attributes(input: ParseStream<'_>, errors: &mut Errors) -> Vec<Attribute> {
    let mut attributes = Vec::new();
    while input.peek(Token![#]) {
        let span = input.span();
        if input.peek2(Token![!]) {
            errors.push(span, Mistake::InnerAttribute);
            for _ in 0..3 {
                let _ = input.parse::<TokenTree>();
            }
            continue;
        }
        match input.call(Attribute::parse_outer) {
            Ok(list) if !list.is_empty() => attributes.extend(list),
            Ok(_) => break,
            Err(error) => {
                errors.push_syntax(error);
                // The parser may have stopped anywhere in it; the next token makes an end.
                let _ = input.parse::<TokenTree>();
            }
        }
    }
    attributes
}

/// Goes on after the next comma.
fn skip_past_comma(content: ParseStream<'_>) {
    while let Ok(token) = content.parse::<TokenTree>() {
        if is_mark(&token, ',') {
            return;
        }
    }
}

/// Goes on after a mark, if it stands anywhere before the next braces, and says whether it did.
fn skip_past_mark(input: ParseStream<'_>, mark: char) -> bool {
    let ahead = input.fork();
    let found = |input: ParseStream<'_>| {
        while !input.peek(token::Brace) {
            match input.parse::<TokenTree>() {
                Ok(token) if is_mark(&token, mark) => return true,
                Ok(_) => {}
                Err(_) => return false,
            }
        }
        false
    };
    found(&ahead) && found(input)
}

fn skip_all(content: ParseStream<'_>) {
    while content.parse::<TokenTree>().is_ok() {}
}

fn is_mark(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

fn is_braced(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// The content of the braces that stand here, if any do.
fn parse_braces<'a>(input: ParseStream<'a>) -> Option<ParseBuffer<'a>> {
    let read = || -> syn::Result<ParseBuffer<'a>> {
        let content;
        braced!(content in input);
        Ok(content)
    };
    read().ok()
}

/// A name of an item: no keyword, not raw.
fn parse_identifier(input: ParseStream<'_>, errors: &mut Errors) -> Option<Ident> {
    let span = input.span();
    match input.parse::<Ident>() {
        Ok(name) if !name.to_string().starts_with("r#") => Some(name),
        _ => {
            errors.push(span, Mistake::NotAName);
            None
        }
    }
}

/// A name, keywords included, which later rules refuse with a better message.
fn parse_name(entry: ParseStream<'_>, errors: &mut Errors) -> Option<Ident> {
    match entry.call(Ident::parse_any) {
        Ok(name) => Some(name),
        Err(_) => {
            errors.push(entry.span(), Mistake::NotAName);
            None
        }
    }
}
