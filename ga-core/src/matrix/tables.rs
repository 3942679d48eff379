//! What a product through matrices needs to know of an algebra: where each coefficient goes.

/// The isomorphism of the elements of given types with matrices, as tables of positions.
///
/// Elements are arrays of coefficients. Matrices have `HEIGHT` rows in all blocks together; a row
/// holds for each of the `UNITS` units 1, i, j, k of its numbers the `WIDTH / UNITS` entries of
/// one block. `HEIGHT`, `WIDTH` and `UNITS` are powers of two, `WIDTH` is 4 or more.
///
/// Entries of tables are two bytes, the lower one first: a position, and the highest bit where
/// the sign changes.
#[derive(Clone, Copy, Debug)]
pub struct Isomorphism<'a, const HEIGHT: usize, const WIDTH: usize, const UNITS: usize> {
    /// The stages of the transform, as bits, that belong to pairs of null vectors.
    pub pairs: usize,
    /// The products of matrices whose sums are the parts of the result.
    pub terms: &'a [Term<'a>],
    /// For each coefficient of the result its position among the entries of all parts.
    pub result: &'a [u8],
}

/// A product of two matrices.
#[derive(Clone, Copy, Debug)]
pub struct Term<'a> {
    /// The part of the result that it is added to.
    pub part: usize,
    /// For each entry of the left matrix, before the transform, its coefficient.
    pub left: &'a [u8],
    /// The same for the right matrix.
    pub right: &'a [u8],
}
