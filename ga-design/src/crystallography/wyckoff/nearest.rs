//! Which Wyckoff position a point belongs to within a tolerance, and where on it the nearest place
//! is.

use super::super::cell::Cell;
use super::coordinates::SiteCoordinates;
use super::{WyckoffPosition, WyckoffPositions};

/// A point and the Wyckoff position that it was found on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedSite<'a> {
    /// The Wyckoff position.
    pub position: &'a WyckoffPosition,
    /// The triplet of it that the point lies on, modulo the lattice.
    pub coordinates: SiteCoordinates,
    /// The nearest place exactly on that triplet, in fractional coordinates and in the same cell
    /// as the point.
    pub place: [f64; 3],
    /// How far that is from the point, in ångström.
    pub distance: f64,
}

impl WyckoffPositions {
    /// The most special position within `tolerance` (ångström) of a point given in fractional
    /// coordinates, and the place on it nearest to the point: points before lines before planes,
    /// among equals the nearest.
    ///
    /// Never more than a tenth of the smallest distance between opposite faces of the cell counts.
    /// `None` when the point or the tolerance is no finite number, or the tolerance is negative.
    ///
    /// ```
    /// use ga_design::crystallography::{Cell, WyckoffPositions};
    ///
    /// let cell = Cell::new([5.64, 5.64, 5.64], [90.0; 3])?;
    /// let halite = WyckoffPositions::standard(225);
    /// let site = halite.as_ref().and_then(|all| all.locate([0.4999, 1.5, 0.5002], &cell, 0.01));
    /// assert_eq!(site.map(|site| (site.position.letter, site.place)), Some(('b', [0.5, 1.5, 0.5])));
    /// # Ok::<(), ga_design::crystallography::CellError>(())
    /// ```
    pub fn locate(&self, point: [f64; 3], cell: &Cell, tolerance: f64) -> Option<LocatedSite<'_>> {
        let finite = point.iter().all(|value| value.abs() < 1e9);
        if !finite || !tolerance.is_finite() || tolerance < 0.0 {
            return None;
        }
        let smallest = cell
            .face_distances()
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let reach = tolerance.min(smallest / 10.0);
        let reciprocal = reciprocal_metric(cell);
        (0..=3).find_map(|dimension| {
            let mut best: Option<LocatedSite<'_>> = None;
            for position in self.positions.iter().filter(|p| p.dimension() == dimension) {
                for (coordinates, normals) in position.coordinates.iter().zip(&position.normals) {
                    let origin = coordinates.origin();
                    let (place, distance) = nearest(origin, normals, point, &reciprocal, cell)?;
                    let least = best.as_ref().map_or(f64::INFINITY, |site| site.distance);
                    if distance <= reach && distance < least {
                        let coordinates = *coordinates;
                        best = Some(LocatedSite {
                            position,
                            coordinates,
                            place,
                            distance,
                        });
                    }
                    // All triplets of the general position are the same place: all of space.
                    if dimension == 3 {
                        break;
                    }
                }
            }
            best
        })
    }
}

/// The nearest place on a triplet, modulo the lattice, and the distance in ångström.
///
/// With integer normals N of the triplet, the lattice translates of it lie where N (x − s) is
/// whole. The shortest step y with N y = r is G⁻¹ Nᵀ (N G⁻¹ Nᵀ)⁻¹ r, G the metric of the cell.
fn nearest(
    origin: [f64; 3],
    normals: &[[i32; 3]],
    point: [f64; 3],
    reciprocal: &[[f64; 3]; 3],
    cell: &Cell,
) -> Option<([f64; 3], f64)> {
    let relative = [0, 1, 2].map(|i| point[i] - origin[i]);
    if normals.len() == 3 {
        // A point: spared the rounding of a linear system.
        let place = [0, 1, 2].map(|i| origin[i] + relative[i].round());
        let step = [0, 1, 2].map(|i| place[i] - point[i]);
        return Some((place, length(cell, step)));
    }
    let normals: Vec<[f64; 3]> = normals.iter().map(|n| n.map(f64::from)).collect();
    let raised: Vec<[f64; 3]> = normals
        .iter()
        .map(|n| [0, 1, 2].map(|i| dot(&reciprocal[i], n)))
        .collect();
    let off: Vec<f64> = normals
        .iter()
        .map(|n| {
            let value = dot(n, &relative);
            value - value.round()
        })
        .collect();
    let mut step = [0.0; 3];
    for (along, weight) in raised.iter().zip(weights(&normals, &raised, &off)?) {
        for (part, value) in step.iter_mut().zip(along) {
            *part -= weight * value;
        }
    }
    let place = [0, 1, 2].map(|i| point[i] + step[i]);
    Some((place, length(cell, step)))
}

/// The solution of (N G⁻¹ Nᵀ) w = r for no, one or two normals.
fn weights(normals: &[[f64; 3]], raised: &[[f64; 3]], off: &[f64]) -> Option<[f64; 2]> {
    match (normals, raised, off) {
        ([], _, _) => Some([0.0, 0.0]),
        ([n], [u], [r]) => Some([r / dot(n, u), 0.0]),
        ([n, m], [u, v], [r, s]) => {
            let (a, b, d) = (dot(n, u), dot(n, v), dot(m, v));
            let determinant = a * d - b * b;
            (determinant > 0.0)
                .then(|| [(r * d - s * b) / determinant, (s * a - r * b) / determinant])
        }
        _ => None,
    }
}

fn length(cell: &Cell, step: [f64; 3]) -> f64 {
    let vector = cell.cartesian(step);
    dot(&vector, &vector).sqrt()
}

/// The scalar products of the reciprocal edges: the inverse of the metric.
fn reciprocal_metric(cell: &Cell) -> [[f64; 3]; 3] {
    let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // The columns of the inverse basis, whose rows are the reciprocal edges.
    let columns = unit.map(|direction| cell.fractional(direction));
    let rows = [0, 1, 2].map(|i| columns.map(|column| column[i]));
    rows.map(|u| rows.map(|v| dot(&u, &v)))
}

fn dot(u: &[f64; 3], v: &[f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}
