//! Sums and multiples of one type, on values and on references.

#![expect(clippy::op_ref, reason = "references on both sides are what is tested")]

use std::iter::Sum;
use std::ops::{Add, Div, Mul, Neg, Sub};

use ga::core::Rational;
use ga::core::ops::*;

use crate::reference::{Oracle, Value};
use crate::samples::Samples;

/// Sums, differences and multiples against those of the coefficients, fixed ones included.
pub fn sums<A>(oracle: &Oracle)
where
    A: Element<Number = Rational>
        + Add<Output: Element<Number = Rational> + Sum<A>>
        + for<'a> Add<&'a A, Output = <A as Add>::Output>
        + Sub<Output = <A as Add>::Output>
        + Neg<Output = <A as Add>::Output>
        + Mul<Rational, Output = <A as Add>::Output>
        + Div<Rational, Output = <A as Add>::Output>,
    for<'a> &'a A: Add<&'a A, Output = <A as Add>::Output>
        + Add<A, Output = <A as Add>::Output>
        + Sub<&'a A, Output = <A as Add>::Output>
        + Neg<Output = <A as Add>::Output>
        + Mul<Rational, Output = <A as Add>::Output>,
{
    let mut samples = Samples::new(23);
    let (a, b): (A, A) = (samples.full(), samples.full());
    let (x, y) = (oracle.value(&a), oracle.value(&b));
    let number = Rational::new(-7, 3);
    let join = |f: &dyn Fn(Rational, Rational) -> Rational| -> Value {
        x.iter().zip(&y).map(|(x, y)| f(*x, *y)).collect()
    };
    let sum = join(&|x, y| x + y);
    for generated in [a + b, &a + &b, a + &b, &a + b, [a, b].into_iter().sum()] {
        oracle.same("sum", &[&x, &y], &oracle.value(&generated), &sum);
    }
    for generated in [a - b, &a - &b] {
        oracle.same(
            "difference",
            &[&x, &y],
            &oracle.value(&generated),
            &join(&|x, y| x - y),
        );
    }
    for generated in [-a, -&a] {
        oracle.same(
            "negative",
            &[&x],
            &oracle.value(&generated),
            &join(&|x, _| -x),
        );
    }
    for generated in [a * number, &a * number] {
        oracle.same(
            "multiple",
            &[&x],
            &oracle.value(&generated),
            &join(&|x, _| x * number),
        );
    }
    oracle.same(
        "part",
        &[&x],
        &oracle.value(&(a / number)),
        &join(&|x, _| x / number),
    );
}

/// A number on the left, which the orphan rule wants type by type.
pub fn numbers_on_the_left<A, B>()
where
    A: Element<Number = f32> + Mul<f32, Output: PartialEq>,
    B: Element<Number = f64> + Mul<f64, Output: PartialEq>,
    f32: Mul<A, Output = <A as Mul<f32>>::Output>,
    f64: Mul<B, Output = <B as Mul<f64>>::Output>,
    for<'a> f64: Mul<&'a B, Output = <B as Mul<f64>>::Output>,
{
    let a = A::from_fn(|position| 0.5 + position as f32);
    let b = B::from_fn(|position| 0.5 + position as f64);
    let (single, double) = (a * 1.5, b * 1.5);
    assert!(1.5 * a == single);
    assert!(1.5 * b == double && 1.5 * &b == double);
}

/// Division, the dual and numbers on the left, on types of the Euclidean space.
#[test]
fn remaining_operators() {
    use crate::presets::r3::{Bivector, Vector};
    let (a, b) = (Vector::new(1.0, 2.0, 3.0), Vector::new(4.0, 5.0, 6.0));
    assert_eq!(a / b, a.quotient(b));
    assert_eq!(&a / b, a.geometric(b.inverse().expect("not null")));
    assert_eq!(!a, a.dual());
    assert_eq!(2.0 * a, Vector::new(2.0, 4.0, 6.0));
    assert_eq!(2.0 * &a, a + a);
    assert_eq!(
        0.5_f32 * Bivector::new(2.0_f32, 4.0, 6.0),
        Bivector::new(1.0, 2.0, 3.0)
    );
    let mut sum = a;
    sum += b;
    sum -= a;
    sum *= 2.0;
    sum /= 4.0;
    assert_eq!(sum, 0.5 * b);
    assert_eq!([a, b].iter().sum::<Vector>(), a + b);
    // Division by a null element is that of floats.
    assert!(!(a / Vector::new(0.0, 0.0, 0.0)).s.is_finite());
    assert_eq!(Vector::new(0.0, 0.0, 0.0).inverse(), None);
    assert_eq!(Vector::new(0.0, 0.0, 0.0).normalized(), None);
    assert_eq!(
        Vector::new(0.0, 0.0, -2.0).normalized(),
        Some(Vector::new(0.0, 0.0, -1.0))
    );
}
