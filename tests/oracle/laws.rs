//! The laws of the algebra on generated multivectors, exactly.

use ga::core::Rational;
use ga::core::ops::*;
use std::ops::{Add, Sub};

use crate::kind::Kind;
use crate::operation::element;
use crate::reference::Oracle;
use crate::samples::Samples;

/// The part of one grade.
fn part<M: Element>(m: M, grade: u32) -> M {
    ga::core::convert::grade(m, grade)
}

/// Laws of products and involutions in every metric; `M` holds the whole algebra.
pub fn products<M>(_: &Oracle)
where
    M: Element<Number = Rational>
        + std::fmt::Debug
        + Add<Output = M>
        + Sub<Output = M>
        + Geometric<Output = M>
        + Wedge<Output = M>
        + LeftContract<Output = M>
        + RightContract<Output = M>
        + ScalarProduct<Output = Rational>
        + Regressive<Output = M>
        + Commutator<Output = M>
        + Anticommutator<Output = M>
        + Reverse<Output = M>
        + Involute<Output = M>
        + Conjugate<Output = M>
        + LeftComplement<Output = M>
        + RightComplement<Output = M>,
{
    for seed in 0..3 {
        let mut samples = Samples::new(seed + 43);
        let (a, b, c): (M, M, M) = (samples.sparse(6), samples.sparse(6), samples.sparse(6));
        assert_eq!(a.geometric(b).geometric(c), a.geometric(b.geometric(c)));
        assert_eq!(a.wedge(b).wedge(c), a.wedge(b.wedge(c)));
        assert_eq!(a.regressive(b).regressive(c), a.regressive(b.regressive(c)));
        assert_eq!(a.geometric(b + c), a.geometric(b) + a.geometric(c));
        assert_eq!((a + b).geometric(c), a.geometric(c) + b.geometric(c));
        assert_eq!(a.wedge(b - c), a.wedge(b) - a.wedge(c));
        assert_eq!(a.commutator(b) + a.anticommutator(b), a.geometric(b));
        // Contraction is adjoint to the outer product.
        assert_eq!(
            a.wedge(b).left_contract(c),
            a.left_contract(b.left_contract(c))
        );
        assert_eq!(
            c.right_contract(b.wedge(a)),
            c.right_contract(b).right_contract(a)
        );
        let sides = (
            a.wedge(b).scalar_product(c),
            a.scalar_product(b.left_contract(c)),
        );
        assert_eq!(sides.0, sides.1);
        assert_eq!(a.scalar_product(b), b.scalar_product(a));
        // Reverse and conjugate turn products around, the grade involution keeps them.
        assert_eq!(a.geometric(b).reverse(), b.reverse().geometric(a.reverse()));
        assert_eq!(
            a.geometric(b).conjugate(),
            b.conjugate().geometric(a.conjugate())
        );
        assert_eq!(
            a.geometric(b).involute(),
            a.involute().geometric(b.involute())
        );
        assert_eq!(a.reverse().involute(), a.conjugate());
        assert_eq!(a.left_complement().right_complement(), a);
        assert_eq!(a.right_complement().left_complement(), a);
        let joined = a
            .right_complement()
            .wedge(b.right_complement())
            .left_complement();
        assert_eq!(joined, a.regressive(b));
    }
}

/// Dual and undual are inverse, and turn outer products into contractions.
pub fn duals<M>(_: &Oracle)
where
    M: Element<Number = Rational>
        + std::fmt::Debug
        + Wedge<Output = M>
        + LeftContract<Output = M>
        + Dual<Output = M>
        + Undual<Output = M>,
{
    let mut samples = Samples::new(47);
    let (a, b): (M, M) = (samples.sparse(8), samples.sparse(8));
    assert_eq!(a.dual().undual(), a);
    assert_eq!(a.undual().dual(), a);
    assert_eq!(a.wedge(b).dual(), a.left_contract(b.dual()));
    assert_eq!(a.left_contract(b).dual(), a.wedge(b.dual()));
}

/// A versor keeps grade, scalar products and outer products; `V` has one parity.
pub fn versors<V, M>(oracle: &Oracle)
where
    V: Element<Number = Rational> + Apply<M, Output = M>,
    M: Element<Number = Rational>
        + std::fmt::Debug
        + Wedge<Output = M>
        + Geometric<Output = M>
        + ScalarProduct<Output = Rational>,
{
    let mut samples = Samples::new(53);
    let list = crate::samples::versors(oracle, &Kind::of::<V>());
    assert!(!list.is_empty());
    for v in &list {
        let v: V = element(v);
        let (a, b): (M, M) = (samples.sparse(5), samples.sparse(5));
        let (c, d) = (v.apply(a), v.apply(b));
        assert_eq!(c.wedge(d), v.apply(a.wedge(b)), "outermorphism");
        assert_eq!(c.geometric(d), v.apply(a.geometric(b)));
        assert_eq!(c.scalar_product(d), a.scalar_product(b));
        for grade in 0..=oracle.dimension as u32 {
            let image = v.apply(part(a, grade));
            assert_eq!(part(image, grade), image, "grade {grade}");
            assert_eq!(part(c, grade), image);
        }
    }
    let zero = M::from_fn(|_| Rational::ZERO);
    assert_eq!(element::<V>(&list[0]).apply(zero), zero);
}
