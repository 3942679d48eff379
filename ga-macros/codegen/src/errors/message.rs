//! The table of messages: what is wrong, and the remedy.

use std::fmt;

use super::Mistake;

/// The remedy: a name that was probably meant, else what holds in general.
fn hint(suggestion: &Option<String>, otherwise: &str) -> String {
    match suggestion {
        Some(name) => format!("did you mean `{name}`?"),
        None => otherwise.to_owned(),
    }
}

/// What was written, cut where it is too long to be shown.
fn shown(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Mistake::*;
        match self {
            Syntax(what) => write!(f, "{what}"),
            TooDeep { limit } => write!(
                f,
                "brackets are nested more than {limit} deep; a declaration needs three levels"
            ),
            NotAPath => write!(
                f,
                "the path of the core crate belongs here; write it as in `crate = ::ga_core;`"
            ),
            MissingSignature => write!(
                f,
                "a signature is missing; write one such as `R3` or `R4_1`, or \
                 `mod name: R4_1 {{ … }}`"
            ),
            ModuleWithoutSignature(name) => write!(
                f,
                "the algebra `{name}` has no signature; write it behind the name, as in \
                 `mod {name}: R3 {{ … }}`"
            ),
            ModuleWithoutBody(name) => write!(
                f,
                "the algebra `{name}` has no body; write its sections in braces, as in \
                 `mod {name}: R3 {{ types {{ … }} }}`"
            ),
            SectionsOfPreset(signature) => write!(
                f,
                "sections belong to an algebra with a name; write `mod name: {} {{ … }}`",
                shown(signature)
            ),
            Trailing => write!(
                f,
                "nothing can stand behind the algebra; remove this, or put it into a call of its \
                 own"
            ),
            SectionWithoutBraces(name) => write!(
                f,
                "the section `{name}` is a list in braces; write `{name} {{ … }}`"
            ),
            NotASection => write!(
                f,
                "a section belongs here; write `basis {{ … }}`, `metric {{ … }}`, `types {{ … }}` \
                 or `products {{ … }}`"
            ),
            MissingComma => write!(f, "entries are separated by commas; write `,` before this"),
            NotAName => write!(
                f,
                "a name belongs here; write an identifier that is no keyword"
            ),
            UnknownSignature { text, suggestion } => write!(
                f,
                "`{}` is not a signature; {}",
                shown(text),
                hint(
                    suggestion,
                    "write `R` and the numbers of basis vectors that square to +1, −1 and 0, as in \
                     `R3`, `R4_1` or `R3_0_1`"
                )
            ),
            NoDimension(text) => write!(
                f,
                "`{text}` has no dimension; an algebra needs at least one basis vector, as in `R1`"
            ),
            TooManyDimensions {
                signature,
                limit,
                preset: true,
            } => write!(
                f,
                "`{}` has too many dimensions for every grade to be generated; that goes to \
                 {limit}, beyond it declare sparse types in `types {{ … }}`",
                shown(signature)
            ),
            TooManyDimensions {
                signature,
                limit,
                preset: false,
            } => write!(
                f,
                "`{}` has too many dimensions; declared types go to {limit}",
                shown(signature)
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
                "`{signature}` needs {expected} basis vectors, but {found} are named; name exactly \
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
                "`{name}` cannot name a basis vector, because fields are named after it and \
                 keywords, `s` and `T` are taken; choose another name, as in `e1`"
            ),
            NotAMetricEntry => write!(
                f,
                "a metric entry is a square such as `e1^2 = 1` or a product such as `e1.e2 = 0`"
            ),
            UnknownBasisVector {
                name,
                basis,
                suggestion,
            } => write!(
                f,
                "`{name}` is not a vector of the basis {basis}; {}",
                hint(suggestion, "name one of these")
            ),
            NotASquare(name) => write!(
                f,
                "a metric entry is a square; write `{name}^2 = value`, or `{name}.other = value` \
                 for a product"
            ),
            NotSymmetric { left, right } => write!(
                f,
                "`{left}.{right}` has another value above; a metric is symmetric, give one value"
            ),
            DuplicateMetricEntry { left, right } => write!(
                f,
                "`{left}.{right}` is given twice; remove one of the entries"
            ),
            NotRational(text) if text.is_empty() => write!(
                f,
                "a number is missing; write an integer, a fraction such as `1/2` or a decimal such \
                 as `0.5`"
            ),
            NotRational(text) => write!(
                f,
                "`{}` is not an exact rational; write an integer, a fraction such as `1/2` or a \
                 decimal such as `0.5`",
                shown(text)
            ),
            NumberTooLarge { limit } => write!(
                f,
                "this number is too large for exact arithmetic; numerators and denominators go to \
                 {limit}"
            ),
            ZeroDenominator => write!(
                f,
                "nothing can be divided by 0; write another denominator, as in `1/2`"
            ),
            UnknownBlade {
                name,
                basis,
                suggestion,
            } => write!(
                f,
                "`{}` is not a blade over {basis}; {}",
                shown(name),
                hint(
                    suggestion,
                    "join basis vectors with `^`, or write `1` for the scalar"
                )
            ),
            SignedBlade => write!(
                f,
                "a blade carries no sign; write its vectors in another order, as in `e31` for −e13"
            ),
            NumberAsBlade(text) => write!(
                f,
                "`{}` is not a blade; the scalar is written `1`, other blades by their vectors, as \
                 in `e12` or `e1^e2`",
                shown(text)
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
            FieldClash { name, field } => write!(
                f,
                "two blades of `{name}` would both be the field `{field}`; choose basis names that \
                 stay distinct when joined"
            ),
            TypeWithoutBlades(name) => write!(
                f,
                "the type `{name}` does not say which blades it holds; write \
                 `{name} {{ e1, e2 }}` or `{name} = grade 1;`"
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
            UnknownContent { name, suggestion } => write!(
                f,
                "`{name}` is not a set of blades; {}",
                hint(
                    suggestion,
                    "write `grade` and a number, `even`, `odd` or `all`, or list the blades in \
                     braces"
                )
            ),
            GradeWithoutNumber => write!(f, "a grade is a number; write one, as in `= grade 2;`"),
            MissingSemicolon(name) => write!(
                f,
                "a type declared with `=` ends with `;`; write one behind `{name} = …`"
            ),
            GradeTooLarge { grade, dimension } => write!(
                f,
                "there is no grade {} in {dimension} dimensions; grades go from 0 to {dimension}",
                shown(grade)
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
            NotAProduct(name) => write!(
                f,
                "`{name}` takes one operand and is always generated; remove it from the products"
            ),
            DuplicateProduct(name) => write!(f, "the product `{name}` is listed twice; remove one"),
            FixedCannotBeKept { name, blades } => write!(
                f,
                "sums of `{name}` lose its fixed coefficient and no declared type holds \
                 {{{blades}}}; declare one, as in `General{name} {{ {blades} }}`"
            ),
            Overflow => write!(
                f,
                "the products of this metric have coefficients beyond exact arithmetic; scale the \
                 basis vectors so that the entries become small"
            ),
            UnsupportedAttribute(name) => write!(
                f,
                "`#[{name}]` cannot stand here; a type takes doc comments, `#[unit]`, \
                 `#[deprecated]`, `#[must_use]`, `#[allow]` and `#[expect]`"
            ),
        }
    }
}
