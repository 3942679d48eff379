//! R3,3, projective space by its lines: every line is a null vector, and every projective
//! transformation is a versor.
//!
//! A line has six homogeneous coordinates after Plücker, its direction **d** and its moment
//! **m** = **x** × **d** about the origin. They are the vector Σ dᵢ`d`ᵢ + mᵢ`m`ᵢ in the basis with
//! dᵢ·mᵢ = 1, which is null because **d**·**m** = 0; two lines meet, or are parallel, exactly
//! where their inner product is zero. All lines through a point span a null 3-blade, and so do
//! all lines of a plane: the two families of null 3-blades are the points and the planes.
//!
//! Even versors map points to points: they are the collineations, the 4×4 matrices of positive
//! determinant. Odd versors exchange points and planes: they are the correlations.
//!
//! ```
//! use ga_spaces::projective3::{Collineation, Line, Trivector};
//!
//! // A perspective: the plane z = −1 goes to infinity, what is parallel to z converges.
//! let view = [
//!     [1.0, 0.0, 0.0, 0.0],
//!     [0.0, 1.0, 0.0, 0.0],
//!     [0.0, 0.0, 1.0, 0.0],
//!     [0.0, 0.0, 1.0, 1.0],
//! ];
//! let versor = Collineation::from_matrix(view).unwrap();
//! let image: Trivector = versor.apply(Trivector::point([2.0, 4.0, 1.0, 1.0]));
//! let [x, y, z, w] = image.point_coordinates().unwrap();
//! assert!((x / w - 1.0).abs() < 1e-12 && (y / w - 2.0).abs() < 1e-12 && (z / w - 0.5).abs() < 1e-12);
//! ```
//!
//! Homogeneous coordinates are in the order x, y, z, w, a point with w = 0 is a direction, and a
//! plane a x + b y + c z + d w = 0 is \[a, b, c, d\].
//!
//! Sources: Dorst, *3D oriented projective geometry through versors of R3,3* (2016); Klawitter,
//! *A Clifford algebraic approach to line geometry* (2014); both cited in §2.3.8 of the
//! dissertation.

mod element;
mod transformation;

ga_macros::define_algebra! {
    mod algebra: R3_3 {
        basis { d1, d2, d3, m1, m2, m3 }
        metric { d1.m1 = 1, d2.m2 = 1, d3.m3 = 1 }
        types {
            /// A line by direction and moment where it is null; any linear complex of lines. The
            /// versor of one that is not null is a correlation, the null polarity.
            Line { d1, d2, d3, m1, m2, m3 }
            /// A direction, as the line through the origin along it.
            Direction { d1, d2, d3 }
            /// A moment, as the line at infinity of the planes with this normal.
            Moment { m1, m2, m3 }
            /// The generator of a collineation; a null 2-blade is a pencil, the lines through a
            /// point in a plane.
            Bivector = grade 2;
            /// A point or a plane where it is a null 3-blade; a quadric or a regulus elsewhere.
            Trivector = grade 3;
            /// The generator of a translation.
            IdealBivector { m23, m31, m12 }
            /// The generator of a perspective that keeps the origin.
            OriginBivector { d23, d31, d12 }
        }
        products { geometric, wedge, left_contract, scalar_product, commutator, sandwich }
    }
}

pub use algebra::*;

/// A collineation with positive determinant, and with them every even element.
pub type Collineation<T = f64> = Even<T>;
