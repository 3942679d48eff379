//! Which part of space a group repeats: the points nearer to one point in general position than to any of
//! its images (its Dirichlet or Voronoi cell), a convex polyhedron for every group and cell.
//!
//! The bisector of two points is their difference: `q − p` is a dual plane of the conformal model, and its
//! product with a point tells on which side that is. The polyhedron is a large cube cut by the bisectors of
//! the seed and its images, until no corner is nearer to an image than to the seed; that it has its share of the
//! cell's volume then proves that nothing is missing.

use ga_cga::{DualPlane, Point, Vector3};
use ga_core::convert::pick;

use super::placement::{PlacementError, SymmetricCell};
use super::{Cell, Operation, close};
use crate::mesh::{Mesh, MeshError};

mod polyhedron;

use polyhedron::Polyhedron;

/// How many points are tried for the seed.
const CANDIDATES: u32 = 64;

/// How many cells around a corner are searched before the cell counts as too oblique.
const FARTHEST_CELL: i32 = 4;

/// How often corners are searched: each time those that are left are nearer to the seed.
const MOST_ROUNDS: u32 = 64;

/// An image is nearer to a corner than the seed if it is so by more than this part.
const ROUNDING: f64 = 1e-10;

/// Nearer than this part of the shortest edge an image coincides with the seed.
const COINCIDENT: f64 = 1e-6;

/// How far the volume may be from its share of the cell.
const MISFIT: f64 = 1e-6;

/// Why operations and a cell have no fundamental domain.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FundamentalDomainError {
    /// The cell contradicts the operations.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// The seed lies on a symmetry element.
    #[error(
        "the point {0:?} is on a symmetry element: choose one in general position, such as \
         [0.13, 0.29, 0.37]"
    )]
    Special([f64; 3]),
    /// The cell is so oblique that thousands of cells are neighbours.
    #[error(
        "the cell is too oblique: choose a reduced one, whose edges are the shortest of its lattice"
    )]
    Oblique,
    /// The images do not fill space, or fill it more than once.
    #[error(
        "the domain has {part:.4} times the volume that it should have: the operations are no group"
    )]
    NotAGroup {
        /// Its volume over the share of one operation.
        part: f64,
    },
}

/// A face of a fundamental domain.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainFace {
    /// Its plane, the normal outward and of unit length.
    pub plane: DualPlane,
    /// Its corners in order around it, anticlockwise seen from outside.
    pub corners: Vec<Point>,
    /// The position in the list of operations of the one whose image is on the other side.
    pub operation: usize,
    /// The cell offset that the operation is followed by.
    pub cell: [i32; 3],
}

/// A convex polyhedron whose images under the group fill space without overlap: an asymmetric unit.
#[derive(Clone, Debug, PartialEq)]
pub struct FundamentalDomain {
    seed: Point,
    faces: Vec<DomainFace>,
    volume: f64,
}

impl FundamentalDomain {
    /// The domain about the point that is farthest from its images, of a few dozen: a stout one.
    ///
    /// ```
    /// use ga_design::crystallography::{Cell, FundamentalDomain, SpaceGroup};
    ///
    /// let cell = Cell::new([5.43; 3], [90.0; 3])?;
    /// let group = SpaceGroup::from_symbol("F d -3 m")?[0];
    /// let domain = FundamentalDomain::of(&group.operations()?, &cell)?;
    /// assert!((domain.volume() - cell.volume() / 192.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FundamentalDomainError`] if the cell does not have the symmetry or is very oblique, or the
    /// operations are no group.
    pub fn of(operations: &[Operation], cell: &Cell) -> Result<Self, FundamentalDomainError> {
        let frame = SymmetricCell::new(operations, cell)?;
        let best = (1..=CANDIDATES).map(candidate).max_by(|p, q| {
            nearest_image(operations, &frame, *p).total_cmp(&nearest_image(operations, &frame, *q))
        });
        Self::about(operations, cell, best.unwrap_or_else(|| candidate(1)))
    }

    /// The domain about a point given in fractions of the cell edges, moved into the unit cell.
    ///
    /// # Errors
    /// [`FundamentalDomainError`], also if the point is on a symmetry element or not finite.
    pub fn about(
        operations: &[Operation],
        cell: &Cell,
        seed: [f64; 3],
    ) -> Result<Self, FundamentalDomainError> {
        let frame = SymmetricCell::new(operations, cell)?;
        let seed = seed.map(|part| part - part.floor());
        let edges = cell.edges();
        let shortest = edges.into_iter().fold(f64::INFINITY, f64::min);
        // Written so that a NaN fails it too.
        let is_general = nearest_image(operations, &frame, seed) > COINCIDENT * shortest;
        if !is_general {
            return Err(FundamentalDomainError::Special(seed));
        }
        let images = Images {
            operations,
            frame: &frame,
            seed,
        };
        let centre = point(frame.cartesian(seed));
        let mut domain = Polyhedron::cube(centre, edges.iter().sum());
        for (distance, source) in images.nearby() {
            if distance <= 2.0 * domain.radius() {
                images.bisect(&mut domain, source);
            }
        }
        let share = share(&frame, operations);
        for reach in 1..=FARTHEST_CELL {
            images.refine(&mut domain, reach);
            // Too few cuts leave too much: the right volume proves that none is missing.
            if domain.volume() < share * (1.0 + MISFIT) {
                break;
            }
        }
        let volume = domain.volume();
        let part = volume / share;
        let fits = (part - 1.0).abs() < MISFIT;
        if !fits {
            let is_group = close(operations).is_ok_and(|all| all.len() == operations.len());
            return Err(match is_group {
                true => FundamentalDomainError::Oblique,
                false => FundamentalDomainError::NotAGroup { part },
            });
        }
        let faces = domain.into_faces().into_iter();
        let faces = faces.filter_map(|(plane, corners, source)| {
            let (operation, cell) = source?;
            Some(DomainFace {
                plane,
                corners,
                operation,
                cell,
            })
        });
        Ok(Self {
            seed: centre,
            faces: faces.collect(),
            volume,
        })
    }

    /// The point that it is the surroundings of.
    pub fn seed(&self) -> Point {
        self.seed
    }

    /// The faces.
    pub fn faces(&self) -> &[DomainFace] {
        &self.faces
    }

    /// The planes of the faces, normals outward.
    pub fn planes(&self) -> impl Iterator<Item = DualPlane> + '_ {
        self.faces.iter().map(|face| face.plane)
    }

    /// The volume in cubic ångström: that of the cell over the number of operations per cell.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// How deep inside a point is: its distance from the nearest face, negative outside.
    pub fn depth(&self, point: Point) -> f64 {
        let heights = self.planes().map(|plane| -(plane | point).s);
        heights.fold(f64::INFINITY, f64::min)
    }

    /// The polyhedron as a surface with flat faces.
    ///
    /// # Errors
    /// [`MeshError`] if the cell is beyond what a mesh can hold.
    pub fn mesh(&self) -> Result<Mesh, MeshError> {
        let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
        for face in &self.faces {
            let first = u32::try_from(positions.len()).unwrap_or(u32::MAX);
            let count = u32::try_from(face.corners.len()).unwrap_or(0);
            triangles.extend((2..count).map(|i| [first, first + i - 1, first + i]));
            for corner in &face.corners {
                positions.push(corner.position().to_array());
                normals.push(face.plane.normal().to_array());
            }
        }
        Mesh::new(positions, normals, triangles)
    }
}

/// An operation and the cell offset that follows it; nothing for the cube that is cut from.
type Source = Option<(usize, [i32; 3])>;

fn point([x, y, z]: [f64; 3]) -> Point {
    Point::at(x, y, z)
}

/// The volume of the cell over the number of operations.
fn share(frame: &SymmetricCell, operations: &[Operation]) -> f64 {
    let [a, b, c] = frame.basis();
    a[0] * b[1] * c[2] / operations.len().max(1) as f64
}

/// Points that fill the unit cube evenly: multiples of the powers of the plastic-like number of three
/// dimensions (M. Roberts, *The unreasonable effectiveness of quasirandom sequences*, 2018).
fn candidate(number: u32) -> [f64; 3] {
    [0.819_172_513_4, 0.671_043_606_7, 0.549_700_477_9]
        .map(|step| (step * f64::from(number)).fract())
}

/// The distance to an image by the shortest way round each edge.
fn nearest_image(operations: &[Operation], frame: &SymmetricCell, seed: [f64; 3]) -> f64 {
    let others = operations.iter().filter(|op| **op != Operation::IDENTITY);
    let distances = others.map(|operation| {
        let image = operation.apply(seed);
        let step = [0, 1, 2].map(|i| image[i] - seed[i]);
        Vector3::from(frame.cartesian(step.map(|part| part - part.round()))).norm()
    });
    // NaN must come out as the nearest.
    distances.fold(f64::INFINITY, |least, d| {
        if d < least || d.is_nan() { d } else { least }
    })
}

/// The images of a seed under a group.
struct Images<'a> {
    operations: &'a [Operation],
    frame: &'a SymmetricCell,
    seed: [f64; 3],
}

impl Images<'_> {
    /// Those in the cells next to the seed, nearest first, without the seed itself.
    fn nearby(&self) -> Vec<(f64, Source)> {
        let mut found = Vec::new();
        for (index, operation) in self.operations.iter().enumerate() {
            let image = operation.apply(self.seed);
            for cell in around(self.seed, image, 1) {
                if *operation != Operation::IDENTITY || cell != [0; 3] {
                    found.push((self.distance(self.seed, image, cell), Some((index, cell))));
                }
            }
        }
        found.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        found
    }

    /// Cuts off all corners that are nearer to another image than to the seed, until there are none; images
    /// are looked for up to so many cells from each corner.
    fn refine(&self, domain: &mut Polyhedron<Source>, reach: i32) {
        for _ in 0..MOST_ROUNDS {
            let mut nearer: Vec<Source> = Vec::new();
            for corner in domain.corners() {
                let at = self.frame.fractional(corner.position().to_array());
                let own = self.distance(at, self.seed, [0; 3]);
                let mut least = own * (1.0 - ROUNDING);
                let mut nearest = None;
                for (index, operation) in self.operations.iter().enumerate() {
                    let image = operation.apply(self.seed);
                    for cell in around(at, image, reach) {
                        let distance = self.distance(at, image, cell);
                        if distance < least {
                            least = distance;
                            nearest = Some((index, cell));
                        }
                    }
                }
                if nearest.is_some() && !nearer.contains(&nearest) {
                    nearer.push(nearest);
                }
            }
            if nearer.is_empty() {
                return;
            }
            for source in nearer {
                self.bisect(domain, source);
            }
        }
    }

    /// Cuts off what is nearer to an image than to the seed.
    fn bisect(&self, domain: &mut Polyhedron<Source>, source: Source) {
        let Some((operation, cell)) = source else {
            return;
        };
        let Some(operation) = self.operations.get(operation) else {
            return;
        };
        let image = operation.apply(self.seed);
        let image = [0, 1, 2].map(|i| image[i] + f64::from(cell[i]));
        let [there, here] = [image, self.seed].map(|x| point(self.frame.cartesian(x)));
        let between: DualPlane = pick(there - here);
        domain.cut(between / between.weight(), source);
    }

    /// The distance from a place to an image in another cell.
    fn distance(&self, from: [f64; 3], image: [f64; 3], cell: [i32; 3]) -> f64 {
        let step = [0, 1, 2].map(|i| image[i] + f64::from(cell[i]) - from[i]);
        Vector3::from(self.frame.cartesian(step)).norm()
    }
}

/// The cells that bring an image near a place, up to `reach` more in every direction.
fn around(place: [f64; 3], image: [f64; 3], reach: i32) -> impl Iterator<Item = [i32; 3]> {
    // Places are corners of a domain, within a few cells of the unit cell.
    let wrap = [0, 1, 2].map(|i| (place[i] - image[i]).round().clamp(-1e6, 1e6) as i32);
    let span = move |i: usize| wrap[i] - reach..=wrap[i] + reach;
    span(0).flat_map(move |i| span(1).flat_map(move |j| span(2).map(move |k| [i, j, k])))
}
