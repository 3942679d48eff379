//! The nine products and the quotient of every ordered pair of types.

use std::marker::PhantomData;

use ga::core::ops::*;
use ga::core::{Product, Rational};

use crate::kind::{Kind, fewest_fields};
use crate::reference::Oracle;
use crate::samples::Samples;

/// Stands for a pair of types; what is not generated falls back to the trait of absence.
pub struct Pair<A, B>(PhantomData<(A, B)>);

impl<A, B> Pair<A, B> {
    pub const fn new() -> Pair<A, B> {
        Pair(PhantomData)
    }
}

macro_rules! all_products {
    ($($trait:ident $method:ident $absent:ident)*) => {
        $(
            impl<A, B, R> Pair<A, B>
            where
                A: Element<Number = Rational> + $trait<B, Output = R>,
                B: Element<Number = Rational>,
                R: Element<Number = Rational>,
            {
                /// Compares the product on random values, and its type with all types.
                pub fn $method(&self, oracle: &Oracle) {
                    let (left, right, result) = (Kind::of::<A>(), Kind::of::<B>(), Kind::of::<R>());
                    let product = Product::$trait;
                    let what = format!("{}.{}({})", left.name, stringify!($method), right.name);
                    let fields = fewest_fields(oracle, product, &left, &right);
                    assert_eq!(Some(result.stored.len()), fields, "fields of {what}");
                    let mut samples = Samples::new(left.stored.len() as u64 * 64 + right.stored.len() as u64);
                    for _ in 0..oracle.repetitions() {
                        let (a, b): (A, B) = (samples.full(), samples.full());
                        let (x, y) = (oracle.value(&a), oracle.value(&b));
                        let expected = oracle.product(product, &x, &y);
                        oracle.same(&what, &[&x, &y], &oracle.value(&a.$method(b)), &expected);
                    }
                }
            }

            /// The product is not generated; some products exist for all pairs that are tested.
            #[allow(dead_code)]
            pub trait $absent {
                fn $method(&self, oracle: &Oracle);
            }

            impl<A, B> $absent for Pair<A, B>
            where
                A: Element<Number = Rational>,
                B: Element<Number = Rational>,
            {
                fn $method(&self, oracle: &Oracle) {
                    let (left, right) = (Kind::of::<A>(), Kind::of::<B>());
                    let fields = fewest_fields(oracle, Product::$trait, &left, &right);
                    assert_eq!(fields, None, "{}.{}({})", left.name, stringify!($method), right.name);
                }
            }
        )*
    };
}

all_products! {
    Geometric geometric NoGeometric
    Wedge wedge NoWedge
    LeftContract left_contract NoLeftContract
    RightContract right_contract NoRightContract
    Inner inner NoInner
    Regressive regressive NoRegressive
    Commutator commutator NoCommutator
    Anticommutator anticommutator NoAnticommutator
}

impl<A, B> Pair<A, B>
where
    A: Element<Number = Rational> + ScalarProduct<B, Output = Rational>,
    B: Element<Number = Rational>,
{
    /// Compares the number that is the scalar product.
    pub fn scalar_product(&self, oracle: &Oracle) {
        let mut samples = Samples::new(A::BLADES.len() as u64 + 64 * B::BLADES.len() as u64);
        let what = format!("{}·{}", Kind::of::<A>().name, Kind::of::<B>().name);
        for _ in 0..oracle.repetitions() {
            let (a, b): (A, B) = (samples.full(), samples.full());
            let (x, y) = (oracle.value(&a), oracle.value(&b));
            let expected = oracle.product(Product::ScalarProduct, &x, &y);
            let generated = oracle.scalar(a.scalar_product(b));
            oracle.same(&what, &[&x, &y], &generated, &expected);
        }
    }
}

impl<A, B, I, P, R> Pair<A, B>
where
    A: Element<Number = Rational> + Quotient<B, Output: Element<Number = Rational>>,
    A: LeftContract<B, Output = P> + Wedge<B, Output = R>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    P: LeftContract<I, Output: Element<Number = Rational>>,
    R: RightContract<I, Output: Element<Number = Rational>>,
    I: Element<Number = Rational>,
{
    /// Quotient, projection and rejection against their definitions by the inverse.
    pub fn divisions(&self, oracle: &Oracle) {
        let mut samples = Samples::new(A::BLADES.len() as u64 + 99 * B::BLADES.len() as u64);
        let what = format!("{}/{}", Kind::of::<A>().name, Kind::of::<B>().name);
        let (a, b): (A, B) = (samples.sparse(6), samples.sparse(3));
        let Some(inverse) = b.inverse() else {
            return;
        };
        let (x, y, z) = (oracle.value(&a), oracle.value(&b), oracle.value(&inverse));
        let expected = oracle.product(Product::Geometric, &x, &z);
        oracle.same(&what, &[&x, &y], &oracle.value(&a.quotient(b)), &expected);
        let inside = oracle.product(Product::LeftContract, &x, &y);
        let expected = oracle.product(Product::LeftContract, &inside, &z);
        let projection = oracle.value(&ga::core::convert::project(a, b));
        oracle.same(
            &format!("project {what}"),
            &[&x, &y],
            &projection,
            &expected,
        );
        let spanned = oracle.product(Product::Wedge, &x, &y);
        let expected = oracle.product(Product::RightContract, &spanned, &z);
        let rejection = oracle.value(&ga::core::convert::reject(a, b));
        oracle.same(&format!("reject {what}"), &[&x, &y], &rejection, &expected);
        // For blades both are also geometric products with the inverse (2.29, 2.30).
        let blade: B = single(&mut samples);
        if let Some(inverse) = blade.inverse() {
            let (y, z) = (oracle.value(&blade), oracle.value(&inverse));
            let inside = oracle.product(Product::LeftContract, &x, &y);
            let expected = oracle.product(Product::Geometric, &inside, &z);
            let projection = oracle.value(&ga::core::convert::project(a, blade));
            if Kind::of::<B>().fixed.is_empty() {
                oracle.same(&format!("blade {what}"), &[&x, &y], &projection, &expected);
            }
        }
    }
}

/// A multiple of one basis blade.
fn single<B: Element<Number = Rational>>(samples: &mut Samples) -> B {
    let position = samples.below(B::BLADES.len());
    B::from_fn(|i| {
        if i == position {
            samples.integer(9)
        } else {
            Rational::ZERO
        }
    })
}
