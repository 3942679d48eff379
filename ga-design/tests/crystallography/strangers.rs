//! Whether the kinds of CIF file that strangers write are read, one hand-made file for each kind that
//! was met among some thirty thousand.

use ga_design::crystallography::cif::{self, Reading};
use ga_design::crystallography::{Crystal, Expansion};

const CELL: &str = "_cell_length_a 5\n_cell_length_b 6\n_cell_length_c 7\n_cell_angle_alpha 90\n\
    _cell_angle_beta 90\n_cell_angle_gamma 90\n";
const SITES: &str = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
    _atom_site_fract_z\n";

fn read(text: &str) -> Reading {
    cif::read_str("test.cif", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn failure(text: &str) -> String {
    match cif::read_str("test.cif", text) {
        Ok(reading) => panic!("this was read: {reading:?}\n{text}"),
        Err(error) => error.to_string(),
    }
}

/// The labels with their elements.
fn elements(crystal: &Crystal) -> Vec<(&str, &str)> {
    let sites = crystal.sites.iter();
    sites
        .map(|site| (site.label.as_str(), site.element.symbol()))
        .collect()
}

fn warns(reading: &Reading, words: &str) -> bool {
    reading
        .warnings
        .iter()
        .any(|warning| warning.message.contains(words))
}

#[test]
fn the_formula_settles_what_labels_leave_open() {
    for (formula, labels) in [
        // Roman numerals, sites and coordinations behind the symbol, as mineralogists write them.
        (
            "'Fe3 P2 O16 H16'",
            &[("FeII", "Fe"), ("OIII", "O"), ("WatI", "O"), ("P", "P")][..],
        ),
        (
            "'Pd Pb Bi'",
            &[("Pda1", "Pd"), ("PbMe1", "Pb"), ("Bib", "Bi")],
        ),
        (
            "'Ca (Al Fe) Si O6'",
            &[
                ("Aloct", "Al"),
                ("CaM2", "Ca"),
                ("Feoct", "Fe"),
                ("OSi1", "O"),
            ],
        ),
        ("'K Mg F3'", &[("KA", "K"), ("FII", "F")]),
        // Symbols in capitals: of one letter or two.
        ("'C2 H6 O1'", &[("CO1", "C"), ("HO1", "H"), ("HO2A", "H")]),
        ("'Co O'", &[("CO1", "Co"), ("O1", "O")]),
        ("'N Cl H4'", &[("NH4", "N"), ("CL", "Cl")]),
        // A typing error for `Er1`; an element that the formula has forgotten.
        ("'Er4 Sb'", &[("Erl", "Er"), ("S1", "S")]),
    ] {
        let rows: Vec<String> = labels
            .iter()
            .map(|(label, _)| format!("{label} 0.1 0.2 0.3"))
            .collect();
        let text = format!(
            "data_x\n_chemical_formula_sum {formula}\n{CELL}_space_group_IT_number 1\n{SITES}{}\n",
            rows.join("\n")
        );
        assert_eq!(elements(&read(&text).crystal), labels, "{formula}");
    }
    // The list of atom types serves as well as a formula.
    let text = format!(
        "data_x\nloop_\n_atom_type_symbol\nH\nO2-\n{CELL}_space_group_IT_number 1\n{SITES}HO1 0 0 0\n"
    );
    assert_eq!(elements(&read(&text).crystal), [("HO1", "H")]);
    // Without either the longer symbol counts.
    let text = format!("data_x\n{CELL}_space_group_IT_number 1\n{SITES}HO1 0 0 0\n");
    assert_eq!(elements(&read(&text).crystal), [("HO1", "Ho")]);
}

#[test]
fn dummies_are_left_out_and_what_is_no_element_is_kept_as_unknown() {
    let text = format!(
        "data_x\n{CELL}_space_group_IT_number 1\nloop_\n_atom_site_label\n_atom_site_type_symbol\n\
         _atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n\
         _atom_site_calc_flag\nN1 N3- 0.22 0.22 0.22 1. d\nH1 H1+ -1. -1. -1. 3. dum\n\
         Q1 Q 0.5 0.5 0.5 1 d\nD2 D 0.3 0.3 0.3 1 d\nCg1 . 0.7 0.7 0.7 1 d\n"
    );
    let reading = read(&text);
    let found = elements(&reading.crystal);
    assert_eq!(found, [("N1", "N"), ("Q1", "X"), ("D2", "H"), ("Cg1", "X")]);
    assert!(warns(&reading, "H1 is a dummy"));
    assert!(warns(&reading, "`Q` names no element"));
    // Nothing but dummies is no crystal.
    let message = failure(&text.replace(" d\n", " dum\n"));
    assert!(
        message.contains("no atom sites with coordinates"),
        "{message}"
    );
}

#[test]
fn an_occupancy_that_counts_something_else_is_one() {
    let text = |value: &str| {
        format!(
            "data_x\n{CELL}_space_group_IT_number 1\n{SITES}_atom_site_occupancy\nH 0 0 0 {value}\n"
        )
    };
    let reading = read(&text("3."));
    assert_eq!(reading.crystal.sites[0].occupancy, 1.0);
    assert!(warns(&reading, "the occupancy 3 is no part of a site"));
    assert_eq!(read(&text("1.02(3)")).crystal.sites[0].occupancy, 1.02);
    assert!(failure(&text("-0.5")).contains("`_atom_site_occupancy` is -0.5"));
    assert!(failure(&text("full")).contains("`_atom_site_occupancy` is `full`"));
}

#[test]
fn axes_and_origins_in_braces_behind_a_symbol_are_understood() {
    let rhombohedral = |symbol: &str| {
        format!(
            "data_x\n_cell_length_a 5.5\n_cell_length_b 5.5\n_cell_length_c 5.5\n_cell_angle_alpha 56\n\
             _cell_angle_beta 56\n_cell_angle_gamma 56\n_symmetry_space_group_name_H-M '{symbol}'\n\
             {SITES}Li 0.3 0.3 0.3\n"
        )
    };
    let crystal = read(&rhombohedral("R 3 c {rhombohedral axes}")).crystal;
    assert_eq!(crystal.hermann_mauguin.as_deref(), Some("R 3 c:R"));
    let message = failure(&rhombohedral("R 3 c {hexagonal axes}"));
    assert!(
        message.contains("the cell does not have the symmetry"),
        "{message}"
    );
    assert_eq!(
        read(&rhombohedral("R 3 c {of some kind}")).crystal.number,
        Some(161)
    );
    let silicon = |symbol: &str| rhombohedral(symbol).replace("56", "90");
    let crystal = read(&silicon("F d -3 m {origin 1}")).crystal;
    assert_eq!(crystal.hermann_mauguin.as_deref(), Some("F d -3 m:1"));
}

#[test]
fn a_symbol_whose_marks_were_forgotten_is_taken_to_the_end_of_its_line() {
    let text = |line: &str| format!("data_x\n{CELL}{line}\n{SITES}Fe 0.1 0.2 0.3\n");
    for (line, number) in [
        ("_symmetry_space_group_name_H-M P n m a", 62),
        ("_space_group_name_H-M_alt P 21 21 21 # a remark", 19),
        ("_symmetry_space_group_name_Hall -P 2ac 2n", 62),
        ("_symmetry_space_group_name_H-M Pnma", 62),
    ] {
        let reading = read(&text(line));
        assert_eq!(reading.crystal.number, Some(number), "{line}");
        let has_blanks = !line.ends_with("Pnma");
        assert_eq!(
            warns(&reading, "should stand in marks"),
            has_blanks,
            "{line}"
        );
    }
    // Other values are one word; the rest of the line is passed over as ever.
    let reading = read(&text("_space_group_IT_number 62 or so"));
    assert_eq!(reading.crystal.number, Some(62));
    assert!(warns(&reading, "`or` belongs to no data name"));
    assert!(failure(&text("_symmetry_space_group_name_H-M P n m q")).contains("`P n m q`"));
}

#[test]
fn texts_lists_and_tables_of_version_2_are_read() {
    let body = format!(
        "data_x\n_a.text '''it's\n_cell_length_a 9'''\n_a.four ''''quoted''''\n_a.none \"\"\"\"\"\"\n\
         _a.list [1 'a]' [2 \"}}\"] \n;\n]\n;\n # ]\n]\n_a.table {{'k[':0 \"l\":[1 2]}}\n{CELL}\
         _space_group.name_H-M_alt '''P n m a'''\n{SITES}Fe 0.1 0.2 0.3\n"
    );
    let reading = read(&format!("#\\#CIF_2.0\n{body}"));
    assert_eq!(reading.crystal.number, Some(62));
    assert_eq!(reading.crystal.cell.edges(), [5.0, 6.0, 7.0]);
    assert_eq!(reading.warnings, []);
    // Files of version 1 have no such things, but words that look like them.
    let old = format!("data_x\n_a [1\n_b {{x\n{CELL}_space_group_IT_number 62\n{SITES}Fe 0 0 0\n");
    assert_eq!(read(&old).crystal.number, Some(62));
    for (cut, words) in [
        ("_a '''x''", "test.cif:3: a text in triple quotation marks"),
        (
            "_a [1 [2]\n",
            "test.cif:3: a list or table begins here and is cut off",
        ),
        ("_a {'k':\n1", "test.cif:3: a list or table begins here"),
        ("_a ['k\n]", "test.cif:3: a quoted value is cut off"),
        ("_a [\n;\n]", "test.cif:4: a text field begins here"),
    ] {
        let message = failure(&format!("#\\#CIF_2.0\ndata_x\n{cut}"));
        assert!(message.starts_with(words), "{message}");
    }
}

#[test]
fn names_of_all_dictionaries_serve() {
    let sites = SITES.replace("_atom_site_", "_atom_site.");
    let text = format!(
        "data_x\n{}loop_\n_space_group_symop.id\n_space_group_symop.operation_xyz\n1 x,y,z\n\
         2 -x,-y,-z\n{sites}Fe 0.1 0.2 0.3\n",
        CELL.replace("_cell_", "_cell.")
    );
    let crystal = read(&text).crystal;
    assert_eq!((crystal.number, crystal.operations.len()), (Some(2), 2));
}

#[test]
fn bytes_of_other_encodings_and_line_ends_of_old_systems_are_read() {
    let text = format!(
        "data_x\n_chemical_name_mineral Gr\u{fc}nerit\n{CELL}_space_group_IT_number 1\n{SITES}\
         Fe1 0.1 0.2 0.3\n"
    );
    let latin: Vec<u8> = text
        .chars()
        .map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?'))
        .collect();
    let reading = cif::read_bytes("latin.cif", &latin).expect("Latin-1 is read");
    assert_eq!(reading.crystal.sites.len(), 1);
    assert!(reading.crystal.name.starts_with("Gr"));
    for text in [
        text.replace('\n', "\r"),
        text.replace('\n', "\r\n"),
        format!("\u{feff}{text}"),
        text.replace('\n', "\n\n\t "),
    ] {
        let reading = cif::read_bytes("test.cif", text.as_bytes()).expect("a crystal");
        assert_eq!(reading.crystal.name, "Grünerit");
        assert_eq!(reading.crystal.cell.edges(), [5.0, 6.0, 7.0]);
    }
}

#[test]
fn structures_of_other_symmetry_are_told_by_name() {
    let with = |symmetry: &str| format!("data_x\n{CELL}{symmetry}\n{SITES}Fe 0.1 0.2 0.3\n");
    let message = failure(&with(
        "loop_\n_space_group_symop_magn_operation.id\n_space_group_symop_magn_operation.xyz\n\
         1 x,y,z,+1\n2 -x,-y,-z,-1",
    ));
    assert!(
        message.starts_with("test.cif:1: a magnetic structure"),
        "{message}"
    );
    let message = failure(&with(
        "loop_\n_space_group_symop_ssg_id\n_space_group_symop_ssg_operation_algebraic\n1 x1,x2,x3,x4",
    ));
    assert!(
        message.starts_with("test.cif:1: a modulated structure"),
        "{message}"
    );
    // Where the ordinary symmetry stands beside it, that is used.
    let reading = read(&with(
        "_space_group_magn.number_BNS 2.4\n_space_group_IT_number 2",
    ));
    assert_eq!(reading.crystal.number, Some(2));
}

#[test]
fn coordinates_in_space_become_fractions() {
    let text = "data_x\n_cell.length_a 41.4\n_cell.length_b 4.785\n_cell.length_c 18.594\n_cell.angle_alpha 90\n\
         _cell.angle_beta 115.88\n_cell.angle_gamma 90\n_symmetry.space_group_name_H-M 'C 1 2 1'\nloop_\n\
         _atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n\
         _atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nATOM 1 C CA -4.059 2.3925 8.364\n";
    let reading = read(text);
    let crystal = &reading.crystal;
    assert_eq!(crystal.number, Some(5));
    assert_eq!(elements(crystal), [("CA", "C")]);
    // Along c is half an edge, along b half: the Cartesian frame is undone.
    let found = crystal.cell.cartesian(crystal.sites[0].position());
    for (found, given) in found.iter().zip([-4.059, 2.3925, 8.364]) {
        assert!((found - given).abs() < 1e-9);
    }
    assert!((crystal.sites[0].position()[1] - 0.5).abs() < 1e-12);
    assert!(warns(&reading, "Cartesian coordinates"));
    // On the twofold axis at half of c: one image for each lattice point of the centred cell.
    assert_eq!(
        Expansion::default()
            .unit_cell(crystal)
            .map(|atoms| atoms.len()),
        Ok(2)
    );
}
