//! Point groups against character tables, and the laws of groups.

use std::collections::BTreeMap;

use ga_cga::{Circle, DirectionVector, Line, Motor, Plane, Point, PointPair, Sphere, Vector3};
use ga_design::crystallography::{
    CrystalClass, CrystalSystem, Isometry, Movable, PointGroup, Word,
};

/// The sizes of the conjugacy classes, from the character tables (for example
/// J. A. Salthouse and M. J. Ware, *Point Group Character Tables*, Cambridge 1972).
const CLASS_SIZES: [(&str, &[usize]); 32] = [
    ("C1", &[1]),
    ("Ci", &[1; 2]),
    ("C2", &[1; 2]),
    ("Cs", &[1; 2]),
    ("C2h", &[1; 4]),
    ("D2", &[1; 4]),
    ("C2v", &[1; 4]),
    ("D2h", &[1; 8]),
    ("C4", &[1; 4]),
    ("S4", &[1; 4]),
    ("C4h", &[1; 8]),
    ("D4", &[1, 1, 2, 2, 2]),
    ("C4v", &[1, 1, 2, 2, 2]),
    ("D2d", &[1, 1, 2, 2, 2]),
    ("D4h", &[1, 1, 1, 1, 2, 2, 2, 2, 2, 2]),
    ("C3", &[1; 3]),
    ("C3i", &[1; 6]),
    ("D3", &[1, 2, 3]),
    ("C3v", &[1, 2, 3]),
    ("D3d", &[1, 1, 2, 2, 3, 3]),
    ("C6", &[1; 6]),
    ("C3h", &[1; 6]),
    ("C6h", &[1; 12]),
    ("D6", &[1, 1, 2, 2, 3, 3]),
    ("C6v", &[1, 1, 2, 2, 3, 3]),
    ("D3h", &[1, 1, 2, 2, 3, 3]),
    ("D6h", &[1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]),
    ("T", &[1, 3, 4, 4]),
    ("Th", &[1, 1, 3, 3, 4, 4, 4, 4]),
    ("O", &[1, 3, 6, 6, 8]),
    ("Td", &[1, 3, 6, 6, 8]),
    ("Oh", &[1, 1, 3, 3, 6, 6, 6, 6, 8, 8]),
];

fn class_sizes(group: &PointGroup) -> Vec<usize> {
    let mut sizes: Vec<usize> = group.conjugacy_classes().iter().map(Vec::len).collect();
    sizes.sort_unstable();
    sizes
}

#[test]
fn the_32_groups_have_the_orders_and_classes_of_the_character_tables() {
    assert_eq!(CrystalClass::table().len(), 32);
    for (schoenflies, sizes) in CLASS_SIZES {
        let group = PointGroup::from_schoenflies(schoenflies).expect("a crystal class");
        assert_eq!(group.order(), sizes.iter().sum::<usize>(), "{schoenflies}");
        assert_eq!(class_sizes(&group), sizes, "{schoenflies}");
    }
}

#[test]
fn groups_that_no_crystal_has_are_right_too() {
    let icosahedral: &[usize] = &[1, 12, 12, 15, 20];
    let with_inversion: &[usize] = &[1, 1, 12, 12, 12, 12, 15, 15, 20, 20];
    let cases: [(&str, &[usize]); 10] = [
        ("b(5)b(3)", icosahedral),
        ("b(3)b(5)", icosahedral),
        ("53", with_inversion),
        ("35", with_inversion),
        ("5", &[1, 2, 2, 5]),
        ("b(5)b(2)", &[1, 2, 2, 5]),
        ("b(7)", &[1; 7]),
        ("7", &[1, 2, 2, 2, 7]),
        ("82", &[1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 4, 4, 4, 4]),
        ("b((10)2)", &[1; 10]),
    ];
    for (symbol, sizes) in cases {
        let group = PointGroup::from_geometric(symbol).expect("a point group");
        assert_eq!(group.order(), sizes.iter().sum::<usize>(), "{symbol}");
        assert_eq!(class_sizes(&group), sizes, "{symbol}");
        assert!(group.crystal_class().is_none(), "{symbol}");
    }
    let orders: BTreeMap<usize, usize> = {
        let group = PointGroup::from_geometric("b(5)b(3)").expect("icosahedral");
        (0..60)
            .filter_map(|n| group.order_of(n))
            .fold(BTreeMap::new(), |mut all, order| {
                *all.entry(order).or_default() += 1;
                all
            })
    };
    assert_eq!(orders, BTreeMap::from([(1, 1), (2, 15), (3, 20), (5, 24)]));
    // A dihedral group of a thousandfold axis: the finest that is accepted.
    let finest = PointGroup::from_geometric("b((1000))b(2)").expect("a dihedral group");
    assert_eq!(finest.order(), 2000);
}

#[test]
fn products_and_inverses_stay_in_the_group() {
    let extra = ["53", "7", "82", "12", "b(12)"];
    let geometric = CrystalClass::table().iter().map(|class| class.geometric);
    for symbol in geometric.chain(extra) {
        let group = PointGroup::from_geometric(symbol).expect("a point group");
        assert_eq!(group.transformations()[0], Isometry::identity());
        for one in 0..group.order() {
            let inverse = group.inverse(one).expect("its inverse");
            assert_eq!(group.product(one, inverse), Some(0), "{symbol}");
            assert_eq!(group.order_of(one), group.order_of(inverse));
            let order = group.order_of(one).expect("an order");
            assert_eq!(group.order() % order, 0, "{symbol}: Lagrange");
            // Rows of the multiplication table are permutations.
            let mut row: Vec<usize> = (0..group.order())
                .map(|other| group.product(one, other).expect("closed"))
                .collect();
            row.sort_unstable();
            assert!(row.iter().copied().eq(0..group.order()), "{symbol}");
        }
        assert_eq!(group.product(0, group.order()), None);
        assert_eq!(group.inverse(group.order()), None);
        assert_eq!(group.order_of(group.order()), None);
    }
    let tetrahedral = PointGroup::from_schoenflies("T").expect("T");
    assert_eq!(tetrahedral.position(&Isometry::inversion()), None);
    let step = Isometry::translation(Vector3::new(1.0, 0.0, 0.0));
    assert_eq!(tetrahedral.position(&step), None);
}

#[test]
fn the_sequence_makes_the_absolute_transformations() {
    for symbol in ["1", "b(22)", "22", "b(4)2", "33", "b(5)b(3)"] {
        let group = PointGroup::from_geometric(symbol).expect("a point group");
        assert_eq!(group.sequence().len() + 1, group.order());
        for (number, step) in group.sequence().iter().enumerate() {
            let (kind, index, input) = step.encoding();
            assert_eq!(
                (Word::from_encoding(kind, index), input),
                (Some(step.word), step.input)
            );
            assert!(
                step.input <= number,
                "{symbol}: only earlier results are used"
            );
            assert!(
                group
                    .generators()
                    .iter()
                    .any(|(word, _)| *word == step.word)
            );
        }
        let point = Point::at(0.3, -1.2, 0.7);
        let (all, made) = (group.apply(point), group.apply_sequence(point));
        assert_eq!(all.len(), made.len());
        for (one, other) in all.iter().zip(&made) {
            assert!(one.distance(*other) < 1e-13, "{symbol}");
        }
    }
}

#[test]
fn the_groups_of_p_and_q_2_are_those_of_table_3_3() {
    // 22, 2̄2, 2̄2̄ and one bar over both: {1, a, b, c, ab, ac, bc, abc} and its subgroups.
    let [a, b, c] = PointGroup::from_geometric("22")
        .expect("22")
        .roots()
        .vectors();
    let word = |word: Word| word.isometry(&[a, b, c]).expect("roots");
    let ac = word(Word::Ca).inverse();
    let expected = [
        (
            "22",
            vec![Word::A, Word::B, Word::C, Word::Ab, Word::Bc, Word::Abc],
        ),
        ("b(2)2", vec![Word::Ab, Word::C, Word::Abc]),
        ("b(2)b(2)", vec![Word::Ab, Word::Bc]),
        ("b(22)", vec![Word::Abc]),
    ];
    for (symbol, words) in expected {
        let group = PointGroup::from_geometric(symbol).expect("a point group");
        for isometry in words.iter().copied().map(word) {
            assert!(group.position(&isometry).is_some(), "{symbol}");
        }
        let with_ac = matches!(symbol, "22" | "b(2)b(2)");
        assert_eq!(group.position(&ac).is_some(), with_ac, "{symbol}");
        assert_eq!(group.order(), words.len() + 1 + usize::from(with_ac));
    }
}

#[test]
fn a_motif_in_general_position_has_as_many_images_as_the_order_and_fewer_in_special_ones() {
    // Figure 3.8: 12 copies, and 6 on the axes of order two.
    let group = PointGroup::from_geometric("b(3)b(3)").expect("23");
    let count = |point: Point| {
        let mut distinct: Vec<Point> = Vec::new();
        for image in group.apply(point) {
            if distinct.iter().all(|known| known.distance(image) > 1e-9) {
                distinct.push(image);
            }
        }
        distinct.len()
    };
    assert_eq!(count(Point::at(0.3, 0.5, 0.9)), 12);
    let axis = (0..12)
        .filter(|n| group.order_of(*n) == Some(2))
        .find_map(|n| group.transformations()[n].motor.rotation()?.plane())
        .expect("a half turn");
    let normal: Vector3 = axis * ga_cga::Trivector3::new(-1.0);
    assert_eq!(count(Point::from(normal)), 6);
    assert_eq!(count(Point::at(0.0, 0.0, 0.0)), 1);
}

/// Whatever the element, moving it and moving back is nothing, and movements follow each other.
fn acts<X: Movable + std::fmt::Debug + ga_core::ops::Element<Number = f64>>(element: X) {
    let group = PointGroup::from_geometric("4b(3)").expect("m-3");
    for one in 0..group.order() {
        let first = group.transformations()[one];
        let image = first.apply(element);
        let back = first.inverse().apply(image);
        let off = (0..X::BLADES.len()).map(|at| (back.at(at) - element.at(at)).abs());
        assert!(
            off.fold(0.0, f64::max) < 1e-12,
            "{element:?} ends as {back:?}"
        );
        let then = group.transformations()[(7 * one + 3) % group.order()];
        let (both, in_turn) = (then.after(&first).apply(element), then.apply(image));
        let off = (0..X::BLADES.len()).map(|at| (both.at(at) - in_turn.at(at)).abs());
        assert!(
            off.fold(0.0, f64::max) < 1e-12,
            "{both:?} against {in_turn:?}"
        );
    }
}

#[test]
fn every_element_of_the_algebra_is_moved() {
    let [a, b, c, d] = [
        [1.0, 0.2, 0.0],
        [0.0, 1.0, 0.4],
        [0.3, -0.5, 2.0],
        [-1.0, 0.1, 0.6],
    ]
    .map(|[x, y, z]| Point::at(x, y, z));
    let infinity = ga_cga::DualSphere::infinity();
    let pair: PointPair = a ^ b;
    let circle: Circle = a ^ b ^ c;
    let sphere: Sphere = a ^ b ^ c ^ d;
    let line: Line = (a ^ b ^ infinity).narrow(1e-9).expect("a line");
    let plane: Plane = (a ^ b ^ c ^ infinity).narrow(1e-9).expect("a plane");
    let motor = Motor::about_direct_line(line, 0.7).expect("a line");
    acts(a);
    acts(pair);
    acts(circle);
    acts(sphere);
    acts(line);
    acts(plane);
    acts(motor);
    acts(line.dual());
    acts(plane.dual());
    acts(ga_cga::DualSphere::from(a));
    acts(DirectionVector::along(Vector3::new(1.0, 2.0, 3.0)));
    acts(ga_cga::Even::from(motor));
}

#[test]
fn symbols_in_three_notations_name_the_same_group() {
    for class in CrystalClass::table() {
        let one = PointGroup::from_international(class.international).expect("International");
        assert_eq!(
            PointGroup::from_schoenflies(class.schoenflies),
            Ok(one.clone())
        );
        assert_eq!(PointGroup::from_geometric(class.geometric), Ok(one.clone()));
        assert_eq!(
            one.crystal_class().map(|c| c.schoenflies),
            Some(class.schoenflies)
        );
        let laue = CrystalClass::from_international(class.laue)
            .expect("a Laue class")
            .group();
        assert!(laue.is_centrosymmetric());
        let doubled = if one.is_centrosymmetric() { 1 } else { 2 };
        assert_eq!(
            laue.order(),
            one.order() * doubled,
            "{}",
            class.international
        );
        assert!(one.transformations().iter().all(|t| {
            // The Laue group in the same axes: every element with and without the inversion.
            laue.position(t).is_some() || one.symbol().roots() != laue.symbol().roots()
        }));
    }
    let cases = [
        ("-4 m 2", "-42m"),
        ("4/m 2/m 2/m", "4/mmm"),
        ("m3m", "m-3m"),
        ("M-3M", "m-3m"),
        ("3 2 1", "32"),
        ("-3 2/m", "-3m"),
        ("-62m", "-6m2"),
        ("2_/_m", "2/m"),
        ("\u{2212}1", "-1"),
    ];
    for (spelling, international) in cases {
        let class = CrystalClass::from_international(spelling).expect(spelling);
        assert_eq!(class.international, international);
    }
    for (spelling, schoenflies) in [
        ("O_h", "Oh"),
        ("D_{2d}", "D2d"),
        ("S6", "C3i"),
        ("Vh", "D2h"),
    ] {
        let class = CrystalClass::from_schoenflies(spelling).expect(spelling);
        assert_eq!(class.schoenflies, schoenflies);
    }
    // One text in two notations is two groups.
    assert_eq!(PointGroup::from_geometric("32").map(|g| g.order()), Ok(12));
    assert_eq!(
        PointGroup::from_international("32").map(|g| g.order()),
        Ok(6)
    );
}

#[test]
fn the_crystal_class_of_an_unusual_symbol_is_found() {
    for (symbol, international) in [
        ("34", "m-3m"),
        ("b(2)1", "mm2"),
        ("12", "mm2"),
        ("b(12)", "m"),
        ("26", "6/mmm"),
    ] {
        let group = PointGroup::from_geometric(symbol).expect("a point group");
        let class = group.crystal_class().expect("a crystal class");
        assert_eq!(class.international, international, "{symbol}");
    }
}

#[test]
fn hand_and_centre_are_as_in_the_tables() {
    let chiral = [
        "1", "2", "222", "3", "32", "4", "422", "6", "622", "23", "432",
    ];
    let centred = [
        "-1", "2/m", "mmm", "4/m", "4/mmm", "-3", "-3m", "6/m", "6/mmm", "m-3", "m-3m",
    ];
    let mut systems = BTreeMap::new();
    for class in CrystalClass::table() {
        let (name, group) = (class.international, class.group());
        assert_eq!(group.is_chiral(), chiral.contains(&name), "{name}");
        assert_eq!(
            group.is_centrosymmetric(),
            centred.contains(&name),
            "{name}"
        );
        assert_eq!(group.is_centrosymmetric(), class.laue == name, "{name}");
        *systems.entry(class.system).or_insert(0) += 1;
    }
    let counts: Vec<i32> = CrystalSystem::ALL.iter().map(|s| systems[s]).collect();
    assert_eq!(counts, [2, 3, 3, 7, 5, 7, 5]);
}

#[test]
fn unknown_names_get_suggestions() {
    let error = PointGroup::from_international("4/mmn").expect_err("no such group");
    assert!(
        error.to_string().contains("did you mean `4/mmm`"),
        "{error}"
    );
    let error = PointGroup::from_schoenflies("D9h").expect_err("no crystal has it");
    assert!(
        error.suggestions.iter().any(|name| name.starts_with('D')),
        "{error}"
    );
    for text in ["", " ", "\u{0}", &"m".repeat(100_000)] {
        assert!(PointGroup::from_international(text).is_err());
        assert!(PointGroup::from_schoenflies(text).is_err());
        assert!(PointGroup::from_geometric(text).is_err());
    }
    let error = "cubical".parse::<CrystalSystem>().expect_err("no system");
    assert!(error.to_string().contains("one of triclinic"), "{error}");
    assert_eq!(" Cubic ".parse(), Ok(CrystalSystem::Cubic));
}
