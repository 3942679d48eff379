//! Which motifs are at hand to show a group with: shapes without symmetry of their own, so that every
//! operation can be seen.

mod comma;
mod hand;

pub use comma::{COMMA_THICKNESS, comma_outline, flat_comma};

use crate::mesh::{self, Ends, Mesh, MeshError};
use std::f64::consts::TAU;

/// A motif that the program brings along; each fits into the unit ball about the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AsymmetricMotif {
    /// A drop with a curved tail that rises from its plane: it has no symmetry at all.
    Comma,
    /// A right hand, with a palm and a back.
    Hand,
    /// A bar with a large and a small ball at its ends; it has its own axis and mirrors along it only.
    Strut,
    /// A right-handed spring with a ball at one end.
    Helix,
}

impl AsymmetricMotif {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Comma, Self::Hand, Self::Strut, Self::Helix];

    /// The name, in small letters.
    pub fn name(self) -> &'static str {
        match self {
            Self::Comma => "comma",
            Self::Hand => "hand",
            Self::Strut => "strut",
            Self::Helix => "helix",
        }
    }

    /// The motif of a name; case does not matter.
    pub fn from_name(name: &str) -> Option<Self> {
        let wanted = name.trim().to_lowercase();
        Self::ALL.into_iter().find(|motif| motif.name() == wanted)
    }

    /// The surface.
    ///
    /// ```
    /// use ga_design::crystallography::AsymmetricMotif;
    ///
    /// for motif in AsymmetricMotif::ALL {
    ///     let mesh = motif.mesh()?;
    ///     let inside = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>() <= 1.0;
    ///     assert!(mesh.positions().iter().all(inside), "{motif:?}");
    /// }
    /// # Ok::<(), ga_design::mesh::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// None for the shapes there are.
    pub fn mesh(self) -> Result<Mesh, MeshError> {
        match self {
            Self::Comma => comma::solid(),
            Self::Hand => hand::solid(),
            Self::Strut => strut(),
            Self::Helix => helix(),
        }
    }

    /// Lines that show the shape in a drawing.
    pub fn lines(self) -> Vec<Vec<[f64; 3]>> {
        match self {
            Self::Comma => vec![comma::rim()],
            Self::Hand => hand::strokes(),
            Self::Strut => vec![STRUT.to_vec()],
            Self::Helix => vec![spring()],
        }
    }
}

/// The ends of the strut, along no direction that a lattice favours.
const STRUT: [[f64; 3]; 2] = [[-0.42, -0.33, -0.5], [0.5, 0.36, 0.58]];

fn strut() -> Result<Mesh, MeshError> {
    let [large, small] = STRUT;
    Mesh::joined(&[
        mesh::tube(&STRUT, Ends::Capped, 0.09, 16)?,
        ball(large, 0.25)?,
        ball(small, 0.14)?,
    ])
}

/// The middle line of the spring: seven quarters of a turn.
fn spring() -> Vec<[f64; 3]> {
    let steps = 56;
    (0..=steps)
        .map(|step| {
            let part = f64::from(step) / f64::from(steps);
            let (sine, cosine) = (1.75 * TAU * part).sin_cos();
            [0.45 * cosine, 0.45 * sine, 1.3 * part - 0.65]
        })
        .collect()
}

fn helix() -> Result<Mesh, MeshError> {
    let line = spring();
    let top = line.last().copied().unwrap_or_default();
    Mesh::joined(&[mesh::tube(&line, Ends::Capped, 0.12, 12)?, ball(top, 0.2)?])
}

/// A sphere somewhere.
fn ball(centre: [f64; 3], radius: f64) -> Result<Mesh, MeshError> {
    ellipsoid(centre, [radius; 3])
}

/// A sphere, drawn out along the axes.
fn ellipsoid(centre: [f64; 3], radii: [f64; 3]) -> Result<Mesh, MeshError> {
    let unit = mesh::icosphere(2)?;
    let positions = unit.positions().iter();
    let placed = positions.map(|p| [0, 1, 2].map(|i| centre[i] + radii[i] * p[i]));
    Mesh::from_triangles(placed.collect(), unit.triangles().to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crystallography::{Isometry, Motif};
    use glam::DVec3;

    fn volume(mesh: &Mesh) -> f64 {
        let at = |i: u32| DVec3::from(mesh.positions()[i as usize]);
        let parts = mesh.triangles().iter();
        parts
            .map(|[a, b, c]| at(*a).cross(at(*b)).dot(at(*c)) / 6.0)
            .sum()
    }

    #[test]
    fn the_outside_is_outside() {
        for motif in AsymmetricMotif::ALL {
            assert!(volume(&motif.mesh().unwrap()) > 0.05, "{motif:?}");
            assert_eq!(AsymmetricMotif::from_name(motif.name()), Some(motif));
            assert!(!motif.lines().is_empty());
        }
        // Half the disc, of the height of the flat comma.
        let expected = std::f64::consts::PI / 2.0 * 0.88 * 0.88 * COMMA_THICKNESS;
        assert!((volume(&flat_comma().unwrap()) - expected).abs() < 0.01 * expected);
    }

    #[test]
    fn the_comma_and_the_hand_have_no_symmetry() {
        let when = crate::crystallography::Coincidence {
            distance: 0.02,
            ..Default::default()
        };
        let oh = crate::crystallography::PointGroup::from_geometric("43").unwrap();
        for motif in [AsymmetricMotif::Comma, AsymmetricMotif::Hand] {
            let mesh = motif.mesh().unwrap();
            let same = |by: &&Isometry| mesh.coincides(&mesh.moved(by).unwrap(), &when);
            assert_eq!(oh.transformations().iter().filter(same).count(), 1);
        }
    }
}
