//! Optional traits of other crates; ga-core's features decide, not the user's.

/// Nothing yet.
#[doc(hidden)]
#[macro_export]
macro_rules! element_features {
    ($($tokens:tt)*) => {};
}
