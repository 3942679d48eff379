//! Whether the Wyckoff positions of plane groups are those of International Tables, those of layer
//! groups the ones of the program moyo, and all of them complete orbits.

use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind, SubperiodicPosition};
use moyo::data::{iter_layer_wyckoff_positions_from_hall_number, layer_hall_symbol_entry};

fn positions(group: &SubperiodicGroup) -> Vec<SubperiodicPosition> {
    group
        .wyckoff_positions()
        .unwrap_or_else(|| panic!("{} {}", group.kind, group.symbol))
}

fn line(positions: &[SubperiodicPosition]) -> String {
    let words: Vec<String> = positions
        .iter()
        .map(|position| format!("{} {}", position.symbol(), position.site_symmetry))
        .collect();
    words.join(", ")
}

#[test]
fn plane_groups_have_the_positions_of_international_tables() {
    // ITA, chapter 2.2.
    let printed = [
        "1a 1",
        "1a 2, 1b 2, 1c 2, 1d 2, 2e 1",
        "1a .m., 1b .m., 2c 1",
        "2a 1",
        "2a .m., 4b 1",
        "1a 2mm, 1b 2mm, 1c 2mm, 1d 2mm, 2e ..m, 2f ..m, 2g .m., 2h .m., 4i 1",
        "2a 2.., 2b 2.., 2c .m., 4d 1",
        "2a 2.., 2b 2.., 4c 1",
        "2a 2mm, 2b 2mm, 4c 2.., 4d ..m, 4e .m., 8f 1",
        "1a 4.., 1b 4.., 2c 2.., 4d 1",
        "1a 4mm, 1b 4mm, 2c 2mm., 4d .m., 4e .m., 4f ..m, 8g 1",
        "2a 4.., 2b 2.mm, 4c ..m, 8d 1",
        "1a 3.., 1b 3.., 1c 3.., 3d 1",
        "1a 3m., 1b 3m., 1c 3m., 3d .m., 6e 1",
        "1a 3.m, 2b 3.., 3c ..m, 6d 1",
        "1a 6.., 2b 3.., 3c 2.., 6d 1",
        "1a 6mm, 2b 3m., 3c 2mm, 6d ..m, 6e .m., 12f 1",
    ];
    for (number, printed) in (1..).zip(printed) {
        let group = SubperiodicGroup::standard(SubperiodicKind::Plane, number).expect("17");
        assert_eq!(line(&positions(group)), printed, "{}", group.symbol);
    }
}

#[test]
fn friezes_have_the_positions_of_international_tables() {
    // ITE, part 2; no letters here.
    let printed = [
        "1 1",
        "1 2, 1 2, 2 1",
        "1 .m., 1 .m., 2 1",
        "1 ..m, 2 1",
        "2 1",
        "1 2mm, 1 2mm, 2 ..m, 2 .m., 2 .m., 4 1",
        "2 2.., 2 .m., 4 1",
    ];
    for (number, printed) in (1..).zip(printed) {
        let group = SubperiodicGroup::standard(SubperiodicKind::Frieze, number).expect("7");
        let mut found: Vec<String> = positions(group)
            .iter()
            .map(|position| line(std::slice::from_ref(position)))
            .collect();
        let mut wanted: Vec<&str> = printed.split(", ").collect();
        found.sort();
        wanted.sort_unstable();
        assert_eq!(found, wanted, "{}", group.symbol);
    }
}

#[test]
fn every_position_is_a_whole_orbit_and_the_last_is_general() {
    for group in SubperiodicGroup::table() {
        let name = group.qualified_symbol();
        let order = group.operations().expect("a group").len();
        let all = positions(group);
        for position in &all {
            let count = position.multiplicity * position.site_group().len();
            assert_eq!(count, order, "{name} {}", position.symbol());
            assert_eq!(position.coordinates().len(), position.multiplicity);
            assert_eq!(position.triplets().len(), position.multiplicity);
            assert!(position.dimension() <= group.kind.dimension());
        }
        let general = all.last().expect("every group has a general position");
        assert_eq!(general.multiplicity, order, "{name}");
        assert_eq!(general.site_symmetry, "1", "{name}");
        assert_eq!(general.dimension(), group.kind.dimension(), "{name}");
    }
}

/// The elements that a symbol names, whatever their order and the dots.
fn elements(symbol: &str) -> Vec<char> {
    let mut all: Vec<char> = symbol.chars().filter(|c| *c != '.').collect();
    all.sort_unstable();
    all
}

#[test]
fn layer_groups_have_the_positions_of_moyo_in_all_its_116_settings() {
    for hall_number in 1..=116 {
        let entry = layer_hall_symbol_entry(hall_number).expect("116 entries");
        let symbol = entry.hm_short.replace('_', "");
        let choice = match entry.setting {
            "1" | "2" => format!("{symbol}:{}", entry.setting),
            _ => symbol,
        };
        let found = SubperiodicGroup::from_symbol(SubperiodicKind::Layer, &choice)
            .unwrap_or_else(|e| panic!("{e}"));
        let ours = positions(found[0]);
        let mut count = 0;
        for theirs in iter_layer_wyckoff_positions_from_hall_number(hall_number) {
            count += 1;
            let same = ours
                .iter()
                .find(|position| position.letter == Some(theirs.letter))
                .unwrap_or_else(|| panic!("{choice} has no {}", theirs.letter));
            assert_eq!(
                same.multiplicity, theirs.multiplicity,
                "{choice} {}",
                theirs.letter
            );
            assert_eq!(
                elements(&same.site_symmetry),
                elements(theirs.site_symmetry),
                "{choice} {}: {} and {}",
                theirs.letter,
                same.site_symmetry,
                theirs.site_symmetry
            );
        }
        assert_eq!(count, ours.len(), "{choice}");
    }
}
