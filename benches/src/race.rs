//! How contestants are timed: in turns, each by the fastest of many short windows.

use std::hint::black_box;
use std::time::Instant;

/// The elements that one pass goes through.
pub const ELEMENTS: usize = 4096;

/// Windows that each contestant gets, in turns with the others.
const ROUNDS: usize = 80;

/// How long a window is at least, in seconds: far above the resolution of the clock, far below
/// the time between two interruptions.
const WINDOW: f64 = 100e-6;

/// One implementation of an operation, with data of its own.
pub struct Contestant {
    /// The library.
    pub name: &'static str,
    /// The first results, in coordinates that do not depend on the library.
    pub images: Vec<Vec<f64>>,
    pass: Box<dyn FnMut()>,
}

/// The number of results that are compared.
const COMPARED: usize = 512;

impl Contestant {
    /// out\[i\] = f(a\[i\]).
    pub fn unary<A, C>(
        name: &'static str,
        a: Vec<A>,
        function: impl Fn(A) -> C + Copy + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: Copy + 'static,
        C: 'static,
    {
        let mut out: Vec<C> = a.iter().map(|a| function(*a)).collect();
        Contestant {
            name,
            images: out.iter().take(COMPARED).map(view).collect(),
            pass: Box::new(move || {
                for (out, a) in out.iter_mut().zip(black_box(&a)) {
                    *out = function(*a);
                }
                black_box(&mut out);
            }),
        }
    }

    /// out\[i\] = f(a\[i\], b\[i\]).
    pub fn binary<A, B, C>(
        name: &'static str,
        a: Vec<A>,
        b: Vec<B>,
        function: impl Fn(A, B) -> C + Copy + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: Copy + 'static,
        B: Copy + 'static,
        C: 'static,
    {
        let pairs = a.iter().zip(&b);
        let mut out: Vec<C> = pairs.map(|(a, b)| function(*a, *b)).collect();
        Contestant {
            name,
            images: out.iter().take(COMPARED).map(view).collect(),
            pass: Box::new(move || {
                let operands = black_box(&a).iter().zip(black_box(&b));
                for (out, (a, b)) in out.iter_mut().zip(operands) {
                    *out = function(*a, *b);
                }
                black_box(&mut out);
            }),
        }
    }

    /// out\[i\] = f(a\[i\], b\[i\], c\[i\]).
    pub fn ternary<A, C>(
        name: &'static str,
        [a, b, c]: [Vec<A>; 3],
        function: impl Fn(A, A, A) -> C + Copy + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: Copy + 'static,
        C: 'static,
    {
        let triples = a.iter().zip(&b).zip(&c);
        let mut out: Vec<C> = triples.map(|((a, b), c)| function(*a, *b, *c)).collect();
        Contestant {
            name,
            images: out.iter().take(COMPARED).map(view).collect(),
            pass: Box::new(move || {
                let operands = black_box(&a).iter().zip(black_box(&b)).zip(black_box(&c));
                for (out, ((a, b), c)) in out.iter_mut().zip(operands) {
                    *out = function(*a, *b, *c);
                }
                black_box(&mut out);
            }),
        }
    }

    /// out\[i\] = f(a\[i\], b\[i\], c\[i\], d\[i\]).
    pub fn quaternary<A, C>(
        name: &'static str,
        [a, b, c, d]: [Vec<A>; 4],
        function: impl Fn(A, A, A, A) -> C + Copy + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: Copy + 'static,
        C: 'static,
    {
        let quadruples = a.iter().zip(&b).zip(c.iter().zip(&d));
        let mut out: Vec<C> = quadruples
            .map(|((a, b), (c, d))| function(*a, *b, *c, *d))
            .collect();
        Contestant {
            name,
            images: out.iter().take(COMPARED).map(view).collect(),
            pass: Box::new(move || {
                let first = black_box(&a).iter().zip(black_box(&b));
                let second = black_box(&c).iter().zip(black_box(&d));
                for (out, ((a, b), (c, d))) in out.iter_mut().zip(first.zip(second)) {
                    *out = function(*a, *b, *c, *d);
                }
                black_box(&mut out);
            }),
        }
    }

    /// A whole slice by one call: f(a, out), where `out` has something in it.
    pub fn slice<A, C>(
        name: &'static str,
        a: Vec<A>,
        mut out: Vec<C>,
        function: impl Fn(&[A], &mut [C]) + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: 'static,
        C: 'static,
    {
        function(&a, &mut out);
        Contestant {
            name,
            images: out.iter().take(COMPARED).map(view).collect(),
            pass: Box::new(move || {
                function(black_box(&a), &mut out);
                black_box(&mut out);
            }),
        }
    }

    /// A whole container by one call: f(a), which gives another one.
    pub fn container<A, C>(
        name: &'static str,
        a: A,
        function: impl Fn(&A) -> C + 'static,
        images: impl Fn(&C, usize) -> Vec<Vec<f64>>,
    ) -> Self
    where
        A: 'static,
    {
        Contestant {
            name,
            images: images(&function(&a), COMPARED),
            pass: Box::new(move || {
                black_box(function(black_box(&a)));
            }),
        }
    }

    /// Two whole slices by one call: f(a, b, out), where `out` has something in it.
    pub fn slices<A, B, C>(
        name: &'static str,
        a: Vec<A>,
        b: Vec<B>,
        out: Vec<C>,
        function: impl Fn(&[A], &[B], &mut [C]) + 'static,
        view: impl Fn(&C) -> Vec<f64>,
    ) -> Self
    where
        A: 'static,
        B: 'static,
        C: 'static,
    {
        let both = move |b: &[B], out: &mut [C]| function(black_box(&a), b, out);
        Contestant::slice(name, b, out, both, view)
    }

    /// Seconds of so many passes.
    fn seconds(&mut self, passes: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..passes {
            (self.pass)();
        }
        start.elapsed().as_secs_f64()
    }

    /// How many passes fill a window.
    fn passes(&mut self) -> usize {
        let mut passes = 1;
        while self.seconds(passes) < WINDOW {
            passes += passes.div_ceil(2);
        }
        passes
    }
}

/// Nanoseconds per element of each contestant.
pub fn race(contestants: &mut [Contestant]) -> Vec<f64> {
    let passes: Vec<usize> = contestants.iter_mut().map(Contestant::passes).collect();
    let mut best = vec![f64::INFINITY; contestants.len()];
    for _ in 0..ROUNDS {
        for ((contestant, passes), best) in contestants.iter_mut().zip(&passes).zip(&mut best) {
            let each = contestant.seconds(*passes) / (*passes * ELEMENTS) as f64;
            *best = best.min(each * 1e9);
        }
    }
    best
}

/// Which results of a contestant differ from those of the first by more than a tolerance.
///
/// Coordinates are compared with the size of their element. What is homogeneous, such as a line
/// or a motor, may come with another factor: `homogeneous` compares up to that.
///
/// # Errors
/// The name and the first element that differs, with both results.
pub fn agree(contestants: &[Contestant], tolerance: f64, homogeneous: bool) -> Result<(), String> {
    let Some((first, others)) = contestants.split_first() else {
        return Ok(());
    };
    for other in others {
        for (index, (own, its)) in first.images.iter().zip(&other.images).enumerate() {
            let its = match homogeneous {
                true => nearest_multiple(own, its),
                false => its.clone(),
            };
            let size = own.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
            let same = own.len() == its.len()
                && own
                    .iter()
                    .zip(&its)
                    .all(|(x, y)| (x - y).abs() <= tolerance * size);
            if !same {
                return Err(format!(
                    "element {index}: {} gives {own:?}, {} gives {its:?}",
                    first.name, other.name
                ));
            }
        }
    }
    Ok(())
}

/// The multiple of some coordinates that is nearest to others.
fn nearest_multiple(own: &[f64], its: &[f64]) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let factor = dot(own, its) / dot(its, its);
    its.iter().map(|x| x * factor).collect()
}
