//! Involutions, complements, duals, norms, grade parts and inverses of every type.

use ga::core::ops::*;
use ga::core::{Product, Rational};

use crate::kind::Kind;
use crate::reference::Oracle;
use crate::samples::Samples;

/// The operations that every type has in every metric.
pub fn involutions<A>(oracle: &Oracle)
where
    A: Element<Number = Rational>
        + Reverse<Output: Element<Number = Rational>>
        + Involute<Output: Element<Number = Rational>>
        + Conjugate<Output: Element<Number = Rational>>
        + LeftComplement<Output: Element<Number = Rational>>
        + RightComplement<Output: Element<Number = Rational>>
        + NormSquared<Output = Rational>,
{
    let name = Kind::of::<A>().name;
    let mut samples = Samples::new(11 + A::BLADES.len() as u64);
    for _ in 0..2 {
        let a: A = samples.full();
        let value = oracle.value(&a);
        let dense = oracle.dense(&value);
        let check = |what: &str, generated, expected: ga::core::dense::Dense<Rational>| {
            let expected = expected.coefficients().to_vec();
            oracle.same(&format!("{name}.{what}"), &[&value], &generated, &expected);
        };
        check("reverse", oracle.value(&a.reverse()), dense.reverse());
        check("involute", oracle.value(&a.involute()), dense.involute());
        check("conjugate", oracle.value(&a.conjugate()), dense.conjugate());
        let right = oracle.value(&a.right_complement());
        check("right_complement", right, dense.right_complement());
        let left = oracle.value(&a.left_complement());
        check("left_complement", left, dense.left_complement());
        let norm = oracle.algebra.scalar(dense.norm_squared());
        check("norm_squared", oracle.scalar(a.norm_squared()), norm);
    }
}

/// Dual and undual, which need an invertible pseudoscalar.
pub fn duals<A>(oracle: &Oracle)
where
    A: Element<Number = Rational>
        + Dual<Output: Element<Number = Rational>>
        + Undual<Output: Element<Number = Rational>>,
{
    let a: A = Samples::new(13).full();
    let value = oracle.value(&a);
    let dense = oracle.dense(&value);
    let expected = dense.dual().expect("an invertible pseudoscalar");
    let expected = expected.coefficients().to_vec();
    oracle.same("dual", &[&value], &oracle.value(&a.dual()), &expected);
    let expected = dense.undual().coefficients().to_vec();
    oracle.same("undual", &[&value], &oracle.value(&a.undual()), &expected);
}

/// The inverse times the element is 1 on both sides, and missing exactly where the dense
/// algebra finds none.
pub fn inverses<A>(oracle: &Oracle)
where
    A: Element<Number = Rational> + Inverse<Number = Rational, Output: Element<Number = Rational>>,
{
    let name = Kind::of::<A>().name;
    let mut samples = Samples::new(17 + A::BLADES.len() as u64);
    let mut list: Vec<A> = vec![A::from_fn(|_| Rational::ZERO)];
    for count in [1, 2, 3, 4] {
        list.push(samples.sparse(count));
    }
    if oracle.dimension < 6 {
        list.push(A::from_fn(|_| samples.integer(3)));
    }
    for a in list {
        let value = oracle.value(&a);
        let generated = Inverse::inverse(a).map(|inverse| oracle.value(&inverse));
        let expected = oracle.dense(&value).inverse().ok();
        assert_eq!(
            generated.is_some(),
            expected.is_some(),
            "{name}.inverse() of {value:?}"
        );
        if let Some(inverse) = generated {
            let one = oracle.scalar(Rational::ONE);
            for (left, right) in [(&value, &inverse), (&inverse, &value)] {
                let product = oracle.product(Product::Geometric, left, right);
                oracle.same(
                    &format!("{name}.inverse"),
                    &[&value, &inverse],
                    &product,
                    &one,
                );
            }
        }
    }
}

/// Everything with one operand.
macro_rules! check_unary {
    ($oracle:ident, $module:ident, $A:ident) => {{
        type A = $module::$A<ga::core::Rational>;
        crate::unary::involutions::<A>(&$oracle);
        crate::unary::inverses::<A>(&$oracle);
        crate::arithmetic::sums::<A>(&$oracle);
        // The part of one grade is a method, not a trait.
        let a: A = crate::samples::Samples::new(19).full();
        let value = $oracle.value(&a);
        for grade in 0..=$oracle.dimension as u32 + 1 {
            let expected = $oracle.restricted(&value, 1 << grade);
            $oracle.same(
                "grade",
                &[&value],
                &$oracle.value(&a.grade(grade)),
                &expected,
            );
        }
        let array = a.to_array();
        assert_eq!(A::from(array), a);
        assert_eq!(<[ga::core::Rational; _]>::from(a), array);
    }};
}
pub(crate) use check_unary;

/// The duals of a type.
macro_rules! check_duals {
    ($oracle:ident, $module:ident, $A:ident) => {
        crate::unary::duals::<$module::$A<ga::core::Rational>>(&$oracle);
    };
}
pub(crate) use check_duals;
