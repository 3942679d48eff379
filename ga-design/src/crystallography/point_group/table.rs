//! Which 32 point groups crystals have, and how each is called in three notations.

use std::sync::LazyLock;

use super::super::lattice::CrystalSystem;
use super::classes::Census;
use super::{PointGroup, PointSymbol};

const TABLE: &str = include_str!("../../../data/point_groups.tsv");

/// One of the 32 crystal classes: a point group that maps a lattice to itself.
#[derive(Debug)]
pub struct CrystalClass {
    /// The International (Hermann–Mauguin) symbol, such as `-42m`.
    pub international: &'static str,
    /// The Schoenflies symbol, such as `D2d`.
    pub schoenflies: &'static str,
    /// The geometric symbol, such as `4b(2)`.
    pub geometric: &'static str,
    /// The crystal system.
    pub system: CrystalSystem,
    /// The International symbol of the Laue class: the group with the inversion added.
    pub laue: &'static str,
    /// Other International spellings: full symbols and other settings.
    also: Vec<&'static str>,
    group: PointGroup,
    census: Census,
}

/// A text that names no crystallographic point group in the notation asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {notation} point group symbol `{symbol}`; did you mean `{}`?", suggestions.join("`, `"))]
pub struct UnknownPointGroup {
    /// `International` or `Schoenflies`.
    pub notation: &'static str,
    /// The symbol as given, shortened when very long.
    pub symbol: String,
    /// The known symbols that look most like it, best first.
    pub suggestions: Vec<&'static str>,
}

impl CrystalClass {
    /// All 32, in the order of *International Tables* A, table 3.2.1.3.
    pub fn table() -> &'static [Self] {
        &CLASSES
    }

    /// The class of an International symbol; blanks, underscores and case do not count.
    ///
    /// # Errors
    /// [`UnknownPointGroup`] with the nearest known symbols.
    pub fn from_international(symbol: &str) -> Result<&'static Self, UnknownPointGroup> {
        let wanted = folded(symbol).replace('\u{2212}', "-");
        Self::table()
            .iter()
            .find(|class| {
                let mut names = std::iter::once(&class.international).chain(&class.also);
                names.any(|name| folded(name) == wanted)
            })
            .ok_or_else(|| unknown("International", symbol, |class| class.international))
    }

    /// The class of a Schoenflies symbol; case, blanks, underscores and braces do not count, and
    /// `S2`, `S6`, `C1h`, `V`, `Vh`, `Vd` are known too.
    ///
    /// # Errors
    /// [`UnknownPointGroup`] with the nearest known symbols.
    pub fn from_schoenflies(symbol: &str) -> Result<&'static Self, UnknownPointGroup> {
        let wanted = match folded(symbol).as_str() {
            "s2" => String::from("ci"),
            "s6" => String::from("c3i"),
            "c1h" | "s1" => String::from("cs"),
            "v" => String::from("d2"),
            "vh" => String::from("d2h"),
            "vd" => String::from("d2d"),
            other => other.to_owned(),
        };
        Self::table()
            .iter()
            .find(|class| folded(class.schoenflies) == wanted)
            .ok_or_else(|| unknown("Schoenflies", symbol, |class| class.schoenflies))
    }

    /// The group itself.
    pub fn group(&self) -> PointGroup {
        self.group.clone()
    }

    /// The geometric symbol, read.
    pub fn symbol(&self) -> PointSymbol {
        self.group.symbol()
    }

    pub(super) fn with_census(census: &Census) -> Option<&'static Self> {
        Self::table().iter().find(|class| class.census == *census)
    }
}

/// What remains of a symbol when spelling does not count.
fn folded(symbol: &str) -> String {
    symbol
        .chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '_' | '{' | '}'))
        .flat_map(char::to_lowercase)
        .collect()
}

fn unknown(
    notation: &'static str,
    symbol: &str,
    name: impl Fn(&'static CrystalClass) -> &'static str,
) -> UnknownPointGroup {
    let short: String = symbol.chars().take(40).collect();
    let wanted = folded(&short);
    let mut ranked: Vec<(usize, &'static str)> = CrystalClass::table()
        .iter()
        .map(|class| {
            (
                strsim::osa_distance(&wanted, &folded(name(class))),
                name(class),
            )
        })
        .collect();
    ranked.sort_by_key(|(distance, _)| *distance);
    UnknownPointGroup {
        notation,
        symbol: short,
        suggestions: ranked.into_iter().take(3).map(|(_, name)| name).collect(),
    }
}

static CLASSES: LazyLock<Vec<CrystalClass>> =
    LazyLock::new(|| TABLE.lines().skip(1).filter_map(row).collect());

fn row(line: &'static str) -> Option<CrystalClass> {
    let mut fields = line.split('\t');
    let international = fields.next()?;
    let schoenflies = fields.next()?;
    let geometric = fields.next()?;
    let system = fields.next()?.parse().ok()?;
    let laue = fields.next()?;
    let also = fields.next().unwrap_or_default();
    let also = also.split("; ").filter(|name| !name.is_empty()).collect();
    let group = PointGroup::from_geometric(geometric).ok()?;
    let census = group.census();
    Some(CrystalClass {
        international,
        schoenflies,
        geometric,
        system,
        laue,
        also,
        group,
        census,
    })
}
