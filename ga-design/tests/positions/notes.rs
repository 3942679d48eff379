//! Whether what people write beside a number or symbol is read: axes, notes in brackets, signs.

use std::collections::BTreeSet;

use crate::symbols::first;
use ga_design::crystallography::{SpaceGroup, hall};
use moyo::data::hall_symbol_entry;

/// The names that moyo has for the settings of monoclinic groups, with their Hall symbols.
#[test]
fn axes_choose_the_setting_that_moyo_has_under_them() {
    let mut compared = 0;
    for hall_number in 1..=530 {
        let entry = hall_symbol_entry(hall_number).expect("1 to 530");
        let Ok(number @ 3..=15) = u32::try_from(entry.number) else {
            continue;
        };
        let found = SpaceGroup::with_axes(number, entry.setting);
        let found = found.unwrap_or_else(|| panic!("{number}:{}", entry.setting));
        let ours = hall::operations(found.hall).expect("a Hall symbol");
        let theirs = hall::operations(entry.hall_symbol).expect("a Hall symbol");
        let [ours, theirs] = [ours, theirs].map(BTreeSet::from_iter);
        assert_eq!(ours, theirs, "{number}:{}", entry.setting);
        assert_eq!(first(&format!("{number}:{}", entry.setting)), found);
        compared += 1;
    }
    // Five groups of three axes, six of three cells for each, two of twice as many.
    assert_eq!(compared, 5 * 3 + 6 * 9 + 2 * 18);
    for wrong in ["", "-", "d", "b0", "b4", "b11", "-b", "1", "bb", "ü"] {
        assert_eq!(SpaceGroup::with_axes(14, wrong), None, "{wrong}");
    }
    for (number, wrong) in [(3, "b2"), (0, "b"), (16, "b"), (231, "b"), (15, "-b4")] {
        assert_eq!(SpaceGroup::with_axes(number, wrong), None, "{wrong}");
    }
}

#[test]
fn notes_and_number_signs_are_read() {
    for (text, meant) in [
        ("F d -3 m (origin choice 1)", "227:1"),
        ("Fd-3m (Origin 2)", "227:2"),
        ("P n n n (choice 2)", "48:2"),
        ("227 (origin choice 1)", "227:1"),
        ("Oh^7 (ORIGIN CHOICE 1)", "227:1"),
        ("R -3 c (rhombohedral axes)", "167:R"),
        ("R 3 (hexagonal setting)", "146:H"),
        ("#225", "225"),
        ("# 225", "225"),
        ("No. 62", "62"),
        ("no 62", "62"),
        ("#227 (origin choice 1)", "227:1"),
    ] {
        assert_eq!(first(text), first(meant), "{text}");
    }
    for wrong in [
        "F d -3 m (origin choice 3)",
        "F d -3 m (origin)",
        "62 (origin choice 1)",
        "(origin choice 1)",
        "#",
        "#F d -3 m",
        "No.",
    ] {
        assert!(SpaceGroup::find(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn what_leaves_a_place_open_gets_both_symbols() {
    let suggestions = |text: &str| SpaceGroup::find(text).expect_err(text).suggestions;
    assert_eq!(suggestions("P 3 m")[..2], ["P 3 m 1", "P 3 1 m"]);
    assert_eq!(suggestions("P-3c")[..2], ["P -3 1 c", "P -3 c 1"]);
}
