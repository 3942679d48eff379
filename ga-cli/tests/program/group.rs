//! `articulate group` on good input: the JSON contract, all groups of all kinds against an independent
//! program, symbols of every notation, and points.

use crate::run::{directory, names, run};
use moyo::data::{
    HallSymbol, LayerSetting, hall_symbol_entry, layer_hall_symbol_entry,
    operations_from_layer_number,
};
use serde_json::Value;
use std::collections::BTreeSet;

/// An operation as integers: the matrix, and the translation in 24ths modulo the lattice.
pub type Key = ([[i32; 3]; 3], [i64; 3]);

/// Reads a triplet such as `-x+1/2,x-y,z`, with code of its own.
pub fn key(triplet: &str) -> Key {
    let (mut rotation, mut shift) = ([[0; 3]; 3], [0; 3]);
    for (row, text) in triplet.split(',').enumerate() {
        let spaced = text.replace('-', " -").replace('+', " ");
        for term in spaced.split_whitespace() {
            let (sign, name) = match term.strip_prefix('-') {
                Some(name) => (-1, name),
                None => (1, term),
            };
            match name {
                "x" => rotation[row][0] += sign,
                "y" => rotation[row][1] += sign,
                "z" => rotation[row][2] += sign,
                number => {
                    let (over, under) = number.split_once('/').unwrap_or((number, "1"));
                    let part: i64 =
                        over.parse::<i64>().unwrap() * 24 / under.parse::<i64>().unwrap();
                    shift[row] = (i64::from(sign) * part).rem_euclid(24);
                }
            }
        }
    }
    (rotation, shift)
}

fn keys(group: &Value) -> BTreeSet<Key> {
    let all = texts(&group["operations"]);
    let keys: BTreeSet<Key> = all.iter().map(|triplet| key(triplet)).collect();
    assert_eq!(keys.len(), all.len(), "an operation twice: {group}");
    keys
}

/// The texts of a list.
pub fn texts(list: &Value) -> Vec<String> {
    let list = list.as_array().expect("a list").iter();
    list.map(|text| text.as_str().expect("a text").to_owned())
        .collect()
}

/// The operations that moyo has for a Hall symbol; it writes `^` and `=` for `'` and `"`.
pub fn judged(hall: &str) -> BTreeSet<Key> {
    let symbol =
        HallSymbol::new(&hall.replace('\'', "^").replace('"', "=")).expect("a Hall symbol");
    let mut keys = BTreeSet::new();
    for operation in symbol.traverse().iter() {
        let shift = operation.translation_as_array();
        for centring in symbol.centering.lattice_points() {
            let units = [0, 1, 2]
                .map(|i| (((shift[i] + centring[i]) * 24.0).round() as i64).rem_euclid(24));
            keys.insert((operation.rotation_as_array(), units));
        }
    }
    keys
}

/// What the program tells in JSON, whatever remarks it has.
pub fn group(words: &[&str]) -> Value {
    let directory = directory();
    let mut all = vec!["group"];
    all.extend(words);
    all.push("--json");
    let ran = run(directory.path(), &all);
    assert_eq!(ran.code, 0, "{words:?}: {}", ran.stderr);
    serde_json::from_str(&ran.stdout).expect("standard output is JSON")
}

#[test]
fn all_230_have_the_operations_of_an_independent_program() {
    let all = group(&["--all"]);
    let all = all.as_array().expect("a list");
    assert_eq!(all.len(), 230);
    let mut symbols = BTreeSet::new();
    for (at, group) in all.iter().enumerate() {
        assert_eq!(group["number"], at + 1);
        let hall = group["hall"].as_str().expect("a text");
        assert_eq!(keys(group), judged(hall), "{hall}");
        // The Hall symbol belongs to the number.
        let known = (1..=530).filter_map(hall_symbol_entry);
        let mut known = known.filter(|entry| entry.number as usize == at + 1);
        assert!(
            known.any(|entry| judged(entry.hall_symbol) == judged(hall)),
            "{hall}"
        );
        let centring = group["centring"].as_array().expect("a list");
        let operations = group["operations"].as_array().expect("a list");
        assert_eq!(group["order"], operations.len() / centring.len());
        assert_eq!(centring[0], serde_json::json!([0.0, 0.0, 0.0]));
        assert!(!texts(&group["generators"]).is_empty());
        for field in [
            "hm",
            "point_group",
            "geometric",
            "system",
            "laue_class",
            "schoenflies",
        ] {
            assert!(
                group[field].as_str().is_some_and(|text| !text.is_empty()),
                "{hall}: {field}"
            );
        }
        assert!(
            symbols.insert(group["geometric"].to_string()),
            "{hall}: twice"
        );
    }
}

#[test]
fn all_groups_of_fewer_translations_are_there() {
    for (kind, count) in [
        ("--frieze", 7),
        ("--wallpaper", 17),
        ("--rod", 75),
        ("--layer", 80),
    ] {
        let all = group(&["--all", kind]);
        let all = all.as_array().expect("a list");
        assert_eq!(all.len(), count, "{kind}");
        for (at, group) in all.iter().enumerate() {
            assert_eq!(group["number"], at + 1, "{kind}");
            let own = keys(group);
            let in_plane = matches!(kind, "--frieze" | "--wallpaper");
            let completed: BTreeSet<Key> = own
                .iter()
                .map(|(rotation, shift)| {
                    let mut rotation = *rotation;
                    // A triplet of the plane leaves z as it is.
                    rotation[2][2] += i32::from(in_plane);
                    (rotation, *shift)
                })
                .collect();
            let hall = group["hall"].as_str().expect("a text");
            if !hall.contains('(') {
                assert_eq!(completed, judged(hall), "{kind} {hall}");
            }
        }
    }
    let all = group(&["--all", "--point"]);
    assert_eq!(all.as_array().map(Vec::len), Some(32));
}

#[test]
fn layer_groups_have_the_operations_of_an_independent_program() {
    let all = group(&["--all", "--layer"]);
    let moyo: Vec<BTreeSet<Key>> = (1..=116)
        .filter_map(|number| {
            let entry = layer_hall_symbol_entry(number)?;
            let setting = LayerSetting::HallNumber(number);
            operations_from_layer_number(entry.number, setting, false).ok()
        })
        .map(|operations| {
            let units = |value: &f64| ((value * 24.0).round() as i64).rem_euclid(24);
            let key = |operation: &moyo::base::Operation| {
                let shift = operation.translation_as_array();
                (
                    operation.rotation_as_array(),
                    [0, 1, 2].map(|i| units(&shift[i])),
                )
            };
            operations.iter().map(key).collect()
        })
        .collect();
    for group in all.as_array().expect("a list") {
        assert!(moyo.contains(&keys(group)), "{}", group["hm"]);
    }
}

#[test]
fn a_group_is_found_by_every_kind_of_symbol() {
    for text in [
        "227",
        "F d -3 m",
        "Fd-3m",
        "F d -3 m:2",
        "F 41/d -3 2/m",
        "Oh^7",
        "-F 4vw 2vw 3",
        "F_d 4 3",
    ] {
        let found = group(&[text]);
        assert_eq!(found["number"], 227, "{text}");
        assert_eq!(found["hm"], "F d -3 m", "{text}");
        assert_eq!(found["hall"], "-F 4vw 2vw 3", "{text}");
        assert_eq!(found["setting"]["choice"], "2", "{text}");
        assert_eq!(found["operations"].as_array().map(Vec::len), Some(192));
    }
    assert_eq!(group(&["F d -3 m:1"])["hall"], "F 4d 2 3 -1d");
    assert_eq!(
        group(&["R -3 c:R", "--cell", "6,55"])["centring"]
            .as_array()
            .map(Vec::len),
        Some(1)
    );
    assert_eq!(group(&["P 21/n"])["number"], 14);
    // The same text in two notations.
    let tetragonal = group(&["P 43"]);
    assert_eq!(
        (&tetragonal["number"], &tetragonal["also"][0]["number"]),
        (&78.into(), &221.into())
    );
    assert_eq!(group(&["P 43", "--notation", "geometric"])["number"], 221);
    assert_eq!(
        group(&["P 2", "--notation", "hall"])["setting"]["standard"],
        false
    );
    for (kind, text, number) in [
        ("--wallpaper", "p4g", 12),
        ("--wallpaper", "4*2", 12),
        ("--wallpaper", "442", 10),
        ("--frieze", "p 2 m g", 7),
        ("--layer", "p 4/n m m", 64),
        ("--rod", "p 42/m m c", 41),
        ("--plane", "17", 17),
    ] {
        assert_eq!(group(&[text, kind])["number"], number, "{kind} {text}");
    }
    for (text, order, name) in [
        ("4/mmm", 16, "D4h"),
        ("D4h", 16, "D4h"),
        ("42", 16, "D4h"),
        ("m-3m", 48, "Oh"),
        ("53", 120, "Ih"),
        ("b(5)b(3)", 60, "I"),
        ("I", 60, "I"),
        ("D5h", 20, "D5h"),
        ("D5d", 20, "D5d"),
        ("C7", 7, "C7"),
        ("C12v", 24, "C12v"),
        ("C5h", 10, "C5h"),
        ("S8", 8, "S8"),
        ("D12", 24, "D12"),
        ("-1", 2, "Ci"),
    ] {
        let found = group(&["--point", text]);
        assert_eq!(
            (&found["order"], &found["schoenflies"]),
            (&order.into(), &name.into()),
            "{text}"
        );
        assert_eq!(
            found["versors"].as_array().map(Vec::len),
            Some(order),
            "{text}"
        );
    }
}

#[test]
fn a_symbol_of_several_settings_takes_the_standard_one_and_says_so() {
    let directory = directory();
    let ran = run(directory.path(), &["group", "F d -3 m", "--json"]);
    assert_eq!(ran.code, 0);
    assert!(
        ran.stderr.starts_with("note: ") && ran.stderr.contains("`F d -3 m:1`"),
        "{}",
        ran.stderr
    );
    assert!(ran.stdout.starts_with('{'));
    // A number leaves nothing open.
    run(directory.path(), &["group", "227"]).well();
}

#[test]
fn a_point_is_told_its_wyckoff_position_and_orbit() {
    let found = group(&["227", "--cell", "5.43", "--at", "0.126,0.125,0.125"]);
    let site = &found["site"];
    assert_eq!(
        (&site["letter"], &site["multiplicity"]),
        (&"a".into(), &8.into())
    );
    assert_eq!(site["site_symmetry"], "-43m");
    assert_eq!(site["place"], serde_json::json!([0.125, 0.125, 0.125]));
    assert!((site["distance"].as_f64().unwrap() - 0.00543).abs() < 1e-9);
    assert_eq!(site["orbit"].as_array().map(Vec::len), Some(8));
    let exact = group(&[
        "227",
        "--cell",
        "5.43",
        "--at",
        "0.126,0.125,0.125",
        "--snap",
        "0.001",
    ]);
    assert_ne!(exact["site"]["letter"], "a");
    // The centre of fourfold rotation of p4gm, and its mirror.
    for (at, multiplicity) in [("0.004,0.003,0", 2), ("0.3,0.2,0", 4), ("0.1,0.23,0", 8)] {
        let site = &group(&["12", "--wallpaper", "--at", at])["site"];
        assert_eq!(site["multiplicity"], multiplicity, "{at}: {site}");
    }
    let wyckoff = &found["wyckoff"];
    let letters: Vec<&str> = wyckoff
        .as_array()
        .unwrap()
        .iter()
        .map(|p| p["letter"].as_str().unwrap())
        .collect();
    assert_eq!(letters.concat(), "abcdefghi");
}

#[test]
fn the_summary_has_the_terms_of_international_tables() {
    let directory = directory();
    let text = run(directory.path(), &["group", "62"]).well();
    for word in [
        "P n m a",
        "D2h^16",
        "mmm",
        "orthorhombic",
        "62",
        "P 21/n 21/m 21/a",
        "-P 2ac 2n",
        "oP",
        "(1) x,y,z",
        "Generators",
        "Positions",
        "T_",
    ] {
        assert!(text.contains(word), "{word} in {text}");
    }
    let general = text
        .lines()
        .find(|line| line.trim_start().starts_with("8  d"));
    assert!(
        general.is_some_and(|line| line.contains("(x,y,z)")),
        "{text}"
    );
    let list = run(directory.path(), &["group", "--all"]).well();
    assert_eq!(list.lines().count(), 231);
    let point = run(directory.path(), &["group", "--point", "53"]).well();
    assert!(
        point.contains("rotoreflection") && point.contains("order 120"),
        "{point}"
    );
    assert!(names(directory.path()).is_empty());
}
