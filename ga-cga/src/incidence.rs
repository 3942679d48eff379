//! How elements lie to each other: what they share and span, how far apart they are, at what
//! angle they cross, and what one casts on another.
//!
//! Every function takes any two elements, direct or dual, in whatever type they are stored (see
//! [`Figure`]), and answers with what is really there: [`meet`] of two planes is a line, and a
//! direction where they are parallel, and the plane itself where they are one.
//!
#![cfg_attr(doc, doc = include_str!("../pictures/meets.md"))]
//!
//! ```
//! use ga_cga::{Classification, DualPlane, DualSphere, Line, Point, Shape, Vector3};
//! use ga_cga::incidence::{angle, contains, distance, join, meet, nearest};
//!
//! let up = Vector3::new(0.0, 0.0, 1.0);
//! let ground = DualPlane::at_distance(up, 0.0);
//! let ball = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.5), 1.0);
//! let waterline = meet(ball, ground).circle().unwrap();
//! assert_eq!(waterline.center(), Some(Point::at(0.0, 0.0, 0.0)));
//! assert_eq!(waterline.radius_squared(), Some(0.75));
//!
//! let level = DualPlane::at_distance(up, 2.0);
//! assert!(matches!(meet(ground, level), Classification::Direct(Shape::Direction(_))));
//! assert_eq!(distance(ground, level), Some(2.0));
//! assert_eq!(distance(ball, level), Some(0.5));
//!
//! let mast = Line::along(Point::at(1.0, 1.0, 0.0), up);
//! assert_eq!(angle(mast, ground), Some(core::f64::consts::FRAC_PI_2));
//! assert!(contains(mast, Point::at(1.0, 1.0, 7.0)));
//! assert!(join(mast, Point::at(0.0, 0.0, 0.0)).plane().is_some());
//! assert_eq!(nearest(mast, Point::at(4.0, 1.0, 3.0)), Some(Point::at(1.0, 1.0, 3.0)));
//! ```
//!
//! Decisions are made in a frame of their own, at the place and in the size of the two elements,
//! so that they are the same everywhere in space; the tolerance is the default one of
//! [`Tolerance`](crate::Tolerance), grown by the rounding that the distance from the origin has
//! put into the coefficients: with d that distance and s the size of the pair (the larger of their
//! radii and their distance, and 1 at least where neither is round), by 1 + d/s for flats and
//! 1 + (d/s)² where a round takes part.
//!
//! An element is first taken for what [`classify()`](crate::classify()) says, for which a length of
//! 1 is ordinary: a sphere with a radius below 2.4e−7 at the origin is a point. Scenes in
//! much smaller units are scaled up first.

mod angle;
mod circle;
mod contains;
mod distance;
mod figure;
mod frame;
mod locus;
mod meet;
mod nearest;
mod project;

pub use angle::angle;
pub use contains::contains;
pub use contains::contains_within;
pub use distance::distance;
pub use figure::Figure;
pub use meet::{join, meet, plunge};
pub use nearest::{nearest, nearest_points};
pub use project::{project, reject};
