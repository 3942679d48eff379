//! The expanded octahedron: six struts along the axes, carried by the twelve rotations of the
//! tetrahedron (figure 3.9).

use super::rotations::tetrahedral;
use super::structure::length;
use super::{GeneratingMember, Structure, TensegrityError, generate};
use ga_cga::Point;

/// The ratio of cable to strut in balance: √(3/8), the least that there can be.
pub const BALANCED_RATIO: f64 = 0.612_372_435_695_794_5;

/// The ratio at which the nodes are those of a cuboctahedron, where the variations shown here end.
const LARGEST_RATIO: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// How far a printed ratio may fall short of the least one.
const PRINTED: f64 = 1e-6;

/// The expanded octahedron of six struts and twenty-four cables, which Pugh names so (A. Pugh, *An
/// Introduction to Tensegrity*, 1976).
///
/// ```
/// use ga_design::tensegrity::{BALANCED_RATIO, Octahedron};
///
/// let structure = Octahedron::default().structure()?;
/// assert_eq!((structure.struts().count(), structure.cables().count()), (6, 24));
/// for cable in structure.cables() {
///     assert!((structure.length(cable) - BALANCED_RATIO).abs() < 1e-15);
/// }
/// # Ok::<(), ga_design::tensegrity::TensegrityError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Octahedron {
    /// The length of a strut.
    pub strut: f64,
    /// The length of a cable over that of a strut: from √(3/8), where it is in balance, to √½, where
    /// its nodes are those of a cuboctahedron. The struts stand ever farther apart; at every ratio but
    /// the first there is no self-stress.
    pub ratio: f64,
}

impl Default for Octahedron {
    /// Struts of length one, in balance.
    fn default() -> Self {
        Self {
            strut: 1.0,
            ratio: BALANCED_RATIO,
        }
    }
}

impl Octahedron {
    /// The structure, about the origin.
    ///
    /// # Errors
    /// [`TensegrityError`] if the length is not positive and finite, or no octahedron has this ratio.
    pub fn structure(&self) -> Result<Structure, TensegrityError> {
        let half = length("the length of a strut", self.strut)? / 2.0;
        if !(BALANCED_RATIO - PRINTED..=LARGEST_RATIO + PRINTED).contains(&self.ratio) {
            return Err(TensegrityError::Ratio {
                value: self.ratio,
                least: BALANCED_RATIO,
                most: LARGEST_RATIO,
            });
        }
        // A strut along z ends at (0, h, ±s), its neighbours at (s, ±h, 0): a cable's square is
        // h² + s² + (s − h)², which is least at h = s/2.
        let excess = (2.0 * (self.ratio * self.ratio - BALANCED_RATIO * BALANCED_RATIO)).max(0.0);
        // A ratio as it is printed means the balanced one.
        let excess = if self.ratio - BALANCED_RATIO < PRINTED {
            0.0
        } else {
            excess.sqrt()
        };
        let apart = half * (0.5 + excess);
        let [low, high] = [-half, half].map(|z| Point::at(0.0, apart, z));
        let neighbours = [half, -half].map(|x| Point::at(x, 0.0, apart));
        let cables = neighbours.map(|to| GeneratingMember::cable(high, to));
        let [first, second] = cables;
        let strut = GeneratingMember::strut(low, high);
        generate(tetrahedral()?.isometries(), &[strut, first, second])
    }
}
