//! Whether every setting of every space group has the operations that an independent program,
//! moyo, gives it.

use std::collections::{BTreeSet, HashSet};

use ga_design::crystallography::{Operation, SpaceGroup, close, hall};
use moyo::data::{HallSymbol, hall_symbol_entry};

/// An operation as integers: the matrix, and the translation in 24ths modulo the lattice.
pub type Key = ([[i32; 3]; 3], [i64; 3]);

/// The operation as integers.
pub fn key(operation: &Operation) -> Key {
    let shift = operation
        .translation_f64()
        .map(|value| (value * 24.0).round() as i64);
    (operation.rotation(), shift)
}

/// What moyo makes of a Hall symbol, centring translations included; `None` when it cannot read
/// it. moyo writes `^` and `=` for the axes `'` and `"`.
fn judged(hall: &str) -> Option<BTreeSet<Key>> {
    let symbol = HallSymbol::new(&hall.replace('\'', "^").replace('"', "="))?;
    let mut keys = BTreeSet::new();
    for operation in symbol.traverse().iter() {
        let shift = operation.translation_as_array();
        for centring in symbol.centering.lattice_points() {
            let units = [0, 1, 2].map(|i| {
                let sum = shift[i] + centring[i];
                ((sum * 24.0).round() as i64).rem_euclid(24)
            });
            keys.insert((operation.rotation_as_array(), units));
        }
    }
    Some(keys)
}

/// The operations of a Hall symbol by moyo.
pub fn operations_of_moyo(hall_symbol: &str) -> BTreeSet<Key> {
    judged(hall_symbol).unwrap_or_else(|| panic!("moyo does not read {hall_symbol}"))
}

#[test]
fn every_setting_of_the_table_has_the_operations_of_moyo() {
    assert_eq!(SpaceGroup::table().len(), 558);
    let mut compared = 0;
    for group in SpaceGroup::table() {
        let ours = group
            .operations()
            .unwrap_or_else(|e| panic!("{}: {e}", group.hall));
        let keys: BTreeSet<Key> = ours.iter().map(key).collect();
        assert_eq!(
            keys.len(),
            ours.len(),
            "{} has an operation twice",
            group.symbol
        );
        // The settings in brackets of change of basis are not in moyo's grammar.
        if group.hall.contains('(') && judged(group.hall).is_none() {
            continue;
        }
        assert_eq!(
            keys,
            operations_of_moyo(group.hall),
            "{} ({})",
            group.symbol,
            group.hall
        );
        compared += 1;
    }
    assert!(compared >= 540, "only {compared} settings were compared");
}

#[test]
fn every_hall_symbol_of_moyo_is_read_and_identified_with_its_number() {
    for hall_number in 1..=530 {
        let entry = hall_symbol_entry(hall_number).expect("530 entries");
        let operations = hall::operations(entry.hall_symbol)
            .unwrap_or_else(|e| panic!("{}: {e}", entry.hall_symbol));
        let keys: BTreeSet<Key> = operations.iter().map(key).collect();
        assert_eq!(
            keys,
            operations_of_moyo(entry.hall_symbol),
            "{}",
            entry.hall_symbol
        );
        let found = SpaceGroup::identify(&operations)
            .unwrap_or_else(|| panic!("{} is not in the table", entry.hall_symbol));
        assert_eq!(found.number, entry.number as u32, "{}", entry.hall_symbol);
    }
}

#[test]
fn short_and_full_symbols_of_moyo_find_their_number() {
    for hall_number in 1..=530 {
        let entry = hall_symbol_entry(hall_number).expect("530 entries");
        for symbol in [entry.hm_short, entry.hm_full] {
            let found = SpaceGroup::from_symbol(symbol)
                .unwrap_or_else(|e| panic!("{hall_number} {symbol}: {e}"));
            assert!(
                found
                    .iter()
                    .any(|group| group.number == entry.number as u32),
                "{symbol} should be {}, not {}",
                entry.number,
                found[0].number
            );
        }
    }
}

#[test]
fn the_230_standard_settings_are_there_once_each() {
    for number in 1..=230 {
        let standard: Vec<_> = SpaceGroup::settings(number)
            .into_iter()
            .filter(|g| g.standard)
            .collect();
        assert_eq!(standard.len(), 1, "group {number}");
        assert_eq!(SpaceGroup::standard(number), Some(standard[0]));
        let found = SpaceGroup::from_symbol(standard[0].symbol).expect("its own symbol");
        assert_eq!(found[0], standard[0], "{}", standard[0].symbol);
        let operations = standard[0]
            .operations()
            .expect("a Hall symbol of the table");
        assert_eq!(SpaceGroup::identify(&operations), Some(standard[0]));
    }
    assert_eq!(SpaceGroup::standard(0), None);
    assert_eq!(SpaceGroup::standard(231), None);
}

#[test]
fn every_symbol_of_the_table_finds_its_own_setting_first_or_its_standard() {
    for group in SpaceGroup::table() {
        for text in [
            group.symbol.to_owned(),
            group.symbol.replace(' ', ""),
            group.symbol.to_uppercase(),
        ] {
            let found = SpaceGroup::from_symbol(&text).expect("a symbol of the table");
            assert_eq!(found[0].number, group.number, "{text}");
            assert_eq!(found[0].symbol, group.symbol, "{text}");
        }
        let found = SpaceGroup::from_symbol(&group.qualified_symbol()).expect("a qualified symbol");
        assert_eq!(
            found[0].choice,
            group.choice,
            "{}",
            group.qualified_symbol()
        );
    }
}

#[test]
fn spellings_of_strangers_are_understood() {
    let cases = [
        ("P21/c", 14, "-P 2ybc"),
        ("P 21/c", 14, "-P 2ybc"),
        ("P 1 21/c 1", 14, "-P 2ybc"),
        ("P121/c1", 14, "-P 2ybc"),
        ("P2_1/c", 14, "-P 2ybc"),
        ("'P 21/n'", 14, "-P 2yn"),
        ("P 21/a", 14, "-P 2yab"),
        ("C 2/c", 15, "-C 2yc"),
        ("C2/m", 12, "-C 2y"),
        ("P 21", 4, "P 2yb"),
        ("P 1 1 21/b", 14, "-P 2bc"),
        ("F d -3 m :2", 227, "-F 4vw 2vw 3"),
        ("Fd-3m:2", 227, "-F 4vw 2vw 3"),
        ("F d -3 m S", 227, "F 4d 2 3 -1d"),
        ("F d -3 m Z", 227, "-F 4vw 2vw 3"),
        ("Fd-3mS", 227, "F 4d 2 3 -1d"),
        ("F d 3 m", 227, "-F 4vw 2vw 3"),
        ("Fm3m", 225, "-F 4 2 3"),
        ("Pa3", 205, "-P 2ac 2ab 3"),
        ("F 41/d -3 2/m", 227, "-F 4vw 2vw 3"),
        ("R -3 c", 167, "-R 3 2\"c"),
        ("R -3 c H", 167, "-R 3 2\"c"),
        ("R-3c:R", 167, "-P 3* 2n"),
        ("R -3 m R", 166, "-P 3* 2"),
        ("H -3 c", 167, "-R 3 2\"c"),
        ("H 3 2", 155, "R 3 2\""),
        ("P 32 2 1", 154, "P 32 2\""),
        ("C m c e", 64, "-C 2ac 2"),
        ("C m c a", 64, "-C 2ac 2"),
        ("p 6/m 2/m 2/m", 191, "-P 6 2"),
        ("P n m a", 62, "-P 2ac 2n"),
        ("P b n m", 62, "-P 2c 2ab"),
    ];
    for (symbol, number, hall) in cases {
        let found = SpaceGroup::from_symbol(symbol).unwrap_or_else(|e| panic!("{symbol}: {e}"));
        assert_eq!((found[0].number, found[0].hall), (number, hall), "{symbol}");
    }
}

#[test]
fn unknown_symbols_get_a_suggestion() {
    let error = SpaceGroup::from_symbol("P 21/q").expect_err("no such group");
    assert!(error.to_string().contains("did you mean"), "{error}");
    assert!(
        error.suggestions.iter().any(|name| name == "P 1 21/c 1"),
        "{error}"
    );
    let error = SpaceGroup::from_symbol("nonsense altogether").expect_err("no such group");
    assert!(error.to_string().contains("write one such as"), "{error}");
    for symbol in [
        "",
        " ",
        ":",
        ":2",
        "s",
        &"P".repeat(100_000),
        "P\u{301} 1\u{0}",
    ] {
        assert!(SpaceGroup::from_symbol(symbol).is_err());
    }
}

#[test]
fn changes_of_basis_carry_the_operations() {
    // The same group in both spellings of Hall's shift, and by hand: a twofold axis along z moved
    // to x = y = 0 in a cell whose origin lies c/12 lower.
    let shifted = hall::operations("P 2x (0 0 1)").expect("a shift in twelfths");
    let by_triplet = hall::operations("P 2x (x,y,z+1/12)").expect("the same as a triplet");
    assert_eq!(shifted, by_triplet);
    assert_eq!(shifted[1].to_string(), "x,-y,-z+1/6");
    // C-centred monoclinic in its primitive cell and back.
    let primitive = hall::operations("C 2y (x-y,x+y,z)").expect("to half the cell");
    assert_eq!(primitive.len(), 2);
    let centred = hall::operations("P 2y (1/2*x+1/2*y,-1/2*x+1/2*y,z)").expect("a doubled cell");
    assert_eq!(centred.len(), 4);
    let doubled = hall::operations("P 1 (1/2*x,y,z)").expect("a doubled cell");
    assert_eq!(doubled.len(), 2);
    // Rhombohedral axes from hexagonal ones (International Tables A, table 1.5.1.1).
    let obverse = hall::operations("-R 3 2\"c (x+z,-x+y+z,-y+z)").expect("to rhombohedral axes");
    let set: HashSet<_> = obverse.into_iter().collect();
    let expected: HashSet<_> = hall::operations("-P 3* 2n")
        .expect("R -3 c:R")
        .into_iter()
        .collect();
    assert_eq!(set, expected);
}

#[test]
fn wrong_hall_symbols_are_refused_with_their_column() {
    let cases = [
        ("", "between 1 and"),
        ("Q 2", "`Q` at column 1"),
        ("-", "lattice letter"),
        ("P 5", "`5` at column 3"),
        ("P 2q", "`q` at column 4"),
        ("P 2 2 3 -1 1", "fifth rotation at column 12"),
        ("P 2 2 2", "column 7 needs an axis"),
        ("P 4*", "axis"),
        ("P 2 4", "axis"),
        ("P 31*", "axis"),
        ("P 2 (0 0", "end the symbol"),
        ("P 2 (0 0 x)", "twelfths"),
        ("P 2 (x,x,z)", "no inverse"),
        ("P 2 (x,y,w)", "unexpected `w`"),
        ("P 3 (2x,y,z)", "integer operations"),
        ("P 4 6x", "do not form a group"),
        ("P 2é", "unexpected"),
    ];
    for (symbol, part) in cases {
        match hall::operations(symbol) {
            Ok(_) => panic!("{symbol} was read"),
            Err(error) => assert!(error.to_string().contains(part), "{symbol}: {error}"),
        }
    }
}

#[test]
fn groups_are_closed_and_have_inverses() {
    for group in SpaceGroup::table() {
        let operations = group.operations().expect("a Hall symbol of the table");
        let all: HashSet<_> = operations.iter().copied().collect();
        assert_eq!(close(&operations).expect("a group"), operations);
        for operation in &operations {
            let inverse = operation.inverse().expect("a small inverse");
            assert!(all.contains(&inverse));
            assert_eq!(inverse.after(operation), Some(Operation::IDENTITY));
            assert_eq!(operation.to_string().parse(), Ok(*operation));
        }
    }
}
