//! `articulate arm`: the JSON contract, tables, and what is refused.

use crate::run::{directory, run};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Two equal links in a plane, the second hinge limited to one side.
const TABLE: &str = r#"{"name": "scara", "convention": "standard", "rows": [
  {"joint": "R", "a": 1.0, "qlim": [-3, 3]},
  {"joint": "R", "a": 1.0, "qlim": [0, 3]},
  {"joint": "P", "d": 0.1, "qlim": [-1, 1]}]}"#;

const URDF: &str = r#"<robot name="two tips">
  <link name="base"/> <link name="arm"/> <link name="left"/> <link name="right"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="arm"/>
    <axis xyz="0 0 1"/> <limit lower="-3" upper="3" effort="1" velocity="1"/> </joint>
  <joint name="one" type="fixed"> <origin xyz="1 0 0.5"/> <parent link="arm"/> <child link="left"/>
  </joint>
  <joint name="two" type="fixed"> <origin xyz="1 0 -0.5"/> <parent link="arm"/>
    <child link="right"/> </joint>
</robot>"#;

fn written(directory: &Path, files: &[(&str, &str)]) {
    for (name, text) in files {
        fs::write(directory.join(name), text).expect("a writable directory");
    }
}

fn near(found: &Value, expected: &[f64]) -> bool {
    let numbers = found.as_array().expect("a list");
    let pairs = numbers.iter().map(|x| x.as_f64().expect("a number"));
    numbers.len() == expected.len() && pairs.zip(expected).all(|(a, b)| (a - b).abs() < 1e-12)
}

#[test]
fn poses_keep_the_contract() {
    let directory = directory();
    let root = directory.path();
    written(
        root,
        &[
            ("scara.json", TABLE),
            ("two.urdf", URDF),
            (
                "values.json",
                "[[0, 0, 0], [1.5707963267948966, 1.5707963267948966, 0.25]]",
            ),
            ("values.csv", "turn\n0\n1.5707963267948966\n"),
        ],
    );
    let words = [
        "arm",
        "fk",
        "--robot",
        "scara.json",
        "--input",
        "values.json",
        "--json",
    ];
    let told = run(root, &words).json();
    let half = 0.5_f64.sqrt();
    assert_eq!(told.as_array().map(Vec::len), Some(2));
    assert!(near(&told[0]["position"], &[2.0, 0.0, 0.1]), "{told}");
    assert!(
        near(&told[0]["quaternion"], &[1.0, 0.0, 0.0, 0.0]),
        "{told}"
    );
    assert!(near(&told[1]["position"], &[-1.0, 1.0, 0.35]), "{told}");
    assert!(
        near(&told[1]["quaternion"], &[0.0, 0.0, 0.0, 1.0]),
        "{told}"
    );

    let words = [
        "arm",
        "fk",
        "--robot",
        "two.urdf",
        "--tip",
        "left",
        "--input",
        "values.csv",
        "--json",
    ];
    let told = run(root, &words).json();
    assert!(near(&told[0]["position"], &[1.0, 0.0, 0.5]), "{told}");
    assert!(near(&told[1]["position"], &[0.0, 1.0, 0.5]), "{told}");
    assert!(
        near(&told[1]["quaternion"], &[half, 0.0, 0.0, half]),
        "{told}"
    );
}

#[test]
fn targets_give_joint_values_that_lead_back() {
    let directory = directory();
    let root = directory.path();
    let targets = json!([
        {"position": [1.0, 1.0, 0.2]},
        {"position": [0.5, -0.5, 0.0], "quaternion": [1, 0, 0, 0]},
        {"position": [5.0, 0.0, 0.0]},
    ]);
    written(
        root,
        &[
            ("scara.json", TABLE),
            ("targets.json", &targets.to_string()),
        ],
    );
    let ik = [
        "arm",
        "ik",
        "--robot",
        "scara.json",
        "--input",
        "targets.json",
    ];
    let told = run(root, &[&ik[..], &["--json"]].concat()).json();
    assert_eq!(told.as_array().map(Vec::len), Some(3));
    for (row, target) in told
        .as_array()
        .into_iter()
        .flatten()
        .zip([true, false, false])
    {
        for key in [
            "position_error",
            "rotation_error",
            "iterations",
            "tries",
            "micros",
        ] {
            assert!(row[key].is_number(), "{key}: {row}");
        }
        assert_eq!(row["converged"], target, "{row}");
        let joints = row["joints"].as_array().expect("a list");
        assert!(
            joints[1]
                .as_f64()
                .is_some_and(|elbow| (0.0..=3.0).contains(&elbow)),
            "{row}"
        );
    }
    // Stretched towards what is out of reach.
    let miss = told[2]["position_error"].as_f64();
    assert!(miss.is_some_and(|miss| (miss - 3.0).abs() < 1e-3), "{told}");
    let values = json!([told[0]["joints"]]).to_string();
    written(root, &[("found.json", &values)]);
    let fk = [
        "arm",
        "fk",
        "--robot",
        "scara.json",
        "--input",
        "found.json",
        "--json",
    ];
    let back = run(root, &fk).json();
    let back: Vec<f64> = serde_json::from_value(back[0]["position"].clone()).expect("numbers");
    for (a, b) in back.iter().zip([1.0, 1.0, 0.2]) {
        assert!((a - b).abs() < 1e-7, "{back:?}");
    }
    // The same question has the same answer, whatever the clock says.
    let mut again = run(root, &[&ik[..], &["--json"]].concat()).json();
    let mut first = told;
    for told in [&mut first, &mut again] {
        for row in told.as_array_mut().into_iter().flatten() {
            row["micros"] = Value::Null;
        }
    }
    assert_eq!(first, again);
}

#[test]
fn tables_of_targets_give_tables_of_joints() {
    let directory = directory();
    let root = directory.path();
    written(
        root,
        &[
            ("scara.json", TABLE),
            ("targets.csv", "# metres\nx, y, z\n1, 1, 0.2\n-1, 0.5, 0\n"),
        ],
    );
    let words = [
        "arm",
        "ik",
        "--robot",
        "scara.json",
        "--input",
        "targets.csv",
        "--out",
        "joints.csv",
        "--out",
        "joints.json",
    ];
    let told = run(root, &words).well();
    assert!(told.contains("joints.csv: 2 rows of scara"), "{told}");
    let table = fs::read_to_string(root.join("joints.csv")).expect("the table");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(
        lines[0],
        "joint 1,joint 2,joint 3,converged,position_error,rotation_error"
    );
    assert_eq!(lines.len(), 3);
    assert!(
        lines[1..].iter().all(|line| line.contains(",true,")),
        "{table}"
    );
    let saved = fs::read_to_string(root.join("joints.json")).expect("the list");
    let saved: Value = serde_json::from_str(&saved).expect("JSON");
    assert_eq!(saved.as_array().map(Vec::len), Some(2));
    // A tool that may turn about its axis reaches what it could not with its attitude fixed.
    written(root, &[("turned.csv", "1,1,0.2,1,0,0,0\n")]);
    let words = [
        "arm",
        "ik",
        "--robot",
        "scara.json",
        "--input",
        "turned.csv",
        "--json",
    ];
    assert_eq!(run(root, &words).json()[0]["converged"], false);
    let free = run(root, &[&words[..], &["--free-about", "z"]].concat()).json();
    assert_eq!(free[0]["converged"], true);
}

#[test]
fn what_cannot_be_is_refused_with_one_message() {
    let directory = directory();
    let root = directory.path();
    written(
        root,
        &[
            ("scara.json", TABLE),
            ("two.urdf", URDF),
            (
                "cycle.urdf",
                &URDF.replace("<child link=\"arm\"/>", "<child link=\"base\"/>"),
            ),
            ("missing.urdf", &URDF.replace("<link name=\"left\"/>", "")),
            ("limits.urdf", &URDF.replace("lower=\"-3\"", "lower=\"4\"")),
            ("table.json", "{\"rows\": 3}"),
            ("short.json", "[[0, 0, 0], [0, 0]]"),
            ("words.csv", "1,2,x\n"),
            ("headed.csv", "a,b,c\n1,2,nan\n"),
            ("values.json", "[[0, 0, 0]]"),
            (
                "targets.json",
                "[{\"position\": [0, 0, 0], \"quaternion\": [0, 0, 0, 0]}]",
            ),
            (
                "unknown.json",
                "[{\"position\": [0, 0, 0], \"rotation\": 1}]",
            ),
            ("far.csv", "1e300,0,0\n"),
            ("four.csv", "1,2,3,4\n"),
        ],
    );
    for (words, code, problem) in [
        (
            vec!["fk", "--robot", "none.json", "--input", "values.json"],
            1,
            "none.json: cannot be read",
        ),
        (
            vec!["fk", "--robot", "table.json", "--input", "values.json"],
            1,
            "table.json: rows is missing",
        ),
        (
            vec!["fk", "--robot", "cycle.urdf", "--input", "values.json"],
            1,
            "hangs on itself",
        ),
        (
            vec!["fk", "--robot", "missing.urdf", "--input", "values.json"],
            1,
            "`left`, which is not there",
        ),
        (
            vec!["fk", "--robot", "limits.urdf", "--input", "values.json"],
            1,
            "limits from 4 to 3",
        ),
        (
            vec!["fk", "--robot", "two.urdf", "--input", "values.json"],
            1,
            "choose one of left, right (--tip LINK)",
        ),
        (
            vec![
                "fk",
                "--robot",
                "two.urdf",
                "--tip",
                "top",
                "--input",
                "values.json",
            ],
            1,
            "no link `top`",
        ),
        (
            vec![
                "fk",
                "--robot",
                "scara.json",
                "--tip",
                "top",
                "--input",
                "values.json",
            ],
            2,
            "--tip chooses",
        ),
        (
            vec!["fk", "--robot", "scara.json", "--input", "short.json"],
            1,
            "row 2: 2 joint values",
        ),
        (
            vec!["fk", "--robot", "scara.json", "--input", "words.csv"],
            1,
            "line 1: `x` is no finite number",
        ),
        (
            vec!["fk", "--robot", "scara.json", "--input", "headed.csv"],
            1,
            "line 2: `nan`",
        ),
        (
            vec!["ik", "--robot", "scara.json", "--input", "targets.json"],
            1,
            "row 1: a quaternion",
        ),
        (
            vec!["ik", "--robot", "scara.json", "--input", "unknown.json"],
            1,
            "unknown field `rotation`",
        ),
        (
            vec!["ik", "--robot", "scara.json", "--input", "far.csv"],
            1,
            "row 1: a position",
        ),
        (
            vec!["ik", "--robot", "scara.json", "--input", "four.csv"],
            1,
            "row 1: 4 numbers",
        ),
        (
            vec![
                "ik",
                "--robot",
                "scara.json",
                "--input",
                "values.csv",
                "--tries",
                "0",
            ],
            2,
            "--tries",
        ),
        (
            vec![
                "ik",
                "--robot",
                "scara.json",
                "--input",
                "values.csv",
                "--free-about",
                "w",
            ],
            2,
            "write x, y or z",
        ),
        (
            vec![
                "ik",
                "--robot",
                "scara.json",
                "--input",
                "four.csv",
                "--out",
                "x.glb",
            ],
            2,
            ".csv .json",
        ),
    ] {
        let all: Vec<&str> = [&["arm"], words.as_slice()].concat();
        let message = run(root, &all).message(code);
        assert!(message.contains(problem), "{words:?}: {message}");
        assert!(!root.join("x.glb").exists());
    }
    // A seed of the wrong length is bad usage.
    written(root, &[("one.csv", "1,1,0\n")]);
    let words = [
        "arm",
        "ik",
        "--robot",
        "scara.json",
        "--input",
        "one.csv",
        "--seed",
        "1,2",
    ];
    let message = run(root, &words).message(2);
    assert!(message.contains("--seed: 2 joint values"), "{message}");
}
