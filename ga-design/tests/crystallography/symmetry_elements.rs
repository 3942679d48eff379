//! Whether the symmetry elements of all 230 groups are complete, carried to each other by the group, and
//! independent of the origin.

use std::collections::BTreeMap;

use ga_design::crystallography::symmetry_elements::{Fraction, LatticeLine, LatticePlane};
use ga_design::crystallography::{Operation, SpaceGroup, SymmetryElements};

fn elements(group: &SpaceGroup) -> (Vec<Operation>, SymmetryElements) {
    let operations = group.operations().expect("a Hall symbol of the table");
    let elements = SymmetryElements::of(&operations).expect("a space group");
    (operations, elements)
}

/// A point in general position, different for every use.
fn somewhere(seed: usize) -> [f64; 3] {
    [0.754_877_666, 0.569_840_291, 0.430_159_709]
        .map(|step: f64| (step * (seed + 1) as f64).fract())
}

fn close_to_whole(value: f64) -> bool {
    (value - value.round()).abs() < 1e-9
}

fn float(fraction: Fraction) -> f64 {
    *fraction.numer() as f64 / *fraction.denom() as f64
}

/// Where an operation moved by a lattice translation leaves something in place: the mean of the orbit of
/// a point, after the mean step of the orbit was taken off. This is geometry with floating-point numbers
/// and shares nothing with the exact solution.
fn fixed_point(operation: &Operation, shift: [f64; 3], start: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let step = |x: [f64; 3]| {
        let image = operation.apply(x);
        [0, 1, 2].map(|i| image[i] + shift[i])
    };
    let orbit: Vec<_> = std::iter::successors(Some(start), |x| Some(step(*x)))
        .take(13)
        .collect();
    let along = [0, 1, 2].map(|i| (orbit[12][i] - start[i]) / 12.0);
    let mean = |i: usize| {
        let terms = orbit.iter().take(12).enumerate();
        terms.map(|(n, x)| x[i] - n as f64 * along[i]).sum::<f64>() / 12.0
    };
    ([0, 1, 2].map(mean), along)
}

#[test]
fn every_operation_with_every_translation_has_its_element_in_the_list() {
    for number in 1..=230 {
        let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
        let (operations, found) = elements(group);
        let mut seed = 0;
        for (index, operation) in operations.iter().enumerate() {
            if operation.is_translation() {
                continue;
            }
            for corner in 0..27 {
                let shift = [corner / 9, corner / 3 % 3, corner % 3].map(|k| f64::from(k) - 1.0);
                seed += 1;
                let (x, along) = fixed_point(operation, shift, somewhere(seed));
                let axes = found.axes().iter().filter(|axis| {
                    let crossed = |p: [Fraction; 3], d: [i64; 3]| goes_through(p, d, x);
                    axis.operations().contains(&index)
                        && crossed(axis.line().point(), axis.line().direction())
                });
                let planes = found.planes().iter().filter(|plane| {
                    let terms = plane.place().normal().into_iter().zip(x);
                    let value: f64 = terms.map(|(h, x)| h as f64 * x).sum();
                    let is_mirror = along.iter().all(|part| part.abs() < 1e-9);
                    plane.operations().contains(&index)
                        && close_to_whole(value - float(plane.place().offset()))
                        && (!is_mirror || plane.letter() == 'm')
                });
                let centres = found.centres().iter().filter(|centre| {
                    let mut parts = centre.point().into_iter().zip(x);
                    centre.operations().contains(&index)
                        && parts.all(|(c, x)| close_to_whole(float(c) - x))
                });
                let all = axes.count() + planes.count() + centres.count();
                assert_eq!(all, 1, "{number}: {operation} shifted by {shift:?}");
            }
        }
    }
}

/// Whether a translate of the line by whole edges goes through a point: the difference, less its part
/// along the direction, is whole for one of the translates.
fn goes_through(point: [Fraction; 3], direction: [i64; 3], x: [f64; 3]) -> bool {
    let difference = [0, 1, 2].map(|i| x[i] - float(point[i]));
    // Every line crosses the layers x_k = 0, 1, … n − 1 of the largest index n: slide to each of them.
    let k = (0..3).max_by_key(|&i| direction[i].abs()).expect("three");
    let size = direction[k].abs();
    (0..size).any(|layer| {
        let slide = (layer as f64 - difference[k]) / direction[k] as f64;
        let mut slid = (0..3).map(|i| difference[i] + slide * direction[i] as f64);
        slid.all(close_to_whole)
    })
}

#[test]
fn the_elements_are_carried_to_each_other_by_every_operation() {
    for group in SpaceGroup::table() {
        let (operations, found) = elements(group);
        let axes: BTreeMap<_, _> = found
            .axes()
            .iter()
            .map(|axis| (axis.line(), axis))
            .collect();
        let planes: BTreeMap<_, _> = found
            .planes()
            .iter()
            .map(|plane| (plane.place(), plane))
            .collect();
        // A few operations of the large groups are enough: with them their products keep the set.
        for operation in operations.iter().take(24) {
            for axis in found.axes() {
                let moved = axis.line().moved_by(operation).expect("small indices");
                let image = axes.get(&moved);
                let image =
                    image.unwrap_or_else(|| panic!("{}: {axis} by {operation}", group.hall));
                let mirrored = match (operation.determinant(), axis.screw()) {
                    (1, screw) | (_, screw @ 0) => screw,
                    (_, screw) => axis.order() - screw,
                };
                assert_eq!((image.order(), image.screw()), (axis.order(), mirrored));
                assert_eq!(
                    image.rotoinversion(),
                    axis.rotoinversion(),
                    "{}",
                    group.hall
                );
                assert_eq!(image.has_inversion_centre(), axis.has_inversion_centre());
                assert_eq!(
                    image.inversion_points().len(),
                    axis.inversion_points().len()
                );
            }
            for plane in found.planes() {
                let moved = plane.place().moved_by(operation).expect("small indices");
                let image = planes.get(&moved);
                let image =
                    image.unwrap_or_else(|| panic!("{}: {plane} by {operation}", group.hall));
                // Edges and diagonals change their names under the axes of the group, mirrors do not.
                assert_eq!(
                    image.letter() == 'm',
                    plane.letter() == 'm',
                    "{}",
                    group.hall
                );
            }
        }
        // Elements stay where they are under their own operations, some lattice translation after.
        for axis in found.axes() {
            for &index in axis.operations() {
                assert_eq!(axis.line().moved_by(&operations[index]), Some(axis.line()));
            }
        }
        for plane in found.planes() {
            for &index in plane.operations() {
                assert_eq!(
                    plane.place().moved_by(&operations[index]),
                    Some(plane.place())
                );
            }
        }
    }
}

#[test]
fn origin_and_order_of_the_operations_do_not_matter() {
    for group in SpaceGroup::table() {
        let (operations, found) = elements(group);
        // Move the origin by an unlucky vector: w' = w + (W − 1) s.
        let moved: Vec<_> = operations
            .iter()
            .rev()
            .map(|operation| {
                let shift = [1, 2, 5].map(|k| num_rational::Ratio::new(k, 7));
                let mut w = operation.translation();
                for (i, row) in operation.rotation().into_iter().enumerate() {
                    w[i] -= shift[i];
                    for (k, entry) in row.into_iter().enumerate() {
                        w[i] += shift[k] * entry;
                    }
                }
                Operation::new(operation.rotation(), w).expect("sevenths are allowed")
            })
            .collect();
        let elsewhere = SymmetryElements::of(&moved).expect("a space group");
        assert_eq!(elsewhere.counts(), found.counts(), "{}", group.hall);
    }
}

#[test]
fn both_origins_of_a_group_have_the_same_elements() {
    let mut compared = 0;
    for number in 1..=230 {
        let settings = SpaceGroup::settings(number);
        let two: Vec<_> = settings
            .iter()
            .filter(|group| matches!(group.choice, Some('1' | '2')))
            .collect();
        for pair in two
            .windows(2)
            .filter(|pair| pair[0].symbol == pair[1].symbol)
        {
            assert_eq!(elements(pair[0]).1.counts(), elements(pair[1]).1.counts());
            compared += 1;
        }
    }
    assert!(compared >= 24, "{compared}");
}

#[test]
fn operations_of_no_crystal_have_no_elements() {
    for text in ["x+y,y,z", "2x+y,x+y,z", "-x+y,-y,z+1/2", "x,y+16z,z"] {
        let Ok(operation) = text.parse::<Operation>() else {
            continue;
        };
        match SymmetryElements::of(&[operation]) {
            // -x+y,-y,z is a half turn in an oblique cell.
            Ok(found) => assert_eq!((text, found.axes().len()), ("-x+y,-y,z+1/2", 4)),
            Err(error) => assert!(error.to_string().contains(&operation.to_string())),
        }
    }
    let shear = Operation::new([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [0.into(); 3]).expect("det 1");
    assert!(SymmetryElements::of(&[shear]).is_err());
    assert_eq!(SymmetryElements::of(&[]), Ok(SymmetryElements::default()));
    // Not a group: elements all the same, and no panic.
    let lone = Operation::new([[-1, 0, 0], [0, -1, 0], [0, 0, -1]], [0.into(); 3]).expect("det -1");
    assert_eq!(
        SymmetryElements::of(&[lone])
            .expect("a centre")
            .centres()
            .len(),
        8
    );
}

#[test]
fn lines_and_planes_beyond_reason_are_none() {
    let far = Fraction::from(i64::MAX);
    let fine = Fraction::new(1, i64::MAX);
    let zero = Fraction::from(0);
    for bad in [
        far,
        -far,
        fine,
        Fraction::new_raw(1, 0),
        Fraction::new_raw(1, -2),
    ] {
        assert_eq!(LatticeLine::through([1, 1, 1], [bad, zero, zero]), None);
        assert_eq!(LatticePlane::through([1, 1, 1], [zero, bad, zero]), None);
    }
    for bad in [[0; 3], [i64::MAX, 1, 0], [i64::MIN, 1, 0], [65, 1, 0]] {
        assert_eq!(LatticeLine::through(bad, [zero; 3]), None);
        assert_eq!(LatticePlane::through(bad, [zero; 3]), None);
    }
}
