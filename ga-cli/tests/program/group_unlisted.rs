//! `articulate group` on Hall symbols of settings that are in no table.

use crate::group::{group, judged, key, texts};
use crate::run::{directory, names, run};
use std::collections::BTreeSet;

#[test]
fn settings_of_no_table_are_told_with_number_and_change_of_basis() {
    for (hall, number, standard) in [
        ("-P 2ybc (1 2 5)", 14, "P 1 21/c 1"),
        ("-C 4 2", 123, "P 4/m m m"),
        ("-F 4 2 (1 2 5)", 139, "I 4/m m m"),
        ("P 2ac 2ab (1 0 0)", 19, "P 21 21 21"),
        ("-F 4vw 2vw 3 (1 2 5)", 227, "F d -3 m"),
    ] {
        let told = group(&[hall]);
        assert_eq!(told["number"], number, "{hall}");
        assert_eq!(told["hall"], hall);
        assert_eq!(told["notation"], "hall");
        assert_eq!(told["setting"]["standard"], false);
        let change = told["setting"]["from_standard"].as_str().expect("a change");
        assert_eq!(told["hm"], format!("{standard} ({change})"));
        let operations = texts(&told["operations"]);
        let keys: BTreeSet<_> = operations.iter().map(|triplet| key(triplet)).collect();
        assert_eq!(keys, judged(hall), "{hall}");
        assert_eq!(told["versors"].as_array().map(Vec::len), Some(keys.len()));
        let general = told["wyckoff"].as_array().and_then(|all| all.last());
        let multiplicity = general.map(|last| last["multiplicity"].clone());
        assert_eq!(multiplicity, Some(keys.len().into()), "{hall}");
    }
}

#[test]
fn what_is_unusual_about_them_is_noted() {
    let directory = directory();
    let ran = run(directory.path(), &["group", "-P 2ybc (1 2 5)"]);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(
        ran.stderr.starts_with("note: `-P 2ybc (1 2 5)`"),
        "{}",
        ran.stderr
    );
    assert!(
        ran.stderr.contains("P 1 21/c 1 (number 14)"),
        "{}",
        ran.stderr
    );
    assert!(ran.stdout.contains("-P 2ybc (1 2 5)"), "{}", ran.stdout);
}

#[test]
fn their_cells_points_and_pictures_are_those_of_the_setting() {
    let directory = directory();
    let words = [
        "group",
        "-C 4 2",
        "--cell",
        "8,8,6,90,90,90",
        "--at",
        "0,0,0",
        "--symmetry",
        "--out",
        "pattern.glb",
        "--json",
    ];
    let ran = run(directory.path(), &words);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let told: serde_json::Value = serde_json::from_str(&ran.stdout).expect("JSON");
    assert_eq!(told["cell"]["a"], 8.0);
    assert_eq!(told["lattice"]["centring"], "C");
    // Two lattice points in the cell.
    assert_eq!(told["site"]["multiplicity"], 2);
    assert_eq!(told["site"]["site_symmetry"], "4/mmm");
    assert_eq!(names(directory.path()), ["pattern.glb"]);
}

#[test]
fn cells_that_their_lattice_cannot_have_are_refused() {
    for (cell, reason) in [
        ("8,6", "all six parameters"),
        (
            "8,8,6,90,90,91",
            "in the standard setting, tetragonal needs",
        ),
        (
            "8,9,6,90,90,90",
            "in the standard setting, tetragonal needs",
        ),
        ("8,8,6,10,10,170", "angles"),
        ("8,8,x", "finite number"),
    ] {
        let directory = directory();
        let words = ["group", "-C 4 2", "--cell", cell];
        let message = run(directory.path(), &words).message(2);
        assert!(message.contains(reason), "{cell}: {message}");
    }
    let directory = directory();
    let words = ["group", "-C 4 2", "--notation", "international"];
    assert!(run(directory.path(), &words).message(2).contains("-C 4 2"));
}
