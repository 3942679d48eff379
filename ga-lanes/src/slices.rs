//! Operations on slices of structs, in lanes.
//!
//! A loop over structs leaves it to the compiler whether anything becomes a vector. These functions
//! take blocks of as many structs as there are lanes, transpose them in registers, compute, and
//! transpose back, in 256 bits where the machine has them ([`Target::V3`](crate::Target::V3);
//! wider shuffles gain nothing). Nothing is allocated. Where several operations follow one another,
//! a [`Batch`](crate::Batch) is faster, which transposes once.
//!
//! Either operand is a slice, or [`One`] element that meets all of the other.
//!
//! ```
//! use ga_lanes::{One, slices};
//! # ga_macros::define_algebra! { crate = ga_core; R3 }
//! use r3::{Even, Vector};
//!
//! let quarter = Even::new(1.0_f32, -1.0, 0.0, 0.0);
//! let vectors = [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 2.0, 5.0)];
//! let mut images = [Vector::default(); 2];
//! slices::apply(One(quarter), &vectors, &mut images)?;
//! assert_eq!(images[0], Vector::new(0.0, 1.0, 0.0));
//! assert_eq!(images[1], Vector::new(-2.0, 0.0, 5.0));
//! # Ok::<(), ga_lanes::LengthMismatch>(())
//! ```
//!
//! One versor on many elements is faster by its own `apply_slice`, whose matrix takes fewer
//! multiplications. Operations that some elements have no value of are those of batches; see
//! [`Partial`](crate::Partial). On several threads, give each a part of the slices.
//!
//! Types of at most sixteen coefficients, stored one after the other as those of `define_algebra!`
//! are, are transposed in registers; others number by number.
//!
//! # Unsafe code
//! A slice is read and written as the numbers that it consists of, after every element has shown by
//! the addresses of its coefficients that it is nothing else ([`Element::place`]); the compiler
//! knows the addresses, and nothing is left of the question. Registers are loaded, shuffled and
//! stored by instructions of the target that runs.

mod elements;
mod parts;
mod plain;
#[cfg(target_arch = "x86_64")]
mod squares;
mod target;
mod task;
mod transpose;

use ga_core::{Element, LengthMismatch, Scalar};

use crate::methods::Of;
use crate::number::Number;
use crate::operand::One;
use crate::operation::{Everywhere, Map, Mapping, Values, ZipMap, Zipping, named};
pub use elements::Elements;
use target::run;
use task::{Fill, Replace};

/// That two operands have as many elements as there are places for the results.
fn check(a: Option<usize>, b: Option<usize>, places: usize) -> Result<(), LengthMismatch> {
    let pairs = [(a, b), (a, Some(places)), (b, Some(places))];
    for pair in pairs {
        if let (Some(left), Some(right)) = pair
            && left != right
        {
            return Err(LengthMismatch { left, right });
        }
    }
    Ok(())
}

/// Fills a slice with the values of an operation.
fn fill<A, B, O, F>(
    a: A,
    b: B,
    operation: &O,
    out: &mut [Of<O, A::Element, B::Element>],
) -> Result<(), LengthMismatch>
where
    F: Number,
    A: Elements<Element: Element<Number = F>>,
    B: Elements<Element: Element<Number = F>>,
    O: Everywhere<A::Element, B::Element, F>,
{
    check(a.count(), b.count(), out.len())?;
    run::<F, _>(Fill {
        a,
        b,
        operation,
        out,
    });
    Ok(())
}

/// The values of a function of one element, written once for all lanes.
///
/// ```
/// use ga_lanes::{Lanes, Map, slices};
/// # ga_macros::define_algebra! { crate = ga_core; R3 }
/// use r3::Vector;
///
/// /// Reflections in the plane e1 = e2.
/// struct Exchanged;
///
/// impl Map<Vector<f32>> for Exchanged {
///     type Output = Vector<f32>;
///
///     #[inline(always)]
///     fn call<L: Lanes<f32>>(&self, x: Vector<L>) -> Vector<L> {
///         Vector::new(x.e2, x.e1, x.e3)
///     }
/// }
///
/// let mut images = [Vector::default()];
/// slices::map(&[Vector::new(1.0_f32, 2.0, 3.0)], &Exchanged, &mut images)?;
/// assert_eq!(images, [Vector::new(2.0, 1.0, 3.0)]);
/// # Ok::<(), ga_lanes::LengthMismatch>(())
/// ```
///
/// # Errors
/// [`LengthMismatch`] where there are not as many elements as places; nothing is written then.
pub fn map<A, K>(elements: A, function: &K, out: &mut [K::Output]) -> Result<(), LengthMismatch>
where
    A: Elements,
    K: Map<A::Element>,
{
    fill::<_, _, _, <A::Element as Element>::Number>(
        One(<A::Element as Element>::Number::ZERO),
        elements,
        &Mapping(function),
        out,
    )
}

/// The values of a function of two elements at the same place, written once for all lanes.
///
/// # Errors
/// [`LengthMismatch`] where operands and places are not equally many; nothing is written then.
pub fn zip_map<A, B, K>(
    a: A,
    b: B,
    function: &K,
    out: &mut [K::Output],
) -> Result<(), LengthMismatch>
where
    A: Elements,
    B: Elements<Element: Element<Number = <A::Element as Element>::Number>>,
    K: ZipMap<A::Element, B::Element>,
{
    fill::<_, _, _, <A::Element as Element>::Number>(a, b, &Zipping(function), out)
}

macro_rules! binary {
    ($($(#[$doc:meta])* $name:ident $method:ident $in_place:ident)*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// [`LengthMismatch`] where operands and places are not equally many; nothing is written
        /// then.
        pub fn $method<A, B, F>(
            a: A,
            b: B,
            out: &mut [Of<named::$name, A::Element, B::Element>],
        ) -> Result<(), LengthMismatch>
        where
            F: Number,
            A: Elements<Element: Element<Number = F>>,
            B: Elements<Element: Element<Number = F>>,
            named::$name: Everywhere<A::Element, B::Element, F>,
        {
            fill(a, b, &named::$name, out)
        }

        $(#[$doc])*
        ///
        /// The result replaces `b`.
        ///
        /// # Errors
        /// [`LengthMismatch`] where the operands are not equally many; nothing is written then.
        pub fn $in_place<A, Y, F>(a: A, b: &mut [Y]) -> Result<(), LengthMismatch>
        where
            F: Number,
            A: Elements<Element: Element<Number = F>>,
            Y: Element<Number = F>,
            named::$name:
                Everywhere<A::Element, Y, F> + Values<A::Element, Y, Output = Y>,
        {
            check(a.count(), None, b.len())?;
            let (operation, elements) = (&named::$name, b);
            run::<F, _>(Replace { a, operation, elements });
            Ok(())
        }
    )*};
}

binary! {
    /// The geometric products `a b`; also those with numbers.
    Geometric geometric geometric_in_place
    /// The outer products `a ∧ b`.
    Wedge wedge wedge_in_place
    /// The left contractions `a ⌋ b`.
    LeftContract left_contract left_contract_in_place
    /// The right contractions `a ⌊ b`.
    RightContract right_contract right_contract_in_place
    /// The inner products `a · b` of (2.71).
    Inner inner inner_in_place
    /// The scalar products `⟨a b⟩`.
    ScalarProduct scalar_product scalar_product_in_place
    /// The regressive products `a ∨ b`.
    Regressive regressive regressive_in_place
    /// The commutator products `(ab − ba)/2`.
    Commutator commutator commutator_in_place
    /// The anticommutator products `(ab + ba)/2`.
    Anticommutator anticommutator anticommutator_in_place
    /// The quotients `a b⁻¹`; non-finite where `b` has no inverse. Also those by numbers.
    Quotient quotient quotient_in_place
    /// The sandwiches `V x̂ Ṽ` with `a` as `V`.
    Sandwich sandwich sandwich_in_place
    /// The versors applied, `V x̂ V⁻¹` (2.28).
    Apply apply apply_in_place
    /// The sums `a + b`.
    Plus plus plus_in_place
    /// The differences `a − b`.
    Minus minus minus_in_place
}
