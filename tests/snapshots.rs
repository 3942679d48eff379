//! Generated code is reviewed like code: small algebras whole, large ones by what they cost.

use insta::{Settings, assert_snapshot};

/// The declaration of the conformal model, as the compiler sees it.
fn conformal() -> &'static str {
    let file = include_str!("../ga-cga/src/algebra.rs");
    let (_, call) = file.split_once("define_algebra! {").unwrap_or(("", file));
    call.trim_end().strip_suffix('}').unwrap_or(call)
}

/// Compares with the files of the folder `snapshots`.
fn reviewed(check: impl FnOnce()) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(check);
}

fn expansion(declaration: &str) -> String {
    ga_codegen::try_expand(declaration).unwrap_or_else(|mistakes| mistakes)
}

fn ledger(declaration: &str) -> String {
    ga_codegen::ledger(declaration).map_or_else(|mistakes| mistakes, |ledger| ledger.to_string())
}

#[test]
fn whole_expansions() {
    reviewed(|| {
        assert_snapshot!("expansion_R2", expansion("R2"));
        assert_snapshot!("expansion_R3", expansion("R3"));
        assert_snapshot!("expansion_R2_0_1", expansion("R2_0_1"));
    });
}

#[test]
fn ledgers() {
    reviewed(|| {
        assert_snapshot!("ledger_R3_0_1", ledger("R3_0_1"));
        assert_snapshot!("ledger_R1_3", ledger("R1_3"));
        assert_snapshot!("ledger_R4_1_null_basis", ledger(conformal()));
    });
}

/// Functions that the conformal model stands on, cut out of its expansion.
#[test]
fn chosen_functions_of_the_conformal_model() {
    let source = expansion(conformal());
    let chosen = [
        "Apply<Point<T>> for Motor<T>",
        "Apply<Circle<T>> for Rotor<T>",
        "Wedge<Point<T>> for Point<T>",
        "Wedge<PointPair<T>> for Point<T>",
        "Geometric<Motor<T>> for Motor<T>",
        "LeftContract<Point<T>> for Point<T>",
    ];
    let functions: Vec<String> = chosen.iter().map(|head| item(&source, head)).collect();
    assert!(
        functions.iter().all(|text| text.starts_with("impl")),
        "{functions:?}"
    );
    reviewed(|| assert_snapshot!("chosen_functions_R4_1_null_basis", functions.join("\n")));
}

/// The implementation of this trait, up to the bracket that closes it.
fn item(source: &str, head: &str) -> String {
    let found = source
        .lines()
        .skip_while(|line| !(line.starts_with("    impl") && line.contains(head)));
    let mut text = String::new();
    for line in found {
        text.push_str(line.strip_prefix("    ").unwrap_or(line));
        text.push('\n');
        if line == "    }" {
            return text;
        }
    }
    format!("not generated: {head}\n")
}

/// The limit that editors keep completing under is four times as high.
#[test]
fn the_conformal_expansion_stays_small() {
    let tokens = ga_codegen::ledger(conformal()).map(|ledger| ledger.tokens);
    assert!(
        tokens.as_ref().is_ok_and(|count| *count < 500_000),
        "{tokens:?}"
    );
}
