//! Round elements: points, which are spheres of radius zero, and spheres.

mod dual_sphere;
mod point;
