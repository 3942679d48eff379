//! Quotient, projection and rejection of every ordered pair, by inverses that are proven to be
//! such.

use std::collections::BTreeSet;
use std::rc::Rc;

use ga::core::ops::*;
use ga::core::{Product, Rational, convert};

use crate::kind::{Kind, free};
use crate::operation::{Binary, Numbers, Pair, element, numbers};
use crate::polynomial::{has_norm, product_kind};
use crate::reference::{Oracle, Value};
use crate::samples::{Form, Samples};

/// An invertible element with its inverse.
pub struct Divisor {
    pub numbers: Numbers,
    inverse: Value,
    form: Form,
}

/// The generated inverse of a type.
type Invert = fn(&[Rational]) -> Option<Numbers>;

/// The generated inverse as a function of numbers.
pub fn invert<B>(b: &[Rational]) -> Option<Numbers>
where
    B: Element<Number = Rational> + Inverse<Number = Rational, Output: Element<Number = Rational>>,
{
    Inverse::inverse(element::<B>(b)).map(|inverse| numbers(&inverse))
}

/// Invertible elements of a type; none only where X X̃ never has a scalar part.
pub fn divisors(oracle: &Oracle, kind: &Kind, inverse: &Kind, invert: Invert) -> Rc<[Divisor]> {
    if let Some(known) = oracle.divisors.borrow().get(&kind.name) {
        return Rc::clone(known);
    }
    let length = kind.stored.len();
    // The general inverse of an element with all coefficients of a large algebra has numbers
    // that are too long to be exact.
    let forms: &[Form] = match oracle.dimension < 6 || length <= 6 {
        true => &[Form::Blade, Form::Sparse(3), Form::Integers],
        false => &[Form::Blade, Form::Sparse(3)],
    };
    let mut samples = Samples::new(length as u64 + 99);
    let mut found = Vec::new();
    for form in forms {
        let candidates = std::iter::repeat_with(|| samples.numbers(length, *form)).take(12);
        let mut invertible = candidates.filter_map(|b| invert(&b).map(|inverse| (b, inverse)));
        let Some((numbers, opposite)) = invertible.next() else {
            continue;
        };
        let value = oracle.value_of(kind, &numbers);
        let opposite = oracle.value_of(inverse, &opposite);
        for (left, right) in [(&value, &opposite), (&opposite, &value)] {
            let one = oracle.product(Product::Geometric, left, right);
            let what = format!("{}.inverse()", kind.name);
            oracle.same(&what, &[left, right], &one, &oracle.scalar(Rational::ONE));
        }
        found.push(Divisor {
            numbers,
            inverse: opposite,
            form: *form,
        });
    }
    assert!(
        !found.is_empty() || !has_norm(oracle, kind),
        "{} has no inverse",
        kind.name
    );
    let found: Rc<[Divisor]> = found.into();
    let mut divisors = oracle.divisors.borrow_mut();
    divisors.insert(kind.name.clone(), Rc::clone(&found));
    found
}

/// What is computed with an inverse.
#[derive(Clone, Copy, Debug)]
pub enum Division {
    /// a b⁻¹.
    Quotient,
    /// (a ⌋ b) ⌋ b⁻¹ (2.29).
    Project,
    /// (a ∧ b) ⌊ b⁻¹ (2.30).
    Reject,
}

impl Division {
    /// The product of both operands, if one comes first, and the product with the inverse.
    fn products(self) -> (Option<Product>, Product) {
        match self {
            Division::Quotient => (None, Product::Geometric),
            Division::Project => (Some(Product::LeftContract), Product::LeftContract),
            Division::Reject => (Some(Product::Wedge), Product::RightContract),
        }
    }

    /// The type of the result; `None` where a product on the way has none.
    fn kind(self, oracle: &Oracle, a: &Kind, b: &Kind, inverse: &Kind) -> Option<Kind> {
        let (first, second) = self.products();
        let dividend = match first {
            Some(product) => product_kind(oracle, product, a, b)?,
            None => a,
        };
        product_kind(oracle, second, dividend, inverse).cloned()
    }
}

/// Compares a division on samples, with the right operand, its inverse and the result's type.
fn compare(
    oracle: &Oracle,
    division: Division,
    [left, right, inverse, result]: [Kind; 4],
    invert: Invert,
    compute: Binary,
) {
    let what = format!("{division:?} {} by {}", left.name, right.name);
    let expected = division.kind(oracle, &left, &right, &inverse);
    let fields = expected.map(|kind| kind.stored.len());
    assert_eq!(Some(result.stored.len()), fields, "fields of {what}");
    let (first, second) = division.products();
    let mut samples = Samples::of(&left, &right);
    for divisor in divisors(oracle, &right, &inverse, invert).iter() {
        let form = match divisor.form {
            Form::Integers => Form::Integers,
            _ => Form::Sparse(6),
        };
        let a = samples.numbers(left.stored.len(), form);
        let (x, z) = (oracle.value_of(&left, &a), &divisor.inverse);
        let y = oracle.value_of(&right, &divisor.numbers);
        let dividend = match first {
            Some(product) => oracle.product(product, &x, &y),
            None => x.clone(),
        };
        let expected = oracle.product(second, &dividend, z);
        let generated = oracle.value_of(&result, &compute(&a, &divisor.numbers));
        oracle.same(&what, &[&x, &y], &generated, &expected);
        if divisor.form == Form::Blade && right.fixed.is_empty() {
            // For blades all three are geometric products with the inverse (2.29, 2.30).
            let expected = oracle.product(Product::Geometric, &dividend, z);
            oracle.same(&what, &[&x, &y], &generated, &expected);
        }
    }
}

/// A division that is not generated cannot exist: no type holds the inverses, or none holds a
/// product on the way.
fn absent(oracle: &Oracle, division: Division, [left, right]: [Kind; 2]) {
    let mut samples = Samples::new(right.stored.len() as u64 + 99);
    let mut blades = BTreeSet::new();
    for form in [Form::Blade, Form::Sparse(3), Form::Integers] {
        let numbers = samples.numbers(right.stored.len(), form);
        let value = oracle.value_of(&right, &numbers);
        if let Some(inverse) = oracle.inverse(&value) {
            let present = (0..).zip(inverse).filter(|(_, v)| *v != Rational::ZERO);
            blades.extend(present.map(|(mask, _)| mask));
        }
    }
    // Without any inverse there is nothing to divide by.
    let inverse = free(oracle, &blades).filter(|_| !blades.is_empty());
    let result = inverse.and_then(|inverse| division.kind(oracle, &left, &right, inverse));
    assert_eq!(result, None, "{division:?} {} by {}", left.name, right.name);
}

impl<A, B, I, R> Pair<A, B>
where
    A: Element<Number = Rational> + Quotient<B, Output = R>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    I: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    pub fn quotient(&self, oracle: &Oracle) {
        let kinds = [
            Kind::of::<A>(),
            Kind::of::<B>(),
            Kind::of::<I>(),
            Kind::of::<R>(),
        ];
        compare(oracle, Division::Quotient, kinds, invert::<B>, |a, b| {
            numbers(&element::<A>(a).quotient(element::<B>(b)))
        });
    }
}

impl<A, B, I, P, R> Pair<A, B>
where
    A: Element<Number = Rational> + LeftContract<B, Output = P>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    I: Element<Number = Rational>,
    P: LeftContract<I, Output = R>,
    R: Element<Number = Rational>,
{
    pub fn project(&self, oracle: &Oracle) {
        let kinds = [
            Kind::of::<A>(),
            Kind::of::<B>(),
            Kind::of::<I>(),
            Kind::of::<R>(),
        ];
        compare(oracle, Division::Project, kinds, invert::<B>, |a, b| {
            numbers(&convert::project(element::<A>(a), element::<B>(b)))
        });
    }
}

impl<A, B, I, P, R> Pair<A, B>
where
    A: Element<Number = Rational> + Wedge<B, Output = P>,
    B: Element<Number = Rational> + Inverse<Number = Rational, Output = I>,
    I: Element<Number = Rational>,
    P: RightContract<I, Output = R>,
    R: Element<Number = Rational>,
{
    pub fn reject(&self, oracle: &Oracle) {
        let kinds = [
            Kind::of::<A>(),
            Kind::of::<B>(),
            Kind::of::<I>(),
            Kind::of::<R>(),
        ];
        compare(oracle, Division::Reject, kinds, invert::<B>, |a, b| {
            numbers(&convert::reject(element::<A>(a), element::<B>(b)))
        });
    }
}

/// What is not generated cannot exist.
pub trait NoDivision {
    fn quotient(&self, oracle: &Oracle);
    fn project(&self, oracle: &Oracle);
    fn reject(&self, oracle: &Oracle);
}

impl<A: Element<Number = Rational>, B: Element<Number = Rational>> NoDivision for Pair<A, B> {
    fn quotient(&self, oracle: &Oracle) {
        absent(
            oracle,
            Division::Quotient,
            [Kind::of::<A>(), Kind::of::<B>()],
        );
    }

    fn project(&self, oracle: &Oracle) {
        absent(
            oracle,
            Division::Project,
            [Kind::of::<A>(), Kind::of::<B>()],
        );
    }

    fn reject(&self, oracle: &Oracle) {
        absent(oracle, Division::Reject, [Kind::of::<A>(), Kind::of::<B>()]);
    }
}

/// Quotient, projection and rejection of a pair.
macro_rules! check_divisions {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without some division")]
        use crate::divisions::NoDivision;
        let pair = crate::operation::Pair::<$module::$A<Q>, $module::$B<Q>>::new();
        pair.quotient($oracle);
        pair.project($oracle);
        pair.reject($oracle);
    }};
}
pub(crate) use check_divisions;
