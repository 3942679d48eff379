//! Whether the plane groups have the rotation centres and mirrors of their orbifold symbols:
//! J. H. Conway, *Structural Chemistry* 13 (2002) 247.

use std::collections::BTreeSet;

use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind, SubperiodicOperation};

/// Points of the cell in twelfths: every rotation centre is one.
type Place = [i32; 2];

fn image(operation: &SubperiodicOperation, place: Place) -> Place {
    let w = operation.rotation();
    let shift = operation.translation();
    [0, 1].map(|i| {
        let moved = w[i][0] * place[0] + w[i][1] * place[1];
        (moved + (shift[i] * 12).to_integer()).rem_euclid(12)
    })
}

/// The orders of the centres without mirrors, then of those on mirrors, one for each orbit.
fn centres(operations: &[SubperiodicOperation]) -> (Vec<usize>, Vec<usize>) {
    let mut seen = BTreeSet::new();
    let (mut gyrations, mut corners) = (Vec::new(), Vec::new());
    for place in (0..144).map(|at| [at / 12, at % 12]) {
        if seen.contains(&place) {
            continue;
        }
        seen.extend(operations.iter().map(|operation| image(operation, place)));
        let fixing: Vec<_> = operations
            .iter()
            .filter(|o| image(o, place) == place)
            .collect();
        let turns = fixing
            .iter()
            .filter(|o| o.in_space().determinant() > 0)
            .count();
        if turns < 2 {
            continue;
        }
        if turns == fixing.len() {
            gyrations.push(turns);
        } else {
            corners.push(turns);
        }
    }
    gyrations.sort_unstable_by(|a, b| b.cmp(a));
    corners.sort_unstable_by(|a, b| b.cmp(a));
    (gyrations, corners)
}

#[test]
fn every_plane_group_has_the_centres_of_its_orbifold_symbol() {
    let symbols = [
        "o", "2222", "**", "xx", "*x", "*2222", "22*", "22x", "2*22", "442", "*442", "4*2", "333",
        "*333", "3*3", "632", "*632",
    ];
    for (number, symbol) in (1..).zip(symbols) {
        let group = SubperiodicGroup::standard(SubperiodicKind::Plane, number).expect("1 to 17");
        let found = SubperiodicGroup::from_symbol(SubperiodicKind::Plane, symbol)
            .unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(found[0], group, "{symbol}");
        let digits = |text: &str| -> Vec<usize> {
            text.chars()
                .filter_map(|c| c.to_digit(10))
                .map(|digit| digit as usize)
                .collect()
        };
        let (before, after) = symbol.split_once('*').unwrap_or((symbol, ""));
        let operations = group.operations().expect("a Hall symbol of the table");
        assert_eq!(
            centres(&operations),
            (digits(before), digits(after)),
            "{symbol}"
        );
        // A star is a mirror: a reflection that some translation by the lattice makes plain.
        let mirror = |o: &SubperiodicOperation| {
            let twice = o
                .then(o)
                .map(|two| two == *o || two.in_space().is_translation());
            let plain = (0..144).any(|at| image(o, [at / 12, at % 12]) == [at / 12, at % 12]);
            twice == Some(true) && plain && o.in_space().determinant() < 0
        };
        assert_eq!(
            operations.iter().any(mirror),
            symbol.contains('*'),
            "{symbol}"
        );
    }
}
