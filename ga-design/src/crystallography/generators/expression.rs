//! How a generator with its joining constraints is written and read: `T_c^{1/2} ab`.
//!
//! ```text
//! generator  = { translator } word | { translator } "[" { translator } word "]"
//! translator = "T_" ( "a" | "b" | "c" ) "^{" [ "-" ] integer [ "/" integer ] "}"
//! word       = "a" | "b" | "c" | "ab" | "bc" | "ca" | "abc" | "bac"
//! ```
//! `T_c^{1/2} ab` is a translation by half the edge c̲ after the word `ab`: a screw or a glide.
//! `T_b^{-1/4}[T_a^{1/2} bc]` is such a generator moved by −¼ b̲ (3.3.2). Blanks do not count.

use std::fmt;
use std::str::FromStr;

use ga_cga::Vector3;
use num_rational::Ratio;

use super::super::symbol_reader::SymbolReader;
use super::super::{Isometry, Word};

/// The largest numerator or denominator of an exponent.
const LARGEST_NUMBER: i32 = 5040;

/// A generator of a space group: a word in the roots, joined with translations along the edges of
/// the cell.
///
/// ```
/// use ga_design::crystallography::GeneratorExpression;
///
/// let screw: GeneratorExpression = "T_b^{-1/4}[T_a^{1/2}bc]".parse()?;
/// assert_eq!(screw.to_string(), "T_b^{-1/4}[T_a^{1/2} bc]");
/// # Ok::<(), ga_design::crystallography::ExpressionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GeneratorExpression {
    /// The product of roots.
    pub word: Word,
    /// The translation that follows the word, in fractions of the edges.
    pub translation: [Ratio<i32>; 3],
    /// By how much the whole is moved, in fractions of the edges.
    pub moved: [Ratio<i32>; 3],
}

/// Why a text is no generator. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExpressionError {
    /// A character that cannot stand there.
    #[error("unexpected `{found}` at column {column}; {expected}")]
    Unexpected {
        /// What stands there.
        found: char,
        /// Its column.
        column: usize,
        /// What could stand there.
        expected: &'static str,
    },
    /// The text ends too early.
    #[error("the generator ends where {expected} should stand")]
    Unfinished {
        /// What is missing.
        expected: &'static str,
    },
    /// Letters that are no product of roots in use.
    #[error("`{found}` is no word in the roots; one of a, b, c, ab, bc, ca, abc, bac")]
    Word {
        /// The letters.
        found: String,
    },
    /// An exponent that is no fraction of an edge.
    #[error(
        "the exponent at column {column} is no fraction with numbers from 1 to {LARGEST_NUMBER}"
    )]
    Exponent {
        /// Where it stands.
        column: usize,
    },
}

impl GeneratorExpression {
    /// The versor: the word of the roots, then the translation, all of it moved; edges and roots
    /// in space. `None` if a root that the word needs has no direction, or a translation no finite
    /// length.
    pub fn isometry(&self, roots: &[Vector3; 3], edges: &[Vector3; 3]) -> Option<Isometry> {
        let turned = self.word.isometry(roots)?;
        let joined = Isometry::translation(along(self.translation, edges)).after(&turned);
        let frame = Isometry::translation(along(self.moved, edges));
        let isometry = joined.moved_by(&frame);
        let finite = isometry.shift().norm().is_finite();
        finite.then_some(isometry)
    }
}

/// The vector that has these fractions of the edges.
pub(super) fn along(fractions: [Ratio<i32>; 3], edges: &[Vector3; 3]) -> Vector3 {
    fractions
        .iter()
        .zip(edges)
        .fold(Vector3::default(), |sum, (fraction, edge)| {
            sum + *edge * (f64::from(*fraction.numer()) / f64::from(*fraction.denom()))
        })
}

impl fmt::Display for GeneratorExpression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joined = |f: &mut fmt::Formatter<'_>| {
            translators(f, &self.translation)?;
            let some = self.translation.iter().any(|part| *part.numer() != 0);
            write!(f, "{}{}", if some { " " } else { "" }, self.word)
        };
        if self.moved.iter().all(|part| *part.numer() == 0) {
            return joined(f);
        }
        translators(f, &self.moved)?;
        f.write_str("[")?;
        joined(f)?;
        f.write_str("]")
    }
}

fn translators(f: &mut fmt::Formatter<'_>, vector: &[Ratio<i32>; 3]) -> fmt::Result {
    for (edge, part) in ["a", "b", "c"].iter().zip(vector) {
        if *part.numer() != 0 {
            write!(f, "T_{edge}^{{{part}}}")?;
        }
    }
    Ok(())
}

impl FromStr for GeneratorExpression {
    type Err = ExpressionError;

    fn from_str(text: &str) -> Result<Self, ExpressionError> {
        let mut reader = Reader(SymbolReader::new(text, |c| !c.is_whitespace()));
        let outer = reader.translators()?;
        let expression = if reader.0.take(|c| c == '[') {
            let translation = reader.translators()?;
            let word = reader.word()?;
            reader.need(']', "`]` after the word")?;
            Self {
                word,
                translation,
                moved: outer,
            }
        } else {
            Self {
                word: reader.word()?,
                translation: outer,
                moved: [Ratio::from_integer(0); 3],
            }
        };
        match reader.0.peek() {
            None => Ok(expression),
            Some(_) => Err(reader.unexpected("the generator ends there")),
        }
    }
}

struct Reader(SymbolReader);

impl Reader {
    fn need(&mut self, wanted: char, expected: &'static str) -> Result<(), ExpressionError> {
        if self.0.take(|c| c == wanted) {
            Ok(())
        } else {
            Err(self.unexpected(expected))
        }
    }

    fn unexpected(&self, expected: &'static str) -> ExpressionError {
        match self.0.peek() {
            None => ExpressionError::Unfinished { expected },
            Some((column, found)) => ExpressionError::Unexpected {
                found,
                column,
                expected,
            },
        }
    }

    /// The sum of the translations; the same edge may stand more than once.
    fn translators(&mut self) -> Result<[Ratio<i32>; 3], ExpressionError> {
        let mut sum = [Ratio::from_integer(0); 3];
        while let Some((column, _)) = self.0.peek().filter(|(_, c)| *c == 'T') {
            self.need('T', "`T` before the edge")?;
            self.need('_', "`_` after `T`")?;
            let edge = self
                .0
                .next_of(|c| ['a', 'b', 'c'].into_iter().position(|edge| edge == c))
                .ok_or_else(|| self.unexpected("an edge goes there: a, b or c"))?;
            self.need('^', "`^` after the edge")?;
            self.need('{', "`{` before the exponent")?;
            let sign = if self.0.take(|c| c == '-') { -1 } else { 1 };
            let numerator = self.integer(column)?;
            let denominator = if self.0.take(|c| c == '/') {
                self.integer(column)?
            } else {
                1
            };
            self.need('}', "`}` after the exponent")?;
            let part = Ratio::new(sign * numerator, denominator);
            // Every translation of an operation is a multiple of one over the largest number.
            let total = sum[edge] + part;
            if LARGEST_NUMBER % *total.denom() != 0 || total.numer().abs() > LARGEST_NUMBER {
                return Err(ExpressionError::Exponent { column });
            }
            sum[edge] = total;
        }
        Ok(sum)
    }

    fn integer(&mut self, column: usize) -> Result<i32, ExpressionError> {
        let digits = self.0.digits();
        let value = digits.ok_or_else(|| self.unexpected("digits of the exponent go there"))?;
        let value = i32::try_from(value).ok();
        value
            .filter(|value| (1..=LARGEST_NUMBER).contains(value))
            .ok_or(ExpressionError::Exponent { column })
    }

    fn word(&mut self) -> Result<Word, ExpressionError> {
        let mut letters = String::new();
        let root = |c| matches!(c, 'a' | 'b' | 'c').then_some(c);
        while let Some(c) = self.0.next_of(root) {
            // Longer than any word, the rest does not matter.
            if letters.len() < 8 {
                letters.push(c);
            }
        }
        if letters.is_empty() {
            return Err(self.unexpected("a word in the roots a, b, c goes there"));
        }
        Word::from_letters(&letters).ok_or(ExpressionError::Word { found: letters })
    }
}
