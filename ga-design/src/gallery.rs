//! Decides which scenes the gallery shows, in which order.
//!
//! A scene is a function of its own in a file of its own: it makes a figure with the algebra, and a
//! test beside it holds what must be true of that figure. Adding one is a row of [`entries`].

mod axial_glides;
mod balanced_shapes;
mod camera_roll;
mod conformal_motions;
mod covariance;
mod crystals;
mod folded_vertex;
mod fundamental_domain;
mod helix;
mod hexagonal_screws;
mod horn;
mod kaleidoscope;
mod lattice_of_horns;
mod meets;
mod miura;
mod motif;
mod motions;
mod palette;
mod plane_groups;
mod point_groups;
mod reflections;
mod roots;
mod screw_arcs;
mod screws;
mod spans;
mod special_position;
mod spiral;
mod stereographic;
mod tensegrities;
mod tetragonal;

use crate::crystallography::cif::CifError;
use crate::crystallography::overlay::OverlayError;
use crate::crystallography::symmetry_elements::{NoElement, TooManyElements};
use crate::crystallography::{
    BondError, CellError, CellRangeError, ExpansionError, FundamentalDomainError, GenerationError,
    HallError, MotifError, PlanePatternError, PointSymbolError, RootsError,
};
use crate::export::{ExportError, Scene};
use crate::folding::FoldError;
use crate::mesh::MeshError;
use crate::tensegrity::TensegrityError;
use crate::warp::WarpError;
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
    /// Two numbers stand for no roots.
    #[error(transparent)]
    Roots(#[from] RootsError),
    /// A symbol stands for no point group.
    #[error(transparent)]
    PointGroup(#[from] PointSymbolError),
    /// A structure of struts and cables could not be made.
    #[error(transparent)]
    Tensegrity(#[from] TensegrityError),
    /// A shape could not be warped.
    #[error(transparent)]
    Warp(#[from] WarpError),
    /// A cell is none.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// A space group could not be read.
    #[error(transparent)]
    Hall(#[from] HallError),
    /// A space group did not grow from its roots.
    #[error(transparent)]
    Generation(#[from] GenerationError),
    /// A pattern of the plane could not be made.
    #[error(transparent)]
    PlanePattern(#[from] PlanePatternError),
    /// A pattern could not be made.
    #[error(transparent)]
    Motif(#[from] MotifError),
    /// A fundamental domain could not be found.
    #[error(transparent)]
    Domain(#[from] FundamentalDomainError),
    /// Symmetry elements could not be found or drawn.
    #[error(transparent)]
    Overlay(#[from] OverlayError),
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

impl From<NoElement> for GalleryError {
    fn from(error: NoElement) -> Self {
        Self::Overlay(error.into())
    }
}

impl From<TooManyElements> for GalleryError {
    fn from(error: TooManyElements) -> Self {
        Self::Overlay(error.into())
    }
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
            entry("point-groups", point_groups::scene),
            entry("roots", roots::scene),
            entry("folded-vertex", folded_vertex::scene),
            entry("diamond", crystals::diamond),
            entry("two-reflections", reflections::scene),
            entry("calcite", crystals::calcite),
            entry("special-position", special_position::scene),
            entry("axial-glides", axial_glides::scene),
            entry("tetrahedral-helix", helix::scene),
            entry("expanded-octahedron", tensegrities::octahedron),
            entry("rutile", crystals::rutile),
            entry("tetragonal", tetragonal::scene),
            entry("screws", screws::scene),
            entry("plane-groups", plane_groups::scene),
            entry("motions", motions::scene),
            entry("conformal-motions", conformal_motions::scene),
            entry("miura", miura::scene),
            entry("tensegrity-tower", tensegrities::tower),
            entry("halite", crystals::halite),
            entry("balanced-shapes", balanced_shapes::scene),
            entry("fundamental-domain", fundamental_domain::scene),
            entry("screw-arcs", screw_arcs::scene),
            entry("hexagonal-screws", hexagonal_screws::scene),
            entry("stereographic", stereographic::scene),
            entry("camera-roll", camera_roll::scene),
            entry("tensegrity-solids", tensegrities::solids),
            entry("spiral", spiral::scene),
            entry("spinel", crystals::spinel),
            entry("octahedron-variations", tensegrities::variations),
            entry("spans", spans::scene),
            entry("pyrite", crystals::pyrite),
        ]
    }
}
