//! Whether the 7 frieze, 17 plane, 75 rod and 80 layer groups are complete, different, groups,
//! tied to their space groups, and the same as in the program moyo.

use std::collections::{BTreeSet, HashMap, HashSet};

use ga_design::crystallography::{
    ChangeOfBasis, CrystalSystem, Operation, SpaceGroup, SubperiodicGroup, SubperiodicKind,
    SubperiodicLattice, SubperiodicOperation, SubperiodicOperationError,
};
use moyo::data::{
    LayerHallSymbol, LayerSetting, layer_hall_symbol_entry, operations_from_layer_number,
};

fn operations(group: &SubperiodicGroup) -> Vec<SubperiodicOperation> {
    group
        .operations()
        .unwrap_or_else(|e| panic!("{} {}: {e}", group.kind, group.symbol))
}

fn in_space(group: &SubperiodicGroup) -> Vec<Operation> {
    operations(group)
        .iter()
        .map(SubperiodicOperation::in_space)
        .collect()
}

#[test]
fn there_are_7_17_75_and_80_and_no_two_are_the_same() {
    for (kind, count) in SubperiodicKind::ALL.into_iter().zip([7, 17, 75, 80]) {
        assert_eq!(kind.count(), count);
        let mut seen = HashSet::new();
        for number in 1..=count {
            let group = SubperiodicGroup::standard(kind, number)
                .unwrap_or_else(|| panic!("no {kind} group {number}"));
            let mut all = operations(group);
            all.sort_unstable();
            assert!(seen.insert(all), "{kind} {number} is there twice");
            let settings = SubperiodicGroup::settings(kind, number);
            assert_eq!(settings[0], group);
            assert_eq!(
                settings.iter().filter(|setting| setting.standard).count(),
                1
            );
        }
        assert_eq!(SubperiodicGroup::standard(kind, 0), None);
        assert_eq!(SubperiodicGroup::standard(kind, count + 1), None);
    }
}

#[test]
fn every_setting_is_a_group_that_leaves_its_line_or_layer_in_place() {
    for group in SubperiodicGroup::table() {
        let all = operations(group);
        let set: HashSet<_> = all.iter().copied().collect();
        assert_eq!(set.len(), all.len(), "{}", group.symbol);
        for one in &all {
            assert!(set.contains(&one.inverse().expect("small numbers")));
            for (along, part) in group.kind.periodic().into_iter().zip(one.translation()) {
                assert!(along || *part.numer() == 0, "{}", group.symbol);
            }
            for other in &all {
                assert!(set.contains(&one.then(other).expect("small numbers")));
            }
        }
        // The order is that of the point group, times two when centred.
        let translations = all.iter().filter(|o| o.in_space().is_translation()).count();
        let centred = usize::from(group.symbol.starts_with('c')) + 1;
        assert_eq!(translations, centred, "{}", group.symbol);
    }
}

#[test]
fn the_generators_of_the_space_group_generate_it() {
    for group in SubperiodicGroup::table() {
        let name = group.qualified_symbol();
        let found = group.space_group().unwrap_or_else(|| panic!("{name}"));
        let standard = SpaceGroup::standard(found.number).expect("a number");
        let carried = found
            .from_standard
            .operations(&standard.operations().expect("a Hall symbol"))
            .expect("the same group");
        let ours: HashSet<_> = in_space(group).into_iter().collect();
        assert_eq!(carried.into_iter().collect::<HashSet<_>>(), ours, "{name}");
    }
}

#[test]
fn settings_of_one_number_differ_by_a_change_of_basis_that_keeps_the_kind() {
    let planar = [
        "x,y",
        "-y,x",
        "x+y,-x+2y",
        "x-y,x",
        "x+y,y",
        "x,x+y",
        "-y,x-y",
        "x-y,x+y",
    ];
    for group in SubperiodicGroup::table()
        .iter()
        .filter(|group| !group.standard)
    {
        let standard = SubperiodicGroup::standard(group.kind, group.number).expect("a number");
        let ours: HashSet<_> = in_space(group).into_iter().collect();
        let quarters = ["", "+1/4", "+1/2", "+3/4"];
        let found = planar.iter().any(|exchange| {
            quarters.iter().any(|u| {
                quarters.iter().any(|v| {
                    let (x, y) = exchange.split_once(',').expect("two");
                    let (ends, across) = match group.kind {
                        SubperiodicKind::Rod => (["", ""], *v),
                        _ => ([*u, *v], ""),
                    };
                    let text = format!("{x}{},{y}{},z{across}", ends[0], ends[1]);
                    let change: ChangeOfBasis = text.parse().expect("a change");
                    let carried: Option<HashSet<_>> = in_space(standard)
                        .iter()
                        .map(|o| change.operation(o))
                        .collect();
                    carried.as_ref() == Some(&ours)
                })
            })
        });
        assert!(found, "{} {}", group.kind, group.qualified_symbol());
    }
}

type Key = ([[i32; 3]; 3], [i64; 3]);

fn keys(operations: impl Iterator<Item = ([[i32; 3]; 3], [f64; 3])>) -> BTreeSet<Key> {
    operations
        .map(|(w, t)| {
            (
                w,
                t.map(|value| ((value * 24.0).round() as i64).rem_euclid(24)),
            )
        })
        .collect()
}

#[test]
fn layer_groups_are_those_of_moyo_in_all_its_116_settings() {
    for hall_number in 1..=116 {
        let entry = layer_hall_symbol_entry(hall_number).expect("116 entries");
        let theirs = operations_from_layer_number(
            entry.number,
            LayerSetting::HallNumber(hall_number),
            false,
        )
        .expect("operations of moyo");
        let theirs = keys(
            theirs
                .iter()
                .map(|o| (o.rotation_as_array(), o.translation_as_array())),
        );
        let symbol = entry.hm_short.replace('_', "");
        let choice = match entry.setting {
            "1" | "2" => format!("{symbol}:{}", entry.setting),
            _ => symbol.clone(),
        };
        let found = SubperiodicGroup::from_symbol(SubperiodicKind::Layer, &choice)
            .unwrap_or_else(|e| panic!("{e}"));
        let group = found[0];
        assert_eq!(
            (group.number, group.symbol),
            (entry.number as u32, symbol.as_str())
        );
        let ours = keys(
            in_space(group)
                .iter()
                .map(|o| (o.rotation(), o.translation_f64())),
        );
        assert_eq!(ours, theirs, "{symbol}");
        assert!(LayerHallSymbol::from_hall_number(hall_number).is_some());
        let full = SubperiodicGroup::from_symbol(SubperiodicKind::Layer, entry.hm_full);
        if let Ok(full) = full {
            assert!(
                full.iter().any(|other| other.number == group.number),
                "{symbol}"
            );
        }
    }
}

#[test]
fn plane_groups_are_the_layer_groups_without_turning_over() {
    // ITE, table 1.2.7.1: the layer groups that keep the two sides.
    let layers = [
        1, 3, 11, 12, 13, 23, 24, 25, 26, 49, 55, 56, 65, 69, 70, 73, 77,
    ];
    for (number, layer) in (1..=17).zip(layers) {
        let plane = SubperiodicGroup::standard(SubperiodicKind::Plane, number).expect("a number");
        let layer = SubperiodicGroup::standard(SubperiodicKind::Layer, layer).expect("a number");
        let ours: HashSet<_> = in_space(plane).into_iter().collect();
        let theirs: HashSet<_> = in_space(layer).into_iter().collect();
        assert_eq!(ours, theirs, "{} and {}", plane.symbol, layer.symbol);
        assert_eq!(plane.lattice(), layer.lattice(), "{}", plane.symbol);
    }
}

#[test]
fn plane_groups_have_the_orders_lattices_and_point_groups_of_international_tables() {
    use SubperiodicLattice::{CentredRectangular, Hexagonal, Oblique, Rectangular, Square};
    // ITA, table 2.1.1.1 and the general positions of the plane groups.
    let table = [
        ("p 1", 1, "1", Oblique),
        ("p 2", 2, "2", Oblique),
        ("p m", 2, "m", Rectangular),
        ("p g", 2, "m", Rectangular),
        ("c m", 4, "m", CentredRectangular),
        ("p 2 m m", 4, "2mm", Rectangular),
        ("p 2 m g", 4, "2mm", Rectangular),
        ("p 2 g g", 4, "2mm", Rectangular),
        ("c 2 m m", 8, "2mm", CentredRectangular),
        ("p 4", 4, "4", Square),
        ("p 4 m m", 8, "4mm", Square),
        ("p 4 g m", 8, "4mm", Square),
        ("p 3", 3, "3", Hexagonal),
        ("p 3 m 1", 6, "3m", Hexagonal),
        ("p 3 1 m", 6, "3m", Hexagonal),
        ("p 6", 6, "6", Hexagonal),
        ("p 6 m m", 12, "6mm", Hexagonal),
    ];
    for (number, (symbol, order, point_group, lattice)) in (1..).zip(table) {
        let group = SubperiodicGroup::standard(SubperiodicKind::Plane, number).expect("a number");
        assert_eq!(group.symbol, symbol);
        assert_eq!(operations(group).len(), order, "{symbol}");
        assert_eq!(group.point_group(), Some(point_group), "{symbol}");
        assert_eq!(group.lattice(), lattice, "{symbol}");
    }
}

#[test]
fn the_operations_of_chosen_groups_are_those_of_the_printed_tables() {
    let cases: [(SubperiodicKind, u32, &[&str]); 7] = [
        (SubperiodicKind::Frieze, 5, &["x,y", "x+1/2,-y"]),
        (
            SubperiodicKind::Frieze,
            7,
            &["x,y", "-x,-y", "-x+1/2,y", "x+1/2,-y"],
        ),
        (SubperiodicKind::Plane, 4, &["x,y", "-x,y+1/2"]),
        (
            SubperiodicKind::Plane,
            8,
            &["x,y", "-x,-y", "-x+1/2,y+1/2", "x+1/2,-y+1/2"],
        ),
        (
            SubperiodicKind::Rod,
            24,
            &["x,y,z", "-y,x,z+1/4", "-x,-y,z+1/2", "y,-x,z+3/4"],
        ),
        (
            SubperiodicKind::Rod,
            17,
            &["x,y,z", "-x,-y,z+1/2", "-x,y,z", "x,-y,z+1/2"],
        ),
        (
            SubperiodicKind::Layer,
            21,
            &["x,y,z", "-x,-y,z", "x+1/2,-y+1/2,-z", "-x+1/2,y+1/2,-z"],
        ),
    ];
    for (kind, number, wanted) in cases {
        let group = SubperiodicGroup::standard(kind, number).expect("a number");
        let ours: BTreeSet<String> = operations(group).iter().map(|o| o.to_string()).collect();
        let wanted: BTreeSet<String> = wanted.iter().map(|text| (*text).to_owned()).collect();
        assert_eq!(ours, wanted, "{kind} {number}");
    }
}

#[test]
fn rod_groups_have_the_space_groups_and_orders_of_their_symbols() {
    // The rod group's symbol is that of a space group without the lattice letter.
    for group in SubperiodicGroup::table()
        .iter()
        .filter(|g| g.kind == SubperiodicKind::Rod)
    {
        let symbol = group.symbol.replacen('p', "P", 1);
        let space = SpaceGroup::from_symbol(&symbol).unwrap_or_else(|e| panic!("{e}"))[0];
        let found = group.space_group().expect("a space group");
        assert_eq!(found.number, space.number, "{symbol}");
        assert_eq!(group.point_group(), Some(space.point_group), "{symbol}");
        let order = space.operations().expect("a Hall symbol").len();
        assert_eq!(operations(group).len(), order, "{symbol}");
        assert_eq!(group.lattice(), SubperiodicLattice::Line);
    }
}

#[test]
fn systems_and_lattices_count_as_in_international_tables() {
    let count = |kind: SubperiodicKind, system: CrystalSystem| {
        (1..=kind.count())
            .filter_map(|number| SubperiodicGroup::standard(kind, number))
            .filter(|group| group.crystal_system() == system)
            .count()
    };
    use CrystalSystem::{
        Cubic, Hexagonal, Monoclinic, Orthorhombic, Tetragonal, Triclinic, Trigonal,
    };
    let systems = [
        Triclinic,
        Monoclinic,
        Orthorhombic,
        Tetragonal,
        Trigonal,
        Hexagonal,
        Cubic,
    ];
    let layers = systems.map(|system| count(SubperiodicKind::Layer, system));
    assert_eq!(layers, [2, 16, 30, 16, 8, 8, 0]);
    let rods = systems.map(|system| count(SubperiodicKind::Rod, system));
    assert_eq!(rods, [2, 10, 10, 19, 11, 23, 0]);
    let mut lattices: HashMap<SubperiodicLattice, usize> = HashMap::new();
    for number in 1..=80 {
        let group = SubperiodicGroup::standard(SubperiodicKind::Layer, number).expect("a number");
        *lattices.entry(group.lattice()).or_default() += 1;
    }
    let centred = lattices.get(&SubperiodicLattice::CentredRectangular);
    assert_eq!(centred, Some(&9), "{lattices:?}");
    assert_eq!(lattices.get(&SubperiodicLattice::Oblique), Some(&7));
    for (kind, rank, dimension) in [
        (SubperiodicKind::Frieze, 1, 2),
        (SubperiodicKind::Plane, 2, 2),
        (SubperiodicKind::Rod, 1, 3),
        (SubperiodicKind::Layer, 2, 3),
    ] {
        assert_eq!((kind.rank(), kind.dimension()), (rank, dimension));
    }
}

#[test]
fn symbols_parse_back_and_others_get_a_suggestion() {
    for group in SubperiodicGroup::table() {
        for symbol in [
            group.qualified_symbol(),
            group.symbol.replace(' ', ""),
            group.symbol.to_uppercase(),
            group.full_symbol().to_owned(),
        ] {
            let found = SubperiodicGroup::from_symbol(group.kind, &symbol)
                .unwrap_or_else(|e| panic!("{e}"));
            assert!(found.contains(&group), "{symbol}");
            assert!(
                found.iter().all(|other| other.number == group.number),
                "{symbol}"
            );
        }
        let number = group.number.to_string();
        let found = SubperiodicGroup::from_symbol(group.kind, &number).expect("a number");
        assert_eq!((found[0].number, found[0].standard), (group.number, true));
    }
    let plane = |text: &str| SubperiodicGroup::from_symbol(SubperiodicKind::Plane, text);
    for (symbol, number) in [
        ("p4g", 12),
        ("cmm", 9),
        ("p31m", 15),
        ("*632", 17),
        ("442", 10),
    ] {
        let found = plane(symbol).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(found[0].number, number, "{symbol}");
    }
    let error = plane("p4gn").expect_err("no such group");
    assert!(
        error.suggestions.contains(&String::from("p 4 g m")),
        "{error}"
    );
    for wrong in [
        "",
        "18",
        "0",
        "-1",
        "q 7 zz zz",
        "p 4/n:3",
        "p 2 m g:2",
        "Fd-3m",
    ] {
        let error = plane(wrong).expect_err("no such group");
        assert!(error.to_string().contains("plane group"), "{error}");
    }
    let nothing = plane("q 7 zz zz").expect_err("no such group");
    assert!(nothing.to_string().contains("from 1 to 17"), "{nothing}");
    let long = "p".repeat(10_000);
    assert!(plane(&long).expect_err("too long").symbol.len() <= 60);
}

#[test]
fn what_leaves_the_line_or_layer_is_refused() {
    let read = |text: &str| -> Operation { text.parse().expect("an operation") };
    let refused = [
        (SubperiodicKind::Layer, "-x,-y,z+1/2"),
        (SubperiodicKind::Layer, "-x,-y,-z+1/2"),
        (SubperiodicKind::Rod, "-x,-y+1/2,z"),
        (SubperiodicKind::Frieze, "-x,y+1/2,z"),
        (SubperiodicKind::Plane, "x,y,z+1/3"),
    ];
    for (kind, text) in refused {
        let error = SubperiodicOperation::new(kind, read(text)).expect_err(text);
        assert!(
            matches!(error, SubperiodicOperationError::Across { .. }),
            "{text}: {error}"
        );
    }
    let turned = [
        (SubperiodicKind::Layer, "z,x,y"),
        (SubperiodicKind::Rod, "x,z,-y"),
        (SubperiodicKind::Frieze, "-y,x,z"),
        (SubperiodicKind::Plane, "x,y,-z"),
        (SubperiodicKind::Layer, "x,y,x+z"),
    ];
    for (kind, text) in turned {
        let error = SubperiodicOperation::new(kind, read(text)).expect_err(text);
        assert!(
            matches!(error, SubperiodicOperationError::Turns { .. }),
            "{text}: {error}"
        );
    }
    let rod = SubperiodicOperation::new(SubperiodicKind::Rod, Operation::IDENTITY);
    let layer = SubperiodicOperation::new(SubperiodicKind::Layer, Operation::IDENTITY);
    assert_eq!(rod.expect("a rod").then(&layer.expect("a layer")), None);
}
