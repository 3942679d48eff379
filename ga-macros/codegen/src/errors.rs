//! Every mistake the macro can name: one table of messages, each with its remedy.

use std::fmt;

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

/// A mistake in a call of `define_algebra!`: what is wrong, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// The tokens do not follow the grammar.
    Syntax(String),
    /// A signature that is not of the form `Rp_q_r`.
    UnknownSignature(String),
    /// `R4-1` and the like.
    DashedSignature(String),
    /// A signature of no dimension.
    NoDimension(String),
    /// More dimensions than the macro supports.
    TooManyDimensions {
        dimension: usize,
        limit: usize,
        preset: bool,
    },
    /// The metric has another signature than the one declared.
    SignatureMismatch { declared: String, actual: String },
    /// The basis has another number of vectors than the signature.
    BasisCount {
        signature: String,
        expected: usize,
        found: usize,
    },
    /// The same basis name twice.
    DuplicateBasisName(String),
    /// A basis name that cannot be told apart from a product of others.
    AmbiguousBasisName { name: String, reading: String },
    /// A basis name that clashes with generated code.
    ReservedBasisName(String),
    /// A metric entry that names no basis vector.
    UnknownBasisVector {
        name: String,
        suggestion: Option<String>,
    },
    /// `e1^3 = 1`.
    NotASquare(String),
    /// A metric entry given twice with different values, `e1.e2 = 1` and `e2.e1 = 2`.
    NotSymmetric { left: String, right: String },
    /// A metric entry given twice with the same value.
    DuplicateMetricEntry { left: String, right: String },
    /// A metric entry that is no exact rational.
    NotRational(String),
    /// A number too large to compute with exactly.
    NumberTooLarge,
    /// A denominator of zero.
    ZeroDenominator,
    /// A blade with a factor outside the basis.
    UnknownBlade {
        name: String,
        suggestion: Option<String>,
    },
    /// An identifier that reads as two different blades.
    AmbiguousBlade {
        name: String,
        first: String,
        second: String,
    },
    /// A basis vector twice within one blade.
    RepeatedFactor { blade: String, factor: String },
    /// A blade twice within one type, perhaps with another sign.
    DuplicateBlade { blade: String, first: String },
    /// A type without blades.
    EmptyType(String),
    /// A type all of whose coefficients are fixed.
    NothingFree(String),
    /// A fixed coefficient of zero.
    FixedZero(String),
    /// A type name twice.
    DuplicateType(String),
    /// A type name that generated code uses.
    ReservedType(String),
    /// `Scalar`, `Even`, `Odd` or `Multivector` declared with other blades than they stand for.
    MisusedName { name: String, meaning: String },
    /// A type name that is not in upper camel case.
    TypeCase { name: String, suggestion: String },
    /// A grade above the dimension.
    GradeTooLarge { grade: u32, dimension: usize },
    /// `#[unit]` on a type that mixes even and odd blades.
    UnitMixedParity(String),
    /// A type with more fields than the macro unrolls.
    TypeTooLarge {
        name: String,
        fields: usize,
        limit: usize,
    },
    /// A section given twice.
    DuplicateSection(String),
    /// A section with an unknown name.
    UnknownSection {
        name: String,
        suggestion: Option<String>,
    },
    /// A product with an unknown name.
    UnknownProduct {
        name: String,
        suggestion: Option<String>,
    },
    /// A product listed twice.
    DuplicateProduct(String),
    /// No declared type holds the result of an operation that keeps no fixed coefficient.
    FixedCannotBeKept { name: String, blades: String },
    /// Coefficients of a product overflow exact arithmetic.
    Overflow,
    /// Reserved attributes on declarations.
    UnsupportedAttribute(String),
}

fn hint(suggestion: &Option<String>, otherwise: &str) -> String {
    match suggestion {
        Some(name) => format!("did you mean `{name}`?"),
        None => otherwise.to_owned(),
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Mistake::*;
        match self {
            Syntax(what) => write!(f, "{what}"),
            UnknownSignature(text) => write!(
                f,
                "`{text}` is not a signature; write `R` and the numbers of basis vectors that \
                 square to +1, −1 and 0, as in `R3`, `R4_1` or `R3_0_1`"
            ),
            DashedSignature(text) => write!(
                f,
                "a signature is one word; write `{text}` with underscores"
            ),
            NoDimension(text) => write!(
                f,
                "`{text}` has no dimension; an algebra needs at least one basis vector, as in `R1`"
            ),
            TooManyDimensions {
                dimension,
                limit,
                preset: true,
            } => write!(
                f,
                "{dimension} dimensions are too many for a preset, which declares every grade; \
                 presets go to {limit}, beyond that declare sparse types in `types {{ … }}`"
            ),
            TooManyDimensions {
                dimension,
                limit,
                preset: false,
            } => write!(
                f,
                "{dimension} dimensions are too many; declared types go to {limit}"
            ),
            SignatureMismatch { declared, actual } => write!(
                f,
                "the metric has signature `{actual}`, not `{declared}`; write `{actual}` or change \
                 the metric"
            ),
            BasisCount {
                signature,
                expected,
                found,
            } => write!(
                f,
                "`{signature}` has {expected} basis vectors, but {found} are named; name exactly \
                 {expected}"
            ),
            DuplicateBasisName(name) => write!(
                f,
                "the basis vector `{name}` is named twice; give each vector its own name"
            ),
            AmbiguousBasisName { name, reading } => write!(
                f,
                "the basis name `{name}` also reads as the blade {reading}; choose another name"
            ),
            ReservedBasisName(name) => write!(
                f,
                "`{name}` cannot name a basis vector, because the generated code uses it; choose \
                 another name, as in `e{name}`"
            ),
            UnknownBasisVector { name, suggestion } => write!(
                f,
                "`{name}` is not a basis vector; {}",
                hint(
                    suggestion,
                    "the metric is given between the vectors of `basis { … }`"
                )
            ),
            NotASquare(name) => write!(
                f,
                "a metric entry is a square `{name}^2 = value` or a product `{name}.other = value`"
            ),
            NotSymmetric { left, right } => write!(
                f,
                "`{left}.{right}` has another value above; a metric is symmetric, give one value"
            ),
            DuplicateMetricEntry { left, right } => write!(
                f,
                "`{left}.{right}` is given twice; remove one of the entries"
            ),
            NotRational(text) => write!(
                f,
                "`{text}` is not an exact rational; write an integer, a fraction such as `1/2` or \
                 a decimal such as `0.5`"
            ),
            NumberTooLarge => write!(
                f,
                "this number is too large for exact arithmetic; numerators and denominators go to \
                 1000000"
            ),
            ZeroDenominator => write!(f, "a fraction needs a denominator other than 0"),
            UnknownBlade { name, suggestion } => write!(
                f,
                "`{name}` is not a blade of this basis; {}",
                hint(
                    suggestion,
                    "join basis vectors with `^`, or write `1` for the scalar"
                )
            ),
            AmbiguousBlade {
                name,
                first,
                second,
            } => write!(
                f,
                "`{name}` reads both as {first} and as {second}; join the vectors with `^`"
            ),
            RepeatedFactor { blade, factor } => write!(
                f,
                "`{blade}` holds `{factor}` twice, so it is zero; each vector stands once in a blade"
            ),
            DuplicateBlade { blade, first } if blade == first => write!(
                f,
                "the blade `{blade}` stands twice in this type; remove one"
            ),
            DuplicateBlade { blade, first } => write!(
                f,
                "`{blade}` is the blade `{first}` again, up to its sign; remove one"
            ),
            EmptyType(name) => write!(
                f,
                "the type `{name}` holds no blade; list at least one, as in `{name} {{ 1 }}`"
            ),
            NothingFree(name) => write!(
                f,
                "every coefficient of `{name}` is fixed, so it has one value only; leave at least \
                 one free"
            ),
            FixedZero(blade) => write!(
                f,
                "a coefficient fixed at 0 is not there; leave `{blade}` out of the type"
            ),
            DuplicateType(name) => write!(
                f,
                "the type `{name}` is declared twice; give each type its own name"
            ),
            ReservedType(name) => write!(
                f,
                "`{name}` cannot name a type, because the generated code uses it; choose another \
                 name, as in `My{name}`"
            ),
            MisusedName { name, meaning } => write!(
                f,
                "`{name}` always means {meaning}; declare it so, leave it out, or choose another \
                 name"
            ),
            TypeCase { name, suggestion } => write!(
                f,
                "type names are in upper camel case; write `{suggestion}` for `{name}`"
            ),
            GradeTooLarge { grade, dimension } => write!(
                f,
                "there is no grade {grade} in {dimension} dimensions; grades go from 0 to \
                 {dimension}"
            ),
            UnitMixedParity(name) => write!(
                f,
                "`{name}` mixes even and odd blades and cannot be a versor; remove `#[unit]`"
            ),
            TypeTooLarge {
                name,
                fields,
                limit,
            } => write!(
                f,
                "`{name}` would have {fields} fields; types go to {limit}, list the blades that are \
                 needed"
            ),
            DuplicateSection(name) => write!(
                f,
                "the section `{name}` stands twice; write one `{name} {{ … }}`"
            ),
            UnknownSection { name, suggestion } => write!(
                f,
                "`{name}` is not a section; {}",
                hint(
                    suggestion,
                    "the sections are `basis`, `metric`, `types` and `products`"
                )
            ),
            UnknownProduct { name, suggestion } => write!(
                f,
                "`{name}` is not a product; {}",
                hint(suggestion, "leave `products` out to have them all")
            ),
            DuplicateProduct(name) => write!(f, "the product `{name}` is listed twice; remove one"),
            FixedCannotBeKept { name, blades } => write!(
                f,
                "sums of `{name}` lose its fixed coefficient and no declared type holds \
                 {{{blades}}}; declare one, as in `General{name} {{ {blades} }}`"
            ),
            Overflow => write!(
                f,
                "the products of this metric have coefficients beyond exact 64-bit arithmetic; \
                 scale the basis vectors so that the entries become small"
            ),
            UnsupportedAttribute(name) => write!(
                f,
                "`#[{name}]` cannot stand here; a type takes doc comments, `#[unit]`, `#[cfg]`-free \
                 lint attributes and `#[deprecated]`"
            ),
        }
    }
}

/// Collects all mistakes of one call, each with the tokens it is about.
#[derive(Default)]
pub struct Errors {
    found: Vec<(Span, Mistake)>,
}

impl Errors {
    /// Records a mistake at a span.
    pub fn push(&mut self, span: Span, mistake: Mistake) {
        self.found.push((span, mistake));
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

    /// How many mistakes were found so far.
    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// One line per mistake: `line:column: message`.
    pub fn report(&self) -> String {
        let mut lines = String::new();
        for (span, mistake) in &self.found {
            let start = span.start();
            lines.push_str(&format!("{}:{}: {mistake}\n", start.line, start.column + 1));
        }
        lines
    }

    /// The `compile_error!` items, each at its own tokens.
    pub fn to_tokens(&self) -> TokenStream {
        self.found
            .iter()
            .map(|(span, mistake)| {
                let message = mistake.to_string();
                quote_spanned!(*span=> ::core::compile_error! { #message })
            })
            .collect()
    }
}

/// The candidate closest to a misspelt name, if any is close.
pub fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let limit = 1 + name.chars().count() / 4;
    candidates
        .into_iter()
        .map(|candidate| (edit_distance(name, candidate), candidate))
        .filter(|(distance, _)| *distance <= limit)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate.to_owned())
}

/// Levenshtein's distance between two words.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
