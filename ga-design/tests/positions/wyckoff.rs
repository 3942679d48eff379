//! Whether multiplicities, site symmetries, triplets and letters are those of International
//! Tables, by the table and by the program moyo, in every setting.

use std::collections::BTreeMap;

use ga_design::crystallography::{
    Cell, ChangeOfBasis, Operation, SpaceGroup, WyckoffPosition, WyckoffPositions,
};
use moyo::data::{hall_symbol_entry, iter_wyckoff_positions_from_hall_number};

const TABLE: &str = include_str!("../../data/wyckoff.tsv");

fn positions(group: &SpaceGroup) -> WyckoffPositions {
    group
        .wyckoff_positions()
        .unwrap_or_else(|| panic!("no positions for {}", group.qualified_symbol()))
}

#[test]
fn all_1731_rows_agree_with_what_the_operations_say() {
    let mut wrong = Vec::new();
    let mut rows = 0;
    for number in 1..=230 {
        let all = WyckoffPositions::standard(number).expect("1 to 230");
        let prefix = format!("{number}\t");
        let table: Vec<Vec<&str>> = TABLE
            .lines()
            .filter(|line| line.starts_with(&prefix))
            .map(|line| line.split('\t').collect())
            .collect();
        assert_eq!(table.len(), all.positions().len(), "group {number}");
        for (row, position) in table.iter().zip(all.positions()) {
            rows += 1;
            let said = (row[1], row[2], row[3], row[4]);
            let found = (
                position.letter.to_string(),
                position.multiplicity.to_string(),
                position.site_symmetry.as_str(),
                position.representative().to_string(),
            );
            if said != (&found.0, &found.1, found.2, &found.3) {
                wrong.push(format!("{number} {said:?} {found:?}"));
            }
        }
    }
    assert_eq!(rows, 1731);
    assert!(wrong.is_empty(), "{}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn site_groups_are_groups_and_cosets_count() {
    for group in SpaceGroup::table() {
        let order = group.operations().expect("a Hall symbol").len();
        let all = positions(group);
        for position in all.positions() {
            let site = position.site_group();
            assert_eq!(site.len() * position.multiplicity, order);
            let closed = ga_design::crystallography::close(site).expect("a finite group");
            assert_eq!(closed.len(), site.len());
            // Every operation of the site group keeps the place, whatever the variables.
            let place = position.representative().at([0.137, 0.291, 0.403]);
            for operation in site {
                let moved = operation.apply(place);
                let off = moved
                    .iter()
                    .zip(place)
                    .map(|(a, b)| (a - b) - (a - b).round());
                assert!(off.into_iter().all(|value| value.abs() < 1e-12));
            }
        }
        let general = all.positions().last().expect("never empty");
        assert_eq!((general.dimension(), general.multiplicity), (3, order));
    }
}

/// The settings of the table that have exactly the operations of a Hall entry of moyo.
fn setting_of(hall_number: i32) -> &'static SpaceGroup {
    let entry = hall_symbol_entry(hall_number).expect("530 entries");
    let hall = entry.hall_symbol.replace('^', "'").replace('=', "\"");
    let mut named = SpaceGroup::table()
        .iter()
        .filter(|group| group.hall == hall);
    // Group 68 has pairs of settings with the same operations and other letters; the second of
    // them exchanges two axes, which moyo writes with a minus sign.
    let named = if entry.setting.contains('-') {
        named.next_back()
    } else {
        named.next()
    };
    named.unwrap_or_else(|| {
        let operations = ga_design::crystallography::hall::operations(&hall).expect("a symbol");
        SpaceGroup::identify(&operations).expect("a known setting")
    })
}

/// A cell that fits the metric of a group's standard setting, carried to the setting.
fn cell_of(group: &SpaceGroup) -> Cell {
    let (edges, angles) = match group.number {
        1..=2 => ([5.1, 6.3, 7.7], [83.0, 97.0, 101.0]),
        3..=15 => ([5.1, 6.3, 7.7], [90.0, 101.0, 90.0]),
        16..=74 => ([5.1, 6.3, 7.7], [90.0; 3]),
        75..=142 => ([5.1, 5.1, 7.7], [90.0; 3]),
        143..=194 => ([5.1, 5.1, 7.7], [90.0, 90.0, 120.0]),
        _ => ([5.1; 3], [90.0; 3]),
    };
    let standard = Cell::new(edges, angles).expect("a cell");
    let change = group.from_standard().expect("a setting of the table");
    let vectors = change.linear();
    let edges = [0, 1, 2].map(|j| {
        standard.cartesian(vectors.map(|row| *row[j].numer() as f64 / *row[j].denom() as f64))
    });
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let lengths = edges.map(|edge| dot(edge, edge).sqrt());
    let angle = |i: usize, j: usize| {
        (dot(edges[i], edges[j]) / (lengths[i] * lengths[j]))
            .acos()
            .to_degrees()
    };
    Cell::new(lengths, [angle(1, 2), angle(2, 0), angle(0, 1)]).expect("a cell")
}

/// The values of a triplet such as `x,-x+1/4,2z` of moyo, read independently.
fn evaluated(triplet: &str, variables: [f64; 3]) -> [f64; 3] {
    let mut place = [0.0; 3];
    for (value, sum) in place.iter_mut().zip(triplet.split(',')) {
        for term in sum
            .replace('-', "+-")
            .split('+')
            .filter(|term| !term.is_empty())
        {
            let (sign, term) = match term.strip_prefix('-') {
                Some(rest) => (-1.0, rest),
                None => (1.0, term),
            };
            let (factor, variable) = match term.find(['x', 'y', 'z']) {
                Some(at) => (
                    &term[..at],
                    variables[usize::from(term.as_bytes()[at] - b'x')],
                ),
                None => (term, 1.0),
            };
            let size = match factor.split_once('/') {
                Some((above, below)) => {
                    above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("one")
                }
                None if factor.is_empty() => 1.0,
                None => factor.parse().expect("a number"),
            };
            *value += sign * size * variable;
        }
    }
    place
}

fn sorted(symbol: &str) -> Vec<char> {
    let mut all: Vec<char> = symbol.chars().collect();
    all.sort_unstable();
    all
}

#[test]
fn site_symmetries_turn_with_the_axes() {
    let cases = [
        ("P 2 2 21", 'a', "2.."),
        ("P 21 2 2", 'a', ".2."),
        ("P 2 21 2", 'a', "..2"),
        ("P m m 2", 'g', "m.."),
        ("P 2 m m", 'g', ".m."),
        ("P m 2 m", 'g', "..m"),
        ("C m m m", 'f', "..2/m"),
        ("A m m m", 'f', "2/m.."),
        ("C -4 2 m", 'a', "-42m"),
        ("R -3 m:R", 'd', ".2/m"),
        ("R -3 m:H", 'd', ".2/m"),
    ];
    for (symbol, letter, wanted) in cases {
        let group = SpaceGroup::from_symbol(symbol).expect("a symbol of the table")[0];
        let all = positions(group);
        let found = all
            .position(letter)
            .map(|position| position.site_symmetry.as_str());
        assert_eq!(found, Some(wanted), "{symbol} {letter}");
    }
}

#[test]
fn letters_and_site_symmetries_are_those_of_moyo_in_all_its_530_settings() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    for hall_number in 1..=530 {
        let group = setting_of(hall_number);
        let cell = cell_of(group);
        let all = positions(group);
        for theirs in iter_wyckoff_positions_from_hall_number(hall_number) {
            compared += 1;
            let place = evaluated(theirs.coordinates, [0.1371, 0.2917, 0.4033]);
            let site = all.locate(place, &cell, 1e-6).expect("a place");
            let ours = site.position;
            // moyo prints the symbols on the axes of the standard setting; on exchanged axes the
            // places of a symbol are exchanged as well.
            let standard = WyckoffPositions::standard(group.number).expect("1 to 230");
            let standard = standard.position(theirs.letter).expect("a letter of moyo");
            let symbol = match group.number {
                16..=74 => sorted(&ours.site_symmetry) == sorted(theirs.site_symmetry),
                _ => ours.site_symmetry == theirs.site_symmetry,
            };
            let same = ours.letter == theirs.letter
                && ours.multiplicity == theirs.multiplicity
                && standard.site_symmetry == theirs.site_symmetry
                && symbol
                && site.distance < 1e-9;
            if !same {
                wrong.push(format!(
                    "{hall_number} {} ({}): {} {} here, {}{} {} in moyo ({})",
                    group.qualified_symbol(),
                    group.number,
                    ours.symbol(),
                    ours.site_symmetry,
                    theirs.multiplicity,
                    theirs.letter,
                    theirs.site_symmetry,
                    theirs.coordinates,
                ));
            }
        }
    }
    assert_eq!(compared, 3467);
    assert!(
        wrong.is_empty(),
        "{} differ\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

#[test]
fn a_point_moved_off_a_site_snaps_back_to_it() {
    let mut checked = 0;
    for group in SpaceGroup::table()
        .iter()
        .filter(|group| group.number % 3 == 1)
    {
        let cell = cell_of(group);
        let all = positions(group);
        for position in all.positions() {
            for coordinates in position.coordinates().iter().take(5) {
                // In the cell of another corner, off by a hundredth of an ångström.
                let exact = coordinates.at([0.1371, 0.2917, 0.4033]);
                let shifted = [0, 1, 2].map(|i| exact[i] + [2.0, -1.0, 0.0][i]);
                let cart = cell.cartesian(shifted);
                let off = cell.fractional([cart[0] + 0.004, cart[1] - 0.006, cart[2] + 0.005]);
                let site = all.locate(off, &cell, 0.02).expect("a place");
                assert_eq!(
                    site.position.letter,
                    position.letter,
                    "{}",
                    group.qualified_symbol()
                );
                assert!(site.distance < 0.0088 + 1e-9);
                // The place is exactly on the triplet.
                let again = all.locate(site.place, &cell, 1e-9).expect("a place");
                assert_eq!(again.position.letter, position.letter);
                assert!(again.distance < 1e-12, "{}", again.distance);
                // The foot is nearer than where it came from, and off by right angles.
                let away = cell.cartesian([0, 1, 2].map(|i| off[i] - site.place[i]));
                let size = away.iter().map(|v| v * v).sum::<f64>().sqrt();
                assert!((size - site.distance).abs() < 1e-12);
                checked += 1;
            }
        }
    }
    assert!(checked > 2000, "{checked}");
}

#[test]
fn a_tolerance_decides_and_nonsense_is_refused() {
    let cell = Cell::new([5.64; 3], [90.0; 3]).expect("a cell");
    let all = WyckoffPositions::standard(225).expect("a number");
    let letter = |point: [f64; 3], tolerance: f64| {
        all.locate(point, &cell, tolerance)
            .map(|site| site.position.letter)
    };
    let point = [0.002, 0.0003, 0.0];
    assert_eq!(letter(point, 0.02), Some('a'));
    assert_eq!(letter(point, 0.002), Some('e'));
    assert_eq!(letter(point, 0.001), Some('j'));
    assert_eq!(letter([0.002, 0.001, 0.0005], 0.0), Some('l'));
    assert_eq!(letter([0.0, 0.0, 0.0], 0.0), Some('a'));
    assert_eq!(letter([f64::NAN, 0.0, 0.0], 0.1), None);
    assert_eq!(letter([f64::INFINITY, 0.0, 0.0], 0.1), None);
    assert_eq!(letter(point, f64::NAN), None);
    assert_eq!(letter(point, f64::INFINITY), None);
    assert_eq!(letter(point, -0.1), None);
    // Far beyond a tenth of the cell, a tolerance counts as that.
    assert_eq!(letter([0.24, 0.26, 0.22], 1000.0), Some('c'));
    assert_eq!(letter([0.12, 0.12, 0.12], 1000.0), Some('f'));
    assert_eq!(WyckoffPositions::standard(0), None);
    assert_eq!(WyckoffPositions::standard(231), None);
    let no_cell: ChangeOfBasis = "1/2x,y,z".parse().expect("a change");
    assert_eq!(WyckoffPositions::in_setting(221, &no_cell), None);
}

#[test]
fn the_sites_of_quartz_and_spinel_are_named_as_in_the_literature() {
    // α-quartz, P 32 2 1: Si in 3a, O in 6c. Spinel, F d -3 m: Mg 8a, Al 16d, O 32e.
    let quartz = WyckoffPositions::standard(154).expect("a number");
    let cell = Cell::new([4.916, 4.916, 5.4054], [90.0, 90.0, 120.0]).expect("a cell");
    let symbol = |all: &WyckoffPositions, cell: &Cell, point: [f64; 3]| {
        all.locate(point, cell, 0.01).map(|site| {
            let position: &WyckoffPosition = site.position;
            format!("{} {}", position.symbol(), position.site_symmetry)
        })
    };
    let silicon = symbol(&quartz, &cell, [0.4697, 0.0, 2.0 / 3.0]);
    assert_eq!(silicon.as_deref(), Some("3a .2."));
    let oxygen = symbol(&quartz, &cell, [0.4133, 0.2672, 0.7855]);
    assert_eq!(oxygen.as_deref(), Some("6c 1"));
    let spinel = WyckoffPositions::standard(227).expect("a number");
    let cell = Cell::new([8.0806; 3], [90.0; 3]).expect("a cell");
    let found = [[0.125; 3], [0.5; 3], [0.2624; 3]].map(|at| symbol(&spinel, &cell, at));
    let found: BTreeMap<usize, Option<&str>> = found
        .iter()
        .map(|text| text.as_deref())
        .enumerate()
        .collect();
    assert_eq!(found[&0], Some("8a -43m"));
    assert_eq!(found[&1], Some("16d .-3m"));
    assert_eq!(found[&2], Some("32e .3m"));
}

#[test]
fn positions_follow_into_a_primitive_cell() {
    let change: ChangeOfBasis = "1/2y+1/2z,1/2x+1/2z,1/2x+1/2y".parse().expect("a change");
    let all = WyckoffPositions::in_setting(227, &change).expect("a cell of the group");
    let multiplicities: Vec<usize> = all.positions().iter().map(|p| p.multiplicity).collect();
    assert_eq!(multiplicities, [2, 2, 4, 4, 8, 12, 24, 24, 48]);
    let inversion: Operation = "-x,-y,-z".parse().expect("an operation");
    assert!(all.positions()[2].site_group().contains(&inversion));
    assert_eq!(all.positions()[4].site_symmetry, ".3m");
}
