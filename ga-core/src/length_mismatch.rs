//! The error of operations element by element whose two sides are not equally many.

use core::fmt;

/// Elements were to be combined one by one with more or fewer of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// How many there are on the left: in a batch, or in the slice of elements.
    pub left: usize,
    /// How many there are on the right: in the other batch, or in the slice of images.
    pub right: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} elements do not go with {} one by one; give as many on both sides",
            self.left, self.right
        )
    }
}

impl core::error::Error for LengthMismatch {}
