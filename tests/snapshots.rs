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
        ("ApplyUnit for Motor<T>", "x: Point<T>)"),
        ("ApplyUnit for Rotor<T>", "x: PointPair<T>)"),
        ("ApplyUnit for DualPlane<T>", "x: DualSphere<T>)"),
        ("Sandwich for Even<T>", "sandwich(self, x: Point<T>)"),
        ("Wedge for Point<T>", "wedge(self, b: Point<T>)"),
        ("Wedge for Point<T>", "wedge(self, b: PointPair<T>)"),
        ("Geometric for Motor<T>", "geometric(self, b: Motor<T>)"),
        (
            "LeftContract for Point<T>",
            "left_contract(self, b: Point<T>)",
        ),
    ];
    let functions: Vec<String> = chosen
        .iter()
        .map(|(list, head)| function(&source, list, head))
        .collect();
    reviewed(|| assert_snapshot!("chosen_functions_R4_1_null_basis", functions.join("\n")));
}

/// The function of a list with its documentation, under the head of the list; functions that ask
/// for a ring and those that ask for a field stand in lists of their own.
fn function(source: &str, list: &str, head: &str) -> String {
    let (item, body) = (" ".repeat(8), " ".repeat(12));
    let is_list = |line: &str| line.starts_with(&format!("{item}impl")) && line.contains(list);
    let lines: Vec<&str> = source.lines().collect();
    for (start, first) in lines.iter().enumerate().filter(|(_, line)| is_list(line)) {
        let mut text = String::new();
        let functions = lines[start + 1..].iter();
        for line in functions.take_while(|line| line.starts_with(&body)) {
            text.push_str(line.strip_prefix(&item).unwrap_or(line));
            text.push('\n');
            if *line == format!("{body}}}") {
                if text.contains(head) {
                    return format!("{}\n{text}}}\n", first.trim_start());
                }
                text.clear();
            }
        }
    }
    panic!("not generated: {list}: {head}")
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
