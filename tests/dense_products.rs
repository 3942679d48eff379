//! Generated products that go through matrices, against the dense multivectors of ga-core,
//! against themselves over integers, and where they must not go through matrices.

use ga::cga::cga3;
use ga::core::dense::Algebra;
use ga::core::ops::{Element, Geometric, TermByTerm};
use ga::core::{Blade, Dual, Metric, Rational, Scalar};

/// Algebras without other types and products, which take long to compile.
macro_rules! algebras {
    ($($module:ident $signature:ident { $($basis:ident)* } { $($metric:tt)* })*) => {$(
        ga::define_algebra! {
            mod $module: $signature {
                basis { $($basis),* }
                metric { $($metric)* }
                types {}
                products { geometric }
            }
        }
    )*};
}

algebras! {
    r4_1 R4_1 { a b c d e } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = -1 }
    r3_2 R3_2 { a b c d e } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = -1, e^2 = -1 }
    r5 R5 { a b c d e } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1 }
    r5_0_1 R5_0_1 { a b o c d e } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1 }
    null_pairs R3_3 { a b c x y z } { a.x = 1, b.y = 1, c.z = -1 }
    r7 R7 { a b c d e f g } {
        a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1, f^2 = 1, g^2 = 1
    }
    r4_4 R4_4 { a b c d e f g h } {
        a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = -1, f^2 = -1, g^2 = -1, h^2 = -1
    }
}

fn orthonormal(positive: usize, negative: usize) -> Metric {
    Metric::from_signature(positive, negative, 0).expect("few vectors")
}

/// Vectors with these squares, and inner products of others.
fn metric(squares: &[i128], pairs: &[(usize, usize, i128)]) -> Metric {
    let dimension = squares.len();
    let mut gram = vec![vec![Rational::ZERO; dimension]; dimension];
    for (index, square) in squares.iter().enumerate() {
        gram[index][index] = Rational::from_integer(*square);
    }
    for &(i, j, product) in pairs {
        gram[i][j] = Rational::from_integer(product);
        gram[j][i] = gram[i][j];
    }
    let names = (0..dimension).map(|number| format!("v{number}"));
    Metric::new(names, gram).expect("a metric")
}

/// Numbers that are the same in every run.
struct Samples(u64);

impl Samples {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 20
    }

    fn integers(&mut self, count: usize) -> Vec<i64> {
        (0..count).map(|_| (self.next() % 19) as i64 - 9).collect()
    }

    /// Multiples of 2⁻²⁰ between −1 and 1, so that products are exact in rationals.
    fn fractions(&mut self, count: usize) -> Vec<f64> {
        let scale = f64::from(1 << 20);
        let mut next = || (self.next() % (1 << 21)) as f64 / scale - 1.0;
        (0..count).map(|_| next()).collect()
    }
}

/// The same type over other numbers.
type Over<X, T> = <X as Element>::Over<T>;

fn element<X: Element<Number = T>, T: Scalar>(numbers: &[T]) -> X {
    X::from_fn(|position| numbers[position])
}

/// Coefficients by bitmask.
fn masks<X: Element<Number = T>, T: Scalar>(x: &X, dimension: usize) -> Vec<T> {
    let blades = (0..1 << dimension).map(Blade::new);
    blades.map(|blade| x.coefficient(blade)).collect()
}

/// Small integers, where all ways are exact: floats through matrices, floats term by term,
/// integers, and the dense multivectors.
fn exact<A, B>(metric: &Metric)
where
    A: Element<Number = f64> + Geometric<B> + TermByTerm<B, Output = <A as Geometric<B>>::Output>,
    B: Element<Number = f64>,
    <A as Geometric<B>>::Output: Element<Number = f64>,
    Over<A, i64>: Geometric<Over<B, i64>>,
    <Over<A, i64> as Geometric<Over<B, i64>>>::Output: Element<Number = i64>,
{
    let dimension = metric.dimension();
    let mut samples = Samples(dimension as u64 * 31 + B::BLADES.len() as u64);
    let a = samples.integers(A::BLADES.len());
    let b = samples.integers(B::BLADES.len());
    let (x, y): (Over<A, i64>, Over<B, i64>) = (element(&a), element(&b));
    let integers = masks(&x.geometric(y), dimension);
    let algebra = Algebra::<i64>::integral(metric).expect("integers");
    let dense = |x| algebra.from_coefficients(x).expect("as many as blades");
    let expected = dense(masks(&x, dimension)).geometric(&dense(masks(&y, dimension)));
    assert_eq!(integers, expected.expect("one algebra").coefficients());
    let floats = |x: &[i64]| -> Vec<f64> { x.iter().map(|x| *x as f64).collect() };
    let (x, y): (A, B) = (element(&floats(&a)), element(&floats(&b)));
    assert_eq!(masks(&x.geometric(y), dimension), floats(&integers));
    assert_eq!(masks(&x.term_by_term(y), dimension), floats(&integers));
}

/// Every coefficient within a few units in the last place of the norms.
fn accurate<A>(metric: &Metric)
where
    A: Element<Number = f64> + Geometric<A>,
    <A as Geometric<A>>::Output: Element<Number = f64>,
{
    let dimension = metric.dimension();
    let algebra = Algebra::<Rational>::new(metric).expect("a metric");
    let mut samples = Samples(dimension as u64);
    let numbers: [Vec<f64>; 2] = [(); 2].map(|()| samples.fractions(A::BLADES.len()));
    let [x, y]: [A; 2] = [element(&numbers[0]), element(&numbers[1])];
    let rational = |x: &f64| Rational::new((x * f64::from(1 << 20)) as i128, 1 << 20);
    let dense = |x: &A| {
        let exact = masks(x, dimension).iter().map(rational).collect();
        algebra.from_coefficients(exact).expect("as many as blades")
    };
    let expected = dense(&x).geometric(&dense(&y)).expect("one algebra");
    let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let bound = 2.0 * f64::EPSILON * norm(&numbers[0]) * norm(&numbers[1]);
    let product = masks(&x.geometric(y), dimension);
    for (value, exact) in product.iter().zip(expected.coefficients()) {
        let exact = *exact.numer() as f64 / *exact.denom() as f64;
        assert!((value - exact).abs() <= bound, "{value} {exact} {bound}");
        assert!((value - exact).abs() <= 1e-13 * norm(&product));
    }
}

macro_rules! checks {
    ($($test:ident $module:ident $metric:expr, [$($Left:ident $Right:ident),*];)*) => {$(
        #[test]
        fn $test() {
            let metric = $metric;
            $(exact::<$module::$Left<f64>, $module::$Right<f64>>(&metric);)*
            accurate::<$module::Multivector<f64>>(&metric);
        }
    )*};
}

checks! {
    conformal_orthonormal r4_1 orthonormal(4, 1),
        [Multivector Multivector, Even Even, Even Odd, Odd Even, Odd Odd];
    conformal_null_basis cga3 metric(&[1, 1, 1, 0, 0], &[(3, 4, -1)]),
        [Multivector Multivector, Even Even, Even Odd, Odd Even, Odd Odd];
    two_ideals r3_2 orthonormal(3, 2), [Multivector Multivector, Even Even];
    quaternion_ideals r5 orthonormal(5, 0), [Multivector Multivector, Odd Odd];
    a_vector_of_square_zero r5_0_1 metric(&[1, 1, 0, 1, 1, 1], &[]),
        [Multivector Multivector, Even Even, Odd Odd, Even Multivector, Multivector Odd];
    pairs_of_null_vectors null_pairs metric(&[0; 6], &[(0, 3, 1), (1, 4, 1), (2, 5, -1)]),
        [Multivector Multivector];
    seven_dimensions r7 orthonormal(7, 0),
        [Multivector Multivector, Even Even, Odd Even, Multivector Even];
    eight_dimensions r4_4 orthonormal(4, 4), [Multivector Multivector, Even Odd, Odd Odd];
}

/// A dilation by a power of two commutes with the product bit by bit: coefficients of different
/// conformal weight never meet in a sum.
#[test]
fn conformal_weights_stay_apart() {
    let mut samples = Samples(5);
    let [x, y]: [cga3::Multivector<f32>; 2] = [(); 2].map(|()| {
        let numbers = samples.fractions(32);
        cga3::Multivector::from_fn(|position| numbers[position] as f32)
    });
    let dilated = |x: cga3::Multivector<f32>, power: i32| {
        let mut masks = x.to_masks();
        for (mask, value) in masks.iter_mut().enumerate() {
            let weight = (mask >> 3 & 1) as i32 - (mask >> 4 & 1) as i32;
            *value *= 2_f32.powi(power * weight);
        }
        cga3::Multivector::from_masks(masks)
    };
    for power in [-20, -3, 1, 12, 24] {
        let product = dilated(x, power) * dilated(y, power);
        assert_eq!(product, dilated(x * y, power), "{power}");
    }
}

/// Where no rounding is wanted there are no halves, and derivatives follow their numbers.
#[test]
fn exact_numbers_have_no_halves() {
    assert!(i64::HALF.is_none() && Rational::HALF.is_none());
    assert!(Dual::<i64>::HALF.is_none() && Dual::<Rational>::HALF.is_none());
    assert_eq!(f32::HALF, Some(0.5));
    assert_eq!(Dual::<f64>::HALF, Some(Dual::constant(0.5)));
    let lanes = <wide::f64x4 as Scalar>::HALF;
    assert_eq!(lanes, Some(wide::f64x4::new([0.5; 4])));
}

#[test]
fn dual_numbers_and_lanes_go_the_same_way() {
    let mut samples = Samples(11);
    let numbers: [Vec<i64>; 4] = [(); 4].map(|()| samples.integers(32));
    let at = |which: usize, position: usize| numbers[which][position] as f64;
    let [a, b, c, d] =
        [0, 1, 2, 3].map(|which| r4_1::Multivector::<f64>::from_fn(|position| at(which, position)));
    // (a + ε c)(b + ε d)
    let dual = |re: usize, eps: usize| {
        r4_1::Multivector::from_fn(|position| Dual::new(at(re, position), at(eps, position)))
    };
    let product = dual(0, 2) * dual(1, 3);
    assert_eq!(product.map(|x| x.re), a * b);
    assert_eq!(product.map(|x| x.eps), a * d + c * b);
    let lanes = |other: usize| {
        r4_1::Multivector::from_fn(|position| {
            wide::f64x4::new([0, 1, 2, 3].map(|lane| at(lane ^ other, position)))
        })
    };
    let product = lanes(0) * lanes(1);
    for (lane, expected) in [a * b, b * a, c * d, d * c].into_iter().enumerate() {
        assert_eq!(product.map(|x| x.to_array()[lane]), expected);
    }
}

/// A small type widened to a large one multiplies term by term: nothing but products of its own
/// coefficients.
#[test]
fn small_types_do_not_round_zeros() {
    let mut samples = Samples(17);
    let numbers = samples.fractions(16);
    let even = cga3::Even::<f64>::from_fn(|position| numbers[position] / 3.0);
    let third = cga3::Scalar::new(1.0 / 3.0);
    assert_eq!(third * even, even.map(|x| x * (1.0 / 3.0)));
    let rotor = cga3::Rotor::new(0.1, 0.2, 0.3, 0.7);
    let wide = cga3::Even::from(rotor);
    assert_eq!(rotor * even, wide.term_by_term(even));
    assert_eq!(even * rotor, even.term_by_term(wide));
    // Blade by blade, where every other coefficient vanishes in every term.
    let vector = cga3::Odd {
        e1: 0.1,
        ..cga3::Odd::default()
    };
    let square = vector.term_by_term(vector);
    assert_eq!(
        square,
        cga3::Even {
            s: 0.1 * 0.1,
            ..cga3::Even::default()
        }
    );
}

/// What is not finite spoils much of the product, but nothing panics, and term by term only
/// what it takes part in is spoilt.
#[test]
fn what_is_not_finite_spreads() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let x = r4_1::Multivector {
            s: value,
            ..r4_1::Multivector::default()
        };
        let y = r4_1::Multivector::<f64>::from_fn(|position| position as f64);
        assert!(!(x * y).s.is_finite());
    }
    let x = r4_1::Odd {
        a: f64::MAX,
        ..r4_1::Odd::default()
    };
    let doubled = x.term_by_term(r4_1::Odd {
        b: 2.0,
        ..r4_1::Odd::default()
    });
    assert_eq!(
        doubled,
        r4_1::Even {
            ab: f64::INFINITY,
            ..r4_1::Even::default()
        }
    );
}
