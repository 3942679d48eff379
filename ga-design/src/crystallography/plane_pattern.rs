//! Decides how a plane group is shown when nobody says how: commas in general position, in cells of a
//! handy shape, those that a reflection has turned over in a second colour.

use super::asymmetric::{comma_outline, flat_comma};
use super::{
    Cell, CellError, CellRange, GenerationError, Isometry, Pattern, SpaceGroupGenerators,
    SubperiodicGroup, SubperiodicKind, SubperiodicLattice, general_position,
};
use crate::export::flat::FlatDrawing;
use crate::export::{ExportError, Line};
use crate::mesh::{Mesh, MeshError};
use ga_cga::{Point, Vector3};
use thiserror::Error;

/// The colours of the copies: as the motif is, and its mirror image.
pub const COLOURS: [[u8; 3]; 2] = [[38, 104, 178], [226, 112, 36]];

/// The part of the room around a motif that it fills.
const FILLED: f64 = 0.96;

/// The pattern that a plane group makes of a comma.
///
/// ```
/// use ga_design::crystallography::{CellRange, PlanePattern, SubperiodicGroup, SubperiodicKind};
///
/// let group = SubperiodicGroup::standard(SubperiodicKind::Plane, 12).unwrap();
/// let pattern = PlanePattern::new(group, 10.0)?;
/// let one_cell = CellRange { low: [0; 3], high: [1; 3] };
/// // p4gm: four commas of either hand.
/// assert_eq!(pattern.copies(one_cell).len(), 8);
/// assert!(pattern.drawing(one_cell)?.encode()?.starts_with("<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct PlanePattern {
    group: &'static SubperiodicGroup,
    cell: Cell,
    edges: [Vector3; 3],
    place: Vector3,
    size: f64,
    isometries: Vec<Isometry>,
}

/// Why a group makes no pattern of the plane.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PlanePatternError {
    /// It is a frieze, rod or layer group.
    #[error("{symbol} is a {kind} group; a pattern of the plane needs a plane group")]
    Kind {
        /// Its symbol.
        symbol: &'static str,
        /// Its kind.
        kind: SubperiodicKind,
    },
    /// The tables have no generators of its space group.
    #[error("the tables have no generators of {symbol}")]
    Generators {
        /// Its symbol.
        symbol: &'static str,
    },
    /// The edge is no length.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// It did not grow from its roots.
    #[error(transparent)]
    Generation(#[from] GenerationError),
}

impl PlanePattern {
    /// The pattern in a cell whose first edge is so long, in ångström, and lies along x; the shape is
    /// that of the lattice, b as long as a or somewhat shorter.
    ///
    /// # Errors
    /// [`PlanePatternError`] if the group is none of the plane or the edge is no length of a cell.
    pub fn new(group: &'static SubperiodicGroup, edge: f64) -> Result<Self, PlanePatternError> {
        let symbol = group.symbol;
        if group.kind != SubperiodicKind::Plane {
            let kind = group.kind;
            return Err(PlanePatternError::Kind { symbol, kind });
        }
        let [ratio, gamma] = shape(group.lattice());
        let cell = Cell::new([edge, ratio * edge, edge], [90.0, 90.0, gamma])?;
        let found = group.space_group().and_then(|found| {
            let generators = SpaceGroupGenerators::of(found.number)?;
            Some((generators, found.from_standard))
        });
        let (generators, from_standard) = found.ok_or(PlanePatternError::Generators { symbol })?;
        let versors = generators.generate_in(cell, &from_standard)?.versors();
        let edges = cell.edge_vectors().map(Vector3::from);
        let [a, b, c] = edges;
        let corner = Point::at(0.0, 0.0, 0.0);
        let found = general_position(&versors, &[a, b], corner, [a, b, c * 0.0]);
        let mut pattern = Self {
            group,
            cell,
            edges,
            place: found.point.position(),
            size: FILLED * found.clearance / 2.0,
            isometries: Vec::new(),
        };
        pattern.isometries = versors.iter().map(|one| pattern.gathered(one)).collect();
        Ok(pattern)
    }

    /// The group.
    #[must_use]
    pub fn group(&self) -> &'static SubperiodicGroup {
        self.group
    }

    /// The cell; its third edge counts for nothing.
    #[must_use]
    pub fn cell(&self) -> &Cell {
        &self.cell
    }

    /// The isometry, of those that differ by translations, that carries the motif into the unit cell.
    fn gathered(&self, isometry: &Isometry) -> Isometry {
        let image = isometry.apply(Point::from(self.place)).position();
        let [x, y, _] = self.cell.fractional(image.to_array());
        // A point less than a millionth below an edge is on it.
        let [x, y] = [x, y].map(|part| -(part + 1e-6).floor());
        let [a, b, _] = self.edges;
        Isometry::translation(a * x + b * y).after(isometry)
    }

    /// The isometries that carry the [`motif`](Self::motif) onto its copies in a block of cells.
    #[must_use]
    pub fn copies(&self, range: CellRange) -> Vec<Isometry> {
        let pattern = Pattern::on_lattice(self.isometries.clone(), self.edges, range);
        let copies = pattern.isometries();
        copies.map(|(_, _, isometry)| isometry).collect()
    }

    /// The comma in its place, a flat piece.
    ///
    /// # Errors
    /// [`MeshError`] if the cell is so large that a corner is too far away.
    pub fn motif(&self) -> Result<Mesh, MeshError> {
        let comma = flat_comma()?;
        let positions = comma.positions().iter().map(|point| self.put(*point));
        Mesh::new(
            positions.collect(),
            comma.normals().to_vec(),
            comma.triangles().to_vec(),
        )
    }

    /// The point of the motif at a point of the comma about the origin.
    fn put(&self, point: [f64; 3]) -> [f64; 3] {
        (self.place + Vector3::from(point) * self.size).to_array()
    }

    /// The outline of the cell at this offset, one corner after the other.
    #[must_use]
    pub fn outline(&self, [x, y, _]: [i32; 3]) -> [[f64; 3]; 4] {
        let [a, b, _] = self.edges;
        let corner = a * f64::from(x) + b * f64::from(y);
        [corner, corner + a, corner + a + b, corner + b].map(Vector3::to_array)
    }

    /// The drawing of a block of cells.
    ///
    /// # Errors
    /// [`ExportError`] if the block reaches too far.
    pub fn drawing(&self, range: CellRange) -> Result<FlatDrawing, ExportError> {
        let (symbol, number) = (self.group.symbol, self.group.number);
        let mut drawing = FlatDrawing::new(
            format!("plane group {symbol} (number {number})"),
            format!(
                "The plane group {symbol}, number {number}: the copies that a reflection has turned \
                 into their mirror images have the second colour."
            ),
        );
        for offset in range.offsets() {
            let [p, q, r, s] = self.outline(offset);
            for ends in [[p, q], [q, r], [r, s], [s, p]] {
                let edge = Line::new(ends.to_vec(), false)?;
                drawing.add_cell_edge(edge, offset == range.low);
            }
        }
        let outline: Vec<Point> = comma_outline()
            .into_iter()
            .map(|[x, y]| Point::from(Vector3::from(self.put([x, y, 0.0]))))
            .collect();
        for isometry in self.copies(range) {
            let points = outline.iter();
            let points = points.map(|point| isometry.apply(*point).position().to_array());
            let [turned, mirrored] = COLOURS;
            let colour = if isometry.is_proper() {
                turned
            } else {
                mirrored
            };
            drawing.add(Line::new(points.collect(), true)?, colour);
        }
        Ok(drawing)
    }
}

/// The length of b over that of a, and the angle between them in degrees.
fn shape(lattice: SubperiodicLattice) -> [f64; 2] {
    match lattice {
        SubperiodicLattice::Oblique => [0.8, 105.0],
        SubperiodicLattice::Rectangular | SubperiodicLattice::CentredRectangular => [0.75, 90.0],
        SubperiodicLattice::Square | SubperiodicLattice::Line => [1.0, 90.0],
        SubperiodicLattice::Hexagonal => [1.0, 120.0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_groups_of_the_plane_and_lengths_make_patterns() {
        for kind in SubperiodicKind::ALL {
            let group = SubperiodicGroup::standard(kind, 1).unwrap();
            let made = PlanePattern::new(group, 1.0);
            if kind == SubperiodicKind::Plane {
                assert!(made.is_ok());
            } else {
                assert!(
                    matches!(made, Err(PlanePatternError::Kind { .. })),
                    "{kind}"
                );
            }
        }
        let group = SubperiodicGroup::standard(SubperiodicKind::Plane, 17).unwrap();
        for edge in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let made = PlanePattern::new(group, edge);
            assert!(matches!(made, Err(PlanePatternError::Cell(_))), "{edge}");
        }
    }

    #[test]
    fn every_setting_makes_a_pattern_without_overlaps() {
        for group in SubperiodicGroup::table() {
            if group.kind != SubperiodicKind::Plane {
                continue;
            }
            let pattern = PlanePattern::new(group, 10.0).unwrap();
            assert!(pattern.size > 0.3, "{}: {}", group.symbol, pattern.size);
            let range = CellRange {
                low: [-1, -1, 0],
                high: [2, 2, 1],
            };
            let centres: Vec<Vector3> = pattern
                .copies(range)
                .iter()
                .map(|copy| copy.apply(Point::from(pattern.place)).position())
                .collect();
            for (at, one) in centres.iter().enumerate() {
                for other in &centres[..at] {
                    let apart = (*one - *other).norm();
                    assert!(apart > 2.0 * pattern.size, "{}", group.symbol);
                }
            }
        }
    }
}
