//! Which letter a mirror or glide plane has: by its shortest glide vectors, as International Tables
//! name them.

use std::fmt;

use super::lattice_basis::{Fraction, dot, modulo_one};
use super::place::LatticePlane;

/// A mirror or glide plane.
///
/// Printed with its letter in *International Tables* A (table 2.1.2.1): `m` for no glide; `a`, `b`, `c`
/// for half an edge; `e` for two of these at once, or for half an edge and half a diagonal, in centred
/// cells; `n` for half a diagonal of a face or, in a plane through body diagonals, of the cell; `d` for
/// a quarter of one; `g` for all others. In hexagonal axes the letters are those of the extended
/// symbols (table 1.5.4.4 there, `P 6 m m` with `b a`): planes that contain an edge `a`, `b` or `a + b`
/// have `a` for half of it, the others `b` for half of `a + 2b` and its like, all of them `n` where
/// half of `c` is added.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReflectionPlane {
    pub(super) place: LatticePlane,
    pub(super) letter: char,
    pub(super) glides: Vec<[Fraction; 3]>,
    pub(super) operations: Vec<usize>,
}

impl ReflectionPlane {
    /// Where it lies, modulo the lattice.
    pub fn place(&self) -> LatticePlane {
        self.place
    }

    /// `m`, `a`, `b`, `c`, `n`, `d`, `e` or `g`.
    pub fn letter(&self) -> char {
        self.letter
    }

    /// The glide vectors in fractions of the cell edges: none for a mirror, two for `e`, otherwise one.
    /// All glides of the plane are these plus lattice translations in the plane.
    pub fn glides(&self) -> &[[Fraction; 3]] {
        &self.glides
    }

    /// The positions, in the list of operations, of those that it is the element of.
    pub fn operations(&self) -> &[usize] {
        &self.operations
    }
}

impl fmt::Display for ReflectionPlane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter)
    }
}

/// The plane of reflections that differ by lattice translations in it, by the glide of one of them.
pub(super) fn named(
    place: LatticePlane,
    glide: [Fraction; 3],
    mut operations: Vec<usize>,
    centrings: &[[Fraction; 3]],
    is_hexagonal: bool,
) -> ReflectionPlane {
    operations.sort_unstable();
    operations.dedup();
    let short = glides(place, glide, centrings);
    let hexagonal = is_hexagonal
        .then(|| hexagonal_letter(place, glide, centrings))
        .flatten();
    let (letter, glides) = match hexagonal {
        Some(letter) => (letter, shortest(&short)),
        None => letter(place, &short),
    };
    ReflectionPlane {
        place,
        letter,
        glides,
        operations,
    }
}

/// All glides of the plane with components from −1/2 to 1/2, the positive ones first.
fn glides(
    place: LatticePlane,
    glide: [Fraction; 3],
    centrings: &[[Fraction; 3]],
) -> Vec<[Fraction; 3]> {
    // A half is a half either way; anything else has one form within the bounds.
    let forms = |part: Fraction| {
        let part = modulo_one(part);
        let bound = Fraction::new(1, 2);
        [part, part - 1]
            .into_iter()
            .filter(move |form| (-bound..=bound).contains(form))
    };
    let mut found = Vec::new();
    for centring in centrings {
        for x in forms(glide[0] + centring[0]) {
            for y in forms(glide[1] + centring[1]) {
                for z in forms(glide[2] + centring[2]) {
                    if dot(place.normal(), [x, y, z]) == Fraction::from(0) {
                        found.push([x, y, z]);
                    }
                }
            }
        }
    }
    if found.is_empty() {
        // A plane of large indices may have no short glide.
        found.push(glide);
    }
    found.sort_by(|u, v| v.cmp(u));
    found.dedup();
    found
}

/// The letter of a glide plane upright in hexagonal axes; `None` for mirrors, glides along `c`, and
/// planes that are not upright.
fn hexagonal_letter(
    place: LatticePlane,
    glide: [Fraction; 3],
    centrings: &[[Fraction; 3]],
) -> Option<char> {
    let [h, k, l] = place.normal();
    if l != 0 {
        return None;
    }
    // Twice a glide is a lattice vector; here one of the cell's own edges is wanted, whole in a and b.
    let zero = Fraction::from(0);
    let shifted = centrings.iter().map(|centring| {
        let twice = |i: usize| (glide[i] + centring[i]) * 2;
        [twice(0), twice(1), modulo_one(glide[2] + centring[2]) * 2]
    });
    let mut upright = shifted.filter(|twice| twice.iter().all(Fraction::is_integer));
    let [u, v, w] = upright.next()?;
    let is_even = |index: Fraction| modulo_one(index / 2) == zero;
    match (is_even(u) && is_even(v), w == zero) {
        (true, _) => None,
        (false, false) => Some('n'),
        // An edge a, b or a + b lies in (010), (100) and (1-10).
        (false, true) if [h, k, h + k].contains(&0) => Some('a'),
        (false, true) => Some('b'),
    }
}

/// The letter of a plane with these glides, and the glides to show.
fn letter(place: LatticePlane, glides: &[[Fraction; 3]]) -> (char, Vec<[Fraction; 3]>) {
    let zero = Fraction::from(0);
    let half = Fraction::new(1, 2);
    let quarter = Fraction::new(1, 4);
    let count = |glide: &[Fraction; 3], part: Fraction| {
        let sizes = glide.iter().map(|x| if *x < zero { -*x } else { *x });
        sizes.filter(|size| *size == part).count()
    };
    // The first, which is the most positive, of those with so many halves, quarters and zeros.
    let with = |halves: usize, quarters: usize| {
        let zeros = 3 - halves - quarters;
        let mut fitting = glides.iter().filter(|glide| {
            count(glide, half) == halves
                && count(glide, quarter) == quarters
                && count(glide, zero) == zeros
        });
        fitting.next().copied()
    };
    let edge = |i: usize| {
        let mut vector = [zero; 3];
        vector[i] = half;
        glides.contains(&vector).then_some(vector)
    };
    let is_face = place.normal().iter().filter(|index| **index != 0).count() == 1;
    if with(0, 0).is_some() {
        return ('m', Vec::new());
    }
    let edges: Vec<_> = (0..3).filter_map(|i| Some((i, edge(i)?))).collect();
    match (edges.as_slice(), with(2, 0), with(3, 0)) {
        ([(_, u), (_, v), ..], _, _) => ('e', vec![*u, *v]),
        ([(_, u)], Some(diagonal), _) => ('e', vec![*u, diagonal]),
        ([(i, u)], None, _) => (['a', 'b', 'c'][*i], vec![*u]),
        ([], Some(diagonal), _) if is_face => ('n', vec![diagonal]),
        ([], _, Some(diagonal)) => ('n', vec![diagonal]),
        _ => match with(0, 2).or(with(0, 3)) {
            Some(quarters) => ('d', vec![quarters]),
            None => ('g', shortest(glides)),
        },
    }
}

/// The glide of least components.
fn shortest(glides: &[[Fraction; 3]]) -> Vec<[Fraction; 3]> {
    let size = |glide: &[Fraction; 3]| glide.iter().map(|x| x * x).sum::<Fraction>();
    let least = glides.iter().min_by_key(|glide| size(glide));
    least.copied().into_iter().collect()
}
