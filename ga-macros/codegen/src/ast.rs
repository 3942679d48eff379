//! What the user wrote, token by token: every node keeps the span that an error points at.

use proc_macro2::{Ident, Span};
use syn::{Attribute, LitInt, Path, Visibility};

/// One call of `define_algebra!`.
pub struct Input {
    /// Where generated code finds ga-core (`crate = path;`).
    pub core: Option<Path>,
    /// The algebra that is declared.
    pub algebra: Algebra,
}

/// `pub mod name: R4_1 { … }`, or a preset, which has no sections.
pub struct Algebra {
    /// Documentation and other attributes of the module.
    pub attributes: Vec<Attribute>,
    /// Visibility of the module.
    pub visibility: Visibility,
    /// Name of the module; a preset derives it from its signature.
    pub name: Ident,
    /// The signature as written.
    pub signature: Signature,
    /// `basis { … }`.
    pub basis: Option<Vec<Ident>>,
    /// `metric { … }`.
    pub metric: Option<Vec<MetricEntry>>,
    /// `types { … }`.
    pub types: Option<Vec<TypeDeclaration>>,
    /// `products { … }`.
    pub products: Option<Vec<Ident>>,
}

impl Algebra {
    /// An algebra of which no section has been read.
    pub fn without_sections(
        attributes: Vec<Attribute>,
        visibility: Visibility,
        name: Ident,
        signature: Signature,
    ) -> Algebra {
        Algebra {
            attributes,
            visibility,
            name,
            signature,
            basis: None,
            metric: None,
            types: None,
            products: None,
        }
    }
}

/// The first and the last token of something written.
pub type Spans = (Span, Span);

/// A signature such as `R4_1`.
pub struct Signature {
    /// The text, `R4_1`; empty where none was written, which has been reported.
    pub text: String,
    /// Where it stands.
    pub spans: Spans,
}

/// `a^2 = value` (then both names are one) or `a.b = value`.
pub struct MetricEntry {
    /// The first vector.
    pub left: Ident,
    /// The second vector; none in a square.
    pub right: Option<Ident>,
    /// The value of their inner product.
    pub value: Number,
}

/// A rational constant.
pub struct Number {
    /// Its exact value, numerator and denominator.
    pub value: (i128, i128),
    /// Where it stands.
    pub spans: Spans,
}

/// One entry of `types { … }`.
pub struct TypeDeclaration {
    /// Documentation and other attributes, passed on to the struct.
    pub attributes: Vec<Attribute>,
    /// `#[unit]`: values of the type are unit versors, and `apply` may use it.
    pub unit: bool,
    /// `#[null]`: values of the type square to 0, and `apply` may use it.
    pub null: bool,
    /// The name of the struct.
    pub name: Ident,
    /// The coefficients it stores.
    pub content: Content,
}

/// The ways to say which blades a type holds.
pub enum Content {
    /// `{ 1, e12, e1^ni, no = 1 }`.
    Blades(Vec<Coefficient>),
    /// `= grade 2;`.
    Grade(LitInt),
    /// `= even;`.
    Even,
    /// `= odd;`.
    Odd,
    /// `= all;`.
    All,
    /// Something that could not be read and has been reported.
    Unknown,
}

/// One coefficient of a type: a blade as spelled, perhaps with a value fixed at compile time.
pub struct Coefficient {
    /// The identifiers joined by `^`; empty for the scalar `1`.
    pub factors: Vec<Ident>,
    /// Where the blade stands, without its value.
    pub spans: Spans,
    /// The fixed value of `blade = value`.
    pub fixed: Option<Number>,
}
