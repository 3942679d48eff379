//! How coordinates and operations change with the cell and the origin: exact affine maps between
//! settings.

use std::fmt;
use std::str::FromStr;

use num_rational::Ratio;

use super::operation::{DENOMINATOR, Operation, OperationError, affine};

mod print;

type Exact = Ratio<i128>;
type Matrix = [[Exact; 3]; 3];
type Column = [Exact; 3];

/// Every entry is a whole multiple of one over this number: the denominator of operations, times
/// 24 for the origin.
///
/// Together with [`LARGEST_VALUE`] this keeps every product and inverse far inside 128 bits.
const FINEST: i128 = DENOMINATOR as i128 * 24;

/// The largest absolute value of an entry.
const LARGEST_VALUE: i128 = 100_000;

/// A change of cell and origin, `(P, p)` of *International Tables* A, 1.5.1.
///
/// The new edges are `(a′, b′, c′) = (a, b, c) P` and the new origin lies at `p` in the old
/// coordinates, so that a point has `x = P x′ + p`: the map carries **new coordinates to old
/// ones**. An operation becomes `S′ = (P, p)⁻¹ S (P, p)`.
///
/// ```
/// use ga_design::crystallography::{ChangeOfBasis, Operation};
///
/// // The second setting of the monoclinic system: c is the unique axis.
/// let change: ChangeOfBasis = "y,z,x".parse()?;
/// let screw: Operation = "-x,y+1/2,-z".parse()?;
/// assert_eq!(change.operation(&screw), "-x,-y,z+1/2".parse().ok());
/// # Ok::<(), ga_design::crystallography::ChangeOfBasisError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ChangeOfBasis {
    linear: Matrix,
    shift: Column,
}

/// Why a text is no change of basis.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ChangeOfBasisError {
    /// The triplet cannot be read.
    #[error(transparent)]
    Triplet(#[from] OperationError),
    /// It cannot be undone, or its numbers are beyond any crystal.
    #[error(
        "the change of basis has no inverse, or numbers beyond 100000 or finer than 1/{FINEST}"
    )]
    Singular,
}

impl ChangeOfBasis {
    /// The same cell and origin.
    pub fn identity() -> Self {
        Self {
            linear: identity(),
            shift: [Exact::from_integer(0); 3],
        }
    }

    /// The change with matrix `linear`, row by row (its columns are the new edges), and new origin
    /// `shift`, both in the old basis.
    ///
    /// `None` when it cannot be undone, or it or its inverse has numbers beyond 100 000 or finer
    /// than 1/120 960.
    pub fn new(linear: [[Ratio<i64>; 3]; 3], shift: [Ratio<i64>; 3]) -> Option<Self> {
        let written = linear.iter().flatten().chain(&shift);
        if written.into_iter().any(|value| *value.denom() == 0) {
            return None;
        }
        Self::from_exact(linear.map(|row| row.map(wide)), shift.map(wide))
    }

    /// As [`ChangeOfBasis::new`].
    pub(super) fn from_exact(linear: Matrix, shift: Column) -> Option<Self> {
        let change = Self { linear, shift };
        // The inverse is kept in bounds as well, so that every change can be undone.
        (change.in_bounds() && change.undone()?.in_bounds()).then_some(change)
    }

    fn in_bounds(&self) -> bool {
        self.linear
            .iter()
            .flatten()
            .chain(&self.shift)
            .all(|value| {
                FINEST % value.denom() == 0
                    && (value.numer() / value.denom()).unsigned_abs() < LARGEST_VALUE.unsigned_abs()
            })
    }

    /// The matrix `P`, row by row; its columns are the new edges in the old basis.
    pub fn linear(&self) -> [[Ratio<i64>; 3]; 3] {
        self.linear.map(|row| row.map(narrow))
    }

    /// The new origin `p` in old coordinates.
    pub fn shift(&self) -> [Ratio<i64>; 3] {
        self.shift.map(narrow)
    }

    /// The volume of the new cell in old cells; negative when the handedness changes.
    pub fn determinant(&self) -> Ratio<i64> {
        narrow(determinant(&self.linear))
    }

    /// The change back: from the new setting to the old one.
    ///
    /// ```
    /// use ga_design::crystallography::ChangeOfBasis;
    ///
    /// let change: ChangeOfBasis = "x-y+1/4,x+y,z".parse()?;
    /// assert_eq!(change.then(&change.inverse()), Some(ChangeOfBasis::identity()));
    /// # Ok::<(), ga_design::crystallography::ChangeOfBasisError>(())
    /// ```
    pub fn inverse(&self) -> Self {
        // Checked when the change was made.
        self.undone().unwrap_or(*self)
    }

    fn undone(&self) -> Option<Self> {
        let linear = inverse(&self.linear)?;
        let shift = image(&linear, &self.shift).map(|value| -value);
        Some(Self { linear, shift })
    }

    /// This change, followed by one that starts from the new setting.
    ///
    /// `None` when the numbers leave the bounds of [`ChangeOfBasis::new`].
    pub fn then(&self, next: &Self) -> Option<Self> {
        let linear = product(&self.linear, &next.linear);
        let shift = sum(&image(&self.linear, &next.shift), &self.shift);
        Self::from_exact(linear, shift)
    }

    /// An operation in the new setting, modulo the new lattice.
    ///
    /// `None` when it has no integer matrix there, or a translation finer than operations know:
    /// then it does not belong to a group that has the new cell.
    pub fn operation(&self, old: &Operation) -> Option<Operation> {
        let linear = inverse(&self.linear)?;
        let rotation = old
            .rotation()
            .map(|row| row.map(|entry| Exact::from_integer(entry.into())));
        let moved = sum(&image(&rotation, &self.shift), &units(old));
        let translation = image(&linear, &difference(&moved, &self.shift));
        operation(
            &product(&product(&linear, &rotation), &self.linear),
            &translation,
        )
    }

    /// What the old lattice translations become in the new setting: the three old edges, as
    /// operations. Those that are not the identity are centring translations of a larger new cell.
    pub fn old_lattice(&self) -> Option<[Operation; 3]> {
        let linear = inverse(&self.linear)?;
        let mut edges = [Operation::IDENTITY; 3];
        for (axis, edge) in edges.iter_mut().enumerate() {
            *edge = operation(&identity(), &linear.map(|row| row[axis]))?;
        }
        Some(edges)
    }

    /// All operations of a group in the new setting, modulo the new lattice, the identity first.
    ///
    /// A larger cell gains centring translations, a smaller one loses them. `None` when an
    /// operation does not exist there (see [`ChangeOfBasis::operation`]), or when a new edge is no
    /// translation of the group.
    ///
    /// ```
    /// use ga_design::crystallography::{ChangeOfBasis, SpaceGroup};
    ///
    /// let diamond = SpaceGroup::standard(227).and_then(|group| group.operations().ok());
    /// let primitive: ChangeOfBasis = "1/2y+1/2z,1/2x+1/2z,1/2x+1/2y".parse()?;
    /// let found = diamond.and_then(|operations| primitive.operations(&operations));
    /// assert_eq!(found.map(|operations| operations.len()), Some(48));
    /// # Ok::<(), ga_design::crystallography::ChangeOfBasisError>(())
    /// ```
    pub fn operations(&self, old: &[Operation]) -> Option<Vec<Operation>> {
        for axis in 0..3 {
            let edge = operation(&identity(), &self.linear.map(|row| row[axis]))?;
            if edge != Operation::IDENTITY && !old.contains(&edge) {
                return None;
            }
        }
        let mut generators = self.old_lattice()?.to_vec();
        for operation in old {
            generators.push(self.operation(operation)?);
        }
        super::close(&generators).ok()
    }

    /// The old coordinates of a point given in new ones: `P x′ + p`.
    pub fn to_old(&self, new: [f64; 3]) -> [f64; 3] {
        let mut point = self.shift.map(float);
        for (value, row) in point.iter_mut().zip(&self.linear) {
            for (factor, part) in row.iter().zip(new) {
                *value += float(*factor) * part;
            }
        }
        point
    }

    /// The new coordinates of a point given in old ones.
    pub fn to_new(&self, old: [f64; 3]) -> [f64; 3] {
        self.inverse().to_old(old)
    }
}

/// Reads the map from new coordinates to old ones: `x = P x′ + p`, such as `x-y,x+y,z+1/4`.
impl FromStr for ChangeOfBasis {
    type Err = ChangeOfBasisError;

    fn from_str(text: &str) -> Result<Self, ChangeOfBasisError> {
        let map = affine(text)?;
        Self::new(map.linear, map.shift).ok_or(ChangeOfBasisError::Singular)
    }
}

/// The map from new coordinates to old ones, `x-y,x+y,z+1/4`; it reads back.
impl fmt::Display for ChangeOfBasis {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        print::write(out, &self.linear, &self.shift)
    }
}

/// An operation from exact parts; `None` when they are no integers or too fine.
fn operation(rotation: &Matrix, translation: &Column) -> Option<Operation> {
    let mut entries = [[0; 3]; 3];
    for (row, exact) in entries.iter_mut().zip(rotation) {
        for (entry, value) in row.iter_mut().zip(exact) {
            if !value.is_integer() {
                return None;
            }
            *entry = i32::try_from(*value.numer()).ok()?;
        }
    }
    let scale = i128::from(DENOMINATOR);
    let mut parts = [0; 3];
    for (part, value) in parts.iter_mut().zip(translation) {
        if scale % value.denom() != 0 {
            return None;
        }
        let scaled = value.numer().rem_euclid(*value.denom()) * (scale / value.denom());
        *part = i32::try_from(scaled).ok()?;
    }
    Operation::from_units(entries, parts)
}

/// The translation of an operation.
fn units(operation: &Operation) -> Column {
    operation
        .translation_units()
        .map(|unit| Exact::new(unit.into(), DENOMINATOR.into()))
}

fn wide(value: Ratio<i64>) -> Exact {
    Exact::new((*value.numer()).into(), (*value.denom()).into())
}

/// Of a value in bounds, so that it fits.
fn narrow(value: Exact) -> Ratio<i64> {
    let part = |whole: &i128| i64::try_from(*whole).unwrap_or(i64::MAX);
    Ratio::new(part(value.numer()), part(value.denom()))
}

fn float(value: Exact) -> f64 {
    *value.numer() as f64 / *value.denom() as f64
}

fn identity() -> Matrix {
    Operation::IDENTITY
        .rotation()
        .map(|row| row.map(|entry| Exact::from_integer(entry.into())))
}

fn image(matrix: &Matrix, vector: &Column) -> Column {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

fn sum(left: &Column, right: &Column) -> Column {
    [0, 1, 2].map(|i| left[i] + right[i])
}

fn difference(left: &Column, right: &Column) -> Column {
    [0, 1, 2].map(|i| left[i] - right[i])
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    left.map(|row| {
        [0, 1, 2].map(|j| row[0] * right[0][j] + row[1] * right[1][j] + row[2] * right[2][j])
    })
}

fn cofactor(m: &Matrix, i: usize, j: usize) -> Exact {
    // The signs are carried by the cyclic order of the indices.
    let (r1, r2, c1, c2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
    m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
}

fn determinant(m: &Matrix) -> Exact {
    m[0][0] * cofactor(m, 0, 0) + m[0][1] * cofactor(m, 0, 1) + m[0][2] * cofactor(m, 0, 2)
}

fn inverse(m: &Matrix) -> Option<Matrix> {
    let volume = determinant(m);
    if *volume.numer() == 0 {
        return None;
    }
    Some([0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(m, j, i) / volume)))
}
