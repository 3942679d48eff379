//! Decides what is told about a crystal to people.

use super::document::Document;
use crate::output;

/// The name, contents, cell and group of a crystal, and its atoms by element.
pub fn text(document: &Document) -> String {
    let cell = &document.cell;
    let unknown = || "not known".to_owned();
    let density = document
        .density
        .map_or_else(unknown, |value| format!("{value:.3} g/cm³"));
    let rows = [
        ("crystal", document.name.clone()),
        ("unit cell holds", document.formula.clone()),
        ("space group", group(document)),
        ("edges a b c", format!("{} {} {} Å", cell.a, cell.b, cell.c)),
        (
            "angles α β γ",
            format!("{}° {}° {}°", cell.alpha_deg, cell.beta_deg, cell.gamma_deg),
        ),
        ("volume", format!("{:.3} Å³", cell.volume)),
        ("density", density),
        ("atoms in the cell", document.atoms.len().to_string()),
    ];
    // The words of the second column are kept left, numbers among them too.
    let mut text: String = rows
        .iter()
        .map(|(name, value)| format!("{name:<18}{value}\n"))
        .collect();
    let mut counts = vec![vec!["element".to_owned(), "atoms".to_owned()]];
    let elements = document.elements();
    counts.extend(
        elements
            .iter()
            .map(|(symbol, n)| vec![(*symbol).to_owned(), n.to_string()]),
    );
    text.push('\n');
    text.push_str(&output::table(&counts));
    text
}

/// One sentence about the crystal, to stand under its picture.
pub fn caption(document: &Document) -> String {
    format!("{}, space group {}.", document.formula, group(document))
}

fn group(document: &Document) -> String {
    match (&document.hm, document.number) {
        (Some(symbol), Some(number)) => format!("{symbol} (number {number})"),
        (Some(symbol), None) => format!("{symbol} (number not known)"),
        (None, Some(number)) => format!("number {number}"),
        (None, None) => "not known".to_owned(),
    }
}
