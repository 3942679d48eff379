//! exp, log and sqrt of every family against arithmetic of 32 digits.

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

/// Every function on every family.
pub fn check<B, R>(space: &Space)
where
    B: Element<Number = f64> + Exponential<Output = R>,
    R: Element<Number = f64> + Logarithm<Output = B> + SquareRoot<Output = R>,
{
    let mut worst = Worst::default();
    for sample in families(space) {
        let bivector: B = space.rounded(&sample.bivector);
        let exact = space.value(&bivector);
        // Not in the type: a part of the bivector is dropped.
        if error(&exact, &sample.bivector) > 1e-15 {
            continue;
        }
        let exponential = space.exp(&exact);
        let generated = bivector.exp();
        let kind = &sample.kind;
        let found = error(&space.value(&generated), &exponential);
        // An angle or rapidity is known to its rounding only.
        let size = largest(&exact).max(10.0) / 10.0;
        worst.note("exp", found, 1e-14 * size, kind);
        // The logarithm of the exponential rounded to double precision.
        let versor: R = space.rounded(&exponential);
        let allowed = (1e-13 + 1e-15 / sample.gap) * sample.growth.powi(2);
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
