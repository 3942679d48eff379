//! Blade names: `e12`, `e1^ni`, `e12ni` into ordered basis vectors, and back into field names.

use ga_core::Rational;

use crate::parse::is_plain_identifier;

/// How an identifier can be read as a product of basis vectors.
#[derive(Debug, PartialEq, Eq)]
pub enum Reading {
    /// The indices of the basis vectors in the order written.
    Blade(Vec<usize>),
    /// No reading.
    Unknown,
    /// Two different readings.
    Ambiguous(Vec<usize>, Vec<usize>),
}

/// A basis name split into letters and the digits behind them, `e` and `12`.
fn split(name: &str) -> (&str, &str) {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    name.split_at(letters.len())
}

/// Reads one identifier over the basis: a whole name first, else a run of names in which
/// digits continue the letters before them (`e12ni` is e1, e2, ni).
pub fn read(word: &str, basis: &[String]) -> Reading {
    if let Some(index) = basis.iter().position(|name| name == word) {
        return Reading::Blade(vec![index]);
    }
    // A blade with a vector twice is zero: that is a reading only where there is no other.
    let mut search = Search {
        basis,
        repeats: false,
        steps: 0,
        taken: Vec::new(),
        found: Vec::new(),
    };
    search.runs(word, None);
    if search.found.is_empty() {
        search.repeats = true;
        search.runs(word, None);
    }
    let mut found = search.found.into_iter();
    match (found.next(), found.next()) {
        (None, _) => Reading::Unknown,
        (Some(one), None) => Reading::Blade(one),
        (Some(one), Some(other)) => Reading::Ambiguous(one, other),
    }
}

/// The search for the ways to cut a word into basis vectors, up to the second one found.
struct Search<'b> {
    basis: &'b [String],
    /// Whether a vector may stand twice.
    repeats: bool,
    steps: usize,
    taken: Vec<usize>,
    found: Vec<Vec<usize>>,
}

impl Search<'_> {
    /// A word that takes longer to read is nobody's blade: bases such as a, aa, aaa, … have
    /// exponentially many readings.
    const STEP_LIMIT: usize = 20_000;

    fn runs(&mut self, rest: &str, letters: Option<&str>) {
        self.steps += 1;
        if self.found.len() > 1
            || self.taken.len() > self.basis.len()
            || self.steps > Self::STEP_LIMIT
        {
            return;
        }
        if rest.is_empty() {
            if !self.found.contains(&self.taken) {
                self.found.push(self.taken.clone());
            }
            return;
        }
        // Fields of bases such as e1 … e12 have an underscore between the vectors.
        let between = |tail: &&str| !self.taken.is_empty() && !tail.is_empty();
        if let Some(tail) = rest.strip_prefix('_').filter(between) {
            self.runs(tail, None);
        }
        let basis = self.basis;
        for (index, name) in basis.iter().enumerate() {
            if !self.repeats && self.taken.contains(&index) {
                continue;
            }
            let (name_letters, digits) = split(name);
            let continued = letters == Some(name_letters) && !digits.is_empty();
            let readings = [Some(name.as_str()), continued.then_some(digits)];
            for reading in readings.into_iter().flatten() {
                if let Some(tail) = rest.strip_prefix(reading) {
                    self.taken.push(index);
                    self.runs(tail, Some(name_letters));
                    self.taken.pop();
                }
            }
        }
    }
}

/// The spelling of a product of basis vectors: `e12ni`; with an underscore between names where
/// it would read as something else or be a keyword, `e1_e12`; `s` for the scalar.
///
/// It is an identifier whatever the basis.
pub fn field_name(indices: &[usize], basis: &[String]) -> String {
    let names: Vec<&str> = indices
        .iter()
        .map(|&i| basis[i].trim_start_matches("r#"))
        .collect();
    let apart = basis.iter().any(|name| split(name).1.len() > 1);
    let mut spelled = match names.as_slice() {
        [] => return "s".to_owned(),
        [one] => (*one).to_owned(),
        _ if apart => names.join("_"),
        _ => joined(&names),
    };
    let misread = || read(&spelled, basis) != Reading::Blade(indices.to_vec());
    if names.len() > 1 && (!is_plain_identifier(&spelled) || misread()) {
        spelled = names.join("_");
    }
    if !is_plain_identifier(&spelled) || spelled == "s" {
        spelled.push('_');
    }
    spelled
}

fn joined(names: &[&str]) -> String {
    let mut spelled = String::new();
    let mut previous = "";
    for name in names {
        let (letters, digits) = split(name);
        if letters != previous || digits.is_empty() {
            spelled.push_str(letters);
        }
        spelled.push_str(digits);
        previous = letters;
    }
    spelled
}

/// A product of basis vectors as a message shows it.
pub fn spelled(indices: &[usize], names: &[String]) -> String {
    let words: Vec<&str> = indices.iter().map(|&i| names[i].as_str()).collect();
    format!("`{}`", words.join("^"))
}

/// What stands for a basis vector that has no usable name starts with this.
pub const PLACEHOLDER: &str = "unnamed_";

/// A basis as a message shows it.
pub fn listed(names: &[String]) -> String {
    let written = names.iter().filter(|name| !name.starts_with(PLACEHOLDER));
    let words: Vec<&str> = written.map(String::as_str).collect();
    format!("`{}`", words.join(", "))
}

/// The indices of a bitmask in increasing order.
pub fn indices(mask: u32) -> Vec<usize> {
    (0..32).filter(|i| mask >> i & 1 == 1).collect()
}

/// The sign of the permutation that sorts distinct indices.
pub fn permutation_sign(indices: &[usize]) -> i32 {
    let inversions = indices
        .iter()
        .enumerate()
        .map(|(i, a)| indices[i + 1..].iter().filter(|b| a > b).count())
        .sum::<usize>();
    if inversions % 2 == 0 { 1 } else { -1 }
}

/// A rational as the source text of a number.
pub fn rational_text(value: &Rational) -> String {
    if value.is_integer() {
        value.numer().to_string()
    } else {
        value.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::{Reading, field_name, indices, read};

    fn basis(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn digits_continue_the_letters_before_them() {
        let cga = basis(&["e1", "e2", "e3", "no", "ni"]);
        assert_eq!(read("e12ni", &cga), Reading::Blade(vec![0, 1, 4]));
        assert_eq!(read("e31", &cga), Reading::Blade(vec![2, 0]));
        assert_eq!(read("e1e2", &cga), Reading::Blade(vec![0, 1]));
        assert_eq!(read("e14", &cga), Reading::Unknown);
        assert_eq!(read("e11", &cga), Reading::Blade(vec![0, 0]));
    }

    #[test]
    fn two_readings_are_told_apart_by_nobody() {
        let twelve: Vec<String> = (1..=12).map(|i| format!("e{i}")).collect();
        assert_eq!(read("e12", &twelve), Reading::Blade(vec![11]));
        assert!(matches!(read("e112", &twelve), Reading::Ambiguous(..)));
    }

    #[test]
    fn every_field_reads_back_as_its_blade() {
        for names in [
            basis(&["e1", "e2", "e3", "no", "ni"]),
            basis(&["a", "bc", "ab", "c"]),
            basis(&["i", "f", "n"]),
            basis(&["e9", "e10", "e11"]),
        ] {
            for mask in 1..1_u32 << names.len() {
                let field = field_name(&indices(mask), &names);
                assert!(syn::parse_str::<syn::Ident>(&field).is_ok(), "{field}");
                let reading = read(&field, &names);
                assert_eq!(reading, Reading::Blade(indices(mask)), "{field}");
            }
        }
    }

    #[test]
    fn a_keyword_is_spelled_apart() {
        assert_eq!(field_name(&[0, 1], &basis(&["i", "f"])), "i_f");
        assert_eq!(field_name(&[0], &basis(&["fn"])), "fn_");
    }

    #[test]
    fn hostile_bases_are_read_in_bounded_time() {
        let names: Vec<String> = (1..=12).map(|i| "a".repeat(i)).collect();
        let word = format!("{}b", "a".repeat(60));
        assert_eq!(read(&word, &names), Reading::Unknown);
    }
}
