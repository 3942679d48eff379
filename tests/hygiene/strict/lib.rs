//! A crate of the strictest lints, with type names that every other crate has in its prelude.

#![forbid(unsafe_code)]
#![deny(missing_docs, warnings, clippy::all)]
#![deny(unreachable_patterns, unused_qualifications, rust_2018_idioms)]

ga::define_algebra!(R2);
ga::define_algebra!(R1_1);

ga::define_algebra! {
    /// Names that stand for other things elsewhere.
    pub mod prelude_names: R3 {
        types {
            /// Not the option of the prelude.
            Option { e1, e2, e3 }
            /// Not the vector of the prelude.
            Vec { 1, e12 }
            Clone { e12, e23, e31 }
            Default { e1 = 1, e2 }
            Borrow { e1, e2 = 1/2 }
            Some { e3 }
            Result { e123 }
            Box { e1, e3 }
            Iterator { e2, e3 }
            Into { e12, e13 }
            String { 1, e123 }
            PartialEq { e23 }
            Debug { e13 }
            Sized { e2 }
            Send { e1, e12 }
            Add { 1, e1 }
            Index { 1, e2 }
            Sum { 1, e3 }
            Display { 1, e23 }
            Fn { 1, e13 }
            Drop { 1, e12, e13, e23 }
        }
    }
}

ga::define_algebra! {
    // Used nowhere, documented nowhere, visible nowhere.
    mod private: R2_0_1 {
        basis { X, Y, zero }
        types {
            Line { X, Y, zero }
            #[unit]
            Motor { 1, X^Y, Y^zero, zero^X }
        }
        products { geometric, apply }
    }
}

ga::define_algebra! {
    pub(crate) mod narrow: R2 {
        basis { i, f }
        types {
            #[must_use]
            Plane { i^f }
            #[deprecated]
            Old { i, f }
        }
        products {}
    }
}

/// Two metrics in one module.
pub fn products() -> (r2::Even, r1_1::Even) {
    let (a, b) = (r2::Vector::new(1.0, 2.0), r1_1::Vector::new(3.0, 4.0));
    (a * a, b * b)
}

/// In the body of a function, where no path of the module reaches.
pub fn local() -> f64 {
    ga::define_algebra!(R1);
    r1::Vector::new(3.0).norm()
}
