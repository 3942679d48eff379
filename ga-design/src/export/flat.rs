//! Decides how a pattern of the plane becomes an SVG drawing: seen from above, closed lines filled.

use super::svg::escape;
use super::{ExportError, Line};
use std::fmt::Write;

/// The longer side of the drawing, in pixels.
const SIZE: f64 = 900.0;

/// The room around it, in pixels.
const MARGIN: f64 = 24.0;

/// The width of a line of a motif, of the cell at the origin and of the others, in pixels.
const MOTIF_WIDTH: f64 = 2.0;
const FIRST_WIDTH: f64 = 2.5;
const CELL_WIDTH: f64 = 1.0;

/// The colour of the cell at the origin, which stands out, and of the others.
const FIRST: [u8; 3] = [40, 44, 52];
const OTHERS: [u8; 3] = [176, 182, 192];

/// A drawing of the plane z = 0 from above, x to the right and y upwards.
///
/// ```
/// use ga_design::export::Line;
/// use ga_design::export::flat::FlatDrawing;
///
/// let mut drawing = FlatDrawing::new("A triangle", "Filled, because it is closed.");
/// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// drawing.add(Line::new(corners, true)?, [38, 104, 178]);
/// assert!(drawing.encode()?.contains("fill=\"#2668b2\""));
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FlatDrawing {
    title: String,
    caption: String,
    others: Vec<Line>,
    first: Vec<Line>,
    motifs: Vec<(Line, [u8; 3])>,
}

impl FlatDrawing {
    /// A drawing with nothing in it, its title and its description.
    #[must_use]
    pub fn new(title: impl Into<String>, caption: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            caption: caption.into(),
            others: Vec::new(),
            first: Vec::new(),
            motifs: Vec::new(),
        }
    }

    /// Adds an edge of a cell, below all motifs; those of the first cell are stronger and lie over
    /// those of the others, with which they are shared.
    pub fn add_cell_edge(&mut self, edge: Line, is_first: bool) {
        if is_first {
            self.first.push(edge);
        } else {
            self.others.push(edge);
        }
    }

    /// Adds a line of a motif in a colour; a closed one is filled.
    pub fn add(&mut self, line: Line, colour: [u8; 3]) {
        self.motifs.push((line, colour));
    }

    /// The text of the SVG file: a path of class `cell` for each edge, one of class `motif` for each
    /// line of a motif.
    ///
    /// # Errors
    /// [`ExportError::EmptyScene`] if there is no line.
    pub fn encode(&self) -> Result<String, ExportError> {
        let motifs = self.motifs.iter().map(|(line, _)| line);
        let all = self.others.iter().chain(&self.first).chain(motifs);
        let points = all
            .flat_map(Line::points)
            .map(|[x, y, _]| glam::DVec3::new(*x, -*y, 0.0));
        let Some([low, high]) = crate::mesh::bounds(points) else {
            return Err(ExportError::EmptyScene {
                scene: self.title.clone(),
            });
        };
        let [low, high] = [low, high].map(glam::DVec3::from);
        let extent = high - low;
        // A drawing without extent, or nearly so, is a dot.
        let scale = Some(SIZE / extent.max_element())
            .filter(|scale| scale.is_finite())
            .unwrap_or(1.0);
        let frame = Frame {
            low: [low.x, low.y],
            scale,
        };
        let [width, height] = [extent.x, extent.y].map(|side| side * scale + 2.0 * MARGIN);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.2}\" height=\"{height:.2}\" \
             viewBox=\"0 0 {width:.2} {height:.2}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
             <g stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
            escape(&self.title),
            escape(&self.caption),
        );
        for (edges, colour, width) in [
            (&self.others, OTHERS, CELL_WIDTH),
            (&self.first, FIRST, FIRST_WIDTH),
        ] {
            for edge in edges {
                let style = format!(
                    "class=\"cell\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"",
                    hexadecimal(colour)
                );
                frame.write(&mut text, edge, &style);
            }
        }
        for (line, colour) in &self.motifs {
            let colour = hexadecimal(*colour);
            let style = if line.is_closed() {
                format!("class=\"motif\" fill=\"{colour}\"")
            } else {
                format!(
                    "class=\"motif\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{MOTIF_WIDTH}\""
                )
            };
            frame.write(&mut text, line, &style);
        }
        text += "</g>\n</svg>\n";
        Ok(text)
    }
}

fn hexadecimal([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Where the plane, y downwards as SVG has it, lies on the page.
struct Frame {
    low: [f64; 2],
    scale: f64,
}

impl Frame {
    fn write(&self, text: &mut String, line: &Line, style: &str) {
        let mut path = String::new();
        for [x, y, _] in line.points() {
            let [low_x, low_y] = self.low;
            let [x, y] = [x - low_x, -y - low_y].map(|side| side * self.scale + MARGIN);
            path.push(if path.is_empty() { 'M' } else { 'L' });
            // Writing to a text cannot fail.
            let _ = write!(path, "{x:.2} {y:.2}");
        }
        if line.is_closed() {
            path.push('Z');
        }
        let _ = writeln!(text, "<path d=\"{path}\" {style}/>");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_no_drawing_and_a_dot_is_one() -> Result<(), ExportError> {
        let mut drawing = FlatDrawing::new("Nothing <yet>", "&");
        assert!(matches!(
            drawing.encode(),
            Err(ExportError::EmptyScene { .. })
        ));
        drawing.add(Line::new(vec![[3.0, 4.0, 5.0]; 2], false)?, [0, 0, 255]);
        let text = drawing.encode()?;
        assert!(
            text.contains("<title>Nothing &lt;yet&gt;</title>"),
            "{text}"
        );
        assert!(text.contains("M24.00 24.00L24.00 24.00\""), "{text}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        Ok(())
    }

    #[test]
    fn y_points_upwards_and_the_first_cell_lies_over_the_others() -> Result<(), ExportError> {
        let mut drawing = FlatDrawing::new("T", "C");
        let line = |to: [f64; 2]| Line::new(vec![[0.0; 3], [to[0], to[1], 0.0]], false);
        drawing.add(line([1.0, 1.0])?, [255, 0, 0]);
        drawing.add_cell_edge(line([2.0, 0.0])?, true);
        drawing.add_cell_edge(line([2.0, 0.0])?, false);
        let text = drawing.encode()?;
        let paths: Vec<_> = text.lines().filter(|l| l.starts_with("<path")).collect();
        assert_eq!(paths.len(), 3);
        assert!(paths[0].contains("#b0b6c0") && paths[1].contains("#282c34"));
        assert!(paths[2].contains("M24.00 474.00L474.00 24.00\""), "{text}");
        Ok(())
    }
}
