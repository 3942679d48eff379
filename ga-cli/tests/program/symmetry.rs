//! `articulate crystal --symmetry`: the elements in JSON, and in the files.

use crate::run::{directory, names, run, shipped};
use serde_json::{Value, json};
use std::collections::BTreeMap;

fn elements(file: &str) -> Vec<Value> {
    let directory = directory();
    let words = ["crystal", &shipped(file), "--symmetry", "--json"];
    let value = run(directory.path(), &words).json();
    value["symmetry_elements"]
        .as_array()
        .expect("a list")
        .clone()
}

fn counts(elements: &[Value]) -> BTreeMap<(String, String), usize> {
    let mut counts = BTreeMap::new();
    for element in elements {
        let text = |name: &str| element[name].as_str().expect("a word").to_owned();
        *counts.entry((text("kind"), text("symbol"))).or_insert(0) += 1;
    }
    counts
}

#[test]
fn the_elements_of_quartz_are_those_of_its_hand() {
    let found = elements("quartz.cif");
    // P 32 2 1 in International Tables: three screws along c, twofold axes and screws across them.
    let expected = [
        ("rotation", "2", 6),
        ("screw", "2_1", 6),
        ("screw", "3_2", 3),
    ];
    let expected = expected.map(|(kind, symbol, n)| ((kind.to_owned(), symbol.to_owned()), n));
    assert_eq!(counts(&found), BTreeMap::from(expected));
    let screw = found
        .iter()
        .find(|element| element["symbol"] == "3_2")
        .expect("a screw");
    assert_eq!(screw["direction"], json!([0, 0, 1]));
    assert_eq!(screw["point"], json!([0.0, 0.0, 0.0]));
    let rise = screw["screw"][2].as_f64().expect("a number");
    assert!((rise - 2.0 / 3.0).abs() < 1e-12, "{rise}");
    assert!(screw.get("glide").is_none());
}

#[test]
fn planes_centres_and_rotoinversions_are_told_as_documented() {
    let found = elements("calcite.cif");
    let counted = counts(&found);
    let count = |kind: &str, symbol: &str| counted[&(kind.to_owned(), symbol.to_owned())];
    assert_eq!(count("rotoinversion", "-3"), 3);
    assert_eq!(count("glide", "c"), 3);
    assert_eq!(count("inversion", "-1"), 24);
    for element in &found {
        let kind = element["kind"].as_str().expect("a word");
        assert_eq!(
            element["point"].as_array().map(Vec::len),
            Some(3),
            "{element}"
        );
        assert_eq!(element.get("screw").is_some(), kind == "screw", "{element}");
        assert_eq!(element.get("glide").is_some(), kind == "glide", "{element}");
        assert_eq!(
            element["direction"].is_null(),
            kind == "inversion",
            "{element}"
        );
        if kind == "rotoinversion" {
            let points = element["inversion_points"].as_array().map(Vec::len);
            // The cell is three times as high as the lattice along c, with a centre in each half.
            assert_eq!(points, Some(2), "{element}");
        }
    }
}

#[test]
fn elements_are_drawn_only_when_asked_for() {
    let directory = directory();
    let halite = shipped("halite.cif");
    let plain = [
        "crystal",
        &halite,
        "--out",
        "plain.glb",
        "--out",
        "plain.json",
    ];
    run(directory.path(), &plain).well();
    let drawn = [
        "crystal",
        &halite,
        "--symmetry",
        "--out",
        "drawn.glb",
        "--out",
        "drawn.json",
    ];
    run(directory.path(), &drawn).well();
    assert_eq!(names(directory.path()).len(), 4);
    let read = |name: &str| std::fs::read(directory.path().join(name)).expect("the file is there");
    let nodes = |name: &str| {
        let model = gltf::Gltf::from_slice(&read(name)).expect("a valid GLB file");
        let nodes = model
            .nodes()
            .filter_map(|node| node.name().map(str::to_owned));
        nodes.collect::<Vec<_>>()
    };
    let is_symmetry = |name: &&String| name.starts_with("4_2") || name.starts_with("plane m");
    assert_eq!(nodes("plain.glb").iter().filter(is_symmetry).count(), 0);
    assert!(nodes("drawn.glb").iter().filter(is_symmetry).count() > 2);
    let json = |name: &str| serde_json::from_slice::<Value>(&read(name)).expect("JSON");
    assert!(json("plain.json").get("symmetry_elements").is_none());
    assert!(json("drawn.json")["symmetry_elements"].is_array());
}

#[test]
fn help_tells_the_contract() {
    let directory = directory();
    let help = run(directory.path(), &["crystal", "--help"]).well();
    for word in ["--symmetry", "symmetry_elements", "rotoinversion", "glide"] {
        assert!(help.contains(word), "{word}");
    }
}

#[test]
fn too_many_elements_are_refused_with_a_remedy() {
    let directory = directory();
    let file = directory.path().join("one.cif");
    let text = "data_x\n_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\n_cell_angle_alpha 90\n\
        _cell_angle_beta 90\n_cell_angle_gamma 90\n_space_group_name_H-M_alt 'F m -3 m'\nloop_\n\
        _atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nPo 0 0 0\n";
    std::fs::write(file, text).expect("the file is written");
    let words = [
        "crystal",
        "one.cif",
        "--symmetry",
        "--cells",
        "9x9x9",
        "--out",
        "x.stl",
    ];
    let message = run(directory.path(), &words).message(1);
    assert!(message.contains("one.cif: --symmetry"), "{message}");
    assert!(message.contains("ask for fewer cells"), "{message}");
    assert_eq!(names(directory.path()), ["one.cif"]);
}
