//! R4,2, Lie's geometry of oriented spheres: one vector for a sphere, a plane or a point, and
//! oriented contact as a product that vanishes.
//!
//! A sphere with centre **c** and signed radius ρ is the null vector
//! n_o + **c** + ½(**c**² − ρ²) n_∞ + ρ r with r² = −1: its radius is one more coordinate.
//! The sign of the radius is its orientation, a point has radius 0, and a plane is a sphere
//! through infinity. Two of them touch with one orientation — the nearer inside of the one is
//! that of the other — exactly where their inner product is zero. Versors keep contact: those
//! that keep r are the conformal transformations (Möbius), those that keep n_∞ move planes to
//! planes and change radii (Laguerre), and together they mix both.
//!
//! ```
//! use ga_spaces::lie_sphere::{Offset, Sphere};
//!
//! let ball = Sphere::about([0.0, 0.0, 0.0], 3.0);
//! let inside = Sphere::about([1.0, 0.0, 0.0], 2.0);
//! assert!(ball.touches(inside, 0.0));
//! // Both grow by the same amount and still touch.
//! let grow = Offset::by(0.5);
//! let (ball, inside): (Sphere, Sphere) = (grow.apply(ball), grow.apply(inside));
//! assert_eq!((ball.radius(), ball.touches(inside, 1e-15)), (3.5, true));
//! ```
//!
//! Sources: Cecil, *Lie Sphere Geometry* (2008), chapters 2 and 3; Krasauskas, cited in §2.3.8
//! of the dissertation.

mod contact;

use ga_core::{Field, Real};

pub use contact::{Contacts, OrientedElement};

ga_macros::define_algebra! {
    mod algebra: R4_2 {
        basis { e1, e2, e3, no, ni, r }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1, r^2 = -1 }
        types {
            /// A Euclidean vector.
            Vector3 { e1, e2, e3 }
            /// An oriented sphere of weight 1, a point where its radius is zero.
            #[null]
            Sphere { no = 1, e1, e2, e3, ni, r }
            /// A vector without n_o, **n** + δ n_∞ + ρ r: an oriented plane where it is null.
            Plane { e1, e2, e3, ni, r }
            /// A vector without r: a sphere of Möbius' geometry, without orientation, whose
            /// versor is the inversion in it.
            Unoriented { no, e1, e2, e3, ni }
            /// Any vector; a null one is an oriented sphere, plane, point or infinity.
            Vector { no, e1, e2, e3, ni, r }
            /// A bivector; where its vectors are null, a pencil of spheres in contact.
            Bivector = grade 2;
            /// A trivector: three spheres, whose common contacts envelope a cyclide of Dupin.
            Trivector = grade 3;
            /// Four spheres.
            Quadvector = grade 4;
            /// A change of all radii by the same amount, of unit norm: Laguerre's offset.
            #[unit]
            Offset { 1 = 1, ni^r }
            /// A translation, of unit norm.
            #[unit]
            Translator { 1 = 1, e1^ni, e2^ni, e3^ni }
            /// A rotation about the origin.
            Rotor { 1, e12, e13, e23 }
        }
        products { geometric, wedge, left_contract, scalar_product, sandwich }
    }
}

pub use algebra::*;

impl<T: Field> Sphere<T> {
    /// The sphere about a centre with a signed radius; a point where that is zero.
    pub fn about(center: [T; 3], radius: T) -> Self {
        let [e1, e2, e3] = center;
        let square = Vector3::new(e1, e2, e3).norm_squared() - radius * radius;
        Sphere {
            e1,
            e2,
            e3,
            ni: square * T::from_ratio(1, 2),
            r: radius,
        }
    }

    /// The centre.
    pub fn center(self) -> [T; 3] {
        [self.e1, self.e2, self.e3]
    }

    /// The signed radius.
    pub fn radius(self) -> T {
        self.r
    }

    /// The same sphere, oriented the other way.
    pub fn reversed_orientation(self) -> Self {
        Sphere { r: -self.r, ..self }
    }
}

impl<T: Real> Plane<T> {
    /// The plane **n**·**x** = δ, oriented by its normal, which is made a unit: the side that
    /// spheres in contact with it and of positive radius are on. `None` for a normal of length
    /// zero; δ counts in units of the given normal.
    pub fn facing(normal: [T; 3], offset: T) -> Option<Self> {
        let [x, y, z] = normal;
        let length = Vector3::new(x, y, z).norm();
        (length.is_invertible() && length.is_finite())
            .then(|| Plane::new(x, y, z, offset, length) * (T::ONE / length))
    }
}

impl<T: Field> Vector<T> {
    /// Infinity n_∞, which all planes touch.
    pub fn infinity() -> Self {
        Vector {
            ni: T::ONE,
            ..Vector::default()
        }
    }
}

impl<T: Field> Offset<T> {
    /// The offset that adds `h` to every signed radius, the translation along r: 1 + ½h n_∞ r.
    pub fn by(h: T) -> Self {
        Offset::new(h * T::from_ratio(1, 2))
    }
}

impl<T: Field> Translator<T> {
    /// The translation by a vector, 1 − ½**v** n_∞.
    pub fn by(v: [T; 3]) -> Self {
        let [x, y, z] = v.map(|c| c * T::from_ratio(-1, 2));
        Translator::new(x, y, z)
    }
}

impl<T: Field> Unoriented<T> {
    /// The sphere about a centre with a squared radius, whose versor is the inversion in it.
    pub fn about(center: [T; 3], radius_squared: T) -> Self {
        let mut sphere: Unoriented<T> = ga_core::convert::pick(Sphere::about(center, T::ZERO));
        sphere.ni -= radius_squared * T::from_ratio(1, 2);
        sphere
    }
}
