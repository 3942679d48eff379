//! How the name of a basis blade is spelled from the names of its vectors.

use alloc::collections::BTreeSet;
use alloc::string::String;
use alloc::vec::Vec;

use crate::Blade;

/// The name of `blade`, concise (`e12ni`) or with wedges (`e1^e2^ni`).
pub(super) fn blade_name(names: &[String], blade: Blade, concise: bool) -> String {
    let members: Vec<&String> = blade
        .indices()
        .filter_map(|index| names.get(index))
        .collect();
    if members.is_empty() {
        return String::from("1");
    }
    let mut spelled = String::new();
    let mut last_prefix = None;
    for name in members {
        let prefix = indexed_prefix(name);
        if concise && prefix.is_some() && prefix == last_prefix {
            spelled.extend(name.chars().next_back());
        } else {
            if !concise && !spelled.is_empty() {
                spelled.push('^');
            }
            spelled.push_str(name);
        }
        last_prefix = prefix;
    }
    spelled
}

/// Whether all blades have different concise names.
pub(super) fn is_unambiguous(names: &[String]) -> bool {
    if names.iter().any(|name| trailing_digits(name) > 1) {
        return false;
    }
    let first_prefix = names.first().and_then(|name| indexed_prefix(name));
    if first_prefix.is_some()
        && names
            .iter()
            .all(|name| indexed_prefix(name) == first_prefix)
    {
        return true;
    }
    let mut seen = BTreeSet::new();
    (0..1 << names.len()).all(|mask| seen.insert(blade_name(names, Blade::new(mask), true)))
}

/// The letters before a single closing digit.
fn indexed_prefix(name: &str) -> Option<&str> {
    let prefix = name.strip_suffix(|last: char| last.is_ascii_digit())?;
    (!prefix.is_empty() && !prefix.ends_with(|last: char| last.is_ascii_digit())).then_some(prefix)
}

fn trailing_digits(name: &str) -> usize {
    name.chars().rev().take_while(char::is_ascii_digit).count()
}
