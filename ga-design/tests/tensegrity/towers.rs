//! Towers: no strut touches another, and the depth that is found is one of balance.

use crate::analysed;
use ga_design::tensegrity::{
    Hand, MOST_STAGE_STRUTS, Stability, Structure, TensegrityError, Tower,
};

fn tower(struts: usize, stages: usize, hand: Hand) -> Structure {
    let tower = Tower {
        struts,
        stages,
        hand,
        ..Tower::default()
    };
    tower.structure().expect("a tower")
}

/// The least distance of two segments, by trying points along both.
fn least_distance(structure: &Structure) -> f64 {
    let struts: Vec<_> = structure
        .struts()
        .map(|strut| structure.ends(strut))
        .collect();
    let points = |index: usize| {
        let [from, to] = struts[index].map(|end| end.position());
        (0..=60).map(move |step| from + (to - from) * (f64::from(step) / 60.0))
    };
    let mut least = f64::INFINITY;
    for one in 0..struts.len() {
        for other in one + 1..struts.len() {
            for a in points(one) {
                for b in points(other) {
                    least = least.min((a - b).norm());
                }
            }
        }
    }
    least
}

#[test]
fn towers_of_many_sizes_are_super_stable_with_free_struts() {
    for (struts, stages) in [
        (3, 2),
        (3, 3),
        (3, 4),
        (3, 5),
        (4, 2),
        (4, 3),
        (5, 3),
        (6, 2),
    ] {
        for hand in [Hand::Right, Hand::Left] {
            let structure = tower(struts, stages, hand);
            assert_eq!(structure.nodes().len(), 2 * struts * stages);
            assert_eq!(structure.struts().count(), struts * stages);
            // Side cables, two polygons, a belt of saddles and two sets of risers at each joint.
            let cables = struts * (stages + 2 + 4 * (stages - 1));
            assert_eq!(structure.cables().count(), cables, "{struts} {stages}");
            assert!(structure.has_free_struts());
            let analysis = analysed(&structure);
            assert_eq!(analysis.states, 1, "{struts} {stages}");
            assert_eq!(
                analysis.stability,
                Stability::SuperStable,
                "{struts} {stages}"
            );
        }
    }
}

#[test]
fn there_is_a_tower_of_every_number_of_struts() {
    for struts in 3..=MOST_STAGE_STRUTS {
        for stages in [2, 3] {
            let structure = tower(struts, stages, Hand::Right);
            assert_eq!(structure.struts().count(), struts * stages);
        }
    }
}

#[test]
fn struts_keep_apart() {
    let structure = tower(3, 3, Hand::Right);
    assert!(least_distance(&structure) > 0.1);
}

#[test]
fn radius_and_height_are_those_asked_for() {
    let asked = Tower {
        radius: 2.0,
        height: 7.0,
        stages: 3,
        ..Tower::default()
    };
    let structure = asked.structure().expect("a tower");
    for node in structure.nodes() {
        let [x, y, _] = node.position().to_array();
        assert!((x.hypot(y) - 2.0).abs() < 1e-12);
    }
    for strut in structure.struts() {
        let [from, to] = structure.ends(strut).map(|end| end.position().to_array());
        assert!(((from[2] - to[2]).abs() - 7.0).abs() < 1e-12);
    }
}

#[test]
fn the_more_twist_the_deeper_stand_the_stages() {
    let height = |degrees: f64| {
        let twist = Some(degrees.to_radians());
        let structure = Tower {
            twist,
            stages: 2,
            ..Tower::default()
        }
        .structure();
        let structure = structure.expect("a tower");
        assert!(analysed(&structure).is_proper);
        let heights = structure
            .nodes()
            .iter()
            .map(|node| node.position().to_array()[2]);
        2.0 * heights.fold(0.0, f64::max)
    };
    let heights = [35.0, 40.0, 45.0, 50.0, 55.0].map(height);
    assert!(
        heights.windows(2).all(|pair| pair[1] < pair[0]),
        "{heights:?}"
    );
}

#[test]
fn without_enough_twist_there_is_no_tower() {
    for degrees in [-40.0, 0.0, 20.0, 75.0] {
        let tower = Tower {
            twist: Some(f64::to_radians(degrees)),
            ..Tower::default()
        };
        let refused = tower.structure();
        assert!(
            matches!(refused, Err(TensegrityError::NoSelfStress { .. })),
            "{degrees}"
        );
    }
}
