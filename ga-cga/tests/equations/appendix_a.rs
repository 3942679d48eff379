//! Appendix A: the algorithms that generate a product, A.1 to A.12, written down as they are
//! printed and compared with the generated types.

use ga_core::ops::{Element, Geometric, LeftContract, Wedge};
use ga_core::product::product;
use ga_core::{Blade, Metric, Product, Rational, reorder_sign};

use super::euclidean::{r3, r4};
use super::samples::{Sample, each};

/// A.1, with `c` the count so far.
fn grade(a: u32, c: u32) -> u32 {
    match a {
        0 => c,
        _ => grade(a >> 1, c + (a & 1)),
    }
}

/// A.2.
fn product_of_blades(a: u32, b: u32) -> u32 {
    a ^ b
}

/// A.3, with `c` the count so far: whether the product of two blades flips its sign.
fn sign(a: u32, b: u32, c: u32) -> bool {
    match a >> 1 {
        0 => c & 1 == 1,
        rest => sign(rest, b, c + grade(rest & b, 0)),
    }
}

/// A.4: whether two blades have a left contraction. The pseudocode returns the contrary, the C++
/// below it this.
fn inner(a: u32, b: u32) -> bool {
    let (ga, gb, gab) = (grade(a, 0), grade(b, 0), grade(a ^ b, 0));
    !(ga > gb || gab != gb - ga)
}

/// A.5.
fn outer(a: u32, b: u32) -> bool {
    a & b == 0
}

/// A.6, which compares the grades first; the print tests a = b where it means their grades.
fn compare(a: u32, b: u32) -> bool {
    let (ga, gb) = (grade(a, 0), grade(b, 0));
    if ga == gb { a < b } else { ga < gb }
}

/// A.7: inserts a blade into a sorted list, `first` the part already passed.
fn insert(a: u32, rest: &[u32], first: &[u32]) -> Vec<u32> {
    match rest {
        [] => [first, &[a]].concat(),
        [head, ..] if compare(a, *head) => [first, &[a], rest].concat(),
        [head, tail @ ..] => insert(a, tail, &[first, &[*head]].concat()),
    }
}

/// One instruction: the signed product of a coefficient of each factor, and its blade.
#[derive(Clone, Copy)]
struct Instruction {
    flips: bool,
    result: u32,
    positions: [usize; 2],
}

/// A.8, for the blades that a product keeps.
fn instructions(a: &[u32], b: &[u32], keeps: fn(u32, u32) -> bool) -> Vec<Instruction> {
    let one = |(i, &a): (usize, &u32)| {
        let with = move |(j, &b): (usize, &u32)| {
            keeps(a, b).then(|| Instruction {
                flips: sign(a, b, 0),
                result: product_of_blades(a, b),
                positions: [i, j],
            })
        };
        b.iter().enumerate().filter_map(with).collect::<Vec<_>>()
    };
    a.iter().enumerate().flat_map(one).collect()
}

/// A.9.
fn exists(a: u32, list: &[u32]) -> bool {
    match list {
        [] => false,
        [head, tail @ ..] => a == *head || exists(a, tail),
    }
}

/// A.10: the blades of the result, sorted.
fn reduce(list: &[Instruction]) -> Vec<u32> {
    match list {
        [] => Vec::new(),
        [head, tail @ ..] => {
            let blades = reduce(tail);
            if exists(head.result, &blades) {
                blades
            } else {
                insert(head.result, &blades, &[])
            }
        }
    }
}

/// A.11: the instructions of each blade of the result.
fn index(list: &[Instruction], blades: &[u32]) -> Vec<Vec<Instruction>> {
    let find = |blade: u32| list.iter().filter(move |one| one.result == blade).copied();
    blades.iter().map(|&blade| find(blade).collect()).collect()
}

/// The bits of a type's blades.
fn bits<X: Element>() -> Vec<u32> {
    X::BLADES.iter().map(|(blade, _)| blade.mask()).collect()
}

/// A.12: the blades of a product and their coefficients.
fn execute<A, B>(a: A, b: B, keeps: fn(u32, u32) -> bool) -> Vec<(u32, Rational)>
where
    A: Element<Number = Rational>,
    B: Element<Number = Rational>,
{
    let list = instructions(&bits::<A>(), &bits::<B>(), keeps);
    let blades = reduce(&list);
    let sums = index(&list, &blades).into_iter().map(|list| {
        let terms = list.into_iter().map(|one| {
            let [i, j] = one.positions;
            let term = a.at(i) * b.at(j);
            if one.flips { -term } else { term }
        });
        terms.sum()
    });
    blades.iter().copied().zip(sums).collect()
}

/// Every blade of the list has its coefficient in the element, which holds no other but zero.
fn agree<X: Element<Number = Rational>>(found: X, list: &[(u32, Rational)]) {
    for &(blade, coefficient) in list {
        assert_eq!(
            found.coefficient(Blade::new(blade)),
            coefficient,
            "{blade:b}"
        );
    }
    let listed: Vec<u32> = list.iter().map(|(blade, _)| *blade).collect();
    for &(blade, _) in X::BLADES {
        let zero = found.coefficient(blade) == Rational::default();
        assert!(zero || listed.contains(&blade.mask()), "{blade:?}");
    }
}

/// A.1: the grade is the number of bits.
#[test]
fn algorithm_a_1_grade() {
    for a in 0..1 << 12 {
        assert_eq!(grade(a, 0), Blade::new(a).grade());
        assert_eq!(grade(a, 0), a.count_ones());
    }
}

/// The coefficient of the one term that two blades of an orthonormal basis have.
fn term(which: Product, a: u32, b: u32) -> Option<(u32, Rational)> {
    let metric = Metric::from_signature(5, 0, 0).expect("a metric");
    let terms = product(&metric, which, Blade::new(a), Blade::new(b)).expect("blades of R5");
    assert!(terms.len() < 2);
    terms
        .first()
        .map(|(blade, coefficient)| (blade.mask(), *coefficient))
}

/// A.2 and A.3: the product of two blades is their exclusive or, with the sign of the reordering.
#[test]
fn algorithms_a_2_and_a_3_the_product_of_blades_and_its_sign() {
    for a in 0..32 {
        for b in 0..32 {
            let value = if sign(a, b, 0) { -1 } else { 1 };
            assert_eq!(reorder_sign(a, b), value);
            let expected = (
                product_of_blades(a, b),
                Rational::from_integer(value.into()),
            );
            assert_eq!(term(Product::Geometric, a, b), Some(expected));
        }
    }
}

/// A.4 and A.5: which blades have a left contraction, and which an outer product.
#[test]
fn algorithms_a_4_and_a_5_the_inner_and_the_outer_product_of_blades() {
    for a in 0..32 {
        for b in 0..32 {
            assert_eq!(term(Product::LeftContract, a, b).is_some(), inner(a, b));
            assert_eq!(term(Product::Wedge, a, b).is_some(), outer(a, b));
        }
    }
}

/// A.6 and A.7: blades inserted in any sequence come out in the order of the generated types.
#[test]
fn algorithms_a_6_and_a_7_the_order_of_blades() {
    for (dimension, order) in [
        (3, bits::<r3::Multivector<Rational>>()),
        (4, bits::<r4::Multivector<Rational>>()),
    ] {
        let count = 1 << dimension;
        for stride in [1, 3, 5, 7] {
            let sorted = (0..count).fold(Vec::new(), |list, step| {
                insert(step * stride % count, &list, &[])
            });
            assert_eq!(sorted, order);
        }
    }
}

/// A.8, A.9, A.10, A.11 and A.12: instructions built, reduced to a type, sorted and executed give
/// the products of the generated types.
#[test]
fn algorithms_a_8_to_a_12_products_by_instruction_lists() {
    fn all<A, B>(a: A, b: B)
    where
        A: Element<Number = Rational> + Geometric<B> + Wedge<B> + LeftContract<B>,
        B: Element<Number = Rational>,
        <A as Geometric<B>>::Output: Element<Number = Rational>,
        <A as Wedge<B>>::Output: Element<Number = Rational>,
        <A as LeftContract<B>>::Output: Element<Number = Rational>,
    {
        agree(a.geometric(b), &execute(a, b, |_, _| true));
        agree(a.wedge(b), &execute(a, b, outer));
        agree(a.left_contract(b), &execute(a, b, inner));
    }
    each(|samples| {
        let [u, v]: [r3::Vector<Rational>; 2] = std::array::from_fn(|_| samples.element());
        let plane: r3::Bivector<Rational> = samples.element();
        let [x, y]: [r3::Multivector<Rational>; 2] = std::array::from_fn(|_| samples.element());
        let even: r4::Even<Rational> = samples.element();
        let odd = r4::Odd::from_fn(|_| Rational::next(samples));
        all(u, v);
        all(u, plane);
        all(plane, u);
        all(plane, plane);
        all(x, y);
        all(even, odd);
        // The type is the smallest: that of two vectors has the blades 1, e12, e13, e23.
        let list = instructions(&bits::<r3::Vector>(), &bits::<r3::Vector>(), |_, _| true);
        assert_eq!(reduce(&list), bits::<r3::Even>());
        assert!(exists(0b011, &reduce(&list)) && !exists(0b001, &reduce(&list)));
        // Each blade of e12, e13, e23 has two instructions, the scalar has three.
        let counts = index(&list, &reduce(&list))
            .iter()
            .map(Vec::len)
            .collect::<Vec<_>>();
        assert_eq!(counts, [3, 2, 2, 2]);
    });
}
