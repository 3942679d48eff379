//! What the coordinates of a Wyckoff position are: a point, line, plane or all of space, such as
//! `0,y,1/4`.

use std::fmt;

use num_rational::Ratio;

use super::super::change_of_basis::ChangeOfBasis;
use super::super::operation::{DENOMINATOR, Operation, affine};
use super::super::smith::SmithForm;

type Exact = Ratio<i64>;

/// The places that one coordinate triplet describes: `linear · (x, y, z) + shift` for all values
/// of the variables that occur, modulo the lattice.
///
/// ```
/// use ga_design::crystallography::WyckoffPositions;
///
/// let diamond = WyckoffPositions::standard(227);
/// let site = diamond.as_ref().and_then(|all| all.position('f'));
/// let triplet = site.map(|site| site.representative().to_string());
/// assert_eq!(triplet.as_deref(), Some("x,1/8,1/8"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SiteCoordinates {
    /// Row by row; the column of a variable that does not occur is zero.
    linear: [[i32; 3]; 3],
    /// In units of one over [`DENOMINATOR`], each in `0..DENOMINATOR`.
    shift: [i32; 3],
}

impl SiteCoordinates {
    /// `x,y,z`.
    pub(super) const GENERAL: Self = Self {
        linear: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        shift: [0; 3],
    };

    /// Reads `x,2x,1/4`.
    pub(super) fn read(text: &str) -> Option<Self> {
        let map = affine(text).ok()?;
        Self::from_exact(&map.linear, &map.shift)
    }

    fn from_exact(linear: &[[Exact; 3]; 3], shift: &[Exact; 3]) -> Option<Self> {
        let mut site = Self {
            linear: [[0; 3]; 3],
            shift: [0; 3],
        };
        for (row, exact) in site.linear.iter_mut().zip(linear) {
            for (entry, value) in row.iter_mut().zip(exact) {
                *entry = value
                    .is_integer()
                    .then(|| i32::try_from(*value.numer()).ok())??;
            }
        }
        let scale = i64::from(DENOMINATOR);
        for (unit, value) in site.shift.iter_mut().zip(shift) {
            if scale % value.denom() != 0 {
                return None;
            }
            let scaled = value.numer().rem_euclid(*value.denom()) * (scale / value.denom());
            *unit = i32::try_from(scaled).ok()?;
        }
        Some(site)
    }

    /// The factors of the variables x, y, z in the three coordinates, row by row.
    pub fn linear(&self) -> [[i32; 3]; 3] {
        self.linear
    }

    /// The constants of the three coordinates, each in `[0, 1)`.
    pub fn shift(&self) -> [Ratio<i32>; 3] {
        self.shift.map(|unit| Ratio::new(unit, DENOMINATOR))
    }

    /// The number of free variables: 0 for a point, 1 for a line, 2 for a plane, 3 for all of
    /// space.
    pub fn dimension(&self) -> usize {
        self.columns().count()
    }

    fn columns(&self) -> impl Iterator<Item = [i32; 3]> {
        [0, 1, 2]
            .map(|j| self.linear.map(|row| row[j]))
            .into_iter()
            .filter(|column| *column != [0; 3])
    }

    /// The place for given values of the variables, in fractional coordinates.
    pub fn at(&self, variables: [f64; 3]) -> [f64; 3] {
        let mut place = self.shift.map(fraction);
        for (value, row) in place.iter_mut().zip(self.linear) {
            for (factor, variable) in row.iter().zip(variables) {
                *value += f64::from(*factor) * variable;
            }
        }
        place
    }

    /// The image under an operation, with the variables of this triplet, modulo the lattice.
    pub(super) fn image(&self, operation: &Operation) -> Self {
        let w = operation.rotation();
        let linear =
            w.map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * self.linear[k][j]).sum::<i32>()));
        let mut shift = operation.translation_units();
        for (value, row) in shift.iter_mut().zip(w) {
            *value += row.iter().zip(self.shift).map(|(f, s)| f * s).sum::<i32>();
        }
        Self {
            linear,
            shift: shift.map(|unit| unit.rem_euclid(DENOMINATOR)),
        }
    }

    /// The constants as the nearest floating-point numbers.
    pub(super) fn origin(&self) -> [f64; 3] {
        self.shift.map(fraction)
    }

    /// Integer normals: a basis of all that are perpendicular to every direction in here.
    pub(super) fn normals(&self) -> Option<Vec<[i32; 3]>> {
        let rows: Vec<[i128; 3]> = self.columns().map(|c| c.map(i128::from)).collect();
        let kernel = SmithForm::of(&rows)?.kernel();
        let narrow = |normal: [i128; 3]| {
            let [u, v, w] = normal.map(|value| i32::try_from(value).ok());
            Some([u?, v?, w?])
        };
        kernel.into_iter().map(narrow).collect()
    }

    /// The same places in another setting, with variables that stand alone where they can: one
    /// coordinate is `x`, `y` or `z` itself for each.
    pub(super) fn carried(&self, change: &ChangeOfBasis) -> Option<Self> {
        if *change == ChangeOfBasis::identity() {
            return Some(*self);
        }
        let back = change.inverse();
        let (q, p) = (back.linear(), back.shift());
        let old = self
            .linear
            .map(|row| row.map(|v| Exact::from_integer(v.into())));
        let product = |row: &[Exact; 3], column: [Exact; 3]| {
            row[0] * column[0] + row[1] * column[1] + row[2] * column[2]
        };
        let linear = q.map(|row| [0, 1, 2].map(|j| product(&row, old.map(|r| r[j]))));
        let origin = self.shift.map(|u| Exact::new(u.into(), DENOMINATOR.into()));
        let shift = [0, 1, 2].map(|i| product(&q[i], origin) + p[i]);
        let columns: Vec<[Exact; 3]> = [0, 1, 2]
            .map(|j| linear.map(|row| row[j]))
            .into_iter()
            .filter(|column| column.iter().any(|v| *v.numer() != 0))
            .collect();
        let choices: &[&[usize]] = match columns.len() {
            0 => &[&[]],
            1 => &[&[0], &[1], &[2]],
            2 => &[&[0, 1], &[0, 2], &[1, 2]],
            _ => &[&[0, 1, 2]],
        };
        choices
            .iter()
            .find_map(|pivots| solved(&columns, shift, pivots))
            .or_else(|| saturated(&columns, shift))
    }
}

/// The same places with the coordinates `pivots` as variables, if that takes whole numbers only.
fn solved(columns: &[[Exact; 3]], shift: [Exact; 3], pivots: &[usize]) -> Option<SiteCoordinates> {
    let zero = Exact::from_integer(0);
    let mut columns = columns.to_vec();
    // Gauss and Jordan, on the columns.
    for (done, pivot) in pivots.iter().enumerate() {
        let found =
            (done..columns.len()).find(|at| columns.get(*at).is_some_and(|c| c[*pivot] != zero))?;
        columns.swap(done, found);
        let head = columns.get(done)?.map(|v| v / columns[done][*pivot]);
        for (at, column) in columns.iter_mut().enumerate() {
            let times = column[*pivot];
            if at == done {
                *column = head;
            } else {
                for (value, part) in column.iter_mut().zip(head) {
                    *value -= times * part;
                }
            }
        }
    }
    let mut linear = [[zero; 3]; 3];
    let mut origin = shift;
    for (pivot, column) in pivots.iter().zip(&columns) {
        for (i, value) in column.iter().enumerate() {
            linear[i][*pivot] = *value;
            origin[i] -= *value * shift[*pivot];
        }
    }
    SiteCoordinates::from_exact(&linear, &origin)
}

/// The same places with the shortest whole directions for variables.
fn saturated(columns: &[[Exact; 3]], shift: [Exact; 3]) -> Option<SiteCoordinates> {
    let whole = |column: &[Exact; 3]| {
        let scale: i64 = column.iter().map(|value| *value.denom()).product();
        column.map(|value| i128::from((value * scale).to_integer()))
    };
    let rows: Vec<[i128; 3]> = columns.iter().map(whole).collect();
    let normals = SmithForm::of(&rows)?.kernel();
    let directions = SmithForm::of(&normals)?.kernel();
    let mut linear = [[Exact::from_integer(0); 3]; 3];
    for (j, direction) in directions.iter().enumerate() {
        for (i, value) in direction.iter().enumerate() {
            linear[i][j] = Exact::from_integer(i64::try_from(*value).ok()?);
        }
    }
    SiteCoordinates::from_exact(&linear, &shift)
}

fn fraction(unit: i32) -> f64 {
    f64::from(unit) / f64::from(DENOMINATOR)
}

/// `x,2x,1/4`: variables first, fraction last.
impl fmt::Display for SiteCoordinates {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (row, shift)) in self.linear.iter().zip(self.shift()).enumerate() {
            if place > 0 {
                out.write_str(",")?;
            }
            let mut first = true;
            for (factor, name) in row.iter().zip(["x", "y", "z"]) {
                match *factor {
                    0 => continue,
                    1 if first => out.write_str(name)?,
                    1 => write!(out, "+{name}")?,
                    -1 => write!(out, "-{name}")?,
                    other if first => write!(out, "{other}{name}")?,
                    other => write!(out, "{other:+}{name}")?,
                }
                first = false;
            }
            match (*shift.numer(), first) {
                (0, false) => {}
                (_, true) => write!(out, "{shift}")?,
                (_, false) => write!(out, "+{shift}")?,
            }
        }
        Ok(())
    }
}
