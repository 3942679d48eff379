//! `articulate expand`: Rust, the ledger, and mistakes at their place.

use crate::run::{directory, run};
use std::fs;

#[test]
fn a_signature_becomes_rust() {
    let directory = directory();
    let source = run(directory.path(), &["expand", "R3"]).well();
    assert!(source.contains("pub struct Bivector<T = f64>"));
    let value = run(directory.path(), &["expand", "R3", "--json"]).json();
    assert_eq!(value["source"], source);
}

#[test]
fn the_ledger_counts_for_people_and_programs() {
    let directory = directory();
    let text = run(directory.path(), &["expand", "R3", "--ledger"]).well();
    let heading = text.lines().next().unwrap_or_default();
    assert!(heading.starts_with("function") && heading.contains("multiplications"));
    let row = text
        .lines()
        .find(|line| line.starts_with("Vector.wedge(Vector) "));
    let words: Vec<_> = row.unwrap_or_default().split_whitespace().collect();
    // a∧b of two vectors in space: three differences of two products.
    assert_eq!(
        words.get(1..5),
        Some(["Bivector", "6", "3", "3"].as_slice())
    );
    let value = run(directory.path(), &["expand", "R3", "--ledger", "--json"]).json();
    let functions = value["functions"].as_array().expect("a list");
    assert_eq!(functions.len(), text.lines().count() - 2);
    let row = functions
        .iter()
        .find(|row| row["function"] == "Vector.wedge(Vector)");
    assert_eq!(
        row.map(|row| row["multiplications"].clone()),
        Some(6.into())
    );
    // Each difference is a product and a fused operation.
    assert_eq!(row.map(|row| row["fused"].clone()), Some(6.into()));
    assert!(value["tokens"].as_u64().is_some_and(|tokens| tokens > 1000));
}

const BODY: &str = "pub mod plane: R2_0_1 {
    basis { e1, e2, e0 }
    metric { e1^2 = 1, e2^2 = 1 }
    types {
        /// A line.
        Line { e1, e2, e0 }
    }
}
";

#[test]
fn a_file_holds_a_body_or_calls() {
    let directory = directory();
    let body = directory.path().join("body.txt");
    fs::write(&body, BODY).expect("the file is written");
    let from_body = run(directory.path(), &["expand", "body.txt"]).well();
    assert!(from_body.contains("pub struct Line<T = f64>"));
    let source = format!("//! A crate.\n\nga::define_algebra! {{\n{BODY}}}\n\nfn main() {{}}\n");
    fs::write(directory.path().join("lib.rs"), source).expect("the file is written");
    let from_source = run(directory.path(), &["expand", "lib.rs"]).well();
    assert_eq!(from_source, from_body);
    let twice = "define_algebra!(R2);\nmod inner { ga::define_algebra! { R3 } }\n";
    fs::write(directory.path().join("two.rs"), twice).expect("the file is written");
    let both = run(directory.path(), &["expand", "two.rs"]).well();
    assert!(both.contains("mod r2") && both.contains("mod r3"));
}

#[test]
fn a_mistake_is_shown_at_its_place_in_the_file() {
    let directory = directory();
    let wrong = BODY.replace("Line { e1, e2, e0 }", "Line { e1, e2, e7 }");
    fs::write(directory.path().join("body.txt"), &wrong).expect("the file is written");
    let message = run(directory.path(), &["expand", "body.txt"]).message(1);
    assert!(message.starts_with("error: body.txt:6:24: "), "{message}");
    let source = format!("// é\nga::define_algebra! {{ {wrong}}}\n");
    fs::write(directory.path().join("lib.rs"), source).expect("the file is written");
    let message = run(directory.path(), &["expand", "lib.rs", "--ledger"]).message(1);
    assert!(message.starts_with("error: lib.rs:7:24: "), "{message}");
}

#[test]
fn a_wrong_signature_gets_the_message_of_the_macro() {
    let directory = directory();
    for wrong in [
        "R0_0", "R4-1", "R40", "R", "r3_", "foo", "R3 R3", "R3_3_3_3",
    ] {
        let message = run(directory.path(), &["expand", wrong]).message(1);
        let expected = ga_codegen::try_expand(wrong).expect_err("it is wrong");
        let first = expected.lines().next().unwrap_or_default();
        assert!(message.contains(first), "{wrong}: {message}");
    }
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let directory = directory();
    fs::write(directory.path().join("bytes.rs"), [0xff, 0xfe, 0]).expect("the file is written");
    for (name, remedy) in [
        ("missing.rs", "R4_1"),
        (".", "directory"),
        ("bytes.rs", "UTF-8"),
    ] {
        let message = run(directory.path(), &["expand", name]).message(1);
        assert!(
            message.contains(name) && message.contains(remedy),
            "{message}"
        );
    }
}

#[test]
fn deep_nesting_is_no_crash() {
    let directory = directory();
    let deep = "(".repeat(50_000) + &")".repeat(50_000);
    for text in [
        deep.clone(),
        format!("define_algebra!{deep}"),
        "(".repeat(50_000),
    ] {
        fs::write(directory.path().join("deep.rs"), text).expect("the file is written");
        let message = run(directory.path(), &["expand", "deep.rs"]).message(1);
        assert!(message.starts_with("error: deep.rs:1:"), "{message}");
    }
}
