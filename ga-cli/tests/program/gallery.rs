//! `articulate gallery`, and what the program says about itself.

use crate::run::{directory, names, run};
use std::fs;

#[test]
fn asked_for_scenes_are_drawn_with_their_page() {
    let directory = directory();
    let words = [
        "gallery",
        "--only",
        "halite,spiral",
        "--out",
        "here/pictures",
        "--json",
    ];
    let value = run(directory.path(), &words).json();
    let folder = directory.path().join("here/pictures");
    let expected = [
        "halite.glb",
        "halite.png",
        "index.html",
        "spiral.glb",
        "spiral.png",
    ];
    assert_eq!(names(&folder), expected);
    assert_eq!(value["index"], "here/pictures/index.html");
    let scenes = value["scenes"].as_array().expect("a list");
    assert_eq!(scenes.len(), 2);
    for scene in scenes {
        for file in ["glb", "png"] {
            let file = scene[file].as_str().expect("a path");
            assert!(directory.path().join(file).is_file());
        }
        assert!(
            scene["title"]
                .as_str()
                .is_some_and(|title| !title.is_empty())
        );
        assert!(
            scene["caption"]
                .as_str()
                .is_some_and(|caption| caption.len() > 40)
        );
    }
    let page = fs::read_to_string(folder.join("index.html")).expect("the page is there");
    assert!(page.contains("Halite") && page.contains("String of pearls"));
    for elsewhere in ["src=\"http", "href=\"http", "@import", "fetch("] {
        assert!(!page.contains(elsewhere), "the page needs {elsewhere}");
    }
}

/// The plane groups with the commas of either hand in a cell, by International Tables A.
const PLANE_GROUPS: [(&str, usize, usize); 17] = [
    ("c2mm", 4, 4),
    ("cm", 2, 2),
    ("p1", 1, 0),
    ("p2", 2, 0),
    ("p2gg", 2, 2),
    ("p2mg", 2, 2),
    ("p2mm", 2, 2),
    ("p3", 3, 0),
    ("p31m", 3, 3),
    ("p3m1", 3, 3),
    ("p4", 4, 0),
    ("p4gm", 4, 4),
    ("p4mm", 4, 4),
    ("p6", 6, 0),
    ("p6mm", 6, 6),
    ("pg", 1, 1),
    ("pm", 1, 1),
];

#[test]
fn the_plane_groups_are_drawn_as_svg_too() {
    let directory = directory();
    let words = ["gallery", "--only", "plane-groups", "--json"];
    let value = run(directory.path(), &words).json();
    let folder = directory.path().join("gallery");
    let expected = [
        "index.html",
        "plane-groups",
        "plane-groups.glb",
        "plane-groups.png",
    ];
    assert_eq!(names(&folder), expected);
    let files: Vec<String> = PLANE_GROUPS
        .iter()
        .map(|(symbol, ..)| format!("{symbol}.svg"))
        .collect();
    assert_eq!(names(&folder.join("plane-groups")), files);
    let listed = value["scenes"][0]["svg"].as_array().expect("a list");
    assert_eq!(listed.len(), 17);
    for file in listed {
        let file = file.as_str().expect("a path");
        assert!(directory.path().join(file).is_file(), "{file}");
    }
    let page = fs::read_to_string(folder.join("index.html")).expect("the page is there");
    for (symbol, turned, mirrored) in PLANE_GROUPS {
        assert!(page.contains(&format!("href=\"plane-groups/{symbol}.svg\"")));
        let path = folder.join(format!("plane-groups/{symbol}.svg"));
        let text = fs::read_to_string(path).expect("the drawing is there");
        let drawing = roxmltree::Document::parse(&text).expect("well-formed");
        let commas = |fill: &str| {
            let nodes = drawing.descendants();
            nodes
                .filter(|node| node.attribute("fill") == Some(fill))
                .count()
        };
        // In 4×3 cells.
        let found = [commas("#2668b2"), commas("#e27024")];
        assert_eq!(found, [12 * turned, 12 * mirrored], "{symbol}");
        // The command for one group draws the same.
        let words = ["group", symbol, "--wallpaper", "--out", "alone.svg"];
        run(directory.path(), &words).well();
        let alone = fs::read_to_string(directory.path().join("alone.svg")).expect("a drawing");
        assert!(is_same_drawing(&alone, &text), "{symbol}");
    }
}

/// Whether all words are the same and all numbers, up to the rounding of their last digit.
fn is_same_drawing(one: &str, other: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        let parts = text.split([' ', '"', 'M', 'L', 'Z']);
        parts.map(str::to_owned).collect()
    };
    let (one, other) = (words(one), words(other));
    let close = |a: &String, b: &String| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() < 0.011,
        _ => a == b,
    };
    one.len() == other.len() && one.iter().zip(&other).all(|(a, b)| close(a, b))
}

#[test]
fn a_gallery_whose_drawings_have_no_place_is_not_begun() {
    let directory = directory();
    fs::create_dir(directory.path().join("gallery")).expect("a folder");
    fs::write(directory.path().join("gallery/plane-groups"), "a file").expect("a file");
    let message = run(directory.path(), &["gallery", "--only", "plane-groups"]).message(1);
    assert!(message.contains("plane-groups"), "{message}");
    assert_eq!(names(&directory.path().join("gallery")), ["plane-groups"]);
}

#[test]
fn people_are_told_where_to_look() {
    let directory = directory();
    let text = run(directory.path(), &["gallery", "--only", "halite"]).well();
    assert!(text.contains("gallery/index.html"), "{text}");
    assert!(directory.path().join("gallery/index.html").is_file());
}

#[test]
fn an_unknown_scene_is_answered_with_the_names_and_the_likely_one() {
    let directory = directory();
    let message = run(directory.path(), &["gallery", "--only", "quarz"]).message(2);
    assert!(
        message.contains("'quartz'") && message.contains("kaleidoscope"),
        "{message}"
    );
    assert!(names(directory.path()).is_empty());
}

#[test]
fn every_scene_can_be_made_and_has_words_to_it() {
    for entry in ga_design::gallery::entries() {
        let scene = entry.scene().expect(entry.name);
        assert_eq!(scene.name(), entry.name);
        assert!(
            !scene.title().is_empty() && scene.caption().len() > 40,
            "{}",
            entry.name
        );
        assert!(!scene.nodes().is_empty());
    }
}

#[test]
fn the_program_explains_itself() {
    let directory = directory();
    let help = run(directory.path(), &["--help"]).well();
    for word in [
        "gallery",
        "group",
        "crystal",
        "tensegrity",
        "expand",
        "Examples:",
    ] {
        assert!(help.contains(word), "{word}");
    }
    for command in ["gallery", "group", "crystal", "tensegrity", "expand"] {
        let help = run(directory.path(), &[command, "--help"]).well();
        assert!(
            help.contains("Examples:") && help.contains("--json"),
            "{command}"
        );
    }
    let version = run(directory.path(), &["--version"]).well();
    assert_eq!(
        version,
        format!("articulate {}\n", env!("CARGO_PKG_VERSION"))
    );
}
