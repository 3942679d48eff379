//! Points and motions of other libraries: which of their types is which of ours.
//!
//! | here | nalgebra | glam | mint |
//! |---|---|---|---|
//! | [`Vector3`](crate::Vector3) | `Vector3` | `Vec3`, `DVec3` | `Vector3` |
//! | [`Point`](crate::Point) | `Point3` | `Vec3`, `DVec3` | `Point3` |
//! | [`Rotor`](crate::Rotor) | `UnitQuaternion` | `Quat`, `DQuat` | `Quaternion` |
//! | [`Translator`](crate::Translator) | `Translation3` | | |
//! | [`Motor`](crate::Motor) | `Isometry3` | | |
//!
//! All are `From` both ways, each behind the feature of the library's name. A quaternion
//! w + x i + y j + z k is the rotor w − x e23 + y e13 − z e12: both stand on the left of what
//! they turn, both turn by twice the angle whose cosine is w, and they multiply alike. A
//! translation by v is the translator 1 − ½ v n_∞, and an isometry, which turns first and
//! translates then, is the motor translator · rotor.
//!
//! Nothing is checked or normalised: rotors and motors are unit versors by declaration, and so
//! are the quaternions of rotations. Normalise first what has drifted away from that.
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

#[cfg(any(feature = "glam", feature = "mint", feature = "nalgebra"))]
mod convention;
#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "nalgebra")]
mod nalgebra;
