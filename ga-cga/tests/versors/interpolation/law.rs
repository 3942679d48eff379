//! What every path between elements must obey, in either precision.

use crate::random::size;
use core::fmt::Debug;
use ga_cga::interpolate::{Carry, ElementPath, NoPath, Way};
use ga_core::ops::{Apply, Element};
use ga_core::{Real, Scalar};

/// Numbers that can be compared with a tolerance.
pub trait Precision: Real + PartialOrd + Into<f64> {}
impl<T: Real + PartialOrd + Into<f64>> Precision for T {}

/// The largest difference of coefficients, over the largest coefficient.
pub fn apart<X: Element<Number: Precision>>(a: X, b: X) -> f64 {
    let difference = if X::FIXED.is_empty() {
        size(X::from_fn(|i| a.at(i) - b.at(i)))
    } else {
        let pairs = (0..X::BLADES.len()).map(|i| (a.at(i) - b.at(i)).abs());
        pairs.fold(X::Number::ZERO, |a, b| if a < b { b } else { a })
    };
    let [difference, a, b]: [f64; 3] = [difference, size(a), size(b)].map(Into::into);
    difference / (a + b)
}

/// The element of another weight; of no other where it is fixed.
pub fn weighted<X: Element>(x: X, weight: X::Number) -> X {
    if !X::FIXED.is_empty() {
        return x;
    }
    X::from_fn(|i| x.at(i) * weight)
}

/// The same element in single precision.
pub fn single<X, Y>(x: X) -> Y
where
    X: Element<Number = f64>,
    Y: Element<Number = f32>,
{
    Y::from_fn(|i| x.at(i) as f32)
}

/// A path starts at its start, ends at the target, goes on from everywhere in the same way, and
/// never leaves the finite numbers.
pub fn obeys<X>(path: ElementPath<X>, from: X, to: X, tolerance: f64)
where
    X: Carry<Number: Precision> + Debug,
{
    let number = X::Number::from_f64;
    let near = |a: X, b: X, what: &str| {
        let off = apart(a, b);
        assert!(
            off < tolerance,
            "{what}: {off} from {from:?} to {to:?}, {a:?} is not {b:?}"
        );
    };
    near(path.at(number(0.0)), from, "start");
    near(path.at(number(1.0)), to, "end");
    for (s, t) in [(0.25, 0.5), (0.7, 0.3), (-0.2, 0.9)] {
        let step = path.versor_at(number(s)).apply(path.at(number(t)));
        let step = weighted(step, path.weight_at(number(s)));
        near(step, path.at(number(s + t)), "composition");
    }
}

/// The ways to the target, each of which is a path that ends there; the reasons of the others.
pub fn ways<X>(from: X, to: X, tolerance: f64) -> [Option<NoPath>; 2]
where
    X: Carry<Number: Precision> + Debug,
{
    [Way::Short, Way::Long].map(|way| match from.path_to(to, way) {
        Ok(path) => {
            obeys(path, from, to, tolerance);
            None
        }
        Err(reason) => Some(reason),
    })
}

/// Both ways lead to the target.
pub const BOTH: [Option<NoPath>; 2] = [None, None];
/// The short way leads to the target, and there is no other.
pub const STRAIGHT: [Option<NoPath>; 2] = [None, Some(NoPath::DoesNotTurn)];

/// Neither way leads to the target, for the same reason.
pub const fn neither(reason: NoPath) -> [Option<NoPath>; 2] {
    [Some(reason), Some(reason)]
}
