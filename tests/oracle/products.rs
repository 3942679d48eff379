//! The nine products of every ordered pair of types.

use ga::core::ops::*;
use ga::core::{Product, Rational};

use crate::kind::Kind;
use crate::operation::{Binary, Pair, element, numbers};
use crate::polynomial::product_kind;
use crate::reference::Oracle;
use crate::samples::Samples;

/// Compares a product on samples, and its type with all types.
fn compare(oracle: &Oracle, product: Product, [left, right, result]: [Kind; 3], compute: Binary) {
    let what = format!("{}.{}({})", left.name, product.method(), right.name);
    let expected = product_kind(oracle, product, &left, &right);
    let fields = expected.map(|kind| kind.stored.len());
    assert_eq!(Some(result.stored.len()), fields, "fields of {what}");
    on_samples(oracle, product, [left, right, result], compute);
}

/// Compares the values of a product.
fn on_samples(
    oracle: &Oracle,
    product: Product,
    [left, right, result]: [Kind; 3],
    compute: Binary,
) {
    let what = format!("{}.{}({})", left.name, product.method(), right.name);
    let mut samples = Samples::of(&left, &right);
    for form in oracle.forms() {
        let a = samples.numbers(left.stored.len(), form);
        let b = samples.numbers(right.stored.len(), form);
        let (x, y) = (oracle.value_of(&left, &a), oracle.value_of(&right, &b));
        let expected = oracle.product(product, &x, &y);
        let generated = oracle.value_of(&result, &compute(&a, &b));
        oracle.same(&what, &[&x, &y], &generated, &expected);
    }
}

/// No declared type may hold a product that is not generated.
pub fn absent(oracle: &Oracle, product: Product, [left, right]: [Kind; 2]) {
    let what = format!("{}.{}({})", left.name, product.method(), right.name);
    assert_eq!(product_kind(oracle, product, &left, &right), None, "{what}");
}

macro_rules! all_products {
    ($($trait:ident $method:ident)*) => {
        $(
            impl<A, B, R> Pair<A, B>
            where
                A: Element<Number = Rational> + $trait<B, Output = R>,
                B: Element<Number = Rational>,
                R: Element<Number = Rational>,
            {
                pub fn $method(&self, oracle: &Oracle) {
                    let kinds = [Kind::of::<A>(), Kind::of::<B>(), Kind::of::<R>()];
                    compare(oracle, Product::$trait, kinds, |a, b| {
                        numbers(&element::<A>(a).$method(element::<B>(b)))
                    });
                }
            }
        )*

        /// What is not generated must have no type.
        #[expect(dead_code, reason = "some products exist for every pair")]
        pub trait NoProduct {
            $(fn $method(&self, oracle: &Oracle);)*
        }

        impl<A, B> NoProduct for Pair<A, B>
        where
            A: Element<Number = Rational>,
            B: Element<Number = Rational>,
        {
            $(
                fn $method(&self, oracle: &Oracle) {
                    absent(oracle, Product::$trait, [Kind::of::<A>(), Kind::of::<B>()]);
                }
            )*
        }
    };
}

all_products! {
    Geometric geometric
    Wedge wedge
    LeftContract left_contract
    RightContract right_contract
    Inner inner
    Regressive regressive
    Commutator commutator
    Anticommutator anticommutator
}

impl<A, B> Pair<A, B>
where
    A: Element<Number = Rational> + ScalarProduct<B, Output = Rational>,
    B: Element<Number = Rational>,
{
    /// Compares the number that is the scalar product; it exists for every pair.
    pub fn scalar_product(&self, oracle: &Oracle) {
        let number = Kind {
            name: "number".to_owned(),
            stored: vec![0],
            signs: vec![Rational::ONE],
            fixed: Vec::new(),
            null: Vec::new(),
        };
        let kinds = [Kind::of::<A>(), Kind::of::<B>(), number];
        on_samples(oracle, Product::ScalarProduct, kinds, |a, b| {
            vec![element::<A>(a).scalar_product(element::<B>(b))]
        });
    }
}

/// All products of a pair.
macro_rules! check_products {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without some product")]
        use crate::products::NoProduct;
        let pair = crate::operation::Pair::<$module::$A<Q>, $module::$B<Q>>::new();
        pair.geometric($oracle);
        pair.wedge($oracle);
        pair.left_contract($oracle);
        pair.right_contract($oracle);
        pair.inner($oracle);
        pair.regressive($oracle);
        pair.commutator($oracle);
        pair.anticommutator($oracle);
        pair.scalar_product($oracle);
    }};
}
pub(crate) use check_products;
