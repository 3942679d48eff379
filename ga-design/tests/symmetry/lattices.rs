//! Systems, centrings, cell constraints, and edges made from roots.

use ga_cga::{DirectionVector, Vector3};
use ga_design::crystallography::lattice::{
    Axis, EdgeError, EdgeParameters, edge_vectors, reciprocal,
};
use ga_design::crystallography::{
    BravaisLattice, Cell, CellParameters, CellShape, Centring, CrystalClass, CrystalSystem,
    Operation, PointGroup, SpaceGroup,
};

const SHAPES: [CellShape; 9] = [
    CellShape::Triclinic,
    CellShape::Monoclinic(Axis::A),
    CellShape::Monoclinic(Axis::B),
    CellShape::Monoclinic(Axis::C),
    CellShape::Orthorhombic,
    CellShape::Tetragonal,
    CellShape::Hexagonal,
    CellShape::Rhombohedral,
    CellShape::Cubic,
];

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

/// The point groups of lattices are as large as Bravais says, for a cell of each shape.
#[test]
fn example_cells_have_the_symmetry_of_their_system_and_no_more() {
    let matrices: Vec<[[i32; 3]; 3]> = (0..19683)
        .map(|mut code| {
            let mut entries = [[0; 3]; 3];
            for entry in entries.iter_mut().flatten() {
                *entry = code % 3 - 1;
                code /= 3;
            }
            entries
        })
        .filter(|w| Operation::new(*w, [0.into(); 3]).is_some())
        .collect();
    for (shape, order) in SHAPES.into_iter().zip([2, 4, 4, 4, 8, 16, 24, 12, 48]) {
        let parameters = shape.example();
        assert_eq!(parameters.shape(), shape);
        let cell = parameters.cell().expect("a cell");
        assert_eq!(shape.check(&cell), Ok(()));
        let g = cell.metric();
        let keeps = |w: &&[[i32; 3]; 3]| {
            (0..3).all(|i| {
                (0..3).all(|j| {
                    let image: f64 = (0..3)
                        .flat_map(|k| (0..3).map(move |l| (k, l)))
                        .map(|(k, l)| f64::from(w[k][i]) * g[k][l] * f64::from(w[l][j]))
                        .sum();
                    (image - g[i][j]).abs() < 1e-9
                })
            })
        };
        assert_eq!(matrices.iter().filter(keeps).count(), order, "{shape}");
    }
}

#[test]
fn violated_constraints_are_named() {
    let cell = |edges, angles| Cell::new(edges, angles).expect("a cell");
    let right = [90.0; 3];
    let cases = [
        (
            CellShape::Tetragonal,
            cell([4.1, 4.3, 6.0], right),
            "tetragonal needs a = b; here a = 4.1, b = 4.3",
        ),
        (
            CellShape::Tetragonal,
            cell([4.1, 4.1, 6.0], [90.0, 90.0, 92.0]),
            "tetragonal needs gamma = 90; here gamma = 92",
        ),
        (
            CellShape::Cubic,
            cell([4.0, 4.0, 4.2], right),
            "cubic needs b = c; here b = 4, c = 4.2",
        ),
        (
            CellShape::Cubic,
            cell([4.0; 3], [90.0, 91.0, 90.0]),
            "cubic needs beta = 90; here beta = 91",
        ),
        (
            CellShape::Hexagonal,
            cell([4.0, 4.0, 5.0], [90.0, 90.0, 60.0]),
            "hexagonal needs gamma = 120; here gamma = 60",
        ),
        (
            CellShape::Hexagonal,
            cell([4.0, 4.5, 5.0], [90.0, 90.0, 120.0]),
            "hexagonal needs a = b",
        ),
        (
            CellShape::Rhombohedral,
            cell([4.0; 3], [70.0, 70.0, 75.0]),
            "rhombohedral needs beta = gamma; here beta = 70, gamma = 75",
        ),
        (
            CellShape::Rhombohedral,
            cell([4.0, 4.0, 5.0], [70.0; 3]),
            "rhombohedral needs b = c",
        ),
        (
            CellShape::Orthorhombic,
            cell([4.0, 5.0, 6.0], [95.0, 90.0, 90.0]),
            "orthorhombic needs alpha = 90; here alpha = 95",
        ),
        (
            CellShape::Monoclinic(Axis::B),
            cell([4.0, 5.0, 6.0], [90.0, 100.0, 101.0]),
            "monoclinic with unique axis b needs gamma = 90; here gamma = 101",
        ),
        (
            CellShape::Monoclinic(Axis::C),
            cell([4.0, 5.0, 6.0], [90.0, 100.0, 90.0]),
            "unique axis c needs beta = 90",
        ),
        (
            CellShape::Monoclinic(Axis::A),
            cell([4.0, 5.0, 6.0], [100.0, 90.0, 95.0]),
            "unique axis a needs gamma = 90",
        ),
    ];
    for (shape, cell, message) in cases {
        let error = shape.check(&cell).expect_err(message);
        assert!(error.to_string().contains(message), "{error}");
        let loose = shape.check_within(&cell, 0.5, 61.0);
        assert_eq!(loose, Ok(()), "{shape}");
    }
    let rounded = cell([4.0, 4.001, 6.0], [90.02, 90.0, 119.99]);
    assert_eq!(CellShape::Hexagonal.check(&rounded), Ok(()));
    let exact = CellShape::Hexagonal.idealized(&rounded).expect("a cell");
    assert_eq!(exact.angles(), [90.0, 90.0, 120.0]);
    assert_eq!(exact.edges()[0], exact.edges()[1]);
    for shape in SHAPES {
        let cell = shape.example().cell().expect("a cell");
        let exact = shape.idealized(&cell).expect("a cell");
        assert_eq!(
            (exact.edges(), exact.angles()),
            (cell.edges(), cell.angles())
        );
    }
    assert_eq!(
        SHAPES.map(CellShape::free_parameters),
        [6, 4, 4, 4, 3, 2, 2, 2, 1]
    );
}

#[test]
fn a_tolerance_that_is_no_number_lets_nothing_pass() {
    let cube = Cell::new([4.0; 3], [90.0; 3]).expect("a cell");
    let rhombohedron = Cell::new([4.0; 3], [75.0; 3]).expect("a cell");
    assert_eq!(CellShape::Cubic.check_within(&cube, 0.0, 0.0), Ok(()));
    assert!(CellShape::Cubic.check_within(&cube, f64::NAN, 0.0).is_err());
    assert!(CellShape::Cubic.check_within(&cube, 0.0, f64::NAN).is_err());
    let shape = CellShape::Rhombohedral;
    assert!(shape.check_within(&rhombohedron, 0.0, f64::NAN).is_err());
    assert!(shape.check_within(&rhombohedron, -1.0, 0.1).is_err());
}

#[test]
fn parameters_of_no_cell_are_refused() {
    let bad = [
        CellParameters::Cubic { a: 0.0 },
        CellParameters::Cubic { a: f64::NAN },
        CellParameters::Rhombohedral {
            a: 4.0,
            alpha: 120.0,
        },
        CellParameters::Tetragonal { a: 4.0, c: -1.0 },
        CellParameters::Hexagonal {
            a: f64::INFINITY,
            c: 1.0,
        },
        CellParameters::Orthorhombic {
            edges: [1.0, 2.0, 0.0],
        },
        CellParameters::Monoclinic {
            edges: [1.0; 3],
            unique: Axis::B,
            angle: 180.0,
        },
        CellParameters::Triclinic {
            edges: [1.0; 3],
            angles: [30.0, 30.0, 90.0],
        },
    ];
    for parameters in bad {
        assert!(parameters.cell().is_err(), "{parameters:?}");
    }
}

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

#[test]
fn rhombohedral_and_hexagonal_axes_become_each_other() {
    for alpha in [46.08, 60.0, 85.0, 90.0, 109.0] {
        let given = CellParameters::Rhombohedral { a: 5.3, alpha };
        let hexagonal = given.on_hexagonal_axes().expect("a cell");
        let CellParameters::Hexagonal { a, c } = hexagonal else {
            panic!("hexagonal axes")
        };
        // International Tables A, table 3.1.4.1: a = a_r √2 √(1 − cos α), c = a_r √3 √(1 + 2 cos α).
        let cosine = alpha.to_radians().cos();
        assert!((a - 5.3 * (2.0 * (1.0 - cosine)).sqrt()).abs() < 1e-12);
        assert!((c - 5.3 * (3.0 * (1.0 + 2.0 * cosine)).sqrt()).abs() < 1e-12);
        let Some(CellParameters::Rhombohedral { a, alpha: back }) =
            hexagonal.on_rhombohedral_axes()
        else {
            panic!("rhombohedral axes")
        };
        assert!((a - 5.3).abs() < 1e-12 && (back - alpha).abs() < 1e-10);
    }
    let cubic = CellParameters::Cubic { a: 4.0 };
    assert_eq!(cubic.on_hexagonal_axes(), Some(cubic));
    assert_eq!(cubic.on_rhombohedral_axes(), Some(cubic));
    let flat = CellParameters::Rhombohedral {
        a: 4.0,
        alpha: 120.0,
    };
    assert_eq!(flat.on_hexagonal_axes(), None);
    assert_eq!(
        CellParameters::Hexagonal { a: -1.0, c: 1.0 }.on_rhombohedral_axes(),
        None
    );
}
