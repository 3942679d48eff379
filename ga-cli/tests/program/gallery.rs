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
