//! The fourteen lattices, and the centrings as lattices of points.

use ga_cga::Vector3;
use ga_design::crystallography::lattice::reciprocal;
use ga_design::crystallography::{
    BravaisLattice, CellShape, Centring, CrystalSystem, Operation, SpaceGroup,
};

#[test]
fn the_fourteen_lattices_are_those_of_systems_and_centrings() {
    let mut found: Vec<BravaisLattice> = CrystalSystem::ALL
        .into_iter()
        .flat_map(|system| Centring::ALL.map(|centring| (system, centring)))
        .filter_map(|(system, centring)| BravaisLattice::of(system, centring))
        .collect();
    found.sort();
    found.dedup();
    assert_eq!(found, BravaisLattice::ALL);
    for lattice in BravaisLattice::ALL {
        assert_eq!(
            BravaisLattice::from_pearson(lattice.pearson()),
            Some(lattice)
        );
    }
    assert_eq!(BravaisLattice::from_pearson("cR"), None);
    // How many space groups each has (International Tables A): 230 in all.
    let counts = [2, 8, 5, 30, 15, 9, 5, 49, 19, 45, 7, 15, 10, 11];
    for (lattice, count) in BravaisLattice::ALL.into_iter().zip(counts) {
        let groups = (1..=230).filter(|number| {
            let group = SpaceGroup::standard(*number).expect("a number");
            let letter = group.symbol.chars().next().expect("a lattice letter");
            let centring = Centring::from_letter(letter).expect("a centring");
            BravaisLattice::of(group.crystal_system(), centring) == Some(lattice)
        });
        assert_eq!(groups.count(), count, "{lattice:?}");
    }
}

#[test]
fn centring_points_are_a_lattice() {
    for centring in Centring::ALL {
        assert_eq!(Centring::from_letter(centring.letter()), Some(centring));
        let translations = centring.translations();
        assert_eq!(translations.len(), centring.points().len());
        for one in &translations {
            for other in &translations {
                let sum = one.after(other).expect("a translation");
                assert!(translations.contains(&sum), "{centring}");
            }
        }
        // As the Hall symbols have it.
        let hall = ga_design::crystallography::hall::operations(&format!("{centring} 1"));
        let mut expected: Vec<Operation> = hall.expect("a Hall symbol");
        let mut found = translations;
        expected.sort();
        found.sort();
        assert_eq!(found, expected);
    }
    assert_eq!(Centring::from_letter('X'), None);
}

#[test]
fn primitive_cells_hold_one_lattice_point() {
    let cell = CellShape::Triclinic.example().cell().expect("a cell");
    let edges = cell.edge_vectors().map(Vector3::from);
    for centring in Centring::ALL {
        let primitive = centring.primitive_edges(edges);
        let [[a, b, c], [x, y, z]] = [edges, primitive];
        let ratio = (a ^ b ^ c).e123 / (x ^ y ^ z).e123;
        let points = centring.points().len() as f64;
        assert!((ratio - points).abs() < 1e-12, "{centring}: {ratio}");
        // Edges and centring points are whole combinations of the primitive edges.
        let duals = reciprocal(primitive).expect("a cell");
        let centres = centring.translations();
        let centres = centres
            .iter()
            .map(|t| Vector3::from(cell.cartesian(t.translation_f64())));
        for vector in edges.into_iter().chain(centres) {
            for dual in duals {
                let part = vector.scalar_product(dual);
                assert!((part - part.round()).abs() < 1e-12, "{centring}: {part}");
            }
        }
    }
}
