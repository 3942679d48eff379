//! How the geometric symbol of a space group is written, read and found.
//!
//! ```text
//! symbol = lattice mark factor mark [ factor mark ]        `P b(4)_1 b(2)`, `C_c 4 b(2)_1`
//! mark   = [ "_" subscript ] [ "'" ]
//! ```
//! The factors are those of the point group. Each generator leaves a mark where it is not just
//! the word of its roots: a glide the letter of International symbols (a, b, c, n, d), a screw
//! the digit of its rise, with the hand that International symbols count. The marks of **ab** and
//! **b** stand after the first number, those of **bc** and **c** after the second, and that of
//! **a** after the lattice letter, where **a** is a generator of its own. A prime says that the
//! axis has been moved off the common point of the roots: `P b(2)_1 b(2)_1'` is `P 21 21 21`.
//!
//! The lattice letter is that of the cell with **a** along an edge: where the roots of a
//! tetragonal group lie along the diagonals of the standard cell, C stands for P and F for I, and
//! in a trigonal or hexagonal one H for P. So `P 4 b(2)` is `P -4 m 2`, and `C 4 b(2)` is
//! `P -4 2 m`, which on those axes is `C -4 m 2`. Glides are named by the standard cell.

use std::fmt;
use std::str::FromStr;

use super::super::{PointSymbol, PointSymbolError};
use super::SpaceGroupGenerators;

const LATTICES: [char; 8] = ['P', 'A', 'B', 'C', 'I', 'F', 'R', 'H'];

/// What a generator leaves on the symbol.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Mark {
    /// The glide letter or the digit of the screw.
    pub subscript: Option<char>,
    /// Whether the generator has been moved off the common point of the roots.
    pub moved: bool,
}

/// The geometric symbol of a space group.
///
/// ```
/// use ga_design::crystallography::GeometricSymbol;
///
/// let symbol: GeometricSymbol = "Pb(4)_1b(2)".parse()?;
/// assert_eq!(symbol.to_string(), "P b(4)_1 b(2)");
/// assert_eq!("P4̅₁2̅".parse(), Ok(symbol));
/// # Ok::<(), ga_design::crystallography::GeometricSymbolError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GeometricSymbol {
    /// The letter of the lattice.
    pub lattice: char,
    /// The symbol of the point group.
    pub point: PointSymbol,
    /// The marks after the lattice letter, the first and the second factor.
    pub marks: [Mark; 3],
}

/// Why a text is no geometric symbol of a space group.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GeometricSymbolError {
    /// It does not begin with a lattice.
    #[error("a geometric symbol begins with its lattice, one of P A B C I F R H, not with `{0}`")]
    Lattice(String),
    /// A subscript that no generator has.
    #[error("a subscript at column {column} is a glide a, b, c, n, d or a screw 1 to 5")]
    Subscript {
        /// Where it stands.
        column: usize,
    },
    /// A second mark on one place.
    #[error("a second mark on one factor at column {column}")]
    Marks {
        /// Where it stands.
        column: usize,
    },
    /// The point group cannot be read.
    #[error("the point group: {0}")]
    Point(#[from] PointSymbolError),
    /// No space group has the symbol.
    #[error("no space group has the geometric symbol `{symbol}`; did you mean `{}`?", suggestions.join("`, `"))]
    Unknown {
        /// The symbol.
        symbol: GeometricSymbol,
        /// The known symbols that look most like it, best first.
        suggestions: Vec<String>,
    },
}

impl fmt::Display for GeometricSymbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mark = |f: &mut fmt::Formatter<'_>, mark: Mark| {
            if let Some(subscript) = mark.subscript {
                write!(f, "_{subscript}")?;
            }
            f.write_str(if mark.moved { "'" } else { "" })
        };
        let [lattice, first, second] = self.marks;
        write!(f, "{}", self.lattice)?;
        mark(f, lattice)?;
        let point = self.point.to_string();
        let split = end_of_first(&point);
        let (one, other) = point.split_at_checked(split).unwrap_or((&point, ""));
        write!(f, " {one}")?;
        mark(f, first)?;
        if !other.is_empty() {
            write!(f, " {other}")?;
            mark(f, second)?;
        }
        Ok(())
    }
}

/// Where the first factor of a point group symbol ends, in bytes.
fn end_of_first(point: &str) -> usize {
    let mut depth = 0;
    for (at, c) in point.char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 && (c.is_ascii_digit() || c == ')') {
            return at + c.len_utf8();
        }
    }
    point.len()
}

impl FromStr for GeometricSymbol {
    type Err = GeometricSymbolError;

    fn from_str(text: &str) -> Result<Self, GeometricSymbolError> {
        let mut chars = text
            .chars()
            .enumerate()
            .map(|(at, c)| (at + 1, c))
            .filter(|(_, c)| !c.is_whitespace() && !matches!(c, '{' | '}'))
            .peekable();
        let lattice = chars
            .next()
            .map(|(_, c)| c.to_ascii_uppercase())
            .filter(|c| LATTICES.contains(c))
            .ok_or_else(|| GeometricSymbolError::Lattice(text.chars().take(1).collect()))?;
        let mut point = String::new();
        let mut marks = [Mark::default(); 3];
        let (mut factors, mut depth) = (0_usize, 0);
        while let Some((column, c)) = chars.next() {
            let subscript = match (c, subscript_digit(c)) {
                ('_', _) => Some(chars.next().map(|(_, c)| c)),
                (_, Some(digit)) => Some(Some(digit)),
                _ => None,
            };
            if subscript.is_some() || matches!(c, '\'' | '\u{2032}') {
                let mark = marks
                    .get_mut(factors)
                    .ok_or(GeometricSymbolError::Marks { column })?;
                match subscript {
                    Some(_) if mark.subscript.is_some() || mark.moved => {
                        return Err(GeometricSymbolError::Marks { column });
                    }
                    Some(Some(c @ ('a'..='d' | 'n' | '1'..='5'))) => mark.subscript = Some(c),
                    Some(_) => return Err(GeometricSymbolError::Subscript { column }),
                    None if mark.moved => return Err(GeometricSymbolError::Marks { column }),
                    None => mark.moved = true,
                }
                continue;
            }
            depth += i32::from(c == '(') - i32::from(c == ')');
            let ends = depth == 0 && (c.is_ascii_digit() || c == ')');
            factors += usize::from(ends);
            // More text than any symbol has is refused where the point group is read.
            if point.len() < 64 {
                point.push(c);
            }
        }
        Ok(Self {
            lattice,
            point: point.parse()?,
            marks,
        })
    }
}

/// The digit of a subscript character.
fn subscript_digit(c: char) -> Option<char> {
    let digit = u32::from(c).checked_sub(0x2080)?;
    char::from_digit(digit, 10)
}

/// The group of a symbol: exactly, or without the primes if that is one group.
pub(super) fn find(text: &str) -> Result<&'static SpaceGroupGenerators, GeometricSymbolError> {
    let symbol: GeometricSymbol = text.parse()?;
    let table = SpaceGroupGenerators::table();
    if let Some(exact) = table.iter().find(|group| group.symbol == symbol) {
        return Ok(exact);
    }
    let unprimed = |mut symbol: GeometricSymbol| {
        for mark in &mut symbol.marks {
            mark.moved = false;
        }
        symbol
    };
    let unmoved = unprimed(symbol) == symbol;
    let mut alike = table
        .iter()
        .filter(|group| unmoved && unprimed(group.symbol) == symbol);
    if let (Some(group), None) = (alike.next(), alike.next()) {
        return Ok(group);
    }
    let wanted = symbol.to_string();
    let mut ranked: Vec<(usize, String)> = table
        .iter()
        .map(|group| group.symbol.to_string())
        .map(|name| (strsim::osa_distance(&wanted, &name), name))
        .collect();
    ranked.sort_by_key(|(distance, _)| *distance);
    Err(GeometricSymbolError::Unknown {
        symbol,
        suggestions: ranked.into_iter().take(3).map(|(_, name)| name).collect(),
    })
}
