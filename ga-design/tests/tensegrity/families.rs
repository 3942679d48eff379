//! The Platonic and Archimedean families: counts, balance, stability, and known ratios.

use crate::analysed;
use ga_design::tensegrity::{Hand, Polyhedron, Solid, Stability, Structure};

/// Struts and cables of each; in the diamond and zigzag patterns each strut has its own two nodes.
const COUNTS: [(Solid, usize, usize); 10] = [
    (Solid::Icosahedron, 6, 24),
    (Solid::Rhombicuboctahedron, 12, 48),
    (Solid::Rhombicosidodecahedron, 30, 120),
    (Solid::TruncatedTetrahedron, 6, 18),
    (Solid::TruncatedCube, 12, 36),
    (Solid::TruncatedOctahedron, 12, 36),
    (Solid::TruncatedDodecahedron, 30, 90),
    (Solid::TruncatedIcosahedron, 30, 90),
    (Solid::Cuboctahedron, 12, 24),
    (Solid::Icosidodecahedron, 30, 60),
];

fn is_circuit(solid: Solid) -> bool {
    matches!(solid, Solid::Cuboctahedron | Solid::Icosidodecahedron)
}

#[test]
fn every_family_is_found_in_balance_and_super_stable() {
    assert_eq!(COUNTS.map(|row| row.0), Solid::ALL);
    for (solid, struts, cables) in COUNTS {
        let name = solid.name();
        let structure = Polyhedron::of(solid).structure().expect(name);
        let counts = (structure.struts().count(), structure.cables().count());
        assert_eq!(counts, (struts, cables), "{name}");
        assert_eq!(structure.has_free_struts(), !is_circuit(solid), "{name}");
        let nodes = if is_circuit(solid) {
            struts
        } else {
            2 * struts
        };
        assert_eq!(structure.nodes().len(), nodes, "{name}");
        let first = structure
            .cables()
            .next()
            .map(|cable| structure.length(cable));
        for cable in structure.cables() {
            let length = structure.length(cable);
            assert!((length - first.unwrap_or(0.0)).abs() < 1e-11, "{name}");
        }
        for strut in structure.struts() {
            assert!((structure.length(strut) - 1.0).abs() < 1e-12, "{name}");
        }
        let analysis = analysed(&structure);
        assert!(analysis.is_proper, "{name}");
        assert_eq!(analysis.stability, Stability::SuperStable, "{name}");
        assert_eq!(analysis.nullity, 4, "{name}");
        if !is_circuit(solid) {
            assert_eq!(analysis.states, 1, "{name}");
        }
    }
}

/// The length of a strut over that of a cable.
fn strut_over_cable(structure: &Structure) -> f64 {
    let length = |member: Option<_>| member.map_or(f64::NAN, |m| structure.length(m));
    length(structure.struts().next()) / length(structure.cables().next())
}

#[test]
fn known_ratios_of_strut_to_cable_come_out() {
    // A. G. Tibert and S. Pellegrino, “Review of form-finding methods for tensegrity structures”, Int. J.
    // Space Structures 18 (2003) 209–223: the truncated tetrahedron with equal cables has 2.2507.
    let truncated = Polyhedron::of(Solid::TruncatedTetrahedron).structure();
    let ratio = strut_over_cable(&truncated.expect("a structure"));
    assert!((ratio - 2.2507).abs() < 1e-4, "{ratio}");
    let octahedron = Polyhedron::of(Solid::Icosahedron).structure();
    let ratio = strut_over_cable(&octahedron.expect("a structure"));
    assert!((ratio - (8.0_f64 / 3.0).sqrt()).abs() < 1e-12, "{ratio}");
    // A chord over two edges of a regular hexagon and of a regular decagon.
    let cuboctahedron = Polyhedron::of(Solid::Cuboctahedron).structure();
    let ratio = strut_over_cable(&cuboctahedron.expect("a structure"));
    assert!((ratio - 3.0_f64.sqrt()).abs() < 1e-12, "{ratio}");
    let icosidodecahedron = Polyhedron::of(Solid::Icosidodecahedron).structure();
    let ratio = strut_over_cable(&icosidodecahedron.expect("a structure"));
    assert!(
        (ratio - 2.0 * 18.0_f64.to_radians().cos()).abs() < 1e-12,
        "{ratio}"
    );
}

#[test]
fn the_ratio_of_cables_is_the_one_asked_for_and_stays_stable() {
    for solid in [
        Solid::Icosahedron,
        Solid::TruncatedTetrahedron,
        Solid::TruncatedCube,
    ] {
        for cable_ratio in [0.8, 1.0, 1.25] {
            let polyhedron = Polyhedron {
                cable_ratio,
                strut: 2.5,
                ..Polyhedron::of(solid)
            };
            let structure = polyhedron.structure().expect("a structure");
            let cables: Vec<_> = structure.cables().collect();
            let length = |index: usize| structure.length(cables[index]);
            let found = length(cables.len() - 1) / length(0);
            assert!(
                (found - cable_ratio).abs() < 1e-8,
                "{} {found}",
                solid.name()
            );
            let strut = structure
                .struts()
                .next()
                .map(|strut| structure.length(strut));
            assert!((strut.unwrap_or(0.0) - 2.5).abs() < 1e-12);
            let analysis = analysed(&structure);
            assert_eq!(
                analysis.stability,
                Stability::SuperStable,
                "{}",
                solid.name()
            );
        }
    }
}

#[test]
fn the_left_hand_is_the_mirror_image() {
    for solid in Solid::ALL {
        let right = Polyhedron {
            hand: Hand::Right,
            ..Polyhedron::of(solid)
        }
        .structure();
        let left = Polyhedron {
            hand: Hand::Left,
            ..Polyhedron::of(solid)
        }
        .structure();
        let (right, left) = (right.expect("a structure"), left.expect("a structure"));
        assert_eq!(right.members(), left.members());
        for (one, other) in right.nodes().iter().zip(left.nodes()) {
            let [x, y, z] = one.position().to_array();
            let [u, v, w] = other.position().to_array();
            let apart = (x + u).abs().max((y - v).abs()).max((z - w).abs());
            assert!(apart < 1e-14, "{}", solid.name());
        }
    }
}

#[test]
fn names_tell_the_solids_apart() {
    let mut names: Vec<_> = Solid::ALL.iter().map(|solid| solid.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Solid::ALL.len());
}
