//! Decides how the pattern of a motif is drawn: copies in two colours, one for each hand, in the frames of
//! their cells.

use super::Arguments;
use super::document::MotifPlace;
use super::motif::{self, MotifShape, Part};
use crate::failure::Failure;
use ga_cga::{Point, Vector3};
use ga_design::crystallography::general_position::distance_to_images;
use ga_design::crystallography::motif::add_instances;
use ga_design::crystallography::overlay::{Shown, add_symmetry_elements};
use ga_design::crystallography::{
    Cell, CellRange, Coincidence, Isometry, Pattern, SymmetryElements, general_position,
};
use ga_design::export::{ExportError, Material, MaterialId, Placement, Scene, View};
use ga_design::mesh::{self, Ends, Mesh, MeshError};

/// The colours of the copies, by their hand.
pub use ga_design::crystallography::plane_pattern::COLOURS;

/// The colour of the frames of cells.
pub const FRAME: [u8; 3] = [110, 116, 128];

/// The part of the room around a motif that it fills.
const FILLED: f64 = 0.96;

/// The most copies in one drawing.
const MOST_COPIES: u64 = 50_000;

/// The most triangles in one drawing.
const MOST_TRIANGLES: u64 = 20_000_000;

/// The distance of a motif from the centre of a point group, in ångström.
const FROM_CENTRE: f64 = 10.0;

/// The radius of the bars of a frame over the mean edge.
const BAR: f64 = 0.006;

/// A group as it is to be drawn.
pub struct Frame {
    /// The title of the scene.
    pub title: String,
    /// Its caption.
    pub caption: String,
    /// The isometries modulo the translations.
    pub isometries: Vec<Isometry>,
    /// The cell; none for point groups.
    pub cell: Option<Cell>,
    /// Its edges.
    pub edges: [Vector3; 3],
    /// Along which of them there are translations.
    pub periodic: [bool; 3],
    /// Whether it is a group of the plane.
    pub is_flat: bool,
    /// The cells to be built.
    pub range: CellRange,
    /// Where the motif is, in fractions of the edges, if that is said.
    pub place: Option<[f64; 3]>,
    /// The symmetry elements to be drawn.
    pub elements: Option<SymmetryElements>,
}

/// A pattern, ready to be drawn.
pub struct Drawing {
    /// The group.
    pub frame: Frame,
    /// The motif, in its place.
    pub parts: Vec<Placed>,
    told: MotifPlace,
}

/// A part of the motif in its place, and the isometries that make its copies in the unit cell.
pub struct Placed {
    /// The part, in space.
    pub part: Part,
    /// The isometries, of coincident copies the first.
    pub isometries: Vec<Isometry>,
}

impl Drawing {
    /// Finds the motif, its place and its size.
    pub fn new(arguments: &Arguments, frame: Frame) -> Result<Self, Failure> {
        let shape = motif::find(arguments.motif.as_deref(), frame.is_flat)?;
        let (place, clearance) = frame.place();
        // Alone in space, it may be as large as a cell.
        let room = clearance.min(1.2 * FROM_CENTRE);
        let size = arguments.size.unwrap_or(FILLED * room / 2.0);
        let isometries = frame.gathered(place);
        let told = MotifPlace {
            name: shape.name.clone(),
            place: frame.fractions(place),
            size,
            copies: isometries.len() as u64 * frame.range.count(),
            cells: [frame.range.low, frame.range.high],
        };
        check_size(&shape, told.copies)?;
        let parts = shape.parts.into_iter().map(|part| {
            let part = put(part, place, size).map_err(ExportError::from)?;
            Ok(Placed {
                isometries: distinct(&part, &isometries, size)?,
                part,
            })
        });
        Ok(Self {
            parts: parts.collect::<Result<_, Failure>>()?,
            frame,
            told,
        })
    }

    /// What is told of the motif.
    pub fn place(&self) -> MotifPlace {
        self.told.clone()
    }

    /// The surfaces.
    pub fn scene(&self) -> Result<Scene, Failure> {
        let frame = &self.frame;
        let mut scene = Scene::new("group", frame.title.clone(), frame.caption.clone());
        if frame.is_flat {
            scene.set_view(from_above())?;
        }
        let hands = ["turned", "mirrored"];
        let mut colours = Vec::new();
        for (name, colour) in hands.into_iter().zip(COLOURS) {
            colours.push(material(&mut scene, name, colour, 1.0)?);
        }
        for placed in &self.parts {
            let Part { name, opacity, .. } = &placed.part;
            let of_part = match placed.part.colour {
                Some(colour) => [material(&mut scene, name, colour, *opacity)?; 2],
                None => match colours.as_slice() {
                    [turned, mirrored] => [*turned, *mirrored],
                    _ => continue,
                },
            };
            let all = frame.repeated(&placed.isometries);
            add_instances(&mut scene, name, &placed.part.mesh, of_part, all)?;
        }
        self.add_frame(&mut scene)?;
        if let (Some(elements), Some(cell)) = (&frame.elements, &frame.cell) {
            add_symmetry_elements(&mut scene, elements, cell, frame.range, Shown::default())
                .map_err(|reason| Failure::Usage(reason.to_string()))?;
        }
        Ok(scene)
    }

    /// The bars around each cell.
    fn add_frame(&self, scene: &mut Scene) -> Result<(), Failure> {
        let segments = self.frame.segments();
        if segments.is_empty() {
            return Ok(());
        }
        let edges = self.frame.edges.map(|edge| edge.norm());
        let bar = BAR * edges.iter().sum::<f64>() / 3.0;
        let bars: Result<Vec<Mesh>, MeshError> = segments
            .iter()
            .map(|ends| mesh::tube(ends, Ends::Capped, bar, 10))
            .collect();
        let bars = Mesh::joined(&bars.map_err(ExportError::from)?).map_err(ExportError::from)?;
        let shape = scene.add_shape("cell", bars);
        let grey = Material::new("cell", FRAME).with_roughness(0.6)?;
        let grey = scene.add_material(grey);
        for offset in self.frame.range.offsets() {
            let origin = self.frame.along(offset.map(f64::from));
            let placement = Placement::at(origin.to_array())?;
            scene.add_node("cell", shape, grey, placement)?;
        }
        Ok(())
    }
}

impl Frame {
    /// The vector of these fractions of the edges.
    pub fn along(&self, fractions: [f64; 3]) -> Vector3 {
        let terms = self.edges.iter().zip(fractions);
        terms.fold(Vector3::default(), |sum, (edge, part)| sum + *edge * part)
    }

    /// The fractions of the edges at a point; where there are no edges, its coordinates.
    fn fractions(&self, point: Point) -> [f64; 3] {
        let place = point.position().to_array();
        match &self.cell {
            Some(cell) => cell.fractional(place),
            None => place,
        }
    }

    /// The middle of the motif, in fractions of the edges.
    pub fn middle(&self) -> [f64; 3] {
        let (place, _) = self.place();
        self.fractions(place)
    }

    /// Where the motif goes, and the distance to its nearest image.
    fn place(&self) -> (Point, f64) {
        let lattice: Vec<Vector3> = self
            .edges
            .iter()
            .zip(self.periodic)
            .filter(|(_, along)| *along)
            .map(|(edge, _)| *edge)
            .collect();
        if let Some(place) = self.place {
            let point = Point::from(self.along(place));
            return (point, distance_to_images(&self.isometries, &lattice, point));
        }
        if self.cell.is_none() {
            let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let sides = unit.map(|side| Vector3::from(side) * 2.0);
            let corner = Point::at(-1.0, -1.0, -1.0);
            let found = general_position(&self.isometries, &[], corner, sides);
            let direction = found.point.position().normalized().unwrap_or(sides[0]);
            let point = Point::from(direction * FROM_CENTRE);
            return (point, distance_to_images(&self.isometries, &[], point));
        }
        // Across the translations the motif stays near the middle, above as well as below.
        let mut corner = Vector3::default();
        let mut sides = self.edges;
        for (at, side) in sides.iter_mut().enumerate() {
            if !self.periodic[at] {
                let is_across = self.is_flat && at == 2;
                *side *= if is_across { 0.0 } else { 0.7 };
                corner -= *side * 0.5;
            }
        }
        let found = general_position(&self.isometries, &lattice, Point::from(corner), sides);
        (found.point, found.clearance)
    }

    /// The isometries, each up to translations, that carry a point into the unit cell.
    fn gathered(&self, point: Point) -> Vec<Isometry> {
        let all = self.isometries.iter();
        all.map(|isometry| {
            let image = self.fractions(isometry.apply(point));
            let back = [0, 1, 2].map(|i| {
                // A point less than a millionth below a face is on it.
                let cells = (image[i] + 1e-6).floor();
                if self.periodic[i] { -cells } else { 0.0 }
            });
            Isometry::translation(self.along(back)).after(isometry)
        })
        .collect()
    }

    /// The isometries in every cell of the block.
    pub fn repeated(&self, isometries: &[Isometry]) -> Vec<Isometry> {
        let pattern = Pattern::on_lattice(isometries.to_vec(), self.edges, self.range);
        pattern
            .isometries()
            .map(|(_, _, isometry)| isometry)
            .collect()
    }

    /// The edges of a cell, as far as there are translations along them; of a line with marks at its ends.
    pub fn segments(&self) -> Vec<[[f64; 3]; 2]> {
        let periodic: Vec<Vector3> = self
            .edges
            .iter()
            .zip(self.periodic)
            .filter(|(_, along)| *along)
            .map(|(edge, _)| *edge)
            .collect();
        let zero = Vector3::default();
        let between = |from: Vector3, to: Vector3| [from.to_array(), to.to_array()];
        match periodic.as_slice() {
            [_, _, _] => mesh::cell_edges([0.0; 3], self.edges.map(|edge| edge.to_array())),
            [a, b] => vec![
                between(zero, *a),
                between(*a, *a + *b),
                between(*a + *b, *b),
                between(*b, zero),
            ],
            [axis] => {
                let mut marks = vec![between(zero, *axis)];
                for (edge, along) in self.edges.iter().zip(self.periodic) {
                    let is_across = self.is_flat && *edge == self.edges[2];
                    if !along && !is_across {
                        let half = *edge * 0.06;
                        marks.push(between(-half, half));
                        marks.push(between(*axis - half, *axis + half));
                    }
                }
                marks
            }
            _ => Vec::new(),
        }
    }
}

/// From above, x to the right and y upwards.
pub fn from_above() -> View {
    View {
        azimuth: -std::f64::consts::FRAC_PI_2,
        elevation: std::f64::consts::FRAC_PI_2,
    }
}

fn material(
    scene: &mut Scene,
    name: &str,
    colour: [u8; 3],
    opacity: f64,
) -> Result<MaterialId, Failure> {
    let material = Material::new(name, colour).with_roughness(0.38)?;
    Ok(scene.add_material(material.with_opacity(opacity)?))
}

/// Refuses what would take hours or fill the memory.
fn check_size(shape: &MotifShape, copies: u64) -> Result<(), Failure> {
    let parts = shape.parts.len() as u64;
    let triangles: u64 = shape
        .parts
        .iter()
        .map(|part| part.mesh.triangles().len() as u64)
        .sum();
    let nodes = copies.saturating_mul(parts);
    let drawn = copies.saturating_mul(triangles);
    if nodes > MOST_COPIES || drawn > MOST_TRIANGLES {
        return Err(Failure::Usage(format!(
            "--cells: the drawing would have {nodes} copies with {drawn} triangles, more than \
             {MOST_COPIES} or {MOST_TRIANGLES}; ask for fewer cells, such as 2x2x2, or a simpler motif"
        )));
    }
    Ok(())
}

/// A part of this size in its place.
fn put(part: Part, place: Point, size: f64) -> Result<Part, MeshError> {
    let origin = place.position().to_array();
    let moved = |p: &[f64; 3]| [0, 1, 2].map(|i| origin[i] + size * p[i]);
    let positions = part.mesh.positions().iter().map(moved).collect();
    let mesh = Mesh::new(
        positions,
        part.mesh.normals().to_vec(),
        part.mesh.triangles().to_vec(),
    )?;
    let mut lines = part.lines;
    for line in &mut lines {
        line.points = line.points.iter().map(moved).collect();
    }
    Ok(Part {
        mesh,
        lines,
        centre: part.centre.as_ref().map(moved),
        ..part
    })
}

/// The isometries whose copies differ.
fn distinct(part: &Part, isometries: &[Isometry], size: f64) -> Result<Vec<Isometry>, Failure> {
    let pattern = Pattern::of_isometries(isometries.to_vec());
    let when = Coincidence {
        distance: 1e-4 * size,
        ..Coincidence::default()
    };
    let wrong = |reason: &dyn std::fmt::Display| Failure::Usage(format!("--motif: {reason}"));
    let kept: Vec<usize> = match part.centre {
        Some(centre) => {
            let copies = pattern.distinct(&Point::from(Vector3::from(centre)), &when);
            let copies = copies.map_err(|reason| wrong(&reason))?;
            copies.iter().map(|copy| copy.operation).collect()
        }
        None => {
            let copies = pattern.distinct(&part.mesh, &when);
            let copies = copies.map_err(|reason| wrong(&reason))?;
            copies.iter().map(|copy| copy.operation).collect()
        }
    };
    Ok(kept
        .into_iter()
        .filter_map(|at| isometries.get(at).copied())
        .collect())
}
