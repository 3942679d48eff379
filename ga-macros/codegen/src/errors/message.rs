//! The table of messages: what is wrong, and the remedy.

use std::fmt;

use super::Mistake;
use super::wording::{basis_hint, counted, hint, shown};

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Mistake::*;
        match self {
            Syntax(what) => write!(f, "{what}"),
            TooDeep { limit } => write!(
                f,
                "brackets are nested more than {limit} deep; a declaration needs only three levels"
            ),
            NotAPath => f.write_str(
                "the path of the core crate belongs here; write it as in `crate = ::ga_core;`",
            ),
            PathWithoutSemicolon => f.write_str(
                "the path of the core crate ends with `;`; write one before this, as in \
                 `crate = ::ga_core;`",
            ),
            MissingSignature => f.write_str(
                "a signature is missing; write one such as `R3` or `R4_1`, or `mod name: R4_1 { \
                 … }`",
            ),
            ModuleWithoutSignature(name) => write!(
                f,
                "the algebra `{name}` has no signature; write it after the name, as in \
                 `mod {name}: R3 {{ … }}`"
            ),
            ModuleWithoutColon(name) => write!(
                f,
                "a colon stands between name and signature; write `mod {name}: R3 {{ … }}`"
            ),
            BodyWithoutBraces(name) => write!(
                f,
                "the sections of an algebra stand in braces; write `mod {name}: R3 {{ … }}`"
            ),
            NotAModule => {
                f.write_str("an algebra with sections is a module; write `mod name: R4_1 { … }`")
            }
            InnerAttribute => {
                f.write_str("an attribute stands before what it is about; write `#[…]` without `!`")
            }
            MarkBetweenSections(mark) => {
                write!(f, "nothing stands between two sections; remove `{mark}`")
            }
            SemicolonForComma => f.write_str("entries are separated by commas; write `,` for `;`"),
            Unexpected(text) => write!(
                f,
                "`{}` does not belong here; remove it, or write `,` before the next entry",
                shown(text)
            ),
            ModuleWithoutBody(name) => write!(
                f,
                "the algebra `{name}` has no body; write its sections in braces, as in \
                 `mod {name}: R3 {{ types {{ … }} }}`"
            ),
            SectionsOfPreset(signature) => write!(
                f,
                "only an algebra with a name has sections; write `mod name: {} {{ … }}`",
                shown(signature)
            ),
            Trailing => f.write_str(
                "nothing can follow the algebra; remove this, or put it into a call of its own",
            ),
            SectionWithoutBraces(name) => write!(
                f,
                "the section `{name}` is a list in braces; write `{name} {{ … }}`"
            ),
            NotASection => f.write_str(
                "a section belongs here; write `basis { … }`, `metric { … }`, `types { … }` or \
                 `products { … }`",
            ),
            MissingComma => f.write_str("entries are separated by commas; write `,` before this"),
            NotAName => {
                f.write_str("a name belongs here; write an identifier that is not a keyword")
            }
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
            SeveralSignatures => {
                f.write_str("one call declares one algebra; write a call for each signature")
            }
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
                "`{}` has too many dimensions to generate every grade; presets go to {limit}, \
                 beyond that declare sparse types in `types {{ … }}`",
                shown(signature)
            ),
            TooManyDimensions {
                signature,
                limit,
                preset: false,
            } => write!(
                f,
                "`{}` has too many dimensions; declared types go to {limit}, so write a smaller \
                 signature",
                shown(signature)
            ),
            SignatureMismatch {
                declared,
                actual,
                degenerate,
            } => write!(
                f,
                "the metric has signature `{actual}`, not `{declared}`; write `{actual}` or change \
                 the metric{}",
                if *degenerate {
                    ", in which entries not written are 0"
                } else {
                    ""
                }
            ),
            BasisCount {
                signature,
                expected,
                found,
            } => write!(
                f,
                "`{signature}` needs {}, but {found} {} named; name exactly {expected}",
                counted(*expected, "basis vector"),
                if *found == 1 { "is" } else { "are" }
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
                "`{name}` cannot name a basis vector, because it cannot name a field: keywords, \
                 `s` and `T` are taken; choose another name, such as `e1`"
            ),
            NotAMetricEntry => f.write_str(
                "this is not a metric entry; write a square such as `e1^2 = 1` or a product such \
                 as `e1.e2 = 0`",
            ),
            UnknownBasisVector {
                name,
                basis,
                named,
                suggestion,
            } => write!(
                f,
                "`{name}` is not a vector of the basis {basis}; {}{}",
                hint(suggestion, "write one of these"),
                basis_hint(*named)
            ),
            MiddleDot(name) => write!(
                f,
                "Rust reads `{name}` as one name, because `·` counts as a letter; write `{}`",
                name.replace('·', ".")
            ),
            NotASquare(name) => write!(
                f,
                "a metric has no power but the square; write `{name}^2 = value`, or \
                 `{name}.other = value` for a product"
            ),
            NotSymmetric(entry) => write!(
                f,
                "`{entry}` contradicts the value given the other way round; a metric is \
                 symmetric, so give one value"
            ),
            ContradictoryMetricEntry(entry) => write!(
                f,
                "`{entry}` was given another value before; remove one of the entries"
            ),
            DuplicateMetricEntry(entry) => {
                write!(f, "`{entry}` is given twice; remove one of the entries")
            }
            NotRational(text) if text.is_empty() => f.write_str(
                "a number is missing; write an integer, a fraction such as `1/2` or a decimal \
                 such as `0.5`",
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
            ZeroDenominator => {
                f.write_str("nothing can be divided by 0; write another denominator, as in `1/2`")
            }
            UnknownBlade {
                name,
                basis,
                named,
                suggestion,
            } => write!(
                f,
                "`{}` is not a blade over {basis}; {}{}",
                shown(name),
                hint(
                    suggestion,
                    "join basis vectors with `^`, or write `1` for the scalar"
                ),
                basis_hint(*named)
            ),
            BladeJoinedBy(mark) => write!(
                f,
                "the vectors of a blade are joined with `^`; write `^` for `{mark}`"
            ),
            AttributeOnBlade => f.write_str(
                "a coefficient takes no attributes and no doc comments; move this to the type",
            ),
            SignedBlade => f.write_str(
                "a blade carries no sign; write its vectors in another order, as in `e31` for \
                 −e13",
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
                "the blade `{blade}` is listed twice in this type; remove one"
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
            BladesWithoutBraces(name) => write!(
                f,
                "the blades of a type stand in braces; write `{name} {{ e1, e2 }}`"
            ),
            EqualsBeforeBraces(name) => write!(
                f,
                "a list of blades follows the name at once; write `{name} {{ … }}` without `=`"
            ),
            SemicolonAfterBraces => {
                f.write_str("a type that lists its blades ends with the brace; remove `;`")
            }
            SectionAmongTypes(name) => write!(
                f,
                "`{name}` is a section of its own; close `types {{ … }}` before it"
            ),
            WordBeforeType(word) => write!(
                f,
                "a type is declared by its name alone and is always public; remove `{word}`"
            ),
            TypeParameters => f.write_str(
                "a type takes no parameters, because each is generic over its numbers; remove \
                 `<…>`",
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
                 name, such as `My{name}`"
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
            GradeWithoutNumber => f.write_str("a grade is a number; write one, as in `= grade 2;`"),
            MissingSemicolon => {
                f.write_str("a type declared with `=` ends with `;`; write one after this")
            }
            SetGoesOn(name) => write!(
                f,
                "a set of blades ends here; write `;`, or list the blades, as in \
                 `{name} {{ 1, e12 }}`"
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
            NeverNull(name) => write!(
                f,
                "`{name}` has no values but zero that square to 0; remove `#[null]`, or add blades \
                 of the opposite square"
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
                "the section `{name}` is written twice; put all into one `{name} {{ … }}`"
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
            Overflow => f.write_str(
                "the products of this metric have coefficients beyond exact arithmetic; scale \
                 the basis vectors so that the entries become small",
            ),
            UnsupportedAttribute(name) => write!(
                f,
                "`#[{name}]` is not allowed here; a type takes doc comments, `#[unit]`, \
                 `#[null]`, `#[deprecated]`, `#[must_use]`, `#[allow]` and `#[expect]`"
            ),
        }
    }
}
