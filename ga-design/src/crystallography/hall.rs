//! How a Hall symbol becomes operations: S. R. Hall, *Acta Cryst.* A37 (1981) 517–525.
//!
//! ```text
//! symbol      = ["-"] lattice { rotation } [ change ]
//! lattice     = P | A | B | C | I | R | H | S | T | F
//! rotation    = ["-"] order [screw] [axis] { translation }
//! order       = 1 | 2 | 3 | 4 | 6             screw = a digit below the order
//! axis        = x | y | z | ' | " | *         translation = a b c n u v w d
//! change      = "(" twelfths twelfths twelfths ")"  |  "(" sum "," sum "," sum ")"
//! ```
//! An omitted axis is z for the first rotation; for the second x after an order of 2 or 4 and
//! a − b after 3 or 6; for a threefold rotation in second or third place the body diagonal.
//! The change of basis `V` carries old coordinates to new ones: operations become `V S V⁻¹`.

mod change_of_basis;
mod rotation;

use super::closure::{ClosureError, close};
use super::operation::{DENOMINATOR, Operation, OperationError};
use rotation::Rotation;

/// The most characters that a Hall symbol may have.
const LONGEST: usize = 200;

/// Why a text is no Hall symbol. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HallError {
    /// Nothing there, or far too much.
    #[error("a Hall symbol has between 1 and {LONGEST} characters, such as `-P 2ybc`")]
    Length,
    /// The lattice letter is missing or unknown.
    #[error(
        "`{found}` at column {column} is no lattice letter; one of P A B C I R H S T F goes first"
    )]
    Lattice {
        /// What stands there.
        found: char,
        /// Its column.
        column: usize,
    },
    /// A character that cannot stand there.
    #[error("unexpected `{found}` at column {column} of the Hall symbol")]
    Unexpected {
        /// What stands there.
        found: char,
        /// Its column.
        column: usize,
    },
    /// The axis of a rotation can neither be read nor inferred.
    #[error("the rotation at column {column} needs an axis: one of x y z ' \" *")]
    Axis {
        /// The column of the rotation.
        column: usize,
    },
    /// More rotations than a symbol has.
    #[error("a fifth rotation at column {column}; a Hall symbol has at most four")]
    TooMany {
        /// The column of the rotation.
        column: usize,
    },
    /// The change of basis cannot be read.
    #[error("the change of basis at column {column}: {reason}")]
    Change {
        /// The column of the bracket.
        column: usize,
        /// What is wrong.
        reason: ChangeError,
    },
    /// The generators make no group.
    #[error(transparent)]
    Closure(#[from] ClosureError),
}

/// What is wrong with a change of basis.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ChangeError {
    /// No closing bracket, or something behind it.
    #[error("it must end the symbol with `)`")]
    Bracket,
    /// Neither three integers nor a triplet.
    #[error("write three whole twelfths such as (0 0 1), or a triplet such as (x-y,x+y,z)")]
    Form,
    /// The triplet cannot be read.
    #[error(transparent)]
    Triplet(#[from] OperationError),
    /// It cannot be undone, or its numbers are beyond any crystal.
    #[error("it has no inverse, or numbers beyond 12 or finer than twelfths")]
    Singular,
    /// It makes operations that are not integer matrices.
    #[error("it does not carry the lattice of this group to a lattice of integer operations")]
    NotIntegral,
}

/// All operations of the group that a Hall symbol describes, modulo the lattice; the identity
/// comes first.
///
/// ```
/// use ga_design::crystallography::hall;
///
/// assert_eq!(hall::operations("P 32 2\"")?.len(), 6);
/// assert_eq!(hall::operations("-F 4vw 2vw 3")?.len(), 192);
/// # Ok::<(), ga_design::crystallography::HallError>(())
/// ```
pub fn operations(symbol: &str) -> Result<Vec<Operation>, HallError> {
    let bytes = symbol.as_bytes();
    if bytes.is_empty() || bytes.len() > LONGEST {
        return Err(HallError::Length);
    }
    let (main, change) = match bytes.iter().position(|byte| *byte == b'(') {
        Some(open) => {
            let change =
                change_of_basis::read(bytes.get(open..).unwrap_or_default()).map_err(|reason| {
                    HallError::Change {
                        column: open + 1,
                        reason,
                    }
                })?;
            (
                bytes.get(..open).unwrap_or_default(),
                Some((change, open + 1)),
            )
        }
        None => (bytes, None),
    };
    let mut generators = generators(main)?;
    if let Some((change, column)) = change {
        generators = change_of_basis::carry(&change, &generators)
            .map_err(|reason| HallError::Change { column, reason })?;
    }
    Ok(close(&generators)?)
}

/// The generators named before any change of basis.
fn generators(bytes: &[u8]) -> Result<Vec<Operation>, HallError> {
    let mut at = 0;
    skip_blanks(bytes, &mut at);
    let centric = bytes.get(at) == Some(&b'-');
    if centric {
        at += 1;
        skip_blanks(bytes, &mut at);
    }
    let letter = bytes.get(at).copied();
    let mut generators = letter
        .and_then(centring)
        .ok_or_else(|| HallError::Lattice {
            found: shown(letter),
            column: at + 1,
        })?;
    at += 1;
    if centric {
        generators.extend(rotation::inversion());
    }
    let mut rotations: Vec<Rotation> = Vec::new();
    loop {
        skip_blanks(bytes, &mut at);
        if at >= bytes.len() {
            return Ok(generators);
        }
        if rotations.len() >= 4 {
            return Err(HallError::TooMany { column: at + 1 });
        }
        let next = Rotation::read(bytes, &mut at, rotations.len(), rotations.last())?;
        generators.extend(next.operation());
        rotations.push(next);
    }
}

/// The centring translations of a lattice letter, as operations.
fn centring(letter: u8) -> Option<Vec<Operation>> {
    const HALF: i32 = DENOMINATOR / 2;
    const THIRD: i32 = DENOMINATOR / 3;
    const THIRDS: i32 = 2 * THIRD;
    let vectors: &[[i32; 3]] = match letter.to_ascii_uppercase() {
        b'P' => &[],
        b'A' => &[[0, HALF, HALF]],
        b'B' => &[[HALF, 0, HALF]],
        b'C' => &[[HALF, HALF, 0]],
        b'I' => &[[HALF, HALF, HALF]],
        b'R' => &[[THIRDS, THIRD, THIRD], [THIRD, THIRDS, THIRDS]],
        b'S' => &[[THIRD, THIRD, THIRDS], [THIRDS, THIRDS, THIRD]],
        b'T' => &[[THIRD, THIRDS, THIRD], [THIRDS, THIRD, THIRDS]],
        b'H' => &[[THIRDS, THIRD, 0], [THIRD, THIRDS, 0]],
        b'F' => &[[0, HALF, HALF], [HALF, 0, HALF], [HALF, HALF, 0]],
        _ => return None,
    };
    let identity = Operation::IDENTITY.rotation();
    vectors
        .iter()
        .map(|vector| Operation::from_units(identity, *vector))
        .collect()
}

/// Files write underscores for blanks.
fn skip_blanks(bytes: &[u8], at: &mut usize) {
    while bytes
        .get(*at)
        .is_some_and(|byte| byte.is_ascii_whitespace() || *byte == b'_')
    {
        *at += 1;
    }
}

/// A byte, or its absence, that can stand in a message.
fn shown(byte: Option<u8>) -> char {
    match byte {
        Some(byte) if byte.is_ascii_graphic() => char::from(byte),
        Some(_) => char::REPLACEMENT_CHARACTER,
        None => ' ',
    }
}
