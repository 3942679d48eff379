//! Flat elements: planes.

mod dual_plane;
