//! Batches against single elements: every operation, on every target of the machine.

mod attempts;
mod container;
mod forms;
mod functions;
mod neighbours;
mod operations;
mod parallel;
mod samples;
mod slices;

ga_macros::define_algebra! {
    crate = ga_core;
    /// The conformal model of the plane, with points of weight 1 and unit motors.
    mod plane: R3_1 {
        basis { e1, e2, no, ni }
        metric { e1^2 = 1, e2^2 = 1, no.ni = -1 }
        types {
            /// A point of weight 1.
            Point { no = 1, e1, e2, ni }
            /// Any vector.
            Vector { no, e1, e2, ni }
            /// Any bivector.
            Pair = grade 2;
            /// Any trivector.
            Circle = grade 3;
            /// A rigid motion, a unit versor.
            #[unit]
            Motor { 1, e12, e1^ni, e2^ni }
            /// Any even element.
            Even { 1, e12, e1^no, e1^ni, e2^no, e2^ni, no^ni, e12^no^ni }
        }
    }
}

ga_macros::define_algebra! { crate = ga_core; R3 }

ga_macros::define_algebra! {
    crate = ga_core;
    /// Plane-based geometry of space.
    mod space: R3_0_1 {
        basis { e0, e1, e2, e3 }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, e0^2 = 0 }
        types {
            /// Any bivector.
            Line = grade 2;
            /// A rigid motion.
            Motor { 1, e23, e31, e12, e01, e02, e03, e0123 }
            /// A multiple of the pseudoscalar.
            Pseudoscalar { e0123 }
        }
    }
}
