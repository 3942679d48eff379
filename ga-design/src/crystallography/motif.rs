//! How any motif becomes a pattern: carried by every isometry of a group into every cell of a block, and
//! coincident copies merged.
//!
//! What can be repeated is a [`Motif`]: every multivector that is [`Movable`](super::Movable) (points,
//! lines, circles, spheres, point pairs, motors, …), and made of points [`Curve`], [`Strut`],
//! [`Labelled`] shapes such as atoms, and meshes. Merging costs about the same for every copy, however many
//! there are: copies are compared within bins of a fingerprint only.

use super::placement::{PlacementError, SymmetricCell};
use super::{Cell, CellRange, Isometry, Operation, Placement};
use crate::mesh::MeshError;
use ga_cga::{Point, Translator, Vector3};

mod bins;
mod instances;
mod multivector;
mod points;
mod surface;

pub use instances::add_instances;
pub use points::{Curve, Labelled, Strut};

use bins::Bins;

/// The most copies that a pattern may have.
pub const MOST_COPIES: u64 = 20_000_000;

/// A point less than this below a face of the cell, in cell edges, is on the face.
const ON_FACE: f64 = 1e-6;

/// Why a pattern cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotifError {
    /// The cell contradicts the operations.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// More copies than anyone needs.
    #[error("the pattern would have {copies} copies, more than {MOST_COPIES}: ask for fewer cells")]
    TooMany {
        /// How many there would be.
        copies: u64,
    },
    /// A copy of a mesh is beyond what a mesh can hold.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A coordinate of the motif or of a copy is NaN or infinite.
    #[error("a copy of the motif has a coordinate that is not finite: check the motif")]
    NotFinite,
}

/// When two copies are one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coincidence {
    /// Copies that a translation by less than this makes one are one; in the unit of the motif.
    pub distance: f64,
    /// And those that a turn by less than this many radians makes one.
    pub angle: f64,
    /// Whether a copy that runs the other way is another: a line, circle or curve turned round, a plane
    /// turned over, a sphere turned inside out by reflection.
    pub is_oriented: bool,
}

impl Default for Coincidence {
    /// One millionth of the unit and of a radian, without regard to orientation.
    fn default() -> Self {
        Self {
            distance: 1e-6,
            angle: 1e-6,
            is_oriented: false,
        }
    }
}

/// Three numbers that change little when a shape is moved a little, and by how much at most between shapes
/// that coincide; the negative ones for a shape that is the negative of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fingerprint {
    /// The three numbers.
    pub values: [f64; 3],
    /// The largest difference of each between coinciding shapes.
    pub tolerance: f64,
}

/// Something that isometries move and of which one can tell whether two are the same.
pub trait Motif: Clone {
    /// The image under an isometry.
    ///
    /// # Errors
    /// [`MotifError`] where the image cannot be held.
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError>;

    /// Whether both are the same shape in the same place.
    fn coincides(&self, other: &Self, when: &Coincidence) -> bool;

    /// What shapes that coincide have in common.
    fn fingerprint(&self, when: &Coincidence) -> Fingerprint;
}

/// A copy of a motif in a pattern.
#[derive(Clone, Debug, PartialEq)]
pub struct MotifCopy<X> {
    /// The position of the isometry in the list that the pattern was made of.
    pub operation: usize,
    /// The cell that it was carried to.
    pub cell: [i32; 3],
    /// Isometry and cell translation together.
    pub isometry: Isometry,
    /// How many copies are in this place: the order of the site symmetry, for a whole pattern.
    pub coincident: usize,
    /// The copy.
    pub shape: X,
}

/// A list of isometries, repeated in the cells of a lattice.
///
/// ```
/// use ga_cga::{Circle, Point, Vector3};
/// use ga_design::crystallography::{Cell, CellRange, Coincidence, Pattern, SpaceGroup};
///
/// let cell = Cell::new([4.0; 3], [90.0; 3])?;
/// let group = SpaceGroup::from_symbol("P m -3 m")?[0];
/// let pattern = Pattern::of_group(&group.operations()?, &cell, CellRange::UNIT)?;
/// // A circle around the fourfold axis: 48 copies, of which 6 are different.
/// let circle = Circle::with_normal(Point::at(0.0, 0.0, 1.0), 0.5, Vector3::new(0.0, 0.0, 1.0));
/// let rings = pattern.distinct(&circle.unwrap(), &Coincidence::default())?;
/// assert_eq!(rings.len(), 6);
/// assert!(rings.iter().all(|ring| ring.coincident == 8));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    isometries: Vec<Isometry>,
    edges: [Vector3; 3],
    cells: CellRange,
}

impl Pattern {
    /// The pattern of isometries alone, as of a point group.
    pub fn of_isometries(isometries: Vec<Isometry>) -> Self {
        Self {
            isometries,
            edges: [Vector3::default(); 3],
            cells: CellRange::UNIT,
        }
    }

    /// The pattern of isometries repeated along three edge vectors in a block of cells.
    pub fn on_lattice(isometries: Vec<Isometry>, edges: [Vector3; 3], cells: CellRange) -> Self {
        Self {
            isometries,
            edges,
            cells,
        }
    }

    /// The pattern of a space group: the operations modulo the lattice, in a block of cells; lengths in
    /// ångström.
    ///
    /// # Errors
    /// [`MotifError::Placement`] if the cell does not have the symmetry of the operations.
    pub fn of_group(
        operations: &[Operation],
        cell: &Cell,
        cells: CellRange,
    ) -> Result<Self, MotifError> {
        let (placements, frame): (Vec<Placement>, SymmetricCell) =
            Placement::of_group(operations, cell)?;
        let isometries = placements.iter().map(Isometry::from).collect();
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let edges = unit.map(|edge| Vector3::from(frame.cartesian(edge)));
        Ok(Self::on_lattice(isometries, edges, cells))
    }

    /// The pattern with its isometries chosen, each up to a lattice translation, so that they carry this
    /// point of the motif into the unit cell: a block of cells then has as many copies in each cell as in
    /// the others. Without a lattice the same pattern.
    ///
    /// ```
    /// use ga_cga::Point;
    /// use ga_design::crystallography::{Cell, Coincidence, Pattern, SpaceGroup};
    ///
    /// let cell = Cell::new([4.0; 3], [90.0; 3])?;
    /// let group = SpaceGroup::from_symbol("P -1")?[0];
    /// let pattern = Pattern::of_group(&group.operations()?, &cell, "3x1x1".parse()?)?;
    /// let at = Point::at(1.0, 1.0, 1.0);
    /// let atoms = pattern.gathered(at).distinct(&at, &Coincidence::default())?;
    /// assert!(atoms.iter().all(|atom| atom.shape.position().e1 >= 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gathered(mut self, anchor: Point) -> Self {
        let [a, b, c] = self.edges;
        let cell = (a ^ b ^ c).e123;
        if cell == 0.0 {
            return self;
        }
        for isometry in &mut self.isometries {
            let x = isometry.apply(anchor).position();
            // Fractions of the edges are ratios of volumes.
            let fractions = [x ^ b ^ c, a ^ x ^ c, a ^ b ^ x].map(|part| part.e123 / cell);
            let mut back = Vector3::default();
            for (edge, fraction) in self.edges.iter().zip(fractions) {
                back -= *edge * (fraction + ON_FACE).floor();
            }
            isometry.motor = Translator::by(back) * isometry.motor;
        }
        self
    }

    /// The number of copies before merging.
    pub fn count(&self) -> u64 {
        self.cells
            .count()
            .saturating_mul(self.isometries.len() as u64)
    }

    /// All isometries: operation, cell, and both together; cell by cell.
    pub fn isometries(&self) -> impl Iterator<Item = (usize, [i32; 3], Isometry)> + '_ {
        self.cells.offsets().flat_map(move |cell| {
            let mut shift = Vector3::default();
            for (edge, count) in self.edges.iter().zip(cell) {
                shift += *edge * f64::from(count);
            }
            let shift = Translator::by(shift);
            let all = self.isometries.iter().enumerate();
            all.map(move |(operation, isometry)| {
                let moved = Isometry {
                    mirror: isometry.mirror,
                    motor: shift * isometry.motor,
                };
                (operation, cell, moved)
            })
        })
    }

    /// All copies of a motif, coincident ones too.
    ///
    /// # Errors
    /// [`MotifError`] if there are more than [`MOST_COPIES`], or a copy cannot be held.
    pub fn copies<X: Motif>(&self, motif: &X) -> Result<Vec<MotifCopy<X>>, MotifError> {
        let copies = self.count();
        if copies > MOST_COPIES {
            return Err(MotifError::TooMany { copies });
        }
        let all = self.isometries().map(|(operation, cell, isometry)| {
            Ok(MotifCopy {
                operation,
                cell,
                isometry,
                coincident: 1,
                shape: motif.moved(&isometry)?,
            })
        });
        all.collect()
    }

    /// The copies that differ, each the first in its place.
    ///
    /// # Errors
    /// [`MotifError`] as for [`Pattern::copies`], and if a coordinate is not finite.
    pub fn distinct<X: Motif>(
        &self,
        motif: &X,
        when: &Coincidence,
    ) -> Result<Vec<MotifCopy<X>>, MotifError> {
        merged(self.copies(motif)?, when)
    }
}

/// The copies that differ, in their order, coincident ones counted.
fn merged<X: Motif>(
    copies: Vec<MotifCopy<X>>,
    when: &Coincidence,
) -> Result<Vec<MotifCopy<X>>, MotifError> {
    let prints: Vec<_> = copies
        .iter()
        .map(|copy| copy.shape.fingerprint(when))
        .collect();
    let mut bins = Bins::for_prints(&prints).ok_or(MotifError::NotFinite)?;
    let mut kept: Vec<MotifCopy<X>> = Vec::new();
    for (copy, print) in copies.into_iter().zip(prints) {
        let reversed = (!when.is_oriented).then(|| print.values.map(|value| -value));
        let places = std::iter::once(print.values).chain(reversed);
        let same = places.flat_map(|values| bins.near(values)).find(|&index| {
            let known = kept.get(index);
            known.is_some_and(|known| known.shape.coincides(&copy.shape, when))
        });
        match same.and_then(|index| kept.get_mut(index)) {
            Some(known) => known.coincident += 1,
            None => {
                bins.insert(print.values, kept.len());
                kept.push(copy);
            }
        }
    }
    Ok(kept)
}
