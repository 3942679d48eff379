//! `articulate tensegrity`: the JSON contract, files that independent readers accept, and what is refused.

use crate::run::{directory, names, run};
use serde_json::Value;

/// The words after `articulate tensegrity` and `--json`, read as JSON.
fn told(words: &[&str]) -> Value {
    let directory = directory();
    let mut all = vec!["tensegrity"];
    all.extend(words);
    all.push("--json");
    run(directory.path(), &all).json()
}

fn list(value: &Value) -> &Vec<Value> {
    value.as_array().expect("a list")
}

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = list(value)
        .iter()
        .map(|number| number.as_f64().expect("a number"));
    numbers.collect()
}

/// The forces on each node, from the contract alone: the largest sum.
fn unbalanced(value: &Value) -> f64 {
    let nodes: Vec<Vec<f64>> = list(&value["nodes"]).iter().map(numbers).collect();
    let members = list(&value["struts"]).iter().chain(list(&value["cables"]));
    let mut sums = vec![[0.0; 3]; nodes.len()];
    for (member, density) in members.zip(numbers(&value["self_stress"])) {
        let ends: Vec<usize> = numbers(member).iter().map(|&end| end as usize).collect();
        let [from, to] = [ends[0], ends[1]];
        for axis in 0..3 {
            let pull = density * (nodes[to][axis] - nodes[from][axis]);
            sums[from][axis] += pull;
            sums[to][axis] -= pull;
        }
    }
    sums.iter()
        .flatten()
        .fold(0.0, |so_far: f64, sum| so_far.max(sum.abs()))
}

/// Shape with its options, nodes, struts, cables.
const SHAPES: [(&[&str], usize, usize, usize); 12] = [
    (&["octahedron"], 12, 6, 24),
    (&["prism"], 6, 3, 9),
    (
        &[
            "prism", "--struts", "7", "--hand", "left", "--height", "0.5",
        ],
        14,
        7,
        21,
    ),
    (&["tower"], 24, 12, 54),
    (&["tower", "--struts", "4", "--stages", "2"], 16, 8, 32),
    (&["icosahedron", "--cable-ratio", "1.3"], 12, 6, 24),
    (&["rhombicuboctahedron"], 24, 12, 48),
    (
        &["truncated-tetrahedron", "--strut-length", "12"],
        12,
        6,
        18,
    ),
    (&["truncated-cube"], 24, 12, 36),
    (&["truncated-octahedron"], 24, 12, 36),
    (&["cuboctahedron"], 12, 12, 24),
    (&["icosidodecahedron"], 30, 30, 60),
];

#[test]
fn json_keeps_the_contract_for_every_shape() {
    for (words, nodes, struts, cables) in SHAPES {
        let value = told(words);
        let counts = ["nodes", "struts", "cables"].map(|name| list(&value[name]).len());
        assert_eq!(counts, [nodes, struts, cables], "{words:?}");
        let stress = numbers(&value["self_stress"]);
        assert_eq!(stress.len(), struts + cables, "{words:?}");
        assert!(
            stress[..struts].iter().all(|density| *density < 0.0),
            "{words:?}"
        );
        assert!(
            stress[struts..].iter().all(|density| *density > 0.0),
            "{words:?}"
        );
        assert!(unbalanced(&value) < 1e-10, "{words:?}");
        assert!(value["states"].as_u64() >= Some(1), "{words:?}");
        assert_eq!(value["stability"], "super-stable", "{words:?}");
        assert_eq!(value["proper"], true, "{words:?}");
        assert_eq!(value["nullity"], 4, "{words:?}");
        let states = value["states"].as_i64().expect("a number");
        let mechanisms = value["mechanisms"].as_i64().expect("a number");
        let members = (struts + cables) as i64;
        assert_eq!(
            states - mechanisms,
            members - 3 * nodes as i64 + 6,
            "{words:?}"
        );
        assert_eq!(numbers(&value["lengths"]["struts"]).len(), struts);
        assert_eq!(numbers(&value["classes"]["cables"]).len(), cables);
    }
}

#[test]
fn the_octahedron_has_the_numbers_of_the_literature() {
    let value = told(&["octahedron"]);
    assert_eq!(
        (&value["states"], &value["mechanisms"]),
        (&1.into(), &1.into())
    );
    let [struts, cables] = ["struts", "cables"].map(|name| numbers(&value["lengths"][name]));
    for cable in cables {
        assert!((cable / struts[0] - 0.375_f64.sqrt()).abs() < 1e-12);
    }
    let stress = numbers(&value["self_stress"]);
    assert!((stress[0] / stress[6] + 1.5).abs() < 1e-12);
    // The ratio as it is printed.
    assert_eq!(told(&["octahedron", "--ratio", "0.6123724"])["states"], 1);
    let off = told(&["octahedron", "--ratio", "0.65"]);
    assert_eq!(
        (&off["states"], &off["stability"]),
        (&0.into(), &"unstressed".into())
    );
    assert!(list(&off["self_stress"]).is_empty());
}

#[test]
fn twist_is_in_radians_or_in_degrees_and_decides_about_balance() {
    assert_eq!(told(&["prism", "--twist", "30deg"])["states"], 1);
    assert_eq!(
        told(&["prism", "--twist", "0.5235987755982988"])["states"],
        1
    );
    assert_eq!(told(&["prism", "--twist", "30"])["states"], 0);
    assert_eq!(told(&["prism", "--twist", "-30deg"])["states"], 0);
    let deep = told(&["tower", "--stages", "2", "--twist", "55deg"]);
    assert_eq!(deep["stability"], "super-stable");
}

#[test]
fn every_format_is_written_and_the_json_file_is_the_json_output() {
    let directory = directory();
    let files = [
        "t.glb", "t.obj", "t.stl", "t.ply", "t.png", "t.svg", "t.json",
    ];
    let mut words = vec!["tensegrity", "prism", "--json"];
    for file in files {
        words.extend(["--out", file]);
    }
    let printed = run(directory.path(), &words).well();
    let expected = [
        "t.glb", "t.json", "t.mtl", "t.obj", "t.ply", "t.png", "t.stl", "t.svg",
    ];
    assert_eq!(names(directory.path()), expected);
    let read = |name: &str| std::fs::read(directory.path().join(name)).expect("the file is there");
    assert_eq!(read("t.json"), printed.as_bytes());
    assert!(read("t.png").starts_with(b"\x89PNG"));
    assert!(read("t.ply").starts_with(b"ply"));
    let svg = String::from_utf8(read("t.svg")).expect("text");
    assert_eq!(svg.matches("<path").count(), 12);
    let model = gltf::Gltf::from_slice(&read("t.glb")).expect("a valid GLB file");
    let count = |word: &str| {
        let named = |node: &gltf::Node| node.name().is_some_and(|name| name.starts_with(word));
        model.nodes().filter(named).count()
    };
    assert_eq!(
        (count("strut "), count("cable "), count("node ")),
        (3, 9, 6)
    );
}

#[test]
fn the_summary_is_for_people() {
    let directory = directory();
    let text = run(directory.path(), &["tensegrity", "truncated-tetrahedron"]).well();
    for word in [
        "truncated tetrahedron",
        "super-stable",
        "states of self-stress",
        "struts 1",
        "cables 2",
    ] {
        assert!(text.contains(word), "{word} in {text}");
    }
    let words = ["tensegrity", "prism", "--out", "p.stl"];
    let text = run(directory.path(), &words).well();
    assert!(
        text.contains("p.stl") && text.contains("3 struts"),
        "{text}"
    );
}

#[test]
fn help_names_the_shapes_and_what_json_holds() {
    let directory = directory();
    let help = run(directory.path(), &["tensegrity", "--help"]).well();
    for word in [
        "octahedron",
        "prism",
        "tower",
        "truncated-icosahedron",
        "self_stress",
        "Examples:",
    ] {
        assert!(help.contains(word), "{word}");
    }
    let help = run(directory.path(), &["tensegrity", "tower", "--help"]).well();
    assert!(
        help.contains("--stages") && help.contains("45deg"),
        "{help}"
    );
}

#[test]
fn bad_usage_exits_with_2_and_names_the_remedy() {
    let directory = directory();
    let cases: [(&[&str], &str); 21] = [
        (&["prism", "--struts", "2"], "3..=60"),
        (&["prism", "--struts", "0"], "3..=60"),
        (&["prism", "--struts=-3"], "3..=60"),
        (&["prism", "--struts", "1000000"], "3..=60"),
        (&["prism", "--struts", "99999999999999999999"], "--struts"),
        (&["prism", "--struts", "NaN"], "--struts"),
        (&["prism", "--height", "0"], "1e-12"),
        (&["prism", "--radius", "inf"], "1e-12"),
        (&["prism", "--radius=-1"], "1e-12"),
        (&["prism", "--twist", "NaN"], "finite"),
        (&["prism", "--twist", "about"], "30deg"),
        (&["prism", "--hand", "both"], "left"),
        (&["tower", "--struts", "21"], "3..=20"),
        (&["tower", "--stages", "1"], "2..=40"),
        (&["tower", "--stages", "100000"], "2..=40"),
        (&["octahedron", "--ratio", "NaN"], "1e-12"),
        (&["octahedron", "--ratio", "abc"], "number"),
        (&["cuboctahedron", "--cable-ratio", "2"], "--cable-ratio"),
        (&["octahedron", "--out", "x.doc"], ".glb"),
        (&["dodecahedron"], "icosidodecahedron"),
        (&[], "octahedron"),
    ];
    for (words, remedy) in cases {
        let mut all = vec!["tensegrity"];
        all.extend(words);
        let ran = run(directory.path(), &all);
        assert_eq!(ran.code, 2, "{words:?}: {}", ran.stderr);
        assert!(
            ran.stdout.is_empty() && !ran.stderr.contains("panicked"),
            "{words:?}"
        );
        assert!(ran.stderr.contains(remedy), "{words:?}: {}", ran.stderr);
    }
    assert!(names(directory.path()).is_empty());
}

#[test]
fn what_no_structure_has_exits_with_1_and_leaves_no_file() {
    let directory = directory();
    let cases: [(&[&str], &str); 7] = [
        (&["octahedron", "--ratio", "0.5"], "0.6123724"),
        (&["octahedron", "--ratio", "0.9"], "0.7071068"),
        (&["tower", "--twist", "10deg"], "at no depth"),
        (
            &["tower", "--struts", "20", "--stages", "20"],
            "at most 240",
        ),
        (
            &["truncated-cube", "--cable-ratio", "1e9"],
            "ratio of lengths",
        ),
        (&["prism", "--twist", "1e300"], "the twist"),
        (
            &["prism", "--radius", "1e-12", "--height", "1e12"],
            "coincide",
        ),
    ];
    for (words, word) in cases {
        let mut all = vec!["tensegrity"];
        all.extend(words);
        all.extend(["--json", "--out", "x.glb", "--out", "x.json"]);
        let message = run(directory.path(), &all).message(1);
        assert!(message.contains(word), "{words:?}: {message}");
    }
    let words = [
        "tensegrity",
        "prism",
        "--out",
        "a.glb",
        "--out",
        "nowhere/x.obj",
    ];
    let message = run(directory.path(), &words).message(1);
    assert!(message.contains("nowhere/x."), "{message}");
    assert!(names(directory.path()).is_empty());
}
