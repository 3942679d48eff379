//! Whether a group is found by every kind of symbol that International Tables give, and named by
//! each.

use ga_design::crystallography::{CrystalSystem, SpaceGroup};
use moyo::data::{arithmetic_crystal_class_entry, hall_symbol_entry};

fn standard(number: u32) -> &'static SpaceGroup {
    SpaceGroup::standard(number).expect("1 to 230")
}

/// The likeliest setting that a text means.
pub fn first(text: &str) -> &'static SpaceGroup {
    SpaceGroup::find(text).unwrap_or_else(|e| panic!("{e}"))[0]
}

#[test]
fn every_kind_of_symbol_of_every_setting_finds_it() {
    for group in SpaceGroup::table() {
        let name = group.qualified_symbol();
        let symbols = [
            name.clone(),
            group.symbol.to_owned(),
            group.full_symbol().to_owned(),
            group.short_symbol(),
            group.extended_symbol(),
            group.schoenflies(),
            group.number.to_string(),
        ];
        for text in symbols {
            let found = SpaceGroup::find(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert!(found.contains(&group), "{name} as {text}");
        }
        // Of settings with the same Hall symbol the first is meant.
        let by_hall = SpaceGroup::from_hall(group.hall).unwrap_or_else(|| panic!("{name}"));
        assert_eq!(by_hall.hall, group.hall, "{name}");
        let spaced = group.hall.replace(' ', "_").to_lowercase();
        assert_eq!(SpaceGroup::from_hall(&spaced), Some(by_hall), "{spaced}");
    }
}

#[test]
fn schoenflies_symbols_are_those_of_international_tables() {
    // ITA, table A1.4.2.
    let cases = [
        (1, "C1^1"),
        (2, "Ci^1"),
        (5, "C2^3"),
        (9, "Cs^4"),
        (14, "C2h^5"),
        (19, "D2^4"),
        (43, "C2v^19"),
        (62, "D2h^16"),
        (74, "D2h^28"),
        (78, "C4^4"),
        (82, "S4^2"),
        (88, "C4h^6"),
        (96, "D4^8"),
        (110, "C4v^12"),
        (122, "D2d^12"),
        (136, "D4h^14"),
        (146, "C3^4"),
        (148, "C3i^2"),
        (154, "D3^6"),
        (161, "C3v^6"),
        (167, "D3d^6"),
        (173, "C6^6"),
        (174, "C3h^1"),
        (176, "C6h^2"),
        (182, "D6^6"),
        (186, "C6v^4"),
        (190, "D3h^4"),
        (194, "D6h^4"),
        (198, "T^4"),
        (205, "Th^6"),
        (212, "O^6"),
        (220, "Td^6"),
        (227, "Oh^7"),
        (230, "Oh^10"),
    ];
    for (number, symbol) in cases {
        assert_eq!(standard(number).schoenflies(), symbol);
        for text in [
            symbol.to_owned(),
            symbol.replace('^', ""),
            format!("{}_{}", &symbol[..1], &symbol[1..]),
        ] {
            let found = SpaceGroup::from_schoenflies(&text);
            assert_eq!(found.first(), Some(&standard(number)), "{text}");
        }
    }
    assert!(SpaceGroup::from_schoenflies("D2h^29").is_empty());
    assert!(SpaceGroup::from_schoenflies("").is_empty());
    let all: std::collections::HashSet<String> = (1..=230)
        .map(|number| standard(number).schoenflies())
        .collect();
    assert_eq!(all.len(), 230);
}

#[test]
fn full_symbols_are_those_of_international_tables() {
    let cases = [
        (14, "P 1 21/c 1"),
        (15, "C 1 2/c 1"),
        (47, "P 2/m 2/m 2/m"),
        (62, "P 21/n 21/m 21/a"),
        (64, "C 2/m 2/c 21/e"),
        (70, "F 2/d 2/d 2/d"),
        (127, "P 4/m 21/b 2/m"),
        (129, "P 4/n 21/m 2/m"),
        (130, "P 4/n 21/c 2/c"),
        (138, "P 42/n 21/c 2/m"),
        (142, "I 41/a 2/c 2/d"),
        (166, "R -3 2/m"),
        (194, "P 63/m 2/m 2/c"),
        (205, "P 21/a -3"),
        (225, "F 4/m -3 2/m"),
        (230, "I 41/a -3 2/d"),
    ];
    for (number, symbol) in cases {
        assert_eq!(standard(number).full_symbol(), symbol);
        assert_eq!(first(symbol), standard(number));
    }
    // Every group whose short symbol leaves axes out has a full one that does not.
    for group in SpaceGroup::table() {
        let shortened = matches!(
            group.point_group,
            "mmm" | "4/mmm" | "-3m" | "6/mmm" | "m-3" | "m-3m"
        );
        assert_eq!(
            shortened,
            group.full_symbol() != group.symbol,
            "{}",
            group.symbol
        );
    }
    let short = |symbol: &str| first(symbol).short_symbol();
    assert_eq!(short("P 1 21/c 1"), "P 21/c");
    assert_eq!(short("P 1 1 21/b"), "P 1 1 21/b");
    assert_eq!(short("P 3 1 2"), "P 3 1 2");
}

#[test]
fn extended_symbols_name_the_further_axes_and_planes() {
    // ITA, table 1.5.4.4 (4.3.2.1 of older editions).
    let cases = [
        ("C 1 2 1", "C 1 2 1 (21)"),
        ("C 1 m 1", "C 1 m 1 (a)"),
        ("C 1 c 1", "C 1 c 1 (n)"),
        ("C 1 2/m 1", "C 1 2/m 1 (21/a)"),
        ("C 1 2/c 1", "C 1 2/c 1 (21/n)"),
        ("I 1 2/a 1", "I 1 2/a 1 (21/c)"),
        ("C 2 2 21", "C 2 2 21 (21 21)"),
        ("C 2 2 2", "C 2 2 2 (21 21)"),
        ("F 2 2 2", "F 2 2 2 (21 21 21)"),
        ("I 2 2 2", "I 2 2 2 (21 21 21)"),
        ("C m m 2", "C m m 2 (b a)"),
        ("C m c 21", "C m c 21 (b n)"),
        ("C c c 2", "C c c 2 (n n)"),
        ("A m m 2", "A m m 2 (n c 21)"),
        ("I m m 2", "I m m 2 (n n 21)"),
        ("C m c m", "C 2/m 2/c 21/m (21/b 21/n n)"),
        ("I m m m", "I 2/m 2/m 2/m (21/n 21/n 21/n)"),
        ("P 4 2 2", "P 4 2 2 (21)"),
        ("P 4 m m", "P 4 m m (g)"),
        ("P 4 b m", "P 4 b m (g)"),
        ("P 4 c c", "P 4 c c (n)"),
        ("P -4 2 m", "P -4 2 m (g)"),
        ("I 4", "I 4 (42)"),
        ("I 41", "I 41 (43)"),
        ("P 3 m 1", "P 3 m 1 (b)"),
        ("P 3 1 m", "P 3 1 m (a)"),
        ("P 3 c 1", "P 3 c 1 (n)"),
        ("R 3", "R 3 (31; 32)"),
        ("P n m a", "P 21/n 21/m 21/a"),
        ("P 1 21/c 1", "P 1 21/c 1"),
    ];
    for (symbol, extended) in cases {
        assert_eq!(first(symbol).extended_symbol(), extended);
        assert_eq!(first(extended), first(symbol));
    }
    // A part of them, in either order and with underscores, will do; a wrong one will not.
    assert_eq!(first("C m c m (b n n)").number, 63);
    assert_eq!(first("C 2/m 2/c 2_1/m (2_1/n; 2_1/b)").number, 63);
    assert!(SpaceGroup::find("C m c m (d)").is_err());
    assert!(SpaceGroup::find("C m c m (63)").is_err());
}

#[test]
fn brackets_round_subscripts_are_no_further_elements() {
    let cases = [
        ("P2(1)/c", 14),
        ("P2(1)2(1)2(1)", 19),
        ("P-42(1)c", 114),
        ("I4(1)/amd", 141),
        ("P6(3)/mmc", 194),
        ("Cmc2(1)", 36),
        ("P3(1)", 144),
        ("C222(1)", 20),
    ];
    for (symbol, number) in cases {
        assert_eq!(first(symbol).number, number, "{symbol}");
    }
}

#[test]
fn bars_and_subscripts_are_read_however_they_are_typed() {
    let cases = [
        ("P2\u{2081}/c", "P 1 21/c 1"),
        ("P 2(1)/c", "P 1 21/c 1"),
        ("P2_1/c", "P 1 21/c 1"),
        ("$P2_{1}/c$", "P 1 21/c 1"),
        ("P2~1~/c", "P 1 21/c 1"),
        ("P2<sub>1</sub>/c", "P 1 21/c 1"),
        ("P2<SUB>1</SUB>2<SUB>1</SUB>2", "P 21 21 2"),
        ("P 2\u{2081} 2\u{2081} 2\u{2081}", "P 21 21 21"),
        ("P6\u{2083}/mmc", "P 63/m m c"),
        ("P1\u{304}", "P -1"),
        ("P 1\u{305}", "P -1"),
        ("P\u{304}1", "P -1"),
        ("P4\u{304}", "P -4"),
        ("I4\u{304}3m", "I -4 3 m"),
        ("Fd3\u{304}m", "F d -3 m:2"),
        ("Fd\u{305}3m", "F d -3 m:2"),
        ("Fd\u{af}3m:1", "F d -3 m:1"),
        ("Fd\u{2212}3m", "F d -3 m:2"),
        ("Fd\\bar{3}m", "F d -3 m:2"),
        ("$Fd\\overline{3}m$", "F d -3 m:2"),
        ("F d \\-3 m S", "F d -3 m:1"),
        ("R3\u{304}c", "R -3 c:H"),
        ("R3\u{304}c:r", "R -3 c:R"),
        ("R3\u{304}m\u{a0}H", "R -3 m:H"),
        ("P42/nnm Z", "P 42/n n m:2"),
        ("B 1 1 21", "B 1 1 21"),
    ];
    for (text, symbol) in cases {
        assert_eq!(first(text).qualified_symbol(), symbol, "{text}");
    }
    // A bar is never lost: without it these would be other groups.
    for number in 1..=230 {
        let barred = standard(number).qualified_symbol();
        let mut typed = String::new();
        let mut chars = barred.chars();
        while let Some(c) = chars.next() {
            match c {
                '-' => typed.extend(chars.next().into_iter().chain(['\u{305}'])),
                other => typed.push(other),
            }
        }
        assert_eq!(first(&typed).number, number, "{typed}");
    }
}

#[test]
fn nothing_and_half_a_symbol_are_no_symbol() {
    for text in [
        "", " ", ":", "::", ":2", "P", "F", "-", "\u{305}", "\\bar", "<sub>", "$$",
    ] {
        let error = SpaceGroup::find(text).expect_err(text).to_string();
        assert!(error.starts_with("unknown space group symbol"), "{error}");
    }
    let error = SpaceGroup::find("").expect_err("empty").to_string();
    assert!(error.contains("write one such as"), "{error}");
}

#[test]
fn systems_laue_classes_and_centrings_are_those_of_moyo() {
    for hall_number in 1..=530 {
        let entry = hall_symbol_entry(hall_number).expect("530 entries");
        let hall = entry.hall_symbol.replace('^', "'").replace('=', "\"");
        let group = SpaceGroup::from_hall(&hall).unwrap_or_else(|| panic!("{hall}"));
        let class = arithmetic_crystal_class_entry(entry.arithmetic_number).expect("73 classes");
        let class = class.geometric_crystal_class;
        let system = format!(
            "{:?}",
            moyo::data::CrystalSystem::from_geometric_crystal_class(class)
        );
        // moyo writes C1h for Cs and S6 for C3i.
        let schoenflies = format!("{class:?}")
            .replace("C1h", "Cs")
            .replace("S6", "C3i");
        let ours = group.schoenflies();
        assert_eq!(ours.split('^').next(), Some(schoenflies.as_str()), "{hall}");
        assert_eq!(
            group.crystal_system().to_string(),
            system.to_lowercase(),
            "{hall}"
        );
        let centring = format!("{:?}", entry.centering);
        // Rhombohedral axes are primitive in moyo, R in International Tables.
        if group.choice != Some('R') {
            assert_eq!(group.centring().to_string(), centring, "{hall}");
        }
    }
}

#[test]
fn laue_classes_have_their_numbers() {
    let mut counts = std::collections::BTreeMap::new();
    for number in 1..=230 {
        *counts.entry(standard(number).laue_class()).or_insert(0) += 1;
    }
    let counts: Vec<(&str, i32)> = counts.into_iter().collect();
    let wanted = [
        ("-1", 2),
        ("-3", 6),
        ("-3m", 19),
        ("2/m", 13),
        ("4/m", 14),
        ("4/mmm", 54),
        ("6/m", 9),
        ("6/mmm", 18),
        ("m-3", 12),
        ("m-3m", 24),
        ("mmm", 59),
    ];
    assert_eq!(counts, wanted);
    assert!(CrystalSystem::Triclinic < CrystalSystem::Cubic);
}

#[test]
fn choices_go_with_numbers_and_symbols() {
    assert_eq!(first("227:1").choice, Some('1'));
    assert_eq!(first("Oh^7:1").choice, Some('1'));
    assert_eq!(first("F d -3 m:2").choice, Some('2'));
    assert_eq!(first("166:R").choice, Some('R'));
    assert_eq!(first("166:h").choice, Some('H'));
    assert_eq!(first(" 166 ").choice, Some('H'));
    for wrong in [
        "227:3",
        "14:1",
        "0",
        "231",
        "-5",
        "99999999999",
        "Oh^7:R",
        "",
        ":",
        "(",
        "C2/c(",
    ] {
        let found = SpaceGroup::find(wrong);
        if wrong == "C2/c(" {
            // An empty bracket asks for nothing further.
            assert_eq!(found.map(|all| all[0].number), Ok(15));
        } else {
            assert!(found.is_err(), "{wrong}");
        }
    }
}

#[test]
fn what_is_almost_a_symbol_gets_a_suggestion() {
    let suggestions = |text: &str| SpaceGroup::find(text).expect_err(text).suggestions;
    assert!(suggestions("P 21/q").contains(&String::from("P 1 21/c 1")));
    assert!(suggestions("D2h^29").contains(&String::from("D2h^28")));
    assert!(suggestions("F d -3 q").contains(&String::from("F d -3 m:2")));
    let error = SpaceGroup::find("Q 17 zz zz zz").expect_err("no symbol");
    assert!(error.to_string().contains("write one such as"), "{error}");
}
