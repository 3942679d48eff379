//! `articulate crystal` on good input: the JSON contract, and files that independent readers accept.

use crate::run::{crystals, directory, names, program, run, shipped, spheres};
use std::f64::consts::FRAC_PI_2;
use std::process::Stdio;

/// File, number of the space group, atoms in the unit cell, density in g/cm³ as mineralogists give it.
const KNOWN: [(&str, u64, usize, f64); 7] = [
    ("calcite.cif", 167, 30, 2.71),
    ("diamond.cif", 227, 8, 3.51),
    ("halite.cif", 225, 8, 2.16),
    ("pyrite.cif", 205, 12, 5.01),
    ("quartz.cif", 154, 9, 2.65),
    ("rutile.cif", 136, 6, 4.25),
    // 56 ions; magnesium and aluminium share the 24 sites of metals.
    ("spinel.cif", 227, 80, 3.58),
];

#[test]
fn every_shipped_crystal_is_among_the_known() {
    let known: Vec<_> = KNOWN.iter().map(|row| row.0.to_owned()).collect();
    assert_eq!(names(&crystals()), known);
}

#[test]
fn json_and_glb_hold_the_atoms_of_the_unit_cell() {
    let directory = directory();
    for (file, number, atoms, density) in KNOWN {
        let glb = directory.path().join("out.glb");
        let words = ["crystal", &shipped(file), "--json", "--out", "out.glb"];
        let value = run(directory.path(), &words).json();
        assert_eq!(value["number"], number, "{file}");
        assert_eq!(
            value["atoms"].as_array().map(Vec::len),
            Some(atoms),
            "{file}"
        );
        assert_eq!(spheres(&glb), atoms, "{file}");
        let found = value["density"].as_f64().unwrap_or(f64::NAN);
        assert!((found - density).abs() < 0.03, "{file}: {found}");
    }
}

#[test]
fn json_keeps_the_contract() {
    let directory = directory();
    let value = run(
        directory.path(),
        &["crystal", &shipped("quartz.cif"), "--json"],
    )
    .json();
    assert_eq!(value["hm"], "P 32 2 1");
    let cell = &value["cell"];
    assert_eq!((&cell["a"], &cell["c"]), (&4.916.into(), &5.4054.into()));
    // Radians, and degrees only where `deg` is written.
    assert_eq!(cell["alpha"], FRAC_PI_2);
    assert_eq!(cell["alpha_deg"], 90.0);
    assert_eq!(cell["gamma_deg"], 120.0);
    assert!((cell["gamma"].as_f64().unwrap_or(0.0) - 4.0 / 3.0 * FRAC_PI_2).abs() < 1e-15);
    for atom in value["atoms"].as_array().expect("a list") {
        assert!(atom["label"].is_string() && atom["element"].is_string());
        assert_eq!(atom["occupancy"], 1.0);
        let numbers = |name: &str| -> Vec<f64> {
            let list = atom[name].as_array().expect("a list");
            list.iter().filter_map(serde_json::Value::as_f64).collect()
        };
        let (fract, cart) = (numbers("fract"), numbers("cart"));
        assert_eq!((fract.len(), cart.len()), (3, 3));
        assert!(fract.iter().all(|f| (0.0..1.0).contains(f)));
        // The hexagonal frame: a along x, b at 120° from it.
        let expected = [
            4.916 * (fract[0] - 0.5 * fract[1]),
            4.916 * 0.75_f64.sqrt() * fract[1],
            5.4054 * fract[2],
        ];
        for (found, expected) in cart.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9);
        }
    }
}

#[test]
fn cells_multiply_the_spheres_but_not_the_atoms_of_the_unit_cell() {
    let directory = directory();
    for (cells, count) in [("2x2x2", 8), ("3", 27), ("-1:1x0:1x0:2", 4)] {
        let words = [
            "crystal",
            &shipped("quartz.cif"),
            "--cells",
            cells,
            "--out",
            "q.glb",
            "--json",
        ];
        let value = run(directory.path(), &words).json();
        assert_eq!(value["atoms"].as_array().map(Vec::len), Some(9), "{cells}");
        assert_eq!(value["cells"]["atoms"], 9 * count, "{cells}");
        assert_eq!(
            spheres(&directory.path().join("q.glb")),
            9 * count,
            "{cells}"
        );
    }
}

#[test]
fn every_format_is_written_and_the_json_file_is_the_json_output() {
    let directory = directory();
    let halite = shipped("halite.cif");
    let mut words = vec!["crystal", &halite, "--json"];
    for file in ["h.glb", "h.OBJ", "h.stl", "h.ply", "h.png", "h.json"] {
        words.extend(["--out", file]);
    }
    let ran = run(directory.path(), &words).well();
    let expected = [
        "h.OBJ", "h.glb", "h.json", "h.mtl", "h.ply", "h.png", "h.stl",
    ];
    assert_eq!(names(directory.path()), expected);
    let read = |name: &str| std::fs::read(directory.path().join(name)).expect("the file is there");
    assert_eq!(read("h.json"), ran.as_bytes());
    assert!(read("h.glb").starts_with(b"glTF"));
    assert!(read("h.png").starts_with(b"\x89PNG"));
    assert!(read("h.ply").starts_with(b"ply"));
}

#[test]
fn the_summary_is_for_people() {
    let directory = directory();
    let text = run(directory.path(), &["crystal", &shipped("calcite.cif")]).well();
    for word in ["Calcite", "C6 Ca6 O18", "R -3 c", "167", "g/cm³", "30"] {
        assert!(text.contains(word), "{word} in {text}");
    }
    assert!(names(directory.path()).is_empty());
}

#[test]
fn warnings_do_not_mix_with_json() {
    let directory = directory();
    let file = directory.path().join("odd.cif");
    let text = std::fs::read_to_string(shipped("halite.cif")).expect("the file is there");
    let number = text.replace(
        "_space_group_IT_number",
        "_space_group_name_H-M_alt 'P 1'\n_space_group_IT_number",
    );
    std::fs::write(&file, number).expect("the file is written");
    let ran = run(directory.path(), &["crystal", "odd.cif", "--json"]);
    // Whether it is accepted or refused, standard output holds JSON or nothing.
    if ran.code == 0 {
        assert!(serde_json::from_str::<serde_json::Value>(&ran.stdout).is_ok());
        assert!(
            ran.stderr.starts_with("warning: odd.cif:"),
            "{}",
            ran.stderr
        );
    } else {
        assert!(ran.message(1).contains("odd.cif:"));
    }
}

#[test]
fn a_reader_that_stops_reading_is_no_failure() {
    let directory = directory();
    let quartz = shipped("quartz.cif");
    let mut child = program(directory.path(), &["crystal", &quartz, "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
}

#[test]
fn bonds_are_told_and_shown_unless_left_out() {
    let directory = directory();
    let quartz = shipped("quartz.cif");
    let words = ["crystal", &quartz, "--json", "--out", "q.glb"];
    let value = run(directory.path(), &words).json();
    let bonds = value["bonds"].as_array().expect("a list");
    // Three silicons with four oxygens each.
    assert_eq!(bonds.len(), 12);
    for bond in bonds {
        let length = bond["length"].as_f64().expect("a number");
        assert!((1.59..1.63).contains(&length), "{bond}");
        let ends: Vec<&str> = (0..2)
            .filter_map(|end| {
                let at = bond["atoms"][end].as_u64()?;
                value["atoms"][usize::try_from(at).ok()?]["element"].as_str()
            })
            .collect();
        assert!(ends == ["Si", "O"] || ends == ["O", "Si"], "{bond}");
        assert_eq!(bond["image"].as_array().map(Vec::len), Some(3));
    }
    for atom in value["atoms"].as_array().expect("a list") {
        let expected = if atom["element"] == "Si" { 4 } else { 2 };
        assert_eq!(atom["coordination"], expected, "{atom}");
    }
    let rods = |file: &str| {
        let bytes = std::fs::read(directory.path().join(file)).expect("the file is there");
        let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
        let is_rod = |node: &gltf::Node| node.mesh().is_some_and(|mesh| mesh.name() == Some("rod"));
        model.nodes().filter(is_rod).count()
    };
    // Bonds inside the cell only, each of two halves.
    let inside = bonds
        .iter()
        .filter(|bond| bond["image"] == serde_json::json!([0, 0, 0]));
    assert_eq!(rods("q.glb"), 2 * inside.count());
    let words = [
        "crystal",
        &quartz,
        "--json",
        "--no-bonds",
        "--out",
        "bare.glb",
    ];
    let value = run(directory.path(), &words).json();
    assert!(value["bonds"].is_null() && value["atoms"][0]["coordination"].is_null());
    assert_eq!(rods("bare.glb"), 0);
    // The last word counts.
    let words = ["crystal", &quartz, "--json", "--no-bonds", "--bonds"];
    assert!(run(directory.path(), &words).json()["bonds"].is_array());
}

#[test]
fn large_blocks_are_instances_without_bonds_unless_asked_for() {
    let directory = directory();
    let halite = shipped("halite.cif");
    let glb = directory.path().join("h.glb");
    let words = [
        "crystal", &halite, "--cells", "14", "--json", "--out", "h.glb",
    ];
    let value = run(directory.path(), &words).json();
    assert!(value["bonds"].is_null());
    assert_eq!(value["cells"]["atoms"], 21_952);
    // A sphere for each element, and the extension that repeats it.
    assert_eq!(spheres(&glb), 2);
    let bytes = std::fs::read(&glb).expect("the file is there");
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.contains("EXT_mesh_gpu_instancing"));
    let words = ["crystal", &halite, "--cells", "14", "--bonds", "--json"];
    assert_eq!(
        run(directory.path(), &words).json()["bonds"]
            .as_array()
            .map(Vec::len),
        Some(24)
    );
    // What cannot be spelled out is refused, and nothing is left.
    let words = [
        "crystal", &halite, "--cells", "26", "--out", "h.stl", "--out", "big.glb",
    ];
    let message = run(directory.path(), &words).message(1);
    assert!(message.starts_with("error: h.stl: "), "{message}");
    assert!(message.contains("ten million triangles"), "{message}");
    assert_eq!(names(directory.path()), ["h.glb"]);
}

#[test]
fn cif_and_xyz_hold_the_crystal() {
    let directory = directory();
    for (file, number, atoms, _) in KNOWN {
        let shipped = shipped(file);
        let words = [
            "crystal", &shipped, "--json", "--out", "one.cif", "--out", "one.xyz",
        ];
        let first = run(directory.path(), &words).json();
        let again = run(directory.path(), &["crystal", "one.cif", "--json"]).json();
        assert_eq!(again["number"], number, "{file}");
        for part in ["name", "hm", "cell", "atoms", "bonds"] {
            assert_eq!(again[part], first[part], "{file}: {part}");
        }
        let words = ["crystal", &shipped, "--cells", "2x1x1", "--out", "two.cif"];
        run(directory.path(), &words).well();
        let block = run(directory.path(), &["crystal", "two.cif", "--json"]).json();
        assert_eq!(block["number"], 1, "{file}");
        assert_eq!(block["atoms"].as_array().map(Vec::len), Some(2 * atoms));
        let density = |value: &serde_json::Value| value["density"].as_f64().expect("a number");
        assert!((density(&block) - density(&first)).abs() < 1e-9, "{file}");
        let xyz = std::fs::read_to_string(directory.path().join("one.xyz")).expect("the file");
        assert_eq!(
            xyz.lines().next(),
            Some(atoms.to_string().as_str()),
            "{file}"
        );
        assert_eq!(xyz.lines().count(), atoms + 2, "{file}");
    }
}

#[test]
fn help_tells_everything_about_crystals() {
    let directory = directory();
    let help = run(directory.path(), &["crystal", "--help"]).well();
    for word in [
        "--cells",
        "--out",
        ".xyz",
        ".extxyz",
        ".cif",
        ".json",
        "--bonds",
        "--no-bonds",
        "coordination",
        "EXT_mesh_gpu_instancing",
        "ten million triangles",
        "Jmol",
        "asymmetric unit",
    ] {
        assert!(help.contains(word), "{word} in {help}");
    }
}

#[test]
fn a_crystal_too_crowded_for_bonds_is_given_without_them() {
    let directory = directory();
    let text = std::fs::read_to_string(shipped("halite.cif")).expect("the file is there");
    let crowded = text.replace("5.6401", "0.1");
    assert_ne!(crowded, text);
    std::fs::write(directory.path().join("tiny.cif"), crowded).expect("the file is written");
    let ran = run(directory.path(), &["crystal", "tiny.cif", "--json"]);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(
        ran.stderr.starts_with("warning: tiny.cif: the atoms crowd"),
        "{}",
        ran.stderr
    );
    let value: serde_json::Value = serde_json::from_str(&ran.stdout).expect("JSON");
    assert!(value["bonds"].is_null());
    // Who asks for them is told that they cannot be had.
    let words = ["crystal", "tiny.cif", "--bonds", "--out", "x.glb"];
    let message = run(directory.path(), &words).message(1);
    assert!(
        message.starts_with("error: tiny.cif: the atoms crowd"),
        "{message}"
    );
    assert_eq!(names(directory.path()), ["tiny.cif"]);
}
