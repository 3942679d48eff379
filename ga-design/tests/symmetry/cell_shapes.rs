//! What the systems ask of a cell: constraints, their messages, and free parameters.

use ga_design::crystallography::lattice::Axis;
use ga_design::crystallography::{Cell, CellParameters, CellShape, Operation};

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
