//! Which symmetry elements a space group has: every axis, plane and inversion centre of a cell, found
//! from the operations exactly and named as *International Tables for Crystallography* A draws them.
//!
//! An operation `(W, w)` together with the lattice translations leaves lines, planes or points in
//! place, modulo lattice translations finitely many (`operation_part`). Operations that share their
//! element give it its highest symbol ([`Axis`], [`ReflectionPlane`]): the axis of a fourfold rotation
//! is that of a twofold one too, the glides of a plane differ by lattice translations.
//!
//! Elements are told apart modulo translations by whole cell edges, so that centred cells list each as
//! often as it occurs in the cell.

use std::collections::{BTreeMap, BTreeSet};

use super::operation::Operation;

mod axis;
mod conformal;
mod extent;
mod lattice_basis;
mod operation_part;
mod place;
mod plane;

pub use axis::Axis;
pub use extent::{
    AxisSegment, CentrePoint, MOST_ELEMENTS, PlacedElements, PlanePolygon, TooManyElements,
};
pub use lattice_basis::Fraction;
pub use place::{LatticeLine, LatticePlane};
pub use plane::ReflectionPlane;

use axis::{Turn, merged};
use operation_part::Part;

/// The point about which a group inverts space, modulo the lattice.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct InversionCentre {
    point: [Fraction; 3],
    operations: Vec<usize>,
}

impl InversionCentre {
    /// The position in fractions of the cell edges, each in `[0, 1)`.
    pub fn point(&self) -> [Fraction; 3] {
        self.point
    }

    /// The positions, in the list of operations, of those that it is the element of.
    pub fn operations(&self) -> &[usize] {
        &self.operations
    }
}

/// An operation that belongs to no crystal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the operation `{operation}` has no symmetry element: its matrix is no rotation or reflection of \
     a lattice, or the cell is too skewed for it (indices of its axis or plane beyond 64)"
)]
pub struct NoElement {
    /// The operation.
    pub operation: Operation,
}

/// The symmetry elements of a space group in one cell.
///
/// ```
/// use ga_design::crystallography::{SpaceGroup, SymmetryElements};
///
/// let group = SpaceGroup::from_symbol("P 21/c")?[0];
/// let elements = SymmetryElements::of(&group.operations()?)?;
/// // Eight inversion centres, four screw axes along b, two glide planes across it.
/// let symbols: Vec<String> = elements.axes().iter().map(|axis| axis.to_string()).collect();
/// assert_eq!(symbols, ["2_1"; 4]);
/// assert_eq!(elements.planes().iter().map(|p| p.letter()).collect::<String>(), "cc");
/// assert_eq!(elements.centres().len(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SymmetryElements {
    axes: Vec<Axis>,
    planes: Vec<ReflectionPlane>,
    centres: Vec<InversionCentre>,
}

impl SymmetryElements {
    /// The elements of all operations of a group modulo the lattice, centring translations included.
    ///
    /// # Errors
    /// [`NoElement`] for an operation that cannot belong to a space group.
    pub fn of(operations: &[Operation]) -> Result<Self, NoElement> {
        let mut turns: BTreeMap<LatticeLine, Vec<Turn>> = BTreeMap::new();
        let mut reflections: BTreeMap<LatticePlane, ([Fraction; 3], Vec<usize>)> = BTreeMap::new();
        let mut inversions: BTreeMap<[Fraction; 3], Vec<usize>> = BTreeMap::new();
        let mut centrings = BTreeSet::from([[Fraction::from(0); 3]]);
        for (index, operation) in operations.iter().enumerate() {
            let part = Part::of(operation).ok_or(NoElement {
                operation: *operation,
            })?;
            match part {
                Part::Translation => {
                    centrings.insert(place::translation(operation));
                }
                Part::Inversion(points) => {
                    for point in points {
                        inversions.entry(point).or_default().push(index);
                    }
                }
                Part::Reflection(planes) => {
                    for (plane, glide) in planes {
                        let (_, found) = reflections
                            .entry(plane)
                            .or_insert_with(|| (glide, Vec::new()));
                        found.push(index);
                    }
                }
                Part::Turn {
                    order,
                    is_proper,
                    axes,
                } => {
                    for (line, along) in axes {
                        turns.entry(line).or_default().push(Turn {
                            operation: index,
                            order,
                            along,
                            is_proper,
                        });
                    }
                }
            }
        }
        let centrings: Vec<_> = centrings.into_iter().collect();
        let points: Vec<_> = inversions.keys().copied().collect();
        // Threefold and sixfold axes along c stand in hexagonal axes.
        let is_hexagonal = turns.iter().any(|(line, turns)| {
            line.direction() == [0, 0, 1] && turns.iter().any(|turn| turn.order % 3 == 0)
        });
        let axes = turns
            .into_iter()
            .filter_map(|(line, turns)| merged(line, &turns, &centrings, &points));
        let planes = reflections.into_iter().map(|(place, (glide, found))| {
            plane::named(place, glide, found, &centrings, is_hexagonal)
        });
        let centres = inversions
            .into_iter()
            .map(|(point, operations)| InversionCentre { point, operations });
        Ok(Self {
            axes: axes.collect(),
            planes: planes.collect(),
            centres: centres.collect(),
        })
    }

    /// The rotation, screw and rotoinversion axes.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The mirror and glide planes.
    pub fn planes(&self) -> &[ReflectionPlane] {
        &self.planes
    }

    /// The inversion centres, those on axes and in planes too.
    pub fn centres(&self) -> &[InversionCentre] {
        &self.centres
    }

    /// How often each symbol occurs in the cell; inversion centres are `-1`.
    ///
    /// ```
    /// use ga_design::crystallography::{SpaceGroup, SymmetryElements};
    ///
    /// let group = SpaceGroup::from_symbol("P 6/m m m")?[0];
    /// let counts = SymmetryElements::of(&group.operations()?)?.counts();
    /// assert_eq!((counts["6/m"], counts["-6"], counts["-1"]), (1, 2, 8));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn counts(&self) -> BTreeMap<String, usize> {
        let mut counts = BTreeMap::new();
        let axes = self.axes.iter().map(ToString::to_string);
        let planes = self.planes.iter().map(ToString::to_string);
        let centres = self.centres.iter().map(|_| String::from("-1"));
        for symbol in axes.chain(planes).chain(centres) {
            *counts.entry(symbol).or_insert(0) += 1;
        }
        counts
    }
}
