//! The edges of a cell made from the roots of its point group.

use ga_cga::{DirectionVector, Vector3};
use ga_design::crystallography::lattice::{EdgeError, EdgeParameters, edge_vectors, reciprocal};
use ga_design::crystallography::{CrystalClass, CrystalSystem, PointGroup};

/// Table 3.4: the lattice that the roots span goes to itself under every transformation.
#[test]
fn edges_from_roots_span_a_lattice_of_their_group() {
    let parameters = EdgeParameters {
        lengths: [2.0, 2.3, 3.1],
        angles: [81.0, 97.0, 104.0],
    };
    for class in CrystalClass::table() {
        let symbol = class.symbol();
        let edges = edge_vectors(symbol, &parameters).expect("a crystal class");
        let duals = reciprocal(edges).expect("three edges that span space");
        for transformation in class.group().transformations() {
            for edge in edges {
                let image = transformation.apply(DirectionVector::along(edge)).vector();
                for dual in duals {
                    let part = image.scalar_product(dual);
                    assert!((part - part.round()).abs() < 1e-12, "{symbol}: {part}");
                }
            }
        }
        // The cell is of the system: the free parameters are kept, the others follow.
        let lengths = edges.map(|edge| edge.norm());
        assert!((lengths[0] - 2.0).abs() < 1e-12);
        let angle = |one: Vector3, other: Vector3| {
            (one.scalar_product(other) / (one.norm() * other.norm()))
                .acos()
                .to_degrees()
        };
        let [a, b, c] = edges;
        let angles = [angle(b, c), angle(c, a), angle(a, b)];
        match class.system {
            CrystalSystem::Triclinic => {
                for (found, given) in angles.iter().zip(parameters.angles) {
                    assert!((found - given).abs() < 1e-9);
                }
            }
            CrystalSystem::Monoclinic => {
                let free = if symbol.to_string() == "1" { 0 } else { 2 };
                for (at, angle) in angles.iter().enumerate() {
                    let given = if at == free {
                        parameters.angles[at]
                    } else {
                        90.0
                    };
                    assert!((angle - given).abs() < 1e-9, "{symbol}");
                }
            }
            CrystalSystem::Trigonal | CrystalSystem::Hexagonal => {
                let between = if symbol.p() == 3 { 60.0 } else { 120.0 };
                assert!((angles[2] - between).abs() < 1e-9, "{symbol}");
                assert!((lengths[0] - lengths[1]).abs() < 1e-12);
            }
            system => {
                assert!(
                    angles.iter().all(|angle| (angle - 90.0).abs() < 1e-9),
                    "{symbol}"
                );
                let equal = lengths
                    .iter()
                    .filter(|l| (*l - lengths[0]).abs() < 1e-12)
                    .count();
                let needed = match system {
                    CrystalSystem::Orthorhombic => 1,
                    CrystalSystem::Tetragonal => 2,
                    _ => 3,
                };
                assert_eq!(equal, needed, "{symbol}");
            }
        }
    }
}

#[test]
fn groups_and_parameters_without_a_lattice_are_refused() {
    let parameters = EdgeParameters {
        lengths: [2.0, 2.3, 3.1],
        angles: [90.0; 3],
    };
    for symbol in ["5", "b(5)b(3)", "82", "(12)2", "b(53)", "7"] {
        let error = edge_vectors(symbol.parse().expect("a symbol"), &parameters);
        assert!(
            matches!(error, Err(EdgeError::NoLattice { .. })),
            "{symbol}"
        );
        assert!(PointGroup::from_geometric(symbol).is_ok());
    }
    let flat = EdgeParameters {
        lengths: [2.0, 0.0, 3.1],
        angles: [90.0; 3],
    };
    assert!(matches!(
        edge_vectors("22".parse().expect("22"), &flat),
        Err(EdgeError::Cell(_))
    ));
    assert_eq!(reciprocal([Vector3::new(1.0, 0.0, 0.0); 3]), None);
    assert_eq!(reciprocal([Vector3::new(f64::NAN, 0.0, 0.0); 3]), None);
}
