//! Decides what is said when a scene cannot be made or saved: what is wrong, where, and what to do.

use super::Format;
use crate::mesh::MeshError;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a scene could not be made or saved.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The scene shows nothing.
    #[error("the scene “{scene}” is empty: add at least one node")]
    EmptyScene {
        /// The scene's title.
        scene: String,
    },
    /// The scene has nothing of the kind that the format holds.
    #[error("the scene “{scene}” has no {needed}, and a .{} file holds nothing else", format.ending())]
    NothingToHold {
        /// The scene's title.
        scene: String,
        /// The format asked for.
        format: Format,
        /// What it would need: “surfaces” or “lines”.
        needed: &'static str,
    },
    /// The ending of the path names no format.
    #[error(
        "{}: the ending names no format; use one of {}",
        path.display(),
        Format::ALL.map(|format| format!(".{}", format.ending())).join(" ")
    )]
    UnknownEnding {
        /// The path asked for.
        path: PathBuf,
    },
    /// A number is NaN, infinite or out of range.
    #[error("{what} is {value}: {remedy}")]
    Number {
        /// Which number it is.
        what: &'static str,
        /// The number itself.
        value: f64,
        /// What it should be.
        remedy: &'static str,
    },
    /// A shape or material was made for another scene.
    #[error(
        "node “{node}” names a {kind} that this scene does not have: add it to the scene first"
    )]
    Foreign {
        /// The node's name.
        node: String,
        /// “shape” or “material”.
        kind: &'static str,
    },
    /// A line has fewer than two points.
    #[error("a line needs at least two points")]
    ShortLine,
    /// More vertices, triangles or bytes than the format can count.
    #[error("the scene is too large for .{}: {what}; save parts of it or use coarser shapes", format.ending())]
    TooLarge {
        /// The format asked for.
        format: Format,
        /// Which limit is passed.
        what: &'static str,
    },
    /// The picture asked for has no pixels or far too many.
    #[error(
        "a picture of {width} × {height} pixels cannot be made: each side must be from 1 to 8192, and all pixels at most 33 million"
    )]
    PictureSize {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// A name of a scene or drawing cannot be used as a file name.
    #[error(
        "“{name}” cannot name a scene or drawing of a gallery: use lower-case letters, digits and hyphens"
    )]
    SceneName {
        /// The name.
        name: String,
    },
    /// Two scenes of a gallery, or two drawings of a scene, have one name.
    #[error("two scenes or drawings are named “{name}”: each needs a name of its own")]
    RepeatedName {
        /// The name.
        name: String,
    },
    /// A surface cannot be made.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The operating system refused.
    #[error("{}: cannot {action}: {source}; {remedy}", path.display())]
    Write {
        /// The file or directory.
        path: PathBuf,
        /// What was tried.
        action: &'static str,
        /// What the system said.
        source: io::Error,
        /// What would help.
        remedy: &'static str,
    },
    /// An encoder refused.
    #[error("cannot encode .{}: {reason}", format.ending())]
    Encode {
        /// The format asked for.
        format: Format,
        /// What the encoder said.
        reason: String,
    },
}
