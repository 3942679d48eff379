//! Structures made with the conformal model: crystals and other symmetric forms.

pub mod camera;
pub mod crystallography;
pub mod export;
pub mod folding;
pub mod gallery;
pub mod linkages;
pub mod mesh;
pub mod tensegrity;
pub mod warp;
