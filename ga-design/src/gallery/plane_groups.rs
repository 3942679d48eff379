//! The 17 plane groups (appendix B): a comma, repeated by each of them, in rows by their lattices.

use super::GalleryError;
use super::motif::face;
use super::palette::{SLATE, solid};
use crate::crystallography::motif::add_instances;
use crate::crystallography::plane_pattern::COLOURS;
use crate::crystallography::{
    CellRange, Isometry, PlanePattern, SubperiodicGroup, SubperiodicKind,
};
use crate::export::{Attachment, MaterialId, Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::{Point, Vector3};
use std::f64::consts::FRAC_PI_2;

mod lettering;

/// The numbers of the groups, row by row: without rotations of order above 2 and with, square, hexagonal.
const ROWS: [&[u32]; 4] = [
    &[1, 2, 3, 4, 5],
    &[6, 7, 8, 9],
    &[10, 11, 12],
    &[13, 14, 15, 16, 17],
];

/// The room for a pattern, and the distances of neighbours and rows.
const ROOM: [f64; 2] = [1.0, 0.74];
const ACROSS: f64 = 1.12;
const DOWN: f64 = 1.0;

/// The height of the lettering, and how far its foot is below the pattern.
const LETTERS: f64 = 0.1;
const BELOW: f64 = 0.17;

/// The cells of a panel, and those of a drawing.
const CELLS: CellRange = CellRange {
    low: [0; 3],
    high: [2, 2, 1],
};
const DRAWN: CellRange = CellRange {
    low: [0; 3],
    high: [4, 3, 1],
};

/// A pattern that fills its room, the vector by which it is moved there, and the middle of its panel.
struct Panel {
    pattern: PlanePattern,
    shift: Vector3,
    middle: [f64; 2],
}

fn panels() -> Result<Vec<Panel>, GalleryError> {
    let mut panels = Vec::new();
    for (row, numbers) in ROWS.into_iter().enumerate() {
        for (column, number) in numbers.iter().enumerate() {
            let group = SubperiodicGroup::standard(SubperiodicKind::Plane, *number);
            let group = group.ok_or(GalleryError::Degenerate {
                what: "a plane group of this number",
            })?;
            let middle = [
                (column as f64 - (numbers.len() - 1) as f64 / 2.0) * ACROSS,
                -(row as f64) * DOWN,
            ];
            let [width, height] =
                extent(&PlanePattern::new(group, 1.0)?).map(|[low, high]| high - low);
            let [wide, high] = ROOM;
            let pattern = PlanePattern::new(group, (wide / width).min(high / height))?;
            let [x, y] = extent(&pattern).map(|[low, high]| (low + high) / 2.0);
            let shift = Vector3::new(middle[0] - x, middle[1] - y, 0.0);
            panels.push(Panel {
                pattern,
                shift,
                middle,
            });
        }
    }
    Ok(panels)
}

/// From where to where the cells of a pattern reach, along x and y.
fn extent(pattern: &PlanePattern) -> [[f64; 2]; 2] {
    let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for [x, y, _] in CELLS.offsets().flat_map(|offset| pattern.outline(offset)) {
        for ([low, high], value) in extent.iter_mut().zip([x, y]) {
            *low = low.min(value);
            *high = high.max(value);
        }
    }
    extent
}

/// The symbol without blanks, for names.
fn name(group: &SubperiodicGroup) -> String {
    group.symbol.replace(' ', "")
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "plane-groups",
        "The 17 plane groups",
        "All ways to repeat a comma in the plane: blue where it was turned or moved, orange where it was \
         mirrored; the cell at the origin has a dark frame. First row: oblique p1 and p2, rectangular pm, pg \
         and cm. Second row: rectangular p2mm, p2mg, p2gg and c2mm. Third row: square p4, p4mm and \
         p4gm. Last row: hexagonal p3, p3m1, p31m, p6 and p6mm. Each is an SVG drawing, too.",
    );
    let [turned, mirrored] = COLOURS;
    let materials = [
        scene.add_material(solid("turned", turned)?),
        scene.add_material(solid("mirrored", mirrored)?),
    ];
    let frames = [
        scene.add_material(solid("first cell", [40, 44, 52])?),
        scene.add_material(solid("cell", [176, 182, 192])?),
    ];
    let paper = scene.add_material(solid("paper", [246, 247, 249])?);
    scene.add("paper", sheet()?, paper)?;
    let ink = scene.add_material(solid("symbol", SLATE)?);
    for Panel {
        pattern,
        shift,
        middle,
    } in panels()?
    {
        let name = name(pattern.group());
        let into_place = Isometry::translation(shift);
        let copies = pattern.copies(CELLS);
        let copies = copies.iter().map(|copy| into_place.after(copy));
        add_instances(&mut scene, &name, &pattern.motif()?, materials, copies)?;
        add_frames(&mut scene, &name, &pattern, shift, frames)?;
        let [x, y] = middle;
        let foot = [x, y - ROOM[1] / 2.0 - BELOW];
        scene.add(
            &format!("symbol of {name}"),
            lettering::written(&name, foot, LETTERS)?,
            ink,
        )?;
        scene.attach(Attachment {
            svg: pattern.drawing(DRAWN)?.encode()?,
            name,
        });
    }
    scene.set_view(View {
        azimuth: -FRAC_PI_2,
        elevation: FRAC_PI_2,
    })?;
    Ok(scene)
}

/// A flat box below all panels, for their shadows to fall on.
fn sheet() -> Result<Mesh, GalleryError> {
    let half = 2.5 * ACROSS + 0.1;
    let [low, high] = [-3.0 * DOWN - 0.78, 0.54];
    let corners = [[-half, low], [half, low], [half, high], [-half, high]];
    let at = |[x, y]: [f64; 2], z: f64| Point::at(x, y, z);
    let [top, bottom] = [-0.008, -0.03].map(|z| corners.map(|corner| at(corner, z)));
    let [a, b, c, d] = bottom;
    let mut faces = vec![face(&top)?, face(&[d, c, b, a])?];
    for (from, to) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        faces.push(face(&[bottom[from], bottom[to], top[to], top[from]])?);
    }
    Ok(Mesh::joined(&faces)?)
}

/// The edges of the cells as rods.
fn add_frames(
    scene: &mut Scene,
    name: &str,
    pattern: &PlanePattern,
    shift: Vector3,
    [first, others]: [MaterialId; 2],
) -> Result<(), GalleryError> {
    let mut rest = Vec::new();
    for offset in CELLS.offsets() {
        let is_first = offset == CELLS.low;
        let radius = if is_first { 0.006 } else { 0.0035 };
        let corners = pattern.outline(offset);
        let corners = corners.map(|corner| (Vector3::from(corner) + shift).to_array());
        let frame = mesh::tube(&corners, Ends::Closed, radius, 8)?;
        if is_first {
            scene.add(&format!("first cell of {name}"), frame, first)?;
        } else {
            rest.push(frame);
        }
    }
    scene.add(&format!("cells of {name}"), Mesh::joined(&rest)?, others)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::Shape;

    /// The symbols with the commas of either hand in a cell: the multiplicities of the general positions
    /// in International Tables A, table 2.2.6, half of them mirrored where there are reflections or glides.
    const HANDS: [(&str, usize, usize); 17] = [
        ("p1", 1, 0),
        ("p2", 2, 0),
        ("pm", 1, 1),
        ("pg", 1, 1),
        ("cm", 2, 2),
        ("p2mm", 2, 2),
        ("p2mg", 2, 2),
        ("p2gg", 2, 2),
        ("c2mm", 4, 4),
        ("p4", 4, 0),
        ("p4mm", 4, 4),
        ("p4gm", 4, 4),
        ("p3", 3, 0),
        ("p3m1", 3, 3),
        ("p31m", 3, 3),
        ("p6", 6, 0),
        ("p6mm", 6, 6),
    ];

    /// Vertices of the comma that no symmetry exchanges.
    const MARKS: [usize; 4] = [0, 20, 41, 80];

    type Marks = [[f64; 2]; 4];

    /// The commas of a panel in fractions of its edges, and whether they are mirrored.
    fn commas(scene: &Scene, panel: &Panel) -> Vec<(Marks, bool)> {
        let prefix = format!("{} ", name(panel.pattern.group()));
        let nodes = scene
            .placed()
            .filter(|(node, ..)| node.name.starts_with(&prefix));
        let commas = nodes.map(|(node, shape, material)| {
            let Shape::Surface(mesh) = shape else {
                panic!("a comma is a surface");
            };
            let marks = MARKS.map(|at| {
                let point = Vector3::from(node.placement.apply(mesh.positions()[at])) - panel.shift;
                let [x, y, _] = panel.pattern.cell().fractional(point.to_array());
                [x, y]
            });
            (marks, material.name() == "mirrored")
        });
        commas.collect()
    }

    /// Whether one comma is the other, moved by whole edges.
    fn is_same((one, mirrored): &(Marks, bool), other: &(Marks, bool)) -> bool {
        let apart = |at: usize, axis: usize| one[at][axis] - other.0[at][axis];
        let whole = [0, 1].map(|axis| apart(0, axis).round());
        let fits = |at: usize| (0..2).all(|axis| (apart(at, axis) - whole[axis]).abs() < 1e-6);
        *mirrored == other.1 && (0..MARKS.len()).all(fits)
    }

    #[test]
    fn the_copies_of_every_panel_are_invariant_under_its_group_and_no_fewer() {
        let scene = scene().unwrap();
        let panels = panels().unwrap();
        assert_eq!(panels.len(), HANDS.len());
        for (panel, (symbol, turned, mirrored)) in panels.iter().zip(HANDS) {
            let group = panel.pattern.group();
            assert_eq!(name(group), symbol);
            let commas = commas(&scene, panel);
            let cells = CELLS.count() as usize;
            let found = commas.iter().filter(|(_, mirrored)| *mirrored).count();
            let counted = (commas.len() - found, found);
            assert_eq!(counted, (cells * turned, cells * mirrored), "{symbol}");
            // The operations by the Hall symbol, which shares nothing with the generators.
            let operations = group.operations().unwrap();
            assert_eq!(operations.len(), turned + mirrored, "{symbol}");
            for operation in &operations {
                let [[a, b, _], [c, d, _], _] = operation.rotation();
                let turns_over = a * d - b * c < 0;
                for (marks, mirrored) in &commas {
                    let image = marks.map(|[x, y]| {
                        let [x, y, _] = operation.apply([x, y, 0.0]);
                        [x, y]
                    });
                    let image = (image, *mirrored != turns_over);
                    // One in each cell.
                    let same = commas.iter().filter(|comma| is_same(&image, comma));
                    assert_eq!(same.count(), cells, "{symbol}: {operation}");
                }
            }
        }
    }

    #[test]
    fn a_pattern_of_another_group_is_told_apart() {
        let scene = scene().unwrap();
        let panels = panels().unwrap();
        let [pm, p4gm] = [3, 12].map(|number| {
            let found = panels
                .iter()
                .find(|panel| panel.pattern.group().number == number);
            found.expect("all are there")
        });
        let commas = commas(&scene, pm);
        let operations = p4gm.pattern.group().operations().unwrap();
        let kept = operations.iter().all(|operation| {
            let [[a, b, _], [c, d, _], _] = operation.rotation();
            commas.iter().all(|(marks, mirrored)| {
                let image = marks.map(|[x, y]| {
                    let [x, y, _] = operation.apply([x, y, 0.0]);
                    [x, y]
                });
                let image = (image, *mirrored != (a * d - b * c < 0));
                commas.iter().any(|comma| is_same(&image, comma))
            })
        });
        assert!(!kept);
    }

    #[test]
    fn each_group_has_a_drawing_with_the_commas_of_both_hands() {
        let scene = scene().unwrap();
        assert_eq!(scene.attachments().len(), HANDS.len());
        let cells = DRAWN.count() as usize;
        for (drawing, (symbol, turned, mirrored)) in scene.attachments().iter().zip(HANDS) {
            assert_eq!(drawing.name, symbol);
            let page = roxmltree::Document::parse(&drawing.svg).unwrap();
            let of = |class: &str, fill: &str| {
                let paths = page.descendants().filter(|node| node.has_tag_name("path"));
                let paths = paths.filter(|node| {
                    (node.attribute("class"), node.attribute("fill")) == (Some(class), Some(fill))
                });
                paths.count()
            };
            let counted = [of("motif", "#2668b2"), of("motif", "#e27024")];
            assert_eq!(
                counted,
                [turned, mirrored].map(|hand| hand * cells),
                "{symbol}"
            );
            assert_eq!(of("cell", "none"), 4 * cells);
        }
    }

    #[test]
    fn nothing_lies_outside_the_sheet_and_no_panel_in_another() {
        let panels = panels().unwrap();
        let boxes: Vec<_> = panels
            .iter()
            .map(|panel| {
                let [x, y, _] = panel.shift.to_array();
                let [[left, right], [low, high]] = extent(&panel.pattern);
                [left + x, right + x, low + y, high + y]
            })
            .collect();
        let [least, greatest] = sheet().unwrap().bounds();
        for (at, [left, right, low, high]) in boxes.iter().enumerate() {
            assert!(least[0] < *left && *right < greatest[0]);
            assert!(least[1] < *low - BELOW && *high < greatest[1]);
            for [a, b, c, d] in &boxes[..at] {
                assert!(b < left || right < a || d < low || high < c);
            }
        }
    }
}
