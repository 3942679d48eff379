//! What is refused, and in which words.

use ga_cga::Point;
use ga_design::crystallography::{Isometry, PointGroup};
use ga_design::tensegrity::{
    Analysis, GeneratingMember, MOST_MEMBERS, MOST_NODES, MOST_PRISM_STRUTS, Member, Octahedron,
    Polyhedron, Prism, Role, Solid, Structure, TensegrityError, Tower, generate,
};

/// Numbers that are no length.
const NO_LENGTHS: [f64; 7] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -1.0,
    1e300,
    1e-300,
];

#[test]
fn fewer_than_three_struts_are_refused() {
    for struts in [0, 1, 2] {
        let few = TensegrityError::FewStruts { value: struts };
        assert_eq!(
            Prism {
                struts,
                ..Prism::default()
            }
            .structure(),
            Err(few)
        );
        assert_eq!(
            Tower {
                struts,
                ..Tower::default()
            }
            .structure(),
            Err(few)
        );
        assert!(few.to_string().contains("at least 3"));
    }
    for stages in [0, 1] {
        let few = Err(TensegrityError::FewStages { value: stages });
        assert_eq!(
            Tower {
                stages,
                ..Tower::default()
            }
            .structure(),
            few
        );
    }
}

#[test]
fn too_many_of_anything_are_refused_before_they_are_made() {
    for struts in [MOST_PRISM_STRUTS + 1, 100_000, usize::MAX] {
        let prism = Prism {
            struts,
            ..Prism::default()
        }
        .structure();
        assert!(
            matches!(prism, Err(TensegrityError::TooMany { .. })),
            "{struts}"
        );
        let tower = Tower {
            struts,
            ..Tower::default()
        }
        .structure();
        assert!(
            matches!(tower, Err(TensegrityError::TooMany { .. })),
            "{struts}"
        );
    }
    for stages in [MOST_NODES / 6 + 1, 1_000_000, usize::MAX] {
        let tower = Tower {
            stages,
            ..Tower::default()
        }
        .structure();
        assert!(
            matches!(tower, Err(TensegrityError::TooMany { .. })),
            "{stages}"
        );
    }
    // A list of transformations that is no finite group.
    let steps = (0..10_000).map(|step| {
        let vector = ga_cga::Vector3::new(f64::from(step), 0.0, 0.0);
        Isometry::translation(vector)
    });
    let strut = GeneratingMember::strut(Point::at(0.0, 0.0, 0.0), Point::at(0.0, 0.0, 1.0));
    let endless = generate(&steps.collect::<Vec<_>>(), &[strut]);
    assert!(matches!(endless, Err(TensegrityError::TooMany { .. })));
}

#[test]
fn what_is_no_length_is_refused_everywhere() {
    for value in NO_LENGTHS {
        let refused = [
            Prism {
                radius: value,
                ..Prism::default()
            }
            .structure(),
            Prism {
                height: value,
                ..Prism::default()
            }
            .structure(),
            Tower {
                radius: value,
                ..Tower::default()
            }
            .structure(),
            Tower {
                height: value,
                ..Tower::default()
            }
            .structure(),
            Octahedron {
                strut: value,
                ..Octahedron::default()
            }
            .structure(),
            Polyhedron {
                strut: value,
                ..Polyhedron::of(Solid::TruncatedCube)
            }
            .structure(),
            Polyhedron {
                cable_ratio: value,
                ..Polyhedron::of(Solid::TruncatedCube)
            }
            .structure(),
        ];
        for result in refused {
            let error = result.expect_err("no structure");
            assert!(
                matches!(error, TensegrityError::Number { .. }),
                "{value} {error}"
            );
            assert!(error.to_string().contains("1e-12 to 1e12"), "{error}");
        }
    }
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let twist = Some(value);
        let prism = Prism {
            twist,
            ..Prism::default()
        }
        .structure();
        assert!(matches!(prism, Err(TensegrityError::Number { .. })));
        let tower = Tower {
            twist,
            ..Tower::default()
        }
        .structure();
        assert!(matches!(tower, Err(TensegrityError::Number { .. })));
    }
}

#[test]
fn ratios_that_no_octahedron_has_are_refused_with_the_range() {
    for ratio in [
        f64::NAN,
        f64::INFINITY,
        -1.0,
        0.0,
        0.5,
        0.6123,
        0.7072,
        1.0,
        1e300,
    ] {
        let octahedron = Octahedron {
            ratio,
            ..Octahedron::default()
        };
        let error = octahedron.structure().expect_err("no octahedron");
        assert!(matches!(error, TensegrityError::Ratio { .. }), "{ratio}");
        assert!(error.to_string().contains("0.6123724"), "{error}");
    }
}

#[test]
fn ratios_of_cables_that_no_balance_has_are_refused() {
    for cable_ratio in [1e-9, 1e-6, 1e6, 1e11] {
        for solid in Solid::ALL {
            let polyhedron = Polyhedron {
                cable_ratio,
                ..Polyhedron::of(solid)
            };
            let error = polyhedron.structure().expect_err("no structure");
            assert!(
                matches!(error, TensegrityError::NoSelfStress { .. }),
                "{error}"
            );
        }
    }
    let circuit = Polyhedron {
        cable_ratio: 1.1,
        ..Polyhedron::of(Solid::Cuboctahedron)
    };
    let error = circuit.structure().expect_err("one kind of cables");
    assert!(error.to_string().contains("one kind"), "{error}");
}

/// Three struts that touch nothing, and what is added to them.
fn with(member: Member, extra: Option<Point>) -> Result<Structure, TensegrityError> {
    let mut nodes: Vec<Point> = (0..6)
        .map(|i| Point::at(f64::from(i), f64::from(i * i), f64::from(i % 2)))
        .collect();
    nodes.extend(extra);
    let strut = |ends| Member {
        role: Role::Strut,
        ends,
        class: 0,
    };
    let members = vec![strut([0, 1]), strut([2, 3]), strut([4, 5]), member];
    Structure::new(nodes, members)
}

#[test]
fn structures_that_are_none_are_refused() {
    let cable = |ends| Member {
        role: Role::Cable,
        ends,
        class: 1,
    };
    assert!(with(cable([0, 2]), None).is_ok());
    let nowhere = with(cable([0, 6]), None);
    assert_eq!(
        nowhere,
        Err(TensegrityError::NoSuchNode {
            ends: [0, 6],
            nodes: 6
        })
    );
    let far = with(cable([usize::MAX, 0]), None);
    assert!(matches!(far, Err(TensegrityError::NoSuchNode { .. })));
    let itself = with(cable([3, 3]), None);
    assert_eq!(itself, Err(TensegrityError::NoLength { ends: [3, 3] }));
    let same = with(cable([0, 6]), Some(Point::at(0.0, 0.0, 1e-12)));
    assert_eq!(same, Err(TensegrityError::NoLength { ends: [0, 6] }));
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let refused = with(cable([0, 2]), Some(Point::at(0.0, bad, 0.0)));
        assert!(
            matches!(refused, Err(TensegrityError::Number { .. })),
            "{bad}"
        );
    }
    let none = Structure::new(Vec::new(), Vec::new());
    assert_eq!(none, Err(TensegrityError::FewStruts { value: 0 }));
    let many = vec![cable([0, 1]); MOST_MEMBERS + 1];
    let many = Structure::new(vec![Point::at(0.0, 0.0, 0.0)], many);
    assert!(matches!(
        many,
        Err(TensegrityError::TooMany {
            what: "members",
            ..
        })
    ));
}

#[test]
fn members_that_are_not_finite_generate_nothing() {
    let group = PointGroup::from_geometric("b(3)b(3)").expect("a group");
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let strut = GeneratingMember::strut(Point::at(bad, 0.0, 0.0), Point::at(0.0, 1.0, 2.0));
        assert!(
            generate(group.transformations(), &[strut]).is_err(),
            "{bad}"
        );
    }
    let none = generate(group.transformations(), &[]);
    assert_eq!(none, Err(TensegrityError::FewStruts { value: 0 }));
    let strut = GeneratingMember::strut(Point::at(0.3, 0.0, 0.0), Point::at(0.0, 1.0, 2.0));
    assert_eq!(
        generate(&[], &[strut]),
        Err(TensegrityError::FewStruts { value: 0 })
    );
}

#[test]
fn structures_on_a_line_or_in_a_plane_are_analysed_without_trouble() {
    let strut = |ends| Member {
        role: Role::Strut,
        ends,
        class: 0,
    };
    let members = vec![strut([0, 1]), strut([2, 3]), strut([1, 2])];
    for place in [
        |i: f64| Point::at(i, 0.0, 0.0),
        |i: f64| Point::at(i, i * i, 0.0),
    ] {
        let nodes = (0..4).map(|i| place(f64::from(i))).collect();
        let structure = Structure::new(nodes, members.clone()).expect("a structure");
        let analysis = Analysis::of(&structure).expect("an analysis");
        assert_eq!(analysis.states, 0);
        let is_finite = analysis
            .force_densities
            .iter()
            .all(|density| density.is_finite());
        assert!(is_finite && analysis.residual(&structure) == 0.0);
    }
}
