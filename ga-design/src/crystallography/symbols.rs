//! Which settings of the 230 space groups are known, and how one is found by number, symbol or
//! operations.
//!
//! The table is `data/space_groups.tsv`: the standard settings of *International Tables for
//! Crystallography* A and the alternative axes, cell and origin choices listed there, with Hall
//! symbols. Where the tables offer two origins the standard one here is the second (on the
//! inversion centre), and for rhombohedral lattices the hexagonal axes.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::change_of_basis::ChangeOfBasis;
use super::hall::{self, HallError};
use super::operation::Operation;

mod axes;
mod extended;
mod lookup;
mod spelling;
mod system;

pub use super::lattice::CrystalSystem;
pub(super) use spelling::folded;
pub use spelling::plain_text;

const TABLE: &str = include_str!("../../data/space_groups.tsv");

/// One setting of a space group.
#[derive(Debug, PartialEq, Eq)]
pub struct SpaceGroup {
    /// The number in International Tables, 1 to 230.
    pub number: u32,
    /// The Hermann–Mauguin symbol with blanks, such as `P 1 21/c 1`.
    pub symbol: &'static str,
    /// The origin choice `1` or `2`, or the axes `H` or `R`, where the symbol does not tell.
    pub choice: Option<char>,
    /// The Hall symbol.
    pub hall: &'static str,
    /// The point group, such as `2/m`.
    pub point_group: &'static str,
    /// Whether this is the setting that the number alone stands for.
    pub standard: bool,
    /// Other spellings: full symbols, and the symbols with the glide `e`.
    also: Vec<&'static str>,
    from_standard: &'static str,
}

/// A symbol that names no known setting.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown space group symbol `{symbol}`{}", did_you_mean(.suggestions))]
pub struct UnknownSymbol {
    /// The symbol as given, shortened when very long.
    pub symbol: String,
    /// The known symbols that look most like it, best first.
    pub suggestions: Vec<String>,
}

fn did_you_mean(suggestions: &[String]) -> String {
    match suggestions {
        [] => String::from("; write one such as `P 21/c` or `F d -3 m:2`"),
        some => format!("; did you mean `{}`?", some.join("`, `")),
    }
}

impl SpaceGroup {
    /// All known settings, by number; the standard one is not always the first of its number.
    pub fn table() -> &'static [Self] {
        &INDEX.table
    }

    /// The standard setting of a number from 1 to 230.
    pub fn standard(number: u32) -> Option<&'static Self> {
        Self::table()
            .iter()
            .find(|group| group.number == number && group.standard)
    }

    /// All settings of a number, the standard one first.
    pub fn settings(number: u32) -> Vec<&'static Self> {
        let mut found: Vec<_> = Self::table()
            .iter()
            .filter(|g| g.number == number)
            .collect();
        found.sort_by_key(|group| !group.standard);
        found
    }

    /// The settings that a Hermann–Mauguin symbol may mean, most likely first.
    ///
    /// Blanks, underscores and case do not matter, nor does how a subscript (`P 2(1)/c`, `P2₁/c`) or
    /// a bar (`F d 3̄ m`, `F d \bar{3} m`) is typed; `:1`, `:2`, `:H`, `:R` or a trailing `S`, `Z`,
    /// `H`, `R` choose origin or axes, and without them the standard choice comes first. Short
    /// (`P 21/c`), full (`P 1 21/c 1`, `F 41/d -3 2/m`), extended (`C 2/m 2/c 21/m (21/b 21/n n)`,
    /// any of its further elements in brackets) and old (`F d 3 m`) spellings are known, and notes in
    /// brackets (see [`plain_text`]).
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// let found = SpaceGroup::from_symbol("Fd-3m:1")?;
    /// assert_eq!(found[0].hall, "F 4d 2 3 -1d");
    /// assert!(SpaceGroup::from_symbol("P 21/q").is_err());
    /// # Ok::<(), ga_design::crystallography::UnknownSymbol>(())
    /// ```
    pub fn from_symbol(symbol: &str) -> Result<Vec<&'static Self>, UnknownSymbol> {
        let symbol = &*plain_text(symbol);
        if let Some(settings) = extended::find(symbol) {
            return Ok(settings);
        }
        let found = spelling::readings(symbol)
            .into_iter()
            .find_map(|(key, choice)| {
                let settings: Vec<_> = INDEX
                    .by_name
                    .get(&key)?
                    .iter()
                    .filter_map(|at| INDEX.table.get(*at))
                    .filter(|group| choice.is_none() || group.choice == choice)
                    .collect();
                (!settings.is_empty()).then_some(settings)
            });
        found.ok_or_else(|| UnknownSymbol {
            symbol: symbol.chars().take(60).collect(),
            suggestions: suggestions(symbol),
        })
    }

    /// The setting with exactly this closed set of operations modulo the lattice, in any order.
    ///
    /// Settings that differ by a name only are told apart by nothing; the standard one, or else
    /// the first of the table, is returned.
    pub fn identify(operations: &[Operation]) -> Option<&'static Self> {
        let mut sorted = operations.to_vec();
        sorted.sort_unstable();
        sorted.dedup();
        BY_OPERATIONS
            .get(&sorted)
            .and_then(|at| INDEX.table.get(*at))
    }

    /// The operations, the identity first.
    pub fn operations(&self) -> Result<Vec<Operation>, HallError> {
        hall::operations(self.hall)
    }

    /// The change of basis `(P, p)` from the standard setting of the number to this one: a point has
    /// the standard coordinates `x = P x′ + p` where `x′` are its coordinates here.
    ///
    /// Of the many that carry the operations over, the one is meant under which the Wyckoff letters
    /// keep their positions.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// let setting = &SpaceGroup::from_symbol("P 1 1 21/b")?[0];
    /// let standard = SpaceGroup::standard(14).and_then(|group| group.operations().ok());
    /// let carried = standard.and_then(|all| setting.from_standard()?.operations(&all));
    /// assert_eq!(carried.map(|all| all.len()), Some(4));
    /// # Ok::<(), ga_design::crystallography::UnknownSymbol>(())
    /// ```
    pub fn from_standard(&self) -> Option<ChangeOfBasis> {
        self.from_standard.parse().ok()
    }

    /// The symbol with its choice of origin or axes where there is one: `F d -3 m:2`.
    pub fn qualified_symbol(&self) -> String {
        match self.choice {
            Some(choice) => format!("{}:{choice}", self.symbol),
            None => self.symbol.to_owned(),
        }
    }

    /// Every spelling of this setting, its own symbol first.
    fn spellings(&self) -> Vec<String> {
        let mut all = vec![self.symbol.to_owned()];
        all.extend(spelling::variants(self.symbol, self.number, self.choice));
        all.extend(self.also.iter().map(|name| (*name).to_owned()));
        all
    }
}

struct Index {
    table: Vec<SpaceGroup>,
    by_name: HashMap<String, Vec<usize>>,
}

static INDEX: LazyLock<Index> = LazyLock::new(|| {
    let table: Vec<SpaceGroup> = TABLE.lines().filter_map(row).collect();
    let mut by_name: HashMap<String, Vec<usize>> = HashMap::new();
    // Own symbols before derived spellings, standard settings before others.
    for derived in [false, true] {
        for standard in [true, false] {
            for (at, group) in table
                .iter()
                .enumerate()
                .filter(|(_, g)| g.standard == standard)
            {
                let names = group.spellings();
                let own = usize::from(!names.is_empty());
                let chosen = if derived {
                    names.get(own..)
                } else {
                    names.get(..own)
                };
                for name in chosen.unwrap_or_default() {
                    let settings = by_name.entry(spelling::folded(name)).or_default();
                    if !settings.contains(&at) {
                        settings.push(at);
                    }
                }
            }
        }
    }
    Index { table, by_name }
});

static BY_OPERATIONS: LazyLock<HashMap<Vec<Operation>, usize>> = LazyLock::new(|| {
    let mut found = HashMap::new();
    for standard in [true, false] {
        for (at, group) in INDEX
            .table
            .iter()
            .enumerate()
            .filter(|(_, g)| g.standard == standard)
        {
            if let Ok(mut operations) = group.operations() {
                operations.sort_unstable();
                found.entry(operations).or_insert(at);
            }
        }
    }
    found
});

/// A row of the table; `None` for its heading.
fn row(line: &'static str) -> Option<SpaceGroup> {
    let mut fields = line.split('\t');
    let number = fields.next()?.parse().ok()?;
    let symbol = fields.next()?;
    let choice = fields.next()?.chars().next();
    let hall = fields.next()?;
    let point_group = fields.next()?;
    let standard = fields.next()? == "standard";
    let also = fields
        .next()?
        .split("; ")
        .filter(|name| !name.is_empty())
        .collect();
    let from_standard = fields.next()?;
    Some(SpaceGroup {
        number,
        symbol,
        choice,
        hall,
        point_group,
        standard,
        also,
        from_standard,
    })
}

/// The folded symbol without the places that have no element: `p3m` for `P 3 m 1` and for `P 3 1 m`.
fn without_ones(symbol: &str) -> String {
    let words = symbol.split(' ').filter(|word| *word != "1");
    spelling::folded(&words.collect::<String>())
}

fn suggestions(symbol: &str) -> Vec<String> {
    let short: String = symbol.chars().take(60).collect();
    let wanted = spelling::folded(short.split(':').next().unwrap_or_default());
    // Everything is like nothing.
    if wanted.is_empty() {
        return Vec::new();
    }
    let mut ranked: Vec<(usize, &SpaceGroup)> = INDEX
        .by_name
        .iter()
        .filter_map(|(name, settings)| {
            let group = settings.first().and_then(|at| INDEX.table.get(*at))?;
            let is_short = group.number > 15 && without_ones(group.symbol) == wanted;
            let distance = strsim::osa_distance(&wanted, name);
            Some((if is_short { 0 } else { distance }, group))
        })
        .filter(|(distance, _)| *distance <= 2)
        .collect();
    ranked
        .sort_by_key(|(distance, group)| (*distance, !group.standard, group.number, group.symbol));
    let mut names: Vec<String> = Vec::new();
    for (_, group) in ranked {
        let name = group.qualified_symbol();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.truncate(3);
    names
}
