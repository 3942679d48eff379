//! `articulate group` on what is wrong: exit code 2 where the command line is, 1 where a file is, one
//! message with the remedy, nothing on standard output and no file left behind.

use crate::run::{directory, names, run};
use std::fs;

/// The message of a command line that is refused; nothing is left behind.
fn refused(words: &[&str]) -> String {
    let directory = directory();
    let mut all = vec!["group"];
    all.extend(words);
    let message = run(directory.path(), &all).message(2);
    assert!(names(directory.path()).is_empty(), "{words:?}");
    message
}

#[test]
fn numbers_out_of_range_are_told_the_range() {
    for (kind, count) in [
        ("", 230),
        ("--wallpaper", 17),
        ("--frieze", 7),
        ("--layer", 80),
        ("--rod", 75),
    ] {
        for number in ["0", "-1", "99999999999999999999", &(count + 1).to_string()] {
            let words: Vec<&str> = [number, kind]
                .into_iter()
                .filter(|word| !word.is_empty())
                .collect();
            let message = refused(&words);
            // The remedy is what is said last.
            assert!(
                message.trim_end().ends_with(&format!("from 1 to {count}")),
                "{words:?}: {message}"
            );
        }
    }
}

#[test]
fn unknown_symbols_are_answered_with_the_nearest() {
    let long = "x".repeat(100_000);
    let cases: [(&[&str], &str); 34] = [
        (&["P 3 m"], "`P 3 m 1`, `P 3 1 m`"),
        (&["P -3 c"], "`P -3 1 c`, `P -3 c 1`"),
        (&["P -6 m"], "`P -6 m 2`, `P -6 2 m`"),
        (&["C 4/m m m"], "`-C 4 2`"),
        (&["C4mm"], "larger cell"),
        (&["F 41/d d m"], "give its symbol with I"),
        (&["14:b4"], "such as c or b1"),
        (&["14:-b1"], "such as c or b1"),
        (&["14:1"], "unique axis"),
        (&["225:2"], "if it has one"),
        (&["62:b1"], "if it has one"),
        (&["#231"], "from 1 to 230"),
        (&["F d -3 m (origin choice 3)"], "F d -3 m"),
        (&["F q -3 m"], "`F m -3 m`"),
        (&["P 21/q"], "P 1 21/"),
        (&["Oh^11"], "`Oh^10`"),
        (&["F d -3 m:3"], "1 or 2"),
        (&["F d -3 m:H"], "F d -3 m"),
        (&["227:3"], "1 or 2"),
        (&["b(4)2"], "--point"),
        (&["4/mmm"], "--point"),
        (&["P b(4)_9"], "subscript"),
        (&["P 21/c", "--notation", "hall"], "no Hall symbol"),
        (&["227", "--notation", "geometric"], "lattice"),
        (&[""], "unknown"),
        (&["F"], "unknown"),
        (&[&long], "unknown"),
        (&["p4q", "--wallpaper"], "`p 4`"),
        (&["p2mq", "--frieze"], "p 2 m"),
        (&["p 4/n q m", "--layer"], "p 4/n"),
        (&["p 42/m q c", "--rod"], "p 42/m m c"),
        (&["D4q", "--point"], "`D4`"),
        (&["4/mmq", "--point"], "`4/mmm`"),
        (&[&long, "--point"], "unknown"),
    ];
    for (words, remedy) in cases {
        let message = refused(words);
        assert!(message.contains(remedy), "{words:?}: {message}");
        assert!(message.len() < 1000, "{words:?}");
    }
}

#[test]
fn numbers_without_roots_are_told_why() {
    for (text, reason) in [
        ("45", "1/p + 1/q must exceed 1/2"),
        ("44", "tiling"),
        ("63", "tiling"),
        ("b(7)3", "do not close"),
        ("(2000)2", "1000"),
        ("530", "third number"),
        ("-53", "minus"),
        ("b(5", "ends"),
        ("C0", "C1"),
        ("C999999999999", "unknown"),
    ] {
        let words: &[&str] = match text {
            "530" | "-53" | "b(5" => &["--point", text, "--notation", "geometric"],
            _ => &["--point", text],
        };
        let message = refused(words);
        assert!(message.contains(reason), "{text}: {message}");
    }
}

#[test]
fn a_wrong_cell_is_told_the_constraint() {
    let cases: [(&[&str], &str); 19] = [
        (
            &["227", "--cell", "5,6,7"],
            "cubic needs a = b; here a = 5, b = 6",
        ),
        (
            &["227", "--cell", "5,5,5,90,90,91"],
            "cubic needs gamma = 90; here gamma = 91",
        ),
        (&["139", "--cell", "5,6,7"], "tetragonal needs a = b"),
        (
            &["154", "--cell", "5,5,7,90,90,119"],
            "hexagonal needs gamma = 120",
        ),
        (&["14", "--cell", "5,6,7,91,100,90"], "needs alpha = 90"),
        (
            &["62", "--cell", "5,6,7,90,90,95"],
            "orthorhombic needs gamma = 90",
        ),
        (
            &["R -3 c:R", "--cell", "5,5,5,80,80,82"],
            "rhombohedral needs",
        ),
        (&["227", "--cell", "5,6"], "has the parameters a,"),
        (&["14", "--cell", "5,6,7"], "a,b,c,beta"),
        (&["1", "--cell", "5"], "a,b,c,alpha,beta,gamma"),
        (&["1", "--cell", "5,6,7,10,10,170"], "angles"),
        (&["227", "--cell", "-5"], "must lie between"),
        (&["227", "--cell", "0"], "must lie between"),
        (&["227", "--cell", "nan"], "finite number"),
        (&["227", "--cell", "5,,"], "finite number"),
        (&["227", "--cell", ""], "here are 0"),
        (&["227", "--cell", "1e999"], "finite number"),
        (
            &["p4g", "--wallpaper", "--cell", "5,6"],
            "has the parameters a;",
        ),
        (&["1", "--rod", "--cell", "5,6"], "has the parameters c;"),
    ];
    for (words, remedy) in cases {
        let message = refused(words);
        assert!(message.contains(remedy), "{words:?}: {message}");
    }
}

#[test]
fn wrong_cells_points_and_lengths_are_refused() {
    let cases: [(&[&str], &str); 21] = [
        (&["227", "--cells", "foo"], "`foo` is no range"),
        (&["227", "--cells", "0"], "no cell"),
        (&["227", "--cells", "-1"], "no cell"),
        (&["227", "--cells", "2x2"], "one number"),
        (
            &["227", "--cells", "100x100x100", "--out", "x.glb"],
            "fewer cells",
        ),
        (&["227", "--cells", "999999999", "--out", "x.glb"], "2x2x2"),
        (&["227", "--cells", "99999999999999999999x1x1"], "2x2x2"),
        (
            &["p4", "--rod", "--cells", "2x2x2"],
            "does not repeat along a",
        ),
        (
            &["p4", "--layer", "--cells", "2x2x2"],
            "does not repeat along c",
        ),
        (&["227", "--at", "1,2"], "three numbers"),
        (&["227", "--at", "1,2,x"], "finite number"),
        (&["227", "--at", "1e300,0,0"], "too far away"),
        (&["p4", "--layer", "--at", "1e300,0,0"], "too far away"),
        (&["227", "--at", "0,0,0", "--snap", "-1"], "--snap -1"),
        (&["227", "--at", "0,0,0", "--snap", "nan"], "--snap"),
        (&["227", "--out", "x.glb", "--size", "0"], "--size 0"),
        (&["227", "--out", "x.glb", "--size", "inf"], "--size"),
        (&["227", "--out", "x.doc"], ".glb"),
        (
            &["227", "--out", "x.glb", "--motif", "foot"],
            "comma, hand, strut, helix",
        ),
        (
            &["227", "--out", "x.glb", "--motif", "."],
            "this is a directory",
        ),
        (
            &["227", "--out", "x.glb", "--motif", "foot.fbx"],
            ".obj, .stl or .xyz",
        ),
    ];
    for (words, remedy) in cases {
        let message = refused(words);
        assert!(message.contains(remedy), "{words:?}: {message}");
    }
}

#[test]
fn options_that_contradict_each_other_are_refused() {
    let cases: [&[&str]; 14] = [
        &[],
        &["--json"],
        &["227", "19"],
        &["227", "--all"],
        &["--all", "--out", "x.json"],
        &["--all", "--cell", "5"],
        &["1", "--wallpaper", "--frieze"],
        &["1", "--point", "--rod"],
        &["227", "--motif", "hand"],
        &["227", "--snap", "0.1"],
        &["227", "--notation", "welsh"],
        &["1", "--rod", "--symmetry"],
        &["43", "--point", "--cell", "5"],
        &["43", "--point", "--notation", "hall"],
    ];
    for words in cases {
        refused(words);
    }
    assert!(refused(&["--jsn"]).contains("unexpected argument"));
}

#[test]
fn motifs_that_cannot_be_read_are_named_with_the_reason() {
    let directory = directory();
    let mut promising = vec![0_u8; 84];
    promising[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let cases: [(&str, &[u8], &str); 18] = [
        ("empty.obj", b"", "no triangles"),
        ("text.obj", b"hello world\n", "no triangles"),
        ("index.obj", b"v 0 0 0\nf 1 2 3\n", "not an OBJ file"),
        ("number.obj", b"v 0 0 x\nf 1 1 1\n", "not an OBJ file"),
        (
            "nan.obj",
            b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "finite",
        ),
        (
            "flat.obj",
            b"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n",
            "one place",
        ),
        (
            "far.obj",
            b"v 1e38 0 0\nv -1e38 1e38 0\nv 0 1 0\nf 1 2 99999999999999999999\n",
            "not an OBJ file",
        ),
        ("bytes.obj", b"\xff\xfe\x00\x01", "bytes.obj"),
        ("empty.stl", b"", "not an STL file"),
        ("promise.stl", &promising, "cut off"),
        ("text.stl", b"solid\nfacet\n", "promise.stl|text.stl"),
        (
            "word.stl",
            b"hello world, this is no model at all",
            "not an STL file",
        ),
        ("empty.xyz", b"", "line 1"),
        ("cut.xyz", b"3\n\nO 0 0 0\n", "cut off"),
        ("element.xyz", b"1\n\nQq 0 0 0\n", "line 3"),
        ("number.xyz", b"1\n\nO 0 nan 0\n", "line 3"),
        ("many.xyz", b"99999999999\n\nO 0 0 0\n", "line 1"),
        ("bytes.xyz", b"\xff\xfe\x00\x01", "UTF-8"),
    ];
    for (name, content, reason) in cases {
        fs::write(directory.path().join(name), content).expect("the file is written");
        let words = ["group", "19", "--motif", name, "--out", "m.glb", "--json"];
        let message = run(directory.path(), &words).message(1);
        assert!(
            message.starts_with(&format!("error: {name}: ")),
            "{message}"
        );
        assert!(
            reason.split('|').any(|word| message.contains(word)),
            "{name}: {message}"
        );
        fs::remove_file(directory.path().join(name)).expect("the file is there");
        assert!(names(directory.path()).is_empty(), "{name}");
    }
    let words = ["group", "19", "--motif", "missing.obj", "--out", "m.glb"];
    let message = run(directory.path(), &words).message(1);
    assert!(
        message.contains("missing.obj") && message.contains("hand"),
        "{message}"
    );
    fs::create_dir(directory.path().join("folder.obj")).expect("a directory");
    let words = ["group", "19", "--motif", "folder.obj", "--out", "m.glb"];
    assert!(
        run(directory.path(), &words)
            .message(1)
            .contains("directory")
    );
}

#[test]
fn when_one_of_several_files_cannot_be_written_none_is() {
    let directory = directory();
    for bad in ["nowhere/x.obj", "nowhere/x.svg", "nowhere/x.json"] {
        let words = [
            "group", "19", "--out", "a.glb", "--out", bad, "--out", "b.json",
        ];
        let message = run(directory.path(), &words).message(1);
        assert!(message.contains("nowhere/x."), "{message}");
        assert!(names(directory.path()).is_empty());
    }
}
