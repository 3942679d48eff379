//! A crate that says itself where the core is, and passes the macro on.

#![deny(missing_docs, warnings)]

/// The core, where this crate keeps it.
pub mod inner {
    pub use ga::core;
}

ga::define_algebra! {
    crate = crate::inner::core;
    R2
}

ga::define_algebra! {
    crate = ::ga::core;
    /// With a leading `::`.
    pub mod absolute: R2 {}
}

/// The macro under another name.
pub use ga::define_algebra as geometric_algebra;

/// Algebras declared by a macro of this crate, from pieces of its input.
macro_rules! plane {
    ($name:ident, $signature:ident, $square:literal) => {
        crate::geometric_algebra! {
            /// Declared by a macro.
            pub mod $name: $signature {
                metric { e1^2 = $square, e2^2 = $square }
            }
        }
    };
}

plane!(positive, R2, 1);
plane!(negative, R0_2, -1);

/// Squares of unit vectors.
pub fn squares() -> (f64, f64) {
    (
        positive::Vector::new(1.0, 0.0).norm_squared(),
        negative::Vector::new(1.0, 0.0).norm_squared(),
    )
}
