//! How the sums in `x-y, 1/2+x, z+.25` are read: the grammar of an affine map as text.
//!
//! ```text
//! map       = sum ("," sum ("," sum))
//! sum       = ["+" | "-"] term { ("+" | "-") term }
//! term      = number ["*"] axis ["/" integer] | axis ["/" integer] | number
//! number    = digits ["/" digits] | digits "." digits
//! axis      = "x" | "y" | "z"           in either case
//! ```
//! Blanks and quotation marks may stand anywhere.

use num_rational::Ratio;

use super::DENOMINATOR;
use super::triplet::OperationError;

/// Larger numbers are refused, so that sums of them cannot overflow.
const LARGEST_NUMBER: i64 = 100_000;

/// The most characters that a triplet may have.
const LONGEST: usize = 256;

/// An affine map with rational entries, as read: `x ↦ linear · x + shift`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// The matrix, row by row.
    pub linear: [[Ratio<i64>; 3]; 3],
    /// The translation, not reduced.
    pub shift: [Ratio<i64>; 3],
    /// The columns (from 1) in the text at which the three sums begin.
    pub columns: [usize; 3],
}

/// Reads an affine map.
pub fn affine(text: &str) -> Result<Affine, OperationError> {
    if text.len() > LONGEST {
        return Err(OperationError::TooLong { limit: LONGEST });
    }
    let zero = Ratio::from_integer(0);
    let mut map = Affine {
        linear: [[zero; 3]; 3],
        shift: [zero; 3],
        columns: [1; 3],
    };
    let mut cursor = Cursor {
        bytes: text.as_bytes(),
        at: 0,
    };
    for place in 0..3 {
        cursor.skip_blanks();
        map.columns[place] = cursor.column();
        sum(&mut cursor, &mut map.linear[place], &mut map.shift[place])?;
        match (cursor.peek(), place) {
            (Some(b','), 0 | 1) => cursor.at += 1,
            (None, 2) => {}
            (None, _) => {
                return Err(OperationError::TooFew {
                    found: place + 1,
                    column: cursor.column(),
                });
            }
            (Some(b','), _) => {
                return Err(OperationError::TooMany {
                    column: cursor.column(),
                });
            }
            (Some(_), _) => return Err(cursor.unexpected()),
        }
    }
    Ok(map)
}

fn sum(
    cursor: &mut Cursor<'_>,
    row: &mut [Ratio<i64>; 3],
    shift: &mut Ratio<i64>,
) -> Result<(), OperationError> {
    let mut terms = 0;
    loop {
        let sign = match cursor.peek() {
            Some(b'+') => 1,
            Some(b'-') => -1,
            None | Some(b',') if terms > 0 => return Ok(()),
            Some(_) if terms == 0 => 0,
            _ => return Err(cursor.unexpected()),
        };
        if sign != 0 {
            cursor.at += 1;
        }
        let sign = Ratio::from_integer(if sign < 0 { -1 } else { 1 });
        term(cursor, sign, row, shift)?;
        terms += 1;
        if terms > 16 {
            return Err(OperationError::TooLong { limit: LONGEST });
        }
    }
}

fn term(
    cursor: &mut Cursor<'_>,
    sign: Ratio<i64>,
    row: &mut [Ratio<i64>; 3],
    shift: &mut Ratio<i64>,
) -> Result<(), OperationError> {
    let starts_with_digit =
        matches!(cursor.peek(), Some(byte) if byte.is_ascii_digit() || byte == b'.');
    let mut value = if starts_with_digit {
        number(cursor)?
    } else {
        Ratio::from_integer(1)
    };
    if starts_with_digit && cursor.peek() == Some(b'*') {
        cursor.at += 1;
    } else if starts_with_digit && cursor.axis().is_none() {
        *shift += sign * value;
        return Ok(());
    }
    let Some(axis) = cursor.axis() else {
        return Err(cursor.unexpected());
    };
    cursor.at += 1;
    if cursor.peek() == Some(b'/') {
        cursor.at += 1;
        value /= Ratio::from_integer(divisor(cursor)?);
    }
    row[axis] += sign * value;
    Ok(())
}

fn divisor(cursor: &mut Cursor<'_>) -> Result<i64, OperationError> {
    cursor.skip_blanks();
    let column = cursor.column();
    let (value, digits) = cursor.digits(column)?;
    match (value, digits) {
        (_, 0) => Err(cursor.unexpected()),
        (0, _) => Err(OperationError::DivisionByZero { column }),
        // Common denominators keep sums of many fractions small.
        (value, _) if i64::from(DENOMINATOR) % value != 0 => {
            Err(OperationError::NotRational { column })
        }
        (value, _) => Ok(value),
    }
}

/// A fraction is exact. A decimal stands for the simplest fraction with a denominator that
/// divides 24 that lies within one unit of its last digit, since `.333` and `.667` are how files
/// spell thirds.
fn number(cursor: &mut Cursor<'_>) -> Result<Ratio<i64>, OperationError> {
    cursor.skip_blanks();
    let column = cursor.column();
    let (whole, whole_digits) = cursor.digits(column)?;
    if cursor.bytes.get(cursor.at) == Some(&b'.') {
        cursor.at += 1;
        let start = cursor.at;
        while cursor.bytes.get(cursor.at).is_some_and(u8::is_ascii_digit) {
            cursor.at += 1;
        }
        let digits = &cursor.bytes[start..cursor.at];
        if digits.is_empty() && whole_digits == 0 {
            return Err(cursor.unexpected());
        }
        let fraction = snapped(digits).ok_or(OperationError::NotRational { column })?;
        return Ok(Ratio::from_integer(whole) + fraction);
    }
    if cursor.peek() == Some(b'/') {
        cursor.at += 1;
        let below = divisor(cursor)?;
        return Ok(Ratio::new(whole, below));
    }
    Ok(Ratio::from_integer(whole))
}

/// The fraction meant by the digits after a decimal point.
fn snapped(digits: &[u8]) -> Option<Ratio<i64>> {
    let mut value = 0.0;
    let mut unit = 1.0;
    for digit in digits.iter().take(15) {
        unit /= 10.0;
        value += f64::from(digit - b'0') * unit;
    }
    let near = |tolerance: f64| {
        move |below: &i64| {
            let above = (value * *below as f64).round();
            let close = (above / *below as f64 - value).abs() < tolerance;
            close.then(|| Ratio::new(above as i64, *below))
        }
    };
    let exact = [1, 2, 3, 4, 6, 8, 12, 24, 5].iter().find_map(near(1e-9));
    // Two digits suffice for thirds; with one digit only exact values are meant.
    let rounded = || {
        [1, 2, 3, 4, 6, 8, 12, 24]
            .iter()
            .find_map(near(unit * 0.999))
    };
    exact.or_else(|| if digits.len() < 2 { None } else { rounded() })
}

struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Cursor<'_> {
    fn skip_blanks(&mut self) {
        while self
            .bytes
            .get(self.at)
            .is_some_and(|byte| byte.is_ascii_whitespace() || matches!(byte, b'\'' | b'"' | b'_'))
        {
            self.at += 1;
        }
    }

    fn peek(&mut self) -> Option<u8> {
        self.skip_blanks();
        self.bytes.get(self.at).copied()
    }

    fn axis(&mut self) -> Option<usize> {
        match self.peek()? {
            b'x' | b'X' => Some(0),
            b'y' | b'Y' => Some(1),
            b'z' | b'Z' => Some(2),
            _ => None,
        }
    }

    /// A run of digits and its length; `(0, 0)` when none stands here.
    fn digits(&mut self, column: usize) -> Result<(i64, usize), OperationError> {
        let start = self.at;
        let mut value: i64 = 0;
        while let Some(byte) = self.bytes.get(self.at).filter(|byte| byte.is_ascii_digit()) {
            value = value * 10 + i64::from(byte - b'0');
            if value > LARGEST_NUMBER {
                return Err(OperationError::TooLarge { column });
            }
            self.at += 1;
        }
        Ok((value, self.at - start))
    }

    fn column(&self) -> usize {
        self.at + 1
    }

    fn unexpected(&mut self) -> OperationError {
        match self.peek() {
            Some(byte) => OperationError::Unexpected {
                found: printable(byte),
                column: self.column(),
            },
            None => OperationError::EndsEarly {
                column: self.column(),
            },
        }
    }
}

/// A byte that can stand in a message.
fn printable(byte: u8) -> char {
    if byte.is_ascii_graphic() {
        char::from(byte)
    } else {
        char::REPLACEMENT_CHARACTER
    }
}
