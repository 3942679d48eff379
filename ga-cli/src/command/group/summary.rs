//! Decides what is told about a group to people, in the order of International Tables.

use super::document::{Periodic, Placed, Point};
use crate::output;

/// The most triplets of a Wyckoff position that are printed.
const MOST_TRIPLETS: usize = 4;

/// Symbols, setting, lattice, generators, operations and positions of a group.
pub fn periodic(group: &Periodic) -> String {
    let mut text = heading(group);
    let rows = facts(group);
    let width = rows.iter().map(|(name, _)| name.chars().count()).max();
    let width = width.unwrap_or(0) + 2;
    for (name, value) in rows {
        text.push_str(&format!("{name:<width$}{value}\n"));
    }
    text.push_str("\nGenerators, after translations along the edges of the standard cell\n");
    for generator in &group.generators {
        text.push_str(&format!("  {generator}\n"));
    }
    text.push_str(&operations(group));
    if let Some(positions) = &group.wyckoff {
        text.push_str("\nPositions\n");
        let mut rows = Vec::new();
        for position in positions.iter().rev() {
            let shown = position.coordinates.iter().take(MOST_TRIPLETS);
            let mut triplets = shown
                .map(|triplet| format!("({triplet})"))
                .collect::<Vec<_>>();
            if position.coordinates.len() > MOST_TRIPLETS {
                triplets.push(String::from("…"));
            }
            rows.push(vec![
                format!("  {}", position.multiplicity),
                position.letter.map_or_else(String::new, String::from),
                position.site_symmetry.clone(),
                triplets.join(" "),
            ]);
        }
        text.push_str(&output::table(&rows));
    }
    if let Some(site) = &group.site {
        text.push_str("\nThe point\n");
        let [x, y, z] = site.place;
        let position = match (site.letter, &site.site_symmetry) {
            (Some(letter), Some(symmetry)) => format!(
                "on position {}{letter}, site symmetry {symmetry}",
                site.multiplicity
            ),
            _ => format!(
                "{} points per cell, site symmetry of order {}",
                site.multiplicity, site.order
            ),
        };
        text.push_str(&format!(
            "  {x:.6} {y:.6} {z:.6}  {position}; {:.4} Å from the one given\n",
            site.distance
        ));
        for [x, y, z] in &site.orbit {
            text.push_str(&format!("  {x:.6} {y:.6} {z:.6}\n"));
        }
    }
    text
}

/// The first two lines, as on the page of a group.
fn heading(group: &Periodic) -> String {
    let schoenflies = group.schoenflies.as_deref().unwrap_or_default();
    let words = [
        &group.symbols.qualified,
        schoenflies,
        &group.point_group,
        &group.system,
    ];
    let words: Vec<&str> = words.iter().map(|word| word.trim()).collect();
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    format!(
        "{}\n{} group number {}\n\n",
        words.join("    "),
        capital(&group.kind),
        group.number
    )
}

fn facts(group: &Periodic) -> Vec<(&'static str, String)> {
    let mut rows = vec![("full symbol", group.symbols.full.clone())];
    if let Some(extended) = &group.symbols.extended {
        rows.push(("extended symbol", extended.clone()));
    }
    match &group.space_group {
        None => {
            rows.push(("Hall symbol", group.hall.clone()));
            rows.push(("geometric symbol", group.geometric.clone()));
        }
        Some(space) => rows.push((
            "with all translations",
            format!(
                "{} (number {}), geometric {}",
                space.hm, space.number, group.geometric
            ),
        )),
    }
    if let Some(laue) = group.laue_class {
        rows.push(("Laue class", laue.to_owned()));
    }
    let pearson = group
        .lattice
        .pearson
        .map_or_else(String::new, |pearson| format!(", {pearson}"));
    rows.push(("lattice", format!("{}{pearson}", group.lattice.bravais)));
    let points = group.centring.iter().map(|point| {
        let parts: Vec<String> = point.iter().map(|part| fraction(*part)).collect();
        format!("({})", parts.join(","))
    });
    rows.push(("lattice points", points.collect::<Vec<_>>().join(" + ")));
    if let Some(change) = group
        .setting
        .from_standard
        .as_ref()
        .filter(|_| !group.setting.standard)
    {
        rows.push(("from the standard setting", change.clone()));
    }
    let directions = ["a", "b", "c"].into_iter().zip(&group.roots.directions);
    let directions = directions.filter(|(_, along)| *along != "-");
    let directions = directions.map(|(root, along)| format!("{root} along {along}"));
    rows.push(("roots", directions.collect::<Vec<_>>().join(", ")));
    if let Some(Placed { cell, .. }) = &group.placed {
        rows.push((
            "shown in the cell",
            format!(
                "{} {} {} Å, {}° {}° {}°",
                cell.a, cell.b, cell.c, cell.alpha_deg, cell.beta_deg, cell.gamma_deg
            ),
        ));
    }
    rows
}

/// The operations, numbered as International Tables number them: those of the first lattice point.
fn operations(group: &Periodic) -> String {
    let shown = group.order.min(group.operations.len());
    let centred = group.centring.len() > 1;
    let note = if centred {
        ", each with every lattice point added"
    } else {
        ""
    };
    let mut text = format!("\nOperations{note}\n");
    let words: Vec<String> = group
        .operations
        .iter()
        .take(shown)
        .enumerate()
        .map(|(at, triplet)| format!("({}) {triplet}", at + 1))
        .collect();
    let width = words.iter().map(String::len).max().unwrap_or(0) + 3;
    let columns = (96 / width).clamp(1, 4);
    for row in words.chunks(columns) {
        let cells: String = row.iter().map(|word| format!("{word:<width$}")).collect();
        text.push_str(&format!("  {}\n", cells.trim_end()));
    }
    text
}

/// A part of an edge, as a fraction where it is a simple one.
fn fraction(value: f64) -> String {
    for denominator in [1, 2, 3, 4, 6, 8, 12, 24] {
        let numerator = value * f64::from(denominator);
        if (numerator - numerator.round()).abs() < 1e-9 {
            let numerator = numerator.round();
            return if denominator == 1 {
                format!("{numerator}")
            } else {
                format!("{numerator}/{denominator}")
            };
        }
    }
    value.to_string()
}

fn capital(word: &str) -> String {
    let mut chars = word.chars();
    let first = chars.next().into_iter().flat_map(char::to_uppercase);
    first.chain(chars).collect()
}

/// One line for each group.
pub fn list(groups: &[Periodic]) -> String {
    let heading = [
        "number",
        "symbol",
        "Schoenflies",
        "point group",
        "geometric",
        "system",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    rows.extend(groups.iter().map(|group| {
        vec![
            group.number.to_string(),
            group.symbols.short.clone(),
            group
                .schoenflies
                .clone()
                .unwrap_or_else(|| String::from("-")),
            group.point_group.clone(),
            group.geometric.clone(),
            group.system.clone(),
        ]
    }));
    output::table(&rows)
}

/// Symbols, generators and classes of a point group.
pub fn point(group: &Point) -> String {
    let name = group.hm.unwrap_or("no crystal class");
    let mut text = format!("{}    {}    {}\n", name, group.schoenflies, group.overlined);
    let hand = if group.chiral {
        "rotations only"
    } else {
        "with reflections"
    };
    let centre = if group.centrosymmetric {
        ", with inversion"
    } else {
        ""
    };
    text.push_str(&format!(
        "Point group of order {}, {hand}{centre}\n\n",
        group.order
    ));
    let q = group.q.map_or_else(String::new, |q| format!(", q = {q}"));
    let mut rows = vec![
        ("geometric symbol", group.geometric.clone()),
        ("roots", format!("p = {}{q}", group.p)),
        ("generators", group.generators.join(", ")),
    ];
    if let Some(system) = &group.system {
        rows.push(("crystal system", system.clone()));
    }
    if let Some(laue) = group.laue_class {
        rows.push(("Laue class", laue.to_owned()));
    }
    for (name, value) in rows {
        text.push_str(&format!("{name:<18}{value}\n"));
    }
    text.push_str("\nConjugacy classes\n");
    let rows = group.classes.iter().map(|class| {
        let order = match class.kind {
            "rotation" | "rotoreflection" => format!("of order {}", class.order),
            _ => String::new(),
        };
        vec![format!("  {}", class.size), class.kind.to_owned(), order]
    });
    text.push_str(&output::table(&rows.collect::<Vec<_>>()));
    text
}

/// One line for each point group.
pub fn point_list(groups: &[Point]) -> String {
    let heading = [
        "number",
        "symbol",
        "Schoenflies",
        "geometric",
        "order",
        "system",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    rows.extend(groups.iter().map(|group| {
        vec![
            group
                .number
                .map_or_else(|| String::from("-"), |number| number.to_string()),
            group.hm.unwrap_or("-").to_owned(),
            group.schoenflies.clone(),
            group.geometric.clone(),
            group.order.to_string(),
            group.system.clone().unwrap_or_default(),
        ]
    }));
    output::table(&rows)
}
