//! Bad input and bad usage: the exit code, one message with file, line and remedy, nothing on standard
//! output, and no file left behind.

use crate::run::{directory, names, run, shipped};
use std::fs;
use std::path::Path;

/// The start of a good file.
const CELL: &str = "data_test
_cell_length_a 5
_cell_length_b 5
_cell_length_c 5
_cell_angle_alpha 90
_cell_angle_beta 90
_cell_angle_gamma 90
";

/// The end of a good file.
const SITES: &str = "loop_
_atom_site_label
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
Na 0 0 0
Cl 0.5 0.5 0.5
";

/// Runs on a file with this content, asking for several files; gives the message.
fn refused(content: impl AsRef<[u8]>) -> String {
    let directory = directory();
    fs::write(directory.path().join("bad.cif"), content).expect("the file is written");
    let words = [
        "crystal", "bad.cif", "--json", "--out", "x.glb", "--out", "x.json",
    ];
    let message = run(directory.path(), &words).message(1);
    assert_eq!(names(directory.path()), ["bad.cif"]);
    message
}

#[test]
fn a_cut_off_file_is_refused_at_its_line() {
    let text = fs::read_to_string(shipped("quartz.cif")).expect("the file is there");
    let cut = text
        .trim_end()
        .rsplit_once(' ')
        .map_or("", |(start, _)| start);
    let cut = cut
        .trim_end()
        .rsplit_once(' ')
        .map_or("", |(start, _)| start);
    let message = refused(cut);
    assert!(message.starts_with("error: bad.cif:"), "{message}");
    assert!(message.contains("cut off"), "{message}");
    let line = message.split(':').nth(2).map(str::parse::<usize>);
    assert!(matches!(line, Some(Ok(1..))), "{message}");
}

#[test]
fn every_cut_of_a_file_is_refused_or_read_without_a_panic() {
    let text = fs::read(shipped("halite.cif")).expect("the file is there");
    let directory = directory();
    for end in (0..text.len()).step_by(97) {
        fs::write(directory.path().join("cut.cif"), &text[..end]).expect("the file is written");
        let ran = run(directory.path(), &["crystal", "cut.cif", "--json"]);
        if ran.code != 0 {
            assert!(ran.message(1).contains("cut.cif:"));
        }
    }
}

#[test]
fn what_is_no_cif_is_refused_with_a_remedy() {
    let cases: [(&[u8], &str); 4] = [
        (b"", "empty"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "not a CIF"),
        (b"hello world\n", "not a CIF"),
        (b"{\"a\": 1}", "not a CIF"),
    ];
    for (content, word) in cases {
        let message = refused(content);
        assert!(message.starts_with("error: bad.cif:"), "{message}");
        assert!(message.contains(word), "{message}");
    }
}

#[test]
fn what_is_missing_or_wrong_in_a_crystal_is_named() {
    let symmetry = "_space_group_name_H-M_alt 'F m -3 m'\n";
    let no_cell = format!("data_test\n{symmetry}{SITES}");
    assert!(refused(no_cell).contains("_cell_length_a"));
    let unknown = format!("{CELL}_space_group_name_H-M_alt 'F q -3 m'\n{SITES}");
    let message = refused(unknown);
    assert!(
        message.contains("F q -3 m") && message.contains("bad.cif:8:"),
        "{message}"
    );
    let not_a_number = format!("{CELL}{symmetry}{}", SITES.replace("Na 0 0", "Na 0 NaN"));
    let message = refused(not_a_number);
    assert!(
        message.contains("bad.cif:14:") && message.contains("NaN"),
        "{message}"
    );
    let no_sites = format!("{CELL}{symmetry}");
    assert!(refused(no_sites).contains("bad.cif:"));
}

#[test]
fn paths_that_lead_to_no_file_are_named() {
    let directory = directory();
    let message = run(directory.path(), &["crystal", "missing.cif"]).message(1);
    assert!(
        message.contains("missing.cif") && message.contains("no such file; check the path"),
        "{message}"
    );
    let message = run(directory.path(), &["crystal", "."]).message(1);
    assert!(
        message.contains("it is a directory; name a file in it"),
        "{message}"
    );
}

#[test]
fn too_many_cells_are_refused_before_they_are_built() {
    let directory = directory();
    for cells in [
        "100000x100000x100",
        "1000x1000x1000",
        "1000000000",
        "99999999999999999999x1x1",
    ] {
        let words = [
            "crystal",
            &shipped("quartz.cif"),
            "--cells",
            cells,
            "--out",
            "x.glb",
        ];
        let message = run(directory.path(), &words).message(1);
        assert!(
            message.contains("quartz.cif") && message.contains("2x2x2"),
            "{message}"
        );
    }
    assert!(names(directory.path()).is_empty());
}

#[test]
fn bad_usage_exits_with_2() {
    let directory = directory();
    let quartz = shipped("quartz.cif");
    let cases: [(&[&str], &str); 8] = [
        (&["crystal", &quartz, "--cells", "foo"], "2x2x2"),
        (&["crystal", &quartz, "--cells", "0x1x1"], "no cell"),
        (&["crystal", &quartz, "--cells", "-1"], "no cell"),
        (&["crystal", &quartz, "--out", "x.doc"], ".glb"),
        (&["crystal", &quartz, "--out", "x.svg"], ".glb"),
        (&["crystal", &quartz, "--out", "x"], ".glb"),
        (&["crystal"], "FILE.cif"),
        (&["cristal", &quartz], "crystal"),
    ];
    for (words, remedy) in cases {
        let message = run(directory.path(), words).message(2);
        assert!(message.contains(remedy), "{words:?}: {message}");
    }
    assert!(names(directory.path()).is_empty());
}

#[test]
fn when_one_of_several_files_cannot_be_written_none_is() {
    let directory = directory();
    fs::create_dir(directory.path().join("taken.png")).expect("a directory");
    let quartz = shipped("quartz.cif");
    for (bad, named) in [("nowhere/x.obj", "nowhere/x."), ("taken.png", "taken.png")] {
        let words = [
            "crystal", &quartz, "--out", "a.glb", "--out", bad, "--out", "b.json",
        ];
        let message = run(directory.path(), &words).message(1);
        assert!(message.contains(named), "{message}");
        // The name under which it would have been written is nobody's business.
        assert!(!message.contains("partial"), "{message}");
        assert_eq!(names(directory.path()), ["taken.png"]);
    }
}

#[test]
fn an_existing_file_survives_a_failure() {
    let directory = directory();
    let old = directory.path().join("old.glb");
    fs::write(&old, "precious").expect("the file is written");
    let words = [
        "crystal",
        &shipped("quartz.cif"),
        "--out",
        "old.glb",
        "--out",
        "no/x.png",
    ];
    run(directory.path(), &words).message(1);
    assert_eq!(fs::read(&old).ok(), Some(b"precious".to_vec()));
    assert_eq!(names(directory.path()), ["old.glb"]);
}

#[cfg(unix)]
#[test]
fn a_file_in_the_way_of_a_directory_is_named() {
    let directory = directory();
    fs::write(directory.path().join("file"), "").expect("the file is written");
    let words = ["gallery", "--only", "halite", "--out", "file/gallery"];
    let message = run(directory.path(), &words).message(1);
    assert!(message.contains("file"), "{message}");
    // A place where not even the administrator can make a file.
    if Path::new("/proc/self").exists() {
        let words = ["crystal", &shipped("quartz.cif"), "--out", "/proc/x.glb"];
        let message = run(directory.path(), &words).message(1);
        assert!(message.contains("/proc/x.glb"), "{message}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_reported() {
    use std::process::Stdio;
    let full = fs::OpenOptions::new().write(true).open("/dev/full");
    let directory = directory();
    let output = crate::run::program(directory.path(), &["expand", "R2"])
        .stdout(full.map(Stdio::from).expect("/dev/full"))
        .output()
        .expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("standard output"), "{message}");
}
