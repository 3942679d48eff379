//! Tokens into the syntax tree; a mistake in one entry does not hide those in the next.
//!
//! ```ebnf
//! input       = [ "crate" "=" path ";" ] ( signature | algebra ) ;
//! algebra     = { attribute } [ visibility ] "mod" name ":" signature "{" { section } "}" ;
//! signature   = "R" p [ "_" q [ "_" r ] ] ;                  (* one word: R3, R4_1, R3_0_1 *)
//! section     = "basis"    "{" [ name { "," name } [ "," ] ] "}"
//!             | "metric"   "{" [ entry { "," entry } [ "," ] ] "}"
//!             | "types"    "{" { type } "}"
//!             | "products" "{" [ name { "," name } [ "," ] ] "}" ;
//! entry       = name "^" "2" "=" number | name "." name "=" number ;
//! type        = { attribute } Name ( "{" [ coefficient { "," coefficient } [ "," ] ] "}" [ "," ]
//!                                  | "=" ( "grade" integer | "even" | "odd" | "all" ) ";" ) ;
//! coefficient = blade [ "=" number ] ;
//! blade       = "1" | name { "^" name } ;                    (* e12, e1^ni, e31, e12ni *)
//! number      = [ "-" ] ( integer [ "/" integer ] | decimal ) ;
//! ```
//!
//! What a section leaves out is filled in: without `basis` the vectors are `e1`, `e2`, …;
//! without `metric` they are orthonormal, positive squares first, then negative, then zero;
//! metric entries not written are 0; without `types` there is one type per grade.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Lit, Token, Visibility, braced};

use crate::ast::{
    Algebra, Coefficient, Content, Input, MetricEntry, Number, Signature, TypeDeclaration,
};
use crate::errors::{Errors, Mistake, closest};

/// Parses a call; what could be read is returned even where errors were found.
pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Option<Input> {
    let parser = |input: ParseStream<'_>| Ok(parse_input(input, errors));
    match parser.parse2(tokens) {
        Ok(input) => input,
        Err(error) => {
            errors.push_syntax(error);
            None
        }
    }
}

fn parse_input(input: ParseStream<'_>, errors: &mut Errors) -> Option<Input> {
    let result = (|| {
        let mut core = None;
        if input.peek(Token![crate]) && input.peek2(Token![=]) {
            input.parse::<Token![crate]>()?;
            input.parse::<Token![=]>()?;
            core = Some(syn::Path::parse_mod_style(input)?);
            input.parse::<Token![;]>()?;
        }
        let algebra = parse_algebra(input, errors)?;
        Ok(Input { core, algebra })
    })();
    match result {
        Ok(parsed) => {
            if !input.is_empty() {
                let trailing = input.span();
                errors.push(
                    trailing,
                    Mistake::Syntax("unexpected tokens after the algebra; remove them".into()),
                );
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

fn parse_algebra(input: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Algebra> {
    if input.is_empty() {
        return Err(input.error("expected a signature such as `R4_1`, or `mod name: R4_1 { … }`"));
    }
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility: Visibility = input.parse()?;
    if !input.peek(Token![mod]) {
        let signature = parse_signature(input, errors)?;
        let name = Ident::new(&module_name(&signature.text), signature.span);
        let visibility = match visibility {
            Visibility::Inherited => syn::parse_quote!(pub),
            given => given,
        };
        return Ok(Algebra {
            attributes,
            visibility,
            name,
            signature,
            basis: None,
            metric: None,
            types: None,
            products: None,
        });
    }
    input.parse::<Token![mod]>()?;
    let name: Ident = input.parse()?;
    input.parse::<Token![:]>()?;
    let signature = parse_signature(input, errors)?;
    let mut algebra = Algebra {
        attributes,
        visibility,
        name,
        signature,
        basis: None,
        metric: None,
        types: None,
        products: None,
    };
    let body;
    braced!(body in input);
    while !body.is_empty() {
        if let Err(error) = parse_section(&body, &mut algebra, errors) {
            errors.push_syntax(error);
            skip_all(&body);
        }
    }
    Ok(algebra)
}

/// The module of a preset: its signature in lower case, if that can be an identifier.
fn module_name(signature: &str) -> String {
    let lower = signature.to_lowercase();
    if syn::parse_str::<Ident>(&lower).is_ok() {
        lower
    } else {
        "algebra".to_owned()
    }
}

fn parse_signature(input: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Signature> {
    let word = Ident::parse_any(input)
        .map_err(|e| syn::Error::new(e.span(), "expected a signature such as `R4_1`"))?;
    let mut text = word.to_string();
    let span = word.span();
    let mut dashed = false;
    while input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        let number: Lit = input.parse()?;
        text.push('_');
        text.push_str(&quote::quote!(#number).to_string());
        dashed = true;
    }
    if dashed {
        errors.push(span, Mistake::DashedSignature(text.clone()));
    }
    Ok(Signature { text, span })
}

fn parse_section(
    body: ParseStream<'_>,
    algebra: &mut Algebra,
    errors: &mut Errors,
) -> syn::Result<()> {
    let name = body.call(Ident::parse_any)?;
    let content;
    braced!(content in body);
    let _ = body.parse::<Option<Token![;]>>()?;
    let duplicate = match name.to_string().as_str() {
        "basis" => {
            let list = separated(&content, errors, |entry, _| Ident::parse_any(entry));
            algebra.basis.replace(list).is_some()
        }
        "metric" => {
            let list = separated(&content, errors, parse_metric_entry);
            algebra.metric.replace(list).is_some()
        }
        "types" => {
            let list = parse_types(&content, errors);
            algebra.types.replace(list).is_some()
        }
        "products" => {
            let list = separated(&content, errors, |entry, _| Ident::parse_any(entry));
            algebra.products.replace(list).is_some()
        }
        other => {
            skip_all(&content);
            let suggestion = closest(other, ["basis", "metric", "types", "products"]);
            errors.push(
                name.span(),
                Mistake::UnknownSection {
                    name: other.into(),
                    suggestion,
                },
            );
            false
        }
    };
    if duplicate {
        errors.push(name.span(), Mistake::DuplicateSection(name.to_string()));
    }
    Ok(())
}

/// Entries between commas; after a mistake reading goes on behind the next comma.
fn separated<T>(
    content: ParseStream<'_>,
    errors: &mut Errors,
    mut entry: impl FnMut(ParseStream<'_>, &mut Errors) -> syn::Result<T>,
) -> Vec<T> {
    let mut list = Vec::new();
    while !content.is_empty() {
        match entry(content, errors) {
            Ok(value) => {
                list.push(value);
                if !content.is_empty() && content.parse::<Token![,]>().is_err() {
                    errors.push(
                        content.span(),
                        Mistake::Syntax("expected `,` between entries".into()),
                    );
                    skip_past_comma(content);
                }
            }
            Err(error) => {
                errors.push_syntax(error);
                skip_past_comma(content);
            }
        }
    }
    list
}

fn skip_past_comma(content: ParseStream<'_>) {
    while let Ok(token) = content.parse::<TokenTree>() {
        if matches!(&token, TokenTree::Punct(mark) if mark.as_char() == ',') {
            return;
        }
    }
}

fn skip_all(content: ParseStream<'_>) {
    while content.parse::<TokenTree>().is_ok() {}
}

fn parse_metric_entry(entry: ParseStream<'_>, errors: &mut Errors) -> syn::Result<MetricEntry> {
    let left = entry.call(Ident::parse_any)?;
    let right = if entry.peek(Token![^]) {
        entry.parse::<Token![^]>()?;
        let power: Lit = entry.parse()?;
        if !matches!(&power, Lit::Int(two) if two.base10_digits() == "2") {
            errors.push(power.span(), Mistake::NotASquare(left.to_string()));
        }
        left.clone()
    } else if entry.peek(Token![.]) {
        entry.parse::<Token![.]>()?;
        entry.call(Ident::parse_any)?
    } else {
        return Err(entry.error(format!(
            "expected `{left}^2 = value` or `{left}.other = value`"
        )));
    };
    entry.parse::<Token![=]>()?;
    let value = parse_number(entry, errors)?;
    Ok(MetricEntry { left, right, value })
}

fn parse_number(entry: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Number> {
    let negative = entry.parse::<Option<Token![-]>>()?.is_some();
    let span = entry.span();
    let mut text = String::new();
    let mut value = None;
    if entry.peek(Lit) {
        let literal: Lit = entry.parse()?;
        text = quote::quote!(#literal).to_string();
        value = decimal(&text);
        if entry.peek(Token![/]) {
            entry.parse::<Token![/]>()?;
            let below: Lit = entry.parse()?;
            let below_text = quote::quote!(#below).to_string();
            value = match (value, decimal(&below_text)) {
                (_, Some((0, _))) => {
                    errors.push(below.span(), Mistake::ZeroDenominator);
                    Some((1, 1))
                }
                (Some((a, b)), Some((c, d))) => a.checked_mul(d).zip(b.checked_mul(c)),
                _ => None,
            };
            text = format!("{text}/{below_text}");
        }
    } else if let Ok(token) = entry.parse::<TokenTree>() {
        text = token.to_string();
    }
    // A call such as `sqrt(2)` or a product: read to the comma, report the whole once.
    while !entry.is_empty() && !entry.peek(Token![,]) {
        text.push_str(&entry.parse::<TokenTree>()?.to_string());
        value = None;
    }
    const LIMIT: i128 = 1_000_000;
    let (numerator, denominator) = match value {
        None => {
            errors.push(span, Mistake::NotRational(text));
            (1, 1)
        }
        Some((a, b)) if a.abs() > LIMIT || b.abs() > LIMIT => {
            errors.push(span, Mistake::NumberTooLarge);
            (1, 1)
        }
        Some(fraction) => fraction,
    };
    let sign = if negative { -1 } else { 1 };
    Ok(Number {
        value: (sign * numerator, denominator),
        span,
    })
}

/// A literal such as `3`, `0.5` or `1_000` as an exact fraction.
fn decimal(text: &str) -> Option<(i128, i128)> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    let all_digits = |s: &str| s.chars().all(|c| c.is_ascii_digit());
    if whole.is_empty() || !all_digits(whole) || !all_digits(fraction) || fraction.len() > 18 {
        return None;
    }
    let numerator: i128 = format!("{whole}{fraction}").parse().ok()?;
    let mut denominator = 10_i128.pow(fraction.len() as u32);
    let mut numerator = numerator;
    for prime in [2, 5] {
        while denominator % prime == 0 && numerator % prime == 0 {
            denominator /= prime;
            numerator /= prime;
        }
    }
    Some((numerator, denominator))
}

fn parse_types(content: ParseStream<'_>, errors: &mut Errors) -> Vec<TypeDeclaration> {
    let mut list = Vec::new();
    while !content.is_empty() {
        match parse_type(content, errors) {
            Ok(declaration) => list.push(declaration),
            Err(error) => {
                errors.push_syntax(error);
                skip_past_type(content);
            }
        }
    }
    list
}

/// After a mistake, goes on behind the next `{ … }` or `;`.
fn skip_past_type(content: ParseStream<'_>) {
    while let Ok(token) = content.parse::<TokenTree>() {
        match token {
            TokenTree::Group(_) => return,
            TokenTree::Punct(mark) if mark.as_char() == ';' => return,
            _ => {}
        }
    }
}

fn parse_type(content: ParseStream<'_>, errors: &mut Errors) -> syn::Result<TypeDeclaration> {
    let mut unit = false;
    let mut attributes = Vec::new();
    for attribute in content.call(Attribute::parse_outer)? {
        let path = attribute.path();
        if path.is_ident("unit") {
            unit = true;
        } else if ["doc", "deprecated", "allow", "expect", "must_use"]
            .iter()
            .any(|allowed| path.is_ident(allowed))
        {
            attributes.push(attribute);
        } else {
            let name = path
                .get_ident()
                .map_or_else(|| "…".to_owned(), Ident::to_string);
            let span = path
                .segments
                .first()
                .map_or_else(Span::call_site, |s| s.ident.span());
            errors.push(span, Mistake::UnsupportedAttribute(name));
        }
    }
    let name: Ident = content.parse()?;
    let content_of_type = if content.peek(Token![=]) {
        content.parse::<Token![=]>()?;
        let kind = content.call(Ident::parse_any)?;
        let parsed = match kind.to_string().as_str() {
            "grade" => {
                let number: syn::LitInt = content.parse()?;
                Content::Grade(number.base10_parse().unwrap_or(u32::MAX), number.span())
            }
            "even" => Content::Even,
            "odd" => Content::Odd,
            "all" => Content::All,
            _ => {
                return Err(syn::Error::new(
                    kind.span(),
                    "expected `grade` and a number, `even`, `odd` or `all`",
                ));
            }
        };
        content.parse::<Token![;]>().map_err(|e| {
            syn::Error::new(e.span(), format!("expected `;` after the type `{name}`"))
        })?;
        parsed
    } else {
        let list;
        braced!(list in content);
        let blades = separated(&list, errors, parse_coefficient);
        let _ = content.parse::<Option<Token![,]>>()?;
        Content::Blades(blades)
    };
    Ok(TypeDeclaration {
        attributes,
        unit,
        name,
        content: content_of_type,
    })
}

fn parse_coefficient(entry: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Coefficient> {
    let span = entry.span();
    let mut factors = Vec::new();
    if entry.peek(Lit) {
        let literal: Lit = entry.parse()?;
        if !matches!(&literal, Lit::Int(one) if one.to_string() == "1") {
            return Err(syn::Error::new(
                literal.span(),
                "the scalar blade is written `1`; other blades by names, as in `e12` or `e1^e2`",
            ));
        }
    } else {
        factors.push(entry.call(Ident::parse_any)?);
        while entry.peek(Token![^]) {
            entry.parse::<Token![^]>()?;
            factors.push(entry.call(Ident::parse_any)?);
        }
    }
    let mut fixed = None;
    if entry.peek(Token![=]) {
        entry.parse::<Token![=]>()?;
        fixed = Some(parse_number(entry, errors)?);
    }
    Ok(Coefficient {
        factors,
        span,
        fixed,
    })
}
