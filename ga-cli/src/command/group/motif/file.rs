//! Decides how a motif is read from a file: OBJ and STL surfaces, XYZ atoms; and how it is brought to the
//! size of the unit ball.

use super::{MotifShape, Outline, Part};
use crate::failure::Failure;
use ga_design::crystallography::xyz;
use ga_design::mesh::{self, Mesh};
use std::fs;
use std::io::{BufReader, Cursor, ErrorKind};
use std::path::Path;

/// The largest file that is read, in bytes.
const LARGEST_FILE: u64 = 64 << 20;

/// The most atoms of a motif.
const MOST_ATOMS: usize = 2000;

/// The radius of an atom over its covalent radius.
const RADIUS_SCALE: f64 = 0.5;

/// Edges at which a surface bends by less than the angle with this cosine are not drawn.
const BEND: f64 = 0.94;

/// The bytes of a file.
fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let refused = |reason: std::io::Error| {
        let remedy = match reason.kind() {
            ErrorKind::NotFound => "check its name, or give comma, hand, strut or helix",
            ErrorKind::IsADirectory => "it is a directory: give a file in it",
            ErrorKind::FileTooLarge => "give a motif of fewer triangles or atoms",
            _ => "check that you may read it",
        };
        Failure::Unreadable {
            file: path.to_owned(),
            reason,
            remedy,
        }
    };
    if fs::metadata(path).map_err(refused)?.len() > LARGEST_FILE {
        return Err(refused(ErrorKind::FileTooLarge.into()));
    }
    fs::read(path).map_err(refused)
}

fn wrong(path: &Path, message: impl Into<String>) -> Failure {
    Failure::Motif {
        file: path.to_owned(),
        message: message.into(),
    }
}

/// The surface of an OBJ file; materials are left out.
pub fn obj(path: &Path) -> Result<MotifShape, Failure> {
    let bytes = read(path)?;
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..Default::default()
    };
    let (models, _) = tobj::load_obj_buf(&mut BufReader::new(Cursor::new(bytes)), &options, |_| {
        Ok(Default::default())
    })
    .map_err(|reason| wrong(path, format!("not an OBJ file: {reason}")))?;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for model in &models {
        let first = positions.len() as u32;
        let corners = model.mesh.positions.chunks_exact(3);
        positions.extend(corners.map(|p| [p[0], p[1], p[2]].map(f64::from)));
        let faces = model.mesh.indices.chunks_exact(3);
        triangles
            .extend(faces.map(|t| [t[0], t[1], t[2]].map(|index| index.saturating_add(first))));
    }
    surface(path, positions, triangles)
}

/// The surface of an STL file, binary or text.
pub fn stl(path: &Path) -> Result<MotifShape, Failure> {
    let bytes = read(path)?;
    let promised = bytes.get(80..84).and_then(|count| count.try_into().ok());
    let promised = promised.map(u32::from_le_bytes).map(u64::from);
    let is_text = bytes.starts_with(b"solid") && bytes.is_ascii();
    // A reader would set aside the room that the file promises to fill.
    if !is_text && promised.is_none_or(|count| 84 + 50 * count > bytes.len() as u64) {
        return Err(wrong(
            path,
            "not an STL file, or it is cut off; save it again",
        ));
    }
    let read = stl_io::read_stl(&mut Cursor::new(bytes))
        .map_err(|reason| wrong(path, format!("not an STL file: {reason}")))?;
    let positions = read
        .vertices
        .iter()
        .map(|v| [v[0], v[1], v[2]].map(f64::from));
    let triangles = read.faces.iter().map(|face| {
        // More than 2³² vertices do not fit into a file of this size.
        face.vertices
            .map(|index| u32::try_from(index).unwrap_or(u32::MAX))
    });
    surface(path, positions.collect(), triangles.collect())
}

/// A surface of the size of the unit ball.
fn surface(
    path: &Path,
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
) -> Result<MotifShape, Failure> {
    if triangles.is_empty() {
        return Err(wrong(
            path,
            "it holds no triangles; save it as a mesh of triangles or polygons",
        ));
    }
    if positions.iter().flatten().any(|value| !value.is_finite()) {
        return Err(wrong(path, "a coordinate is no finite number"));
    }
    let (middle, radius) = ball(&positions);
    if radius <= 0.0 || !radius.is_finite() {
        return Err(wrong(
            path,
            "all its points are in one place, or too far apart",
        ));
    }
    let placed = positions
        .iter()
        .map(|p| [0, 1, 2].map(|i| (p[i] - middle[i]) / radius));
    let mesh = Mesh::from_triangles(placed.collect(), triangles)
        .map_err(|reason| wrong(path, reason.to_string()))?;
    let name = name_of(path);
    Ok(MotifShape {
        name: path.display().to_string(),
        parts: vec![Part {
            lines: edges(&mesh),
            name,
            mesh,
            colour: None,
            opacity: 1.0,
            centre: None,
        }],
    })
}

/// The edges at which a surface bends, or ends.
fn edges(mesh: &Mesh) -> Vec<Outline> {
    use std::collections::BTreeMap;
    let at = |index: u32| {
        glam::DVec3::from(
            mesh.positions()
                .get(index as usize)
                .copied()
                .unwrap_or_default(),
        )
    };
    let key = |index: u32| at(index).to_array().map(f64::to_bits);
    let mut faces: BTreeMap<[[u64; 3]; 2], Vec<glam::DVec3>> = BTreeMap::new();
    for &[a, b, c] in mesh.triangles() {
        let normal = (at(b) - at(a)).cross(at(c) - at(a)).normalize_or_zero();
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let mut ends = [key(from), key(to)];
            ends.sort_unstable();
            faces.entry(ends).or_default().push(normal);
        }
    }
    let is_drawn = |normals: &Vec<glam::DVec3>| match normals.as_slice() {
        [one, other] => one.dot(*other) < BEND,
        _ => true,
    };
    faces
        .into_iter()
        .filter(|(_, normals)| is_drawn(normals))
        .map(|(ends, _)| Outline {
            points: ends.map(|end| end.map(f64::from_bits)).to_vec(),
            is_area: false,
        })
        .collect()
}

/// The atoms of an XYZ file.
pub fn atoms(path: &Path) -> Result<MotifShape, Failure> {
    let bytes = read(path)?;
    let text = String::from_utf8(bytes).map_err(|_| wrong(path, "give a text file in UTF-8"))?;
    let atoms = xyz::read(&text).map_err(|reason| wrong(path, reason.to_string()))?;
    if !(1..=MOST_ATOMS).contains(&atoms.len()) {
        let count = atoms.len();
        return Err(wrong(
            path,
            format!("line 1: a motif has from 1 to {MOST_ATOMS} atoms, here are {count}"),
        ));
    }
    let positions: Vec<[f64; 3]> = atoms.iter().map(|(_, place)| *place).collect();
    let (middle, reach) = ball(&positions);
    let largest = atoms
        .iter()
        .map(|(element, _)| RADIUS_SCALE * element.covalent_radius())
        .fold(0.1, f64::max);
    let whole = reach + largest;
    let parts = atoms.iter().map(|(element, place)| {
        let centre = [0, 1, 2].map(|i| (place[i] - middle[i]) / whole);
        let radius = (RADIUS_SCALE * element.covalent_radius()).max(0.1) / whole;
        let unit = mesh::icosphere(2)?;
        let points = unit.positions().iter();
        let points = points.map(|p| [0, 1, 2].map(|i| centre[i] + radius * p[i]));
        Ok(Part {
            name: element.symbol().to_owned(),
            mesh: Mesh::from_triangles(points.collect(), unit.triangles().to_vec())?,
            lines: vec![circle(centre, radius)],
            colour: Some(element.colour()),
            opacity: 1.0,
            centre: Some(centre),
        })
    });
    let parts: Result<Vec<Part>, mesh::MeshError> = parts.collect();
    Ok(MotifShape {
        name: path.display().to_string(),
        parts: parts.map_err(|reason| wrong(path, reason.to_string()))?,
    })
}

/// A sphere's circle in the plane of a and b.
fn circle(centre: [f64; 3], radius: f64) -> Outline {
    let points = (0..24).map(|step| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(step) / 24.0).sin_cos();
        [
            centre[0] + radius * cosine,
            centre[1] + radius * sine,
            centre[2],
        ]
    });
    Outline {
        points: points.collect(),
        is_area: true,
    }
}

/// The middle of the bounding box, and the distance of the farthest point from it.
fn ball(positions: &[[f64; 3]]) -> ([f64; 3], f64) {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for position in positions {
        for i in 0..3 {
            low[i] = low[i].min(position[i]);
            high[i] = high[i].max(position[i]);
        }
    }
    let middle = [0, 1, 2].map(|i| (low[i] + high[i]) / 2.0);
    let far = positions.iter().map(|p| {
        let [x, y, z] = [0, 1, 2].map(|i| p[i] - middle[i]);
        (x * x + y * y + z * z).sqrt()
    });
    (middle, far.fold(0.0, f64::max))
}

/// The name of a file without directory and ending.
fn name_of(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
