//! Dense products from five dimensions on: term by term against the way through matrices, on
//! the same data in one process. `cargo bench --bench dense` prints a row for each signature,
//! pair of types and number: nanoseconds per product, the minimum of many windows.
//!
//! Builds for newer machines: `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench dense`.

use std::hint::black_box;
use std::time::{Duration, Instant};

use ga_core::Scalar;
use ga_core::ops::{Element, TermByTerm};

/// Algebras without other types and products, which take long to compile.
macro_rules! algebras {
    ($($module:ident $signature:ident { $($basis:ident)* } { $($metric:tt)* })*) => {$(
        ga_macros::define_algebra! {
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
    conformal R4_1 { a b c no ni } { a^2 = 1, b^2 = 1, c^2 = 1, no.ni = -1 }
    r3_2 R3_2 { a b c d e } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = -1, e^2 = -1 }
    r5_0_1 R5_0_1 { a b c d e o } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1 }
    r6 R6 { a b c d e f } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1, f^2 = 1 }
    r3_3 R3_3 { a b c d e f } { a^2 = 1, b^2 = 1, c^2 = 1, d^2 = -1, e^2 = -1, f^2 = -1 }
    r2_4 R2_4 { a b c d e f } { a^2 = 1, b^2 = 1, c^2 = -1, d^2 = -1, e^2 = -1, f^2 = -1 }
    r7 R7 { a b c d e f g } {
        a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1, f^2 = 1, g^2 = 1
    }
    r8 R8 { a b c d e f g h } {
        a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = 1, f^2 = 1, g^2 = 1, h^2 = 1
    }
    r4_4 R4_4 { a b c d e f g h } {
        a^2 = 1, b^2 = 1, c^2 = 1, d^2 = 1, e^2 = -1, f^2 = -1, g^2 = -1, h^2 = -1
    }
}

/// Nanoseconds per product.
fn nanoseconds<A, B, R>(multiply: impl Fn(A, B) -> R) -> f64
where
    A: Element,
    B: Element<Number = A::Number>,
    R: Element<Number = A::Number>,
{
    const COUNT: usize = 128;
    let mut state = 1_i64;
    let mut next = move || {
        state = (state * 75 + 74) % 65_537;
        A::Number::from_integer(state % 13 - 6)
    };
    let a: Vec<A> = (0..COUNT).map(|_| A::from_fn(|_| next())).collect();
    let b: Vec<B> = (0..COUNT).map(|_| B::from_fn(|_| next())).collect();
    let mut products = vec![R::from_fn(|_| R::Number::ZERO); COUNT];
    let mut best = f64::INFINITY;
    let mut windows = 0;
    let start = Instant::now();
    while windows < 10 || start.elapsed() < Duration::from_millis(100) {
        windows += 1;
        let window = Instant::now();
        for (product, (a, b)) in products.iter_mut().zip(a.iter().zip(&b)) {
            *product = multiply(*a, *b);
        }
        black_box(&mut products);
        best = best.min(window.elapsed().as_secs_f64() * 1e9 / COUNT as f64);
    }
    best
}

fn print(signature: &str, [left, right]: [&str; 2], scalar: &str, direct: f64, matrices: f64) {
    println!(
        "{signature:<10} {left:<12} {right:<12} {scalar:<4} {direct:>10.1} {matrices:>10.1} {:>7.2}",
        direct / matrices
    );
}

macro_rules! rows {
    ($($module:ident: $($Left:ident $Right:ident),*;)*) => {$($({
        let (name, types) = (stringify!($module), [stringify!($Left), stringify!($Right)]);
        { rows!(@of f64 name types $module $Left $Right); }
        { rows!(@of f32 name types $module $Left $Right); }
    })*)*};
    (@of $float:ident $name:ident $types:ident $module:ident $Left:ident $Right:ident) => {
        type A = $module::$Left<$float>;
        type B = $module::$Right<$float>;
        let direct = nanoseconds(|a: A, b: B| a.term_by_term(b));
        let matrices = nanoseconds(|a: A, b: B| a.geometric(b));
        print($name, $types, stringify!($float), direct, matrices);
    };
}

fn main() {
    println!(
        "{:<10} {:<12} {:<12} {:<4} {:>10} {:>10} {:>7}",
        "signature", "left", "right", "", "direct ns", "matrix ns", "ratio"
    );
    rows! {
        r4_1: Multivector Multivector, Even Even, Even Odd, Odd Odd;
        conformal: Multivector Multivector, Even Even, Even Odd, Odd Odd;
        r3_2: Multivector Multivector, Even Even;
        r6: Multivector Multivector, Even Even, Odd Odd, Even Multivector;
        r3_3: Multivector Multivector, Even Even, Odd Odd, Even Multivector;
        r2_4: Multivector Multivector, Even Even, Odd Odd, Even Multivector;
        r5_0_1: Multivector Multivector, Even Even, Even Multivector;
        r7: Multivector Multivector, Even Even, Odd Even;
        r8: Multivector Multivector, Even Even, Odd Even;
        r4_4: Multivector Multivector, Even Even, Odd Even;
    }
}
