//! How symmetry elements are drawn into a scene: axes as rods with the conventional symbol at their ends,
//! screws with the helix that they climb, planes as clear sheets with their glide, centres as small balls.

use ga_cga::{Point, Rotor, Vector3};

use super::symmetry_elements::{
    AxisSegment, NoElement, PlacedElements, PlanePolygon, TooManyElements,
};
use super::{Cell, CellRange, SymmetryElements};
use crate::export::{ExportError, Material, MaterialId, Placement, Scene, ShapeId};
use crate::mesh::{self, Ends, Mesh, MeshError};

mod colours;
mod plates;

pub use colours::legend;

use colours::{CENTRE, Colour, of_axis, of_plane};
use plates::plate;

/// The radius of a rod over the cube root of the cell's volume.
const ROD: f64 = 0.0075;

/// The radius of the symbol at an axis's ends, and of the helix of a screw, in radii of the rod.
const SYMBOL: f64 = 5.0;

/// The radius of a helix's own thread and of a plane's outline, in radii of the rod.
const THREAD: f64 = 0.45;

/// The points of one turn of a helix.
const PER_TURN: f64 = 32.0;

/// Why symmetry elements cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum OverlayError {
    /// An operation has none.
    #[error(transparent)]
    NoElement(#[from] NoElement),
    /// There are too many.
    #[error(transparent)]
    TooMany(#[from] TooManyElements),
    /// The scene cannot hold them.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl From<MeshError> for OverlayError {
    fn from(error: MeshError) -> Self {
        Self::Export(error.into())
    }
}

/// Which elements are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Rotation, screw and rotoinversion axes.
    pub axes: bool,
    /// Mirror and glide planes.
    pub planes: bool,
    /// Inversion centres.
    pub centres: bool,
}

impl Default for Shown {
    /// All of them.
    fn default() -> Self {
        Self {
            axes: true,
            planes: true,
            centres: true,
        }
    }
}

/// Where and how boldly elements are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Where the corner of the cell at the lattice's origin is drawn, in ångström.
    pub origin: Vector3,
    /// The thickness of rods, symbols and helices, 1 for the usual.
    pub boldness: f64,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            origin: Vector3::default(),
            boldness: 1.0,
        }
    }
}

/// Adds the symmetry elements in a block of cells to a scene, in ångström; [`legend`] says what their
/// colours mean.
///
/// ```
/// use ga_design::crystallography::overlay::{Shown, add_symmetry_elements, legend};
/// use ga_design::crystallography::{Cell, CellRange, SpaceGroup, SymmetryElements};
/// use ga_design::export::Scene;
///
/// let cell = Cell::new([4.0, 5.0, 6.0], [90.0; 3])?;
/// let group = SpaceGroup::from_symbol("P 21 21 21")?[0];
/// let elements = SymmetryElements::of(&group.operations()?)?;
/// let mut scene = Scene::new("screws", "Screws of P 21 21 21", legend(&elements));
/// add_symmetry_elements(&mut scene, &elements, &cell, CellRange::UNIT, Shown::default())?;
/// assert!(scene.caption().contains("2₁ (blue)"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`OverlayError`] if there are too many elements, or the scene cannot hold them.
pub fn add_symmetry_elements(
    scene: &mut Scene,
    elements: &SymmetryElements,
    cell: &Cell,
    range: CellRange,
    shown: Shown,
) -> Result<(), OverlayError> {
    let mut placed = elements.within(range)?;
    if !shown.axes {
        placed.axes.clear();
    }
    if !shown.planes {
        placed.planes.clear();
    }
    if !shown.centres {
        placed.centres.clear();
    }
    add_placed_elements(scene, &placed, cell, Style::default())
}

/// Adds elements that [`SymmetryElements::within`] found in a block of cells, or a choice of them, to a
/// scene.
///
/// # Errors
/// [`OverlayError`] if the scene cannot hold them.
pub fn add_placed_elements(
    scene: &mut Scene,
    placed: &PlacedElements,
    cell: &Cell,
    style: Style,
) -> Result<(), OverlayError> {
    let mut drawing = Drawing {
        scene,
        cell,
        origin: style.origin,
        rod: ROD * style.boldness * cell.volume().cbrt(),
        materials: Vec::new(),
        shapes: Vec::new(),
    };
    for segment in &placed.axes {
        drawing.axis(segment)?;
    }
    drawing.planes(placed)?;
    for centre in &placed.centres {
        drawing.ball("inversion centre", CENTRE, centre.point, 2.6)?;
    }
    Ok(())
}

/// A scene being drawn into; shapes and materials are added when they are first needed.
struct Drawing<'a> {
    scene: &'a mut Scene,
    cell: &'a Cell,
    origin: Vector3,
    /// The radius of a rod in ångström.
    rod: f64,
    materials: Vec<(&'static str, u8, MaterialId)>,
    shapes: Vec<(String, ShapeId)>,
}

impl Drawing<'_> {
    /// An axis: rod, symbols at both ends, inversion points and the helix of a screw.
    fn axis(&mut self, segment: &AxisSegment) -> Result<(), OverlayError> {
        let axis = segment.axis;
        let colour = of_axis(axis);
        let material = self.material(colour, 100)?;
        let [from, to] = segment.ends.map(|end| self.position(end));
        let along = to - from;
        let length = along.norm();
        let turned = upright_to(along);
        let [u, v, w] = axis.line().direction();
        let name = format!("{axis} [{u} {v} {w}]");
        let rod = self.shape("rod", || mesh::cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, 12))?;
        let place = |at: Vector3, scale: [f64; 3]| {
            Placement::at(at.to_array())?.rotated(turned)?.scaled(scale)
        };
        let placement = place(from, [self.rod, self.rod, length])?;
        self.scene
            .add_node(name.clone(), rod, material, placement)?;
        let size = SYMBOL * self.rod;
        let symbol = self.shape(&format!("symbol {axis}"), || plate(axis))?;
        for end in [from, to] {
            self.scene
                .add_node(name.clone(), symbol, material, place(end, [size; 3])?)?;
        }
        for point in &segment.inversion_points {
            // Those of -3 and n/m are inversion centres, which are drawn as such.
            if matches!(axis.rotoinversion(), Some(4 | 6)) {
                self.ball("inversion point", colour, *point, 2.4)?;
            }
        }
        if let Some(helix) = self.helix(segment, from, length)? {
            self.scene.add(&name, helix, material)?;
        }
        Ok(())
    }

    /// The paths of the screw: as many threads as its lattice translation asks for, in its sense.
    fn helix(
        &self,
        segment: &AxisSegment,
        from: Vector3,
        length: f64,
    ) -> Result<Option<Mesh>, OverlayError> {
        let axis = segment.axis;
        let (order, screw) = (axis.order(), axis.screw());
        if screw == 0 || screw >= order {
            return Ok(None);
        }
        // n_q with q beyond n/2 is a left-handed screw of n − q threads.
        let (threads, sense) = if 2 * screw <= order {
            (screw, 1.0)
        } else {
            (order - screw, -1.0)
        };
        let line = axis.line().line(self.cell);
        let edge = self
            .cell
            .cartesian(axis.line().direction().map(|index| index as f64));
        let period = *axis.period().numer() as f64 / *axis.period().denom() as f64;
        let pitch = Vector3::from(edge).norm() * period * f64::from(threads);
        let turns = length / pitch;
        let count = (turns * PER_TURN).ceil().clamp(2.0, 4096.0) as u32;
        let unit = line.direction();
        let through = Point::from(from);
        let axis_line = ga_cga::DualLine::along(through, unit);
        let side = aside(unit) * (SYMBOL * 0.8 * self.rod);
        let mut parts = Vec::new();
        for thread in 0..threads {
            let start = f64::from(thread) / f64::from(threads);
            let path = (0..=count).filter_map(|i| {
                let part = f64::from(i) / f64::from(count);
                let angle = sense * std::f64::consts::TAU * (turns * part + start);
                let motor = ga_cga::Motor::screw(axis_line, angle, length * part)?;
                let point: Point = motor.apply(Point::from(from + side));
                Some(point.position().to_array())
            });
            let path: Vec<_> = path.collect();
            parts.push(mesh::tube(&path, Ends::Capped, THREAD * self.rod, 8)?);
        }
        Ok(Some(Mesh::joined(&parts)?))
    }

    /// The planes, all of a letter as one sheet and one outline.
    fn planes(&mut self, placed: &PlacedElements) -> Result<(), OverlayError> {
        let mut letters: Vec<char> = placed.planes.iter().map(|p| p.plane.letter()).collect();
        letters.sort_unstable();
        letters.dedup();
        for letter in letters {
            let all = placed.planes.iter().filter(|p| p.plane.letter() == letter);
            let (mut sheets, mut lines) = (Vec::new(), Vec::new());
            for polygon in all {
                sheets.push(self.sheet(polygon)?);
                lines.extend(self.outline(polygon)?);
            }
            let colour = of_plane(letter);
            let (clear, solid) = (self.material(colour, 16)?, self.material(colour, 100)?);
            let name = format!("plane {letter}");
            self.scene.add(&name, Mesh::joined(&sheets)?, clear)?;
            self.scene
                .add(&format!("outline of {name}"), Mesh::joined(&lines)?, solid)?;
        }
        Ok(())
    }

    fn sheet(&self, polygon: &PlanePolygon) -> Result<Mesh, OverlayError> {
        let corners = self.corners(polygon);
        let count = u32::try_from(corners.len()).unwrap_or_default();
        let normal = polygon.plane.dual_plane(self.cell).normal().to_array();
        let triangles = (2..count).map(|i| [0, i - 1, i]).collect();
        let positions: Vec<_> = corners.into_iter().map(Vector3::to_array).collect();
        let normals = vec![normal; positions.len()];
        Ok(Mesh::new(positions, normals, triangles)?)
    }

    fn corners(&self, polygon: &PlanePolygon) -> Vec<Vector3> {
        let corners = polygon.corners.iter();
        corners.map(|corner| self.position(*corner)).collect()
    }

    /// The outline, whole for mirrors and dashed for glides, and the glide's arrow in the middle.
    fn outline(&self, polygon: &PlanePolygon) -> Result<Vec<Mesh>, OverlayError> {
        let corners = self.corners(polygon);
        let radius = THREAD * self.rod;
        let mut parts = Vec::new();
        let next = corners.iter().cycle().skip(1);
        for (from, to) in corners.iter().zip(next) {
            let length = (*to - *from).norm();
            let dashes = if polygon.plane.letter() == 'm' {
                1.0
            } else {
                (length / (12.0 * self.rod)).round().clamp(2.0, 200.0)
            };
            let fill = if dashes == 1.0 { 1.0 } else { 0.6 };
            let mut dash = 0.0;
            while dash < dashes {
                let at = |part: f64| (*from + (*to - *from) * (part / dashes)).to_array();
                parts.push(mesh::cylinder(at(dash), at(dash + fill), radius, 6)?);
                dash += 1.0;
            }
        }
        let sum = corners
            .iter()
            .fold(Vector3::default(), |sum, corner| sum + *corner);
        let middle = sum / corners.len().max(1) as f64;
        for glide in polygon.plane.glides() {
            let fractions = glide.map(|part| *part.numer() as f64 / *part.denom() as f64);
            let step = Vector3::from(self.cell.cartesian(fractions));
            let tip = (middle + step * 0.5).to_array();
            parts.push(mesh::arrow(
                (middle - step * 0.5).to_array(),
                tip,
                self.rod,
                10,
            )?);
        }
        Ok(parts)
    }

    /// A ball of a radius given in radii of the rod.
    fn ball(
        &mut self,
        name: &str,
        colour: Colour,
        point: [f64; 3],
        radius: f64,
    ) -> Result<(), OverlayError> {
        let material = self.material(colour, 100)?;
        let shape = self.shape("ball", || mesh::icosphere(2))?;
        let place = Placement::at(self.position(point).to_array())?;
        let place = place.scaled([radius * self.rod; 3])?;
        Ok(self.scene.add_node(name, shape, material, place)?)
    }

    /// Where a point given in fractions of the cell edges is drawn.
    fn position(&self, fractions: [f64; 3]) -> Vector3 {
        self.origin + Vector3::from(self.cell.cartesian(fractions))
    }

    fn material(&mut self, colour: Colour, percent: u8) -> Result<MaterialId, ExportError> {
        let known = self
            .materials
            .iter()
            .find(|(name, opacity, _)| *name == colour.name && *opacity == percent);
        if let Some((_, _, id)) = known {
            return Ok(*id);
        }
        let name = match percent {
            100 => format!("symmetry, {}", colour.name),
            _ => format!("symmetry, clear {}", colour.name),
        };
        let material = Material::new(name, colour.rgb)
            .with_roughness(0.45)?
            .with_opacity(f64::from(percent) / 100.0)?;
        let id = self.scene.add_material(material);
        self.materials.push((colour.name, percent, id));
        Ok(id)
    }

    fn shape(
        &mut self,
        name: &str,
        make: impl FnOnce() -> Result<Mesh, MeshError>,
    ) -> Result<ShapeId, MeshError> {
        if let Some((_, id)) = self.shapes.iter().find(|(known, _)| known == name) {
            return Ok(*id);
        }
        let id = self.scene.add_shape(name, make()?);
        self.shapes.push((name.to_owned(), id));
        Ok(id)
    }
}

/// The quaternion w x y z that turns the z axis to a direction.
fn upright_to(direction: Vector3) -> [f64; 4] {
    let up = Vector3::new(0.0, 0.0, 1.0);
    // Straight down is half a turn about x away.
    Rotor::between(up, direction).map_or([0.0, 1.0, 0.0, 0.0], |rotor| rotor.to_quaternion())
}

/// A unit vector at right angles to a unit vector.
fn aside(unit: Vector3) -> Vector3 {
    let rotor = Rotor::from_quaternion(upright_to(unit));
    rotor.apply(Vector3::new(1.0, 0.0, 0.0))
}
