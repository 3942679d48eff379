//! Approximate equality: coefficient by coefficient, with one tolerance for all.

/// The three comparisons of `approx`, for whatever numbers have them.
#[cfg(feature = "approx")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_approx {
    ($Name:ident $($field:ident)*) => {
        impl<T: $crate::crates::approx::AbsDiffEq> $crate::crates::approx::AbsDiffEq for $Name<T>
        where
            T::Epsilon: ::core::marker::Copy,
        {
            type Epsilon = T::Epsilon;

            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                $(<T as $crate::crates::approx::AbsDiffEq>::abs_diff_eq(
                    &self.$field, &other.$field, epsilon,
                ))&&*
            }
        }

        impl<T: $crate::crates::approx::RelativeEq> $crate::crates::approx::RelativeEq for $Name<T>
        where
            T::Epsilon: ::core::marker::Copy,
        {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }

            fn relative_eq(
                &self,
                other: &Self,
                epsilon: T::Epsilon,
                max_relative: T::Epsilon,
            ) -> bool {
                $(<T as $crate::crates::approx::RelativeEq>::relative_eq(
                    &self.$field, &other.$field, epsilon, max_relative,
                ))&&*
            }
        }

        impl<T: $crate::crates::approx::UlpsEq> $crate::crates::approx::UlpsEq for $Name<T>
        where
            T::Epsilon: ::core::marker::Copy,
        {
            fn default_max_ulps() -> u32 {
                T::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, max_ulps: u32) -> bool {
                $(<T as $crate::crates::approx::UlpsEq>::ulps_eq(
                    &self.$field, &other.$field, epsilon, max_ulps,
                ))&&*
            }
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "approx"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_approx {
    ($($tokens:tt)*) => {};
}
