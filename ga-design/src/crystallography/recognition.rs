//! Which space group a list of operations is, whatever its cell and origin, and how the standard
//! setting leads to it.
//!
//! After R. W. Grosse-Kunstleve, *Acta Cryst.* A55 (1999) 383: a primitive cell, then axes along
//! the symmetry directions, then an origin from linear equations modulo the lattice. Everything
//! is exact and needs no lengths: a symmetry direction is known by the matrices alone.

use std::collections::HashMap;
use std::sync::LazyLock;

use num_rational::Ratio;

use super::change_of_basis::ChangeOfBasis;
use super::direction;
use super::operation::{DENOMINATOR, Operation};
use super::smith::SmithForm;
use super::symbols::{CrystalSystem, SpaceGroup};

mod axes;
mod primitive;
mod setting;

type Exact = Ratio<i128>;
type Matrix = [[i128; 3]; 3];

/// What a list of operations was recognised as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recognition {
    /// The number in International Tables, 1 to 230.
    pub number: u32,
    /// The change of basis that makes the operations of the standard setting these ones; it keeps
    /// the handedness, so that enantiomorphic groups are told apart.
    ///
    /// Where several do (they differ by a symmetry of the group's own pattern of elements, its
    /// normaliser), one is chosen: Wyckoff letters that the normaliser exchanges depend on it.
    pub from_standard: ChangeOfBasis,
}

impl SpaceGroup {
    /// The space group of a closed list of operations modulo the lattice, in any setting, of which
    /// [`SpaceGroup::table`] may know nothing.
    ///
    /// `None` when the list is empty or not closed under composition, or its cell is so far from
    /// any usual one that the change of basis leaves the bounds of [`ChangeOfBasis::new`].
    ///
    /// ```
    /// use ga_design::crystallography::{Operation, SpaceGroup, close};
    ///
    /// // A screw axis along the body diagonal: P 31 in an odd cell, centred by a third of it.
    /// let screw: Operation = "z+1/3,x,y".parse()?;
    /// let found = SpaceGroup::recognise(&close(&[screw])?);
    /// assert_eq!(found.map(|found| found.number), Some(144));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn recognise(operations: &[Operation]) -> Option<Recognition> {
        let mut given = operations.to_vec();
        given.sort_unstable();
        given.dedup();
        if given.is_empty() || super::close(&given).ok()?.len() != given.len() {
            return None;
        }
        // A setting of the table keeps the change, and so the letters, of the table.
        if let Some(known) = Self::identify(&given) {
            return Some(Recognition {
                number: known.number,
                from_standard: known.from_standard()?,
            });
        }
        let to_primitive = primitive::cell(&given)?;
        let mut primitive: Vec<Operation> = given
            .iter()
            .map(|operation| to_primitive.operation(operation))
            .collect::<Option<_>>()?;
        primitive.sort_unstable();
        primitive.dedup();
        let candidates = STANDARDS.get(&Census::of(&primitive))?;
        let axes = axes::candidates(&primitive, candidates.first()?.system)?;
        for standard in candidates {
            for basis in &axes {
                if let Some(change) = standard.matched(&primitive, basis) {
                    return Some(Recognition {
                        number: standard.number,
                        from_standard: change.then(&to_primitive.inverse())?,
                    });
                }
            }
        }
        None
    }
}

/// How many operations there are of each determinant and order, modulo all translations: this
/// tells the 32 point groups apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
struct Census([usize; 14]);

impl Census {
    /// Of operations in a primitive cell, where no two have the same matrix.
    fn of(operations: &[Operation]) -> Self {
        let mut census = Self::default();
        for operation in operations {
            let order = usize::try_from(direction::order(operation)).unwrap_or(0);
            let place = order + if operation.determinant() < 0 { 7 } else { 0 };
            if let Some(count) = census.0.get_mut(place) {
                *count += 1;
            }
        }
        census
    }
}

/// What is compared with: a standard setting.
struct Standard {
    number: u32,
    system: CrystalSystem,
    /// The translations of the cell, in units of one over [`DENOMINATOR`].
    centring: Vec<[i32; 3]>,
    /// Operations that make the group together with the translations.
    generators: Vec<Operation>,
}

static STANDARDS: LazyLock<HashMap<Census, Vec<Standard>>> = LazyLock::new(|| {
    let mut standards: HashMap<Census, Vec<Standard>> = HashMap::new();
    for group in SpaceGroup::table().iter().filter(|group| group.standard) {
        if let Some((census, standard)) = Standard::of(group) {
            standards.entry(census).or_default().push(standard);
        }
    }
    standards
});

impl Standard {
    fn of(group: &SpaceGroup) -> Option<(Census, Self)> {
        let operations = group.operations().ok()?;
        let (translations, others): (Vec<Operation>, Vec<Operation>) = operations
            .iter()
            .partition(|operation| operation.is_translation());
        let mut matrices = Vec::new();
        for operation in &operations {
            if !matrices.contains(&operation.rotation()) {
                matrices.push(operation.rotation());
            }
        }
        let of_matrix = |matrix| operations.iter().find(|o| o.rotation() == matrix).copied();
        let representatives: Vec<Operation> = matrices.into_iter().filter_map(of_matrix).collect();
        let mut generators: Vec<Operation> = Vec::new();
        let mut made = super::close(&translations).ok()?;
        for operation in others {
            if !made.contains(&operation) {
                generators.push(operation);
                let all: Vec<Operation> = translations.iter().chain(&generators).copied().collect();
                made = super::close(&all).ok()?;
            }
        }
        let standard = Self {
            number: group.number,
            system: group.crystal_system(),
            centring: translations
                .iter()
                .map(Operation::translation_units)
                .collect(),
            generators,
        };
        Some((Census::of(&representatives), standard))
    }

    /// The change from this setting to the primitive one, if the edges `basis` (columns, in
    /// primitive coordinates) make the group this one.
    ///
    /// With x_std = M⁻¹ x + q the operation (W₀, w₀) becomes (W, v) with W = M W₀ M⁻¹ and
    /// v = (W − 1) p + M w₀, p = M q: linear equations for p modulo the lattice.
    fn matched(&self, primitive: &[Operation], basis: &Matrix) -> Option<ChangeOfBasis> {
        let volume = determinant(basis);
        if volume != i128::try_from(self.centring.len()).ok()? {
            return None;
        }
        let scale = i128::from(DENOMINATOR);
        let fits = |vector: &[i32; 3]| {
            let moved = times(basis, &vector.map(i128::from));
            moved.iter().all(|value| value % scale == 0)
        };
        if !self.centring.iter().all(fits) {
            return None;
        }
        let adjugate = adjugate(basis);
        let mut rows = Vec::new();
        let mut targets = Vec::new();
        for generator in &self.generators {
            let rotation = generator.rotation().map(|row| row.map(i128::from));
            let carried = product(&product(basis, &rotation), &adjugate);
            let mut matrix = [[0; 3]; 3];
            for (row, wide) in matrix.iter_mut().zip(carried) {
                for (entry, value) in row.iter_mut().zip(wide) {
                    if value % volume != 0 {
                        return None;
                    }
                    *entry = i32::try_from(value / volume).ok()?;
                }
            }
            let there = primitive.iter().find(|o| o.rotation() == matrix)?;
            let moved = times(basis, &generator.translation_units().map(i128::from));
            let units = there.translation_units();
            for (i, row) in matrix.iter().enumerate() {
                let mut equation = row.map(i128::from);
                equation[i] -= 1;
                rows.push(equation);
                targets.push(Exact::new(i128::from(units[i]) - moved[i], scale));
            }
        }
        let origin = SmithForm::of(&rows)?.solve_modulo_one(&targets)?;
        let inverse = adjugate.map(|row| row.map(|value| Exact::new(value, volume)));
        let shift = inverse.map(|row| {
            let value = row[0] * origin[0] + row[1] * origin[1] + row[2] * origin[2];
            value - value.floor()
        });
        ChangeOfBasis::from_exact(inverse, shift)
    }
}

fn times(m: &Matrix, v: &[i128; 3]) -> [i128; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    left.map(|row| {
        [0, 1, 2].map(|j| row[0] * right[0][j] + row[1] * right[1][j] + row[2] * right[2][j])
    })
}

/// The inverse times the determinant.
fn adjugate(m: &Matrix) -> Matrix {
    let cofactor = |i: usize, j: usize| {
        let (r1, r2, c1, c2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(j, i)))
}

fn determinant(m: &Matrix) -> i128 {
    let a = adjugate(m);
    m[0][0] * a[0][0] + m[0][1] * a[1][0] + m[0][2] * a[2][0]
}
