//! Which of this library's types the contests are run with, and how they act when they are unit.

/// The algebra of space, with the rotor a unit versor.
pub mod euclidean {
    ga_macros::define_algebra! {
        pub mod algebra: R3 {
            types {
                /// A vector.
                Vector { e1, e2, e3 }
                /// An area.
                Bivector { e23, e31, e12 }
                /// A volume.
                Trivector { e123 }
                /// A rotation.
                #[unit]
                Rotor { 1, e23, e31, e12 }
            }
        }
    }
    pub use algebra::*;
}

/// The plane-based algebra, with the motor a unit versor.
pub mod plane_based {
    ga_macros::define_algebra! {
        pub mod algebra: R3_0_1 {
            basis { e0, e1, e2, e3 }
            metric { e1^2 = 1, e2^2 = 1, e3^2 = 1 }
            types {
                /// A plane.
                Plane { e1, e2, e3, e0 }
                /// A line.
                Line { e23, e31, e12, e01, e02, e03 }
                /// A point of weight 1.
                Point { e123 = 1, e032, e013, e021 }
                /// A direction.
                Direction { e032, e013, e021 }
                /// A point with a weight.
                WeightedPoint { e123, e032, e013, e021 }
                /// A rotation.
                #[unit]
                Rotor { 1, e23, e31, e12 }
                /// A translation.
                #[unit]
                Translator { 1 = 1, e01, e02, e03 }
                /// A rigid motion.
                #[unit]
                Motor { 1, e23, e31, e12, e01, e02, e03, e0^e123 }
                /// The pseudoscalar.
                Pseudoscalar { e0^e123 }
            }
        }
    }
    pub use algebra::*;

    /// The exponential of a line.
    pub fn screw<T: ga_core::Real>(line: Line<T>) -> Motor<T> {
        ga_core::convert::pick(line.exp())
    }
}

/// A versor known to be unit.
pub fn unit<V>(versor: V) -> V {
    versor
}

/// The conformal algebra, with the motor a unit versor.
pub mod conformal {
    ga_macros::define_algebra! {
        pub mod algebra: R4_1 {
            basis { e1, e2, e3, no, ni }
            metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1 }
            types {
                /// A point of weight 1.
                Point { no = 1, e1, e2, e3, ni }
                /// A dual sphere.
                DualSphere { no, e1, e2, e3, ni }
                /// A dual plane.
                DualPlane { e1, e2, e3, ni }
                /// A point pair.
                PointPair = grade 2;
                /// A circle.
                Circle = grade 3;
                /// A line.
                Line { e12^ni, e13^ni, e23^ni, e1^no^ni, e2^no^ni, e3^no^ni }
                /// A sphere.
                Sphere = grade 4;
                /// A rotation.
                #[unit]
                Rotor { 1, e12, e13, e23 }
                /// A translation.
                #[unit]
                Translator { 1 = 1, e1^ni, e2^ni, e3^ni }
                /// A rigid motion.
                #[unit]
                Motor { 1, e12, e13, e23, e1^ni, e2^ni, e3^ni, e123^ni }
                /// An inversion, a translation and the inversion back.
                #[unit]
                Transversor { 1 = 1, e1^no, e2^no, e3^no }
                /// Any even versor.
                #[unit]
                Versor { 1, e12, e13, e23, e1^no, e2^no, e3^no, e1^ni, e2^ni, e3^ni, no^ni, e123^no, e123^ni, e12^no^ni, e13^no^ni, e23^no^ni }
            }
        }
    }
    pub use algebra::*;
}
