//! No input makes the macro panic or loop; what it accepts is Rust.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Words, marks and whole phrases that a declaration is made of, and some that it is not.
const FRAGMENTS: &[&str] = &[
    "R3",
    "R4_1",
    "R0_0",
    "R2_0_1",
    "R13",
    "R4-1",
    "R1_2_3_4",
    "R",
    "Cl(3)",
    "mod",
    "mod m: R2",
    "pub",
    "pub(crate)",
    "crate = a::b;",
    "crate",
    "basis",
    "metric",
    "types",
    "products",
    "basis { e1, e2 }",
    "basis { x, s, fn }",
    "basis { r#fn, _, T }",
    "metric { e1^2 = 1 }",
    "metric { e1.e2 = -1/2, e2.e1 = 1 }",
    "types { V { e1, e2 } }",
    "types { A = grade 1; }",
    "V = grade 1;",
    "V { e1, e12, e21 }",
    "P { e1 = 1, e2 }",
    "#[unit]",
    "#[doc = \"x\"]",
    "#[derive(Hash)]",
    "/// text\n",
    "#![x]",
    "even",
    "odd",
    "all",
    "grade",
    "wedge",
    "outer",
    "apply",
    "e1",
    "e2",
    "e12",
    "e1^e2",
    "no",
    "ni",
    "s",
    "T",
    "Self",
    "fn",
    "r#fn",
    "_",
    "ß",
    "数",
    "0",
    "1",
    "2",
    "1.5",
    "1/0",
    "1e9",
    "999999999999999999999999999999999999999999",
    "0x1f",
    "'a'",
    "\"text\"",
    "'life",
    "=",
    ",",
    ";",
    ":",
    "::",
    ".",
    "..",
    "^",
    "^=",
    "-",
    "->",
    "#",
    "$",
    "@",
    "!",
    "?",
    "{}",
    "()",
    "[]",
    "{{{{}}}}",
];

/// Declarations that are right.
const VALID: &[&str] = &[
    "R1",
    "R2",
    "R2_0_1",
    "/// Text.\npub(crate) R1_1",
    "crate = ::other; mod a: R2 { basis { x, y } types { V { x, y } R { 1, x^y } } }",
    "pub mod b: R1_1 { basis { no, ni } metric { no.ni = -1 } types { #[unit] D { 1, no^ni } } }",
    "mod c: R2 { metric { e1^2 = 3/2, e2^2 = 0.5, e1.e2 = -1/4 } products { wedge, apply } }",
    "mod d: R2 { types { P { e1 = 1, e2, e21 } B = grade 2; } products { } }",
];

/// A stream of fragments, some of them inside brackets.
fn stream() -> impl Strategy<Value = String> {
    let leaf = select(FRAGMENTS).prop_map(str::to_owned);
    let tree = leaf.prop_recursive(4, 40, 6, |inner| {
        (
            select(&[("{", "}"), ("(", ")"), ("[", "]")][..]),
            vec(inner, 0..6),
        )
            .prop_map(|((open, close), parts)| format!("{open} {} {close}", parts.join(" ")))
    });
    vec(tree, 0..12).prop_map(|parts| parts.join(" "))
}

/// A module with sections, so that random entries reach the rules behind the parser.
fn module() -> impl Strategy<Value = String> {
    let entries = || vec(select(FRAGMENTS), 0..6).prop_map(|parts| parts.join(" "));
    (
        select(&["R1", "R2", "R1_1", "R9", "R12", "R0", "R4,1"][..]),
        vec(
            (
                select(&["basis", "metric", "types", "products"][..]),
                entries(),
            ),
            0..4,
        ),
    )
        .prop_map(|(signature, sections)| {
            let sections: Vec<String> = sections
                .iter()
                .map(|(name, entries)| format!("{name} {{ {entries} }}"))
                .collect();
            format!("mod m: {signature} {{ {} }}", sections.join(" "))
        })
}

/// A right declaration with tokens taken out, doubled, exchanged or put in.
fn mutated() -> impl Strategy<Value = String> {
    let edit = (any::<prop::sample::Index>(), 0..4_u8, select(FRAGMENTS));
    (select(VALID), vec(edit, 1..4)).prop_map(|(text, edits)| {
        let mut words: Vec<String> = words(text);
        for (place, kind, fragment) in edits {
            let place = place.index(words.len().max(1));
            match kind {
                0 if place < words.len() => drop(words.remove(place)),
                1 => words.insert(place, fragment.to_owned()),
                2 if place < words.len() => words[place] = fragment.to_owned(),
                _ if place + 1 < words.len() => words.swap(place, place + 1),
                _ => {}
            }
        }
        words.join(" ")
    })
}

/// The text cut between words, marks and brackets.
fn words(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    for letter in text.chars() {
        let in_word = letter.is_alphanumeric() || letter == '_';
        match words.last_mut() {
            Some(last) if in_word && last.ends_with(|c: char| c.is_alphanumeric() || c == '_') => {
                last.push(letter);
            }
            _ => words.push(letter.to_string()),
        }
    }
    words
}

/// A diagonal algebra of one or two dimensions with random types over it.
fn right() -> impl Strategy<Value = String> {
    (
        1..=2_usize,
        vec(prop_oneof!["1", "-1", "0", "2/3"], 2),
        vec(any::<u8>(), 1..4),
    )
        .prop_map(|(dimension, squares, types)| {
            let square = |i: usize| format!("e{}^2 = {}", i + 1, squares[i]);
            let metric: Vec<String> = (0..dimension).map(square).collect();
            let negative = squares[..dimension].iter().filter(|s| *s == "-1").count();
            let null = squares[..dimension].iter().filter(|s| *s == "0").count();
            let positive = dimension - negative - null;
            let types: Vec<String> = types
                .iter()
                .enumerate()
                .map(|(i, masks)| {
                    let blades = 1 << dimension;
                    let mut list: Vec<String> = (0..blades)
                        .filter(|mask| masks >> mask & 1 == 1)
                        .map(|mask| blade(mask, dimension))
                        .collect();
                    if list.is_empty() {
                        list.push("e1".to_owned());
                    }
                    format!("Type{i} {{ {} }}", list.join(", "))
                })
                .collect();
            format!(
                "mod m: R{positive}_{negative}_{null} {{ metric {{ {} }} types {{ {} }} }}",
                metric.join(", "),
                types.join(" ")
            )
        })
}

fn blade(mask: usize, dimension: usize) -> String {
    let factors: Vec<String> = (0..dimension)
        .filter(|i| mask >> i & 1 == 1)
        .map(|i| format!("e{}", i + 1))
        .collect();
    if factors.is_empty() {
        "1".to_owned()
    } else {
        factors.join("^")
    }
}

/// Expands, and asks that the result is Rust, with errors or without.
fn expands(text: &str) {
    let expansion = ga_codegen::expand(text);
    assert!(syn::parse_file(&expansion).is_ok(), "{text}\n{expansion}");
    let failed = ga_codegen::try_expand(text).is_err();
    assert_eq!(failed, expansion.contains("compile_error!"), "{text}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn random_streams_are_refused(text in stream()) {
        expands(&text);
    }

    #[test]
    fn random_entries_are_refused(text in module()) {
        expands(&text);
    }

    #[test]
    fn random_characters_are_refused(text in "\\PC{0,80}") {
        expands(&text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn broken_declarations_are_refused(text in mutated()) {
        expands(&text);
    }

    #[test]
    fn right_declarations_are_rust(text in right()) {
        let expansion = ga_codegen::try_expand(&text);
        prop_assert!(expansion.is_ok(), "{}\n{:?}", text, expansion);
        prop_assert!(syn::parse_file(&expansion.unwrap_or_default()).is_ok(), "{}", text);
    }
}

/// What the proptests start from is right, else they would test refusals only.
#[test]
fn the_valid_declarations_are_valid() {
    for text in VALID {
        assert_eq!(ga_codegen::try_expand(text).err(), None, "{text}");
    }
}

/// Brackets nested beyond any stack.
#[test]
fn deep_nesting_is_refused() {
    for depth in [33, 100, 20_000] {
        let (open, close) = ("(".repeat(depth), ")".repeat(depth));
        for text in [
            format!("{open}{close}"),
            format!("mod m: R2 {{ metric {{ e1^2 = {open}{close} }} }}"),
            format!("#[doc = {open}{close}] R2"),
        ] {
            assert!(ga_codegen::try_expand(&text).is_err(), "depth {depth}");
        }
    }
}

/// A text of many entries takes time in proportion, and names that are long stay short in
/// messages.
#[test]
fn long_input_ends() {
    let names = "e1, ".repeat(2_000);
    assert!(ga_codegen::try_expand(&format!("mod m: R2 {{ basis {{ {names} }} }}")).is_err());
    let blades = "e12, ".repeat(2_000);
    assert!(
        ga_codegen::try_expand(&format!("mod m: R2 {{ types {{ V {{ {blades} }} }} }}")).is_err()
    );
    let word = "e".repeat(100_000);
    let report = ga_codegen::try_expand(&format!("mod m: R2 {{ types {{ V {{ {word} }} }} }}"));
    assert!(report.is_err_and(|message| message.len() < 500));
}

/// A call with mistakes still gives the structs, with their documentation and visibility, so
/// that completion goes on working.
#[test]
fn structs_survive_mistakes() {
    let source = ga_codegen::expand(
        "/// My algebra.\npub(crate) mod wrong: R4 {
            types {
                /// My vector.
                #[deprecated]
                Vector { e1, e2, e3 }
                Rotor { 1, e12, e99 }
            }
            products { wegde }
        }",
    );
    for expected in [
        "compile_error!",
        "did you mean `wedge`?",
        "/// My algebra.",
        "pub(crate) mod wrong {",
        "/// My vector.",
        "#[deprecated]",
        "pub struct Vector<T = f64> {",
        "pub struct Rotor<T = f64> {",
        "pub e12: T,",
    ] {
        assert!(source.contains(expected), "{expected}\n{source}");
    }
    for unreadable in [
        "mod wrong { types { Line { e1 } } }",
        "mod wrong: R99 { types { Line { e1 } } }",
    ] {
        let source = ga_codegen::expand(unreadable);
        assert!(source.contains("pub struct Line<T = f64> {"), "{source}");
    }
}

/// All mistakes of one call come out together, from top to bottom.
#[test]
fn the_report_names_lines_and_columns() {
    let report = ga_codegen::try_expand(
        "mod m: R2 {\n  types { a { e1 } }\n  products { dot }\n  basis { e1, 2 }\n}",
    );
    let lines = report.expect_err("three mistakes");
    let places: Vec<&str> = lines
        .lines()
        .filter_map(|line| line.split(": ").next())
        .collect();
    assert_eq!(places, ["2:11", "3:14", "4:15"], "{lines}");
}
