//! Decides which scenes the gallery shows, in which order.
//!
//! A scene is a function of its own in a file of its own: it makes a figure with the algebra, and a
//! test beside it holds what must be true of that figure. Adding one is a row of [`entries`].

mod camera_roll;
mod conformal_motions;
mod covariance;
mod crystals;
mod folded_vertex;
mod helix;
mod kaleidoscope;
mod meets;
mod miura;
mod motif;
mod motions;
mod palette;
mod reflections;
mod spans;
mod spiral;
mod stereographic;

use crate::crystallography::cif::CifError;
use crate::crystallography::{BondError, CellRangeError, ExpansionError};
use crate::export::{ExportError, Scene};
use crate::folding::FoldError;
use crate::mesh::MeshError;
use thiserror::Error;

/// A scene of the gallery, not yet made.
///
/// ```
/// let entry = ga_design::gallery::entries().iter().find(|entry| entry.name == "diamond");
/// let scene = entry.map(|entry| entry.scene()).transpose()?;
/// assert_eq!(scene.map(|scene| scene.title().to_owned()).as_deref(), Some("Diamond"));
/// # Ok::<(), ga_design::gallery::GalleryError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// The name of the scene, for files and links.
    pub name: &'static str,
    make: fn() -> Result<Scene, GalleryError>,
}

impl Entry {
    /// Makes the scene.
    ///
    /// # Errors
    /// [`GalleryError`] if a part of it cannot be made; a test makes every one.
    pub fn scene(&self) -> Result<Scene, GalleryError> {
        (self.make)()
    }
}

/// Why a scene of the gallery could not be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum GalleryError {
    /// A crystal could not be read.
    #[error(transparent)]
    Crystal(#[from] CifError),
    /// The block of cells is no block.
    #[error(transparent)]
    Cells(#[from] CellRangeError),
    /// A crystal could not be built.
    #[error(transparent)]
    Expansion(#[from] ExpansionError),
    /// The bonds of a crystal could not be found.
    #[error(transparent)]
    Bonds(#[from] BondError),
    /// A pattern does not fold.
    #[error(transparent)]
    Fold(#[from] FoldError),
    /// A shape could not be made.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The scene could not be put together.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// A geometric construction has no result.
    #[error("{what} does not exist")]
    Degenerate {
        /// What was constructed.
        what: &'static str,
    },
}

/// The scenes, in the order in which the gallery shows them.
#[must_use]
pub const fn entries() -> &'static [Entry] {
    const fn entry(name: &'static str, make: fn() -> Result<Scene, GalleryError>) -> Entry {
        Entry { name, make }
    }
    const {
        &[
            entry("quartz", crystals::quartz),
            entry("covariance", covariance::scene),
            entry("kaleidoscope", kaleidoscope::scene),
            entry("meets", meets::scene),
            entry("folded-vertex", folded_vertex::scene),
            entry("diamond", crystals::diamond),
            entry("two-reflections", reflections::scene),
            entry("calcite", crystals::calcite),
            entry("tetrahedral-helix", helix::scene),
            entry("rutile", crystals::rutile),
            entry("motions", motions::scene),
            entry("conformal-motions", conformal_motions::scene),
            entry("miura", miura::scene),
            entry("halite", crystals::halite),
            entry("stereographic", stereographic::scene),
            entry("camera-roll", camera_roll::scene),
            entry("spiral", spiral::scene),
            entry("spinel", crystals::spinel),
            entry("spans", spans::scene),
            entry("pyrite", crystals::pyrite),
        ]
    }
}
