//! Decides which file formats a scene can be saved in, and that the ending of the path chooses.
//!
//! A design is described once, as a [`Scene`]; each submodule turns a scene into the bytes of one
//! format, and [`mod@write`] puts bytes on the disk so that no half-written file is ever seen.
//!
//! | ending | written by | what it holds |
//! |---|---|---|
//! | `.glb` | [`glb`] | everything, shared shapes stored once, turned to y up as glTF requires |
//! | `.obj` | [`obj`] | surfaces, lines and, in an `.mtl` file beside it, materials; z up |
//! | `.stl` | [`stl`] | surfaces as bare triangles, for printing; z up |
//! | `.ply` | [`ply`] | surfaces with normals and colours; z up |
//! | `.svg` | [`svg`] | lines, in parallel projection, for cutting and drawing |
//! | `.png` | [`picture`] | a rendered picture |
//!
//! Patterns of the plane have a drawing of their own, with filled areas: [`flat`].

pub mod attachment;
pub mod error;
pub mod flat;
pub mod flatten;
pub mod gallery;
pub mod glb;
pub mod material;
pub mod obj;
pub mod picture;
pub mod placement;
pub mod ply;
pub mod scene;
pub mod stl;
pub mod svg;
pub mod view;
pub mod write;

pub use attachment::Attachment;
pub use error::ExportError;
pub use gallery::write_gallery;
pub use material::Material;
pub use placement::Placement;
pub use scene::{Instances, Line, MaterialId, Node, Placed, Scene, Shape, ShapeId};
pub use view::View;

use std::path::{Path, PathBuf};

/// A file format that a scene can be saved in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Binary glTF 2.0, for viewers and Blender.
    Glb,
    /// Wavefront OBJ with its MTL file, for Rhino and most others.
    Obj,
    /// Binary STL, for printing.
    Stl,
    /// Binary PLY, for MeshLab.
    Ply,
    /// A vector drawing of the lines.
    Svg,
    /// A rendered picture.
    Png,
}

impl Format {
    /// Every format, in the order in which messages list them.
    pub const ALL: [Format; 6] = [
        Format::Glb,
        Format::Obj,
        Format::Stl,
        Format::Ply,
        Format::Svg,
        Format::Png,
    ];

    /// The ending of the format's files, without the dot.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Format::Glb => "glb",
            Format::Obj => "obj",
            Format::Stl => "stl",
            Format::Ply => "ply",
            Format::Svg => "svg",
            Format::Png => "png",
        }
    }

    /// The format that the ending of a path asks for, in capitals or not.
    ///
    /// ```
    /// use ga_design::export::Format;
    /// assert_eq!(Format::from_path("quartz.GLB".as_ref())?, Format::Glb);
    /// let error = Format::from_path("quartz.doc".as_ref()).unwrap_err();
    /// assert!(error.to_string().contains(".glb .obj .stl .ply .svg .png"));
    /// # Ok::<(), ga_design::export::ExportError>(())
    /// ```
    ///
    /// # Errors
    /// [`ExportError::UnknownEnding`], which lists the endings that there are.
    pub fn from_path(path: &Path) -> Result<Self, ExportError> {
        let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
        Self::ALL
            .into_iter()
            .find(|format| ending == format.ending())
            .ok_or_else(|| ExportError::UnknownEnding {
                path: path.to_owned(),
            })
    }
}

/// Saves the scene in the format that the ending of the path asks for.
///
/// The file is complete or not there at all; an existing file is replaced. The directory must exist.
///
/// # Errors
/// [`ExportError`] if the ending is unknown, the scene has nothing that the format can hold, or the
/// file cannot be written.
pub fn save(scene: &Scene, path: &Path) -> Result<(), ExportError> {
    let format = Format::from_path(path)?;
    write::write_files(&encode(scene, format, path)?)
}

/// The files that saving the scene at `path` would write: one, or for OBJ the geometry and its
/// materials.
///
/// # Errors
/// [`ExportError`] if the scene has nothing that the format can hold.
pub fn encode(
    scene: &Scene,
    format: Format,
    path: &Path,
) -> Result<Vec<(PathBuf, Vec<u8>)>, ExportError> {
    let bytes = match format {
        Format::Glb => glb::encode(scene)?,
        Format::Stl => stl::encode(scene)?,
        Format::Ply => ply::encode(scene)?,
        Format::Svg => svg::encode(scene)?.into_bytes(),
        Format::Png => picture::render(scene, &picture::Settings::default())?.to_png()?,
        Format::Obj => {
            let materials = path.with_extension("mtl");
            let library = materials.file_name().unwrap_or_default().to_string_lossy();
            let files = obj::encode(scene, &library)?;
            return Ok(vec![
                (materials, files.materials.into_bytes()),
                (path.to_owned(), files.geometry.into_bytes()),
            ]);
        }
    };
    Ok(vec![(path.to_owned(), bytes)])
}
