//! Whether the symmetry elements of well-known groups have the symbols, numbers and places of
//! International Tables.

use std::collections::BTreeMap;

use ga_design::crystallography::symmetry_elements::{Fraction, LatticeLine, LatticePlane};
use ga_design::crystallography::{SpaceGroup, SymmetryElements};

fn setting(symbol: &str) -> &'static SpaceGroup {
    SpaceGroup::from_symbol(symbol).expect("a known symbol")[0]
}

fn elements(group: &SpaceGroup) -> SymmetryElements {
    let operations = group.operations().expect("a Hall symbol of the table");
    SymmetryElements::of(&operations).expect("a space group")
}

fn part(text: &str) -> Fraction {
    match text.split_once('/') {
        Some((n, d)) => Fraction::new(n.parse().expect("a number"), d.parse().expect("a number")),
        None => Fraction::from(text.parse::<i64>().expect("a number")),
    }
}

fn point(text: &str) -> [Fraction; 3] {
    let parts: Vec<_> = text.split(',').map(part).collect();
    parts.try_into().expect("three parts")
}

/// The symbols of the elements in one cell and how often each occurs, as the diagrams of International
/// Tables A have them: inversion centres with those on axes, planes by their letters.
const COUNTED: [(&str, &str); 16] = [
    ("P -1", "-1:8"),
    ("P 1 21/c 1", "-1:8 2_1:4 c:2"),
    ("C 1 2/c 1", "-1:16 2:4 2_1:4 c:2 n:2"),
    ("P 21 21 21", "2_1:12"),
    ("P n m a", "-1:8 2_1:8 2_1/m:4 a:2 m:2 n:2"),
    ("P 31 2 1", "2:6 2_1:6 3_1:3"),
    ("P 32 2 1", "2:6 2_1:6 3_2:3"),
    ("P 41 21 2", "2:4 2_1:14 4_1:2"),
    ("P 43 21 2", "2:4 2_1:14 4_3:2"),
    ("I 41/a", "-1:16 -4:4 4_1:2 4_3:2 a:2 b:2"),
    ("R -3 c", "-1:24 -3:3 2:18 2_1:18 3_1:3 3_2:3 c:3 n:3"),
    (
        "P 63/m m c",
        "-1:8 -6:2 2:6 2/m:6 2_1:6 2_1/m:9 6_3/m:1 c:3 b:3 m:5 n:3",
    ),
    ("P 6/m m m", "-1:8 -6:2 2/m:15 2_1/m:12 6/m:1 a:3 b:3 m:8"),
    ("P a -3", "-1:8 -3:4 2_1:12 3_1:4 3_2:4 a:2 b:2 c:2"),
    (
        "F d -3 m",
        "-1:32 -3:16 -4:24 2/m:24 2_1/m:24 3_1:16 3_2:16 4_1:12 4_3:12 d:12 g:12 m:12",
    ),
    (
        "I a -3 d",
        "-1:16 -3:4 -4:12 2:24 2_1:24 3_1:4 3_2:4 4_1:6 4_3:6 a:4 b:4 c:4 d:12",
    ),
];

#[test]
fn the_elements_of_well_known_groups_are_counted_as_drawn() {
    for (symbol, expected) in COUNTED {
        let found = elements(setting(symbol));
        let mut wanted = BTreeMap::new();
        for entry in expected.split(' ') {
            let (name, count) = entry.rsplit_once(':').expect("name:count");
            wanted.insert(name.to_owned(), count.parse().expect("a number"));
        }
        assert_eq!(found.counts(), wanted, "{symbol}");
    }
}

/// Elements by symbol, direction or plane, and a point of it, from the lists of symmetry operations
/// and Wyckoff positions of International Tables A.
const AXES: [(&str, &str, [i64; 3], &str); 24] = [
    ("P 1 21/c 1", "2_1", [0, 1, 0], "0,0,1/4"),
    ("C 1 2/c 1", "2", [0, 1, 0], "0,0,1/4"),
    ("C 1 2/c 1", "2_1", [0, 1, 0], "1/4,0,1/4"),
    ("P 21 21 21", "2_1", [0, 0, 1], "1/4,0,0"),
    ("P 21 21 21", "2_1", [0, 1, 0], "0,0,1/4"),
    ("P 21 21 21", "2_1", [1, 0, 0], "0,1/4,0"),
    ("P n m a", "2_1", [0, 0, 1], "1/4,0,0"),
    ("P n m a", "2_1/m", [0, 1, 0], "0,0,0"),
    ("P n m a", "2_1", [1, 0, 0], "0,1/4,1/4"),
    ("P 31 2 1", "3_1", [0, 0, 1], "0,0,0"),
    ("P 31 2 1", "2", [1, 1, 0], "0,0,0"),
    ("P 31 2 1", "2", [1, 0, 0], "0,0,1/3"),
    ("P 31 2 1", "2", [0, 1, 0], "0,0,1/6"),
    ("P 41 21 2", "4_1", [0, 0, 1], "0,1/2,0"),
    ("P 41 21 2", "2_1", [0, 0, 1], "0,0,0"),
    ("P 41 21 2", "2", [1, 1, 0], "0,0,0"),
    ("I 41/a :1", "-4", [0, 0, 1], "0,0,0"),
    ("I 41/a :2", "-4", [0, 0, 1], "0,1/4,1/8"),
    ("R -3 c", "-3", [0, 0, 1], "0,0,0"),
    ("P 63/m m c", "-6", [0, 0, 1], "1/3,2/3,1/4"),
    ("P a -3", "-3", [1, 1, 1], "0,0,0"),
    ("F d -3 m :2", "-4", [0, 0, 1], "1/8,1/8,1/8"),
    ("F d -3 m :2", "-3", [1, 1, 1], "0,0,0"),
    ("I a -3 d", "-4", [1, 0, 0], "3/8,0,1/4"),
];

const PLANES: [(&str, char, [i64; 3], &str, &str); 9] = [
    ("P 1 21/c 1", 'c', [0, 1, 0], "0,1/4,0", "0,0,1/2"),
    ("C 1 2/c 1", 'c', [0, 1, 0], "0,0,0", "0,0,1/2"),
    ("C 1 2/c 1", 'n', [0, 1, 0], "0,1/4,0", "1/2,0,1/2"),
    ("P n m a", 'a', [0, 0, 1], "0,0,1/4", "1/2,0,0"),
    ("P n m a", 'm', [0, 1, 0], "0,1/4,0", ""),
    ("P n m a", 'n', [1, 0, 0], "1/4,0,0", "0,1/2,1/2"),
    ("C m c e", 'e', [0, 0, 1], "0,0,1/4", "1/2,0,0"),
    ("F d d 2", 'd', [1, 0, 0], "1/8,0,0", "0,1/4,1/4"),
    ("I 41 m d", 'd', [1, -1, 0], "1/4,0,0", "1/4,1/4,-1/4"),
];

#[test]
fn elements_lie_where_the_tables_say() {
    for (symbol, name, direction, place) in AXES {
        let found = elements(setting(symbol));
        let line = LatticeLine::through(direction, point(place)).expect("a line");
        let axis = found.axes().iter().find(|axis| axis.line() == line);
        let axis = axis.unwrap_or_else(|| panic!("{symbol}: no axis {direction:?} at {place}"));
        assert_eq!(axis.to_string(), name, "{symbol}: {direction:?} at {place}");
        if name.starts_with('-') {
            let points = axis.inversion_points();
            assert!(
                points.contains(&point(place)),
                "{symbol} {place}: {points:?}"
            );
        }
    }
    for (symbol, letter, normal, place, glide) in PLANES {
        let found = elements(setting(symbol));
        let wanted = LatticePlane::through(normal, point(place)).expect("a plane");
        let plane = found.planes().iter().find(|plane| plane.place() == wanted);
        let plane = plane.unwrap_or_else(|| panic!("{symbol}: no plane {normal:?} at {place}"));
        assert_eq!(plane.letter(), letter, "{symbol}: {normal:?} at {place}");
        match glide {
            "" => assert!(plane.glides().is_empty()),
            glide => assert_eq!(plane.glides()[0], point(glide), "{symbol}"),
        }
    }
}

#[test]
fn screws_of_the_enantiomorphic_pairs_have_opposite_senses() {
    // Number, its partner, the principal screws of the first and of the second.
    let pairs = [
        (76, 78, "4_1", "4_3"),
        (91, 95, "4_1", "4_3"),
        (92, 96, "4_1", "4_3"),
        (144, 145, "3_1", "3_2"),
        (151, 153, "3_1", "3_2"),
        (152, 154, "3_1", "3_2"),
        (169, 170, "6_1", "6_5"),
        (171, 172, "6_2", "6_4"),
        (178, 179, "6_1", "6_5"),
        (180, 181, "6_2", "6_4"),
        (213, 212, "4_1", "4_3"),
    ];
    for (one, other, right, left) in pairs {
        for (number, there, absent) in [(one, right, left), (other, left, right)] {
            let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
            let counts = elements(group).counts();
            assert!(counts.contains_key(there), "{number}: {counts:?}");
            assert!(!counts.contains_key(absent), "{number}: {counts:?}");
        }
    }
}
