//! Blade names: `e12`, `e1^ni`, `e12ni` into ordered basis vectors, and back into field names.

use ga_core::Rational;

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
/// single digits continue the letters before them (`e12ni` is e1, e2, ni).
pub fn read(word: &str, basis: &[String]) -> Reading {
    if let Some(index) = basis.iter().position(|name| name == word) {
        return Reading::Blade(vec![index]);
    }
    let mut found = Vec::new();
    runs(word, None, basis, &mut Vec::new(), &mut found);
    let mut found = found.into_iter();
    match (found.next(), found.next()) {
        (None, _) => Reading::Unknown,
        (Some(one), None) => Reading::Blade(one),
        (Some(one), Some(other)) => Reading::Ambiguous(one, other),
    }
}

fn runs(
    rest: &str,
    letters: Option<&str>,
    basis: &[String],
    taken: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if found.len() > 1 || taken.len() > basis.len() {
        return;
    }
    if rest.is_empty() {
        if !found.contains(taken) {
            found.push(taken.clone());
        }
        return;
    }
    for (index, name) in basis.iter().enumerate() {
        let (name_letters, digits) = split(name);
        let continued = letters == Some(name_letters) && digits.len() == 1;
        let readings = [Some(name.as_str()), continued.then_some(digits)];
        for reading in readings.into_iter().flatten() {
            if let Some(tail) = rest.strip_prefix(reading) {
                taken.push(index);
                runs(tail, Some(name_letters), basis, taken, found);
                taken.pop();
            }
        }
    }
}

/// The spelling of a product of basis vectors: `e12ni`; with an underscore between names where
/// a name has two digits or more; `s` for the scalar.
pub fn field_name(indices: &[usize], basis: &[String]) -> String {
    if indices.is_empty() {
        return "s".to_owned();
    }
    let apart = basis.iter().any(|name| split(name).1.len() > 1) && indices.len() > 1;
    if apart {
        let names: Vec<&str> = indices.iter().map(|&i| basis[i].as_str()).collect();
        return names.join("_");
    }
    let mut spelled = String::new();
    let mut previous = "";
    for &index in indices {
        let (letters, digits) = split(&basis[index]);
        if letters != previous || digits.is_empty() {
            spelled.push_str(letters);
        }
        spelled.push_str(digits);
        previous = letters;
    }
    spelled
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
