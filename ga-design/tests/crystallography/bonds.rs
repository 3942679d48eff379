//! Whether atoms are joined as chemists join them.

use ga_design::crystallography::bonds::coordination;
use ga_design::crystallography::{
    Atom, Bond, BondError, Bonding, CellRange, Crystal, Expansion, cif,
};
use std::collections::BTreeMap;

type Counts<T> = &'static [(&'static str, T)];

fn crystal(text: &str) -> Crystal {
    let reading = cif::read_str("test.cif", text);
    reading.unwrap_or_else(|error| panic!("{error}")).crystal
}

fn unit(crystal: &Crystal) -> Vec<Atom> {
    let atoms = Expansion::default().unit_cell(crystal);
    atoms.unwrap_or_else(|error| panic!("{error}"))
}

fn bonded(crystal: &Crystal) -> (Vec<Atom>, Vec<Bond>) {
    let atoms = unit(crystal);
    let bonds = Bonding::default().periodic(&crystal.cell, &atoms);
    let bonds = bonds.unwrap_or_else(|error| panic!("{error}"));
    (atoms, bonds)
}

/// For each element the coordination numbers that occur.
fn numbers(crystal: &Crystal) -> BTreeMap<&'static str, Vec<usize>> {
    let (atoms, bonds) = bonded(crystal);
    let counts = coordination(&bonds, atoms.len());
    let mut found: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (atom, count) in atoms.iter().zip(counts) {
        let of_element = found.entry(atom.element.symbol()).or_default();
        if !of_element.contains(&count) {
            of_element.push(count);
        }
    }
    for counts in found.values_mut() {
        counts.sort_unstable();
    }
    found
}

/// A cubic crystal of these sites, each `label x y z`.
fn cubic(edge: f64, group: &str, sites: &[&str]) -> Crystal {
    cell([edge; 3], [90.0; 3], group, sites)
}

fn cell([a, b, c]: [f64; 3], angles: [f64; 3], group: &str, sites: &[&str]) -> Crystal {
    let [alpha, beta, gamma] = angles;
    crystal(&format!(
        "data_x\n_cell_length_a {a}\n_cell_length_b {b}\n_cell_length_c {c}\n\
         _cell_angle_alpha {alpha}\n_cell_angle_beta {beta}\n_cell_angle_gamma {gamma}\n\
         _space_group_name_H-M_alt '{group}'\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
         _atom_site_fract_y\n_atom_site_fract_z\n{}\n",
        sites.join("\n")
    ))
}

#[test]
fn shipped_crystals_have_the_coordination_of_the_textbooks() {
    let known: [(&str, &str, Counts<&[usize]>); 6] = [
        (
            "quartz",
            include_str!("../../data/cif/quartz.cif"),
            &[("Si", &[4]), ("O", &[2])],
        ),
        (
            "diamond",
            include_str!("../../data/cif/diamond.cif"),
            &[("C", &[4])],
        ),
        (
            "halite",
            include_str!("../../data/cif/halite.cif"),
            &[("Na", &[6]), ("Cl", &[6])],
        ),
        // An oxygen of calcite has its carbon and two calciums.
        (
            "calcite",
            include_str!("../../data/cif/calcite.cif"),
            &[("C", &[3]), ("Ca", &[6]), ("O", &[3])],
        ),
        (
            "rutile",
            include_str!("../../data/cif/rutile.cif"),
            &[("Ti", &[6]), ("O", &[3])],
        ),
        // A sulfur of pyrite has three irons and the other sulfur of its pair.
        (
            "pyrite",
            include_str!("../../data/cif/pyrite.cif"),
            &[("Fe", &[6]), ("S", &[4])],
        ),
    ];
    for (name, text, expected) in known {
        let expected: BTreeMap<&str, Vec<usize>> = expected
            .iter()
            .map(|(el, counts)| (*el, counts.to_vec()))
            .collect();
        assert_eq!(numbers(&crystal(text)), expected, "{name}");
    }
}

#[test]
fn metals_of_a_shared_site_each_have_their_oxygens() {
    // Tetrahedra and octahedra of spinel, each site occupied by both metals; an oxygen has three
    // octahedral and one tetrahedral neighbour, each twice.
    let spinel = numbers(&crystal(include_str!("../../data/cif/spinel.cif")));
    assert_eq!(spinel["Mg"], [4, 6]);
    assert_eq!(spinel["Al"], [4, 6]);
    assert_eq!(spinel["O"], [8]);
}

#[test]
fn simple_structures_have_their_coordination() {
    let cases: [(&str, Crystal, Counts<usize>); 12] = [
        (
            "fluorite",
            cubic(5.463, "F m -3 m", &["Ca 0 0 0", "F 0.25 0.25 0.25"]),
            &[("Ca", 8), ("F", 4)],
        ),
        (
            "caesium chloride",
            cubic(4.123, "P m -3 m", &["Cs 0 0 0", "Cl 0.5 0.5 0.5"]),
            &[("Cs", 8), ("Cl", 8)],
        ),
        (
            "zinc blende",
            cubic(5.409, "F -4 3 m", &["Zn 0 0 0", "S 0.25 0.25 0.25"]),
            &[("Zn", 4), ("S", 4)],
        ),
        (
            "perovskite",
            cubic(
                3.905,
                "P m -3 m",
                &["Sr 0 0 0", "Ti 0.5 0.5 0.5", "O 0.5 0.5 0"],
            ),
            &[("Sr", 12), ("Ti", 6), ("O", 6)],
        ),
        (
            "copper",
            cubic(3.615, "F m -3 m", &["Cu 0 0 0"]),
            &[("Cu", 12)],
        ),
        (
            "aluminium",
            cubic(4.049, "F m -3 m", &["Al 0 0 0"]),
            &[("Al", 12)],
        ),
        // Eight neighbours and six hardly farther, as the metal is usually counted.
        (
            "iron",
            cubic(2.866, "I m -3 m", &["Fe 0 0 0"]),
            &[("Fe", 14)],
        ),
        (
            "magnesium",
            cell(
                [3.209, 3.209, 5.211],
                [90.0, 90.0, 120.0],
                "P 63/m m c",
                &["Mg 0.33333 0.66667 0.25"],
            ),
            &[("Mg", 12)],
        ),
        // A hydride: the hydrogens have nothing but metals.
        (
            "lithium hydride",
            cubic(4.083, "F m -3 m", &["Li 0 0 0", "H 0.5 0.5 0.5"]),
            &[("Li", 6), ("H", 6)],
        ),
        (
            "graphite",
            cell(
                [2.461, 2.461, 6.708],
                [90.0, 90.0, 120.0],
                "P 63/m m c",
                &["C1 0 0 0.25", "C2 0.33333 0.66667 0.25"],
            ),
            &[("C", 3)],
        ),
        (
            "periclase",
            cubic(4.212, "F m -3 m", &["Mg 0 0 0", "O 0.5 0.5 0.5"]),
            &[("Mg", 6), ("O", 6)],
        ),
        (
            "lithium iodide",
            cubic(6.0, "F m -3 m", &["Li 0 0 0", "I 0.5 0.5 0.5"]),
            &[("Li", 6), ("I", 6)],
        ),
    ];
    for (name, crystal, expected) in cases {
        let found = numbers(&crystal);
        for (element, count) in expected {
            assert_eq!(found[element], [*count], "{name}");
        }
    }
}

#[test]
fn hydrogens_have_one_bond_and_none_to_each_other() {
    // Water and methane with the distances that X-rays give, a hydrogen molecule, and hydrogens of
    // two molecules 1.0 Å apart.
    let sites = [
        "O1 0.10 0.10 0.10",
        "H1 0.18 0.10 0.10",
        "H2 0.08 0.178 0.10",
        "C1 0.50 0.50 0.50",
        "H3 0.5630 0.5630 0.5630",
        "H4 0.437 0.437 0.563",
        "H5 0.437 0.563 0.437",
        "H6 0.563 0.437 0.437",
        "H7 0.80 0.80 0.10",
        "H8 0.874 0.80 0.10",
        "H9 0.28 0.10 0.10",
    ];
    let found = bonded(&cubic(10.0, "P 1", &sites));
    let (atoms, bonds) = &found;
    let mut joined: Vec<String> = bonds
        .iter()
        .map(|bond| bond.atoms.map(|at| atoms[at].label.to_string()).join("-"))
        .collect();
    joined.sort();
    assert_eq!(
        joined,
        [
            "C1-H3", "C1-H4", "C1-H5", "C1-H6", "H7-H8", "O1-H1", "O1-H2"
        ]
    );
}

#[test]
fn what_stands_between_parts_a_bond() {
    // A barium 3.45 Å from the sulfur of a sulfate, with an oxygen between them.
    let with_oxygen = ["Ba 0.1 0.1 0.1", "S 0.445 0.1 0.1", "O 0.34 0.2 0.1"];
    let (_, bonds) = bonded(&cubic(10.0, "P 1", &with_oxygen));
    let pairs: Vec<_> = bonds.iter().map(|bond| bond.atoms).collect();
    assert_eq!(pairs, [[0, 2], [1, 2]]);
    let (_, bonds) = bonded(&cubic(10.0, "P 1", &with_oxygen[..2]));
    assert_eq!(bonds.len(), 1);
}

#[test]
fn bonds_lead_across_the_faces_of_small_cells() {
    // Polonium: one atom, bonded to its own images along the three edges.
    let (_, bonds) = bonded(&cubic(3.359, "P m -3 m", &["Po 0 0 0"]));
    let mut images: Vec<_> = bonds.iter().map(|bond| bond.image).collect();
    images.sort_unstable();
    assert_eq!(images, [[0, 0, 1], [0, 1, 0], [1, 0, 0]]);
    assert_eq!(coordination(&bonds, 1), [6]);
}

/// The distances of all pairs, by trying every image nearby.
fn by_trying(crystal: &Crystal, atoms: &[Atom], reach: f64) -> Vec<(usize, usize, [i32; 3])> {
    let mut found = Vec::new();
    let around = CellRange {
        low: [-4; 3],
        high: [5; 3],
    };
    for (i, one) in atoms.iter().enumerate() {
        for (j, other) in atoms.iter().enumerate().skip(i) {
            for image in around.offsets() {
                if i == j && image <= [0; 3] {
                    continue;
                }
                let step = [0, 1, 2].map(|k| other.fract[k] + f64::from(image[k]) - one.fract[k]);
                let [x, y, z] = crystal.cell.cartesian(step);
                if (x * x + y * y + z * z).sqrt() <= reach {
                    found.push((i, j, image));
                }
            }
        }
    }
    found.sort_unstable();
    found
}

#[test]
fn all_images_within_reach_are_found_in_any_cell() {
    // Of one kind of atom in oblique cells, with a rule that joins whatever is near.
    for (edges, angles) in [
        ([3.0, 4.0, 5.0], [90.0, 90.0, 90.0]),
        ([2.6, 9.0, 2.9], [63.0, 71.0, 58.0]),
        ([4.0, 4.0, 4.0], [35.0, 40.0, 45.0]),
        ([12.0, 2.5, 7.0], [110.0, 95.0, 118.0]),
    ] {
        let sites = ["O1 0.02 0.98 0.5", "O2 0.9 0.3 0.01", "O3 0.45 0.55 0.7"];
        let crystal = cell(edges, angles, "P 1", &sites);
        let atoms = unit(&crystal);
        let bonding = Bonding {
            nearest: 0.0,
            farthest: 2.2,
        };
        let bonds = bonding.periodic(&crystal.cell, &atoms).expect("bonds");
        let reach = 2.2 * 2.0 * 0.66;
        let all = by_trying(&crystal, &atoms, reach);
        for bond in &bonds {
            let [i, j] = bond.atoms;
            assert!(all.contains(&(i, j, bond.image)), "{bond:?}");
            assert!(bond.length <= reach);
        }
        // Every pair that is not there has a third atom between its ends.
        let place = |at: usize, image: [i32; 3]| {
            crystal
                .cell
                .cartesian([0, 1, 2].map(|k| atoms[at].fract[k] + f64::from(image[k])))
        };
        let square = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>();
        let around = CellRange {
            low: [-4; 3],
            high: [5; 3],
        };
        for (i, j, image) in all {
            let (from, to) = (place(i, [0; 3]), place(j, image));
            let mut middles = (0..3).flat_map(|k| around.offsets().map(move |cell| (k, cell)));
            let is_parted = middles.any(|(k, cell)| {
                let middle = place(k, cell);
                let (left, right) = (square(from, middle), square(middle, to));
                left > 1e-9 && right > 1e-9 && left + right < square(from, to) * (1.0 - 1e-9)
            });
            let is_bond = bonds
                .iter()
                .any(|bond| bond.atoms == [i, j] && bond.image == image);
            assert_eq!(is_bond, !is_parted, "{i} {j} {image:?}");
        }
    }
}

#[test]
fn a_block_has_the_bonds_of_its_cells() {
    let quartz = crystal(include_str!("../../data/cif/quartz.cif"));
    let (atoms, periodic) = bonded(&quartz);
    let range: CellRange = "-1:2x2x3".parse().expect("a range");
    let block = Expansion::default()
        .cells(&quartz, &atoms, range)
        .expect("a block");
    let between = Bonding::default().between(&block).expect("bonds");
    assert!(between.iter().all(|bond| bond.image == [0; 3]));
    // Of each bond of the unit cell as many copies as there are cells whose neighbour is there too.
    let copies = |image: [i32; 3]| -> usize {
        (0..3)
            .map(|i| (range.high[i] - range.low[i] - image[i].abs()).max(0) as usize)
            .product()
    };
    let expected: usize = periodic.iter().map(|bond| copies(bond.image)).sum();
    assert_eq!(between.len(), expected);
}

#[test]
fn nothing_is_joined_where_nothing_can_be() {
    let bonding = Bonding::default();
    assert_eq!(bonding.between(&[]), Ok(Vec::new()));
    // Unknown atoms, alternative positions of one atom, and factors that are no lengths.
    let (_, bonds) = bonded(&cubic(10.0, "P 1", &["X1 0.1 0.1 0.1", "X2 0.25 0.1 0.1"]));
    assert_eq!(bonds, []);
    let (_, bonds) = bonded(&cubic(10.0, "P 1", &["C1 0.1 0.1 0.1", "C2 0.15 0.1 0.1"]));
    assert_eq!(bonds, []);
    let halite = crystal(include_str!("../../data/cif/halite.cif"));
    let atoms = unit(&halite);
    for farthest in [0.0, -1.0, f64::NAN] {
        let bonding = Bonding {
            nearest: 0.6,
            farthest,
        };
        assert_eq!(bonding.periodic(&halite.cell, &atoms), Ok(Vec::new()));
    }
}

#[test]
fn crowds_and_places_beyond_all_bounds_are_refused() {
    let thin = cell([0.01, 50.0, 50.0], [90.0; 3], "P 1", &["Cs 0 0 0"]);
    let atoms = unit(&thin);
    let crowded = Bonding::default().periodic(&thin.cell, &atoms);
    assert_eq!(crowded, Err(BondError::Crowded));
    let message = crowded.expect_err("a crowd").to_string();
    assert!(message.contains("leave the bonds out"), "{message}");

    let halite = crystal(include_str!("../../data/cif/halite.cif"));
    let mut atoms = unit(&halite);
    for value in [f64::NAN, f64::INFINITY, 1e9] {
        atoms[3].fract[1] = value;
        let found = Bonding::default().periodic(&halite.cell, &atoms);
        assert_eq!(found, Err(BondError::Place(3)));
        atoms[3].cart[1] = value;
        assert!(Bonding::default().between(&atoms).is_err());
    }
    let enormous = Bonding {
        nearest: 0.6,
        farthest: 1e9,
    };
    let atoms = unit(&halite);
    assert_eq!(
        enormous.periodic(&halite.cell, &atoms),
        Err(BondError::Crowded)
    );
}
