//! The 230 groups and all their settings, grown from roots, against Hall symbols and against the
//! program moyo.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use ga_design::crystallography::{
    Cell, ExpressionError, GenerationError, GeneratorExpression, Isometry, Motion, Operation,
    PointGroup, RootDirection, SpaceGroup, SpaceGroupGenerators,
};
use moyo::data::{HallSymbol, hall_symbol_entry};

fn sorted(mut operations: Vec<Operation>) -> Vec<Operation> {
    operations.sort_unstable();
    operations
}

fn standard(number: u32) -> &'static SpaceGroup {
    SpaceGroup::standard(number).unwrap_or_else(|| panic!("group {number}"))
}

fn example(group: &SpaceGroup) -> Cell {
    group.cell_shape().example().cell().expect("an example")
}

#[test]
fn all_settings_generated_from_roots_have_the_operations_of_their_hall_symbols() {
    for group in SpaceGroup::table() {
        let name = group.qualified_symbol();
        let generated = group
            .generate_operations()
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(generated.first(), Some(&Operation::IDENTITY), "{name}");
        let expected = group.operations().expect("a Hall symbol of the table");
        assert_eq!(
            sorted(generated),
            sorted(expected),
            "{name} ({})",
            group.hall
        );
    }
}

#[test]
fn all_settings_of_moyo_are_generated() {
    let (mut compared, mut settings) = (BTreeSet::new(), 0);
    for hall_number in 1..=530 {
        let entry = hall_symbol_entry(hall_number).expect("530 entries");
        let symbol = HallSymbol::new(entry.hall_symbol).expect("its own symbol");
        let mut expected = BTreeSet::new();
        for operation in symbol.traverse().iter() {
            for centring in symbol.centering.lattice_points() {
                let shift = operation.translation_as_array();
                let units = [0, 1, 2].map(|i| {
                    let sum = shift[i] + centring[i];
                    ((sum * 24.0).round() as i64).rem_euclid(24)
                });
                expected.insert((operation.rotation_as_array(), units));
            }
        }
        let hall = entry.hall_symbol.replace('^', "'").replace('=', "\"");
        // Two of its symbols may be one group with the same operations.
        let ours = SpaceGroup::table()
            .iter()
            .find(|group| group.hall == hall && group.number == entry.number as u32);
        let Some(group) = ours else { continue };
        let generated: BTreeSet<_> = group
            .generate_operations()
            .expect("a setting of the table")
            .iter()
            .map(|op| {
                let units = op
                    .translation_f64()
                    .map(|value| (value * 24.0).round() as i64);
                (op.rotation(), units)
            })
            .collect();
        assert_eq!(
            generated, expected,
            "{} {}",
            entry.number, entry.hall_symbol
        );
        compared.insert(group.number);
        settings += 1;
    }
    assert_eq!(compared.len(), 230);
    assert!(settings >= 525, "{settings} settings compared");
}

/// A wrong glide or screw would give more cosets than the point group has elements.
#[test]
fn the_cosets_of_the_lattice_are_as_many_as_the_point_group_has_elements() {
    for group in SpaceGroup::table() {
        let generation = group
            .generate(&example(group))
            .expect("a setting of the table");
        let point = group.generators().expect("generators").symbol.point;
        let order = PointGroup::new(point).expect("a point group").order();
        assert_eq!(
            generation.representatives().len(),
            order,
            "{}",
            group.symbol
        );
        let class = PointGroup::from_international(group.point_group).expect(group.point_group);
        assert_eq!(order, class.order(), "{}", group.symbol);
        let all = order * generation.translations().len();
        assert_eq!(generation.operations().len(), all, "{}", group.symbol);
    }
}

/// Operations and versors say the same of points, and belong to each other.
#[test]
fn versors_are_the_operations_in_the_cell() {
    for group in SpaceGroup::table() {
        let cell = example(group);
        let generation = group.generate(&cell).expect("a setting of the table");
        let (operations, versors) = (generation.operations(), generation.versors());
        assert_eq!(operations.len(), versors.len());
        for (operation, versor) in operations.iter().zip(&versors) {
            assert_eq!(versor.operation(&cell), Ok(*operation), "{}", group.symbol);
            let fractions = [0.17, 0.31, 0.77];
            let point = ga_cga::Point::from(ga_cga::Vector3::from(cell.cartesian(fractions)));
            let image = cell.cartesian(operation.apply(fractions));
            let apart = versor.apply(point).position() - ga_cga::Vector3::from(image);
            assert!(apart.norm() < 1e-12, "{} {operation}", group.symbol);
        }
        for generator in generation.generators() {
            let operation = generator.operation(&cell).expect("of the lattice");
            assert!(operations.contains(&operation), "{}", group.symbol);
        }
        assert_eq!(group.versors(&cell), Ok(versors));
    }
}

/// The pairs of *International Tables* A, with the order n and the rise m/n of a screw n_m that
/// the first has and the second has with n − m.
const PAIRS: [(u32, u32, i32, i32); 11] = [
    (76, 78, 4, 1),
    (91, 95, 4, 1),
    (92, 96, 4, 1),
    (144, 145, 3, 1),
    (151, 153, 3, 1),
    (152, 154, 3, 1),
    (169, 170, 6, 1),
    (171, 172, 6, 2),
    (178, 179, 6, 1),
    (180, 181, 6, 2),
    (213, 212, 4, 1),
];

/// By how many n-ths of c the n-fold screws about ±c climb while they turn anticlockwise, seen
/// against the direction in which they climb.
fn climbs(group: &SpaceGroup, order: f64) -> BTreeSet<i32> {
    let cell = example(group);
    let height = cell.edges()[2];
    let versors = group.versors(&cell).expect("versors");
    versors
        .iter()
        .filter_map(|versor| match versor.motion() {
            Motion::Screw {
                axis, angle, rise, ..
            } if (angle - 2.0 * PI / order).abs() < 1e-9 && axis.e3.abs() > 1.0 - 1e-9 => {
                // Turned upside down a screw keeps its hand: the axis tells which way is up.
                let climb = (rise / height * order).round() as i32;
                Some(climb.rem_euclid(order as i32))
            }
            _ => None,
        })
        .collect()
}

#[test]
fn the_eleven_enantiomorphic_pairs_have_the_right_hand() {
    for (right, left, order, rise) in PAIRS {
        let (one, other) = (standard(right), standard(left));
        let expected = BTreeSet::from([rise]);
        assert_eq!(climbs(one, f64::from(order)), expected, "{}", one.symbol);
        let expected = BTreeSet::from([order - rise]);
        assert_eq!(
            climbs(other, f64::from(order)),
            expected,
            "{}",
            other.symbol
        );
        // The mirror image of the one is the other, so both are chiral.
        for group in [one, other] {
            let class = PointGroup::from_international(group.point_group).expect("a class");
            assert!(class.is_chiral());
        }
    }
}

#[test]
fn cells_of_the_wrong_shape_are_refused_by_the_constraint() {
    let oblong = Cell::new([4.1, 4.3, 6.0], [90.0; 3]).expect("a cell");
    let error = standard(76).generate(&oblong).expect_err("not tetragonal");
    assert_eq!(
        error.to_string(),
        "tetragonal needs a = b; here a = 4.1, b = 4.3"
    );
    assert!(matches!(error, GenerationError::Constraint(_)));
    assert!(standard(16).versors(&oblong).is_ok());
    assert!(standard(227).versors(&oblong).is_err());
    let hexagonal = SpaceGroup::from_symbol("R -3 c:R").expect("a setting")[0];
    let cell = Cell::new([4.1, 4.1, 6.0], [90.0, 90.0, 120.0]).expect("a cell");
    let error = hexagonal.versors(&cell).expect_err("other axes");
    assert!(
        error.to_string().starts_with("rhombohedral needs b = c"),
        "{error}"
    );
    // What a measurement leaves is taken out.
    let measured = Cell::new([4.1, 4.1005, 6.0], [90.01, 89.99, 119.98]).expect("a cell");
    let generation = standard(152).generate(&measured).expect("but for rounding");
    assert_eq!(generation.cell().angles(), [90.0, 90.0, 120.0]);
    assert_eq!(generation.operations().len(), 6);
}

#[test]
fn large_and_small_cells_do_as_well() {
    for number in [2, 14, 62, 88, 167, 194, 230] {
        let group = standard(number);
        let expected = sorted(group.operations().expect("operations"));
        for scale in [2e-3, 5.0, 3e5] {
            let example = example(group);
            let edges = example.edges().map(|edge| edge * scale);
            let cell = Cell::new(edges, example.angles()).expect("a cell");
            let generation = group
                .generate(&cell)
                .unwrap_or_else(|e| panic!("{number} {scale}: {e}"));
            assert_eq!(
                sorted(generation.operations()),
                expected,
                "{number} at {scale}"
            );
        }
    }
}

#[test]
fn the_table_is_whole_and_its_expressions_print_as_they_are_read() {
    let table = SpaceGroupGenerators::table();
    assert_eq!(table.len(), 230);
    assert!(table.iter().map(|group| group.number).eq(1..=230));
    assert_eq!(SpaceGroupGenerators::of(0), None);
    for group in table {
        assert_eq!(
            group.generators.iter().map(|g| g.word).collect::<Vec<_>>(),
            group.symbol.point.generators(),
            "{}",
            group.number
        );
        for generator in &group.generators {
            assert_eq!(generator.to_string().parse(), Ok(*generator));
        }
        for direction in group.roots {
            assert_eq!(direction.to_string().parse(), Ok(direction));
        }
        let class = PointGroup::new(group.symbol.point)
            .expect("a point group")
            .crystal_class();
        let symbol = standard(group.number).point_group;
        let international = PointGroup::from_international(symbol)
            .expect(symbol)
            .crystal_class();
        assert_eq!(
            class.map(|c| c.international),
            international.map(|c| c.international),
            "{}",
            group.number
        );
    }
    // Eight groups need a generator off the common point of the roots.
    let moved: Vec<u32> = table
        .iter()
        .filter(|group| group.generators.iter().any(|g| g.moved != [0.into(); 3]))
        .map(|group| group.number)
        .collect();
    assert_eq!(moved, [19, 198, 199, 208, 210, 212, 213, 214]);
}

#[test]
fn wrong_expressions_and_directions_are_refused_where_they_go_wrong() {
    let cases = [
        ("", "a word in the roots"),
        ("x", "unexpected `x` at column 1"),
        ("T", "ends where `_`"),
        ("T_d^{1/2}a", "unexpected `d` at column 3"),
        ("T_c1/2a", "unexpected `1` at column 4"),
        ("T_c^{}a", "digits"),
        ("T_c^{1/0}a", "exponent at column 1"),
        ("T_c^{1/11}a", "exponent at column 1"),
        ("T_c^{99999999999}a", "exponent at column 1"),
        ("T_c^{1/2a", "unexpected `a` at column 9"),
        ("T_c^{1/2}", "ends where a word"),
        ("T_c^{1/2}ba", "`ba` is no word"),
        ("T_c^{1/2}[ab", "ends where `]`"),
        ("ab]", "the generator ends there"),
        ("[T_c^{1/2}[ab]]", "unexpected `[`"),
        ("abcabcabcabcabc", "no word"),
    ];
    for (text, part) in cases {
        let error: ExpressionError = text.parse::<GeneratorExpression>().expect_err(text);
        assert!(error.to_string().contains(part), "`{text}`: {error}");
    }
    for text in [
        "", "[", "[10]", "[1000]", "[000]", "(100)", "[1x0]", "a", "--", "[1-]",
    ] {
        let error = text.parse::<RootDirection>().expect_err(text);
        assert!(
            error.to_string().contains("one such as `[1-10]`"),
            "{error}"
        );
    }
    let spaced: GeneratorExpression = " T_a^{1/4} T_a^{1/4} b c ".parse().expect("blanks");
    assert_eq!(spaced.to_string(), "T_a^{1/2} bc");
    assert_eq!(
        spaced.isometry(
            &[ga_cga::Vector3::default(); 3],
            &[ga_cga::Vector3::default(); 3]
        ),
        None
    );
}

/// The versor of an expression is its word, then the translation, then all of it moved.
#[test]
fn a_translation_of_no_length_makes_no_versor() {
    let roots = ga_design::crystallography::Roots::new(4, 3)
        .expect("4, 3")
        .vectors();
    let edges = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(ga_cga::Vector3::from);
    let mut expression: GeneratorExpression = "T_c^{1/2} ab".parse().expect("a screw");
    assert!(expression.isometry(&roots, &edges).is_some());
    assert_eq!(
        expression.isometry(&roots, &edges.map(|edge| edge * f64::NAN)),
        None
    );
    expression.moved[0] = num_rational::Ratio::new_raw(1, 0);
    assert_eq!(expression.isometry(&roots, &edges), None);
}

#[test]
fn expressions_are_versors() {
    let axis = |x: f64, y: f64, z: f64| ga_cga::Vector3::new(x, y, z);
    let roots = [
        axis(1.0, 0.0, 0.0),
        axis(0.0, 1.0, 0.0),
        axis(0.0, 0.0, 1.0),
    ];
    let edges = roots.map(|root| root * 4.0);
    let screw: GeneratorExpression = "T_b^{-1/4}[T_a^{1/2}bc]".parse().expect("a generator");
    let versor = screw.isometry(&roots, &edges).expect("roots");
    let Motion::Screw {
        through,
        axis,
        rise,
        ..
    } = versor.motion()
    else {
        panic!("a screw")
    };
    assert!((rise.abs() - 2.0).abs() < 1e-12 && axis.e1.abs() > 1.0 - 1e-12);
    assert!(through.distance(ga_cga::Point::at(0.0, -1.0, 0.0)) < 1e-12);
    assert!(
        versor
            .after(&versor.inverse())
            .is_same(&Isometry::identity(), 1e-12)
    );
}
