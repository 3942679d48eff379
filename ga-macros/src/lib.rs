//! `define_algebra!`: a metric in, structs with unrolled products out.
//!
//! A shell around the library `ga_codegen`, which holds the parser, the mathematics and the
//! emitter. Most programs use the macro through the facade `ga`; used directly it expects
//! `ga-core` among the dependencies, under that name or one given by `crate = path;`.

use proc_macro::TokenStream;

/// Declares a geometric algebra as a module of structs.
///
/// A bare signature is a preset: `R4_1` has four basis vectors of square +1 and one of −1,
/// `R3_0_1` three of +1 and one of 0. The module is named like the signature in lower case; its
/// types are `Scalar`, `Vector`, `Bivector`, … one per grade, and `Even`, `Odd`, `Multivector`.
///
/// ```
/// ga_macros::define_algebra!(R2);
/// use r2::{Bivector, Vector};
///
/// let area: Bivector = Vector::new(2.0, 0.0) ^ Vector::new(0.0, 3.0);
/// assert_eq!(area.e12, 6.0);
/// ```
///
/// An algebra of one's own names its module, and any of basis, metric, types and products:
///
/// ```
/// ga_macros::define_algebra! {
///     crate = ::ga_core;                      // where ga-core is; this is the default
///
///     /// Spacetime, with time first.
///     pub mod spacetime: R1_3 {
///         basis    { t, x, y, z }
///         metric   { t^2 = 1, x^2 = -1, y^2 = -1, z^2 = -1 }
///         types {
///             /// An event of spacetime.
///             Event { t, x, y, z }
///             /// An electromagnetic field; `z^y` is stored as spelled, as minus `y^z`.
///             Field2 { x^t, y^t, z^t, z^y, x^z, y^x }
///             /// A boost or rotation; `V Ṽ = 1` is promised and `apply` relies on it.
///             #[unit]
///             Lorentz = even;
///         }
///         products { geometric, wedge, inner, apply }
///     }
/// }
///
/// let event = spacetime::Event::new(3.0, 1.0, 2.0, 2.0);
/// assert_eq!(event.norm_squared(), 0.0);
/// ```
///
/// What is left out is filled in: without `basis` the vectors are `e1`, `e2`, …; without
/// `metric` they are orthonormal, positive squares first, then negative, then zero; metric
/// entries not written are 0; `no.ni = -1` sets the product of two different vectors; without
/// `types` there is one per grade; without `products` all are generated. A coefficient fixed at
/// compile time, `Point { no = 1, e1, e2, e3, ni }`, is no field; operations keep it where they
/// provably do and widen where not. `Scalar`, `Even`, `Odd` and `Multivector` are always there
/// (up to eight dimensions); sparse types go to twelve dimensions.
///
/// Versors apply by `V x̂ V⁻¹`. A versor that is known to be unit spares the division and more:
/// `Unit` of ga-core holds one of any type, for one versor on many elements and hot loops; `#[unit]`
/// promises it of all values of a type. `#[null]` promises that the values of a type square to 0:
/// narrowing checks it, and applications have less to compute. One versor on very many elements is
/// its matrix.
///
/// ```
/// use ga_core::Unit;
///
/// ga_macros::define_algebra! {
///     pub mod conformal: R3_1 {
///         basis  { e1, e2, no, ni }
///         metric { e1^2 = 1, e2^2 = 1, no.ni = -1 }
///         types {
///             #[null]
///             Point { no = 1, e1, e2, ni }
///             Circle { no, e1, e2, ni }
///             Motor { 1, e12, e1^ni, e2^ni }
///         }
///     }
/// }
/// use conformal::{Circle, Motor, Point};
///
/// let motor = Unit::new(Motor::new(2.0, 0.0, -1.0, 0.0)).unwrap();
/// let image: Point = motor.apply(Point::new(2.0, 1.0, 2.5));
/// assert_eq!(image, Point::new(3.0, 1.0, 5.0));
/// assert_eq!((motor * motor).linear_map::<Point>().apply(image), Point::new(5.0, 1.0, 13.0));
///
/// assert!(Point::try_from(Circle::new(1.0, 3.0, 1.0, 5.0)).is_ok());
/// assert!(Point::try_from(Circle::new(1.0, 3.0, 1.0, 4.5)).is_err());
/// ```
///
/// Mistakes are reported all at once, each on the token that is wrong; the structs are still
/// emitted, so that completion keeps working.
#[proc_macro]
pub fn define_algebra(input: TokenStream) -> TokenStream {
    ga_codegen::expand_tokens(input.into()).into()
}

/// The expansion of [`define_algebra!`] with the same body, as formatted Rust in a
/// `&'static str`, so that a crate can hold a snapshot of its own algebra.
///
/// ```
/// let source: &'static str = ga_macros::algebra_source!(R2);
/// assert!(source.contains("fn wedge(self, b: Vector<T>) -> Bivector<T>"));
/// ```
#[proc_macro]
pub fn algebra_source(input: TokenStream) -> TokenStream {
    ga_codegen::source_tokens(input.into()).into()
}
