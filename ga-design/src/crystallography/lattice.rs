//! Which lattices crystals have: seven systems, fourteen Bravais lattices, their free cell
//! parameters and constraints, and edge vectors from roots (Table 3.4).

mod bravais;
mod centring;
mod edges;
mod primitive;
mod shape;
mod system;

pub use bravais::BravaisLattice;
pub use centring::Centring;
pub use edges::{EdgeError, EdgeParameters, edge_vectors};
pub use shape::{
    ANGLE_TOLERANCE, Axis, CellParameters, CellShape, ConstraintError, EDGE_TOLERANCE,
};
pub use system::{CrystalSystem, UnknownSystem};

use ga_cga::Vector3;

/// The reciprocal vectors of three edges, **a**\* = (**b**∧**c**)(**a**∧**b**∧**c**)⁻¹ and so on,
/// so that **a**·**a**\* = 1 and **a**·**b**\* = 0; `None` for edges in one plane.
///
/// ```
/// use ga_cga::Vector3;
/// use ga_design::crystallography::lattice::reciprocal;
///
/// let edges = [[2.0, 0.0, 0.0], [-1.0, 2.0, 0.0], [0.0, 0.0, 4.0]].map(Vector3::from);
/// let [_, _, upright] = reciprocal(edges).unwrap();
/// assert_eq!(upright, Vector3::new(0.0, 0.0, 0.25));
/// ```
pub fn reciprocal(edges: [Vector3; 3]) -> Option<[Vector3; 3]> {
    let [a, b, c] = edges;
    let volume = a ^ b ^ c;
    let sizes = a.norm() * b.norm() * c.norm();
    // Flatter than any lattice, and than any three roots that span space.
    if sizes.is_nan() || volume.norm() <= 1e-9 * sizes {
        return None;
    }
    let unit = volume.inverse()?;
    Some([(b ^ c) * unit, (c ^ a) * unit, (a ^ b) * unit])
}
