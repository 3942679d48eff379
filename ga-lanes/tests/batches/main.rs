//! Batches against single elements: every operation, on every target of the machine.

mod attempts;
mod container;
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
