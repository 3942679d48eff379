//! Numbers are exact: integers, fractions and decimals, never rounded.

use proc_macro2::{Ident, Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Lit, Token};

use crate::ast::Number;
use crate::errors::{Errors, Mistake};

/// The largest numerator or denominator: products of many such numbers stay exact.
const LIMIT: i128 = 1_000_000;

/// Reads up to the next comma, or up to a name after a number, before which a comma is missing;
/// what is no number is reported once, as a whole.
pub fn parse(entry: ParseStream<'_>, errors: &mut Errors) -> Number {
    let first = entry.span();
    let mut words: Vec<(String, Span)> = Vec::new();
    // Apart, because `syn` takes a sign as part of the literal.
    let negative = entry.parse::<Token![-]>().is_ok();
    if negative {
        words.push(("-".to_owned(), first));
    }
    let mut after_literal = false;
    while !entry.is_empty() && !entry.peek(Token![,]) && !entry.peek(Token![;]) {
        if after_literal && entry.peek(Ident::peek_any) {
            break;
        }
        after_literal = entry.peek(Lit);
        let word = match entry.peek(Lit).then(|| entry.parse::<Lit>()) {
            Some(Ok(literal)) => (quote::quote!(#literal).to_string(), literal.span()),
            _ => match entry.parse::<TokenTree>() {
                Ok(TokenTree::Group(group)) => (group.to_string(), group.span_close()),
                Ok(token) => (token.to_string(), token.span()),
                Err(_) => break,
            },
        };
        words.push(word);
    }
    let last = words.last().map_or(first, |(_, span)| *span);
    let magnitude: Vec<&str> = words
        .iter()
        .skip(usize::from(negative))
        .map(|(word, _)| word.as_str())
        .collect();
    let result = match magnitude.as_slice() {
        [whole] => decimal(whole),
        [above, "/", below] => fraction(above, below),
        _ => Err(None),
    };
    let (numerator, denominator) = result.unwrap_or_else(|mistake| {
        let text = || words.iter().map(|(word, _)| word.as_str()).collect();
        let mistake = mistake.unwrap_or_else(|| Mistake::NotRational(text()));
        let spans = match (&mistake, words.last()) {
            (Mistake::ZeroDenominator, Some((_, below))) => (*below, *below),
            _ => (first, last),
        };
        errors.push_range(spans, mistake);
        (1, 1)
    });
    Number {
        value: (if negative { -numerator } else { numerator }, denominator),
        spans: (first, last),
    }
}

/// Numerator and denominator, or what is wrong; `None` says that it is no number.
type Exact = Result<(i128, i128), Option<Mistake>>;

fn fraction(above: &str, below: &str) -> Exact {
    let ((a, b), (c, d)) = (decimal(above)?, decimal(below)?);
    if c == 0 {
        return Err(Some(Mistake::ZeroDenominator));
    }
    // Each is within the limit, so that the products are far from overflow.
    within_limit(a * d, b * c)
}

/// A literal such as `3`, `0.5` or `1_000` as an exact fraction.
fn decimal(text: &str) -> Exact {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    let all_digits = |s: &str| s.bytes().all(|c| c.is_ascii_digit());
    if whole.is_empty() || !all_digits(whole) || !all_digits(fraction) {
        return Err(None);
    }
    let fraction = fraction.trim_end_matches('0');
    let too_large = || Some(Mistake::NumberTooLarge { limit: LIMIT });
    let places = u32::try_from(fraction.len()).map_err(|_| too_large())?;
    let numerator: i128 = format!("{whole}{fraction}")
        .parse()
        .map_err(|_| too_large())?;
    let mut denominator = 10_i128.checked_pow(places).ok_or_else(too_large)?;
    let mut numerator = numerator;
    for prime in [2, 5] {
        while denominator % prime == 0 && numerator % prime == 0 {
            denominator /= prime;
            numerator /= prime;
        }
    }
    within_limit(numerator, denominator)
}

fn within_limit(numerator: i128, denominator: i128) -> Exact {
    if numerator > LIMIT || denominator > LIMIT {
        return Err(Some(Mistake::NumberTooLarge { limit: LIMIT }));
    }
    Ok((numerator, denominator))
}
