//! What cannot be saved is refused with a remedy, and leaves nothing behind.

use crate::demo;
use ga_design::export::write::{create_directory, write_file, write_files};
use ga_design::export::{ExportError, Format, Line, Material, Placement, Scene, View, save};
use ga_design::mesh;
use std::fs;
use std::path::Path;

fn names_in(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

#[test]
fn save_writes_what_the_ending_asks_for() {
    let folder = tempfile::tempdir().unwrap();
    let scene = demo::knot().unwrap();
    for ending in ["glb", "obj", "stl", "ply", "svg"] {
        save(&scene, &folder.path().join(format!("knot.{ending}"))).unwrap();
    }
    let expected = [
        "knot.glb", "knot.mtl", "knot.obj", "knot.ply", "knot.stl", "knot.svg",
    ];
    assert_eq!(names_in(folder.path()), expected);
    let text = fs::read_to_string(folder.path().join("knot.obj")).unwrap();
    assert!(text.contains("mtllib knot.mtl\n"));
}

#[test]
fn an_unknown_ending_is_answered_with_the_known_ones() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["knot.doc", "knot", "knot.", ".glb", "glb"] {
        let path = folder.path().join(name);
        let error = save(&demo::knot().unwrap(), &path).unwrap_err();
        assert!(matches!(error, ExportError::UnknownEnding { .. }), "{name}");
        let message = error.to_string();
        assert!(message.contains(name) && message.contains(".glb .obj .stl .ply .svg .png"));
    }
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn a_missing_directory_is_named_and_not_made() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("missing/knot.glb");
    let message = save(&demo::knot().unwrap(), &path).unwrap_err().to_string();
    assert!(message.contains("missing/knot.glb") && message.contains("make its directory first"));
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn a_directory_in_the_place_of_a_file_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("taken.glb");
    fs::create_dir(&path).unwrap();
    let message = save(&demo::knot().unwrap(), &path).unwrap_err().to_string();
    assert!(message.contains("it is a directory"), "{message}");
    assert_eq!(names_in(folder.path()), ["taken.glb"]);
    let under_file = folder.path().join("file/x.glb");
    fs::write(folder.path().join("file"), "text").unwrap();
    assert!(save(&demo::knot().unwrap(), &under_file).is_err());
    assert!(create_directory(&under_file).is_err());
    assert_eq!(
        fs::read_to_string(folder.path().join("file")).unwrap(),
        "text"
    );
}

#[test]
fn files_that_belong_together_come_together_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    // The materials cannot be written, so the geometry must not be either.
    fs::create_dir(folder.path().join("knot.mtl")).unwrap();
    assert!(save(&demo::knot().unwrap(), &folder.path().join("knot.obj")).is_err());
    assert_eq!(names_in(folder.path()), ["knot.mtl"]);
    let files = [
        (folder.path().join("a"), b"a".to_vec()),
        (folder.path().join("missing/b"), b"b".to_vec()),
    ];
    assert!(write_files(&files).is_err());
    assert_eq!(names_in(folder.path()), ["knot.mtl"]);
}

#[test]
fn an_existing_file_is_replaced_whole_and_keeps_its_permissions() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.txt");
    fs::write(&path, "a long text that is longer than the new one").unwrap();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write_file(&path, b"new").unwrap();
        assert_eq!(
            fs::metadata(&path).unwrap().permissions().mode() & 0o777,
            0o640
        );
    }
    write_file(&path, b"newer").unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "newer");
    assert_eq!(names_in(folder.path()), ["a.txt"]);
}

#[cfg(unix)]
#[test]
fn links_and_devices_are_written_through_and_new_files_are_readable_by_others() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt};
    let folder = tempfile::tempdir().unwrap();
    let [target, link] = ["target", "link"].map(|name| folder.path().join(name));
    fs::write(&target, "old").unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    write_file(&link, b"new").unwrap();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(&target).unwrap(), "new");
    write_file(Path::new("/dev/null"), b"gone").unwrap();
    assert!(
        fs::metadata("/dev/null")
            .unwrap()
            .file_type()
            .is_char_device()
    );
    // As a file made in the ordinary way, whatever the umask.
    let [ours, plain] = ["ours", "plain"].map(|name| folder.path().join(name));
    write_file(&ours, b"x").unwrap();
    fs::write(&plain, b"x").unwrap();
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
    assert_eq!(mode(&ours), mode(&plain));
}

#[test]
fn an_empty_scene_has_no_file() {
    let folder = tempfile::tempdir().unwrap();
    for format in Format::ALL {
        let path = folder.path().join(format!("empty.{}", format.ending()));
        let error = save(&Scene::new("empty", "Nothing", ""), &path).unwrap_err();
        assert!(matches!(error, ExportError::EmptyScene { .. }));
    }
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn a_format_that_cannot_hold_the_scene_says_so() {
    let mut scene = Scene::new("line", "A line", "");
    let ink = scene.add_material(Material::new("ink", [0; 3]));
    let line = Line::new(vec![[0.0; 3], [1.0; 3]], false).unwrap();
    scene.add("line", line, ink).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for ending in ["stl", "ply"] {
        let error = save(&scene, &folder.path().join(format!("line.{ending}"))).unwrap_err();
        assert!(error.to_string().contains("no surfaces"), "{error}");
    }
    let error = save(&demo::crystal().unwrap(), &folder.path().join("a.svg")).unwrap_err();
    assert!(error.to_string().contains("no lines"), "{error}");
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn numbers_that_are_none_are_refused_where_they_enter() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(Placement::at([0.0, bad, 0.0]).is_err());
        assert!(Placement::default().scaled([1.0, 1.0, bad]).is_err());
        assert!(Placement::default().rotated([bad, 0.0, 0.0, 1.0]).is_err());
        assert!(Line::new(vec![[0.0; 3], [bad; 3]], false).is_err());
        assert!(Material::new("m", [0; 3]).with_opacity(bad).is_err());
        assert!(Material::new("m", [0; 3]).with_roughness(bad).is_err());
        assert!(Material::new("m", [0; 3]).with_metallic(bad).is_err());
        let mut scene = Scene::new("s", "S", "");
        assert!(
            scene
                .set_view(View {
                    azimuth: bad,
                    elevation: 0.0
                })
                .is_err()
        );
        assert!(
            scene
                .set_view(View {
                    azimuth: 0.0,
                    elevation: bad
                })
                .is_err()
        );
    }
    assert!(Placement::default().rotated([0.0; 4]).is_err());
    assert!(Placement::default().scaled([0.0, 1.0, 1.0]).is_err());
    assert!(Placement::default().scaled([-1.0, 1.0, 1.0]).is_err());
    assert!(Material::new("m", [0; 3]).with_opacity(1.01).is_err());
    assert!(Line::new(vec![[0.0; 3]], false).is_err());
}

#[test]
fn a_node_of_another_scene_or_out_of_reach_is_refused() {
    let mut one = Scene::new("one", "One", "");
    let mut other = Scene::new("other", "Other", "");
    let red = one.add_material(Material::new("red", [200, 0, 0]));
    let ball = one.add_shape("sphere", mesh::icosphere(1).unwrap());
    let error = other
        .add_node("x", ball, red, Placement::default())
        .unwrap_err();
    assert!(error.to_string().contains("“x”"), "{error}");
    let far = Placement::at([1e18, 0.0, 0.0])
        .unwrap()
        .scaled([1e17; 3])
        .unwrap();
    assert!(one.add_node("far", ball, red, far).is_err());
    assert!(one.nodes().is_empty());
}
