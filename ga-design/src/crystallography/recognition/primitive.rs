//! Which primitive cell a group is recognised in: a compact one, so that matrices stay small.

use num_rational::Ratio;

use super::super::change_of_basis::ChangeOfBasis;
use super::super::operation::{DENOMINATOR, Operation};
use super::super::smith::SmithForm;
use super::{Matrix, determinant, times};

type Exact = Ratio<i128>;
type Vector = [i128; 3];

/// The change from the given cell to a primitive one of the same handedness.
pub fn cell(operations: &[Operation]) -> Option<ChangeOfBasis> {
    let scale = i128::from(DENOMINATOR);
    let mut basis = vec![[scale, 0, 0], [0, scale, 0], [0, 0, scale]];
    for translation in operations.iter().filter(|o| o.is_translation()) {
        let mut rows = basis.clone();
        rows.push(translation.translation_units().map(i128::from));
        basis = SmithForm::of(&rows)?.row_lattice();
    }
    let mut edges: [Vector; 3] = basis.try_into().ok()?;
    shorten(&mut edges, &invariant_metric(operations));
    let mut columns = [0, 1, 2].map(|i| edges.map(|edge| edge[i]));
    if determinant(&columns) < 0 {
        columns = columns.map(|row| row.map(|value| -value));
    }
    let linear = columns.map(|row| row.map(|value| Exact::new(value, scale)));
    ChangeOfBasis::from_exact(linear, [Exact::from_integer(0); 3])
}

/// A metric that all operations keep: the sum of Wᵀ W. It stands in for the lengths of the cell,
/// which nobody gave.
fn invariant_metric(operations: &[Operation]) -> Matrix {
    let mut metric = [[0; 3]; 3];
    for operation in operations {
        for row in operation.rotation() {
            for (i, left) in row.iter().enumerate() {
                for (j, right) in row.iter().enumerate() {
                    metric[i][j] += i128::from(left * right);
                }
            }
        }
    }
    metric
}

/// Takes whole multiples of one edge from another as long as that makes it shorter.
fn shorten(edges: &mut [Vector; 3], metric: &Matrix) {
    let dot = |u: &Vector, v: &Vector| {
        let lowered = times(metric, v);
        u[0] * lowered[0] + u[1] * lowered[1] + u[2] * lowered[2]
    };
    let mut shorter = true;
    // Each round makes the sum of the squares of the lengths, a positive integer, smaller.
    while shorter {
        shorter = false;
        for (i, j) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
            let (long, short) = (edges[i], edges[j]);
            let size = dot(&short, &short);
            let steps = (2 * dot(&long, &short) + size).div_euclid(2 * size.max(1));
            let cut = [0, 1, 2].map(|k| long[k] - steps * short[k]);
            if dot(&cut, &cut) < dot(&long, &long) {
                edges[i] = cut;
                shorter = true;
            }
        }
    }
}
