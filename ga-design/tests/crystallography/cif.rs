//! Whether CIF files as strangers write them are read.

use ga_design::crystallography::cif::{self, Reading};
use ga_design::crystallography::{Crystal, Element, Operation};

const CELL: &str = "_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\n_cell_angle_alpha 90\n\
    _cell_angle_beta 90\n_cell_angle_gamma 90\n";
const SITES: &str = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
    _atom_site_fract_z\nFe1 0.1 0.2 0.3\n";

fn read(text: &str) -> Reading {
    cif::read_str("test.cif", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn crystal(symmetry: &str) -> Crystal {
    read(&format!("data_x\n{CELL}{symmetry}\n{SITES}")).crystal
}

fn failure(text: &str) -> String {
    match cif::read_str("test.cif", text) {
        Ok(reading) => panic!("this was read: {reading:?}\n{text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn an_awkward_file_is_read() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cif/awkward.cif");
    let reading = cif::read_file(path).unwrap_or_else(|error| panic!("{error}"));
    let crystal = &reading.crystal;
    assert_eq!(crystal.name, "A name over two lines");
    assert_eq!(crystal.cell.edges(), [5.431; 3]);
    assert_eq!(crystal.cell.angles(), [90.0; 3]);
    assert_eq!(crystal.number, Some(227));
    assert_eq!(crystal.hermann_mauguin.as_deref(), Some("F d -3 m:1"));
    let labels: Vec<&str> = crystal
        .sites
        .iter()
        .map(|site| site.label.as_str())
        .collect();
    assert_eq!(labels, ["Si#1", "Ge'A"]);
    assert_eq!(crystal.sites[0].fract[0].value, 0.0);
    assert_eq!(crystal.sites[1].fract[2].value, -0.125);
    let uncertainty = crystal.sites[1].fract[1]
        .uncertainty
        .expect("an uncertainty");
    assert!((uncertainty - 0.0012).abs() < 1e-15);
    assert_eq!(crystal.sites[1].element.symbol(), "Ge");
    assert_eq!(crystal.sites[1].occupancy, 0.25);
    let messages: Vec<String> = reading.warnings.iter().map(ToString::to_string).collect();
    assert!(
        messages
            .iter()
            .any(|m| m.contains("Si9 has no coordinates")),
        "{messages:?}"
    );
}

#[test]
fn line_ends_of_all_systems_are_counted_alike() {
    let text = format!("data_x\n{CELL}_space_group_IT_number 1\n{SITES}Fe2 a b c\n");
    for end in ["\n", "\r\n", "\r"] {
        let error = failure(&text.replace('\n', end));
        assert!(
            error.starts_with("test.cif:15: `_atom_site_fract_x` is `a`"),
            "{error}"
        );
    }
}

#[test]
fn symmetry_is_taken_from_whatever_is_given() {
    for (symmetry, number, symbol, count) in [
        ("_space_group_IT_number 195", 195, "P 2 3", 12),
        ("_symmetry_Int_Tables_number '195'", 195, "P 2 3", 12),
        ("_space_group_name_H-M_alt 'P 2 3'", 195, "P 2 3", 12),
        ("_symmetry_space_group_name_H-M P23", 195, "P 2 3", 12),
        ("_space_group.name_H-M_alt 'P 2 3'", 195, "P 2 3", 12),
        (
            "_symmetry_space_group_name_Hall 'P 2 2 3'",
            195,
            "P 2 3",
            12,
        ),
        (
            "_space_group_name_Hall ' P 2 2 3'\n_space_group_name_H-M_alt wrong",
            195,
            "P 2 3",
            12,
        ),
        (
            "_space_group_name_Hall wrong\n_space_group_name_H-M_alt 'P 2 3'",
            195,
            "P 2 3",
            12,
        ),
        (
            "_space_group_name_H-M_alt 'F d -3 m'",
            227,
            "F d -3 m:2",
            192,
        ),
        (
            "_space_group_name_H-M_alt 'F d -3 m'\n_space_group_IT_coordinate_system_code 1",
            227,
            "F d -3 m:1",
            192,
        ),
        (
            "_space_group_name_H-M_alt 'P 2 3'\n_space_group_IT_number 999",
            195,
            "P 2 3",
            12,
        ),
        (
            "loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n'-x, -y, -z'",
            2,
            "P -1",
            2,
        ),
        ("_symmetry_equiv_pos_as_xyz x,y,z", 1, "P 1", 1),
        (
            "loop_\n_space_group_symop.operation_xyz\n'X, Y, Z'\n'-X, Y+0.5, -Z'",
            4,
            "P 1 21 1",
            2,
        ),
        // The operations count, whatever else is said.
        (
            "loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n-x,-y,-z\n_space_group_IT_number 225",
            2,
            "P -1",
            2,
        ),
        // Unknown values are no values.
        (
            "_space_group_name_H-M_alt ?\n_space_group_IT_number 195",
            195,
            "P 2 3",
            12,
        ),
        (
            "loop_\n_symmetry_equiv_pos_as_xyz\n?\n_space_group_IT_number 195",
            195,
            "P 2 3",
            12,
        ),
    ] {
        let found = crystal(symmetry);
        assert_eq!(found.number, Some(number), "{symmetry}");
        assert_eq!(found.hermann_mauguin.as_deref(), Some(symbol), "{symmetry}");
        assert_eq!(found.operations.len(), count, "{symmetry}");
        assert_eq!(found.operations[0], Operation::IDENTITY, "{symmetry}");
    }
}

#[test]
fn the_cell_chooses_between_settings() {
    let with = |cell: [f64; 6], symbol: &str| {
        let [a, b, c, alpha, beta, gamma] = cell;
        let text = format!(
            "data_x\n_cell_length_a {a}\n_cell_length_b {b}\n_cell_length_c {c}\n\
             _cell_angle_alpha {alpha}\n_cell_angle_beta {beta}\n_cell_angle_gamma {gamma}\n\
             _symmetry_space_group_name_H-M '{symbol}'\n{SITES}"
        );
        read(&text).crystal.hermann_mauguin.expect("a symbol")
    };
    assert_eq!(with([5., 5., 17., 90., 90., 120.], "R -3 c"), "R -3 c:H");
    assert_eq!(with([6.4, 6.4, 6.4, 46., 46., 46.], "R -3 c"), "R -3 c:R");
    assert_eq!(with([5., 6., 7., 90., 100., 90.], "P 2/m"), "P 1 2/m 1");
    assert_eq!(with([5., 6., 7., 90., 90., 100.], "P 2/m"), "P 1 1 2/m");
    assert_eq!(with([5., 6., 7., 100., 90., 90.], "P 2/m"), "P 2/m 1 1");
}

#[test]
fn an_unlisted_setting_is_recognised_and_its_change_of_basis_told() {
    let shifted = "loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n1/5-x,-y,-z\n\
        _symmetry_space_group_name_H-M 'P -1'";
    let named = read(&format!("data_x\n{CELL}{shifted}\n{SITES}"));
    let found = &named.crystal;
    assert_eq!((found.number, found.operations.len()), (Some(2), 2));
    // What the file itself says needs no warning.
    assert_eq!(named.warnings, []);
    let nameless = "loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n1/5-x,-y,-z";
    let reading = read(&format!("data_x\n{CELL}{nameless}\n{SITES}"));
    assert_eq!(reading.crystal.number, Some(2));
    assert_eq!(reading.crystal.hermann_mauguin.as_deref(), Some("P -1"));
    let told = &reading.warnings[0].message;
    assert!(told.contains("`P -1` (number 2)"), "{told}");
    assert!(told.contains("9/10") || told.contains("1/10"), "{told}");
    // The word of the file against its operations.
    let wrong = read(&format!(
        "data_x\n{CELL}{nameless}\n_space_group_IT_number 225\n\
         _space_group_name_H-M_alt 'F m -3 m'\n{SITES}"
    ));
    assert_eq!(wrong.crystal.number, Some(2));
    assert_eq!(wrong.crystal.hermann_mauguin.as_deref(), Some("P -1"));
    assert!(
        wrong.warnings[0]
            .message
            .contains("the operations are used")
    );
    // However the bar is typed.
    let spelled = crystal("_symmetry_space_group_name_H-M 'F d 3\u{304} m:1'");
    assert_eq!((spelled.number, spelled.operations.len()), (Some(227), 192));
    let contradicted = read(&format!(
        "data_x\n{CELL}_space_group_IT_number 2\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n{SITES}"
    ));
    assert_eq!(contradicted.crystal.number, Some(1));
    assert!(
        contradicted.warnings[0]
            .message
            .contains("the operations are used")
    );
}

#[test]
fn a_symbol_in_another_notation_is_read_with_a_warning_and_a_slip_of_the_pen_is_not() {
    for symbol in ["D2^4", "P 2ac 2ab"] {
        let reading = read(&format!(
            "data_x\n{CELL}_symmetry_space_group_name_H-M '{symbol}'\n{SITES}"
        ));
        assert_eq!(reading.crystal.number, Some(19), "{symbol}");
        assert!(
            reading.warnings[0]
                .message
                .contains("another one of P 21 21 21")
        );
    }
    for symbol in ["P 22", "P 21/q", "F"] {
        let message = failure(&format!(
            "data_x\n{CELL}_symmetry_space_group_name_H-M '{symbol}'\n{SITES}"
        ));
        assert!(message.contains("unknown space group symbol"), "{message}");
    }
}

#[test]
fn incomplete_operation_lists_are_completed_with_a_warning() {
    let reading = read(&format!(
        "data_x\n{CELL}loop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n-y,x,z\n{SITES}"
    ));
    assert_eq!(reading.crystal.number, Some(75));
    assert_eq!(reading.crystal.operations.len(), 4);
    assert_eq!(reading.warnings[0].line, 10);
    assert!(
        reading.warnings[0].message.contains("their group has 4"),
        "{:?}",
        reading.warnings
    );
}

#[test]
fn the_first_complete_block_is_read() {
    let text = format!(
        "data_global\n_journal_year 1980\ndata_second\n{CELL}\n_space_group_IT_number 1\n\
         data_third\n{CELL}_space_group_IT_number 2\n{SITES}"
    );
    let reading = read(&text);
    assert_eq!(
        (reading.crystal.name.as_str(), reading.crystal.number),
        ("third", Some(2))
    );
}

#[test]
fn cartesian_sites_are_converted() {
    let text = format!(
        "data_x\n{CELL}_space_group_IT_number 1\nloop_\n_atom_site.id\n_atom_site.type_symbol\n\
         _atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 CA 1.0 2.5 5.0\n"
    );
    let crystal = read(&text).crystal;
    let found = crystal.sites[0].position();
    for (value, expected) in found.iter().zip([0.2, 0.5, 1.0]) {
        assert!((value - expected).abs() < 1e-12);
    }
    assert_eq!(crystal.sites[0].element.symbol(), "Ca");
}

#[test]
fn elements_are_found_in_types_and_labels() {
    for (text, symbol) in [
        ("Si4+", "Si"),
        ("O2-", "O"),
        ("Fe3+", "Fe"),
        ("D", "H"),
        ("H", "H"),
        ("SI1", "Si"),
        ("C12A", "C"),
        ("Cl-", "Cl"),
        ("CL2", "Cl"),
        ("O_w", "O"),
        ("OW1", "O"),
        ("U1", "U"),
        ("w3", "W"),
        ("na+", "Na"),
        ("N", "N"),
        ("Fe(III)", "Fe"),
        ("T1", "H"),
        ("OH1", "O"),
        ("Wat", "O"),
        ("Cval", "C"),
        ("Siva", "Si"),
    ] {
        let found = Element::from_type_symbol(text).map(Element::symbol);
        assert_eq!(found, Some(symbol), "{text}");
    }
    for text in ["", "?", "X1", "M", "12C", "é", "Q1", "Du", "Vac", "Cg1"] {
        assert_eq!(Element::from_type_symbol(text), None, "{text}");
    }
    assert_eq!(
        (1..=118)
            .filter(|n| Element::from_number(*n).is_some())
            .count(),
        118
    );
    for (label, symbol) in [
        ("Ow", Some("O")),
        ("Oh2", Some("O")),
        ("T1", None),
        ("Ti1", Some("Ti")),
        ("Wat30", Some("O")),
        ("WatII", Some("O")),
        ("H2OA", Some("O")),
        ("Dum1", None),
        ("Cg", None),
    ] {
        assert_eq!(
            Element::from_label(label).map(Element::symbol),
            symbol,
            "{label}"
        );
    }
    let carbon = Element::from_symbol("C").expect("carbon");
    assert_eq!(
        (carbon.number(), carbon.covalent_radius(), carbon.colour()),
        (6, 0.76, [0x90; 3])
    );
    for number in 1..=118 {
        let element = Element::from_number(number).expect("an element");
        assert_eq!(Element::from_symbol(element.symbol()), Some(element));
        assert!(element.mass() > 0.9 && element.covalent_radius() > 0.2);
    }
}
