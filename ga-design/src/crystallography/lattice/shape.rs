//! Which constraints a system puts on a cell, which parameters it leaves free, and what is said
//! of a cell that does not keep them.

use std::fmt;

use super::super::{Cell, CellError};

/// An edge of the cell, as the unique axis of a monoclinic one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The edge **a**; its angle is alpha.
    A,
    /// The edge **b**; its angle is beta.
    B,
    /// The edge **c**; its angle is gamma.
    C,
}

/// The shape of a cell: a crystal system together with a choice of axes.
///
/// ```
/// use ga_design::crystallography::{Cell, CellShape};
///
/// let cell = Cell::new([4.1, 4.3, 6.0], [90.0, 90.0, 90.0])?;
/// let error = CellShape::Tetragonal.check(&cell).unwrap_err();
/// assert_eq!(error.to_string(), "tetragonal needs a = b; here a = 4.1, b = 4.3");
/// # Ok::<(), ga_design::crystallography::CellError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CellShape {
    /// No constraint.
    Triclinic,
    /// The two angles at the unique axis are 90°.
    Monoclinic(Axis),
    /// All angles 90°.
    Orthorhombic,
    /// a = b, all angles 90°.
    Tetragonal,
    /// a = b, alpha = beta = 90°, gamma = 120°: trigonal and hexagonal crystals.
    Hexagonal,
    /// a = b = c, alpha = beta = gamma: trigonal crystals on rhombohedral axes.
    Rhombohedral,
    /// a = b = c, all angles 90°.
    Cubic,
}

/// The free parameters of a cell, by shape; edges in ångström, angles in degrees.
///
/// ```
/// use ga_design::crystallography::CellParameters;
///
/// let quartz = CellParameters::Hexagonal { a: 4.916, c: 5.4054 }.cell()?;
/// assert_eq!(quartz.angles(), [90.0, 90.0, 120.0]);
/// # Ok::<(), ga_design::crystallography::CellError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CellParameters {
    /// Six parameters.
    Triclinic {
        /// a, b, c.
        edges: [f64; 3],
        /// alpha, beta, gamma.
        angles: [f64; 3],
    },
    /// Four parameters.
    Monoclinic {
        /// a, b, c.
        edges: [f64; 3],
        /// The axis at right angles to the two others.
        unique: Axis,
        /// The angle between the two others.
        angle: f64,
    },
    /// Three parameters.
    Orthorhombic {
        /// a, b, c.
        edges: [f64; 3],
    },
    /// Two parameters.
    Tetragonal {
        /// a and b.
        a: f64,
        /// c, along the fourfold axis.
        c: f64,
    },
    /// Two parameters.
    Hexagonal {
        /// a and b, at 120°.
        a: f64,
        /// c, along the threefold or sixfold axis.
        c: f64,
    },
    /// Two parameters.
    Rhombohedral {
        /// All three edges.
        a: f64,
        /// All three angles.
        alpha: f64,
    },
    /// One parameter.
    Cubic {
        /// All three edges.
        a: f64,
    },
}

impl CellParameters {
    /// The cell with these parameters.
    ///
    /// # Errors
    /// [`CellError`] when a length or an angle is out of range, or the angles are of no corner.
    pub fn cell(self) -> Result<Cell, CellError> {
        const RIGHT: [f64; 3] = [90.0; 3];
        match self {
            Self::Triclinic { edges, angles } => Cell::new(edges, angles),
            Self::Monoclinic {
                edges,
                unique,
                angle,
            } => {
                let angles = match unique {
                    Axis::A => [angle, 90.0, 90.0],
                    Axis::B => [90.0, angle, 90.0],
                    Axis::C => [90.0, 90.0, angle],
                };
                Cell::new(edges, angles)
            }
            Self::Orthorhombic { edges } => Cell::new(edges, RIGHT),
            Self::Tetragonal { a, c } => Cell::new([a, a, c], RIGHT),
            Self::Hexagonal { a, c } => Cell::new([a, a, c], [90.0, 90.0, 120.0]),
            Self::Rhombohedral { a, alpha } => Cell::new([a; 3], [alpha; 3]),
            Self::Cubic { a } => Cell::new([a; 3], RIGHT),
        }
    }

    /// The shape.
    pub fn shape(self) -> CellShape {
        match self {
            Self::Triclinic { .. } => CellShape::Triclinic,
            Self::Monoclinic { unique, .. } => CellShape::Monoclinic(unique),
            Self::Orthorhombic { .. } => CellShape::Orthorhombic,
            Self::Tetragonal { .. } => CellShape::Tetragonal,
            Self::Hexagonal { .. } => CellShape::Hexagonal,
            Self::Rhombohedral { .. } => CellShape::Rhombohedral,
            Self::Cubic { .. } => CellShape::Cubic,
        }
    }
}

/// A constraint that a cell does not keep.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ConstraintError {
    /// Two parameters should be equal.
    #[error("{shape} needs {} = {}; here {} = {}, {} = {}", .names[0], .names[1], .names[0], .values[0], .names[1], .values[1])]
    Unequal {
        /// What the cell should be.
        shape: CellShape,
        /// The parameters.
        names: [&'static str; 2],
        /// Their values, in ångström or degrees.
        values: [f64; 2],
    },
    /// An angle should have a certain value.
    #[error("{shape} needs {name} = {needed}; here {name} = {value}")]
    Angle {
        /// What the cell should be.
        shape: CellShape,
        /// The angle.
        name: &'static str,
        /// The degrees that it should have.
        needed: f64,
        /// The degrees that it has.
        value: f64,
    },
}

/// The largest relative difference of edges that is taken for rounding, by default.
pub const EDGE_TOLERANCE: f64 = 1e-3;

/// The largest difference of angles in degrees that is taken for rounding, by default.
pub const ANGLE_TOLERANCE: f64 = 0.1;

const EDGES: [&str; 3] = ["a", "b", "c"];
const ANGLES: [&str; 3] = ["alpha", "beta", "gamma"];

impl CellShape {
    /// Whether a cell has this shape, within a thousandth of an edge and a tenth of a degree.
    ///
    /// # Errors
    /// [`ConstraintError`] with the first constraint that is violated: edges before angles.
    pub fn check(self, cell: &Cell) -> Result<(), ConstraintError> {
        self.check_within(cell, EDGE_TOLERANCE, ANGLE_TOLERANCE)
    }

    /// Whether a cell has this shape, within a relative difference of edges and a difference of
    /// angles in degrees. A tolerance that is no number lets nothing pass.
    ///
    /// # Errors
    /// [`ConstraintError`] with the first constraint that is violated: edges before angles.
    pub fn check_within(
        self,
        cell: &Cell,
        edge_tolerance: f64,
        angle_tolerance: f64,
    ) -> Result<(), ConstraintError> {
        let (edges, angles) = (cell.edges(), cell.angles());
        for (one, other) in self.equal_edges() {
            let values = [edges[one], edges[other]];
            let names = [EDGES[one], EDGES[other]];
            let apart = (values[0] - values[1]).abs();
            let equal = apart <= edge_tolerance * values[0].max(values[1]);
            if !equal {
                let shape = self;
                return Err(ConstraintError::Unequal {
                    shape,
                    names,
                    values,
                });
            }
        }
        for (at, needed) in self.fixed_angles().into_iter().enumerate() {
            let Some(needed) = needed else { continue };
            let right = (angles[at] - needed).abs() <= angle_tolerance;
            if !right {
                return Err(ConstraintError::Angle {
                    shape: self,
                    name: ANGLES[at],
                    needed,
                    value: angles[at],
                });
            }
        }
        for (one, other) in self.equal_angles() {
            let values = [angles[one], angles[other]];
            let equal = (values[0] - values[1]).abs() <= angle_tolerance;
            if !equal {
                return Err(ConstraintError::Unequal {
                    shape: self,
                    names: [ANGLES[one], ANGLES[other]],
                    values,
                });
            }
        }
        Ok(())
    }

    /// The cell of exactly this shape that is nearest to a cell that has it but for rounding:
    /// edges and angles that should be equal are averaged.
    ///
    /// # Errors
    /// [`CellError::Flat`] when the averages span nothing, which no cell comes near that passes
    /// [`check`](CellShape::check).
    pub fn idealized(self, cell: &Cell) -> Result<Cell, CellError> {
        let [a, b, c] = cell.edges();
        let [alpha, beta, gamma] = cell.angles();
        let edges = cell.edges();
        match self {
            Self::Triclinic => Ok(*cell),
            Self::Monoclinic(unique) => {
                let angle = match unique {
                    Axis::A => alpha,
                    Axis::B => beta,
                    Axis::C => gamma,
                };
                CellParameters::Monoclinic {
                    edges,
                    unique,
                    angle,
                }
                .cell()
            }
            Self::Orthorhombic => CellParameters::Orthorhombic { edges }.cell(),
            Self::Tetragonal => {
                let a = (a + b) / 2.0;
                CellParameters::Tetragonal { a, c }.cell()
            }
            Self::Hexagonal => {
                let a = (a + b) / 2.0;
                CellParameters::Hexagonal { a, c }.cell()
            }
            Self::Rhombohedral => {
                let (a, alpha) = ((a + b + c) / 3.0, (alpha + beta + gamma) / 3.0);
                CellParameters::Rhombohedral { a, alpha }.cell()
            }
            Self::Cubic => {
                let a = (a + b + c) / 3.0;
                CellParameters::Cubic { a }.cell()
            }
        }
    }

    /// Some cell of this shape and no other, of a size near 1: its edges and angles differ where
    /// they may.
    pub fn example(self) -> CellParameters {
        let edges = [1.0, 1.2, 1.5];
        let (a, c) = (1.0, 1.5);
        match self {
            Self::Triclinic => CellParameters::Triclinic {
                edges,
                angles: [81.0, 97.0, 104.0],
            },
            Self::Monoclinic(unique) => CellParameters::Monoclinic {
                edges,
                unique,
                angle: 104.0,
            },
            Self::Orthorhombic => CellParameters::Orthorhombic { edges },
            Self::Tetragonal => CellParameters::Tetragonal { a, c },
            Self::Hexagonal => CellParameters::Hexagonal { a, c },
            Self::Rhombohedral => CellParameters::Rhombohedral { a, alpha: 75.0 },
            Self::Cubic => CellParameters::Cubic { a },
        }
    }

    /// The number of parameters that are free.
    pub fn free_parameters(self) -> usize {
        match self {
            Self::Triclinic => 6,
            Self::Monoclinic(_) => 4,
            Self::Orthorhombic => 3,
            Self::Tetragonal | Self::Hexagonal | Self::Rhombohedral => 2,
            Self::Cubic => 1,
        }
    }

    fn equal_edges(self) -> Vec<(usize, usize)> {
        match self {
            Self::Triclinic | Self::Monoclinic(_) | Self::Orthorhombic => vec![],
            Self::Tetragonal | Self::Hexagonal => vec![(0, 1)],
            Self::Rhombohedral | Self::Cubic => vec![(0, 1), (1, 2), (0, 2)],
        }
    }

    fn fixed_angles(self) -> [Option<f64>; 3] {
        let right = Some(90.0);
        match self {
            Self::Triclinic | Self::Rhombohedral => [None; 3],
            Self::Monoclinic(Axis::A) => [None, right, right],
            Self::Monoclinic(Axis::B) => [right, None, right],
            Self::Monoclinic(Axis::C) => [right, right, None],
            Self::Orthorhombic | Self::Tetragonal | Self::Cubic => [right; 3],
            Self::Hexagonal => [right, right, Some(120.0)],
        }
    }

    fn equal_angles(self) -> Vec<(usize, usize)> {
        match self {
            Self::Rhombohedral => vec![(0, 1), (1, 2), (0, 2)],
            _ => vec![],
        }
    }
}

impl fmt::Display for CellShape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Triclinic => "triclinic",
            Self::Monoclinic(Axis::A) => "monoclinic with unique axis a",
            Self::Monoclinic(Axis::B) => "monoclinic with unique axis b",
            Self::Monoclinic(Axis::C) => "monoclinic with unique axis c",
            Self::Orthorhombic => "orthorhombic",
            Self::Tetragonal => "tetragonal",
            Self::Hexagonal => "hexagonal",
            Self::Rhombohedral => "rhombohedral",
            Self::Cubic => "cubic",
        })
    }
}
