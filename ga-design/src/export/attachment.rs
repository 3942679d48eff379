//! Decides what goes with a scene besides its shapes: finished drawings.

/// A drawing that goes with a scene, as the text of an SVG file.
#[derive(Debug, Clone, PartialEq)]
pub struct Attachment {
    /// The name, for a file in the folder of the scene: lower-case letters, digits and hyphens.
    pub name: String,
    /// The text of the SVG file.
    pub svg: String,
}
