//! What can be wrong with a CIF file, and what each message advises.

use super::super::cell::CellError;
use super::super::closure::ClosureError;
use super::super::hall::HallError;
use super::super::operation::OperationError;
use super::super::placement::PlacementError;
use super::super::symbols::UnknownSymbol;

/// What is wrong with a file, and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The operating system refused.
    #[error("cannot be read: {reason}")]
    Unreadable {
        /// The reason given.
        reason: String,
    },
    /// Zero bytes.
    #[error("not a CIF text file (it holds zero bytes); save it as plain text in UTF-8")]
    Binary,
    /// Nothing in it.
    #[error("the file is empty; a CIF file begins with a line such as `data_quartz`")]
    Empty,
    /// Does not begin as CIF files do.
    #[error("not a CIF file: `{found}` stands where a line such as `data_quartz` should begin it")]
    NotCif {
        /// The first word.
        found: String,
    },
    /// A quotation that does not end.
    #[error("a quoted value is cut off: the closing {quote} is missing on this line")]
    OpenQuote {
        /// The quotation mark.
        quote: char,
    },
    /// A text field that does not end.
    #[error("a text field begins here and is cut off: no line that begins with `;` closes it")]
    OpenText,
    /// A quotation in three marks that does not end.
    #[error("a text in triple quotation marks begins here and is cut off: they do not close")]
    OpenTriple,
    /// A list or table that does not end.
    #[error("a list or table begins here and is cut off: the closing bracket is missing")]
    OpenList,
    /// A save frame that does not end.
    #[error("a save frame begins here and is cut off: the closing `save_` is missing")]
    OpenFrame,
    /// A name without value at the end.
    #[error("the file is cut off: the data name `{tag}` has no value")]
    NoValue {
        /// The data name.
        tag: String,
    },
    /// A loop with values missing.
    #[error(
        "the loop of `{tag}` is cut off: {values} values do not fill rows of {columns}; \
         {missing} more would complete the last row"
    )]
    Ragged {
        /// The first data name of the loop.
        tag: String,
        /// The number of data names.
        columns: usize,
        /// The number of values.
        values: usize,
        /// How many values are missing in the last row.
        missing: usize,
    },
    /// More of something than any crystal has.
    #[error("too large: more than {limit} {what}")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// The limit.
        limit: usize,
    },
    /// No block has a cell.
    #[error("no unit cell: add `_cell_length_a` and the other cell parameters")]
    NoCell,
    /// A cell parameter is missing.
    #[error("the unit cell is incomplete: `{tag}` has no value")]
    MissingCell {
        /// The data name.
        tag: &'static str,
    },
    /// The cell is impossible.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// Not a number where one must stand.
    #[error("`{tag}` is `{found}`; it must be a finite number such as 0.25 or 1.234(5)")]
    NotANumber {
        /// The data name.
        tag: String,
        /// The value found.
        found: String,
    },
    /// A coordinate beyond any use.
    #[error("`{tag}` is {found}; fractional coordinates lie between -1000 and 1000")]
    FarAway {
        /// The data name.
        tag: String,
        /// The value found.
        found: f64,
    },
    /// A negative occupancy.
    #[error("`{tag}` is {found}; an occupancy lies between 0 and 1")]
    Occupancy {
        /// The data name.
        tag: String,
        /// The value found.
        found: f64,
    },
    /// Nothing says what the symmetry is.
    #[error(
        "no symmetry: add the operations (`_space_group_symop_operation_xyz`), the symbol \
         (`_space_group_name_H-M_alt`, `_space_group_name_Hall`) or the number \
         (`_space_group_IT_number`) of the space group"
    )]
    NoSymmetry,
    /// A magnetic structure.
    #[error(
        "a magnetic structure: its operations also reverse time, and they are not read; add those of \
         the structure without moments (`_space_group_symop_operation_xyz`), or its symbol"
    )]
    Magnetic,
    /// A modulated structure.
    #[error(
        "a modulated structure: its symmetry is that of more than three dimensions and is not read; \
         add that of the average structure (`_space_group_symop_operation_xyz`)"
    )]
    Modulated,
    /// An operation that cannot be read.
    #[error("the symmetry operation `{text}` is wrong: {reason}")]
    Operation {
        /// The operation as written.
        text: String,
        /// What is wrong with it.
        reason: OperationError,
    },
    /// The operations make no group.
    #[error(transparent)]
    Closure(#[from] ClosureError),
    /// An unknown Hermann–Mauguin symbol.
    #[error(transparent)]
    Symbol(#[from] UnknownSymbol),
    /// A Hall symbol that cannot be read.
    #[error("the Hall symbol `{text}` is wrong: {reason}")]
    Hall {
        /// The symbol as written.
        text: String,
        /// What is wrong with it.
        reason: HallError,
    },
    /// A number that no space group has.
    #[error("there is no space group number {found}; the numbers run from 1 to 230")]
    Number {
        /// The value as written.
        found: String,
    },
    /// The cell contradicts the symmetry.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// No atoms.
    #[error(
        "no atom sites with coordinates: add a loop with `_atom_site_label` and \
         `_atom_site_fract_x`, `_y`, `_z`"
    )]
    NoSites,
    /// Coordinates for only some of the axes.
    #[error("the atom sites lack `{tag}`")]
    MissingCoordinate {
        /// The data name.
        tag: String,
    },
}
