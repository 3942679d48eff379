//! Where a motif is put in a group when nobody says where: in general position, as far from its own
//! images as a search finds.

use ga_cga::{Point, Vector3};

use super::Isometry;
use super::lattice::reciprocal;

/// How many places are tried.
const CANDIDATES: u32 = 160;

/// A place in general position, and how much room there is around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralPosition {
    /// The place.
    pub point: Point,
    /// The distance to its nearest image; infinite where there is none. A motif inside a ball of half
    /// this radius touches none of its copies.
    pub clearance: f64,
}

/// The place in the parallelepiped with a corner at `corner` and edges `sides` that is farthest from its
/// own images under isometries and lattice translations, of those that are tried; the same in every call.
///
/// `lattice` holds up to three independent translations, none for a point group; of translations that are
/// far from reduced some images may be missed. The isometries are those of the group modulo the lattice,
/// the identity among them or not.
///
/// ```
/// use ga_cga::{Point, Vector3};
/// use ga_design::crystallography::{Cell, SpaceGroup, general_position};
///
/// let cell = Cell::new([4.0; 3], [90.0; 3])?;
/// let edges = cell.edge_vectors().map(Vector3::from);
/// let versors = SpaceGroup::standard(221).unwrap().versors(&cell)?;
/// let origin = Point::at(0.0, 0.0, 0.0);
/// let found = general_position(&versors, &edges, origin, edges);
/// // No sphere of this radius and its 47 images overlap.
/// assert!(found.clearance > 0.4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn general_position(
    isometries: &[Isometry],
    lattice: &[Vector3],
    corner: Point,
    sides: [Vector3; 3],
) -> GeneralPosition {
    let lattice = Lattice::new(lattice);
    let mut best = GeneralPosition {
        point: corner,
        clearance: -1.0,
    };
    for index in 1..=CANDIDATES {
        let mut place = corner.position();
        for (side, step) in sides.iter().zip(STEPS) {
            place += *side * (f64::from(index) * step).fract();
        }
        let clearance = lattice.clearance(isometries, place);
        if clearance > best.clearance {
            best = GeneralPosition {
                point: Point::from(place),
                clearance,
            };
        }
    }
    best
}

/// The distance from a point to its nearest image under the isometries and the lattice, those that leave
/// it in place not counted; infinite where there is none.
pub fn distance_to_images(isometries: &[Isometry], lattice: &[Vector3], point: Point) -> f64 {
    let lattice = Lattice::new(lattice);
    let place = point.position();
    let turned = isometries
        .iter()
        .flat_map(|isometry| lattice.images(isometry.apply(point).position() - place));
    let moved = lattice.images(Vector3::default());
    let size = 1.0 + place.norm();
    let apart = turned.chain(moved).map(Vector3::norm);
    apart
        .filter(|distance| *distance > 1e-6 * size)
        .fold(f64::INFINITY, f64::min)
}

/// Powers of the inverse of the number with x⁴ = x + 1, whose multiples fill the cube evenly.
const STEPS: [f64; 3] = [
    0.819_172_513_396_164_5,
    0.671_043_606_703_789_3,
    0.549_700_477_901_970_6,
];

/// Translations, and what reduces a vector by them.
struct Lattice {
    edges: Vec<Vector3>,
    /// Empty for edges in one plane, where nothing is reduced.
    duals: Vec<Vector3>,
}

impl Lattice {
    fn new(edges: &[Vector3]) -> Self {
        let full = match edges {
            [a, b, c, ..] => reciprocal([*a, *b, *c]).map(|duals| duals.to_vec()),
            [a, b] => {
                // The dual of the plane's area is a vector across it, which nothing is moved along.
                let across: Vector3 = (*a ^ *b) * ga_cga::Trivector3::new(-1.0);
                reciprocal([*a, *b, across]).map(|[a, b, _]| vec![a, b])
            }
            [a] => a.inverse().map(|dual| vec![dual]),
            [] => None,
        };
        Self {
            edges: edges.iter().take(3).copied().collect(),
            duals: full.unwrap_or_default(),
        }
    }

    /// The vector and what lattice translations make of it, near its shortest.
    fn images(&self, vector: Vector3) -> impl Iterator<Item = Vector3> + '_ {
        let mut reduced = vector;
        for (edge, dual) in self.edges.iter().zip(&self.duals) {
            reduced -= *edge * vector.scalar_product(*dual).round();
        }
        let count = 3_u32.pow(self.edges.len() as u32);
        (0..count).map(move |choice| {
            let mut image = reduced;
            let mut rest = choice;
            for edge in &self.edges {
                image += *edge * (f64::from(rest % 3) - 1.0);
                rest /= 3;
            }
            image
        })
    }

    /// The distance to the nearest image, whichever it is: zero on a symmetry element.
    fn clearance(&self, isometries: &[Isometry], place: Vector3) -> f64 {
        let point = Point::from(place);
        let turned = isometries
            .iter()
            .filter(|isometry| !isometry.is_same(&Isometry::identity(), 1e-9))
            .flat_map(|isometry| self.images(isometry.apply(point).position() - place));
        let own = self.edges.iter().copied();
        turned
            .chain(own)
            .map(Vector3::norm)
            .fold(f64::INFINITY, f64::min)
    }
}
