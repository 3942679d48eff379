//! The expanded octahedron and the prisms: ratios, force densities, states, eigenvalues.

use crate::analysed;
use ga_cga::{Motor, Point, Rotor, Translator, Vector3};
use ga_design::tensegrity::{
    BALANCED_RATIO, Hand, Octahedron, Prism, Role, Stability, Structure, balanced_twist,
};
use proptest::prelude::*;
use std::f64::consts::PI;

fn densities(structure: &Structure, role: Role) -> Vec<f64> {
    let analysis = analysed(structure);
    let members = structure.members().iter().zip(&analysis.force_densities);
    members
        .filter(|(member, _)| member.role == role)
        .map(|(_, density)| *density)
        .collect()
}

#[test]
fn the_octahedron_is_in_balance_at_its_ratio() {
    let structure = Octahedron::default().structure().expect("a structure");
    assert!((BALANCED_RATIO - 0.375_f64.sqrt()).abs() < 1e-16);
    let counts = [
        structure.nodes().len(),
        structure.struts().count(),
        structure.cables().count(),
    ];
    assert_eq!(counts, [12, 6, 24]);
    assert!(structure.has_free_struts());
    for cable in structure.cables() {
        assert!((structure.length(cable) - 0.375_f64.sqrt()).abs() < 1e-15);
    }
    let analysis = analysed(&structure);
    assert_eq!((analysis.states, analysis.mechanisms), (1, 1));
    assert_eq!(analysis.stability, Stability::SuperStable);
    assert_eq!(analysis.nullity, 4);
    assert!(analysis.eigenvalues[4] > 0.1 && analysis.eigenvalues[0] > -1e-14);
    for strut in densities(&structure, Role::Strut) {
        for cable in densities(&structure, Role::Cable) {
            assert!((strut / cable + 1.5).abs() < 1e-13);
        }
    }
}

#[test]
fn every_strut_of_the_octahedron_lies_along_an_axis() {
    let structure = Octahedron::default().structure().expect("a structure");
    for strut in structure.struts() {
        let [from, to] = structure.ends(strut).map(|end| end.position());
        let along = (to - from).to_array();
        let small = along.iter().filter(|part| part.abs() < 1e-15).count();
        assert_eq!(small, 2, "{along:?}");
    }
}

#[test]
fn at_every_other_ratio_the_self_stress_vanishes() {
    for ratio in [0.6124, 0.613, 0.62, 0.65, 0.68, 0.7, 0.707] {
        let octahedron = Octahedron {
            ratio,
            ..Octahedron::default()
        };
        let structure = octahedron.structure().expect("a structure");
        for cable in structure.cables() {
            assert!((structure.length(cable) - ratio).abs() < 1e-14);
        }
        let analysis = analysed(&structure);
        assert_eq!((analysis.states, analysis.mechanisms), (0, 0), "{ratio}");
        assert_eq!(analysis.stability, Stability::Unstressed);
        assert!(!analysis.is_proper);
    }
}

#[test]
fn a_ratio_as_it_is_printed_means_the_balanced_one() {
    for ratio in [0.6123724, 0.612372, 0.6123725, 0.61237243] {
        let octahedron = Octahedron {
            ratio,
            ..Octahedron::default()
        };
        let structure = octahedron.structure().expect("a structure");
        assert_eq!(analysed(&structure).states, 1, "{ratio}");
    }
}

#[test]
fn prisms_of_both_hands_have_the_force_densities_of_the_literature() {
    for n in 3..=12 {
        for hand in [Hand::Right, Hand::Left] {
            let prism = Prism {
                struts: n,
                radius: 1.3,
                height: 0.9,
                twist: None,
                hand,
            };
            let structure = prism.structure().expect("a structure");
            let counts = [structure.nodes().len(), structure.struts().count()];
            assert_eq!(counts, [2 * n, n]);
            assert_eq!(structure.cables().count(), 3 * n);
            assert!(structure.has_free_struts());
            let analysis = analysed(&structure);
            assert_eq!((analysis.states, analysis.mechanisms), (1, 2 * n - 5));
            assert_eq!(
                (analysis.stability, analysis.nullity),
                (Stability::SuperStable, 4)
            );
            let horizontal = 1.0 / (2.0 * (PI / n as f64).sin());
            for (member, density) in structure.members().iter().zip(&analysis.force_densities) {
                let [from, to] = structure.ends(member).map(|end| end.position().to_array());
                let is_level = (from[2] - to[2]).abs() < 1e-12;
                let expected = match member.role {
                    Role::Strut => -1.0,
                    Role::Cable if is_level => horizontal,
                    Role::Cable => 1.0,
                };
                assert!(
                    (density - expected).abs() < 1e-12,
                    "{n}: {density} {expected}"
                );
            }
        }
    }
}

/// The angle from the lower to the upper end of a member that rises, about z, from −π to π.
fn turn(ends: [Point; 2]) -> Option<f64> {
    let [mut low, mut high] = ends.map(|end| end.position().to_array());
    if low[2] > high[2] {
        std::mem::swap(&mut low, &mut high);
    }
    let rises = high[2] - low[2] > 1e-9;
    let angle = high[1].atan2(high[0]) - low[1].atan2(low[0]);
    rises.then(|| (angle + PI).rem_euclid(2.0 * PI) - PI)
}

#[test]
fn the_side_cables_turn_by_the_balanced_angle_and_to_the_hand() {
    for n in 3..=12 {
        for (hand, sign) in [(Hand::Right, 1.0), (Hand::Left, -1.0)] {
            let structure = Prism {
                struts: n,
                hand,
                ..Prism::default()
            }
            .structure();
            let structure = structure.expect("a structure");
            let twist = PI / 2.0 - PI / n as f64;
            assert!((balanced_twist(n) - twist).abs() < 1e-15);
            for member in structure.members() {
                let Some(angle) = turn(structure.ends(member)) else {
                    continue;
                };
                let expected = match member.role {
                    Role::Cable => twist,
                    Role::Strut => twist + 2.0 * PI / n as f64,
                };
                assert!(
                    (angle - sign * expected).abs() < 1e-12,
                    "{n} {angle} {expected}"
                );
            }
        }
    }
}

#[test]
fn a_prism_of_another_twist_has_no_self_stress() {
    for n in 3..=8 {
        for off in [-0.3, -0.01, 0.01, 0.2] {
            let twist = Some(balanced_twist(n) + off);
            let structure = Prism {
                struts: n,
                twist,
                ..Prism::default()
            }
            .structure();
            let analysis = analysed(&structure.expect("a structure"));
            assert_eq!(analysis.states, 0, "{n} {off}");
            assert_eq!(analysis.stability, Stability::Unstressed);
        }
    }
}

fn structures() -> impl Strategy<Value = Structure> {
    let prism = (3..9_usize, any::<bool>(), 0.3..3.0_f64, 0.3..3.0_f64).prop_map(
        |(struts, left, radius, height)| {
            let hand = if left { Hand::Left } else { Hand::Right };
            Prism {
                struts,
                radius,
                height,
                twist: None,
                hand,
            }
            .structure()
        },
    );
    let octahedron = (0.1..10.0_f64).prop_map(|strut| {
        let ratio = BALANCED_RATIO;
        Octahedron { strut, ratio }.structure()
    });
    prop_oneof![prism, octahedron].prop_map(|structure| structure.expect("a structure"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Statics do not depend on place, direction or unit.
    #[test]
    fn motions_and_scalings_keep_all_that_is_told(
        structure in structures(),
        axis in prop::array::uniform3(-1.0..1.0_f64),
        angle in -3.0..3.0_f64,
        place in prop::array::uniform3(-50.0..50.0_f64),
        exponent in -5.0..5.0_f64,
    ) {
        let rotor = Rotor::about_axis(Vector3::from(axis), angle);
        prop_assume!(rotor.is_some());
        let rotor = rotor.unwrap_or(Rotor::identity());
        let motor = Motor::rigid(rotor, Translator::by(Vector3::from(place)));
        let scale = exponent.exp();
        let moved = structure.moved(|point| {
            let scaled = Point::from(point.position() * scale);
            motor.apply(scaled)
        });
        let moved = moved.expect("a structure");
        let (before, after) = (analysed(&structure), analysed(&moved));
        prop_assert_eq!(before.states, after.states);
        prop_assert_eq!(before.mechanisms, after.mechanisms);
        prop_assert_eq!(before.stability, after.stability);
        prop_assert_eq!(before.nullity, after.nullity);
        for (one, other) in before.force_densities.iter().zip(&after.force_densities) {
            prop_assert!((one - other).abs() < 1e-8);
        }
    }
}
