//! Decides which group a text means: by number, or by a symbol in one of the notations.

use crate::failure::Failure;
use clap::ValueEnum;
use ga_design::crystallography::symbols::plain_text;
use ga_design::crystallography::{
    CrystalClass, PointGroup, Recognition, SpaceGroup, SpaceGroupGenerators, SubperiodicGroup,
    SubperiodicKind,
};
use serde::Serialize;

/// The kinds of groups.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The 230.
    Space,
    /// Plane, frieze, layer and rod groups.
    Subperiodic(SubperiodicKind),
    /// Groups that leave a point in place.
    Point,
}

/// How a group can be named.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Notation {
    /// The number in International Tables.
    Number,
    /// Hermann–Mauguin.
    International,
    /// Schoenflies.
    Schoenflies,
    /// Hall.
    Hall,
    /// Hestenes and Holt.
    Geometric,
}

impl Notation {
    /// The name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::International => "Hermann–Mauguin symbol",
            Self::Schoenflies => "Schoenflies symbol",
            Self::Hall => "Hall symbol",
            Self::Geometric => "geometric symbol",
        }
    }
}

/// A space group, and how it was found.
pub struct Found {
    /// The setting chosen; the standard one where the setting that is meant is in no table.
    pub group: &'static SpaceGroup,
    /// The setting that is meant and is in no table.
    pub unlisted: Option<Unlisted>,
    /// The notation in which the text was read.
    pub notation: Notation,
    /// The other settings that it fits.
    pub others: Vec<&'static SpaceGroup>,
    /// What it means in other notations, where that is another group.
    pub also: Vec<(Notation, &'static SpaceGroup)>,
}

/// A setting that is in no table.
pub struct Unlisted {
    /// Its Hall symbol.
    pub hall: String,
    /// How the standard setting leads to it.
    pub setting: Recognition,
}

const NOTATIONS: [Notation; 5] = [
    Notation::Number,
    Notation::International,
    Notation::Schoenflies,
    Notation::Hall,
    Notation::Geometric,
];

/// The space group that a text means, in this notation or in the first of all in which it means one.
pub fn space(text: &str, notation: Option<Notation>) -> Result<Found, Failure> {
    let text = &*plain_text(text);
    check_number("space", 230, text)?;
    check_choice(text)?;
    let wanted: Vec<Notation> = notation.map_or(NOTATIONS.to_vec(), |only| vec![only]);
    let mut readings = wanted
        .into_iter()
        .map(|notation| (notation, settings(text, notation)))
        .filter(|(_, settings)| !settings.is_empty());
    let Some((read_as, settings)) = readings.next() else {
        let is_hall = notation.is_none_or(|only| only == Notation::Hall);
        let unlisted = is_hall.then(|| unlisted(text)).flatten();
        return unlisted.ok_or_else(|| unknown(text, notation));
    };
    let [group, others @ ..] = settings.as_slice() else {
        return Err(unknown(text, notation));
    };
    let also = readings
        .filter_map(|(notation, settings)| Some((notation, *settings.first()?)))
        .filter(|(_, other)| other.number != group.number)
        .collect();
    Ok(Found {
        group,
        unlisted: None,
        notation: read_as,
        others: others.to_vec(),
        also,
    })
}

/// The settings that a text means in a notation, the likeliest first.
fn settings(text: &str, notation: Notation) -> Vec<&'static SpaceGroup> {
    let is_number = |text: &str| text.trim().parse::<u32>().is_ok();
    let (name, choice) = text.split_once(':').unwrap_or((text, ""));
    match notation {
        Notation::Number if is_number(name) => {
            let found = SpaceGroup::find(text).unwrap_or_default();
            // A number means its standard setting, which leaves nothing open.
            found.into_iter().take(1).collect()
        }
        Notation::Number => Vec::new(),
        Notation::International => SpaceGroup::from_symbol(text).unwrap_or_default(),
        Notation::Schoenflies => {
            let wanted = choice.trim();
            let chosen = |group: &&SpaceGroup| match group.choice {
                _ if wanted.is_empty() => group.standard,
                Some(choice) => wanted.eq_ignore_ascii_case(&choice.to_string()),
                None => false,
            };
            let known = SpaceGroup::from_schoenflies(name);
            known.into_iter().filter(chosen).collect()
        }
        Notation::Hall => SpaceGroup::from_hall(text).into_iter().collect(),
        Notation::Geometric => {
            let found = SpaceGroupGenerators::from_symbol(text).ok();
            let group = found.and_then(|group| SpaceGroup::standard(group.number));
            group.into_iter().collect()
        }
    }
}

/// What is said of a text that means nothing, with the nearest that does.
fn unknown(text: &str, notation: Option<Notation>) -> Failure {
    let is_point = PointGroup::from_geometric(text).is_ok()
        || CrystalClass::from_international(text).is_ok()
        || CrystalClass::from_schoenflies(text).is_ok();
    if is_point && notation.is_none() {
        return Failure::Usage(format!(
            "`{}` is no space group but a point group: --point tells of it",
            short(text)
        ));
    }
    // Marks that only geometric symbols have.
    let looks_geometric = text.contains("b(") || text.contains('\u{305}');
    let is_geometric = match notation {
        None => looks_geometric,
        Some(asked) => asked == Notation::Geometric,
    };
    if let (true, Err(error)) = (is_geometric, SpaceGroupGenerators::from_symbol(text)) {
        return Failure::Usage(error.to_string());
    }
    Failure::Usage(match (SpaceGroup::find(text), notation) {
        (Err(error), _) => format!("{error}{}", larger_cell(text)),
        // It is known, only not in the notation that was asked for.
        (Ok(_), Some(asked)) => {
            let (text, asked) = (short(text), asked.name());
            format!("`{text}` is no {asked}; leave --notation out")
        }
        (Ok(_), None) => format!("unknown space group `{}`", short(text)),
    })
}

/// What is added for the symbol of a tetragonal group in a larger cell, such as `C 4/m m m`.
fn larger_cell(text: &str) -> &'static str {
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut letters = plain.chars();
    let letter = letters.next().map(|c| c.to_ascii_uppercase());
    let is_fourfold = letters.as_str().trim_start_matches('-').starts_with('4');
    match letter {
        Some('C') if is_fourfold => {
            "; C is a larger cell of a tetragonal group: give its symbol with P, in the cell whose axes are \
             along the diagonals of this one, or its Hall symbol, such as `-C 4 2` for `C 4/m m m`"
        }
        // With a 3 it is meant to be cubic.
        Some('F') if is_fourfold && !plain.contains('3') => {
            "; F is a larger cell of a tetragonal group: give its symbol with I, in the cell whose axes are \
             along the diagonals of this one, or its Hall symbol"
        }
        _ => "",
    }
}

/// What a Hall symbol means whose setting is in no table.
fn unlisted(text: &str) -> Option<Found> {
    let setting = Recognition::of_hall(text)?;
    Some(Found {
        group: SpaceGroup::standard(setting.number)?,
        unlisted: Some(Unlisted {
            hall: text.trim().to_owned(),
            setting,
        }),
        notation: Notation::Hall,
        others: Vec::new(),
        also: Vec::new(),
    })
}

/// The group of fewer translations that a text means, and the other settings that it fits.
pub fn subperiodic(
    kind: SubperiodicKind,
    text: &str,
) -> Result<(&'static SubperiodicGroup, Vec<&'static SubperiodicGroup>), Failure> {
    let mistake = match SubperiodicGroup::from_symbol(kind, text) {
        Ok(found) => match found.as_slice() {
            [group, others @ ..] => {
                let is_number = text.trim().parse::<u32>().is_ok();
                let others = if is_number { &[] } else { others };
                return Ok((*group, others.to_vec()));
            }
            [] => format!("unknown {kind} group `{}`", short(text)),
        },
        Err(error) => error.to_string(),
    };
    // Only what is no symbol either, as the orbifold symbol 442 is one, can be a wrong number.
    check_number(&kind.to_string(), kind.count(), text)?;
    Err(Failure::Usage(mistake))
}

/// Refuses a number that no group of the kind has.
fn check_number(kind: &str, count: u32, text: &str) -> Result<(), Failure> {
    let name = text.split(':').next().unwrap_or_default().trim();
    let digits = name.strip_prefix(['-', '+']).unwrap_or(name);
    let is_whole = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit());
    match name.parse::<u32>() {
        Ok(number) if (1..=count).contains(&number) => Ok(()),
        _ if is_whole => Err(Failure::Usage(format!(
            "there is no {kind} group number {}: {kind} groups are numbered from 1 to {count}",
            short(name)
        ))),
        _ => Ok(()),
    }
}

/// Refuses what stands after a colon and is no choice of origin or axes: 1, 2, H, R, or axes such as `b1`.
fn check_choice(text: &str) -> Result<(), Failure> {
    let Some((name, choice)) = text.split_once(':') else {
        return Ok(());
    };
    let number = name.trim().parse::<u32>().ok();
    if let (Some(number), Err(_)) = (number, SpaceGroup::find(text)) {
        let remedy = match number {
            3..=15 => "its unique axis, b, c or a, and the choice of its cell, such as c or b1",
            _ => "the choice of its origin, 1 or 2, or of its axes, H or R, if it has one",
        };
        return Err(Failure::Usage(format!(
            "`{}`: group {number} has no setting of this name; after the colon stands {remedy}",
            short(text),
        )));
    }
    let first = choice.trim().trim_start_matches('-').chars().next();
    let first = first.map(|c| c.to_ascii_lowercase());
    match first {
        Some('1' | '2' | 'h' | 'r' | 'a' | 'b' | 'c') => Ok(()),
        _ => Err(Failure::Usage(format!(
            "`{}`: after the colon stands the choice of origin, 1 or 2, or of axes, H or R, not `{}`",
            short(text),
            short(choice)
        ))),
    }
}

/// A text, shortened when long.
pub fn short(text: &str) -> String {
    text.chars().take(40).collect()
}
