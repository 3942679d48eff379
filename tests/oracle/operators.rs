//! The operators of every ordered pair are the methods, with values and references on either
//! side, as far as they exist.

#![expect(clippy::op_ref, reason = "references on both sides are what is tested")]

use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Shl, Sub};

use ga::core::ops::*;
use ga::core::{Product, Rational};

use crate::divisions::{divisors, invert};
use crate::kind::{Kind, free};
use crate::operation::{Numbers, Pair, Spellings, element, numbers};
use crate::products::absent;
use crate::reference::Oracle;
use crate::samples::{Form, Samples};

/// All spellings of an operation give the same numbers; the operation is checked elsewhere.
fn agree(oracle: &Oracle, what: &str, [left, right]: [&Kind; 2], b: &Numbers, spell: Spellings) {
    let a = Samples::of(left, right).numbers(left.stored.len(), Form::Integers);
    let spellings = spell(&a, b);
    *oracle.compared.borrow_mut() += spellings.len();
    for other in &spellings {
        let (left, right) = (&left.name, &right.name);
        assert_eq!(
            other, &spellings[0],
            "{left} {what} {right} on {a:?} and {b:?}"
        );
    }
}

fn products_agree(oracle: &Oracle, what: &str, [left, right]: [Kind; 2], spell: Spellings) {
    let b = Samples::of(&right, &left).numbers(right.stored.len(), Form::Integers);
    agree(oracle, what, [&left, &right], &b, spell);
}

macro_rules! all_operators {
    ($($operator:ident $symbol:tt $product:ident $method:ident $value:ident $reference:ident)*) => {
        $(
            impl<A, B, R> Pair<A, B>
            where
                A: Element<Number = Rational> + $product<B, Output = R> + $operator<B, Output = R>,
                for<'a> &'a A: $operator<B, Output = R>,
                B: Element<Number = Rational>,
                R: Element<Number = Rational>,
            {
                /// With a value on the right.
                pub fn $value(&self, oracle: &Oracle) {
                    let kinds = [Kind::of::<A>(), Kind::of::<B>()];
                    products_agree(oracle, stringify!($symbol), kinds, |a, b| {
                        let (a, b): (A, B) = (element(a), element(b));
                        let list = [a.$method(b), a $symbol b, &a $symbol b];
                        list.iter().map(numbers).collect()
                    });
                }
            }

            impl<A, B, R> Pair<A, B>
            where
                A: Element<Number = Rational> + $product<B, Output = R>,
                A: for<'b> $product<&'b B, Output = R> + for<'b> $operator<&'b B, Output = R>,
                for<'a, 'b> &'a A: $operator<&'b B, Output = R>,
                B: Element<Number = Rational>,
                R: Element<Number = Rational>,
            {
                /// With a reference on the right.
                pub fn $reference(&self, oracle: &Oracle) {
                    let kinds = [Kind::of::<A>(), Kind::of::<B>()];
                    products_agree(oracle, stringify!($symbol), kinds, |a, b| {
                        let (a, b): (A, B) = (element(a), element(b));
                        let list = [a.$method(b), a.$method(&b), a $symbol &b, &a $symbol &b];
                        list.iter().map(numbers).collect()
                    });
                }
            }
        )*

        /// Where there is no operator, there is no product.
        #[expect(dead_code, reason = "some operators exist for every pair")]
        pub trait NoOperator {
            $(
                fn $value(&self, oracle: &Oracle);
                fn $reference(&self, oracle: &Oracle);
            )*
        }

        impl<A: Element<Number = Rational>, B: Element<Number = Rational>> NoOperator for Pair<A, B> {
            $(
                fn $value(&self, oracle: &Oracle) {
                    absent(oracle, Product::$product, [Kind::of::<A>(), Kind::of::<B>()]);
                }

                fn $reference(&self, oracle: &Oracle) {
                    absent(oracle, Product::$product, [Kind::of::<A>(), Kind::of::<B>()]);
                }
            )*
        }
    };
}

all_operators! {
    Mul * Geometric geometric times times_reference
    BitXor ^ Wedge wedge outer outer_reference
    BitOr | Inner inner dot dot_reference
    BitAnd & Regressive regressive meet meet_reference
    Shl << LeftContract left_contract contract contract_reference
}

impl<A, B, I, R> Pair<A, B>
where
    A: Element<Number = Rational> + Quotient<B, Output = R> + Div<B, Output = R>,
    for<'a> &'a A: Div<B, Output = R>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    I: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// `/` with a value on the right.
    pub fn over(&self, oracle: &Oracle) {
        let (left, right) = (Kind::of::<A>(), Kind::of::<B>());
        for divisor in divisors(oracle, &right, &Kind::of::<I>(), invert::<B>)
            .iter()
            .take(1)
        {
            agree(oracle, "/", [&left, &right], &divisor.numbers, |a, b| {
                let (a, b): (A, B) = (element(a), element(b));
                [a.quotient(b), a / b, &a / b].iter().map(numbers).collect()
            });
        }
    }
}

impl<A, B, I, R> Pair<A, B>
where
    A: Element<Number = Rational> + Quotient<B, Output = R>,
    A: for<'b> Quotient<&'b B, Output = R> + for<'b> Div<&'b B, Output = R>,
    for<'a, 'b> &'a A: Div<&'b B, Output = R>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    I: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// `/` with a reference on the right.
    pub fn over_reference(&self, oracle: &Oracle) {
        let (left, right) = (Kind::of::<A>(), Kind::of::<B>());
        for divisor in divisors(oracle, &right, &Kind::of::<I>(), invert::<B>)
            .iter()
            .take(1)
        {
            agree(oracle, "/", [&left, &right], &divisor.numbers, |a, b| {
                let (a, b): (A, B) = (element(a), element(b));
                let list = [a.quotient(b), a.quotient(&b), a / &b, &a / &b];
                list.iter().map(numbers).collect()
            });
        }
    }
}

/// Where there is no `/`, there is no quotient.
pub trait NoQuotient {
    fn over(&self, oracle: &Oracle);
    fn over_reference(&self, oracle: &Oracle);
}

impl<A: Element<Number = Rational>, B: Element<Number = Rational>> NoQuotient for Pair<A, B> {
    fn over(&self, oracle: &Oracle) {
        crate::divisions::NoDivision::quotient(self, oracle);
    }

    fn over_reference(&self, oracle: &Oracle) {
        crate::divisions::NoDivision::quotient(self, oracle);
    }
}

impl<A, B, R> Pair<A, B>
where
    A: Element<Number = Rational> + Add<B, Output = R> + Sub<B, Output = R>,
    B: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// Sum and difference against those of all coefficients, in the smallest type of both.
    pub fn sums(&self, oracle: &Oracle) {
        let spell: Spellings = |a, b| {
            let (a, b): (A, B) = (element(a), element(b));
            [a + b, a - b].iter().map(numbers).collect()
        };
        let kinds = [Kind::of::<A>(), Kind::of::<B>(), Kind::of::<R>()];
        compare_sums(oracle, kinds, spell);
    }
}

fn compare_sums(oracle: &Oracle, [left, right, result]: [Kind; 3], compute: Spellings) {
    let what = format!("{} ± {}", left.name, right.name);
    let blades = &left.blades() | &right.blades();
    let fields = free(oracle, &blades).map(|kind| kind.stored.len());
    assert_eq!(Some(result.stored.len()), fields, "fields of {what}");
    assert!(result.fixed.is_empty(), "{what} fixes coefficients");
    let mut samples = Samples::of(&left, &right);
    for form in [Form::Fractions, Form::Sparse(2)] {
        let a = samples.numbers(left.stored.len(), form);
        let b = samples.numbers(right.stored.len(), form);
        let (x, y) = (oracle.value_of(&left, &a), oracle.value_of(&right, &b));
        for (generated, sign) in compute(&a, &b).iter().zip([Rational::ONE, -Rational::ONE]) {
            let expected = x.iter().zip(&y).map(|(x, y)| *x + *y * sign).collect();
            oracle.same(
                &what,
                &[&x, &y],
                &oracle.value_of(&result, generated),
                &expected,
            );
        }
    }
}

/// Sums that are not generated have no type.
pub trait NoSum {
    fn sums(&self, oracle: &Oracle);
}

impl<A: Element<Number = Rational>, B: Element<Number = Rational>> NoSum for Pair<A, B> {
    fn sums(&self, oracle: &Oracle) {
        let (left, right) = (Kind::of::<A>(), Kind::of::<B>());
        let holding = free(oracle, &(&left.blades() | &right.blades()));
        assert_eq!(holding, None, "{} + {}", left.name, right.name);
    }
}

/// The operators of a pair with a value on the right.
macro_rules! check_operators {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {
        crate::operators::each_operator!($oracle, $module, $A, $B:
            times outer dot meet contract over)
    };
}

/// The operators of a pair with a reference on the right.
macro_rules! check_references {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {
        crate::operators::each_operator!($oracle, $module, $A, $B:
            times_reference outer_reference dot_reference meet_reference contract_reference
            over_reference)
    };
}

/// These operators of a pair, or that they are missing.
macro_rules! each_operator {
    ($oracle:ident, $module:ident, $A:ident, $B:ident: $($operator:ident)*) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without some operator")]
        use crate::operators::{NoOperator, NoQuotient};
        let pair = crate::operation::Pair::<$module::$A<Q>, $module::$B<Q>>::new();
        $(pair.$operator($oracle);)*
    }};
}

/// The sum and the difference of a pair.
macro_rules! check_sums {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without a sum")]
        use crate::operators::NoSum;
        crate::operation::Pair::<$module::$A<Q>, $module::$B<Q>>::new().sums($oracle);
    }};
}
pub(crate) use {check_operators, check_references, check_sums, each_operator};
