//! Geometric space group symbols: unique, printed as read, true to the generators, found.

use std::collections::BTreeMap;

use ga_design::crystallography::{
    Bars, GeometricSymbol, GeometricSymbolError, Motion, SpaceGroup, SpaceGroupGenerators, Word,
};

#[test]
fn every_group_has_a_symbol_of_its_own_and_is_found_by_it() {
    let mut seen = BTreeMap::new();
    for group in SpaceGroupGenerators::table() {
        let text = group.symbol.to_string();
        assert_eq!(seen.insert(text.clone(), group.number), None, "{text}");
        assert_eq!(text.parse(), Ok(group.symbol));
        for spelling in [text.clone(), text.replace(' ', ""), format!(" {text} ")] {
            let found = SpaceGroupGenerators::from_symbol(&spelling).expect("its own symbol");
            assert_eq!(found.number, group.number, "{spelling}");
            let setting = SpaceGroup::from_geometric(&spelling).expect("its own symbol");
            assert!(setting.standard && setting.number == group.number);
            assert_eq!(setting.geometric(), Some(group.symbol));
        }
    }
    assert_eq!(seen.len(), 230);
}

#[test]
fn symbols_of_the_literature_are_found() {
    // Table 3.5, figures 3.4 to 3.6 as corrected, and others as they are written there.
    let cases = [
        ("P b(6)b(2)", 177),
        ("P b(6)_1b(2)", 178),
        ("P b(6)_2b(2)", 180),
        ("P b(6)_3b(2)", 182),
        ("P b(6)_4b(2)", 181),
        ("P b(6)_5b(2)", 179),
        ("P b(4)2", 83),
        ("P b(4)_1 b(2)", 91),
        ("P b(4) b(2)", 89),
        ("P b(4)_2 2", 84),
        ("P b(4)_3 b(2)", 95),
        ("P b(4)_3 b(3)", 212),
        ("F b(4)_3 b(3)", 210),
        ("P 4\u{305}\u{2081}2\u{305}", 91),
        ("P b(4)_{1} b(2)", 91),
        ("pb(4)_1b(2)", 91),
        ("P 43", 221),
        ("F_d 43", 227),
        ("P b(22)", 2),
        ("P 1", 6),
        ("P b(1)", 1),
        ("P 4 b(2)", 115),
        ("C 4 b(2)", 111),
        ("F 4 b(2)", 121),
        ("I 4 b(2)", 119),
        ("P b(3)' b(3)", 198),
        ("P b(3) b(3)", 195),
        ("P b(2)_1 b(2)_1\u{2032}", 19),
        ("P b(2)_1 b(2)_1", 18),
    ];
    for (symbol, number) in cases {
        let found =
            SpaceGroupGenerators::from_symbol(symbol).unwrap_or_else(|e| panic!("{symbol}: {e}"));
        assert_eq!(found.number, number, "{symbol}");
    }
}

/// Among all notations a geometric symbol is found unless an older one means something by it.
#[test]
fn barred_symbols_are_found_among_all_notations() {
    for group in SpaceGroupGenerators::table() {
        let text = group.symbol.to_string();
        let found = SpaceGroup::find(&text).unwrap_or_else(|e| panic!("{text}: {e}"));
        if text.contains("b(") {
            assert_eq!(found[0], group.standard, "{text}");
        } else {
            let older = SpaceGroup::from_symbol(&text).map(|found| found[0].number);
            let hall = SpaceGroup::from_hall(&text).map(|found| found.number);
            let mut schoenflies = SpaceGroup::from_schoenflies(&text).into_iter();
            let schoenflies = schoenflies.next().map(|found| found.number);
            let known = older.ok().or(schoenflies).or(hall);
            let number = known.unwrap_or(group.number);
            assert_eq!(found[0].number, number, "{text}");
        }
    }
    // In Hermann and Mauguin's notation these are P 3₂ and P 4.
    assert_eq!(
        SpaceGroup::find("P 32").map(|found| found[0].number),
        Ok(145)
    );
    assert_eq!(SpaceGroup::find("P 4").map(|found| found[0].number), Ok(75));
    assert_eq!(
        SpaceGroup::from_geometric("P 4").map(|found| found.number),
        Ok(99)
    );
    let origin = SpaceGroup::find("F_d b(4) b(3):1");
    assert!(origin.is_err());
    assert_eq!(
        SpaceGroup::find("F_d 4 3:1").map(|found| found[0].hall),
        Ok("F 4d 2 3 -1d")
    );
    let error = SpaceGroup::find("P b(4)_5").expect_err("no such screw");
    assert!(
        error.to_string().contains("did you mean `P b(4)"),
        "{error}"
    );
}

#[test]
fn what_is_no_symbol_is_refused() {
    let cases = [
        ("", "begins with its lattice"),
        ("4 2", "not with `4`"),
        ("Q 4", "not with `Q`"),
        ("P", "empty point group symbol"),
        ("P 4m", "unexpected `m`"),
        ("P -4", "a minus is the rotoinversion"),
        ("P b(4)_9", "a subscript at column 7"),
        ("P b(4)_", "a subscript at column 7"),
        ("P b(4)_x", "a subscript at column 7"),
        ("P b(4)_1_2", "second mark on one factor at column 9"),
        ("P b(4)''", "second mark"),
        ("P b(4)'_1", "second mark"),
        ("P 4 2 2_1", "second mark"),
        ("P 44", "limit"),
        (
            "P 53",
            "no space group has the geometric symbol `P 5 3`; did you mean `P 3 3`, `P 4 3`",
        ),
        ("P b(4)_5", "did you mean `P b(4)"),
        ("R 43", "did you mean"),
    ];
    for (text, part) in cases {
        let error = SpaceGroupGenerators::from_symbol(text).expect_err(text);
        assert!(error.to_string().contains(part), "`{text}`: {error}");
    }
    for text in [
        "P\u{305}",
        "\u{0}",
        &"P".repeat(100_000),
        &"P4".repeat(10_000),
        "P(",
        "P b(4)_\u{305}",
    ] {
        assert!(SpaceGroupGenerators::from_symbol(text).is_err());
    }
    let error = "P b(53)".parse::<GeometricSymbol>();
    assert!(error.is_ok(), "a symbol, if of no lattice: {error:?}");
    assert!(matches!(
        SpaceGroupGenerators::from_symbol("P b(53)"),
        Err(GeometricSymbolError::Unknown { .. })
    ));
}

/// Each mark says what the generator does: the rise of the screw, the direction of the glide.
#[test]
fn marks_are_what_the_generators_do() {
    for group in SpaceGroupGenerators::table() {
        let setting = SpaceGroup::standard(group.number).expect("a number");
        let cell = setting.cell_shape().example().cell().expect("a cell");
        let generation = setting.generate(&cell).expect("a group");
        let [lattice, first, second] = group.symbol.marks;
        for (expression, versor) in group.generators.iter().zip(generation.generators()) {
            let mark = match (expression.word, group.symbol.point.bars()) {
                (Word::A, _) => lattice,
                (Word::B | Word::Ab | Word::Abc, _) => first,
                (Word::C | Word::Bc, Bars::None | Bars::First | Bars::Second | Bars::Each) => {
                    second
                }
                other => panic!("{other:?} is no generator"),
            };
            let name = format!("{} {expression}", group.symbol);
            assert_eq!(mark.moved, expression.moved != [0.into(); 3], "{name}");
            let fractions = |vector: ga_cga::Vector3| cell.fractional(vector.to_array());
            match versor.motion() {
                Motion::Screw {
                    axis, angle, rise, ..
                } => {
                    let order = (2.0 * std::f64::consts::PI / angle).round();
                    // The shortest lattice vector along the axis, for which n_m rises m/n.
                    let along = shortest(&generation, axis);
                    let digit = (rise / along * order).round().rem_euclid(order) as u32;
                    let written = mark.subscript.and_then(|c| c.to_digit(10)).unwrap_or(0);
                    // A threefold screw by a lattice vector is a rotation elsewhere.
                    assert_eq!(written, digit, "{name}: {rise} of {along}");
                }
                Motion::Glide { vector, .. } => {
                    let parts = fractions(vector);
                    let quarter = parts.iter().any(|p| ((p * 4.0).round() as i32) % 2 != 0);
                    let some = parts.iter().filter(|p| p.abs() > 1e-9).count();
                    match mark.subscript {
                        None => assert_eq!(some, 0, "{name}: {parts:?}"),
                        Some('n') => assert!(some >= 2 && !quarter, "{name}: {parts:?}"),
                        Some('d') => assert!(some >= 2 && quarter, "{name}: {parts:?}"),
                        Some(letter @ ('a'..='c')) => {
                            let given = usize::from(letter as u8 - b'a');
                            let joined = expression.translation;
                            assert!(*joined[given].numer() != 0, "{name}: {parts:?}");
                        }
                        Some(other) => panic!("{name}: `{other}` on a glide"),
                    }
                }
                _ => assert_eq!(mark.subscript, None, "{name}"),
            }
        }
    }
}

/// The length of the shortest lattice vector in this direction.
fn shortest(generation: &ga_design::crystallography::Generation, axis: ga_cga::Vector3) -> f64 {
    let cell = generation.cell();
    let mut best = f64::INFINITY;
    for point in generation.translations() {
        let base = point.translation_f64();
        for code in 0..125 {
            let step = [code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2];
            let fractions = [0, 1, 2].map(|i| base[i] + f64::from(step[i]));
            let vector = ga_cga::Vector3::from(cell.cartesian(fractions));
            let across = vector - axis * vector.scalar_product(axis);
            if across.norm() < 1e-9 && vector.norm() > 1e-9 {
                best = best.min(vector.norm());
            }
        }
    }
    best
}
