//! The files of `articulate group`: that independent readers accept them, and find in them what was asked
//! for.

use crate::run::{directory, names, run};
use serde_json::Value;
use std::fs;

#[test]
fn a_motif_becomes_files_that_others_read() {
    let directory = directory();
    let words = [
        "group", "62", "--motif", "hand", "--cells", "2x1x1", "--json", "--out", "a.glb", "--out",
        "a.obj", "--out", "a.stl", "--out", "a.ply", "--out", "a.svg", "--out", "a.json",
    ];
    let ran = run(directory.path(), &words).well();
    let told: Value = serde_json::from_str(&ran).expect("JSON");
    assert_eq!(
        (&told["motif"]["copies"], &told["motif"]["name"]),
        (&16.into(), &"hand".into())
    );
    let expected = [
        "a.glb", "a.json", "a.mtl", "a.obj", "a.ply", "a.stl", "a.svg",
    ];
    assert_eq!(names(directory.path()), expected);
    let read = |name: &str| fs::read(directory.path().join(name)).expect("the file is there");
    assert_eq!(read("a.json"), ran.as_bytes());
    let model = gltf::Gltf::from_slice(&read("a.glb")).expect("a valid GLB file");
    let hands = |mirrored: bool| {
        let of_hand = |node: &gltf::Node| {
            let name = node.mesh().and_then(|mesh| mesh.name().map(str::to_owned));
            name.is_some_and(|name| {
                name.starts_with("hand") && name.contains("mirrored") == mirrored
            })
        };
        model.nodes().filter(of_hand).count()
    };
    // Half the operations change the hand.
    assert_eq!((hands(false), hands(true)), (8, 8));
    let text = String::from_utf8(read("a.svg")).expect("UTF-8");
    let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
    let paths = drawing
        .descendants()
        .filter(|node| node.has_tag_name("path"));
    // Twelve edges of each of two cells, and the strokes of sixteen hands.
    assert!(paths.count() > 24 + 16);
}

#[test]
fn a_group_of_the_plane_is_drawn_with_filled_commas() {
    let directory = directory();
    for (text, copies, mirrored) in [
        ("p1", 12, 0),
        ("p4g", 96, 48),
        ("cm", 48, 24),
        ("p6m", 144, 72),
    ] {
        run(
            directory.path(),
            &["group", text, "--wallpaper", "--out", "w.svg"],
        )
        .well();
        let text = fs::read_to_string(directory.path().join("w.svg")).expect("the file is there");
        let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
        let motifs: Vec<_> = drawing
            .descendants()
            .filter(|node| node.attribute("class") == Some("motif"))
            .collect();
        assert_eq!(motifs.len(), copies);
        let of_second = motifs
            .iter()
            .filter(|node| node.attribute("fill") == Some("#e27024"));
        assert_eq!(of_second.count(), mirrored);
    }
}

#[test]
fn a_motif_may_come_from_a_file() {
    let directory = directory();
    let write = |name: &str, text: &str| {
        fs::write(directory.path().join(name), text).expect("the file is written");
    };
    write(
        "t.obj",
        "v 0 0 0\nv 3 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    );
    write(
        "w.xyz",
        "3\nwater\nO 0 0 0\nH 0.76 0.59 0\nH -0.76 0.59 0\n",
    );
    write(
        "t.stl",
        "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
         endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\n\
         endfacet\nendsolid t\n",
    );
    for (motif, parts) in [("t.obj", 1), ("w.xyz", 3), ("t.stl", 1)] {
        let words = [
            "group",
            "P 21 21 21",
            "--motif",
            motif,
            "--out",
            "m.glb",
            "--out",
            "m.svg",
        ];
        run(directory.path(), &words).well();
        let bytes = fs::read(directory.path().join("m.glb")).expect("the file is there");
        let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
        let is_copy =
            |node: &gltf::Node| node.mesh().is_some_and(|mesh| mesh.name() != Some("cell"));
        assert_eq!(model.nodes().filter(is_copy).count(), 4 * parts, "{motif}");
    }
    // Atoms on a special position are merged: sodium chloride has four at the origin.
    write("na.xyz", "1\n\nNa 0 0 0\n");
    let words = [
        "group", "225", "--at", "0,0,0", "--motif", "na.xyz", "--out", "na.glb",
    ];
    run(directory.path(), &words).well();
    let bytes = fs::read(directory.path().join("na.glb")).expect("the file is there");
    let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
    let atoms = model
        .nodes()
        .filter(|node| node.mesh().is_some_and(|mesh| mesh.name() != Some("cell")));
    assert_eq!(atoms.count(), 4);
}

#[test]
fn symmetry_elements_are_listed_and_drawn() {
    let directory = directory();
    let words = [
        "group",
        "19",
        "--symmetry",
        "--json",
        "--out",
        "s.glb",
        "--out",
        "s.svg",
    ];
    let told = run(directory.path(), &words).json();
    let elements = told["symmetry_elements"].as_array().expect("a list");
    assert!(
        elements.iter().all(|element| element["symbol"] == "2_1"),
        "{elements:?}"
    );
    let bytes = fs::read(directory.path().join("s.glb")).expect("the file is there");
    let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
    let drawn = model
        .nodes()
        .filter(|node| node.name().is_some_and(|name| name.starts_with("2_1")));
    assert!(drawn.count() > 3);
    let text = fs::read_to_string(directory.path().join("s.svg")).expect("the file is there");
    let drawing = roxmltree::Document::parse(&text).expect("well-formed XML");
    let named = drawing
        .descendants()
        .filter(|node| node.text() == Some("2_1"));
    assert!(named.count() > 3);
}
