//! Whether crystals read from files come out as an independent program and published facts say:
//! space group, atoms per cell, density, nearest distances.

use std::collections::BTreeMap;
use std::path::PathBuf;

use ga_design::crystallography::{
    Atom, Cell, CellRange, Crystal, Expansion, ExpansionError, Measured, Operation, Placement,
    Site, SpaceGroup, cif,
};
use moyo::MoyoDataset;
use moyo::base::{Cell as MoyoCell, Lattice};

/// Grams per cubic centimetre for one dalton in one cubic ångström (CODATA 2018).
const DALTON_PER_CUBIC_ANGSTROM: f64 = 1.660_539_066;

fn shipped(name: &str) -> cif::Reading {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("data/cif")
        .join(name);
    cif::read_file(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn atoms_of(crystal: &Crystal) -> Vec<Atom> {
    Expansion::default()
        .unit_cell(crystal)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn density(crystal: &Crystal, atoms: &[Atom]) -> f64 {
    let mass: f64 = atoms
        .iter()
        .map(|atom| atom.element.mass() * atom.occupancy)
        .sum();
    mass * DALTON_PER_CUBIC_ANGSTROM / crystal.cell.volume()
}

/// The shortest distance between different atoms of two elements, over the neighbouring cells.
fn nearest(crystal: &Crystal, atoms: &[Atom], pair: &str) -> f64 {
    let (first, second) = pair.split_once('-').expect("a pair of elements");
    let around: CellRange = "-1:2".parse().expect("a range");
    let block = Expansion::default()
        .cells(crystal, atoms, around)
        .expect("27 cells");
    let mut least = f64::INFINITY;
    for one in atoms.iter().filter(|atom| atom.element.symbol() == first) {
        for other in block.iter().filter(|atom| atom.element.symbol() == second) {
            let square: f64 = (0..3).map(|i| (one.cart[i] - other.cart[i]).powi(2)).sum();
            if square > 1e-6 {
                least = least.min(square.sqrt());
            }
        }
    }
    least
}

/// The number that moyo finds for the atoms, which it is given without any symmetry.
fn number_by_moyo(crystal: &Crystal, atoms: &[Atom], tolerance: f64) -> i32 {
    let mut kinds: BTreeMap<String, i32> = BTreeMap::new();
    let mut merged: Vec<([f64; 3], String)> = Vec::new();
    // Elements that share a place are one kind of atom.
    for atom in atoms {
        let tag = format!("{}{}", atom.element.symbol(), atom.occupancy);
        let same = |p: &[f64; 3]| (0..3).all(|i| (p[i] - atom.fract[i]).abs() < 1e-4);
        match merged.iter_mut().find(|(place, _)| same(place)) {
            Some((_, kind)) => kind.push_str(&tag),
            None => merged.push((atom.fract, tag)),
        }
    }
    let mut numbers = Vec::new();
    for (_, kind) in &merged {
        let next = kinds.len() as i32;
        numbers.push(*kinds.entry(kind.clone()).or_insert(next));
    }
    let lattice = Lattice::from_basis(crystal.cell.edge_vectors());
    let places = merged.iter().map(|(place, _)| (*place).into()).collect();
    let cell = MoyoCell::new(lattice, places, numbers);
    MoyoDataset::with_default(&cell, tolerance)
        .expect("moyo finds a group")
        .number
}

#[test]
fn shipped_files_have_the_groups_and_atoms_of_their_papers() {
    // Name, group, atoms per cell, density in g/cm³ as the record names it (pyrite's, which does
    // not, by hand), and a distance in Å computed from the record's cell and coordinates by hand.
    let cases = [
        ("quartz.cif", 154, 9, 2.646, "Si-O", 1.605),
        (
            "diamond.cif",
            227,
            8,
            3.516,
            "C-C",
            3.56679 * 3_f64.sqrt() / 4.0,
        ),
        ("halite.cif", 225, 8, 2.164, "Na-Cl", 5.6401 / 2.0),
        ("rutile.cif", 136, 6, 4.249, "Ti-O", 1.949),
        ("calcite.cif", 167, 30, 2.713, "C-O", 4.988 * 0.2567),
        ("pyrite.cif", 205, 12, 5.011, "Fe-S", 2.2624),
        ("spinel.cif", 227, 80, 3.561, "Al-O", 1.925),
    ];
    for (name, number, count, expected_density, pair, distance) in cases {
        let reading = shipped(name);
        let crystal = &reading.crystal;
        assert_eq!(reading.warnings, [], "{name}");
        assert_eq!(crystal.number, Some(number), "{name}");
        let atoms = atoms_of(crystal);
        assert_eq!(atoms.len(), count, "{name}");
        let found = density(crystal, &atoms);
        assert!(
            (found - expected_density).abs() < 0.002,
            "{name}: density {found}"
        );
        let found = nearest(crystal, &atoms, pair);
        assert!((found - distance).abs() < 0.002, "{name}: {pair} {found}");
        assert_eq!(
            number_by_moyo(crystal, &atoms, 1e-4),
            number as i32,
            "{name}"
        );
    }
}

#[test]
fn recalled_crystals_reach_the_anchors_computed_elsewhere() {
    // Cells and coordinates are recalled; counts, densities and distances were computed from
    // them by other programs, so the table judges the construction, not the minerals.
    let table = include_str!("../cif/anchors.tsv");
    let mut seen = 0;
    for line in table.lines().skip(1) {
        let fields: Vec<&str> = line.split('\t').collect();
        let [
            name,
            symbol,
            number,
            cell,
            sites,
            count,
            expected_density,
            pair,
            distance,
        ] = fields.as_slice()
        else {
            panic!("nine fields in {line}");
        };
        let crystal = recalled(name, symbol, cell, sites);
        let number: u32 = number.parse().expect("a number");
        assert_eq!(crystal.number, Some(number), "{name}");
        let atoms = atoms_of(&crystal);
        assert_eq!(atoms.len().to_string(), *count, "{name}");
        if let Ok(expected) = expected_density.parse::<f64>() {
            let found = density(&crystal, &atoms);
            assert!(
                (found - expected).abs() < 2e-3 * expected,
                "{name}: density {found}"
            );
        }
        let expected: f64 = distance.parse().expect("a distance");
        let found = nearest(&crystal, &atoms, pair);
        assert!((found - expected).abs() < 1e-3, "{name}: {pair} {found}");
        assert_eq!(
            number_by_moyo(&crystal, &atoms, 1e-3),
            number as i32,
            "{name}"
        );
        seen += 1;
    }
    assert_eq!(seen, 25);
}

fn recalled(name: &str, symbol: &str, cell: &str, sites: &str) -> Crystal {
    let p: Vec<f64> = cell
        .split(' ')
        .map(|word| word.parse().expect("a number"))
        .collect();
    let mut text = format!(
        "data_x\n_cell_length_a {}\n_cell_length_b {}\n_cell_length_c {}\n_cell_angle_alpha {}\n\
         _cell_angle_beta {}\n_cell_angle_gamma {}\n_space_group_name_H-M_alt '{symbol}'\nloop_\n\
         _atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n",
        p[0], p[1], p[2], p[3], p[4], p[5]
    );
    for site in sites.split("; ") {
        text.push_str(site);
        text.push('\n');
    }
    cif::read_str(name, &text)
        .unwrap_or_else(|error| panic!("{error}"))
        .crystal
}

#[test]
fn every_group_is_found_again_by_moyo_in_a_random_crystal() {
    // Three general positions of different elements have no symmetry but the one given.
    let metric = |number: u32| match number {
        1..=2 => ([8.0, 9.0, 10.0], [83.0, 97.0, 105.0]),
        3..=15 => ([8.0, 9.0, 10.0], [90.0, 103.0, 90.0]),
        16..=74 => ([8.0, 9.0, 10.0], [90.0; 3]),
        75..=142 => ([9.0, 9.0, 11.0], [90.0; 3]),
        143..=194 => ([9.0, 9.0, 11.0], [90.0, 90.0, 120.0]),
        _ => ([14.0; 3], [90.0; 3]),
    };
    for number in 1..=230 {
        let group = SpaceGroup::standard(number).expect("a standard setting");
        let (edges, angles) = metric(number);
        let site = |label: &str, fract: [f64; 3]| Site {
            label: label.to_owned(),
            element: ga_design::crystallography::Element::from_label(label).expect("an element"),
            fract: fract.map(|value| Measured {
                value,
                uncertainty: None,
            }),
            occupancy: 1.0,
        };
        let crystal = Crystal {
            name: String::new(),
            number: Some(number),
            hermann_mauguin: None,
            cell: Cell::new(edges, angles).expect("a cell"),
            operations: group.operations().expect("operations"),
            sites: vec![
                site("Na", [0.1234, 0.3871, 0.0719]),
                site("K", [0.2117, 0.0553, 0.3329]),
                site("Cl", [0.0471, 0.1913, 0.2287]),
            ],
        };
        let atoms = atoms_of(&crystal);
        assert_eq!(atoms.len(), 3 * crystal.operations.len(), "group {number}");
        assert_eq!(
            number_by_moyo(&crystal, &atoms, 1e-5),
            number as i32,
            "group {number}"
        );
    }
}

#[test]
fn placements_equal_the_operations_they_stand_for() {
    for group in SpaceGroup::table() {
        let operations = group.operations().expect("operations");
        // A cell with the symmetry of the setting: the average of a lopsided metric.
        let hexagonal = (143..=194).contains(&group.number) && group.choice != Some('R');
        let angles = if hexagonal {
            [90.0, 90.0, 120.0]
        } else {
            [90.0; 3]
        };
        let edges = if hexagonal { [5.0, 5.0, 7.0] } else { [6.0; 3] };
        let cell = Cell::new(edges, angles).expect("a cell");
        let Ok((placements, frame)) = Placement::of_group(&operations, &cell) else {
            panic!("{} does not fit", group.symbol);
        };
        for (operation, placement) in operations.iter().zip(&placements) {
            assert!(placement.reflections.len() <= 3);
            // The parity of reflections is the handedness of the operation.
            let parity = if placement.reflections.len() % 2 == 0 {
                1
            } else {
                -1
            };
            assert_eq!(parity, operation.determinant(), "{operation}");
            for normal in &placement.reflections {
                let square: f64 = normal.iter().map(|value| value * value).sum();
                assert!((square - 1.0).abs() < 1e-14);
            }
            for point in [[0.1, 0.2, 0.3], [1.0, -2.0, 0.5], [0.0, 0.0, 1.0]] {
                let expected = cell.cartesian(operation.apply(point));
                let found = placement.apply(frame.cartesian(point));
                for i in 0..3 {
                    assert!(
                        (found[i] - expected[i]).abs() < 1e-12,
                        "{} {operation}",
                        group.symbol
                    );
                }
            }
        }
    }
}

#[test]
fn caller_made_maps_build_the_same_cell() {
    let crystal = shipped("calcite.cif").crystal;
    let (placements, frame) =
        Placement::of_group(&crystal.operations, &crystal.cell).expect("placements");
    // Integer operations instead of reflections: an independent way to the same atoms.
    let maps: Vec<_> = crystal
        .operations
        .iter()
        .map(|op: &Operation| move |p| frame.cartesian(op.apply(frame.fractional(p))))
        .collect();
    let expansion = Expansion::default();
    let by_maps = expansion
        .unit_cell_by(&crystal, &frame, &maps)
        .expect("atoms");
    let by_reflections = expansion.unit_cell(&crystal).expect("atoms");
    assert_eq!(by_maps.len(), by_reflections.len());
    for (a, b) in by_maps.iter().zip(&by_reflections) {
        assert_eq!((&a.label, a.operation), (&b.label, b.operation));
        for i in 0..3 {
            assert!((a.fract[i] - b.fract[i]).abs() < 1e-11);
        }
    }
    let short = expansion.unit_cell_by(&crystal, &frame, &maps[1..]);
    assert!(matches!(short, Err(ExpansionError::Count { .. })));
    let broken: Vec<_> = placements.iter().map(|_| |_| [f64::NAN; 3]).collect();
    let error = expansion
        .unit_cell_by(&crystal, &frame, &broken)
        .expect_err("no place");
    assert!(matches!(error, ExpansionError::NotFinite { .. }));
}

#[test]
fn coordinates_near_special_positions_are_moved_onto_them() {
    let text = "data_w\n_cell_length_a 3.82\n_cell_length_b 3.82\n_cell_length_c 6.26\n\
        _cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 120\n\
        _space_group_IT_number 186\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
        _atom_site_fract_y\n_atom_site_fract_z\nZn 0.333 0.667 0\nS .3333 .6667 .375\n";
    let crystal = cif::read_str("wurtzite.cif", text)
        .expect("a crystal")
        .crystal;
    let atoms = atoms_of(&crystal);
    assert_eq!(atoms.len(), 4);
    for atom in &atoms {
        let third = (atom.fract[0] * 3.0).round() / 3.0;
        assert!((atom.fract[0] - third).abs() < 1e-9, "{:?}", atom.fract);
    }
}

#[test]
fn atoms_listed_twice_are_one_and_shared_sites_are_two() {
    let head = "data_x\n_cell_length_a 4\n_cell_length_b 4\n_cell_length_c 4\n\
        _cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n\
        _space_group_name_H-M_alt 'P m -3 m'\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
        _atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n";
    let count = |rows: &str| {
        let crystal = cif::read_str("x.cif", &format!("{head}{rows}"))
            .expect("a crystal")
            .crystal;
        atoms_of(&crystal).len()
    };
    assert_eq!(count("Po1 0 0 0 1\nPo2 0 0 0.999999 1\n"), 1);
    assert_eq!(count("O1 .5 0 0 1\nO2 0 .5 0 1\nO3 0 0 .5 1\n"), 3);
    assert_eq!(count("Na 0 0 0 .5\nK 0 0 0 .5\n"), 2);
    // Two half-filled positions of one element, 0.4 Å apart, are not one atom.
    assert_eq!(count("H 0 0 .05 .5\n"), 6);
}

#[test]
fn a_billion_cells_are_refused() {
    let crystal = shipped("halite.cif").crystal;
    let atoms = atoms_of(&crystal);
    let range: CellRange = "1000x1000x1000".parse().expect("a range");
    let error = Expansion::default()
        .cells(&crystal, &atoms, range)
        .expect_err("too many");
    assert!(error.to_string().contains("8000000000 atoms"), "{error}");
    for (text, part) in [
        ("", "no range of cells"),
        ("2x2", "no range of cells"),
        ("2x2xq", "no range of cells"),
        ("0x1x1", "holds no cell"),
        ("3:1", "holds no cell"),
        ("-1", "holds no cell"),
        ("99999999999999999999", "beyond"),
        ("1000001:1000002", "beyond"),
        ("1:2:3", "no range of cells"),
        ("2x2x2x2", "no range of cells"),
    ] {
        let error = text.parse::<CellRange>().expect_err(text).to_string();
        assert!(error.contains(part), "{text}: {error}");
    }
}

#[test]
fn cells_that_are_none_are_refused() {
    let right = [90.0; 3];
    for (edges, angles, part) in [
        ([0.0, 1.0, 1.0], right, "edge a"),
        ([1.0, -1.0, 1.0], right, "edge b"),
        ([1.0, 1.0, f64::NAN], right, "edge c"),
        ([1.0, 1.0, f64::INFINITY], right, "edge c"),
        ([1.0, 1.0, 1e9], right, "edge c"),
        ([1.0; 3], [0.0, 90.0, 90.0], "angle alpha"),
        ([1.0; 3], [90.0, 180.0, 90.0], "angle beta"),
        ([1.0; 3], [90.0, 90.0, f64::NAN], "angle gamma"),
        ([1.0; 3], [120.0, 120.0, 120.0], "no cell has the angles"),
        ([1.0; 3], [30.0, 30.0, 90.0], "no cell has the angles"),
        ([1.0; 3], [30.0, 60.0, 90.0], "no cell has the angles"),
    ] {
        let error = Cell::new(edges, angles).expect_err(part).to_string();
        assert!(error.contains(part), "{error}");
    }
}
