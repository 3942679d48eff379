//! Involutions, complements, duals, norms, grade parts and inverses of every type.

use std::marker::PhantomData;
use std::ops::Not;

use ga::core::dense::Dense;
use ga::core::ops::*;
use ga::core::{Blade, Product, Rational};

use crate::kind::{Kind, smallest};
use crate::operation::{Numbers, element, numbers};
use crate::polynomial::linear;
use crate::reference::Oracle;
use crate::samples::{Form, Samples};

/// Stands for one type; what is not generated falls back to the trait of absence.
pub struct Single<A>(PhantomData<A>);

impl<A> Single<A> {
    pub const fn new() -> Single<A> {
        Single(PhantomData)
    }
}

/// A linear map of the dense algebra, where the metric has it.
type Map = fn(&Dense<Rational>) -> Option<Dense<Rational>>;

/// The type of the image: the type itself, or the smallest that holds it; `None` where the
/// metric has no such map or no type holds the image.
fn image_kind(oracle: &Oracle, kind: &Kind, map: Map) -> Option<Kind> {
    map(&oracle.algebra.zero())?;
    let image = linear(&kind.general(0), |mask| {
        let blade = oracle.algebra.blade(Blade::new(mask), Rational::ONE);
        let image = blade
            .ok()
            .and_then(|blade| map(&blade))
            .expect("a linear map");
        let terms = image.terms();
        terms.iter().map(|(blade, v)| (blade.mask(), *v)).collect()
    });
    // Involutions keep a square of 0; duals are of other blades than null types here.
    let own = kind.fits(&image).then_some(kind);
    own.or_else(|| smallest(oracle, &image)).cloned()
}

/// Compares a linear map on samples, and its type with all types.
fn compare(
    oracle: &Oracle,
    name: &str,
    [kind, result]: [Kind; 2],
    map: Map,
    compute: fn(&[Rational]) -> Numbers,
) {
    let what = format!("{}.{name}()", kind.name);
    let fields = image_kind(oracle, &kind, map).map(|kind| kind.stored.len());
    assert_eq!(Some(result.stored.len()), fields, "fields of {what}");
    let mut samples = Samples::new(11 + kind.stored.len() as u64);
    for form in [Form::Fractions, Form::Fractions, Form::Sparse(2)] {
        let a = samples.numbers(kind.stored.len(), form);
        let value = oracle.value_of(&kind, &a);
        let expected = map(&oracle.dense(&value)).expect("a map of the metric");
        let generated = oracle.value_of(&result, &compute(&a));
        oracle.same(
            &what,
            &[&value],
            &generated,
            &expected.coefficients().to_vec(),
        );
    }
}

macro_rules! all_maps {
    ($($trait:ident $method:ident $map:expr;)*) => {
        $(
            impl<A, R> Single<A>
            where
                A: Element<Number = Rational> + $trait<Output = R>,
                R: Element<Number = Rational>,
            {
                pub fn $method(&self, oracle: &Oracle) {
                    let kinds = [Kind::of::<A>(), Kind::of::<R>()];
                    compare(oracle, stringify!($method), kinds, $map, |a| {
                        numbers(&element::<A>(a).$method())
                    });
                }
            }
        )*

        /// What is not generated must have no type, or no meaning in the metric.
        #[expect(dead_code, reason = "some maps exist for every type")]
        pub trait NoMap {
            $(fn $method(&self, oracle: &Oracle);)*
        }

        impl<A: Element<Number = Rational>> NoMap for Single<A> {
            $(
                fn $method(&self, oracle: &Oracle) {
                    let kind = Kind::of::<A>();
                    let image = image_kind(oracle, &kind, $map);
                    assert_eq!(image, None, "{}.{}()", kind.name, stringify!($method));
                }
            )*
        }
    };
}

all_maps! {
    Reverse reverse |a| Some(a.reverse());
    Involute involute |a| Some(a.involute());
    Conjugate conjugate |a| Some(a.conjugate());
    LeftComplement left_complement |a| Some(a.left_complement());
    RightComplement right_complement |a| Some(a.right_complement());
    Dual dual |a| a.dual().ok();
    Undual undual |a| a.dual().ok().map(|_| a.undual());
}

/// The squared norm.
pub fn norms<A>(oracle: &Oracle)
where
    A: Element<Number = Rational> + NormSquared<Output = Rational>,
{
    let name = Kind::of::<A>().name;
    let mut samples = Samples::new(13 + A::BLADES.len() as u64);
    for _ in 0..2 {
        let a: A = samples.full();
        let value = oracle.value(&a);
        let expected = oracle.scalar(oracle.dense(&value).norm_squared());
        let generated = oracle.scalar(a.norm_squared());
        let what = format!("{name}.norm_squared()");
        oracle.same(&what, &[&value], &generated, &expected);
    }
}

/// The operator `!` is the dual.
pub fn not<A>(oracle: &Oracle)
where
    A: Element<Number = Rational> + Dual<Output: Element<Number = Rational>>,
    A: Not<Output = <A as Dual>::Output>,
{
    let a: A = Samples::new(14).full();
    let value = oracle.value(&a);
    let expected = oracle.value(&a.dual());
    oracle.same("!", &[&value], &oracle.value(&!a), &expected);
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
    if oracle.dimension < 6 || A::BLADES.len() <= 6 {
        list.push(A::from_fn(|_| samples.integer(3)));
    }
    for a in list {
        let value = oracle.value(&a);
        let generated = Inverse::inverse(a).map(|inverse| oracle.value(&inverse));
        let expected = oracle.inverse(&value);
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
        #[allow(unused_imports, reason = "used by types without some map")]
        use crate::unary::NoMap;
        let single = crate::unary::Single::<A>::new();
        single.reverse(&$oracle);
        single.involute(&$oracle);
        single.conjugate(&$oracle);
        single.left_complement(&$oracle);
        single.right_complement(&$oracle);
        single.dual(&$oracle);
        single.undual(&$oracle);
        crate::unary::norms::<A>(&$oracle);
        crate::unary::inverses::<A>(&$oracle);
        crate::arithmetic::sums::<A>(&$oracle);
        crate::arithmetic::numbers_on_the_left::<$module::$A<f32>, $module::$A<f64>>();
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

/// The operator of the dual of a type.
macro_rules! check_duals {
    ($oracle:ident, $module:ident, $A:ident) => {
        crate::unary::not::<$module::$A<ga::core::Rational>>(&$oracle);
    };
}
pub(crate) use check_duals;
