//! Decides what a surface is here: an indexed triangle mesh whose every number has been checked.
//!
//! A [`Mesh`] cannot be built wrong: coordinates are finite and of a size that survives single
//! precision, normals are of unit length, indices exist. Exporters and the renderer rely on it and
//! check nothing twice. The generators in the submodules make the shapes that structures are drawn
//! with. Lengths are in the unit of the scene; z points up; triangles wind anticlockwise seen from
//! outside.

mod cylinder;
mod flat;
mod frame;
mod sphere;
mod torus;
mod tube;

pub use cylinder::{arrow, cone, cylinder};
pub use flat::{disc, parallelogram};
pub use frame::{box_edges, cell_edges};
pub use sphere::{icosphere, uv_sphere};
pub use torus::torus;
pub use tube::{Ends, tube};

use glam::DVec3;
use thiserror::Error;

/// The largest absolute coordinate: its square still fits single precision, so that a viewer can
/// compute lengths without overflow.
pub const LARGEST_COORDINATE: f64 = 1e18;

/// How far the squared length of a normal may be from one.
const NORMAL_TOLERANCE: f64 = 1e-3;

/// Why a mesh could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no triangle, or no vertex.
    #[error("the mesh is empty: give it at least one triangle")]
    Empty,
    /// A coordinate is NaN, infinite, or beyond [`LARGEST_COORDINATE`].
    #[error("{what} is {value}: coordinates must be finite and at most 1e18 in size")]
    Coordinate {
        /// Which number it is.
        what: &'static str,
        /// The number itself.
        value: f64,
    },
    /// A normal is not of unit length.
    #[error("normal {index} has length {length}: normals must have unit length")]
    Normal {
        /// Position in the list of normals.
        index: usize,
        /// Its length.
        length: f64,
    },
    /// There is not one normal for each position.
    #[error("{positions} positions but {normals} normals: give one normal for each position")]
    Lengths {
        /// The number of positions.
        positions: usize,
        /// The number of normals.
        normals: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}, but there are only {vertices} vertices")]
    Index {
        /// Position in the list of triangles.
        triangle: usize,
        /// The vertex it asks for.
        vertex: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A size that must be positive is not, or two points that must differ coincide.
    #[error("{what}")]
    Degenerate {
        /// What is degenerate, and what would be right.
        what: &'static str,
    },
    /// A subdivision asks for too few or too many parts.
    #[error("{what} is {value}: it must be from {least} to {most}")]
    Resolution {
        /// Which number it is.
        what: &'static str,
        /// The number asked for.
        value: usize,
        /// The smallest that makes a shape.
        least: usize,
        /// The largest that is worth drawing.
        most: usize,
    },
}

/// A surface of triangles, with a unit normal at each vertex.
///
/// ```
/// use ga_design::mesh::Mesh;
/// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let mesh = Mesh::from_triangles(corners, vec![[0, 1, 2]])?;
/// assert_eq!(mesh.normals()[0], [0.0, 0.0, 1.0]);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh of these vertices, if they make one.
    ///
    /// # Errors
    /// [`MeshError`] if it is empty, a number is not finite or too large, a normal is not of unit
    /// length, or a triangle names a vertex that is not there.
    pub fn new(
        positions: Vec<[f64; 3]>,
        normals: Vec<[f64; 3]>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self, MeshError> {
        check_shape(&positions, &triangles)?;
        if positions.len() != normals.len() {
            return Err(MeshError::Lengths {
                positions: positions.len(),
                normals: normals.len(),
            });
        }
        for (index, normal) in normals.iter().enumerate() {
            let length = DVec3::from(*normal).length();
            // Written so that a NaN fails it too.
            let unit = (length - 1.0).abs() <= NORMAL_TOLERANCE;
            if !unit {
                return Err(MeshError::Normal { index, length });
            }
        }
        Ok(Self {
            positions,
            normals,
            triangles,
        })
    }

    /// The mesh of these vertices with smooth normals: the mean of the adjoining faces, weighted by
    /// area. A vertex of no face, or of faces without area, gets the normal z.
    ///
    /// # Errors
    /// [`MeshError`] as for [`Mesh::new`].
    pub fn from_triangles(
        positions: Vec<[f64; 3]>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self, MeshError> {
        check_shape(&positions, &triangles)?;
        let mut sums = vec![DVec3::ZERO; positions.len()];
        for triangle in &triangles {
            let corner = triangle.map(|i| corner(&positions, i));
            let area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
            for &vertex in triangle {
                if let Some(sum) = sums.get_mut(vertex as usize) {
                    *sum += area;
                }
            }
        }
        let normals = sums
            .into_iter()
            .map(|sum| direction(sum).unwrap_or(DVec3::Z).to_array())
            .collect();
        Self::new(positions, normals, triangles)
    }

    /// All triangles of several meshes as one.
    ///
    /// # Errors
    /// [`MeshError`] if there is no mesh, or more vertices than an index can count.
    pub fn joined<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> Result<Self, MeshError> {
        let mut whole = Self {
            positions: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
        };
        for mesh in meshes {
            let first = u32::try_from(whole.positions.len()).map_err(|_| TOO_MANY)?;
            whole.positions.extend(&mesh.positions);
            whole.normals.extend(&mesh.normals);
            u32::try_from(whole.positions.len()).map_err(|_| TOO_MANY)?;
            let shifted = mesh.triangles.iter().map(|t| t.map(|i| i + first));
            whole.triangles.extend(shifted);
        }
        Self::new(whole.positions, whole.normals, whole.triangles)
    }

    /// The vertices.
    #[must_use]
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// The unit normals, one for each vertex.
    #[must_use]
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }

    /// The triangles, as positions in the list of vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The least and the greatest value of each coordinate.
    ///
    /// ```
    /// let sphere = ga_design::mesh::icosphere(0)?;
    /// let [least, greatest] = sphere.bounds();
    /// assert!(least[2] < -0.8 && greatest[2] <= 1.0);
    /// # Ok::<(), ga_design::mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        bounds(self.positions.iter().map(|&p| DVec3::from(p))).unwrap_or_default()
    }
}

const TOO_MANY: MeshError = MeshError::Degenerate {
    what: "the mesh has more vertices than 32-bit indices can count: split it",
};

fn check_shape(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Result<(), MeshError> {
    if positions.is_empty() || triangles.is_empty() {
        return Err(MeshError::Empty);
    }
    // The last index is kept free: several file formats give it a meaning of its own.
    if u32::try_from(positions.len()).is_err() {
        return Err(TOO_MANY);
    }
    for &position in positions {
        checked_point("a vertex", position)?;
    }
    for (index, triangle) in triangles.iter().enumerate() {
        for &vertex in triangle {
            if vertex as usize >= positions.len() {
                return Err(MeshError::Index {
                    triangle: index,
                    vertex,
                    vertices: positions.len(),
                });
            }
        }
    }
    Ok(())
}

/// The point as a vector, if every coordinate may stand in a mesh.
pub(crate) fn checked_point(what: &'static str, point: [f64; 3]) -> Result<DVec3, MeshError> {
    for value in point {
        // Written so that a NaN fails it too.
        let fits = value.abs() <= LARGEST_COORDINATE;
        if !fits {
            return Err(MeshError::Coordinate { what, value });
        }
    }
    Ok(DVec3::from(point))
}

/// The length, if it is positive and may stand in a mesh.
fn checked_length(what: &'static str, value: f64) -> Result<f64, MeshError> {
    if value.is_nan() || value.abs() > LARGEST_COORDINATE {
        return Err(MeshError::Coordinate { what, value });
    }
    if value <= 0.0 {
        return Err(MeshError::Degenerate {
            what: "a length is zero or negative: it must be positive",
        });
    }
    Ok(value)
}

/// The number of parts, if it is in the range that makes sense.
fn checked_resolution(
    what: &'static str,
    value: usize,
    least: usize,
    most: usize,
) -> Result<usize, MeshError> {
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(MeshError::Resolution {
            what,
            value,
            least,
            most,
        })
    }
}

fn corner(positions: &[[f64; 3]], index: u32) -> DVec3 {
    positions
        .get(index as usize)
        .map_or(DVec3::ZERO, |&p| DVec3::from(p))
}

/// The unit vector along `vector`, whatever its size; nothing if it is zero or not finite.
///
/// Divides by the largest component first: the square of a very small or very large number is zero
/// or infinite although the direction is well defined.
pub(crate) fn direction(vector: DVec3) -> Option<DVec3> {
    let largest = vector.abs().max_element();
    if largest > 0.0 && largest.is_finite() {
        (vector / largest).try_normalize()
    } else {
        None
    }
}

/// Two unit vectors that make a right-handed frame with the unit vector `axis` as the third.
///
/// Starts from the coordinate axis that is farthest from `axis`, so that the cross product is never
/// small.
pub(crate) fn perpendicular(axis: DVec3) -> [DVec3; 2] {
    let size = axis.abs();
    let start = if size.x <= size.y && size.x <= size.z {
        DVec3::X
    } else if size.y <= size.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    let first = direction(axis.cross(start)).unwrap_or(DVec3::X);
    [first, axis.cross(first)]
}

/// The least and the greatest corner of some points; nothing if there is none.
pub(crate) fn bounds(points: impl Iterator<Item = DVec3>) -> Option<[[f64; 3]; 2]> {
    points
        .fold(None, |box_so_far: Option<(DVec3, DVec3)>, point| {
            Some(match box_so_far {
                None => (point, point),
                Some((least, greatest)) => (least.min(point), greatest.max(point)),
            })
        })
        .map(|(least, greatest)| [least.to_array(), greatest.to_array()])
}
