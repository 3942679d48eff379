//! How a symmetric set of point pairs warps a shape (3.9, figure 3.7): each point is moved by the
//! exponential of their sum, weighted by how far it is from each.
//!
//! ```
//! use ga_cga::{Point, PointPair, Vector3};
//! use ga_design::crystallography::{Isometry, Placement};
//! use ga_design::mesh;
//! use ga_design::warp::{Warp, Weighting};
//!
//! // A tangent in the direction of y at (1, 0, 0), and its image under the half turn about z.
//! let half_turn = Placement {
//!     reflections: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     translation: [0.0; 3],
//! };
//! let still = Placement { reflections: vec![], translation: [0.0; 3] };
//! let group = [still, half_turn].map(|placement| Isometry::from(&placement));
//! let pair = PointPair::tangent(Point::at(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
//! let warp = Warp::generated(&group, &[pair], Weighting::SquaredDistance, 0.1)?;
//! assert_eq!(warp.pairs().count(), 2);
//! let warped = warp.mesh(&mesh::icosphere(3)?)?;
//! assert_eq!(warped.triangles().len(), 1280);
//! # Ok::<(), ga_design::warp::WarpError>(())
//! ```

use crate::crystallography::Isometry;
use crate::mesh::{self, Mesh, MeshError, direction, perpendicular};
use ga_cga::{Even, Point, PointPair, Vector3};
use ga_core::{Dual, Real};
use glam::DVec3;
use thiserror::Error;

/// The most pairs of a warp.
pub const MOST_PAIRS: usize = 1000;

/// Pairs whose coefficients differ by less than this part of the largest are one.
const SAME: f64 = 1e-9;

/// How much a pair counts at a point, by their squared distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weighting {
    /// As (3.9) is printed: the squared distance from the pair's centre. What is far is moved most, and
    /// the place of a pair stays as its own pair leaves it.
    SquaredDistance,
    /// 1/(1 + d²/r²) at the squared distance d² and with the reach r: what is near is moved most, by one
    /// whole pair in its centre, half of it at the distance r.
    Near {
        /// The distance at which a pair counts half.
        reach: f64,
    },
}

/// Why there is no such warp.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum WarpError {
    /// There is no pair.
    #[error("there is no point pair to warp with")]
    Empty,
    /// More pairs than are computed with.
    #[error("{value} point pairs are too many: at most {MOST_PAIRS}")]
    TooMany {
        /// The number of pairs.
        value: usize,
    },
    /// A pair has no centre from which a distance could be measured.
    #[error(
        "point pair {index} has no centre: it is flat, zero or not finite; use two points, or a tangent"
    )]
    NoCenter {
        /// Its place in the list.
        index: usize,
    },
    /// A number is NaN, infinite or out of its range.
    #[error("{what} is {value}: it must be {range}")]
    Number {
        /// Which number it is.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range in words.
        range: &'static str,
    },
    /// A vertex is moved to the point at infinity, or farther than can be computed with.
    #[error("vertex {vertex} of the mesh is moved to infinity: warp by less, or with other pairs")]
    AtInfinity {
        /// Its place in the list of vertices.
        vertex: usize,
    },
    /// The warped shape is no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// A set of point pairs κᵢ that moves a point p by C = e^{−t Σ dᵢκᵢ} (3.9), with weights dᵢ that depend
/// on the distances from p.
///
/// Because the weights depend on distances alone, the warp by the images of pairs under a group has the
/// group's symmetry: it commutes with every isometry of the group.
#[derive(Debug, Clone, PartialEq)]
pub struct Warp {
    pairs: Vec<(PointPair, Point)>,
    weighting: Weighting,
    amount: f64,
}

impl Warp {
    /// The warp by these pairs. Real pairs push from their first point to their second, imaginary ones
    /// turn about the circles that they are dual to, tangents bend.
    ///
    /// # Errors
    /// [`WarpError`] if there is no pair or too many, a pair has no centre, or a number is not finite.
    pub fn new(
        pairs: Vec<PointPair>,
        weighting: Weighting,
        amount: f64,
    ) -> Result<Self, WarpError> {
        if pairs.is_empty() {
            return Err(WarpError::Empty);
        }
        if pairs.len() > MOST_PAIRS {
            return Err(WarpError::TooMany { value: pairs.len() });
        }
        if !amount.is_finite() {
            return Err(WarpError::Number {
                what: "the amount of a warp",
                value: amount,
                range: "finite",
            });
        }
        if let Weighting::Near { reach } = weighting
            && !(1e-12..=1e12).contains(&reach)
        {
            return Err(WarpError::Number {
                what: "the reach of a pair",
                value: reach,
                range: "from 1e-12 to 1e12",
            });
        }
        let centred = pairs.into_iter().enumerate().map(|(index, pair)| {
            let is_finite = pair.to_array().iter().all(|part| part.is_finite());
            let center = pair
                .center()
                .filter(|center| is_finite && center.ni.is_finite());
            let center = center.ok_or(WarpError::NoCenter { index })?;
            Ok((pair, center))
        });
        Ok(Self {
            pairs: centred.collect::<Result<_, WarpError>>()?,
            weighting,
            amount,
        })
    }

    /// The warp by all images of these pairs under the isometries of a group; images that coincide are
    /// one. A pair that the group also reverses is taken back by its image.
    ///
    /// # Errors
    /// [`WarpError`] as for [`Warp::new`].
    pub fn generated(
        group: &[Isometry],
        pairs: &[PointPair],
        weighting: Weighting,
        amount: f64,
    ) -> Result<Self, WarpError> {
        let mut images: Vec<PointPair> = Vec::new();
        for &pair in pairs {
            for isometry in group {
                let image = isometry.apply(pair);
                let near = SAME * size(image);
                if !images.iter().any(|&known| size(known - image) <= near) {
                    images.push(image);
                }
                if images.len() > MOST_PAIRS {
                    return Err(WarpError::TooMany {
                        value: images.len(),
                    });
                }
            }
        }
        Self::new(images, weighting, amount)
    }

    /// The pairs.
    pub fn pairs(&self) -> impl Iterator<Item = PointPair> + '_ {
        self.pairs.iter().map(|(pair, _)| *pair)
    }

    /// Where a point is moved to; `None` if that is the point at infinity, or not finite.
    #[must_use]
    pub fn apply(&self, point: Point) -> Option<Point> {
        self.image(point)
    }

    /// The versor C = e^{−t Σ dᵢκᵢ} that moves a point (3.9).
    fn versor<T: Real + From<f64>>(&self, point: Point<T>) -> Even<T> {
        let constant = |pair: PointPair| PointPair::<T>::from(pair.to_array().map(T::from));
        let mut sum = PointPair::<T>::default();
        for (pair, center) in &self.pairs {
            let center = Vector3::from(center.position().to_array().map(T::from));
            let square = (point.position() - center).norm_squared();
            let weight = match self.weighting {
                Weighting::SquaredDistance => square,
                Weighting::Near { reach } => T::ONE / (T::ONE + square / T::from(reach * reach)),
            };
            sum += constant(*pair) * weight;
        }
        (sum * T::from(-self.amount)).exp()
    }

    fn image<T: Real + From<f64>>(&self, point: Point<T>) -> Option<Point<T>> {
        let versor = self.versor(point);
        // What overflows moves nothing anywhere.
        let is_finite = versor.to_array().iter().all(|part| part.is_finite());
        let image = is_finite.then(|| point.image_under(versor)).flatten()?;
        let places = image.position().to_array();
        places.iter().all(|part| part.is_finite()).then_some(image)
    }

    /// The derivative of the warp at a point in a direction.
    fn derivative(&self, at: DVec3, along: DVec3) -> Option<DVec3> {
        let [x, y, z] = std::array::from_fn(|axis| Dual::new(at[axis], along[axis]));
        let image = self.image(Point::at(x, y, z))?;
        let derivative = DVec3::from(image.position().to_array().map(|part| part.eps));
        derivative.is_finite().then_some(derivative)
    }

    /// The warped mesh: vertices are moved, and normals stay at right angles to the surface, because
    /// their tangents are carried along by the derivative of the warp. A normal whose tangents collapse
    /// stays as it was.
    ///
    /// # Errors
    /// [`WarpError`] if a vertex is moved to infinity or out of the range of meshes.
    pub fn mesh(&self, mesh: &Mesh) -> Result<Mesh, WarpError> {
        let mut positions = Vec::with_capacity(mesh.positions().len());
        let mut normals = Vec::with_capacity(mesh.normals().len());
        for (vertex, (&place, &normal)) in mesh.positions().iter().zip(mesh.normals()).enumerate() {
            let image = self.apply(Point::from(Vector3::from(place)));
            let image = image.ok_or(WarpError::AtInfinity { vertex })?;
            positions.push(image.position().to_array());
            let (at, normal) = (DVec3::from(place), DVec3::from(normal));
            let [first, second] = perpendicular(normal).map(|along| self.derivative(at, along));
            let carried = first.zip(second).map(|(first, second)| first.cross(second));
            let unit = carried.and_then(direction).unwrap_or(normal);
            normals.push(unit.to_array());
        }
        Ok(mesh::Mesh::new(
            positions,
            normals,
            mesh.triangles().to_vec(),
        )?)
    }
}

/// The largest coefficient of a pair.
fn size(pair: PointPair) -> f64 {
    let parts = pair.to_array();
    parts
        .iter()
        .fold(0.0, |so_far, part| so_far.max(part.abs()))
}
