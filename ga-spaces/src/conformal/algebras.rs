//! The algebras for one to five dimensions, all declared alike.

use ga_core::Field;

use super::ConformalSpace;

/// The conformal model of Euclidean space of dimension `N`, 1 to 5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Conformal<const N: usize>;

/// Declares the algebra of one dimension and says what its types are for.
macro_rules! conformal {
    ($dimension:literal $module:ident $signature:ident { $($axis:ident)* }) => {
        #[doc = concat!("The conformal model of Euclidean space of dimension ", $dimension, ".")]
        pub mod $module {
            ga_macros::define_algebra! {
                mod algebra: $signature {
                    basis { $($axis,)* no, ni }
                    metric { $($axis^2 = 1,)* no.ni = -1 }
                    types {
                        /// A Euclidean vector.
                        Vector { $($axis),* }
                        /// A point of weight 1, n_o + **x** + ½**x**² n_∞.
                        #[null]
                        Point { no = 1, $($axis,)* ni }
                        /// A sphere by its dual vector, of one dimension less than the space; a
                        /// plane where its weight is zero, a point where its radius is.
                        Sphere { no, $($axis,)* ni }
                        /// A translation 1 − ½**v** n_∞, of unit norm.
                        #[unit]
                        Translator { 1 = 1, $($axis^ni),* }
                    }
                    products { geometric, wedge, scalar_product, sandwich }
                }
            }

            pub use algebra::*;
        }

        impl<T: Field> ConformalSpace<T> for Conformal<$dimension> {
            const DIMENSION: usize = $dimension;
            type Vector = $module::Vector<T>;
            type Point = $module::Point<T>;
            type Sphere = $module::Sphere<T>;
            type Translator = $module::Translator<T>;
            type Versor = $module::Even<T>;
        }
    };
}

conformal! { 1 dimension1 R2_1 { e1 } }
conformal! { 2 dimension2 R3_1 { e1 e2 } }
conformal! { 3 dimension3 R4_1 { e1 e2 e3 } }
conformal! { 4 dimension4 R5_1 { e1 e2 e3 e4 } }
conformal! { 5 dimension5 R6_1 { e1 e2 e3 e4 e5 } }
