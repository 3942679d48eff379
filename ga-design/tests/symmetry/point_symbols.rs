//! Geometric point group symbols: every row of Table 3.2, other spellings, mistakes.

use ga_design::crystallography::{Bars, PointSymbol, PointSymbolError, RootsError, Word};

fn read(text: &str) -> PointSymbol {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

#[test]
fn the_eight_rows_of_the_table_name_their_generators() {
    type Row = (&'static str, Bars, &'static [(u8, u8)]);
    let rows: [Row; 8] = [
        ("1", Bars::Single, &[(0, 0)]),
        ("4", Bars::Single, &[(0, 0), (0, 1)]),
        ("b(4)", Bars::BarredSingle, &[(1, 0)]),
        ("42", Bars::None, &[(0, 0), (0, 1), (0, 2)]),
        ("b(4)2", Bars::First, &[(1, 0), (0, 2)]),
        ("4b(2)", Bars::Second, &[(0, 0), (1, 1)]),
        ("b(4)b(2)", Bars::Each, &[(1, 0), (1, 1)]),
        ("b(42)", Bars::Both, &[(2, 0)]),
    ];
    for (text, bars, encoding) in rows {
        let symbol = read(text);
        assert_eq!(symbol.bars(), bars, "{text}");
        assert_eq!(symbol.to_string(), text);
        let words = symbol.generators();
        let found: Vec<_> = words.iter().map(|w| (w.kind(), w.index())).collect();
        assert_eq!(found, encoding, "{text}");
    }
}

#[test]
fn words_are_known_by_their_letters_and_encoding() {
    let mut seen = std::collections::HashSet::new();
    for word in Word::ALL {
        assert_eq!(Word::from_letters(word.letters()), Some(word));
        assert!(seen.insert((word.kind(), word.index())));
        assert_eq!(Word::from_encoding(word.kind(), word.index()), Some(word));
        assert_eq!(usize::from(word.kind()) + 1, word.letters().len());
    }
    assert_eq!(Word::from_letters("ba"), None);
    assert_eq!(Word::from_encoding(2, 2), None);
}

#[test]
fn overlines_blanks_and_long_numbers_are_read() {
    let cases = [
        ("4\u{305}2", "b(4)2"),
        ("4\u{304}2", "b(4)2"),
        ("42\u{305}", "4b(2)"),
        ("4\u{305}2\u{305}", "b(4)b(2)"),
        (" b( 4 )_2 ", "b(4)2"),
        ("(4)(2)", "42"),
        ("b((10))", "b((10))"),
        ("(10)b(2)", "(10)b(2)"),
        ("b((12)2)", "b((12)2)"),
        ("(10)\u{305}2", "b((10))2"),
    ];
    for (text, written) in cases {
        assert_eq!(read(text).to_string(), written, "{text}");
        assert_eq!(read(written), read(text));
        assert_eq!(read(text).overlined().parse(), Ok(read(text)), "{text}");
    }
    assert_eq!(read("b((10))2").p(), 10);
    assert_eq!(read("b(5)").q(), None);
    assert_eq!(read("b(4)2").overlined(), "4\u{305}2");
}

#[test]
fn what_is_no_symbol_is_refused_where_it_goes_wrong() {
    let cases = [
        ("", "empty"),
        ("  ", "empty"),
        ("-4", "`-` at column 1: a minus is the rotoinversion"),
        ("4 -2", "`-` at column 3"),
        ("\u{2212}42m", "rotoinversion"),
        ("4m", "unexpected `m` at column 2"),
        ("m-3m", "unexpected `m` at column 1"),
        ("422", "third number at column 3"),
        ("102", "third number at column 3"),
        ("b(42)2", "third number at column 6"),
        ("2b(42)", "stands alone"),
        ("b", "`(` after `b`"),
        ("b4", "unexpected `4` at column 2"),
        ("b(", "ends where a number"),
        ("b()", "unexpected `)` at column 3"),
        ("b(4", "ends where a number"),
        ("b(422)", "unexpected `2` at column 5"),
        ("(10", "ends where `)`"),
        ("()", "unexpected `)` at column 2"),
        ("4\u{305}\u{305}", "at column 3"),
        ("0", "p = 0 is no root angle"),
        ("45", "do not close"),
        ("b(4)b(5)", "do not close"),
        ("63", "limit"),
        ("(99999999999999999999)", "p = 4294967295"),
    ];
    for (text, part) in cases {
        let error = text.parse::<PointSymbol>().expect_err(text);
        assert!(error.to_string().contains(part), "`{text}`: {error}");
    }
    assert_eq!(
        PointSymbol::new(4, 4, Bars::Each),
        Err(RootsError::Planar { p: 4, q: 4 })
    );
    assert_eq!(
        "4b(4)".parse::<PointSymbol>(),
        Err(PointSymbolError::Roots(RootsError::Planar { p: 4, q: 4 }))
    );
}
