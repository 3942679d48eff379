//! The split of bivectors into commuting blades.

use ga::core::algorithm::Split;
use ga::core::ops::{Element, SplitCommuting};

use crate::families::families;
use crate::space::{Space, error, largest};
use crate::{conformal_space, r1_3, r2_2, r3_0_1, r4, r4_1, r5, space};
use ga::cga::cga3;

/// Of every family: the parts add up to the bivector, commute, and are blades.
fn check<B>(space: &Space)
where
    B: Element<Number = f64> + SplitCommuting<Output: Element<Number = f64>>,
{
    let mut unique = 0;
    for sample in families(space) {
        let bivector: B = space.rounded(&sample.bivector);
        // Not in the type: a part of the bivector is dropped.
        if error(&space.value(&bivector), &sample.bivector) > 1e-15 {
            continue;
        }
        let Split::Blades([first, second]) = bivector.split_commuting() else {
            continue;
        };
        unique += 1;
        let exact = space.value(&bivector);
        let (first, second) = (space.value(&first), space.value(&second));
        let scale = largest(&exact).max(1e-150);
        let sum = first.add(&second).expect("the same algebra");
        // Blades that are nearly alike are known that much less.
        let squares = [&first, &second].map(|blade| space.times(blade, blade));
        let [x, y] = [0, 1].map(|i| squares[i].coefficient(ga::core::Blade::SCALAR).to_f64());
        let condition = scale * scale / (x - y).abs().max(1e-300);
        let allowed = 1e-14 * (1.0 + condition);
        assert!(x >= y - allowed * scale * scale, "{}: {x} {y}", sample.kind);
        assert!(error(&sum, &exact) <= allowed, "{}", sample.kind);
        let commutator = space
            .times(&first, &second)
            .sub(&space.times(&second, &first))
            .expect("the same algebra");
        assert!(
            largest(&commutator) <= allowed * scale * scale,
            "{}",
            sample.kind
        );
        for square in squares {
            let rest = largest(&square.grade(4));
            assert!(
                rest <= allowed * scale * scale,
                "{} {}: {rest:e}",
                space.name,
                sample.kind
            );
        }
    }
    assert!(unique > 50, "{unique} in {}", space.name);
}

#[test]
fn parts_are_commuting_blades() {
    check::<r4::Bivector>(&space("R4", 4, 0, 0));
    check::<r1_3::Bivector>(&space("R1_3", 1, 3, 0));
    check::<r3_0_1::Bivector>(&space("R3_0_1", 3, 0, 1));
    check::<r2_2::Bivector>(&space("R2_2", 2, 2, 0));
    check::<r5::Bivector>(&space("R5", 5, 0, 0));
    check::<cga3::PointPair>(&conformal_space());
    check::<cga3::DualLine>(&conformal_space());
}

#[test]
fn a_screw_is_a_line_and_a_translation() {
    // A quarter turn about the z axis and a shift along it.
    let screw = cga3::DualLine::from([0.8, 0.0, 0.0, 0.0, 0.0, 0.3]);
    let translation = cga3::DualLine::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.3]);
    let rotation = screw - translation;
    let [first, second] = screw.split_commuting().blades().expect("unique");
    let size = |x: cga3::DualLine| x.to_array().into_iter().map(f64::abs).sum::<f64>();
    assert!(size(first - translation) < 1e-15 && size(second - rotation) < 1e-15);
    assert_eq!(
        rotation.split_commuting().blades().map(|[a, b]| a + b),
        Some(rotation)
    );
}

#[test]
fn the_other_answers() {
    let isoclinic = r4::Bivector::from([1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    assert_eq!(isoclinic.split_commuting(), Split::Isoclinic);
    assert_eq!(isoclinic.split_commuting().blades(), None);
    // e12 + e34 + e13 + e24: the squares of the blades would be complex.
    let complex = r2_2::Bivector::from([1.0, 1.0, 0.0, 0.0, -1.0, 1.0]);
    let other = r2_2::Bivector::from([1.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
    let answers = [complex.split_commuting(), other.split_commuting()];
    assert!(answers.contains(&Split::Complex), "{answers:?}");
    let zero = r4_1::Bivector::<f64>::default();
    assert_eq!(zero.split_commuting(), Split::Blades([zero, zero]));
    let bad = r4::Bivector::from([f64::NAN, 0.0, 0.0, 0.0, 0.0, 1.0]);
    assert!(bad.split_commuting().blades().is_none());
    let huge = r4::Bivector::from([1e200, 0.0, 0.0, 0.0, 0.0, 1e100]);
    assert!(huge.split_commuting().blades().is_none());
}
