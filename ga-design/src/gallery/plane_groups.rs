//! The 17 plane groups (appendix B): a comma, repeated by each of them, in rows by their lattices.

use super::GalleryError;
use super::palette::{SLATE, solid};
use crate::crystallography::motif::add_instances;
use crate::crystallography::plane_pattern::COLOURS;
use crate::crystallography::{
    CellRange, Isometry, PlanePattern, SubperiodicGroup, SubperiodicKind,
};
use crate::export::{Attachment, MaterialId, Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::Vector3;
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
const ROOM: [f64; 2] = [1.0, 0.66];
const ACROSS: f64 = 1.12;
const DOWN: f64 = 0.92;

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
