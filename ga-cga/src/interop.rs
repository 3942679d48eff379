//! Points and motions of other libraries: which of their types is which of ours.
//!
//! | here | nalgebra | glam | mint |
//! |---|---|---|---|
//! | [`Vector3`](crate::Vector3) | `Vector3` | `Vec3`, `DVec3` | `Vector3` |
//! | [`Point`](crate::Point) | `Point3` | `Vec3`, `DVec3` | `Point3` |
//! | [`Rotor`](crate::Rotor) | `UnitQuaternion` | `Quat`, `DQuat` | `Quaternion` |
//! | [`Translator`](crate::Translator) | `Translation3` | | |
//! | [`Motor`](crate::Motor) | `Isometry3`, `UnitDualQuaternion` | | |
//!
//! All are `From` both ways, each behind the feature of the library's name. What need not exist is
//! `TryFrom` both ways, with a [`MatrixError`]:
//!
//! | here | nalgebra | glam |
//! |---|---|---|
//! | [`Rotor`](crate::Rotor) | from `Matrix3` | |
//! | [`Motor`](crate::Motor) | `Matrix4` | `Mat4`, `DMat4`, `Affine3A`, `DAffine3` |
//! | [`Even`](crate::Even), a similarity | `Matrix4`, `Similarity3` | `Mat4`, `DMat4` |
//!
//! Without any feature there are plain lists: `to_matrix` and `from_matrix` of
//! [`Rotor`](crate::Rotor::to_matrix), [`Motor`](crate::Motor::to_matrix) and
//! [`Even`](crate::Even::to_matrix), by rows; the quaternion of a
//! [`Rotor`](crate::Rotor::to_quaternion) and the dual quaternion of a
//! [`Motor`](crate::Motor::to_dual_quaternion), w first.
//!
//! A quaternion w + x i + y j + z k is the rotor w − x e23 + y e13 − z e12: both stand on the
//! left of what they turn, both turn by twice the angle whose cosine is w, and they multiply
//! alike. A translation by v is the translator 1 − ½ v n_∞, and an isometry, which turns first
//! and translates then, is the motor translator · rotor.
//!
//! What is `From` is neither checked nor normalised: rotors and motors are unit versors by
//! declaration, and so are the quaternions of rotations. Normalise first what has drifted away
//! from that. Matrices do not depend on the weight of the versor.
//!
//! Besides, the features of ga-core take any element as the plain list of its coefficients to
//! and from vectors of the same length: `SVector` of nalgebra for every type, vectors of glam
//! and mint for two to four coefficients. For a [`Translator`](crate::Translator) these are the
//! coefficients −½ v and not the vector v that it translates by.
//!
//! ```
//! # #[cfg(feature = "mint")] {
//! use ga_cga::Point;
//!
//! let p = Point::from(mint::Point3 { x: 1.0, y: 2.0, z: 2.0 });
//! assert_eq!(p, Point::at(1.0, 2.0, 2.0));
//! # }
//! ```

mod convention;
#[cfg(feature = "glam")]
mod glam;
mod matrix;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "nalgebra")]
mod nalgebra;

pub use matrix::{MATRIX_TOLERANCE, MatrixError};
