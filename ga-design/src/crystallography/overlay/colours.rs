//! Which colour an element has, and how a caption tells it.

use crate::crystallography::SymmetryElements;
use crate::crystallography::symmetry_elements::Axis;

/// A colour and the word for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour {
    pub(super) name: &'static str,
    pub(super) rgb: [u8; 3],
}

const fn colour(name: &'static str, rgb: [u8; 3]) -> Colour {
    Colour { name, rgb }
}

/// Inversion centres.
pub(super) const CENTRE: Colour = colour("white", [246, 247, 250]);

/// The colour of an axis: by its order.
pub(super) fn of_axis(axis: &Axis) -> Colour {
    match axis.rotoinversion().unwrap_or(axis.order()) {
        2 => colour("blue", [38, 104, 178]),
        3 => colour("green", [24, 150, 112]),
        4 => colour("orange", [226, 112, 36]),
        _ => colour("violet", [138, 72, 170]),
    }
}

/// The colour of a plane by its letter.
pub(super) fn of_plane(letter: char) -> Colour {
    match letter {
        'm' => colour("slate", [72, 92, 124]),
        'n' => colour("pink", [204, 92, 140]),
        'd' => colour("red", [190, 52, 56]),
        _ => colour("yellow", [224, 168, 40]),
    }
}

/// The elements of one cell with their numbers and colours, in a sentence for a caption.
///
/// ```
/// use ga_design::crystallography::{SpaceGroup, SymmetryElements, overlay};
///
/// let group = SpaceGroup::from_symbol("P n m a")?[0];
/// let elements = SymmetryElements::of(&group.operations()?)?;
/// assert_eq!(
///     overlay::legend(&elements),
///     "Symmetry elements of one cell: 8 axes 2₁ (blue), 4 axes 2₁/m (blue), 2 planes a (yellow), \
///      2 planes m (slate), 2 planes n (pink), 8 inversion centres (white)."
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn legend(elements: &SymmetryElements) -> String {
    let mut entries: Vec<(String, Colour, usize)> = Vec::new();
    let mut count = |name: String, colour: Colour| match entries
        .iter_mut()
        .find(|(known, ..)| *known == name)
    {
        Some((_, _, count)) => *count += 1,
        None => entries.push((name, colour, 1)),
    };
    let mut axes: Vec<_> = elements.axes().iter().collect();
    axes.sort_by_key(|axis| (axis.order(), axis.to_string()));
    for axis in axes {
        count(
            format!("axis {}", printed(&axis.to_string())),
            of_axis(axis),
        );
    }
    let mut planes: Vec<_> = elements.planes().iter().collect();
    planes.sort_by_key(|plane| plane.letter());
    for plane in planes {
        count(format!("plane {plane}"), of_plane(plane.letter()));
    }
    for _ in elements.centres() {
        count(String::from("inversion centre"), CENTRE);
    }
    if entries.is_empty() {
        return String::from("No symmetry elements but translations.");
    }
    let words = entries.iter().map(|(name, colour, count)| {
        let name = match (
            *count,
            name.strip_prefix("axis "),
            name.strip_prefix("plane "),
        ) {
            (1, ..) => name.clone(),
            (_, Some(symbol), _) => format!("axes {symbol}"),
            (_, _, Some(letter)) => format!("planes {letter}"),
            _ => format!("{name}s"),
        };
        format!("{count} {name} ({})", colour.name)
    });
    let list = words.collect::<Vec<_>>().join(", ");
    format!("Symmetry elements of one cell: {list}.")
}

/// A symbol as in print: the number of the screw below the line.
fn printed(symbol: &str) -> String {
    let mut lowered = false;
    let digits = symbol.chars().filter_map(|letter| {
        let below = lowered;
        lowered = letter == '_';
        match (letter, below) {
            ('_', _) => None,
            ('1'..='5', true) => {
                char::from_u32(u32::from('₁') + u32::from(letter) - u32::from('1'))
            }
            _ => Some(letter),
        }
    });
    digits.collect()
}
