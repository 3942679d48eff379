//! How a frieze, plane, rod or layer group is found by its symbol, and what is said when it is not.

use super::super::symbols::folded;
use super::{SubperiodicGroup, SubperiodicKind};

/// A symbol that names no group of a kind.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} group `{symbol}`{}", hint(*.kind, .suggestions))]
pub struct UnknownSubperiodicSymbol {
    /// The kind that was asked for.
    pub kind: SubperiodicKind,
    /// The symbol as given, shortened when very long.
    pub symbol: String,
    /// The known symbols that look most like it, best first.
    pub suggestions: Vec<String>,
}

fn hint(kind: SubperiodicKind, suggestions: &[String]) -> String {
    let example = match kind {
        SubperiodicKind::Frieze => "p 2 m g",
        SubperiodicKind::Plane => "p 4 g m",
        SubperiodicKind::Rod => "p 42/m m c",
        SubperiodicKind::Layer => "p 4/n m m",
    };
    match suggestions {
        [] => format!(
            "; write a number from 1 to {}, or a symbol such as `{example}`",
            kind.count()
        ),
        some => format!("; did you mean `{}`?", some.join("`, `")),
    }
}

/// The settings that a symbol or number may mean, the standard one first.
pub fn find(
    kind: SubperiodicKind,
    symbol: &str,
) -> Result<Vec<&'static SubperiodicGroup>, UnknownSubperiodicSymbol> {
    let (name, suffix) = symbol.split_once(':').unwrap_or((symbol, ""));
    let wanted = folded(name);
    let choice = match folded(suffix).as_str() {
        "" => Some(None),
        "1" => Some(Some('1')),
        "2" => Some(Some('2')),
        _ => None,
    };
    let all = || {
        SubperiodicGroup::table()
            .iter()
            .filter(|group| group.kind == kind)
    };
    let number: Option<u32> = wanted.parse().ok();
    let mut found: Vec<&SubperiodicGroup> = match (choice, number) {
        (None, _) => Vec::new(),
        (Some(choice), _) => all()
            .filter(|group| {
                let named = group.spellings().contains(&wanted) || Some(group.number) == number;
                named && (choice.is_none() || group.choice == choice)
            })
            .collect(),
    };
    // The orbifold symbols 442, 333 and the like are no numbers of groups, so nothing clashes.
    found.sort_by_key(|group| !group.standard);
    if found.is_empty() {
        return Err(UnknownSubperiodicSymbol {
            kind,
            symbol: symbol.chars().take(60).collect(),
            suggestions: suggestions(all(), &wanted),
        });
    }
    Ok(found)
}

fn suggestions<'a>(
    groups: impl Iterator<Item = &'a SubperiodicGroup>,
    wanted: &str,
) -> Vec<String> {
    let distance = |group: &SubperiodicGroup| {
        let spellings = group.spellings().into_iter();
        spellings
            .map(|name| strsim::osa_distance(wanted, &name))
            .min()
    };
    let mut ranked: Vec<(usize, &SubperiodicGroup)> = groups
        .filter_map(|group| Some((distance(group)?, group)))
        .filter(|(distance, group)| *distance <= 2 && *distance < folded(group.symbol).len())
        .collect();
    ranked.sort_by_key(|(distance, group)| (*distance, !group.standard, group.number));
    let mut names: Vec<String> = Vec::new();
    for (_, group) in ranked {
        if !names.iter().any(|name| name == group.symbol) {
            names.push(group.symbol.to_owned());
        }
    }
    names.truncate(3);
    names
}
