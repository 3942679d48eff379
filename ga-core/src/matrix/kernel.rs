//! The product itself: transform, multiply, transform back.

#![expect(
    clippy::needless_range_loop,
    reason = "loops over arrays of known size are unrolled, with the tables as constants, where \
              they are short, and vectorised everywhere; iterators over these are not"
)]

use super::{Isomorphism, Term};
use crate::Scalar;

/// The signs of the products of the units 1, i, j, k: `κ_c κ_d = ± κ_{c ⊕ d}`.
const NEGATIVE: [[bool; 4]; 4] = [
    [false, false, false, false],
    [false, true, false, true],
    [false, true, true, false],
    [false, false, true, true],
];

/// Matrices by rows, all blocks together.
type Rows<T, const HEIGHT: usize, const WIDTH: usize> = [[T; WIDTH]; HEIGHT];

impl<const HEIGHT: usize, const WIDTH: usize, const UNITS: usize>
    Isomorphism<'_, HEIGHT, WIDTH, UNITS>
{
    const SIZE: usize = HEIGHT * WIDTH;

    /// The number of rows and columns of one block.
    const ROWS: usize = WIDTH / UNITS;

    /// The geometric product of two elements given by their coefficients, whose numbers are
    /// powers of two; `half` is the number ½.
    #[inline(always)]
    pub fn product<T: Scalar, const A: usize, const B: usize, const R: usize>(
        &self,
        half: T,
        a: &[T; A],
        b: &[T; B],
    ) -> [T; R] {
        let (a, b) = (with_negatives(a), with_negatives(b));
        let mut result = [T::ZERO; R];
        for part in 0..R / Self::SIZE {
            let mut sum = [[T::ZERO; WIDTH]; HEIGHT];
            for term in self.terms {
                if term.part == part {
                    self.add_term(term, &a, &b, &mut sum);
                }
            }
            self.read_off(half, sum, part, &mut result);
        }
        result
    }

    /// Adds the product of two matrices, entries by row and column.
    #[inline(always)]
    fn add_term<T: Scalar, const A: usize, const B: usize>(
        &self,
        term: &Term<'_>,
        a: &[[T; A]; 2],
        b: &[[T; B]; 2],
        sum: &mut Rows<T, HEIGHT, WIDTH>,
    ) {
        let mut left = [[T::ZERO; WIDTH]; HEIGHT];
        let mut right = [[T::ZERO; WIDTH]; HEIGHT];
        Self::gather(a, term.left, &mut left);
        Self::gather(b, term.right, &mut right);
        self.transform::<T, false>(&mut left);
        self.transform::<T, false>(&mut right);
        Self::align(&mut right);
        Self::multiply(&left, &Self::multiples(&right), sum);
    }

    /// The coefficients of one part of the result.
    #[inline(always)]
    fn read_off<T: Scalar, const R: usize>(
        &self,
        half: T,
        mut sum: Rows<T, HEIGHT, WIDTH>,
        part: usize,
        result: &mut [T; R],
    ) {
        Self::align(&mut sum);
        self.transform::<T, true>(&mut sum);
        let mut scale = T::ONE;
        for _ in 0..HEIGHT.trailing_zeros() {
            scale *= half;
        }
        let mut signed = [[[T::ZERO; WIDTH]; HEIGHT]; 2];
        for r in 0..HEIGHT {
            for w in 0..WIDTH {
                signed[0][r][w] = sum[r][w] * scale;
                signed[1][r][w] = -(sum[r][w] * scale);
            }
        }
        for n in 0..R {
            let (negative, position) = read(self.result, n);
            if R == Self::SIZE || position / Self::SIZE == part {
                let position = position % Self::SIZE;
                result[n] = signed[negative][position / WIDTH][position % WIDTH];
            }
        }
    }

    /// The coefficients in the places of a table.
    #[inline(always)]
    fn gather<T: Scalar, const N: usize>(
        x: &[[T; N]; 2],
        table: &[u8],
        to: &mut Rows<T, HEIGHT, WIDTH>,
    ) {
        for r in 0..HEIGHT {
            for w in 0..WIDTH {
                let (negative, position) = read(table, r * WIDTH + w);
                to[r][w] = x[negative][position % N];
            }
        }
    }

    /// From coefficients of g^a to entries at row r, or back but for the factor.
    #[inline(always)]
    fn transform<T: Scalar, const BACK: bool>(&self, x: &mut Rows<T, HEIGHT, WIDTH>) {
        for stage in 0..HEIGHT.trailing_zeros() {
            let stride = 1 << stage;
            let pair = self.pairs & stride != 0;
            for r in 0..HEIGHT {
                if r & stride != 0 {
                    continue;
                }
                for w in 0..WIDTH {
                    let (u, v) = (x[r][w], x[(r + stride) % HEIGHT][w]);
                    let (above, below) = if !pair || w & stride == 0 {
                        (u + v, u - v)
                    } else if BACK {
                        (u + u, v)
                    } else {
                        (u, v + v)
                    };
                    x[r][w] = above;
                    x[(r + stride) % HEIGHT][w] = below;
                }
            }
        }
    }

    /// Entries by the column t instead of by r ⊕ t, or back.
    #[inline(always)]
    fn align<T: Scalar>(x: &mut Rows<T, HEIGHT, WIDTH>) {
        for r in 0..HEIGHT {
            let row = x[r];
            for w in 0..WIDTH {
                x[r][w] = row[(w ^ (r % Self::ROWS)) % WIDTH];
            }
        }
    }

    /// The rows of a matrix times each unit from the left.
    #[inline(always)]
    fn multiples<T: Scalar>(x: &Rows<T, HEIGHT, WIDTH>) -> [[[T; WIDTH]; UNITS]; HEIGHT] {
        let mut multiples = [[[T::ZERO; WIDTH]; UNITS]; HEIGHT];
        for r in 0..HEIGHT {
            for c in 0..UNITS {
                for d in 0..UNITS {
                    for t in 0..Self::ROWS {
                        let value = x[r][d * Self::ROWS + t];
                        multiples[r][c][(c ^ d) * Self::ROWS + t] =
                            if NEGATIVE[c][d] { -value } else { value };
                    }
                }
            }
        }
        multiples
    }

    /// Adds a product: the left matrix by r ⊕ s, the right one and the sum by column.
    #[inline(always)]
    fn multiply<T: Scalar>(
        left: &Rows<T, HEIGHT, WIDTH>,
        right: &[[[T; WIDTH]; UNITS]; HEIGHT],
        sum: &mut Rows<T, HEIGHT, WIDTH>,
    ) {
        if WIDTH <= 8 {
            Self::multiply_rows(left, right, sum);
        } else {
            Self::multiply_tiles::<T, 4, 8>(left, right, sum);
        }
    }

    /// The same row by row.
    #[inline(always)]
    fn multiply_rows<T: Scalar>(
        left: &Rows<T, HEIGHT, WIDTH>,
        right: &[[[T; WIDTH]; UNITS]; HEIGHT],
        sum: &mut Rows<T, HEIGHT, WIDTH>,
    ) {
        for r in 0..HEIGHT {
            let mut total = sum[r];
            for c in 0..UNITS {
                for b in 0..Self::ROWS {
                    let factor = left[r][c * Self::ROWS + b];
                    let multiple = &right[(r ^ b) % HEIGHT][c];
                    for w in 0..WIDTH {
                        total[w] = total[w].plus_product(factor, multiple[w]);
                    }
                }
            }
            sum[r] = total;
        }
    }

    /// The same for tiles of so many rows and columns, small enough to stay in registers.
    #[inline(always)]
    fn multiply_tiles<T: Scalar, const TALL: usize, const WIDE: usize>(
        left: &Rows<T, HEIGHT, WIDTH>,
        right: &[[[T; WIDTH]; UNITS]; HEIGHT],
        sum: &mut Rows<T, HEIGHT, WIDTH>,
    ) {
        for top in (0..HEIGHT).step_by(TALL) {
            let block = top - top % Self::ROWS;
            for first in (0..WIDTH).step_by(WIDE) {
                let mut tile = [[T::ZERO; WIDE]; TALL];
                for r in 0..TALL {
                    for w in 0..WIDE {
                        tile[r][w] = sum[(top + r) % HEIGHT][(first + w) % WIDTH];
                    }
                }
                for s in block..block + Self::ROWS {
                    for c in 0..UNITS {
                        let multiple = &right[s % HEIGHT][c];
                        for r in 0..TALL {
                            let row = &left[(top + r) % HEIGHT];
                            let b = (top + r) ^ s;
                            let factor = row[(c * Self::ROWS + b) % WIDTH];
                            for w in 0..WIDE {
                                let entry = multiple[(first + w) % WIDTH];
                                tile[r][w] = tile[r][w].plus_product(factor, entry);
                            }
                        }
                    }
                }
                for r in 0..TALL {
                    for w in 0..WIDE {
                        sum[(top + r) % HEIGHT][(first + w) % WIDTH] = tile[r][w];
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn with_negatives<T: Scalar, const N: usize>(x: &[T; N]) -> [[T; N]; 2] {
    let mut both = [*x; 2];
    for n in 0..N {
        both[1][n] = -x[n];
    }
    both
}

/// Whether the sign changes, and the position, of an entry of a table; (0, 0) beyond it.
#[inline(always)]
fn read(table: &[u8], number: usize) -> (usize, usize) {
    match table.get(2 * number..2 * number + 2) {
        Some(&[low, high]) => (
            usize::from(high >> 7),
            usize::from(low) | usize::from(high & 0x7f) << 8,
        ),
        _ => (0, 0),
    }
}
