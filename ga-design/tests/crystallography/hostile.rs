//! Whether broken files get one clear message with file and line, and whether nothing at all can
//! make the readers panic.

use crate::shipped::SHIPPED;
use ga_design::crystallography::cif::{self, Problem};
use ga_design::crystallography::{Expansion, Operation};
use proptest::prelude::*;
use survives::survives;

#[path = "../cif/survives.rs"]
mod survives;

const CELL: &str = "_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\n_cell_angle_alpha 90\n\
    _cell_angle_beta 90\n_cell_angle_gamma 90\n";
const SITES: &str = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
    _atom_site_fract_z\nFe1 0.1 0.2 0.3\n";

fn failure(text: &str) -> String {
    match cif::read_str("test.cif", text) {
        Ok(reading) => panic!("this was read: {reading:?}\n{text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn broken_files_get_one_message_with_file_line_and_remedy() {
    let good = format!("data_x\n{CELL}_space_group_IT_number 1\n{SITES}");
    assert!(cif::read_str("test.cif", &good).is_ok());
    let with_symmetry = |text: &str| format!("data_x\n{CELL}{text}\n{SITES}");
    let with_row = |row: &str| format!("{good}{row}\n");
    let with_cell = |from: &str, to: &str| good.replace(from, to);
    let cases = [
        (
            String::new(),
            "test.cif:1: the file is empty; a CIF file begins",
        ),
        (
            "  \n# only a comment\n".into(),
            "test.cif:1: the file is empty",
        ),
        (
            "{\"json\": true}".into(),
            "test.cif:1: not a CIF file: `{\"json\":` stands where",
        ),
        (
            "\n\n5\nwater\nO 0 0 0\n".into(),
            "test.cif:3: not a CIF file: `5`",
        ),
        (
            with_symmetry("_title 'no end"),
            "test.cif:8: a quoted value is cut off: the closing '",
        ),
        (
            with_symmetry("_title \"no end'"),
            "test.cif:8: a quoted value is cut off: the closing \"",
        ),
        (
            with_symmetry("_title\n;\nno end"),
            "test.cif:9: a text field begins here and is cut off",
        ),
        (
            with_symmetry("save_x"),
            "test.cif:8: a save frame begins here and is cut off",
        ),
        (
            with_row("Fe2 0.5 0.5"),
            "test.cif:9: the loop of `_atom_site_label` is cut off: 7 values \
            do not fill rows of 4; 1 more",
        ),
        (
            format!("{good}Fe2 0.5\n_more 1\n"),
            "test.cif:9: the loop of `_atom_site_label` is cut off",
        ),
        (
            format!("{good}_last_name"),
            "test.cif:15: the file is cut off: the data name `_last_name`",
        ),
        (
            format!("data_x\n{CELL}loop_\n_a\n_b\n"),
            "test.cif:8: the file is cut off: the data name `_b`",
        ),
        (
            format!("data_x\n_space_group_IT_number 1\n{SITES}"),
            "test.cif:1: no unit cell: add",
        ),
        (
            with_cell("_cell_length_c 5\n", ""),
            "test.cif:1: the unit cell is incomplete: `_cell_length_c`",
        ),
        (
            with_cell("gamma 90", "gamma ?"),
            "test.cif:1: the unit cell is incomplete: `_cell_angle_gamma`",
        ),
        (
            with_cell("length_a 5", "length_a -5"),
            "test.cif:2: cell edge a is -5; it must lie",
        ),
        (
            with_cell("length_a 5", "length_a 0"),
            "test.cif:2: cell edge a is 0",
        ),
        (
            with_cell("length_a 5", "length_a 1e999"),
            "test.cif:2: `_cell_length_a` is `1e999`; it must",
        ),
        (
            with_cell("length_a 5", "length_a nan"),
            "test.cif:2: `_cell_length_a` is `nan`; it must",
        ),
        (
            with_cell("length_b 5", "length_b 5,1"),
            "test.cif:3: `_cell_length_b` is `5,1`",
        ),
        (
            with_cell("alpha 90", "alpha 180"),
            "test.cif:2: cell angle alpha is 180",
        ),
        (
            with_cell("alpha 90", "alpha 5").replace("beta 90", "beta 20"),
            "test.cif:2: no cell has the angles",
        ),
        (
            with_symmetry(""),
            "test.cif:1: no symmetry: add the operations",
        ),
        (
            with_symmetry("_space_group_name_H-M_alt 'P 21/q'"),
            "test.cif:8: unknown space group symbol \
            `P 21/q`; did you mean",
        ),
        (
            with_symmetry("_space_group_name_H-M_alt 'Q 1'\n_space_group_IT_number 1"),
            "test.cif:8: unknown \
            space group symbol `Q 1`",
        ),
        (
            with_symmetry("_space_group_name_Hall 'Q 1'"),
            "test.cif:8: the Hall symbol `Q 1` is wrong: `Q` at column 1",
        ),
        (
            with_symmetry("_space_group_IT_number 231"),
            "test.cif:8: there is no space group number 231",
        ),
        (
            with_symmetry("_space_group_IT_number two"),
            "test.cif:8: there is no space group number two",
        ),
        (
            with_symmetry("loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\nx,y,q"),
            "test.cif:11: the symmetry operation \
            `x,y,q` is wrong: unexpected `q` at column 5",
        ),
        (
            with_symmetry("loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\nx,x+y,z"),
            "test.cif:10: the operations do not form a group",
        ),
        (
            with_symmetry("_space_group_IT_number 194"),
            "test.cif:2: the cell does not have the symmetry",
        ),
        (
            with_row("Fe2 nan 0 0"),
            "test.cif:15: `_atom_site_fract_x` is `nan`; it must be a finite number",
        ),
        (
            with_row("Fe2 0 inf 0"),
            "test.cif:15: `_atom_site_fract_y` is `inf`",
        ),
        (
            with_row("Fe2 0 -Infinity 0"),
            "test.cif:15: `_atom_site_fract_y` is `-Infinity`",
        ),
        (
            with_row("Fe2 0 0 0.5("),
            "test.cif:15: `_atom_site_fract_z` is `0.5(`",
        ),
        (
            with_row("Fe2 0 0 1e10"),
            "test.cif:15: `_atom_site_fract_z` is 10000000000; fractional",
        ),
        (
            good.replace("Fe1 0.1 0.2 0.3", "Fe1 ? ? ?"),
            "test.cif:1: no atom sites with coordinates",
        ),
        (
            format!("data_x\n{CELL}_space_group_IT_number 1\n"),
            "test.cif:1: no atom sites",
        ),
        (
            good.replace("_atom_site_fract_z", "_atom_site_fract_w"),
            "test.cif:1: the atom sites lack `_atom_site_fract_z`",
        ),
        (
            good.replace("_atom_site_label", "_atom_site_occupancy")
                .replace("Fe1", "-1"),
            "test.cif:14: `_atom_site_occupancy` is -1; an occupancy",
        ),
    ];
    for (text, expected) in cases {
        let message = failure(&text);
        assert!(
            message.starts_with(expected),
            "{message}\ninstead of\n{expected}"
        );
        assert!(!message.contains('\n'), "{message}");
    }
}

#[test]
fn files_that_cannot_be_read_say_so() {
    let error = cif::read_file("no/such/file.cif").expect_err("no such file");
    assert!(
        error
            .to_string()
            .starts_with("no/such/file.cif: cannot be read: "),
        "{error}"
    );
    assert_eq!(error.line, None);
    let error = cif::read_file(env!("CARGO_MANIFEST_DIR")).expect_err("a folder");
    assert!(
        matches!(error.problem, Problem::Unreadable { .. }),
        "{error}"
    );
    let error = cif::read_bytes("wide.cif", b"\xff\xfed\0a\0t\0a\0").expect_err("UTF-16");
    assert!(
        error
            .to_string()
            .starts_with("wide.cif:1: not a CIF text file"),
        "{error}"
    );
}

#[test]
fn crowds_of_atoms_end_in_an_error_at_once() {
    let mut text = format!("data_x\n{CELL}_space_group_IT_number 1\n{SITES}");
    text = text
        .replace("_atom_site_label", "_atom_site_occupancy")
        .replace("Fe1", "0.01");
    text.push_str(&"0.01 0 0 0\n".repeat(20_000));
    let crystal = cif::read_str("test.cif", &text).expect("a crystal").crystal;
    let error = Expansion::default()
        .unit_cell(&crystal)
        .expect_err("too dense");
    assert!(error.to_string().contains("crowd around"), "{error}");
}

#[test]
fn files_beyond_the_limits_are_refused() {
    let many = "data_a\n".repeat(100_001);
    assert!(failure(&many).starts_with("test.cif:100001: too large: more than 100000 data blocks"));
    let listed = "x,y,z\n".repeat(4097);
    let text = format!("data_x\n{CELL}loop_\n_symmetry_equiv_pos_as_xyz\n{listed}{SITES}");
    assert!(
        failure(&text).starts_with("test.cif:10: too large: more than 4096 symmetry operations")
    );
}

/// What the fuzzer found, and what is built to be hostile: each file made an earlier reader fail.
#[test]
fn the_findings_of_the_fuzzer_are_survived() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cif/hostile");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("an entry").path();
        survives(&std::fs::read(path).expect("the file is there"));
        count += 1;
    }
    assert!(count > 0);
}

#[test]
fn every_beginning_of_a_shipped_file_is_survived() {
    for text in SHIPPED {
        for length in 0..text.len() {
            survives(&text.as_bytes()[..length]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn random_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        survives(&bytes);
    }

    #[test]
    fn random_words_of_the_format_are_survived(words in prop::collection::vec(prop_oneof![
        Just("data_x"), Just("loop_"), Just("save_"), Just("save_a"), Just("_cell_length_a"),
        Just("_cell_length_b"), Just("_cell_length_c"), Just("_cell_angle_alpha"),
        Just("_cell_angle_beta"), Just("_cell_angle_gamma"), Just("_atom_site_label"),
        Just("_atom_site_fract_x"), Just("_atom_site_fract_y"), Just("_atom_site_fract_z"),
        Just("_space_group_IT_number"), Just("_symmetry_equiv_pos_as_xyz"), Just("x,y,z"),
        Just("-x,y+1/2,z"), Just("1"), Just("90"), Just("5.5(2)"), Just("?"), Just("."),
        Just("'"), Just("\n;"), Just("#"), Just("global_"), Just("\"a b\""), Just("Si"),
    ], 0..60)) {
        survives(format!("data_x\n{CELL}{}", words.join("\n")).as_bytes());
    }

    #[test]
    fn mutated_files_are_survived(
        which in 0..7_usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4_u8), 1..8),
    ) {
        let mut bytes = SHIPPED[which].as_bytes().to_vec();
        for (place, byte, kind) in changes {
            let at = place.index(bytes.len().max(1)).min(bytes.len().saturating_sub(1));
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                2 if bytes.len() > 1 => { bytes.remove(at); }
                _ => bytes[at] = b"0123456789.-+'\"; \n_?"[usize::from(byte) % 20],
            }
        }
        survives(&bytes);
    }

    #[test]
    fn random_triplets_and_symbols_are_survived(
        triplet in "[-+xyzXYZ0-9/*., ']{0,40}",
        hall in "-?[PABCIRHSTF] ?(-?[12346][1-5]?[xyz'\"*]?[abcnuvwd]{0,3} ?){0,5}(\\([-xyz0-9/+,* ]{0,20}\\))?",
        symbol in "\\PC{0,20}",
    ) {
        if let Ok(operation) = triplet.parse::<Operation>() {
            prop_assert_eq!(operation.to_string().parse::<Operation>(), Ok(operation));
        }
        if let Ok(operations) = ga_design::crystallography::hall::operations(&hall) {
            prop_assert_eq!(operations[0], Operation::IDENTITY);
        }
        let _ = ga_design::crystallography::SpaceGroup::from_symbol(&symbol);
        let _ = symbol.parse::<Operation>();
        let _ = ga_design::crystallography::hall::operations(&symbol);
    }
}
