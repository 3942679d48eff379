//! Transformations (2.4.4): which versor does what, and what the product of two of them is.
//!
//! Every transformation is a product of reflections, so all of them are applied alike: `apply` is
//! X ↦ V X̂ V⁻¹ (2.28) with the grade involution for odd versors, for each kind of element, and
//! keeps what the element is. A product acts from the right: `b * a` does `a` first.
//!
#![cfg_attr(doc, doc = include_str!("../pictures/motions.md"))]
#![cfg_attr(doc, doc = include_str!("../pictures/conformal-motions.md"))]
//!
//! | transformation | made by | type |
//! |---|---|---|
//! | reflection in a plane | the [`DualPlane`](crate::DualPlane) itself | `DualPlane` |
//! | inversion, reflection in a sphere | the [`DualSphere`](crate::DualSphere) itself | `DualSphere` |
//! | half turn about a line | the [`DualLine`](crate::DualLine) itself | `DualLine` |
//! | reflection in any other element | the element itself, by its `apply` | its own |
//! | rotation about the origin | [`Rotor::turn`](crate::Rotor::turn), [`Rotor::between`](crate::Rotor::between) | [`Rotor`](crate::Rotor) |
//! | rotation about a line | [`Motor::about_line`](crate::Motor::about_line) | [`Motor`](crate::Motor) |
//! | translation | [`Translator::by`](crate::Translator::by) | [`Translator`](crate::Translator) |
//! | screw | [`Motor::screw`](crate::Motor::screw) | [`Motor`](crate::Motor) |
//! | scaling about the origin | [`Dilator::scaling`](crate::Dilator::scaling) | [`Dilator`](crate::Dilator) |
//! | scaling about a point | [`Even::scaling`](crate::Even::scaling) | [`Even`](crate::Even) |
//! | transversion | [`Transversor::by`](crate::Transversor::by) | [`Transversor`](crate::Transversor) |
//!
//! Whatever else preserves circles and spheres is a [`ConformalRotor`], or, with a reflection,
//! an [`OddVersor`].
//!
//! The type of a product is the smallest that holds it:
//!
//! | first ╲ second | rotor | translator | motor | dilator | transversor | plane, sphere |
//! |---|---|---|---|---|---|---|
//! | rotor | rotor | motor | motor | even | even | odd |
//! | translator | motor | translator | motor | even | even | odd |
//! | motor | motor | motor | motor | even | even | odd |
//! | dilator | even | even | even | dilator | even | odd |
//! | transversor | even | even | even | even | transversor | odd |
//! | dual plane | odd | odd | odd | odd | odd | motor, even |
//! | dual sphere | odd | odd | odd | odd | odd | even |
//!
//! Long chains of products drift off the versors by rounding; `renormalized` brings them back.

mod conformal_rotor;
mod dilator;
mod image;
mod motor;
mod rotor;
mod similarity;
mod translator;
mod transversor;

pub use conformal_rotor::{ConformalRotor, OddVersor};
