//! Whether the elements that versors show in space are those found exactly from the operations.

use crate::standard_cell::cell;
use std::f64::consts::TAU;

use ga_cga::{DualLine, DualPlane, Line, Motor, Point, Vector3};
use ga_design::crystallography::symmetry_elements::LatticeLine;
use ga_design::crystallography::{
    Cell, CellRange, Isometry, Motion, Placement, SpaceGroup, SymmetryElements,
};

/// The image of an element under an isometry.
fn moved_line(line: DualLine, by: &Isometry) -> DualLine {
    let reflected = by.mirror.map_or(line, |mirror| mirror.apply(line));
    by.motor.apply(reflected)
}

fn moved_plane(plane: DualPlane, by: &Isometry) -> DualPlane {
    let reflected = by.mirror.map_or(plane, |mirror| mirror.apply(plane));
    by.motor.apply(reflected)
}

/// Whether two elements are one up to orientation.
fn same(a: &[f64], b: &[f64]) -> bool {
    let off = |sign: f64| a.iter().zip(b).all(|(x, y)| (x - sign * y).abs() < 1e-9);
    off(1.0) || off(-1.0)
}

/// Whether a point in space is on a translate of a line of the list.
fn is_on(line: LatticeLine, cell: &Cell, point: Point) -> bool {
    let x = cell.fractional(point.position().to_array());
    let home = line.line(cell);
    let span = -4..=4;
    span.clone().any(|i| {
        span.clone().any(|j| {
            span.clone().any(|k| {
                let back = [
                    x[0] - f64::from(i),
                    x[1] - f64::from(j),
                    x[2] - f64::from(k),
                ];
                let [a, b, c] = cell.cartesian(back);
                let there = Point::at(a, b, c);
                home.nearest(there)
                    .is_some_and(|foot| foot.distance(there) < 1e-8)
            })
        })
    })
}

#[test]
fn versors_have_the_elements_of_their_operations_in_all_groups() {
    for number in 1..=230 {
        let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
        let operations = group.operations().expect("a Hall symbol of the table");
        let cell = cell(number);
        let found = SymmetryElements::of(&operations).expect("a space group");
        let (placements, _) = Placement::of_group(&operations, &cell).expect("a fitting cell");
        for (index, placement) in placements.iter().enumerate() {
            let isometry = Isometry::from(placement);
            let name = format!("{number}: {}", operations[index]);
            match isometry.motion() {
                Motion::Identity => assert!(operations[index].is_translation(), "{name}"),
                Motion::Translation { vector: by } => {
                    assert!(operations[index].is_translation(), "{name}");
                    let by = by.to_array();
                    assert!((0..3).all(|i| (by[i] - placement.translation[i]).abs() < 1e-9));
                }
                Motion::Screw {
                    angle,
                    rise: advance,
                    ..
                } => {
                    let axis = isometry.motion().axis().expect("a screw has one");
                    // The line in the logarithm of the motor is the same.
                    let motor = isometry.motor;
                    let motor = if motor.s < 0.0 { -motor } else { motor };
                    let generator: DualLine = motor.log().expect("at most half a turn");
                    let line = Motor::from(-generator).renormalized().expect("a line");
                    let line: DualLine = line.narrow(1e-9).expect("a line");
                    assert!(same(&line.to_array(), &axis.to_array()), "{name}");
                    assert!(
                        same(&moved_line(axis, &isometry).to_array(), &axis.to_array()),
                        "{name}"
                    );
                    let turns = TAU / angle;
                    assert!((turns - turns.round()).abs() < 1e-9, "{name}: {turns}");
                    let foot = axis.nearest(Point::at(0.1, 0.2, 0.3)).expect("a line");
                    let listed = found.axes().iter().find(|element| {
                        element.operations().contains(&index) && is_on(element.line(), &cell, foot)
                    });
                    let listed = listed.unwrap_or_else(|| panic!("{name} is not in the list"));
                    // The screw of 2π/n, repeated until it has turned by this angle, climbs as far up
                    // to lattice translations along the axis.
                    let edge =
                        Vector3::from(cell.cartesian(listed.line().direction().map(|k| k as f64)));
                    let period = edge.norm() * float(listed.period());
                    let repeats = f64::from(listed.order()) / turns;
                    let climbed = f64::from(listed.screw()) / f64::from(listed.order()) * repeats;
                    let off = advance / period - climbed;
                    assert!(
                        (off - off.round()).abs() < 1e-8,
                        "{name} {listed}: {advance}"
                    );
                }
                Motion::Glide {
                    plane,
                    vector: glide,
                } => {
                    assert!(same(
                        &moved_plane(plane, &isometry).to_array(),
                        &plane.to_array()
                    ));
                    assert!(plane.normal().scalar_product(glide).abs() < 1e-9, "{name}");
                    let listed = found.planes().iter().any(|element| {
                        let there = element.dual_plane(&cell);
                        let spacing = 1.0 / reciprocal(element.place().normal(), &cell);
                        let ours = plane.distance_from_origin().expect("a plane");
                        let theirs = there.distance_from_origin().expect("a plane");
                        let parallel = plane.normal().scalar_product(there.normal());
                        let apart = (ours - theirs * parallel.signum()) / spacing;
                        element.operations().contains(&index)
                            && (parallel.abs() - 1.0).abs() < 1e-9
                            && (apart - apart.round()).abs() < 1e-8
                            && (element.letter() != 'm'
                                || is_lattice_vector(glide, &cell, &operations))
                    });
                    assert!(listed, "{name}");
                }
                Motion::RotoInversion {
                    center: point,
                    axis: Some(_),
                    angle,
                } => {
                    let axis = isometry.motion().axis().expect("a rotoinversion has one");
                    assert!(
                        same(&moved_line(axis, &isometry).to_array(), &axis.to_array()),
                        "{name}"
                    );
                    assert!(isometry.apply(point).distance(point) < 1e-9, "{name}");
                    let order = (TAU / angle).round();
                    assert!((TAU / angle - order).abs() < 1e-9, "{name}");
                    let listed = found.axes().iter().any(|element| {
                        let mut points = element.inversion_points().iter();
                        element.operations().contains(&index)
                            && is_on(element.line(), &cell, point)
                            && points.any(|at| is_translate(at.map(float), &cell, point))
                    });
                    assert!(listed, "{name}");
                }
                Motion::RotoInversion {
                    center: point,
                    axis: None,
                    ..
                } => {
                    assert!(isometry.apply(point).distance(point) < 1e-9, "{name}");
                    let mut centres = found.centres().iter();
                    assert!(centres.any(|centre| {
                        is_translate(centre.point().map(float), &cell, point)
                            && centre.conformal_point(&cell).position().norm() < 50.0
                    }));
                }
            }
        }
    }
}

fn float(part: ga_design::crystallography::symmetry_elements::Fraction) -> f64 {
    *part.numer() as f64 / *part.denom() as f64
}

/// The length of the reciprocal vector (hkl)*.
fn reciprocal(normal: [i64; 3], cell: &Cell) -> f64 {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let parts = axes.map(|axis| {
        let x = cell.fractional(axis);
        (0..3).map(|i| normal[i] as f64 * x[i]).sum::<f64>()
    });
    parts.iter().map(|part| part * part).sum::<f64>().sqrt()
}

fn is_translate(fraction: [f64; 3], cell: &Cell, point: Point) -> bool {
    let x = cell.fractional(point.position().to_array());
    (0..3).all(|i| {
        let off = x[i] - fraction[i];
        (off - off.round()).abs() < 1e-8
    })
}

fn is_lattice_vector(
    vector: Vector3,
    cell: &Cell,
    operations: &[ga_design::crystallography::Operation],
) -> bool {
    let translations = operations
        .iter()
        .filter(|operation| operation.is_translation());
    let [x, y, z] = vector.to_array();
    let mut all = translations.map(|operation| operation.translation_f64());
    all.any(|t| is_translate(t, cell, Point::at(x, y, z)))
}

#[test]
fn placed_elements_lie_on_their_conformal_elements_and_in_the_block() {
    for (symbol, cells) in [
        ("P 31 2 1", "2x1x1"),
        ("I a -3 d", "1"),
        ("P 1 21/c 1", "-1:1x0:1x0:1"),
    ] {
        let group = SpaceGroup::from_symbol(symbol).expect("known")[0];
        let cell = cell(group.number);
        let elements = SymmetryElements::of(&group.operations().expect("Hall")).expect("a group");
        let range: CellRange = cells.parse().expect("a range");
        let placed = elements.within(range).expect("few");
        let inside = |x: &[f64; 3]| {
            (0..3).all(|i| {
                let (low, high) = (f64::from(range.low[i]), f64::from(range.high[i]));
                (low - 1e-9..=high + 1e-9).contains(&x[i])
            })
        };
        for segment in &placed.axes {
            assert!(segment.ends.iter().all(inside), "{symbol} {}", segment.axis);
            assert!(
                segment.inversion_points.iter().all(inside),
                "{symbol} {}",
                segment.axis
            );
            let [from, to] = segment.ends.map(|x| {
                let [x, y, z] = cell.cartesian(x);
                Point::at(x, y, z)
            });
            let line = Line::through(from, to).expect("of some length");
            let turned = segment.axis.line().line(&cell).direction();
            let along = line.direction() / line.weight();
            assert!((along - turned).norm() < 1e-9);
            assert!(
                is_on(segment.axis.line(), &cell, from),
                "{symbol} {}",
                segment.axis
            );
        }
        for polygon in &placed.planes {
            assert!(polygon.corners.len() >= 3 && polygon.corners.iter().all(inside));
        }
        assert!(placed.centres.iter().all(|centre| inside(&centre.point)));
    }
    // Counted by hand: half turns along c of P 2 stand in the corners, edges and middle of the cell.
    let group = SpaceGroup::from_symbol("P 1 1 2").expect("known")[0];
    let elements = SymmetryElements::of(&group.operations().expect("Hall")).expect("a group");
    assert_eq!(elements.within(CellRange::UNIT).expect("few").axes.len(), 9);
    let huge: CellRange = "1000x1000x1000".parse().expect("a range");
    assert!(elements.within(huge).is_err());
    let backwards = CellRange {
        low: [1; 3],
        high: [0; 3],
    };
    let none = elements.within(backwards).expect("none");
    assert!(none.axes.is_empty() && none.planes.is_empty() && none.centres.is_empty());
}
