//! How a setting is found by whatever a user writes: number, Hermann–Mauguin, Schoenflies, Hall or
//! geometric symbol.

use super::super::generators::GeometricSymbolError;
use super::super::hall;
use super::{SpaceGroup, UnknownSymbol, folded, plain_text, spelling};

impl SpaceGroup {
    /// The settings that a text may mean, likeliest first: a number (`62`), a Hermann–Mauguin
    /// symbol (see [`SpaceGroup::from_symbol`]), a Schoenflies symbol (`D2h^16`), a Hall symbol
    /// (`-P 2ac 2n`) or a geometric symbol (`P b(4)_1 b(2)`), each but the Hall symbol with `:1`,
    /// `:2`, `:H` or `:R` for origin or axes, and a number with the axes of a monoclinic group (`14:b2`,
    /// see [`SpaceGroup::with_axes`]). Notes in brackets and `#` are read as [`plain_text`] says.
    ///
    /// What is a symbol in several of these notations, as `P 2`, counts as the first of them: `P4̅` is
    /// the Hermann–Mauguin symbol of number 81, while a geometric symbol is safe as `P b(4)`.
    /// [`SpaceGroup::from_hall`] and [`SpaceGroup::from_geometric`] read one notation only.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// for text in ["227", "F d -3 m", "F 41/d -3 2/m", "Oh^7", "-F 4vw 2vw 3", "F_d 4 3"] {
    ///     assert_eq!(SpaceGroup::find(text)?[0].qualified_symbol(), "F d -3 m:2");
    /// }
    /// assert_eq!(SpaceGroup::find("227:1")?[0].hall, "F 4d 2 3 -1d");
    /// # Ok::<(), ga_design::crystallography::UnknownSymbol>(())
    /// ```
    pub fn find(text: &str) -> Result<Vec<&'static Self>, UnknownSymbol> {
        let text = &*plain_text(text);
        let (name, suffix) = text.split_once(':').unwrap_or((text, ""));
        if let Ok(number) = name.trim().parse() {
            let settings = chosen(Self::settings(number), suffix);
            let with_axes = || Some(vec![Self::with_axes(number, suffix)?]);
            return settings.or_else(with_axes).ok_or_else(|| unknown(text));
        }
        let by_symbol = Self::from_symbol(text);
        let other = || {
            let schoenflies = chosen(Self::from_schoenflies(name), suffix);
            schoenflies
                .or_else(|| Some(vec![Self::from_hall(text)?]))
                .or_else(|| {
                    let standard = Self::from_geometric(name).ok()?;
                    chosen(Self::settings(standard.number), suffix)
                })
        };
        by_symbol.or_else(|unknown| {
            other().ok_or_else(|| {
                let mut unknown = unknown;
                unknown.suggestions.extend(similar_schoenflies(name));
                // Bars say which notation is meant; combining ones are written in two.
                let geometric = similar_geometric(name);
                let open = name.contains("b(") || unknown.suggestions.is_empty();
                if open && !geometric.is_empty() {
                    unknown.suggestions = geometric;
                }
                unknown
            })
        })
    }

    /// The settings of a Schoenflies symbol, the standard one first; blanks, underscores and case
    /// do not matter, and the `^` may be left out: `D2h^16`, `D_2h^16`, `D2h16`.
    pub fn from_schoenflies(symbol: &str) -> Vec<&'static Self> {
        let plain = |text: &str| folded(text).replace('^', "");
        let wanted = plain(symbol);
        // Without the sign C23 might be C2 to the third or C to the 23rd; no two symbols clash.
        (1..=230)
            .filter_map(Self::standard)
            .find(|group| plain(&group.schoenflies()) == wanted)
            .map(|group| Self::settings(group.number))
            .unwrap_or_default()
    }

    /// The setting with the operations of a Hall symbol, in whatever way it is written.
    ///
    /// `None` when the text is no Hall symbol, or one of a setting that the table does not have;
    /// then [`SpaceGroup::recognise`] tells the group.
    pub fn from_hall(symbol: &str) -> Option<&'static Self> {
        // A lattice letter alone, such as `F`, is the beginning of a symbol.
        if !symbol.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        // Here blanks matter: `P 32` is not `P 3 2`.
        let words = |hall: &str| {
            let plain = hall.to_ascii_lowercase().replace('_', " ");
            plain.split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let wanted = words(symbol);
        let same = |hall: &str| words(hall) == wanted;
        let mut named = Self::table().iter().filter(|group| same(group.hall));
        named
            .next()
            .or_else(|| Self::identify(&hall::operations(symbol.trim()).ok()?))
    }
}

/// The settings with a choice of origin or axes, if any is asked for; `None` when none is left.
fn chosen(
    mut settings: Vec<&'static SpaceGroup>,
    suffix: &str,
) -> Option<Vec<&'static SpaceGroup>> {
    let suffix = suffix.trim();
    if !suffix.is_empty() {
        let choice = spelling::choice(suffix)?;
        settings.retain(|group| group.choice == Some(choice));
    }
    (!settings.is_empty()).then_some(settings)
}

fn unknown(text: &str) -> UnknownSymbol {
    UnknownSymbol {
        symbol: text.chars().take(60).collect(),
        suggestions: Vec::new(),
    }
}

/// Geometric symbols that a text with bars almost is.
fn similar_geometric(name: &str) -> Vec<String> {
    let barred = name.contains("b(") || name.contains(['\u{304}', '\u{305}']);
    match SpaceGroup::from_geometric(name) {
        Err(GeometricSymbolError::Unknown { suggestions, .. }) if barred => suggestions,
        _ => Vec::new(),
    }
}

/// Schoenflies symbols that a text with `^` almost is.
fn similar_schoenflies(name: &str) -> Vec<String> {
    if !name.contains('^') {
        return Vec::new();
    }
    let short: String = name.chars().take(20).collect();
    let wanted = folded(&short);
    let mut ranked: Vec<(usize, u32, String)> = (1..=230)
        .filter_map(SpaceGroup::standard)
        .map(|group| (group.number, group.schoenflies()))
        .map(|(number, symbol)| {
            let distance = strsim::osa_distance(&wanted, &folded(&symbol));
            // A superscript beyond the last comes nearest to the last.
            (distance, 230 - number, symbol)
        })
        .filter(|(distance, _, _)| *distance <= 2)
        .collect();
    ranked.sort();
    ranked
        .into_iter()
        .map(|(_, _, symbol)| symbol)
        .take(3)
        .collect()
}
