//! Every mistake the macro can name, and which of them follow from others.

/// A mistake in a call of `define_algebra!`: what is wrong, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// Tokens that follow no rule of the grammar, in the words of the parser that met them.
    Syntax(String),
    /// Brackets nested deeper than any declaration needs.
    TooDeep { limit: usize },
    /// `crate = …` without a path.
    NotAPath,
    /// `crate = path` without a semicolon.
    PathWithoutSemicolon,
    /// Nothing where a signature belongs.
    MissingSignature,
    /// `mod name { … }`.
    ModuleWithoutSignature(String),
    /// `mod name R3 { … }`.
    ModuleWithoutColon(String),
    /// `mod name: R3` and no braces.
    ModuleWithoutBody(String),
    /// `mod name: R3 ( … )`.
    BodyWithoutBraces(String),
    /// `struct name: R3 { … }`.
    NotAModule,
    /// `R3 { … }`.
    SectionsOfPreset(String),
    /// Tokens behind the whole algebra.
    Trailing,
    /// An attribute of the form `#![…]`.
    InnerAttribute,
    /// A section without its braces.
    SectionWithoutBraces(String),
    /// Something other than a section.
    NotASection,
    /// A mark between two sections.
    MarkBetweenSections(char),
    /// Two entries without a comma between.
    MissingComma,
    /// Two entries with a semicolon between.
    SemicolonForComma,
    /// A token that continues no entry.
    Unexpected(String),
    /// Something other than a name in a list of names.
    NotAName,
    /// A signature that is not of the form `Rp_q_r`.
    UnknownSignature {
        text: String,
        suggestion: Option<String>,
    },
    /// Several signatures in one call.
    SeveralSignatures,
    /// A signature of no dimension.
    NoDimension(String),
    /// More dimensions than the macro supports.
    TooManyDimensions {
        signature: String,
        limit: usize,
        preset: bool,
    },
    /// The metric has another signature than the one declared.
    SignatureMismatch {
        declared: String,
        actual: String,
        /// Whether more vectors square to zero than are declared to.
        degenerate: bool,
    },
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
    /// A basis name that is no field name, or that is one already.
    ReservedBasisName(String),
    /// A metric entry of another form.
    NotAMetricEntry,
    /// A metric entry that names no basis vector.
    UnknownBasisVector {
        name: String,
        basis: String,
        /// Whether the call names its basis.
        named: bool,
        suggestion: Option<String>,
    },
    /// `no·ni = -1`, which Rust reads as one name.
    MiddleDot(String),
    /// `e1^3 = 1`.
    NotASquare(String),
    /// A metric entry given both ways with different values, `e1.e2 = 1` and `e2.e1 = 2`.
    NotSymmetric(String),
    /// A metric entry given twice with different values.
    ContradictoryMetricEntry(String),
    /// A metric entry given twice with the same value.
    DuplicateMetricEntry(String),
    /// A number that is no exact rational.
    NotRational(String),
    /// A number too large to compute with exactly.
    NumberTooLarge { limit: i128 },
    /// A denominator of zero.
    ZeroDenominator,
    /// A blade with a factor outside the basis.
    UnknownBlade {
        name: String,
        basis: String,
        /// Whether the call names its basis.
        named: bool,
        suggestion: Option<String>,
    },
    /// `e1*e2`.
    BladeJoinedBy(char),
    /// An attribute or a doc comment on one coefficient.
    AttributeOnBlade,
    /// `-e13`.
    SignedBlade,
    /// A number other than 1 where a blade belongs.
    NumberAsBlade(String),
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
    /// Two blades of a type that would be the same field.
    FieldClash { name: String, field: String },
    /// A type without `{ … }` and without `= …;`.
    TypeWithoutBlades(String),
    /// A type whose blades stand in other brackets than braces.
    BladesWithoutBraces(String),
    /// `Name = { … }`.
    EqualsBeforeBraces(String),
    /// `Name { … };`.
    SemicolonAfterBraces,
    /// A section among the types.
    SectionAmongTypes(String),
    /// `pub` or `struct` in front of a type.
    WordBeforeType(String),
    /// `Name<T> { … }`.
    TypeParameters,
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
    /// `= something` that is no set of blades.
    UnknownContent {
        name: String,
        suggestion: Option<String>,
    },
    /// `= grade` without a number.
    GradeWithoutNumber,
    /// `= grade 2` without a semicolon.
    MissingSemicolon,
    /// `= grade 1 + grade 2`.
    SetGoesOn(String),
    /// A grade above the dimension.
    GradeTooLarge { grade: String, dimension: usize },
    /// `#[unit]` on a type that mixes even and odd blades.
    UnitMixedParity(String),
    /// `#[null]` on a type of whose values none, or zero alone, squares to 0.
    NeverNull(String),
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
    /// Something in the list of products that is generated in any case.
    NotAProduct(String),
    /// A product listed twice.
    DuplicateProduct(String),
    /// No declared type holds the result of an operation that keeps no fixed coefficient.
    FixedCannotBeKept { name: String, blades: String },
    /// Coefficients of a product overflow exact arithmetic.
    Overflow,
    /// An attribute that a type cannot have.
    UnsupportedAttribute(String),
}

impl Mistake {
    /// Whether a metric is incomplete because of it, so that its signature says nothing.
    pub fn is_about_metric(&self) -> bool {
        use Mistake::*;
        matches!(
            self,
            NotAMetricEntry
                | NotAName
                | NotASquare(_)
                | UnknownBasisVector { .. }
                | MiddleDot(_)
                | NotSymmetric(_)
                | ContradictoryMetricEntry(_)
                | SemicolonForComma
                | Unexpected(_)
                | DuplicateBasisName(_)
                | NotRational(_)
                | NumberTooLarge { .. }
                | ZeroDenominator
        )
    }

    /// Whether it says something about blades only, so that an unknown dimension explains it.
    pub fn is_about_blades(&self) -> bool {
        use Mistake::*;
        matches!(
            self,
            AmbiguousBasisName { .. }
                | UnknownBasisVector { .. }
                | UnknownBlade { .. }
                | AmbiguousBlade { .. }
                | FieldClash { .. }
                | NothingFree(_)
                | MisusedName { .. }
                | GradeTooLarge { .. }
                | UnitMixedParity(_)
                | NeverNull(_)
                | TypeTooLarge { .. }
                | FixedCannotBeKept { .. }
                | Overflow
        )
    }
}
