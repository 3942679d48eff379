//! Which elements a block of cells shows: all lattice translates that reach into it, clipped to it.

use super::lattice_basis::{Fraction, LatticeBasis};
use super::{Axis, InversionCentre, ReflectionPlane, SymmetryElements};
use crate::crystallography::CellRange;

/// The most elements that a block may show.
pub const MOST_ELEMENTS: usize = 20_000;

/// Rounding of positions in cell edges.
const ROUNDING: f64 = 1e-9;

/// More elements than anyone can see.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "these cells have more than {MOST_ELEMENTS} symmetry elements; ask for fewer cells (such as 1x1x1)"
)]
pub struct TooManyElements;

/// The part of an axis in a block of cells; coordinates in fractions of the cell edges.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisSegment<'a> {
    /// The axis.
    pub axis: &'a Axis,
    /// Where it enters and where it leaves the block, in its direction.
    pub ends: [[f64; 3]; 2],
    /// The inversion points on this part, see [`Axis::inversion_points`].
    pub inversion_points: Vec<[f64; 3]>,
}

/// The part of a plane in a block of cells; coordinates in fractions of the cell edges.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanePolygon<'a> {
    /// The plane.
    pub plane: &'a ReflectionPlane,
    /// The corners, in order around the polygon.
    pub corners: Vec<[f64; 3]>,
}

/// An inversion centre in a block of cells; coordinates in fractions of the cell edges.
#[derive(Clone, Debug, PartialEq)]
pub struct CentrePoint<'a> {
    /// The centre.
    pub centre: &'a InversionCentre,
    /// Where it is.
    pub point: [f64; 3],
}

/// The symmetry elements in a block of cells, those on its faces included.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedElements<'a> {
    /// The axes.
    pub axes: Vec<AxisSegment<'a>>,
    /// The planes.
    pub planes: Vec<PlanePolygon<'a>>,
    /// The inversion centres.
    pub centres: Vec<CentrePoint<'a>>,
}

impl SymmetryElements {
    /// The elements in a block of cells.
    ///
    /// ```
    /// use ga_design::crystallography::{CellRange, SpaceGroup, SymmetryElements};
    ///
    /// let group = SpaceGroup::from_symbol("P m -3 m")?[0];
    /// let elements = SymmetryElements::of(&group.operations()?)?;
    /// let placed = elements.within(CellRange::UNIT)?;
    /// // The inversion centres at corners and middles of edges, faces and the cell.
    /// assert_eq!(placed.centres.len(), 27);
    /// // Four diagonals of the cube.
    /// let threefold = placed.axes.iter().filter(|segment| segment.axis.order() == 3);
    /// assert_eq!(threefold.filter(|segment| segment.axis.screw() == 0).count(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TooManyElements`] if there are more than [`MOST_ELEMENTS`].
    pub fn within(&self, range: CellRange) -> Result<PlacedElements<'_>, TooManyElements> {
        let block = Block {
            low: range.low.map(f64::from),
            high: range.high.map(f64::from),
        };
        let axes: Vec<_> = self.axes.iter().map(|axis| block.lines(axis)).collect();
        let planes: Vec<_> = self
            .planes
            .iter()
            .map(|plane| block.offsets(plane))
            .collect();
        let centres: Vec<_> = self
            .centres
            .iter()
            .map(|centre| block.points(centre))
            .collect();
        let grids = axes.iter().map(|(_, steps)| steps.as_slice());
        let rows = planes.iter().map(std::slice::from_ref);
        let boxes = centres.iter().map(<[Steps; 3]>::as_slice);
        let count = |steps: &[Steps]| steps.iter().map(Steps::count).product::<f64>();
        let all: f64 = grids.chain(rows).chain(boxes).map(count).sum();
        if all > MOST_ELEMENTS as f64 {
            return Err(TooManyElements);
        }
        let axes = self.axes.iter().zip(axes);
        let planes = self.planes.iter().zip(planes);
        let centres = self.centres.iter().zip(centres);
        Ok(PlacedElements {
            axes: axes
                .flat_map(|(axis, (basis, steps))| block.segments(axis, basis, steps))
                .collect(),
            planes: planes
                .flat_map(|(plane, steps)| {
                    let all = steps
                        .values()
                        .filter_map(|offset| block.polygon(plane, offset));
                    all.collect::<Vec<_>>()
                })
                .collect(),
            centres: centres
                .flat_map(|(centre, [xs, ys, zs])| {
                    let xy = xs
                        .values()
                        .flat_map(move |x| ys.values().map(move |y| (x, y)));
                    let all = xy.flat_map(move |(x, y)| zs.values().map(move |z| [x, y, z]));
                    all.map(move |point| CentrePoint { centre, point })
                })
                .collect(),
        })
    }
}

/// A start and all whole steps from it that stay between two bounds.
#[derive(Clone, Copy, Debug)]
struct Steps {
    start: f64,
    first: f64,
    last: f64,
}

impl Steps {
    fn between(start: f64, low: f64, high: f64) -> Self {
        Self {
            start,
            first: (low - start - ROUNDING).ceil(),
            last: (high - start + ROUNDING).floor(),
        }
    }

    fn count(&self) -> f64 {
        (self.last - self.first + 1.0).max(0.0)
    }

    fn values(self) -> impl Iterator<Item = f64> + use<> {
        // Counted before: a number that an integer holds.
        let count = self.count() as u64;
        (0..count).map(move |i| self.start + self.first + i as f64)
    }
}

/// A block of cells in fractions of the cell edges.
#[derive(Clone, Copy, Debug)]
struct Block {
    low: [f64; 3],
    high: [f64; 3],
}

impl Block {
    /// The translates of a form's value that occur in the block.
    fn steps(&self, form: [i64; 3], start: Fraction) -> Steps {
        let mut bounds = [0.0; 2];
        for (i, index) in form.into_iter().enumerate() {
            let sides = [self.low[i], self.high[i]].map(|side| side * index as f64);
            bounds[0] += sides[0].min(sides[1]);
            bounds[1] += sides[0].max(sides[1]);
        }
        Steps::between(float(start), bounds[0], bounds[1])
    }

    /// The translates of a line, by the two coordinates across it.
    fn lines(&self, axis: &Axis) -> (LatticeBasis, [Steps; 2]) {
        let basis = LatticeBasis::completing(axis.line().direction());
        let [across, aside, _] = basis.forms();
        let [x, y, _] = basis.coordinates(axis.line().point());
        (basis, [self.steps(across, x), self.steps(aside, y)])
    }

    fn offsets(&self, plane: &ReflectionPlane) -> Steps {
        self.steps(plane.place().normal(), plane.place().offset())
    }

    fn points(&self, centre: &InversionCentre) -> [Steps; 3] {
        let point = centre.point();
        [0, 1, 2].map(|i| Steps::between(float(point[i]), self.low[i], self.high[i]))
    }

    fn segments<'a>(
        &self,
        axis: &'a Axis,
        basis: LatticeBasis,
        [across, aside]: [Steps; 2],
    ) -> Vec<AxisSegment<'a>> {
        let pairs = across
            .values()
            .flat_map(|x| aside.values().map(move |y| (x, y)));
        let start = |(x, y)| basis.position([x, y, 0.0]);
        pairs
            .filter_map(|pair| self.segment(axis, basis, start(pair)))
            .collect()
    }

    /// The part of the line through a point in the block; `None` where it passes by, or touches an edge
    /// or a corner.
    fn segment<'a>(
        &self,
        axis: &'a Axis,
        basis: LatticeBasis,
        start: [f64; 3],
    ) -> Option<AxisSegment<'a>> {
        let direction = axis.line().direction().map(|index| index as f64);
        let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            let (low, high) = (self.low[i] - start[i], self.high[i] - start[i]);
            if direction[i] == 0.0 {
                if low > ROUNDING || high < -ROUNDING {
                    return None;
                }
            } else {
                let sides = [low / direction[i], high / direction[i]];
                enters = enters.max(sides[0].min(sides[1]));
                leaves = leaves.min(sides[0].max(sides[1]));
            }
        }
        let at = |height: f64| [0, 1, 2].map(|i| start[i] + height * direction[i]);
        let [_, _, height] = basis.forms();
        let points = axis.inversion_points().iter().flat_map(|point| {
            // Where the point lies along this translate of the line, and one cell on, and so on.
            let terms = height.into_iter().zip(start);
            let here: f64 = terms.map(|(form, x)| form as f64 * x).sum();
            let [_, _, along] = basis.coordinates(*point);
            Steps::between(float(along) - here, enters, leaves).values()
        });
        (leaves - enters > ROUNDING).then(|| AxisSegment {
            axis,
            ends: [at(enters), at(leaves)],
            inversion_points: points.map(at).collect(),
        })
    }

    /// The part of the plane on which the form has this value; `None` where it only touches the block.
    fn polygon<'a>(&self, plane: &'a ReflectionPlane, offset: f64) -> Option<PlanePolygon<'a>> {
        let normal = plane.place().normal().map(|index| index as f64);
        let value = |x: [f64; 3]| (0..3).map(|i| normal[i] * x[i]).sum::<f64>() - offset;
        // A big polygon of the plane, clipped by the six faces, would start from nowhere; the edges of
        // the block that the plane crosses give the corners directly.
        let corner = |bits: usize| {
            [0, 1, 2].map(|i| {
                if bits >> i & 1 == 0 {
                    self.low[i]
                } else {
                    self.high[i]
                }
            })
        };
        let mut corners: Vec<[f64; 3]> = Vec::new();
        let mut add = |x: [f64; 3]| {
            let same = |y: &[f64; 3]| (0..3).all(|i| (x[i] - y[i]).abs() < ROUNDING);
            if !corners.iter().any(same) {
                corners.push(x);
            }
        };
        for bits in 0..8 {
            for axis in (0..3).filter(|axis| bits >> axis & 1 == 0) {
                let ends = [corner(bits), corner(bits | 1 << axis)];
                let values = ends.map(value);
                for (end, size) in ends.into_iter().zip(values) {
                    if size.abs() < ROUNDING {
                        add(end);
                    }
                }
                if values[0] * values[1] < 0.0 && values.iter().all(|v| v.abs() >= ROUNDING) {
                    let part = values[0] / (values[0] - values[1]);
                    add([0, 1, 2].map(|i| ends[0][i] + part * (ends[1][i] - ends[0][i])));
                }
            }
        }
        (corners.len() > 2).then(|| PlanePolygon {
            plane,
            corners: around(corners, normal),
        })
    }
}

/// The corners of a convex polygon in order around their mean, anticlockwise seen against the normal.
fn around(mut corners: Vec<[f64; 3]>, normal: [f64; 3]) -> Vec<[f64; 3]> {
    let count = corners.len() as f64;
    let mean = [0, 1, 2].map(|i| corners.iter().map(|x| x[i]).sum::<f64>() / count);
    // Any affine map keeps the order, so fractions may stand for lengths: drop the coordinate in which
    // the normal is largest.
    let drop = (0..3).fold(0, |best, i| {
        if normal[i].abs() > normal[best].abs() {
            i
        } else {
            best
        }
    });
    let (u, v) = ((drop + 1) % 3, (drop + 2) % 3);
    let angle = |x: &[f64; 3]| (x[v] - mean[v]).atan2(x[u] - mean[u]);
    corners.sort_by(|x, y| angle(x).total_cmp(&angle(y)));
    if normal[drop] < 0.0 {
        corners.reverse();
    }
    corners
}

pub(super) fn float(fraction: Fraction) -> f64 {
    *fraction.numer() as f64 / *fraction.denom() as f64
}
