//! The numbers of products that the algorithms promise, counted on the smallest algebra there is.

#![cfg(any(feature = "std", feature = "libm"))]

use std::cell::Cell;
use std::ops::{Add, Sub};

use ga_core::algorithm::{
    MOST_HALVINGS, MOST_TERMS, ORTHONORMAL_TERMS, adjugate, adjugate_products, exponential,
};
use ga_core::ops::{Element, Geometric};
use ga_core::{Blade, Scalar};

thread_local! {
    static PRODUCTS: Cell<usize> = const { Cell::new(0) };
}

/// A number as a multivector, which counts its products with others.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted<T>(T);

impl<T: Scalar> Element for Counted<T> {
    type Number = T;
    type Over<U: Scalar> = Counted<U>;
    const BLADES: &'static [(Blade, i8)] = &[(Blade::SCALAR, 1)];
    const FIXED: &'static [(Blade, i8, i64, i64)] = &[];
    const LABELS: &'static [&'static str] = &["1"];

    fn at(&self, _: usize) -> T {
        self.0
    }

    fn from_fn(mut coefficient: impl FnMut(usize) -> T) -> Self {
        Counted(coefficient(0))
    }
}

impl<T: Scalar> Geometric for Counted<T> {
    type Output = Self;

    fn geometric(self, b: Self) -> Self {
        PRODUCTS.set(PRODUCTS.get() + 1);
        Counted(self.0 * b.0)
    }
}

impl<T: Scalar> Geometric<T> for Counted<T> {
    type Output = Self;

    fn geometric(self, b: T) -> Self {
        Counted(self.0 * b)
    }
}

impl<T: Scalar> Add for Counted<T> {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        Counted(self.0 + b.0)
    }
}

impl<T: Scalar> Sub for Counted<T> {
    type Output = Self;

    fn sub(self, b: Self) -> Self {
        Counted(self.0 - b.0)
    }
}

/// The result, and how many products it took.
fn counting<R>(compute: impl FnOnce() -> R) -> (R, usize) {
    PRODUCTS.set(0);
    let result = compute();
    (result, PRODUCTS.get())
}

/// Of all elements whose coefficients add up to 4, the number −4 has the smallest exponential
/// against the terms of its series.
#[test]
fn exponentials_sum_as_many_terms_as_they_say() {
    let (_, worst) = counting(|| exponential(Counted(-4.0)));
    assert_eq!(worst, ORTHONORMAL_TERMS);
    for step in -4096..=4096 {
        let x = f64::from(step) / 1024.0;
        let (found, products) = counting(|| exponential(Counted(x)));
        assert!((found.0 - x.exp()).abs() <= 1e-14 * x.exp().max(1.0), "{x}");
        assert!(products <= ORTHONORMAL_TERMS, "{products} for {x}");
        let (_, products) = counting(|| exponential(Counted(x as f32)));
        assert!(products <= ORTHONORMAL_TERMS, "{products} for {x} in f32");
    }
}

#[test]
fn each_halving_is_one_product_more() {
    for (x, halvings) in [
        (4.0, 0),
        (4.5, 1),
        (-700.0, 8),
        (1e300, 995),
        (f64::MAX, 1022),
    ] {
        let (_, products) = counting(|| exponential(Counted::<f64>(x)));
        assert!(
            products <= ORTHONORMAL_TERMS + halvings,
            "{products} for {x}"
        );
    }
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (_, products) = counting(|| exponential(Counted(x)));
        assert!(products <= MOST_TERMS + MOST_HALVINGS, "{products} for {x}");
    }
}

#[test]
fn adjugates_take_the_products_they_say() {
    for dimension in 0..=8 {
        let blades = 1 << dimension;
        let (_, products) = counting(|| adjugate(Counted(2.0), blades));
        assert_eq!(
            products,
            adjugate_products(blades),
            "{dimension} dimensions"
        );
    }
}
