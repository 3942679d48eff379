//! Where an element lies: a line, a plane or a point of space modulo the lattice, in one exact form.

use super::lattice_basis::{Fraction, LatticeBasis, dot, image, modulo_one, primitive};
use crate::crystallography::Operation;

/// The largest denominator that a position can have: operations have 5040, and the inversion point of
/// an axis -6 divides by 6.
const FINEST: i64 = 30_240;

/// The farthest position, in cell edges.
const FARTHEST: u64 = 64;

/// A line along a lattice direction, modulo the lattice translations of the cell.
///
/// Two lines are equal exactly if a translation by whole cell edges takes one to the other.
///
/// ```
/// use ga_design::crystallography::symmetry_elements::{Fraction, LatticeLine};
///
/// let half = Fraction::new(1, 2);
/// let zero = Fraction::from(0);
/// let one = LatticeLine::through([0, 0, 2], [half, zero, half]);
/// assert_eq!(one, LatticeLine::through([0, 0, -1], [-half, 3.into(), zero]));
/// assert!(LatticeLine::through([0, 0, 0], [zero; 3]).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LatticeLine {
    direction: [i64; 3],
    point: [Fraction; 3],
}

impl LatticeLine {
    /// The line through a point (in fractions of the cell edges) in a direction (in whole edges);
    /// `None` for a direction of zero, or with coprime indices beyond 64, and for a point beyond 64
    /// edges or finer than 1/30240.
    pub fn through(direction: [i64; 3], point: [Fraction; 3]) -> Option<Self> {
        Self::reduced(direction, exact(point)?)
    }

    /// The same for a point that was computed from an operation.
    pub(super) fn reduced(direction: [i64; 3], point: [Fraction; 3]) -> Option<Self> {
        let direction = primitive(direction)?;
        let basis = LatticeBasis::completing(direction);
        let [across, aside, _] = basis.coordinates(point).map(modulo_one);
        let point = basis.point([across, aside, Fraction::from(0)]);
        Some(Self { direction, point })
    }

    /// The direction `[uvw]`: coprime, the first index that is not zero positive.
    pub fn direction(&self) -> [i64; 3] {
        self.direction
    }

    /// A point of the line, in fractions of the cell edges: always the same for equal lines.
    pub fn point(&self) -> [Fraction; 3] {
        self.point
    }

    /// Whether the line, or one of its translates by whole edges, goes through a point.
    pub fn contains(&self, point: [Fraction; 3]) -> bool {
        Self::through(self.direction, point) == Some(*self)
    }

    /// The line that an operation takes this one to.
    ///
    /// `None` where its indices are beyond 64.
    pub fn moved_by(&self, operation: &Operation) -> Option<Self> {
        let direction = moved_direction(operation, self.direction);
        Self::reduced(direction, moved_point(operation, self.point))
    }
}

/// A plane along a net plane of the lattice, modulo the lattice translations of the cell: all points
/// with `h x + k y + l z = offset`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LatticePlane {
    normal: [i64; 3],
    offset: Fraction,
}

impl LatticePlane {
    /// The plane `(hkl)` through a point; `None` for indices that are zero, or coprime beyond 64, and
    /// for a point beyond 64 edges or finer than 1/30240.
    ///
    /// ```
    /// use ga_design::crystallography::symmetry_elements::{Fraction, LatticePlane};
    ///
    /// let quarter = Fraction::new(1, 4);
    /// let plane = LatticePlane::through([0, -2, 0], [0.into(), quarter, 0.into()]).unwrap();
    /// assert_eq!((plane.normal(), plane.offset()), ([0, 1, 0], quarter));
    /// ```
    pub fn through(normal: [i64; 3], point: [Fraction; 3]) -> Option<Self> {
        Self::reduced(primitive(normal)?, exact(point)?)
    }

    /// The same for a point that was computed from an operation.
    fn reduced(normal: [i64; 3], point: [Fraction; 3]) -> Option<Self> {
        let normal = primitive(normal)?;
        let offset = dot(normal, point);
        Some(Self::at(normal, offset))
    }

    /// The plane with these primitive indices on which the form has this value.
    pub(super) fn at(normal: [i64; 3], offset: Fraction) -> Self {
        let offset = modulo_one(offset);
        Self { normal, offset }
    }

    /// The Miller indices `(hkl)`: coprime, the first that is not zero positive.
    pub fn normal(&self) -> [i64; 3] {
        self.normal
    }

    /// What `h x + k y + l z` is on the plane, in `[0, 1)`.
    pub fn offset(&self) -> Fraction {
        self.offset
    }

    /// A point of the plane, in fractions of the cell edges: always the same for equal planes.
    pub fn point(&self) -> [Fraction; 3] {
        // The last form is 1 on the indices, so the indices are 1 on it.
        let [_, _, once] = LatticeBasis::completing(self.normal).forms();
        once.map(|entry| self.offset * entry)
    }

    /// Whether the plane, or one of its translates by whole edges, goes through a point.
    pub fn contains(&self, point: [Fraction; 3]) -> bool {
        Self::through(self.normal, point) == Some(*self)
    }

    /// The plane that an operation takes this one to.
    ///
    /// `None` where its indices are beyond 64, or those of the operation's inverse are.
    pub fn moved_by(&self, operation: &Operation) -> Option<Self> {
        // Forms go with the inverse: h W⁻¹ is constant on the image.
        let back = matrix(&operation.inverse()?);
        let normal = [0, 1, 2].map(|j| (0..3).map(|i| self.normal[i] * back[i][j]).sum());
        Self::reduced(normal, moved_point(operation, self.point()))
    }
}

/// The point, if its coordinates are such that nothing computed from them can overflow.
fn exact(point: [Fraction; 3]) -> Option<[Fraction; 3]> {
    let fits = |part: &Fraction| {
        (1..=FINEST).contains(part.denom())
            && part.numer().abs_diff(0) <= FARTHEST * part.denom().abs_diff(0)
    };
    point.iter().all(fits).then_some(point)
}

/// The image of a point under an operation, exactly; not reduced modulo the lattice.
pub(super) fn moved_point(operation: &Operation, point: [Fraction; 3]) -> [Fraction; 3] {
    let turned = image(&matrix(operation), point);
    let shift = translation(operation);
    [0, 1, 2].map(|i| turned[i] + shift[i])
}

/// The image of a direction.
fn moved_direction(operation: &Operation, direction: [i64; 3]) -> [i64; 3] {
    matrix(operation).map(|row| (0..3).map(|k| row[k] * direction[k]).sum())
}

/// The matrix of an operation.
pub(super) fn matrix(operation: &Operation) -> [[i64; 3]; 3] {
    operation.rotation().map(|row| row.map(i64::from))
}

/// The translation of an operation.
pub(super) fn translation(operation: &Operation) -> [Fraction; 3] {
    operation
        .translation()
        .map(|part| Fraction::new(i64::from(*part.numer()), i64::from(*part.denom())))
}
