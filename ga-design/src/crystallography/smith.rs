//! How integer matrices with three columns are brought to Smith's normal form, and what that
//! solves: linear equations modulo the lattice, and the lattice vectors in a plane or on a line.

use num_rational::Ratio;

type Exact = Ratio<i128>;

/// `left · matrix · right = diagonal`, with unimodular `left` and `right`.
///
/// The diagonal entries are not made to divide one another: nothing here needs that.
#[derive(Clone, Debug)]
pub struct SmithForm {
    left: Vec<Vec<i128>>,
    right: [[i128; 3]; 3],
    diagonal: Vec<i128>,
}

impl SmithForm {
    /// The normal form of a matrix given row by row.
    ///
    /// `None` when a number outgrows 60 bits on the way, which small matrices never do.
    pub fn of(rows: &[[i128; 3]]) -> Option<Self> {
        let mut work = Work {
            matrix: rows.to_vec(),
            left: (0..rows.len())
                .map(|i| (0..rows.len()).map(|j| i128::from(i == j)).collect())
                .collect(),
            right: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        };
        let mut diagonal = Vec::new();
        while let Some((row, column)) = work.smallest(diagonal.len()) {
            let place = diagonal.len();
            work.exchange_rows(place, row);
            work.exchange_columns(place, column);
            // Each round makes the pivot smaller, so that this ends.
            if work.clear(place)? {
                diagonal.push(work.matrix.get(place)?.get(place).copied()?);
            }
        }
        Some(Self {
            left: work.left,
            right: work.right,
            diagonal,
        })
    }

    /// The lattice vectors that the matrix carries to zero: a basis of all integer ones.
    pub fn kernel(&self) -> Vec<[i128; 3]> {
        (self.diagonal.len()..3)
            .map(|column| self.right.map(|row| row[column]))
            .collect()
    }

    /// A basis of the lattice that the rows generate: as many vectors as the rank.
    pub fn row_lattice(&self) -> Vec<[i128; 3]> {
        // left · matrix = diagonal · right⁻¹, and left changes the generators only.
        let v = &self.right;
        let cofactor = |i: usize, j: usize| {
            let (r1, r2, c1, c2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
            v[r1][c1] * v[r2][c2] - v[r1][c2] * v[r2][c1]
        };
        let sign = v[0][0] * cofactor(0, 0) + v[0][1] * cofactor(0, 1) + v[0][2] * cofactor(0, 2);
        let row =
            |(place, pivot): (usize, &i128)| [0, 1, 2].map(|j| sign * cofactor(j, place) * pivot);
        self.diagonal.iter().enumerate().map(row).collect()
    }

    /// One exact solution of `matrix · x ≡ target` modulo 1 in every row; `None` without any.
    pub fn solve_modulo_one(&self, target: &[Exact]) -> Option<[Exact; 3]> {
        let mut solution = [Exact::from_integer(0); 3];
        for (place, row) in self.left.iter().enumerate() {
            let value: Exact = row.iter().zip(target).map(|(f, t)| *t * *f).sum();
            match self.diagonal.get(place) {
                Some(pivot) => {
                    for (part, factors) in solution.iter_mut().zip(&self.right) {
                        *part += value / *pivot * factors[place];
                    }
                }
                None if value.is_integer() => {}
                None => return None,
            }
        }
        Some(solution)
    }
}

struct Work {
    matrix: Vec<[i128; 3]>,
    left: Vec<Vec<i128>>,
    right: [[i128; 3]; 3],
}

impl Work {
    /// Where the entry nearest to zero (but not zero) stands, from `place` on.
    fn smallest(&self, place: usize) -> Option<(usize, usize)> {
        let mut best: Option<(i128, usize, usize)> = None;
        for (i, row) in self.matrix.iter().enumerate().skip(place) {
            for (j, entry) in row.iter().enumerate().skip(place) {
                let size = entry.abs();
                if size != 0 && best.is_none_or(|(least, _, _)| size < least) {
                    best = Some((size, i, j));
                }
            }
        }
        best.map(|(_, i, j)| (i, j))
    }

    fn exchange_rows(&mut self, one: usize, other: usize) {
        self.matrix.swap(one, other);
        self.left.swap(one, other);
    }

    fn exchange_columns(&mut self, one: usize, other: usize) {
        for row in self.matrix.iter_mut().chain(&mut self.right) {
            row.swap(one, other);
        }
    }

    /// Takes multiples of the pivot row and column from the others; whether nothing was left over.
    fn clear(&mut self, place: usize) -> Option<bool> {
        const LARGEST: i128 = 1 << 60;
        let pivot_row = *self.matrix.get(place)?;
        let pivot = *pivot_row.get(place)?;
        let pivot_left = self.left.get(place)?.clone();
        let mut clean = true;
        let rows = self.matrix.iter_mut().zip(&mut self.left).enumerate();
        for (_, (row, left)) in rows.filter(|(i, _)| *i != place) {
            let times = row.get(place)?.div_euclid(pivot);
            for (entry, part) in row.iter_mut().zip(pivot_row) {
                *entry -= times * part;
            }
            for (entry, part) in left.iter_mut().zip(&pivot_left) {
                *entry -= times * part;
            }
            clean &= *row.get(place)? == 0;
        }
        for column in (0..3).filter(|column| *column != place) {
            let entry = *self.matrix.get(place)?.get(column)?;
            let times = entry.div_euclid(pivot);
            clean &= entry == times * pivot;
            for row in self.matrix.iter_mut().chain(&mut self.right) {
                row[column] -= times * row[place];
            }
        }
        let small = |value: &i128| value.abs() < LARGEST;
        let all = self.matrix.iter().chain(&self.right).flatten();
        let fits = all.chain(self.left.iter().flatten()).all(small);
        fits.then_some(clean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(numerator: i128, denominator: i128) -> Exact {
        Exact::new(numerator, denominator)
    }

    fn times(rows: &[[i128; 3]], x: [Exact; 3]) -> Vec<Exact> {
        rows.iter()
            .map(|row| row.iter().zip(x).map(|(f, v)| v * *f).sum())
            .collect()
    }

    #[test]
    fn the_kernel_is_annihilated_and_saturated() {
        let rows = [[2, 4, 6], [1, 2, 3], [0, 0, 0]];
        let kernel = SmithForm::of(&rows).expect("small").kernel();
        assert_eq!(kernel.len(), 2);
        for vector in &kernel {
            let image = times(&rows, vector.map(Exact::from_integer));
            assert!(image.iter().all(|v| *v.numer() == 0));
        }
        // The cross product of a saturated basis is the primitive normal.
        let [u, v] = [kernel[0], kernel[1]];
        let cross = [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            u[j] * v[k] - u[k] * v[j]
        });
        assert!(cross == [1, 2, 3] || cross == [-1, -2, -3], "{cross:?}");
    }

    #[test]
    fn equations_modulo_one_are_solved_or_refused() {
        let rows = [[-2, 0, 0], [0, -2, 0], [3, 1, 0]];
        let form = SmithForm::of(&rows).expect("small");
        let target = [exact(1, 2), exact(1, 3), exact(-11, 12)];
        if let Some(x) = form.solve_modulo_one(&target) {
            for (value, wanted) in times(&rows, x).iter().zip(target) {
                assert!((value - wanted).is_integer());
            }
        } else {
            panic!("-2x = 1/2, -2y = 1/3, 3x + y = -11/12 has the solution -1/4, -1/6");
        }
        // A screw part is no matter of the origin.
        let screw = [[-2, 0, 0], [0, -2, 0], [0, 0, 0]];
        let form = SmithForm::of(&screw).expect("small");
        let target = [exact(0, 1), exact(0, 1), exact(1, 2)];
        assert_eq!(form.solve_modulo_one(&target), None);
    }

    #[test]
    fn an_empty_matrix_leaves_everything_free() {
        let form = SmithForm::of(&[]).expect("empty");
        assert_eq!(form.kernel().len(), 3);
        assert_eq!(form.solve_modulo_one(&[]), Some([exact(0, 1); 3]));
    }
}
