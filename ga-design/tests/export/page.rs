//! The gallery's page holds every scene, escapes every text, and needs nothing from elsewhere.

use crate::demo;
use ga_design::export::gallery::encode;
use ga_design::export::picture::Settings;
use ga_design::export::{Attachment, ExportError, Scene, glb, write_gallery};

const SMALL: Settings = Settings {
    width: 40,
    height: 30,
    samples: 1,
};

fn page(scenes: &[Scene]) -> String {
    let files = encode(scenes, &SMALL, |_| {}).unwrap();
    let (path, bytes) = files.last().unwrap();
    assert_eq!(path.to_str(), Some("index.html"));
    String::from_utf8(bytes.clone()).unwrap()
}

#[test]
fn the_page_embeds_each_model_and_escapes_each_text() {
    use base64::{Engine, engine::general_purpose::STANDARD};
    let scenes = [demo::crystal().unwrap(), demo::knot().unwrap()];
    let page = page(&scenes);
    assert!(page.contains("Halite &amp; &lt;its&gt; “cell”"));
    assert!(!page.contains("<its>"));
    for scene in &scenes {
        let mark = format!("id=\"model-{}\"", scene.name());
        let (_, after) = page.split_once(&mark).unwrap();
        let (_, after) = after.split_once('>').unwrap();
        let (model, _) = after.split_once("</script>").unwrap();
        assert_eq!(STANDARD.decode(model).unwrap(), glb::encode(scene).unwrap());
        for ending in ["glb", "png"] {
            assert!(page.contains(&format!("href=\"{}.{ending}\" download", scene.name())));
        }
    }
    assert!(!page.contains("{{"));
}

#[test]
fn hostile_texts_stay_texts() {
    let mut scene = demo::crystal().unwrap();
    let evil = "</h2><script>alert(1)</script>{{models}}{{cards}}'\" onload=\"x\u{0}";
    let mut hostile = Scene::new("hostile", evil, evil);
    let red = hostile.add_material(ga_design::export::Material::new(evil, [200, 40, 40]));
    hostile
        .add(evil, ga_design::mesh::icosphere(0).unwrap(), red)
        .unwrap();
    std::mem::swap(&mut scene, &mut hostile);
    let page = page(&[scene]);
    assert!(!page.contains("<script>alert"));
    assert!(!page.contains("onload=\"x"));
    assert_eq!(page.matches("id=\"model-hostile\"").count(), 1);
    assert_eq!(page.matches("<script").count(), 2);
}

#[test]
fn the_page_loads_nothing_from_elsewhere() {
    let page = page(&[demo::crystal().unwrap()]);
    for foreign in [
        "http://",
        "https://",
        "src=\"//",
        "@import",
        "fetch(",
        "XMLHttpRequest",
    ] {
        assert!(!page.contains(foreign), "{foreign}");
    }
}

#[test]
fn a_gallery_is_written_with_a_file_per_scene_and_kind() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("made/here");
    let mut scene = Scene::new("one", "One", "Just one.");
    let red = scene.add_material(ga_design::export::Material::new("red", [200, 40, 40]));
    scene
        .add("ball", ga_design::mesh::icosphere(0).unwrap(), red)
        .unwrap();
    let mut seen = Vec::new();
    let index = write_gallery(&[scene], &directory, &SMALL, |s| {
        seen.push(s.name().to_owned())
    })
    .unwrap();
    assert_eq!(index, directory.join("index.html"));
    assert_eq!(seen, ["one"]);
    let mut names: Vec<_> = std::fs::read_dir(&directory)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["index.html", "one.glb", "one.png"]);
}

fn with_drawings(names: &[&str]) -> Scene {
    let mut scene = demo::crystal().unwrap();
    for name in names {
        scene.attach(Attachment {
            name: (*name).to_owned(),
            svg: format!("<svg id=\"{name}\"/>"),
        });
    }
    scene
}

#[test]
fn drawings_are_written_into_a_folder_of_their_scene_and_linked() {
    let folder = tempfile::tempdir().unwrap();
    let scene = with_drawings(&["p1", "p31m"]);
    let name = scene.name().to_owned();
    let index = write_gallery(&[scene], folder.path(), &SMALL, |_| {}).unwrap();
    let page = std::fs::read_to_string(index).unwrap();
    for drawing in ["p1", "p31m"] {
        let path = format!("{name}/{drawing}.svg");
        let text = std::fs::read_to_string(folder.path().join(&path)).unwrap();
        assert_eq!(text, format!("<svg id=\"{drawing}\"/>"));
        assert!(page.contains(&format!("href=\"{path}\"")));
    }
}

#[test]
fn drawings_without_a_plain_name_of_their_own_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("gallery");
    for name in ["", "..", "a/b", "P1", "p 1", "p2̅"] {
        let scene = with_drawings(&[name]);
        let error = write_gallery(&[scene], &directory, &SMALL, |_| {}).unwrap_err();
        assert!(matches!(error, ExportError::SceneName { .. }), "{name}");
    }
    let scene = with_drawings(&["p1", "p1"]);
    let error = write_gallery(&[scene], &directory, &SMALL, |_| {}).unwrap_err();
    assert!(matches!(error, ExportError::RepeatedName { .. }));
    assert!(!directory.exists());
}

#[test]
fn names_that_are_no_file_names_are_refused_before_anything_is_made() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("gallery");
    for name in ["", "index", "Knot", "a b", "../up", "a/b", "ünder"] {
        let scene = Scene::new(name, "T", "C");
        let error = write_gallery(&[scene], &directory, &SMALL, |_| {}).unwrap_err();
        assert!(matches!(error, ExportError::SceneName { .. }), "{name}");
    }
    let twice = [demo::crystal().unwrap(), demo::crystal().unwrap()];
    let error = write_gallery(&twice, &directory, &SMALL, |_| {}).unwrap_err();
    assert!(matches!(error, ExportError::RepeatedName { .. }));
    let error = write_gallery(&[], &directory, &SMALL, |_| {}).unwrap_err();
    assert!(matches!(error, ExportError::EmptyScene { .. }));
    let error =
        write_gallery(&[Scene::new("bare", "T", "C")], &directory, &SMALL, |_| {}).unwrap_err();
    assert!(matches!(error, ExportError::EmptyScene { .. }));
    assert!(!directory.exists());
}
