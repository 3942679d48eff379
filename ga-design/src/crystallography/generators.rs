//! How the 230 space groups grow from three roots and a lattice: which generators each has, and
//! what its geometric symbol is.
//!
//! The table is `data/space_group_generators.tsv`. Each group is given by a point group in the
//! notation of Hestenes and Holt, a lattice, the direction of the lattice along which each root
//! lies, and its generators: words in the roots joined with translations (3.3.2). Reflections,
//! rotors and translators are versors; their products modulo the lattice are the group. No table
//! of operations is read on the way.
//!
//! ```text
//! p, q ──► Roots ┐
//! Cell ──► edges ┴► generators as versors ──► closure modulo the lattice ──► operations
//!                       ▲
//!           `T_c^{1/4} ab`, origin shift, change of basis of the setting
//! ```

mod expression;
mod generate;
mod generation;
mod root_direction;
mod symbol;

pub use expression::{ExpressionError, GeneratorExpression};
pub use generate::GenerationError;
pub use generation::Generation;
pub use root_direction::{DirectionError, RootDirection};
pub use symbol::{GeometricSymbol, GeometricSymbolError, Mark};

use std::sync::LazyLock;

use num_rational::Ratio;

use super::SpaceGroup;
use super::lattice::Centring;
use super::operation::affine;

const TABLE: &str = include_str!("../../data/space_group_generators.tsv");

/// How one of the 230 space groups is generated in its standard setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpaceGroupGenerators {
    /// The number in *International Tables*, 1 to 230.
    pub number: u32,
    /// The standard setting, in whose cell all of this is said.
    pub standard: &'static SpaceGroup,
    /// The geometric symbol of the group, with that of its point group.
    pub symbol: GeometricSymbol,
    /// The lattice of the standard cell.
    pub centring: Centring,
    /// Along which direction of the lattice **a**, **b** and **c** lie.
    pub roots: [RootDirection; 3],
    /// Where the common point of the roots lies, in fractions of the edges of the standard cell.
    pub origin: [Ratio<i32>; 3],
    /// The generators, each in terms of the roots at their common point; with the lattice
    /// translations they generate the group.
    pub generators: Vec<GeneratorExpression>,
}

impl SpaceGroupGenerators {
    /// All 230, by number.
    pub fn table() -> &'static [Self] {
        &GENERATORS
    }

    /// The generators of a space group by its number in *International Tables*, 1 to 230.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroupGenerators;
    ///
    /// let group = SpaceGroupGenerators::of(76).unwrap();
    /// assert_eq!(group.symbol.to_string(), "P b(4)_1");
    /// assert_eq!(group.generators[0].to_string(), "T_c^{1/4} ab");
    /// ```
    pub fn of(number: u32) -> Option<&'static Self> {
        Self::table().iter().find(|group| group.number == number)
    }

    /// The group of a geometric symbol such as `P b(4)_1 b(2)` or `P 4̅₁2̅`.
    ///
    /// Blanks do not count, and the primes of moved generators may be left out where no other
    /// group is meant then.
    ///
    /// # Errors
    /// [`GeometricSymbolError`]: no such symbol, with the nearest known ones.
    pub fn from_symbol(symbol: &str) -> Result<&'static Self, GeometricSymbolError> {
        symbol::find(symbol)
    }
}

static GENERATORS: LazyLock<Vec<SpaceGroupGenerators>> =
    LazyLock::new(|| TABLE.lines().skip(1).filter_map(row).collect());

fn row(line: &str) -> Option<SpaceGroupGenerators> {
    let mut fields = line.split('\t');
    let number = fields.next()?.parse().ok()?;
    let standard = SpaceGroup::standard(number)?;
    let symbol = fields.next()?.parse().ok()?;
    let centring = Centring::from_letter(fields.next()?.chars().next()?)?;
    let mut direction = || fields.next()?.parse().ok();
    let roots = [direction()?, direction()?, direction()?];
    let origin = fractions(fields.next()?)?;
    let generators = fields.next()?.split("; ").map(str::parse);
    Some(SpaceGroupGenerators {
        number,
        standard,
        symbol,
        centring,
        roots,
        origin,
        generators: generators.collect::<Result<_, _>>().ok()?,
    })
}

fn fractions(text: &str) -> Option<[Ratio<i32>; 3]> {
    let shift = affine(text).ok()?.shift;
    let mut narrow = [Ratio::from_integer(0); 3];
    for (part, wide) in narrow.iter_mut().zip(shift) {
        let numerator = i32::try_from(*wide.numer()).ok()?;
        *part = Ratio::new(numerator, i32::try_from(*wide.denom()).ok()?);
    }
    Some(narrow)
}
