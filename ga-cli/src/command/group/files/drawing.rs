//! Decides how a pattern becomes an SVG drawing: filled areas for groups of the plane, lines in space.

use super::super::motif::Outline;
use super::super::scene::{COLOURS, Drawing, FRAME};
use crate::failure::Failure;
use ga_cga::Point;
use ga_design::crystallography::Isometry;
use ga_design::export::svg::{self, escape};
use ga_design::export::{Line, Material, Scene};
use std::fmt::Write;

/// The longer side of a drawing of the plane, in pixels.
const SIZE: f64 = 900.0;

/// The colours of symmetry elements.
const AXIS: [u8; 3] = [24, 150, 112];
const PLANE: [u8; 3] = [204, 92, 140];
const CENTRE: [u8; 3] = [40, 44, 52];

/// The room around it.
const MARGIN: f64 = 24.0;

/// The drawing.
pub fn svg(drawing: &Drawing) -> Result<String, Failure> {
    if drawing.frame.is_flat {
        Ok(flat(drawing))
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

/// A path of the plane, y downwards as SVG has it.
struct Path {
    points: Vec<[f64; 2]>,
    style: String,
    is_closed: bool,
}

/// The plane from above, areas filled.
fn flat(drawing: &Drawing) -> String {
    let frame = &drawing.frame;
    let mut paths = Vec::new();
    let hex = |[red, green, blue]: [u8; 3]| format!("#{red:02x}{green:02x}{blue:02x}");
    let down = |points: Vec<[f64; 3]>| points.iter().map(|[x, y, _]| [*x, -*y]).collect();
    for offset in frame.range.offsets() {
        let origin = frame.along(offset.map(f64::from)).to_array();
        // The cell at the origin stands out.
        let is_first = offset == frame.range.low;
        let (width, shade) = if is_first {
            (2.5, [40, 44, 52])
        } else {
            (1.0, [176, 182, 192])
        };
        for ends in frame.segments() {
            let ends = ends.map(|end| [0, 1, 2].map(|i| end[i] + origin[i]));
            let path = Path {
                points: down(ends.to_vec()),
                style: format!(
                    "class=\"cell\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"",
                    hex(shade)
                ),
                is_closed: false,
            };
            // Edges shared with the first cell are drawn over those of the others.
            if is_first {
                paths.push(path);
            } else {
                paths.insert(0, path);
            }
        }
    }
    for placed in &drawing.parts {
        for isometry in frame.repeated(&placed.isometries) {
            let shade = hex(colour(placed.part.colour, &isometry));
            for outline in &placed.part.lines {
                let style = if outline.is_area {
                    format!("class=\"motif\" fill=\"{shade}\"")
                } else {
                    format!("class=\"motif\" fill=\"none\" stroke=\"{shade}\" stroke-width=\"2\"")
                };
                paths.push(Path {
                    points: down(moved(outline, &isometry)),
                    style,
                    is_closed: outline.is_area,
                });
            }
        }
    }
    written(&frame.title, &frame.caption, &paths)
}

fn written(title: &str, caption: &str, paths: &[Path]) -> String {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for point in paths.iter().flat_map(|path| &path.points) {
        for i in 0..2 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    let extent = [0, 1].map(|i| high[i] - low[i]);
    let largest = extent[0].max(extent[1]);
    let scale = if largest > 0.0 { SIZE / largest } else { 1.0 };
    let [width, height] = extent.map(|side| side * scale + 2.0 * MARGIN);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.2}\" height=\"{height:.2}\" \
         viewBox=\"0 0 {width:.2} {height:.2}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <g stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        escape(title),
        escape(caption),
    );
    for path in paths {
        let mut line = String::new();
        for point in &path.points {
            let [x, y] = [0, 1].map(|i| (point[i] - low[i]) * scale + MARGIN);
            line.push(if line.is_empty() { 'M' } else { 'L' });
            // Writing to a text cannot fail.
            let _ = write!(line, "{x:.2} {y:.2}");
        }
        if path.is_closed {
            line.push('Z');
        }
        let _ = writeln!(text, "<path d=\"{line}\" {}/>", path.style);
    }
    text += "</g>\n</svg>\n";
    text
}
