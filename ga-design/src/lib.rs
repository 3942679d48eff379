//! Structures made with the conformal model: crystals and other symmetric forms.

pub mod crystallography;
pub mod export;
pub mod gallery;
pub mod mesh;
