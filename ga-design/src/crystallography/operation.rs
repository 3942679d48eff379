//! What a symmetry operation is: an integer matrix and an exact translation modulo the lattice.

use num_rational::Ratio;

mod expression;
mod print;
mod triplet;

pub(super) use expression::affine;
pub use triplet::OperationError;

/// All translations are whole multiples of one over this number: 2⁴ · 3² · 5 · 7.
///
/// Integer matrices keep such a set closed, so that composing operations can neither round nor
/// overflow. Every translation of the space groups is a multiple of 1/24; the rest leaves room for
/// the fivefold and sevenfold supercells that occur in files.
pub const DENOMINATOR: i32 = 5040;

/// The largest absolute value of a matrix entry that is accepted.
///
/// Conventional settings need 0 and ±1 only; reduced cells of files go a little further.
pub const LARGEST_ENTRY: i32 = 16;

/// A symmetry operation of a crystal in fractional coordinates: `x ↦ W x + w` modulo the lattice.
///
/// `W` is an integer matrix of determinant ±1 (row by row), `w` an exact rational vector with
/// every component in `[0, 1)`. Two operations that differ by a lattice translation are therefore
/// equal, and the operations of a space group form a finite group under [`Operation::then`].
///
/// ```
/// use ga_design::crystallography::Operation;
///
/// let screw: Operation = "-y, x-y, z+1/3".parse()?;
/// assert_eq!(screw.to_string(), "-y,x-y,z+1/3");
/// assert_eq!(screw.then(&screw).and_then(|two| two.then(&screw)), Some(Operation::IDENTITY));
/// # Ok::<(), ga_design::crystallography::OperationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Operation {
    rotation: [[i32; 3]; 3],
    /// In units of one over [`DENOMINATOR`], each in `0..DENOMINATOR`.
    translation: [i32; 3],
}

impl Operation {
    /// `x,y,z`.
    pub const IDENTITY: Self = Self {
        rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        translation: [0; 3],
    };

    /// The operation with matrix `rotation` and translation `translation`, the latter reduced
    /// modulo the lattice.
    ///
    /// `None` when the determinant is not ±1, an entry exceeds [`LARGEST_ENTRY`], or a translation
    /// is no multiple of one over [`DENOMINATOR`].
    pub fn new(rotation: [[i32; 3]; 3], translation: [Ratio<i32>; 3]) -> Option<Self> {
        let mut units = [0; 3];
        for (unit, part) in units.iter_mut().zip(translation) {
            if *part.denom() <= 0 || DENOMINATOR % *part.denom() != 0 {
                return None;
            }
            let numerator = part.numer().rem_euclid(*part.denom());
            *unit = numerator * (DENOMINATOR / *part.denom());
        }
        Self::from_units(rotation, units)
    }

    /// As [`Operation::new`], with the translation in units of one over [`DENOMINATOR`].
    pub(super) fn from_units(rotation: [[i32; 3]; 3], translation: [i32; 3]) -> Option<Self> {
        let small = rotation
            .iter()
            .flatten()
            .all(|entry| (-LARGEST_ENTRY..=LARGEST_ENTRY).contains(entry));
        let operation = Self {
            rotation,
            translation: translation.map(|unit| unit.rem_euclid(DENOMINATOR)),
        };
        (small && operation.determinant().abs() == 1).then_some(operation)
    }

    /// The matrix `W`, row by row.
    pub fn rotation(&self) -> [[i32; 3]; 3] {
        self.rotation
    }

    /// The translation `w`, every component in `[0, 1)`.
    pub fn translation(&self) -> [Ratio<i32>; 3] {
        self.translation.map(|unit| Ratio::new(unit, DENOMINATOR))
    }

    /// The translation as the nearest floating-point numbers.
    pub fn translation_f64(&self) -> [f64; 3] {
        self.translation
            .map(|unit| f64::from(unit) / f64::from(DENOMINATOR))
    }

    /// The determinant of `W`: 1 for rotations and screws, −1 for the operations that turn a left
    /// hand into a right one.
    pub fn determinant(&self) -> i32 {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rotation;
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    }

    /// The trace of `W`; with the determinant it tells the type of the operation
    /// (*International Tables* A, table 1.2.2.1).
    pub fn trace(&self) -> i32 {
        self.rotation[0][0] + self.rotation[1][1] + self.rotation[2][2]
    }

    /// Whether the operation is a lattice or centring translation: `W` is the identity.
    pub fn is_translation(&self) -> bool {
        self.rotation == Self::IDENTITY.rotation
    }

    /// This operation after `first`: `x ↦ self(first(x))`, modulo the lattice.
    ///
    /// `None` when an entry of the product exceeds [`LARGEST_ENTRY`], which happens only to
    /// operations that do not belong to one finite group.
    pub fn after(&self, first: &Self) -> Option<Self> {
        let mut rotation = [[0; 3]; 3];
        let mut translation = self.translation;
        for (i, row) in self.rotation.iter().enumerate() {
            for (k, factor) in row.iter().enumerate() {
                for (entry, other) in rotation[i].iter_mut().zip(first.rotation[k]) {
                    *entry += factor * other;
                }
                translation[i] += factor * first.translation[k];
            }
        }
        Self::from_units(rotation, translation)
    }

    /// `next` after this operation; see [`Operation::after`].
    pub fn then(&self, next: &Self) -> Option<Self> {
        next.after(self)
    }

    /// The operation that undoes this one, modulo the lattice.
    ///
    /// `None` when an entry of the inverse exceeds [`LARGEST_ENTRY`].
    pub fn inverse(&self) -> Option<Self> {
        let w = &self.rotation;
        let sign = self.determinant();
        let mut rotation = [[0; 3]; 3];
        for (i, row) in rotation.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                // The adjugate, its signs carried by the cyclic order of the indices.
                let (r1, r2) = ((j + 1) % 3, (j + 2) % 3);
                let (c1, c2) = ((i + 1) % 3, (i + 2) % 3);
                *entry = sign * (w[r1][c1] * w[r2][c2] - w[r1][c2] * w[r2][c1]);
            }
        }
        let large = rotation
            .iter()
            .flatten()
            .any(|entry| entry.abs() > LARGEST_ENTRY);
        if large {
            return None;
        }
        let translation = rotation.map(|row| {
            -row.iter()
                .zip(self.translation)
                .map(|(entry, unit)| entry * unit)
                .sum::<i32>()
        });
        Self::from_units(rotation, translation)
    }

    /// The image of a point in fractional coordinates; not reduced to the unit cell.
    pub fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        let shift = self.translation_f64();
        let mut image = shift;
        for (value, row) in image.iter_mut().zip(self.rotation) {
            *value += f64::from(row[0]) * point[0]
                + f64::from(row[1]) * point[1]
                + f64::from(row[2]) * point[2];
        }
        image
    }

    /// The translation in units of one over [`DENOMINATOR`].
    pub(super) fn translation_units(&self) -> [i32; 3] {
        self.translation
    }
}
