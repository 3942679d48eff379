//! A crate that knows the library under another name.

algebra::define_algebra!(R2);

algebra::define_algebra! {
    /// Vectors with names of their own.
    pub mod named: R1_1 {
        basis { no, ni }
        metric { no.ni = -1 }
        types {
            /// A null vector.
            Origin { no }
            Line { no, ni }
        }
    }
}

/// The source of the first algebra.
pub const SOURCE: &str = algebra::algebra_source!(R2);

/// Uses both.
pub fn product() -> (r2::Even, named::Scalar) {
    let (a, b) = (r2::Vector::new(1.0, 2.0), r2::Vector::new(3.0, 4.0));
    (a * b, named::Origin::new(1.0) | named::Line::new(0.0, 1.0))
}
