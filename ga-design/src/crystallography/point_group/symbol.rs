//! How the geometric symbol of a point group is written and read, and which generators it names
//! (Table 3.2).
//!
//! ```text
//! symbol   = factor [ factor ] | "b(" number number ")"
//! factor   = number | "b(" number ")" | number overline
//! number   = digit | "(" digit { digit } ")"            1 to 1000
//! overline = U+0305 | U+0304                            the digit before it is barred
//! ```
//! `b(4)2` is 4̄2: a bar over what stands in the brackets. One bar over both, `b(42)`, is another
//! group than two bars, `b(4)b(2)` or 4̄2̄. Blanks, and underscores for blanks, do not count.

use std::fmt;
use std::str::FromStr;

use super::super::roots::{Roots, RootsError};
use super::super::symbol_reader::SymbolReader;
use super::generator::Word;

/// What the bars of a symbol join: whether roots reflect on their own or act in a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bars {
    /// `p` alone: **a** and **b**; only **a** for p = 1.
    Single,
    /// p̄ alone: **ab**.
    BarredSingle,
    /// `pq`: **a**, **b** and **c**.
    None,
    /// p̄ q: **ab** and **c**.
    First,
    /// p q̄: **a** and **bc**.
    Second,
    /// p̄ q̄: **ab** and **bc**.
    Each,
    /// One bar over both: **abc**. (The last row of the printed table repeats p̄ q.)
    Both,
}

/// A geometric point group symbol after Hestenes and Holt: two angle numbers and bars.
///
/// ```
/// use ga_design::crystallography::PointSymbol;
///
/// let symbol: PointSymbol = "b(4)2".parse()?;
/// assert_eq!((symbol.p(), symbol.q()), (4, Some(2)));
/// assert_eq!(symbol.to_string(), "b(4)2");
/// assert_eq!(symbol.overlined(), "4̅2");
/// assert_eq!("4̅2".parse(), Ok(symbol));
/// # Ok::<(), ga_design::crystallography::PointSymbolError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PointSymbol {
    p: u32,
    q: u32,
    bars: Bars,
}

/// Why a text is no geometric point group symbol. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PointSymbolError {
    /// Nothing there.
    #[error("an empty point group symbol; write one such as `43`, `b(4)2` or `b(22)`")]
    Empty,
    /// A minus sign, which is another notation.
    #[error(
        "`-` at column {column}: a minus is the rotoinversion of International symbols; a bar \
         of a geometric symbol is written b(4) or with an overline"
    )]
    Minus {
        /// Where it stands.
        column: usize,
    },
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
    #[error("the symbol ends where {expected} should stand")]
    Unfinished {
        /// What is missing.
        expected: &'static str,
    },
    /// A third number.
    #[error(
        "a third number at column {column}: a symbol has p and q only; numbers of two digits go \
         in brackets, as in `(10)2`"
    )]
    TooMany {
        /// Where it begins.
        column: usize,
    },
    /// Bars in an order that names no generators.
    #[error("one bar over both numbers stands alone: `b(42)`")]
    Joined,
    /// The numbers have no roots.
    #[error(transparent)]
    Roots(#[from] RootsError),
}

impl PointSymbol {
    /// The symbol with these numbers and bars; `q` is not looked at where the bars say that there
    /// is no second number.
    ///
    /// # Errors
    /// [`RootsError`] when p and q have no roots.
    pub fn new(p: u32, q: u32, bars: Bars) -> Result<Self, RootsError> {
        // A single p is a group about c, at right angles to b as to a.
        let q = match bars {
            Bars::Single | Bars::BarredSingle => 2,
            _ => q,
        };
        Roots::new(p, q)?;
        Ok(Self { p, q, bars })
    }

    /// The first number.
    pub fn p(&self) -> u32 {
        self.p
    }

    /// The second number, where there is one.
    pub fn q(&self) -> Option<u32> {
        let single = matches!(self.bars, Bars::Single | Bars::BarredSingle);
        (!single).then_some(self.q)
    }

    /// Which roots are joined.
    pub fn bars(&self) -> Bars {
        self.bars
    }

    /// The roots; a group of one number takes q = 2.
    ///
    /// # Errors
    /// None for a symbol that was made by [`PointSymbol::new`] or parsed.
    pub fn roots(&self) -> Result<Roots, RootsError> {
        Roots::new(self.p, self.q)
    }

    /// The generators (Table 3.2).
    pub fn generators(&self) -> &'static [Word] {
        use Word::{A, Ab, Abc, B, Bc, C};
        match self.bars {
            Bars::Single if self.p == 1 => &[A],
            Bars::Single => &[A, B],
            Bars::BarredSingle => &[Ab],
            Bars::None => &[A, B, C],
            Bars::First => &[Ab, C],
            Bars::Second => &[A, Bc],
            Bars::Each => &[Ab, Bc],
            Bars::Both => &[Abc],
        }
    }

    /// The symbol with bars as they are printed: a combining overline after each barred number.
    /// One bar over both cannot be told from two in this form; there it stays `b(42)`.
    pub fn overlined(&self) -> String {
        let bar = |n: u32| format!("{}\u{305}", Number(n));
        let (p, q) = (Number(self.p), Number(self.q));
        match self.bars {
            Bars::BarredSingle => bar(self.p),
            Bars::First => format!("{}{q}", bar(self.p)),
            Bars::Second => format!("{p}{}", bar(self.q)),
            Bars::Each => format!("{}{}", bar(self.p), bar(self.q)),
            Bars::Single | Bars::None | Bars::Both => self.to_string(),
        }
    }
}

/// A number as a symbol has it: bare where one digit says it.
struct Number(u32);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            n @ 0..=9 => write!(f, "{n}"),
            n => write!(f, "({n})"),
        }
    }
}

impl fmt::Display for PointSymbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (p, q) = (Number(self.p), Number(self.q));
        match self.bars {
            Bars::Single => write!(f, "{p}"),
            Bars::BarredSingle => write!(f, "b({p})"),
            Bars::None => write!(f, "{p}{q}"),
            Bars::First => write!(f, "b({p}){q}"),
            Bars::Second => write!(f, "{p}b({q})"),
            Bars::Each => write!(f, "b({p})b({q})"),
            Bars::Both => write!(f, "b({p}{q})"),
        }
    }
}

impl FromStr for PointSymbol {
    type Err = PointSymbolError;

    fn from_str(text: &str) -> Result<Self, PointSymbolError> {
        let counts = |c: char| !c.is_whitespace() && c != '_';
        let mut reader = Reader(SymbolReader::new(text, counts));
        if reader.0.peek().is_none() {
            return Err(PointSymbolError::Empty);
        }
        let first = reader.factor()?;
        let Some((column, _)) = reader.0.peek() else {
            return Ok(match first {
                Factor::Bare(p) => Self::new(p, 2, Bars::Single)?,
                Factor::Barred(p) => Self::new(p, 2, Bars::BarredSingle)?,
                Factor::Joined(p, q) => Self::new(p, q, Bars::Both)?,
            });
        };
        if matches!(first, Factor::Joined(..)) {
            return Err(PointSymbolError::TooMany { column });
        }
        let second = reader.factor()?;
        if let Some((column, _)) = reader.0.peek() {
            return Err(PointSymbolError::TooMany { column });
        }
        Ok(match (first, second) {
            (Factor::Bare(p), Factor::Bare(q)) => Self::new(p, q, Bars::None)?,
            (Factor::Barred(p), Factor::Bare(q)) => Self::new(p, q, Bars::First)?,
            (Factor::Bare(p), Factor::Barred(q)) => Self::new(p, q, Bars::Second)?,
            (Factor::Barred(p), Factor::Barred(q)) => Self::new(p, q, Bars::Each)?,
            _ => return Err(PointSymbolError::Joined),
        })
    }
}

/// What stands between two places of a symbol where it could end.
enum Factor {
    Bare(u32),
    Barred(u32),
    Joined(u32, u32),
}

struct Reader(SymbolReader);

impl Reader {
    fn unexpected(&self, expected: &'static str) -> PointSymbolError {
        match self.0.peek() {
            None => PointSymbolError::Unfinished { expected },
            Some((column, '-' | '\u{2212}')) => PointSymbolError::Minus { column },
            Some((column, found)) => PointSymbolError::Unexpected {
                found,
                column,
                expected,
            },
        }
    }

    fn factor(&mut self) -> Result<Factor, PointSymbolError> {
        if self.0.take(|c| c == 'b') {
            if !self.0.take(|c| c == '(') {
                return Err(self.unexpected("`(` after `b`"));
            }
            let p = self.number()?;
            let joined = match self.0.peek() {
                Some((_, ')')) => None,
                _ => Some(self.number()?),
            };
            if !self.0.take(|c| c == ')') {
                return Err(self.unexpected("`)` after the barred numbers"));
            }
            return Ok(match joined {
                None => Factor::Barred(p),
                Some(q) => Factor::Joined(p, q),
            });
        }
        let number = self.number()?;
        let barred = self.0.take(|c| matches!(c, '\u{304}' | '\u{305}'));
        Ok(if barred {
            Factor::Barred(number)
        } else {
            Factor::Bare(number)
        })
    }

    /// One digit, or several in brackets.
    fn number(&mut self) -> Result<u32, PointSymbolError> {
        const EXPECTED: &str = "a number, `b(` or nothing goes there";
        if !self.0.take(|c| c == '(') {
            let digit = self.0.next_of(|c| c.to_digit(10));
            return digit.ok_or_else(|| self.unexpected(EXPECTED));
        }
        let value = self.0.digits();
        let value = value.ok_or_else(|| self.unexpected("digits in the brackets"))?;
        if self.0.take(|c| c == ')') {
            Ok(value)
        } else {
            Err(self.unexpected("`)` after the digits"))
        }
    }
}
