//! How the edges of a cell are made from roots (Table 3.4).

use ga_cga::{Rotor, Trivector3, Vector3};

use super::super::roots::RootsError;
use super::super::{Bars, PointSymbol};

/// The free lengths and angles of Table 3.4: α, β, γ of the edges and the oblique angles of the
/// cells that have such.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeParameters {
    /// α, β, γ: the lengths of the edges as far as they are free.
    pub lengths: [f64; 3],
    /// The angles alpha, beta, gamma between the edges, in degrees: all three count in a triclinic
    /// cell, the one in the mirror or across the axis in a monoclinic one.
    pub angles: [f64; 3],
}

/// Why roots make no edges.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum EdgeError {
    /// The group is of no lattice.
    #[error(
        "no lattice has the point group {symbol}: the numbers of a crystal are 1, 2, 3, 4 and 6"
    )]
    NoLattice {
        /// The group.
        symbol: PointSymbol,
    },
    /// The numbers have no roots.
    #[error(transparent)]
    Roots(#[from] RootsError),
    /// The parameters are lengths or angles of no cell.
    #[error(transparent)]
    Cell(#[from] super::super::CellError),
}

/// The edge vectors **a̲**, **b̲**, **c̲** of the primitive cell that a point group's roots span
/// (Table 3.4), in the frame of the roots.
///
/// As corrected: tetragonal and trigonal cells take **b̲** = −**b** **a̲** **b** as hexagonal ones
/// do, the reflection of **a̲** in **b** (so that a̲ and b̲ are at 60° for p = 3, at 120° for p = 6);
/// the mirror of `1` gets the oblique angle in its own plane; the triclinic cell has all six
/// parameters; (**a**∧**b**)\* of the cubic cell is taken at unit length.
///
/// ```
/// use ga_design::crystallography::lattice::{EdgeParameters, edge_vectors};
///
/// let parameters = EdgeParameters { lengths: [2.0, 2.0, 5.0], angles: [90.0; 3] };
/// let [a, b, c] = edge_vectors("b(4)2".parse()?, &parameters)?;
/// assert!((a.norm() - b.norm()).abs() < 1e-12 && (c.norm() - 5.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`EdgeError`]: a point group that no lattice has, or parameters of no cell.
pub fn edge_vectors(
    symbol: PointSymbol,
    parameters: &EdgeParameters,
) -> Result<[Vector3; 3], EdgeError> {
    let roots = symbol.roots()?;
    let [a, b, c] = roots.vectors();
    // The lengths and angles are checked once, as those of a cell.
    let general = super::super::Cell::new(parameters.lengths, parameters.angles)?;
    let [alpha, beta, gamma] = parameters.lengths;
    let in_plane = |from: Vector3, towards: Vector3, degrees: f64| {
        let turn = Rotor::turn(from ^ towards, degrees.to_radians());
        turn.map_or(towards, |rotor| rotor.apply(from))
    };
    let reflected = |edge: Vector3| {
        let image: Vector3 = b.apply(edge);
        image
    };
    let edges = match (symbol.p(), symbol.q().unwrap_or(2), symbol.bars()) {
        // 1̄ and the bar over 22: no direction is special.
        (1, 2, Bars::BarredSingle) | (2, 2, Bars::Both) => {
            general.edge_vectors().map(Vector3::from)
        }
        // The mirror a: across it one edge, in it two at any angle.
        (1, 2, Bars::Single) => {
            let aside: Vector3 = (c ^ a) * Trivector3::new(-1.0);
            let [angle, _, _] = parameters.angles;
            [a * alpha, aside * beta, in_plane(aside, c, angle) * gamma]
        }
        // The twofold axis along c: across it two edges at any angle.
        (2, 2, Bars::BarredSingle | Bars::First) => {
            let [_, _, angle] = parameters.angles;
            [a * alpha, in_plane(a, b, angle) * beta, c * gamma]
        }
        (2, 2, _) => [a * alpha, b * beta, c * gamma],
        (3 | 4 | 6, 2, _) => [a * alpha, reflected(a * alpha), c * gamma],
        (4, 3, _) => {
            let upright: Vector3 = (a ^ b) * Trivector3::new(-1.0);
            let upright = upright.normalized().unwrap_or(c);
            [a * alpha, reflected(a * alpha), upright * alpha]
        }
        (3, 3, _) => {
            // The roots are half diagonals of the faces.
            let size = alpha * std::f64::consts::SQRT_2 / 2.0;
            [(a - c) * size, (a + c) * size, (b * 2.0 - a - c) * size]
        }
        _ => return Err(EdgeError::NoLattice { symbol }),
    };
    Ok(edges)
}
