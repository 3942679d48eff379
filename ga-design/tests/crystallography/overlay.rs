//! Whether symmetry elements are drawn where they are, in every group, and screws in their sense.

use crate::standard_cell::cell;
use ga_cga::Vector3;
use ga_design::crystallography::overlay::{
    OverlayError, Shown, Style, add_placed_elements, add_symmetry_elements, legend,
};
use ga_design::crystallography::{CellRange, SpaceGroup, SymmetryElements};
use ga_design::export::{Scene, flatten};
use std::f64::consts::TAU;

fn elements(number: u32) -> SymmetryElements {
    let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
    let operations = group.operations().expect("a Hall symbol of the table");
    SymmetryElements::of(&operations).expect("a space group")
}

fn drawn(number: u32, shown: Shown) -> Scene {
    let found = elements(number);
    let mut scene = Scene::new("overlay", "Overlay", legend(&found));
    add_symmetry_elements(&mut scene, &found, &cell(number), CellRange::UNIT, shown)
        .unwrap_or_else(|error| panic!("{number}: {error}"));
    scene
}

#[test]
fn the_elements_of_every_group_can_be_drawn() {
    for number in 1..=230 {
        let scene = drawn(number, Shown::default());
        let found = elements(number);
        let placed = found.within(CellRange::UNIT).expect("few");
        let count = |prefix: &str| {
            let nodes = scene.nodes().iter();
            nodes.filter(|node| node.name.starts_with(prefix)).count()
        };
        assert_eq!(count("inversion centre"), placed.centres.len(), "{number}");
        let mut letters: Vec<char> = placed.planes.iter().map(|p| p.plane.letter()).collect();
        letters.sort_unstable();
        letters.dedup();
        assert_eq!(count("plane "), letters.len(), "{number}");
        // A rod and two symbols for each axis, and a helix for each screw.
        let screws = placed
            .axes
            .iter()
            .filter(|segment| segment.axis.screw() != 0);
        let axes = scene.nodes().iter().filter(|node| node.name.contains('['));
        assert_eq!(
            axes.count(),
            3 * placed.axes.len() + screws.count(),
            "{number}"
        );
        if number % 9 != 0 {
            continue;
        }
        // Nothing is drawn far outside: symbols and helices stand out by a few rods.
        let reach = 0.3 * cell(number).volume().cbrt();
        for surface in flatten::surfaces(&scene) {
            for position in &surface.positions {
                let x = cell(number).fractional(*position);
                let out = x
                    .iter()
                    .map(|part| (part - 0.5).abs() - 0.5)
                    .fold(0.0, f64::max);
                assert!(out * 5.1 < reach, "{number}: {} at {x:?}", surface.name);
            }
        }
    }
}

/// How well the vertices of the surfaces with this name and shape follow a helix about the z axis through
/// a place, of this rise for a turn: 1 for all of them, near 0 for another helix.
fn follows(scene: &Scene, name: &str, [x, y]: [f64; 2], rise: f64) -> f64 {
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for (node, shape, _) in scene.placed() {
        let is_helix = scene
            .shapes()
            .iter()
            .any(|(known, other)| known == name && other == shape);
        if node.name != name || !is_helix {
            continue;
        }
        for p in shape.points() {
            let (dx, dy) = (p[0] - x, p[1] - y);
            // The helices around other axes of the cell are farther away.
            if dx.hypot(dy) < 0.3 {
                let angle = dy.atan2(dx) - TAU * p[2] / rise;
                sum[0] += angle.cos();
                sum[1] += angle.sin();
                count += 1.0;
            }
        }
    }
    assert!(count > 0.0, "{name}");
    (sum[0] / count).hypot(sum[1] / count)
}

#[test]
fn threads_wind_to_the_right_or_to_the_left_as_the_screw_does() {
    // Number, symbol, where the axis stands, the rise of a thread in c, positive to the right.
    for (number, name, at, rise) in [
        (144, "3_1 [0 0 1]", [0.0, 0.0], 1.0),
        (145, "3_2 [0 0 1]", [0.0, 0.0], -1.0),
        (76, "4_1 [0 0 1]", [0.0, 0.0], 1.0),
        (78, "4_3 [0 0 1]", [0.0, 0.0], -1.0),
        (169, "6_1 [0 0 1]", [0.0, 0.0], 1.0),
        (170, "6_5 [0 0 1]", [0.0, 0.0], -1.0),
    ] {
        let scene = drawn(number, Shown::default());
        let c = 7.3;
        let right = follows(&scene, name, at, rise * c);
        let wrong = follows(&scene, name, at, -rise * c);
        assert!(right > 0.95 && wrong < 0.3, "{number}: {right} {wrong}");
    }
    // Two threads of twice the rise: together they follow none, one half turn apart.
    let scene = drawn(171, Shown::default());
    let together = follows(&scene, "6_2 [0 0 1]", [0.0, 0.0], 2.0 * 7.3);
    assert!(together < 0.1, "{together}");
}

#[test]
fn only_what_is_asked_for_is_drawn() {
    let none = Shown {
        axes: false,
        planes: false,
        centres: false,
    };
    assert!(drawn(225, none).nodes().is_empty());
    let axes = drawn(225, Shown { axes: true, ..none });
    assert!(axes.nodes().iter().all(|node| node.name.contains('[')));
    let centres = drawn(
        225,
        Shown {
            centres: true,
            ..none
        },
    );
    assert!(
        centres
            .nodes()
            .iter()
            .all(|node| node.name == "inversion centre")
    );
    assert!(drawn(1, Shown::default()).nodes().is_empty());
    assert_eq!(
        legend(&elements(1)),
        "No symmetry elements but translations."
    );
}

#[test]
fn style_moves_and_thickens() {
    let (found, cell) = (elements(75), cell(75));
    let placed = found.within(CellRange::UNIT).expect("few");
    let bounds = |style: Style| {
        let mut scene = Scene::new("a", "b", "c");
        add_placed_elements(&mut scene, &placed, &cell, style).expect("a scene");
        let surfaces = flatten::surfaces(&scene);
        let all: Vec<_> = surfaces.flat_map(|surface| surface.positions).collect();
        all.iter().fold(f64::INFINITY, |least, p| least.min(p[0]))
    };
    let usual = bounds(Style::default());
    let moved = bounds(Style {
        origin: Vector3::new(10.0, 0.0, 0.0),
        ..Style::default()
    });
    assert!((moved - usual - 10.0).abs() < 1e-9);
    let bold = bounds(Style {
        boldness: 2.0,
        ..Style::default()
    });
    assert!((bold - 2.0 * usual).abs() < 1e-9, "{usual} {bold}");
}

#[test]
fn too_many_elements_and_impossible_styles_are_refused() {
    let (found, cell) = (elements(225), cell(225));
    let mut scene = Scene::new("a", "b", "c");
    let cells: CellRange = "20".parse().expect("a range");
    let error = add_symmetry_elements(&mut scene, &found, &cell, cells, Shown::default());
    assert!(matches!(error, Err(OverlayError::TooMany(_))));
    assert!(scene.nodes().is_empty());
    let placed = found.within(CellRange::UNIT).expect("few");
    for boldness in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let style = Style {
            boldness,
            ..Style::default()
        };
        let error = add_placed_elements(&mut scene, &placed, &cell, style).expect_err("no rods");
        assert!(matches!(error, OverlayError::Export(_)), "{error}");
    }
    let origin = Vector3::new(f64::NAN, 0.0, 0.0);
    let style = Style {
        origin,
        ..Style::default()
    };
    assert!(add_placed_elements(&mut scene, &placed, &cell, style).is_err());
}
