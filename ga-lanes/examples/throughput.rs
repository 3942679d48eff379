//! How near batches come to the machine's limits: fused multiply-adds in cache, copies beyond it.
//!
//! `cargo run --release -p ga-lanes --example throughput`

use std::hint::black_box;
use std::time::Instant;

use ga_lanes::{Batch, Kernel, Lanes, Number, One, Target, dispatch};

ga_macros::define_algebra! {
    crate = ga_core;
    /// The conformal model with unit motors.
    mod conformal: R4_1 {
        basis { e1, e2, e3, no, ni }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1 }
        types {
            /// A point of weight 1.
            Point { no = 1, e1, e2, e3, ni }
            /// Any vector.
            DualSphere { no, e1, e2, e3, ni }
            /// A line, the generator of a motor.
            DualLine { e12, e13, e23, e1^ni, e2^ni, e3^ni }
            /// A circle.
            Circle = grade 3;
            /// A rigid motion, a unit versor.
            #[unit]
            Motor { 1, e12, e13, e23, e1^ni, e2^ni, e3^ni, e123^ni }
        }
    }
}

use conformal::{Circle, DualLine, Motor, Point};

/// As many fused multiply-adds as the machine can do: chains that do not wait for each other.
struct Peak(u32);

impl<F: Number> Kernel<F> for Peak {
    type Output = f64;

    /// Multiply-adds of single numbers per nanosecond.
    #[inline(always)]
    fn run<L: Lanes<F>>(self) -> f64 {
        let factor = L::from_f64(black_box(0.999));
        let mut sums = [L::from_f64(black_box(1.0)); 12];
        let time = least_seconds(|| {
            for _ in 0..self.0 {
                for sum in &mut sums {
                    *sum = factor.plus_product(*sum, factor);
                }
            }
        });
        black_box(sums);
        (12 * L::COUNT) as f64 * f64::from(self.0) / time * 1e-9
    }
}

/// The least time of many, in seconds.
#[inline(always)]
fn least_seconds(mut function: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_millis() < 400 {
        let start = Instant::now();
        function();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

/// A number of the data, different everywhere.
fn datum(index: usize) -> f64 {
    ((index * 7919) % 1000) as f64 * 1e-3 + 0.1
}

fn batch<X: ga_core::Element<Number: Number>>(len: usize) -> Batch<X> {
    use ga_core::Real;
    (0..len)
        .map(|index| X::from_fn(|position| X::Number::from_f64(datum(index + 31 * position))))
        .collect()
}

fn row(
    name: &str,
    len: usize,
    repetitions: usize,
    peak: f64,
    slots: f64,
    mut function: impl FnMut(),
) {
    let time = least_seconds(|| (0..repetitions).for_each(|_| function()));
    let each = time / (len * repetitions) as f64 * 1e9;
    print!(
        "  {name:24} {each:8.3} ns, time for {:5.1} multiply-adds",
        each * peak
    );
    if slots > 0.0 {
        print!(
            ", {:3.0} % of the peak for {slots}",
            slots / (each * peak) * 100.0
        );
    }
    println!();
}

macro_rules! report {
    ($float:ident) => {
        let peak = dispatch::<$float, _>(Peak(10_000));
        println!(" {}: {peak:.1} multiply-adds a nanosecond", stringify!($float));
        let len = 2048 / size_of::<$float>();
        let (motors, points) = (batch::<Motor<$float>>(len), batch::<Point<$float>>(len));
        let circles = batch::<Circle<$float>>(len);
        let one = motors.get(3).map(One);
        let mut images = Batch::new();
        row("motors on points", len, 200, peak, 32.0, || {
            let _ = motors.apply_into(black_box(&points), black_box(&mut images));
        });
        let mut images = Batch::new();
        row("motors on circles", len, 100, peak, 107.0, || {
            let _ = motors.apply_into(black_box(&circles), black_box(&mut images));
        });
        let mut products = Batch::new();
        row("motor motor", len, 100, peak, 48.0, || {
            let _ = motors.geometric_into(black_box(&motors), black_box(&mut products));
        });
        let generators = batch::<DualLine<$float>>(len);
        row("exponentials", len, 20, peak, 0.0, || {
            black_box(black_box(&generators).exp());
        });
        let versors = generators.exp();
        row("logarithms", len, 20, peak, 0.0, || {
            black_box(black_box(&versors).log());
        });
        if let Some(one) = one {
            let mut images = Batch::new();
            row("one motor on points", len, 200, peak, 32.0, || {
                one.apply_into(black_box(&points), black_box(&mut images));
            });
            let len = (64 << 20) / size_of::<Point<$float>>();
            let points = batch::<Point<$float>>(len);
            let mut images = points.clone();
            let bytes = (2 * len * size_of::<Point<$float>>()) as f64;
            let rate = |time: f64| bytes / time * 1e-9;
            let copied = rate(least_seconds(|| copy(black_box(&points), black_box(&mut images))));
            let moved = rate(least_seconds(|| {
                one.apply_into(black_box(&points), black_box(&mut images));
            }));
            let placed = rate(least_seconds(|| one.apply_in_place(black_box(&mut images))));
            println!(
                "  one motor on {len} points, out of cache: {moved:.1} GB/s, copy {copied:.1} GB/s, \
                 {:.0} %; in place {placed:.1} GB/s",
                moved / copied * 100.0
            );
        }
    };
}

fn copy<X: ga_core::Element<Number: Number>>(from: &Batch<X>, to: &mut Batch<X>) {
    for (to, from) in to.columns_mut().zip(from.columns()) {
        to.copy_from_slice(from);
    }
}

fn main() {
    for target in Target::ALL {
        let reported = target.scope(|| {
            println!("{target:?}");
            report!(f32);
            report!(f64);
        });
        if reported.is_none() {
            println!("{target:?}: not on this machine");
        }
    }
}
