//! The name that was probably meant: the closest by Levenshtein's distance.

/// The candidate closest to a misspelt name, if any is close: one edit, and one more for every
/// four letters. Names longer than any name of the field have no close one.
pub fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    const LONGEST: usize = 64;
    let length = name.chars().count();
    if length > LONGEST {
        return None;
    }
    let limit = 1 + length / 4;
    candidates
        .into_iter()
        .map(|candidate| (edit_distance(name, candidate), candidate))
        // A word that shares no letter with the candidate is no misspelling of it.
        .filter(|(distance, _)| *distance <= limit && *distance < length)
        // Of equals, people hit the wrong key later in a word more often than they lose one.
        .min_by_key(|(distance, candidate)| {
            let first_differs = candidate.chars().next() != name.chars().next();
            let length_differs = candidate.chars().count() != length;
            (*distance, first_differs, length_differs)
        })
        .map(|(_, candidate)| candidate.to_owned())
}

/// The number of insertions, deletions and substitutions between two words.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        if let Some(first) = row.first_mut() {
            *first = left;
        }
        for (above, y) in row.iter_mut().skip(1).zip(&b) {
            let substituted = diagonal + usize::from(x != *y);
            diagonal = *above;
            left = substituted.min(diagonal + 1).min(left + 1);
            *above = left;
        }
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::{closest, edit_distance};

    #[test]
    fn distances_are_levenshteins() {
        // The examples of Levenshtein's distance in Wagner and Fischer's setting.
        assert_eq!(edit_distance("kitten", "sitting"), 3);
        assert_eq!(edit_distance("", "abc"), 3);
        assert_eq!(edit_distance("abc", ""), 3);
        assert_eq!(edit_distance("same", "same"), 0);
    }

    #[test]
    fn only_close_names_are_suggested() {
        assert_eq!(closest("wedgee", ["inner", "wedge"]), Some("wedge".into()));
        assert_eq!(closest("x", ["y", "z"]), None);
        assert_eq!(closest("quaternion", ["inner", "wedge"]), None);
        assert_eq!(closest(&"e".repeat(1000), ["e"]), None);
    }
}
