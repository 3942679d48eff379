//! Whether what is written as CIF and XYZ is the crystal that was read.

use crate::shipped::SHIPPED;
use ga_design::crystallography::{Atom, CellRange, Crystal, Expansion, SpaceGroup, cif, xyz};

fn read(text: &str) -> Crystal {
    let reading = cif::read_str("test.cif", text);
    reading
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
        .crystal
}

fn built(crystal: &Crystal, range: CellRange) -> Vec<Atom> {
    let expansion = Expansion::default();
    let unit = expansion.unit_cell(crystal).expect("a unit cell");
    expansion.cells(crystal, &unit, range).expect("a block")
}

#[test]
fn shipped_crystals_read_back_as_they_were() {
    for text in SHIPPED {
        let crystal = read(text);
        let written = cif::write(&crystal);
        assert_eq!(read(&written), crystal, "{written}");
        // Symbol, number and operations stand in the file, the Hall symbol where the setting is in a
        // table (that of quartz is not: its origin is another).
        for tag in ["_space_group_IT_number ", "_H-M_alt ", "_operation_xyz\n"] {
            assert!(written.contains(tag), "{tag}: {written}");
        }
        let is_tabulated = SpaceGroup::identify(&crystal.operations).is_some();
        assert_eq!(written.contains("_name_Hall "), is_tabulated, "{written}");
    }
}

#[test]
fn uncertainties_names_and_labels_survive() {
    let text = "data_a-name\n_chemical_name_mineral 'it\"s a \u{2019}name'\n_cell_length_a 5.5\n\
        _cell_length_b 6.25\n_cell_length_c 7\n_cell_angle_alpha 90\n_cell_angle_beta 101.5\n\
        _cell_angle_gamma 90\n_space_group_name_H-M_alt 'P 1 21/n 1'\nloop_\n_atom_site_label\n\
        _atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n\
        _atom_site_occupancy\n\
        \"O1'\" O 0.1234(5) -0.25 1.10(12) 0.5\n\"H a\" H 1/3 0.250(1) 0 1\n'a \"b\"' ? 0 0 0.5 1\n\
        data_2 C 1e-3(1) 0.00012(3) 2.5 0.333\n";
    // A label that begins a block, were it not in marks.
    let text = text.replace("data_2 C", "'data_2' C");
    let crystal = read(&text);
    assert_eq!(crystal.sites.len(), 4);
    let again = read(&cif::write(&crystal));
    assert_eq!(again, crystal);
}

#[test]
fn settings_in_no_table_keep_their_operations() {
    let text = "data_x\n_cell_length_a 5\n_cell_length_b 6\n_cell_length_c 7\n_cell_angle_alpha 90\n\
        _cell_angle_beta 90\n_cell_angle_gamma 90\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n\
        -x+1/7,-y,-z\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
        _atom_site_fract_z\nFe 0.1 0.2 0.3\n";
    let crystal = read(text);
    let again = read(&cif::write(&crystal));
    assert_eq!(again.operations, crystal.operations);
    assert_eq!(again, crystal);
}

#[test]
fn a_block_is_one_cell_without_symmetry() {
    for text in SHIPPED {
        let crystal = read(text);
        let range: CellRange = "-1:1x2x1".parse().expect("a range");
        let atoms = built(&crystal, range);
        let written = cif::write_block(&crystal, range, &atoms);
        let block = read(&written);
        assert_eq!((block.number, block.operations.len()), (Some(1), 1));
        let [a, b, c] = crystal.cell.edges();
        assert_eq!(block.cell.edges(), [2.0 * a, 2.0 * b, c]);
        assert_eq!(block.cell.angles(), crystal.cell.angles());
        let found = built(&block, CellRange::UNIT);
        assert_eq!(found.len(), atoms.len());
        let corner = crystal.cell.cartesian(range.low.map(f64::from));
        for (found, atom) in found.iter().zip(&atoms) {
            assert_eq!(
                (found.element, found.occupancy),
                (atom.element, atom.occupancy)
            );
            for (i, corner) in corner.iter().enumerate() {
                assert!((found.cart[i] + corner - atom.cart[i]).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn xyz_has_the_lattice_and_every_atom() {
    let quartz = read(SHIPPED[0]);
    let range: CellRange = "2x1x1".parse().expect("a range");
    let atoms = built(&quartz, range);
    let written = xyz::write("a \"name\"\n", &quartz.cell, range, &atoms);
    let lines: Vec<&str> = written.lines().collect();
    assert_eq!(lines[0], "18");
    assert_eq!(lines.len(), 20);
    let comment = lines[1];
    assert!(
        comment.starts_with("Lattice=\"9.832 0 0 -2.45"),
        "{comment}"
    );
    assert!(
        comment.contains(" Properties=species:S:1:pos:R:3 pbc=\"T T T\" name=\"a  name  \""),
        "{comment}"
    );
    for (line, atom) in lines[2..].iter().zip(&atoms) {
        let words: Vec<&str> = line.split(' ').collect();
        assert_eq!((words.len(), words[0]), (4, atom.element.symbol()));
        for (word, value) in words[1..].iter().zip(atom.cart) {
            let found: f64 = word.parse().expect("a number");
            assert!((found - value).abs() <= 1e-8);
            assert_ne!(*word, "-0");
        }
    }
    // Sites that are not full are told.
    let spinel = read(SHIPPED[6]);
    let written = xyz::write(
        "s",
        &spinel.cell,
        CellRange::UNIT,
        &built(&spinel, CellRange::UNIT),
    );
    assert!(written.contains("species:S:1:pos:R:3:occupancy:R:1"));
    assert!(
        written
            .lines()
            .skip(2)
            .all(|line| line.split(' ').count() == 5)
    );
    // Nothing is written for nothing.
    assert_eq!(
        xyz::write("", &quartz.cell, CellRange::UNIT, &[])
            .lines()
            .count(),
        2
    );
}
