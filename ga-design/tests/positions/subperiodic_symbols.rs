//! Whether frieze, plane, rod and layer groups are found by every spelling, and what is said of
//! others.

use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind};

#[test]
fn symbols_parse_back_and_others_get_a_suggestion() {
    for group in SubperiodicGroup::table() {
        for symbol in [
            group.qualified_symbol(),
            group.symbol.replace(' ', ""),
            group.symbol.to_uppercase(),
            group.full_symbol().to_owned(),
        ] {
            let found = SubperiodicGroup::from_symbol(group.kind, &symbol)
                .unwrap_or_else(|e| panic!("{e}"));
            assert!(found.contains(&group), "{symbol}");
            assert!(
                found.iter().all(|other| other.number == group.number),
                "{symbol}"
            );
        }
        let number = group.number.to_string();
        let found = SubperiodicGroup::from_symbol(group.kind, &number).expect("a number");
        assert_eq!((found[0].number, found[0].standard), (group.number, true));
    }
    let plane = |text: &str| SubperiodicGroup::from_symbol(SubperiodicKind::Plane, text);
    for (symbol, number) in [
        ("p4g", 12),
        ("cmm", 9),
        ("p31m", 15),
        ("*632", 17),
        ("442", 10),
    ] {
        let found = plane(symbol).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(found[0].number, number, "{symbol}");
    }
    let error = plane("p4gn").expect_err("no such group");
    assert!(
        error.suggestions.contains(&String::from("p 4 g m")),
        "{error}"
    );
    for wrong in [
        "",
        "18",
        "0",
        "-1",
        "q 7 zz zz",
        "p 4/n:3",
        "p 2 m g:2",
        "Fd-3m",
    ] {
        let error = plane(wrong).expect_err("no such group");
        assert!(error.to_string().contains("plane group"), "{error}");
    }
    let nothing = plane("q 7 zz zz").expect_err("no such group");
    assert!(nothing.to_string().contains("from 1 to 17"), "{nothing}");
    let long = "p".repeat(10_000);
    assert!(plane(&long).expect_err("too long").symbol.len() <= 60);
}
