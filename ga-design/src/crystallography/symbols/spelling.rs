//! Which spellings of a Hermann–Mauguin symbol are taken for the same.

use std::borrow::Cow;

/// The most characters of a symbol that are looked at: the longest ones with markup are far shorter.
const LONGEST: usize = 200;

/// What markup writes around a subscript.
const SUBSCRIPT: [&str; 2] = ["<sub>", "</sub>"];

/// What TeX and CIF write before a number under a bar.
const BARS: [&str; 3] = ["\\overline", "\\bar", "\\-"];

/// A symbol without what does not matter: case, blanks, quotation marks, brackets, and the marks
/// of a subscript. A bar over a number is a minus sign before it.
pub fn folded(symbol: &str) -> String {
    let start: String = symbol.chars().take(LONGEST).map(plain).collect();
    let text = SUBSCRIPT
        .iter()
        .fold(start, |text, mark| text.replace(mark, ""));
    let text = BARS.iter().fold(text, |text, bar| text.replace(bar, "-"));
    let mut folded = String::with_capacity(text.len());
    for c in text.chars().filter(|c| !c.is_whitespace()) {
        match c {
            '_' | '~' | '\'' | '"' | '(' | ')' | '{' | '}' | '$' => {}
            // A combining bar stands behind its number; behind a letter it is meant for the next.
            '\u{304}' | '\u{305}' => {
                let number = folded.chars().last().filter(char::is_ascii_digit);
                if number.is_some() {
                    folded.pop();
                }
                folded.push('-');
                folded.extend(number);
            }
            other => folded.push(other),
        }
    }
    folded
}

/// One character as typed on a plain keyboard.
fn plain(c: char) -> char {
    match c {
        // Dashes that word processors make of a minus sign, and bars that stand alone.
        '\u{2010}'..='\u{2015}' | '\u{2212}' | '\u{af}' | '\u{203e}' => '-',
        // Subscripts.
        '\u{2080}'..='\u{2089}' => {
            char::from_digit(u32::from(c) - u32::from('\u{2080}'), 10).unwrap_or(c)
        }
        other => other.to_ascii_lowercase(),
    }
}

/// A number or symbol with its choice of origin or axes after a colon, where a note in brackets tells
/// it, and without the sign before a number; any other text as it is.
///
/// ```
/// use ga_design::crystallography::symbols::plain_text;
///
/// assert_eq!(plain_text("F d -3 m (origin choice 2)"), "F d -3 m:2");
/// assert_eq!(plain_text("R -3 c (rhombohedral axes)"), "R -3 c:R");
/// assert_eq!(plain_text("#225"), "225");
/// assert_eq!(plain_text("P2(1)/c"), "P2(1)/c");
/// ```
pub fn plain_text(text: &str) -> Cow<'_, str> {
    let trimmed = text.trim();
    let signs = ["#", "No.", "no.", "No ", "no "];
    let number = signs.iter().find_map(|sign| trimmed.strip_prefix(sign));
    let number = number.map(str::trim_start);
    let is_number = |text: &&str| text.starts_with(|c: char| c.is_ascii_digit());
    let rest = number.filter(is_number).unwrap_or(text);
    match noted(rest) {
        Some((name, choice)) => Cow::Owned(format!("{name}:{choice}")),
        None => Cow::Borrowed(rest),
    }
}

/// A text before a note in brackets, and the choice of origin or axes that this tells.
fn noted(text: &str) -> Option<(&str, char)> {
    let (name, note) = text.trim_end().strip_suffix(')')?.rsplit_once('(')?;
    // What stands after a colon has told it already.
    if name.contains(':') {
        return None;
    }
    let note = note.to_ascii_lowercase();
    let words: Vec<&str> = note.split_whitespace().collect();
    let choice = match words.as_slice() {
        ["origin", "choice", "1"] | ["origin" | "choice", "1"] => '1',
        ["origin", "choice", "2"] | ["origin" | "choice", "2"] => '2',
        ["hexagonal"] | ["hexagonal", "axes" | "cell" | "setting"] => 'H',
        ["rhombohedral"] | ["rhombohedral", "axes" | "cell" | "setting"] => 'R',
        _ => return None,
    };
    Some((name.trim_end(), choice))
}

/// The ways to read a symbol, as folded names with a choice of origin or axes, best first.
pub fn readings(symbol: &str) -> Vec<(String, Option<char>)> {
    let mut all = Vec::new();
    let (name, suffix) = match symbol.split_once(':') {
        Some((name, suffix)) => (folded(name), folded(suffix)),
        None => (folded(symbol), String::new()),
    };
    // Other suffixes, such as `b1`, tell the axes, which the symbol itself also tells.
    let choice = choice(&suffix);
    all.push((name.clone(), choice));
    let trailing = match name.chars().last() {
        Some('s') => Some('1'),
        Some('z') => Some('2'),
        Some('h') => Some('H'),
        Some('r') => Some('R'),
        _ => None,
    };
    if let (Some(trailing), None) = (trailing, choice) {
        let mut shorter = name;
        shorter.pop();
        all.push((shorter, Some(trailing)));
    }
    all
}

/// The choice of origin or axes that a suffix begins with, in either case.
pub fn choice(suffix: &str) -> Option<char> {
    match suffix.chars().next()?.to_ascii_uppercase() {
        known @ ('1' | '2' | 'H' | 'R') => Some(known),
        _ => None,
    }
}

/// Spellings that follow from the symbol by rule.
pub fn variants(symbol: &str, number: u32, choice: Option<char>) -> Vec<String> {
    let words: Vec<&str> = symbol.split(' ').collect();
    let mut all = Vec::new();
    match number {
        // Monoclinic: the short symbol leaves the ones out.
        3..=15 => {
            let short: Vec<&str> = words.iter().copied().filter(|word| *word != "1").collect();
            all.push(short.join(" "));
        }
        // Cubic: the old symbol writes 3 for −3.
        200..=206 | 221..=230 => {
            let old = words
                .iter()
                .map(|word| if *word == "-3" { "3" } else { word });
            all.push(old.collect::<Vec<_>>().join(" "));
        }
        // Rhombohedral lattice on hexagonal axes: protein files write H for R.
        146 | 148 | 155 | 160 | 161 | 166 | 167 if choice == Some('H') => {
            all.push(symbol.replacen('R', "H", 1));
        }
        _ => {}
    }
    all
}
