//! Decides how lines become an SVG drawing: in parallel projection, the farther ones first.

use super::{ExportError, Format, Scene, flatten, picture::camera::axes};
use glam::DVec3;

/// The longer side of the drawing, in pixels.
const SIZE: f64 = 800.0;

/// The room around the drawing, in pixels.
const MARGIN: f64 = 20.0;

/// The text of an SVG file with every line of the scene, seen from the scene's view; surfaces are
/// left out.
///
/// # Errors
/// [`ExportError`] if the scene has no line.
pub fn encode(scene: &Scene) -> Result<String, ExportError> {
    scene.check_not_empty()?;
    let [right, up, towards] = axes(scene.view());
    let mut lines: Vec<_> = flatten::lines(scene).collect();
    let nearness = |line: &flatten::PlacedLine| {
        let sum: f64 = line
            .points
            .iter()
            .map(|&p| DVec3::from(p).dot(towards))
            .sum();
        sum / line.points.len() as f64
    };
    lines.sort_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    let project = |point: [f64; 3]| {
        let point = DVec3::from(point);
        DVec3::new(point.dot(right), -point.dot(up), 0.0)
    };
    let points = lines
        .iter()
        .flat_map(|line| line.points.iter().map(|&p| project(p)));
    let Some([least, greatest]) = crate::mesh::bounds(points) else {
        return Err(ExportError::NothingToHold {
            scene: scene.title().to_owned(),
            format: Format::Svg,
            needed: "lines",
        });
    };
    let [least, extent] = [
        DVec3::from(least),
        DVec3::from(greatest) - DVec3::from(least),
    ];
    let largest = extent.max_element();
    // A drawing without extent, or nearly so, is a dot.
    let scale = Some(SIZE / largest)
        .filter(|s| s.is_finite())
        .unwrap_or(1.0);
    let [width, height, _] = (extent * scale + 2.0 * MARGIN).to_array();
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.2}\" height=\"{height:.2}\" \
         viewBox=\"0 0 {width:.2} {height:.2}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n\
         <g fill=\"none\" stroke-width=\"1.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        escape(scene.title()),
        escape(scene.caption()),
    );
    for line in &lines {
        let [red, green, blue] = line.material.color();
        let mut path = String::new();
        for &point in &line.points {
            let place = (project(point) - least) * scale + MARGIN;
            path.push(if path.is_empty() { 'M' } else { 'L' });
            path += &format!("{:.3} {:.3}", place.x, place.y);
        }
        if line.closed {
            path.push('Z');
        }
        text += &format!(
            "<path d=\"{path}\" stroke=\"#{red:02x}{green:02x}{blue:02x}\" \
             stroke-opacity=\"{:.3}\"><title>{}</title></path>\n",
            line.material.opacity(),
            escape(line.name),
        );
    }
    text += "</g>\n</svg>\n";
    Ok(text)
}

/// The text with the characters that XML and HTML give a meaning to spelled out, and without
/// control characters, which XML does not allow.
///
/// ```
/// use ga_design::export::svg::escape;
/// assert_eq!(escape("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
/// ```
#[must_use]
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
