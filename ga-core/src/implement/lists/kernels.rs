//! Straight-line bodies: sums of products become chains of fused operations.

/// The statements of a generated body: what is named first, then the value or the struct that is
/// returned.
///
/// They are Rust as they stand; here every sum of products is evaluated as [`sum!`](crate::sum)
/// says. One pattern without recursion reads a body, so that compilation stays fast.
#[doc(hidden)]
#[macro_export]
macro_rules! kernel {
    (
        $(let [$($name:tt),*] = $value:expr;)*
        $(let $temporary:ident = $first:tt $(::$first_constant:ident)? $(.$first_field:tt)? $(* $by:tt $(.$by_field:tt)?)?
            $(+ $plus:tt $(.$plus_field:tt)? * $plus_by:tt $(.$plus_by_field:tt)?)*
            $(- $minus:tt $(.$minus_field:tt)? * $minus_by:tt $(.$minus_by_field:tt)?)*;)*
        return $Output:ident {
            $($field:ident: $lead:tt $(::$constant:ident)? $(.$lead_field:tt)? $(* $times:tt $(.$times_field:tt)?)?
                $(+ $add:tt $(.$add_field:tt)? * $add_by:tt $(.$add_by_field:tt)?)*
                $(- $sub:tt $(.$sub_field:tt)? * $sub_by:tt $(.$sub_by_field:tt)?)*),* $(,)?
        }
    ) => {
        $(let [$($name),*] = $value;)*
        $(let $temporary = ($first $(::$first_constant)? $(.$first_field)? $(* $by $(.$by_field)?)?)
            $(.plus_product($plus $(.$plus_field)?, $plus_by $(.$plus_by_field)?))*
            $(.minus_product($minus $(.$minus_field)?, $minus_by $(.$minus_by_field)?))*;)*
        $Output {
            $($field: ($lead $(::$constant)? $(.$lead_field)? $(* $times $(.$times_field)?)?)
                $(.plus_product($add $(.$add_field)?, $add_by $(.$add_by_field)?))*
                $(.minus_product($sub $(.$sub_field)?, $sub_by $(.$sub_by_field)?))*),*
        }
    };
    (
        $(let [$($name:tt),*] = $value:expr;)*
        $(let $temporary:ident = $first:tt $(::$first_constant:ident)? $(.$first_field:tt)? $(* $by:tt $(.$by_field:tt)?)?
            $(+ $plus:tt $(.$plus_field:tt)? * $plus_by:tt $(.$plus_by_field:tt)?)*
            $(- $minus:tt $(.$minus_field:tt)? * $minus_by:tt $(.$minus_by_field:tt)?)*;)*
        return $($sum:tt)*
    ) => {
        $(let [$($name),*] = $value;)*
        $(let $temporary = ($first $(::$first_constant)? $(.$first_field)? $(* $by $(.$by_field)?)?)
            $(.plus_product($plus $(.$plus_field)?, $plus_by $(.$plus_by_field)?))*
            $(.minus_product($minus $(.$minus_field)?, $minus_by $(.$minus_by_field)?))*;)*
        $crate::sum!($($sum)*)
    };
    // A choice between ways of computing, none of them a sum.
    (match $($choice:tt)*) => {
        match $($choice)*
    };
}

/// A sum of products as a chain of [`plus_product`](crate::Scalar::plus_product) and
/// [`minus_product`](crate::Scalar::minus_product).
///
/// It is opened by a value, a product or anything in parentheses; then come the products that are
/// added, then those that are subtracted: `x + t0 * t8 - t1 * t9`. What is added to the others
/// first is what costs no multiplication, so that each product is one fused operation.
#[doc(hidden)]
#[macro_export]
macro_rules! sum {
    ($lead:tt $(::$constant:ident)? $(.$lead_field:tt)? $(* $times:tt $(.$times_field:tt)?)?
        $(+ $add:tt $(.$add_field:tt)? * $add_by:tt $(.$add_by_field:tt)?)*
        $(- $sub:tt $(.$sub_field:tt)? * $sub_by:tt $(.$sub_by_field:tt)?)*) => {
        ($lead $(::$constant)? $(.$lead_field)? $(* $times $(.$times_field)?)?)
            $(.plus_product($add $(.$add_field)?, $add_by $(.$add_by_field)?))*
            $(.minus_product($sub $(.$sub_field)?, $sub_by $(.$sub_by_field)?))*
    };
}
