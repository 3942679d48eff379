//! Which cells of the lattice are built: `2x2x2`, `-1:1` and their like.

use std::num::IntErrorKind;
use std::str::FromStr;

/// The farthest cell from the origin that a range may reach.
pub const FARTHEST: i32 = 100_000;

/// A block of unit cells: from the corner `low` to the corner `high`, in cell edges, `high`
/// excluded.
///
/// ```
/// use ga_design::crystallography::CellRange;
///
/// let block: CellRange = "2x2x3".parse()?;
/// assert_eq!(block.count(), 12);
/// let around: CellRange = "-1:1x-1:1x0:1".parse()?;
/// assert_eq!((around.low, around.high), ([-1, -1, 0], [1, 1, 1]));
/// # Ok::<(), ga_design::crystallography::CellRangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellRange {
    /// The first cell along each edge.
    pub low: [i32; 3],
    /// The cell after the last along each edge.
    pub high: [i32; 3],
}

/// Why a text is no range of cells.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CellRangeError {
    /// Not of the form.
    #[error(
        "`{text}` is no range of cells; write one such as 2x2x2, or -1:1x-1:1x0:1 from corner to corner"
    )]
    Form {
        /// The text, shortened when long.
        text: String,
    },
    /// A range without cells.
    #[error(
        "the range {low}:{high} holds no cell; the second number must be larger than the first"
    )]
    Empty {
        /// The first cell.
        low: i32,
        /// The cell after the last.
        high: i32,
    },
    /// Farther than any picture needs.
    #[error("the range reaches beyond {FARTHEST} cells from the origin")]
    TooFar,
}

impl CellRange {
    /// The one cell at the origin.
    pub const UNIT: Self = Self {
        low: [0; 3],
        high: [1; 3],
    };

    /// The number of cells.
    pub fn count(&self) -> u64 {
        // Three factors of at most 200000 each cannot overflow for a range that was parsed, but
        // the fields are open.
        self.low
            .iter()
            .zip(self.high)
            .fold(1, |count, (low, high)| {
                let along = u64::try_from(i64::from(high) - i64::from(*low)).unwrap_or(0);
                u64::saturating_mul(count, along)
            })
    }

    /// The offsets of the cells in whole edges, the third index running fastest.
    pub fn offsets(&self) -> impl Iterator<Item = [i32; 3]> + use<> {
        let Self { low, high } = *self;
        (low[0]..high[0]).flat_map(move |i| {
            (low[1]..high[1]).flat_map(move |j| (low[2]..high[2]).map(move |k| [i, j, k]))
        })
    }
}

impl Default for CellRange {
    fn default() -> Self {
        Self::UNIT
    }
}

/// One part for all three edges or one for each, parted by `x`, `×` or `,`; a part is a number of
/// cells or `first:last` corner.
impl FromStr for CellRange {
    type Err = CellRangeError;

    fn from_str(text: &str) -> Result<Self, CellRangeError> {
        let form = || CellRangeError::Form {
            text: text.chars().take(40).collect(),
        };
        let parts: Vec<&str> = text.split(['x', 'X', '×', ',']).map(str::trim).collect();
        let parts: [&str; 3] = match parts.as_slice() {
            [all] => [all, all, all],
            [a, b, c] => [a, b, c],
            _ => return Err(form()),
        };
        let mut range = Self::UNIT;
        for (i, part) in parts.into_iter().enumerate() {
            let number = |word: &str| {
                word.trim()
                    .parse::<i64>()
                    .map_err(|error| match error.kind() {
                        IntErrorKind::PosOverflow | IntErrorKind::NegOverflow => {
                            CellRangeError::TooFar
                        }
                        _ => form(),
                    })
            };
            let (low, high) = match part.split_once(':') {
                Some((low, high)) => (number(low)?, number(high)?),
                None => (0, number(part)?),
            };
            let near = |value: i64| {
                i32::try_from(value)
                    .ok()
                    .filter(|value| value.abs() <= FARTHEST)
                    .ok_or(CellRangeError::TooFar)
            };
            let (low, high) = (near(low)?, near(high)?);
            if low >= high {
                return Err(CellRangeError::Empty { low, high });
            }
            range.low[i] = low;
            range.high[i] = high;
        }
        Ok(range)
    }
}
