//! Decides how a pattern becomes an SVG drawing: filled areas for groups of the plane, lines in space.

use super::super::motif::Outline;
use super::super::scene::{COLOURS, Drawing, FRAME};
use crate::failure::Failure;
use ga_cga::Point;
use ga_design::crystallography::Isometry;
use ga_design::export::flat::FlatDrawing;
use ga_design::export::{Line, Material, Scene, svg};

/// The colours of symmetry elements.
const AXIS: [u8; 3] = [24, 150, 112];
const PLANE: [u8; 3] = [204, 92, 140];
const CENTRE: [u8; 3] = [40, 44, 52];

/// The drawing.
pub fn svg(drawing: &Drawing) -> Result<String, Failure> {
    if drawing.frame.is_flat {
        flat(drawing)
    } else {
        lines(drawing)
    }
}

/// The colour of a copy.
fn colour(own: Option<[u8; 3]>, isometry: &Isometry) -> [u8; 3] {
    let [turned, mirrored] = COLOURS;
    let of_hand = if isometry.is_proper() {
        turned
    } else {
        mirrored
    };
    own.unwrap_or(of_hand)
}

/// The points of a copy of an outline.
fn moved(outline: &Outline, isometry: &Isometry) -> Vec<[f64; 3]> {
    let points = outline.points.iter();
    points
        .map(|[x, y, z]| isometry.apply(Point::at(*x, *y, *z)).position().to_array())
        .collect()
}

/// Lines in space, as every scene is drawn.
fn lines(drawing: &Drawing) -> Result<String, Failure> {
    let frame = &drawing.frame;
    let mut scene = Scene::new("group", frame.title.clone(), frame.caption.clone());
    let mut materials: Vec<([u8; 3], ga_design::export::MaterialId)> = Vec::new();
    let grey = scene.add_material(Material::new("cell", FRAME));
    for offset in frame.range.offsets() {
        let origin = frame.along(offset.map(f64::from)).to_array();
        for ends in frame.segments() {
            let ends = ends.map(|end| [0, 1, 2].map(|i| end[i] + origin[i]));
            scene.add("cell", Line::new(ends.to_vec(), false)?, grey)?;
        }
    }
    for placed in &drawing.parts {
        for isometry in frame.repeated(&placed.isometries) {
            let wanted = colour(placed.part.colour, &isometry);
            let known = materials.iter().find(|(colour, _)| *colour == wanted);
            let material = match known {
                Some((_, material)) => *material,
                None => {
                    let material = scene.add_material(Material::new("copy", wanted));
                    materials.push((wanted, material));
                    material
                }
            };
            for outline in &placed.part.lines {
                let line = Line::new(moved(outline, &isometry), outline.is_area)?;
                scene.add(&placed.part.name, line, material)?;
            }
        }
    }
    add_elements(drawing, &mut scene)?;
    Ok(svg::encode(&scene)?)
}

/// The symmetry elements, if there are any to be drawn: axes as lines, planes and centres as outlines.
fn add_elements(drawing: &Drawing, scene: &mut Scene) -> Result<(), Failure> {
    let (Some(elements), Some(cell)) = (&drawing.frame.elements, &drawing.frame.cell) else {
        return Ok(());
    };
    let placed = elements
        .within(drawing.frame.range)
        .map_err(|reason| Failure::Usage(format!("--symmetry: {reason}")))?;
    let [axes, planes, centres] =
        [AXIS, PLANE, CENTRE].map(|colour| scene.add_material(Material::new("element", colour)));
    let at = |place: &[f64; 3]| cell.cartesian(*place);
    for segment in &placed.axes {
        let line = Line::new(segment.ends.iter().map(at).collect(), false)?;
        scene.add(&segment.axis.to_string(), line, axes)?;
    }
    for polygon in &placed.planes {
        let line = Line::new(polygon.corners.iter().map(at).collect(), true)?;
        scene.add(&polygon.plane.to_string(), line, planes)?;
    }
    let radius = 0.01 * cell.volume().cbrt();
    for centre in &placed.centres {
        let [x, y, z] = at(&centre.point);
        // An octahedron's outline, which is small from every side.
        let corners = [
            [x + radius, y, z],
            [x, y + radius, z],
            [x, y, z + radius],
            [x - radius, y, z],
            [x, y - radius, z],
            [x, y, z - radius],
        ];
        scene.add("-1", Line::new(corners.to_vec(), true)?, centres)?;
    }
    Ok(())
}

/// The plane from above, areas filled.
fn flat(drawing: &Drawing) -> Result<String, Failure> {
    let frame = &drawing.frame;
    let mut flat = FlatDrawing::new(frame.title.clone(), frame.caption.clone());
    for offset in frame.range.offsets() {
        let origin = frame.along(offset.map(f64::from)).to_array();
        for ends in frame.segments() {
            let ends = ends.map(|end| [0, 1, 2].map(|i| end[i] + origin[i]));
            flat.add_cell_edge(Line::new(ends.to_vec(), false)?, offset == frame.range.low);
        }
    }
    for placed in &drawing.parts {
        for isometry in frame.repeated(&placed.isometries) {
            let shade = colour(placed.part.colour, &isometry);
            for outline in &placed.part.lines {
                let line = Line::new(moved(outline, &isometry), outline.is_area)?;
                flat.add(line, shade);
            }
        }
    }
    Ok(flat.encode()?)
}
