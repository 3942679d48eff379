//! exp, log and sqrt of every family against arithmetic of 32 digits.

use ga::core::Real;
use ga::core::ops::{Element, Exponential, Logarithm, SquareRoot};

use crate::families::families;
use crate::space::{Space, error, largest};

/// The worst error of each function, with where it occurred.
#[derive(Default)]
pub struct Worst(Vec<(&'static str, f64, String)>);

impl Worst {
    fn note(&mut self, function: &'static str, error: f64, allowed: f64, kind: &str) {
        let ratio = error / allowed;
        match self.0.iter_mut().find(|(known, ..)| *known == function) {
            Some(worst) if worst.1 >= ratio => {}
            Some(worst) => *worst = (function, ratio, format!("{error:e} for {kind}")),
            None => self
                .0
                .push((function, ratio, format!("{error:e} for {kind}"))),
        }
    }

    fn judge(&self, name: &str) {
        for (function, ratio, kind) in &self.0 {
            println!("{name} {function}: {ratio:.2} of what is allowed, {kind}");
        }
        for (function, ratio, kind) in &self.0 {
            assert!(*ratio <= 1.0, "{name} {function}: {kind}");
        }
    }
}

/// Every function on every family, in double precision.
pub fn check<B, R>(space: &Space)
where
    B: Element<Number = f64> + Exponential<Output = R>,
    R: Element<Number = f64> + Logarithm<Output = B> + SquareRoot<Output = R>,
{
    compare::<B, R, f64>(space, &DOUBLE);
}

/// The same where the exponential is a power series, which loses a digit in large boosts.
pub fn check_series<B, R>(space: &Space)
where
    B: Element<Number = f64> + Exponential<Output = R>,
    R: Element<Number = f64> + Logarithm<Output = B> + SquareRoot<Output = R>,
{
    let bounds = Bounds {
        exp: 1e-13,
        edge: 4e-15,
        ..DOUBLE
    };
    compare::<B, R, f64>(space, &bounds);
}

/// What double precision promises.
const DOUBLE: Bounds = Bounds {
    rounding: 1e-15,
    exp: 1e-14,
    log: 1e-13,
    edge: 1e-15,
};

/// Every function on every family, in single precision.
pub fn check_single<B, R>(space: &Space)
where
    B: Element<Number = f32> + Exponential<Output = R>,
    R: Element<Number = f32> + Logarithm<Output = B> + SquareRoot<Output = R>,
{
    let bounds = Bounds {
        rounding: 1e-6,
        exp: 1e-5,
        log: 1e-5,
        edge: 5e-7,
    };
    compare::<B, R, f32>(space, &bounds);
}

/// The errors that are allowed.
struct Bounds {
    /// Of the sample as a value of the type.
    rounding: f64,
    /// Of exponentials.
    exp: f64,
    /// Of logarithms and roots.
    log: f64,
    /// Of logarithms and roots, times the distance from the edge.
    edge: f64,
}

fn compare<B, R, N>(space: &Space, bounds: &Bounds)
where
    N: Real + Into<f64>,
    B: Element<Number = N> + Exponential<Output = R>,
    R: Element<Number = N> + Logarithm<Output = B> + SquareRoot<Output = R>,
{
    let mut worst = Worst::default();
    for sample in families(space) {
        if bounds.edge > 0.1 * sample.gap {
            continue;
        }
        let bivector: B = space.rounded(&sample.bivector);
        let exact = space.value(&bivector);
        // Not in the type: a part of the bivector is dropped.
        if error(&exact, &sample.bivector) > bounds.rounding {
            continue;
        }
        let exponential = space.exp(&exact);
        let generated = bivector.exp();
        let kind = &sample.kind;
        let found = error(&space.value(&generated), &exponential);
        // An angle or rapidity is known to its rounding only.
        let growth = sample.growth.powi(2);
        let size = largest(&exact).max(10.0) / 10.0;
        worst.note("exp", found, bounds.exp * size * growth, kind);
        // The logarithm of the exponential rounded to double precision.
        let versor: R = space.rounded(&exponential);
        let allowed = (bounds.log + bounds.edge / sample.gap) * growth;
        match versor.log() {
            Some(log) => {
                let found = error(&space.value(&log), &exact);
                worst.note("log", found, allowed, kind);
                let back = error(&space.exp(&space.value(&log)), &space.value(&versor));
                worst.note("exp of log", back, allowed, kind);
            }
            None => worst.note("log", f64::INFINITY, allowed, kind),
        }
        match generated.log() {
            Some(log) => {
                let found = error(&space.value(&log), &exact);
                worst.note("log of exp", found, allowed, kind);
            }
            None => worst.note("log of exp", f64::INFINITY, allowed, kind),
        }
        let halved = exact.scale(crate::wide::Wide::from(0.5));
        match versor.sqrt() {
            Some(root) => {
                let root = space.value(&root);
                worst.note("sqrt", error(&root, &space.exp(&halved)), allowed, kind);
                let square = error(&space.times(&root, &root), &space.value(&versor));
                worst.note("square of sqrt", square, allowed, kind);
            }
            None => worst.note("sqrt", f64::INFINITY, allowed, kind),
        }
    }
    worst.judge(space.name);
}
