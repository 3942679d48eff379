//! What an operation of a subperiodic group is: exact, and reduced only by the translations that
//! the group has.

use std::fmt;

use num_rational::Ratio;

use super::super::operation::Operation;
use super::SubperiodicKind;

/// An operation of a frieze, plane, rod or layer group: `x ↦ W x + w` modulo the translations of
/// the group.
///
/// Across the translations nothing is taken modulo anything: there `w` is exactly zero, because a
/// screw or glide in a direction without translations would make one, and inversions and mirrors
/// lie at the origin. `W` mixes no direction with translations and one without. In the plane the
/// third coordinate is kept as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SubperiodicOperation {
    kind: SubperiodicKind,
    operation: Operation,
}

/// Why an operation belongs to no group of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SubperiodicOperationError {
    /// A translation where there are none.
    #[error(
        "`{operation}` moves along {axis}, where a {kind} group has no translations; move the \
         origin onto the {kind}, or it is no operation of one"
    )]
    Across {
        /// The operation.
        operation: Operation,
        /// The kind of group.
        kind: SubperiodicKind,
        /// `a`, `b` or `c`.
        axis: char,
    },
    /// A matrix that turns a direction with translations into one without.
    #[error("`{operation}` turns {axis} out of the directions of a {kind} group")]
    Turns {
        /// The operation.
        operation: Operation,
        /// The kind of group.
        kind: SubperiodicKind,
        /// `a`, `b` or `c`.
        axis: char,
    },
}

impl SubperiodicOperation {
    /// An operation of a space group as one of a subperiodic group.
    ///
    /// ```
    /// use ga_design::crystallography::{Operation, SubperiodicKind, SubperiodicOperation};
    ///
    /// let screw: Operation = "-x,-y,z+1/2".parse()?;
    /// assert!(SubperiodicOperation::new(SubperiodicKind::Rod, screw).is_ok());
    /// assert!(SubperiodicOperation::new(SubperiodicKind::Layer, screw).is_err());
    /// # Ok::<(), ga_design::crystallography::OperationError>(())
    /// ```
    pub fn new(
        kind: SubperiodicKind,
        operation: Operation,
    ) -> Result<Self, SubperiodicOperationError> {
        let periodic = kind.periodic();
        let flat = kind.dimension() == 2;
        let rotation = operation.rotation();
        let shift = operation.translation();
        for (i, axis) in ['a', 'b', 'c'].into_iter().enumerate() {
            let mixed = (0..3).any(|j| periodic[i] != periodic[j] && rotation[i][j] != 0);
            let off_plane = |j: usize| (i == 2) != (j == 2) && rotation[i][j] != 0;
            let leaves = flat && ((0..3).any(off_plane) || rotation[2][2] != 1);
            if mixed || leaves {
                return Err(SubperiodicOperationError::Turns {
                    operation,
                    kind,
                    axis,
                });
            }
            if !periodic[i] && *shift[i].numer() != 0 {
                return Err(SubperiodicOperationError::Across {
                    operation,
                    kind,
                    axis,
                });
            }
        }
        Ok(Self { kind, operation })
    }

    /// The kind of group that it is an operation of.
    pub fn kind(&self) -> SubperiodicKind {
        self.kind
    }

    /// The operation of the space group that has translations along all axes as well.
    pub fn in_space(&self) -> Operation {
        self.operation
    }

    /// The matrix `W`, row by row.
    pub fn rotation(&self) -> [[i32; 3]; 3] {
        self.operation.rotation()
    }

    /// The translation `w`: in `[0, 1)` along the translations, exactly zero across them.
    pub fn translation(&self) -> [Ratio<i32>; 3] {
        self.operation.translation()
    }

    /// `next` after this operation; `None` for operations of different kinds, or as for
    /// [`Operation::after`].
    pub fn then(&self, next: &Self) -> Option<Self> {
        // Block matrices and zeros stay what they are, so that the reduction modulo the whole
        // lattice changes nothing across the translations.
        let operation = self.operation.then(&next.operation)?;
        (self.kind == next.kind).then_some(Self {
            kind: self.kind,
            operation,
        })
    }

    /// The operation that undoes this one, modulo the translations of the group.
    pub fn inverse(&self) -> Option<Self> {
        let operation = self.operation.inverse()?;
        Some(Self {
            kind: self.kind,
            operation,
        })
    }

    /// The image of a point in fractional coordinates.
    pub fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        self.operation.apply(point)
    }
}

/// `x,y` in the plane, `x,y,z` in space.
impl fmt::Display for SubperiodicOperation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let triplet = self.operation.to_string();
        let shown = match self.kind.dimension() {
            2 => triplet.strip_suffix(",z").unwrap_or(&triplet),
            _ => &triplet,
        };
        out.write_str(shown)
    }
}
