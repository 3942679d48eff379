//! Which symmetry elements a group has besides those of its full symbol: the extended
//! Hermann–Mauguin symbol (*International Tables* A, 1.5.4).
//!
//! A centred lattice, and already the lattice translations oblique to an axis, put further axes
//! and planes between those that the symbol names. They are found from the operations: for every
//! symmetry direction of the symbol, the screw and glide parts of all operations along it.

use std::collections::BTreeSet;

use super::super::direction::{self, Direction, signless};
use super::super::operation::{DENOMINATOR, Operation};
use super::super::symmetry_directions::symmetry_directions;
use super::{CrystalSystem, SpaceGroup};

/// The settings of a symbol with further elements in brackets, which they all have.
///
/// `None` for anything else: in `P2(1)/c` the brackets are another spelling of a subscript.
pub fn find(symbol: &str) -> Option<Vec<&'static SpaceGroup>> {
    let (first, second) = symbol.split_once('(')?;
    let (further, suffix) = second.rsplit_once(':').unwrap_or((second, ""));
    let mut found = SpaceGroup::from_symbol(&format!("{first}:{suffix}")).ok()?;
    found.retain(|group| group.has_further(further));
    (!found.is_empty()).then_some(found)
}

impl SpaceGroup {
    /// The extended Hermann–Mauguin symbol: the full symbol, then in brackets the further axes and
    /// planes, in the order of the symmetry directions, lines parted by semicolons.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// let symbol = |number| SpaceGroup::standard(number).map(|group| group.extended_symbol());
    /// assert_eq!(symbol(15).as_deref(), Some("C 1 2/c 1 (21/n)"));
    /// assert_eq!(symbol(63).as_deref(), Some("C 2/m 2/c 21/m (21/b 21/n n)"));
    /// assert_eq!(symbol(99).as_deref(), Some("P 4 m m (g)"));
    /// ```
    pub fn extended_symbol(&self) -> String {
        let full = self.full_symbol();
        let further = self.further_elements();
        let most = further.iter().map(Further::lines).max().unwrap_or(0);
        let lines: Vec<String> = (0..most)
            .map(|line| {
                let words: Vec<String> = further.iter().filter_map(|all| all.word(line)).collect();
                words.join(" ")
            })
            .collect();
        match lines.as_slice() {
            [] => full.to_owned(),
            some => format!("{full} ({})", some.join("; ")),
        }
    }

    /// Whether all the words of a second line, such as `21/b` or `n`, are elements that
    /// [`SpaceGroup::extended_symbol`] lists.
    fn has_further(&self, words: &str) -> bool {
        let further = self.further_elements();
        let known = |word: &str| {
            further.iter().any(|all| {
                let axis = all.axes.iter().any(|axis| axis == word);
                axis || all.planes.iter().any(|plane| word.chars().eq([*plane]))
            })
        };
        words
            .split(|c: char| c.is_whitespace() || matches!(c, ';' | ',' | '/' | '(' | ')'))
            .filter(|word| !word.is_empty())
            .all(|word| known(&word.to_ascii_lowercase().replace('_', "")))
    }

    fn further_elements(&self) -> Vec<Further> {
        let operations = self.operations().unwrap_or_default();
        let tokens = self.full_symbol().split(' ').skip(1);
        tokens
            .zip(self.directions())
            .map(|(token, direction)| self.further(token, direction, &operations))
            .collect()
    }

    /// The symmetry direction of each place of the symbol.
    fn directions(&self) -> Vec<Direction> {
        match self.crystal_system() {
            // The symbols that this is about are full, with a place for each axis.
            CrystalSystem::Monoclinic => vec![[1, 0, 0], [0, 1, 0], [0, 0, 1]],
            CrystalSystem::Trigonal if self.choice == Some('R') => vec![[1, 1, 1], [1, -1, 0]],
            system => symmetry_directions(system)
                .iter()
                .filter_map(|class| class.first().copied())
                .collect(),
        }
    }

    /// The axes and planes along a direction that the token does not name.
    fn further(&self, token: &str, direction: Direction, operations: &[Operation]) -> Further {
        let along: Vec<&Operation> = operations
            .iter()
            .filter(|operation| direction::axis(operation) == Some(signless(direction)))
            .collect();
        let highest = along
            .iter()
            .filter(|operation| operation.determinant() > 0)
            .map(|operation| direction::order(operation))
            .max();
        // Every lattice puts 3₁ and 3₂ beside the threefold axes of a cube: no symbol says so.
        let listed = self.crystal_system() != CrystalSystem::Cubic || highest != Some(3);
        let mut axes = BTreeSet::new();
        let mut planes = BTreeSet::new();
        for operation in along {
            for step in steps() {
                let proper = operation.determinant() > 0;
                if proper && listed && Some(direction::order(operation)) == highest {
                    axes.extend(screw(operation, step, direction, operations));
                } else if !proper && direction::order(operation) == 2 {
                    planes.extend(self.glide(operation, step, direction));
                }
            }
        }
        let (axis, plane) = match token.split_once('/') {
            Some((axis, plane)) => (axis, plane),
            None => (token, token),
        };
        axes.remove(axis.trim_start_matches('-'));
        if token.starts_with("-4") || token.starts_with("-6") {
            // A fourfold or sixfold rotoinversion names the axis that it is the square of, and
            // the plane across.
            return Further::default();
        }
        let named: &[char] = match plane.chars().next() {
            Some('e') => &['a', 'b', 'c'],
            Some(letter) => &[letter],
            None => &[],
        };
        planes.retain(|letter| !named.contains(letter));
        Further {
            axes: axes.into_iter().collect(),
            planes: planes.into_iter().collect(),
        }
    }

    /// The letter of the glide plane of a reflection followed by a lattice step; `None` for a glide
    /// by thirds, which only a rhombohedral lattice makes and no symbol names.
    fn glide(&self, operation: &Operation, step: Direction, normal: Direction) -> Option<char> {
        let twice = sum_of_powers(operation, step, 2);
        // The two conventional directions in the plane, and the letter of half the first.
        let hexagonal = matches!(
            self.crystal_system(),
            CrystalSystem::Trigonal | CrystalSystem::Hexagonal
        ) && self.choice != Some('R');
        let (u, v, half): (Direction, Direction, char) = match normal {
            [1, 0, 0] if hexagonal => ([1, 2, 0], [0, 0, 1], 'b'),
            [1, -1, 0] if hexagonal => ([1, 1, 0], [0, 0, 1], 'a'),
            [1, 0, 0] => ([0, 1, 0], [0, 0, 1], 'b'),
            [0, 1, 0] => ([1, 0, 0], [0, 0, 1], 'a'),
            [0, 0, 1] => ([1, 0, 0], [0, 1, 0], 'a'),
            _ => ([1, 1, 0], [0, 0, 1], 'g'),
        };
        let other = if normal == [0, 0, 1] { 'b' } else { 'c' };
        // Twice the glide is p u + q v, each modulo twice a lattice translation of the plane.
        let part = |along: Direction, across: Direction| {
            let place = (0..3)
                .find(|i| along[*i] != 0 && across[*i] == 0)
                .unwrap_or(0);
            (twice[place] / along[place]).rem_euclid(2 * DENOMINATOR)
        };
        let (p, q) = (part(u, v), part(v, u));
        let whole = |value: i32| value % DENOMINATOR == 0;
        let odd = |value: i32| (value / DENOMINATOR) % 2 == 1;
        let quarters = |value: i32| (2 * value) % DENOMINATOR == 0;
        match (whole(p) && whole(q), odd(p), odd(q)) {
            (true, false, false) => Some('m'),
            (true, true, false) => Some(half),
            (true, false, true) => Some(other),
            (true, true, true) => Some('n'),
            // A quarter of both: the diamond glide.
            _ if quarters(p) && quarters(q) && !whole(p) && !whole(q) => Some('d'),
            _ if quarters(p) && quarters(q) => Some('g'),
            _ => None,
        }
    }
}

/// What stands along one direction besides what the symbol names there.
#[derive(Default)]
struct Further {
    axes: Vec<String>,
    planes: Vec<char>,
}

impl Further {
    fn lines(&self) -> usize {
        self.axes.len().max(self.planes.len())
    }

    fn word(&self, line: usize) -> Option<String> {
        match (self.axes.get(line), self.planes.get(line)) {
            (Some(axis), Some(plane)) => Some(format!("{axis}/{plane}")),
            (Some(axis), None) => Some(axis.clone()),
            (None, Some(plane)) => Some(plane.to_string()),
            (None, None) => None,
        }
    }
}

/// The symbol of the axis of a rotation followed by a lattice step: `4`, `42`.
fn screw(
    operation: &Operation,
    step: Direction,
    direction: Direction,
    operations: &[Operation],
) -> Option<String> {
    let order = direction::order(operation);
    let along = sum_of_powers(operation, step, order);
    let place = direction.iter().position(|value| *value != 0)?;
    let shift = along.get(place)? / direction.get(place)?;
    let shortest = shortest_translation(direction, operations);
    // The sense of the rotation about the direction, which decides between 3₁ and 3₂.
    let turn = sense(operation, direction) * shift / shortest;
    match turn.rem_euclid(order) {
        0 => Some(order.to_string()),
        part => Some(format!("{order}{part}")),
    }
}

/// 1 for a rotation that turns right-handedly about the direction by less than half a turn, −1
/// for its inverse.
fn sense(operation: &Operation, direction: Direction) -> i32 {
    let w = direction::proper(operation);
    let determinant = |u: Direction, v: Direction| {
        (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                direction[i] * (u[j] * v[k] - u[k] * v[j])
            })
            .sum::<i32>()
    };
    let edges: [Direction; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let area = edges
        .into_iter()
        .map(|edge| determinant(edge, direction::image(&w, edge)))
        .find(|area| *area != 0);
    area.map_or(1, i32::signum)
}

/// The length of the shortest translation along a direction, in units of one over
/// [`DENOMINATOR`] of the direction.
fn shortest_translation(direction: Direction, operations: &[Operation]) -> i32 {
    let translation = |fraction: i32| {
        let shift = direction.map(|part| (part * DENOMINATOR / fraction).rem_euclid(DENOMINATOR));
        operations
            .iter()
            .any(|operation| operation.is_translation() && operation.translation_units() == shift)
    };
    let fraction = [3, 2].into_iter().find(|fraction| translation(*fraction));
    DENOMINATOR / fraction.unwrap_or(1)
}

/// The translation of the power `order` of an operation followed by a lattice step, not reduced.
fn sum_of_powers(operation: &Operation, step: Direction, order: i32) -> [i32; 3] {
    let w = operation.rotation();
    let units = operation.translation_units();
    let mut term = [0, 1, 2].map(|i| units[i] + step[i] * DENOMINATOR);
    let mut sum = [0; 3];
    for _ in 0..order {
        for (total, part) in sum.iter_mut().zip(term) {
            *total += part;
        }
        term = direction::image(&w, term);
    }
    sum
}

/// The lattice steps that can change a screw or glide part: to the corners around.
fn steps() -> impl Iterator<Item = Direction> {
    let ends = [-1, 0, 1];
    ends.into_iter()
        .flat_map(move |i| ends.into_iter().map(move |j| (i, j)))
        .flat_map(move |(i, j)| ends.into_iter().map(move |k| [i, j, k]))
}
