//! Conformal spacetime against the coordinate formulas of the conformal group, exactly.
#![cfg(all(feature = "conformal-spacetime", feature = "spacetime"))]

use ga_core::Rational;
use ga_spaces::conformal_spacetime::{
    Bivector4, Event, Hyperboloid, Lorentz, Translator, Transversor, Vector4,
};
use ga_spaces::spacetime;
use proptest::prelude::*;

type Four = [Rational; 4];

fn exact() -> impl Strategy<Value = Rational> {
    (-6_i128..=6, 1_i128..=3).prop_map(|(n, d)| Rational::new(n, d))
}

fn four() -> impl Strategy<Value = Four> {
    [exact(), exact(), exact(), exact()]
}

/// A light-like displacement: t² = x² + y² + z² by the parametrisation of such quadruples.
fn light() -> impl Strategy<Value = Four> {
    [-3_i128..=3, -3..=3, -3..=3, -3..=3].prop_map(|[m, n, p, q]| {
        [
            m * m + n * n + p * p + q * q,
            m * m + n * n - p * p - q * q,
            2 * (m * q + n * p),
            2 * (n * q - m * p),
        ]
        .map(Rational::from_integer)
    })
}

fn dot(a: Four, b: Four) -> Rational {
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3]
}

fn add(a: Four, b: Four) -> Four {
    [0, 1, 2, 3].map(|i| a[i] + b[i])
}

fn event([t, x, y, z]: Four) -> Event<Rational> {
    Event::at(t, x, y, z)
}

fn vector([t, x, y, z]: Four) -> Vector4<Rational> {
    Vector4::new(t, x, y, z)
}

fn zero() -> Rational {
    Rational::from_integer(0)
}

proptest! {
    /// Events are null, and their inner product is −½ of the interval.
    #[test]
    fn events_measure_intervals(a in four(), b in four()) {
        prop_assert_eq!(event(a).norm_squared(), zero());
        let apart = add(a, b.map(|c| -c));
        prop_assert_eq!(event(a).interval(event(b)), dot(apart, apart));
    }

    /// Light leaves every event along its cone: the event read as an equation.
    #[test]
    fn light_lies_on_the_cone(a in four(), along in light()) {
        let cone = Hyperboloid::about(event(a), zero());
        let there = event(add(a, along));
        prop_assert_eq!(cone.scalar_product(there), zero());
        prop_assert_eq!(cone.interval(), Some(zero()));
    }

    /// (x + x² b)/(1 + 2 b·x + b² x²), or infinity where the denominator is zero; light stays
    /// light.
    #[test]
    fn special_conformal_transformations_keep_light(x in four(), b in four(), along in light()) {
        let bend = Transversor::by(vector(b));
        let y = add(x, along);
        let factor = |x: Four| {
            Rational::from_integer(1) + Rational::from_integer(2) * dot(b, x) + dot(b, b) * dot(x, x)
        };
        let image = |x: Four| bend.apply(event(x)).center();
        for point in [x, y] {
            let divisor = factor(point);
            let expected = (divisor != zero()).then(|| {
                event(add(point, b.map(|c| c * dot(point, point))).map(|c| c / divisor))
            });
            prop_assert_eq!(image(point), expected);
        }
        if let (Some(p), Some(q)) = (image(x), image(y)) {
            prop_assert_eq!(p.interval(q), zero());
        }
    }

    /// Any interval is divided by the factors of both events.
    #[test]
    fn intervals_scale_by_both_factors(x in four(), y in four(), b in four()) {
        let bend = Transversor::by(vector(b));
        let (p, q) = (bend.apply(event(x)), bend.apply(event(y)));
        if let (Some(p), Some(q)) = (p.center(), q.center()) {
            let factors = bend.apply(event(x)).no * bend.apply(event(y)).no;
            prop_assert_eq!(p.interval(q) * factors, event(x).interval(event(y)));
        }
    }

    /// The reflection in the hyperboloid of squared interval s about c is c + s (x−c)/(x−c)²;
    /// the light cone of the centre goes to infinity.
    #[test]
    fn hyperboloids_invert(c in four(), s in exact(), apart in four(), along in light()) {
        prop_assume!(s != zero());
        let hyperboloid = Hyperboloid::about(event(c), s);
        prop_assert_eq!(hyperboloid.interval(), Some(s));
        let image: Hyperboloid<Rational> = hyperboloid.apply(event(add(c, apart)));
        let square = dot(apart, apart);
        let expected = (square != zero())
            .then(|| event(add(c, apart.map(|d| d * s / square))));
        prop_assert_eq!(image.center(), expected);
        let lost: Hyperboloid<Rational> = hyperboloid.apply(event(add(c, along)));
        prop_assert_eq!(lost.center(), None);
    }

    /// Translations move events and keep their weight.
    #[test]
    fn translators_shift(x in four(), v in four()) {
        let image: Event<Rational> = Translator::by(vector(v)).apply(event(x));
        prop_assert_eq!(image, event(add(x, v)));
    }

    /// Lorentz transformations are those of the algebra of spacetime.
    #[test]
    fn lorentz_transformations_agree_with_spacetime(
        g in [-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0],
        x in [-5.0..5.0, -5.0..5.0, -5.0..5.0, -5.0..5.0],
    ) {
        let [a, b, c, d, e, f]: [f64; 6] = g;
        let [t, x, y, z]: [f64; 4] = x;
        let here = Lorentz::from_generator(Bivector4::new(a, b, c, d, e, f));
        let there = (spacetime::Bivector::new(a, b, c, d, e, f) * 0.5).exp();
        let image: Event = here.apply(Event::at(t, x, y, z));
        let expected: spacetime::Vector = there.apply(spacetime::Vector::new(t, x, y, z));
        for (a, b) in image.position().to_array().into_iter().zip(expected.to_array()) {
            prop_assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{} is not {}", a, b);
        }
    }
}

/// A hyperplane and infinity have no centre and no interval.
#[test]
fn hyperplanes_have_no_centre() {
    let now = Hyperboloid::new(0.0, 1.0, 0.0, 0.0, 0.0, 0.0);
    let infinity = Hyperboloid::new(0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    for element in [now, infinity, Hyperboloid::default()] {
        assert_eq!(element.center(), None);
        assert_eq!(element.interval(), None);
    }
    // Reflection in t = 0 turns time.
    let image: Hyperboloid = now.apply(Event::at(3.0, 1.0, 2.0, 0.0));
    assert_eq!(image.center(), Some(Event::at(-3.0, 1.0, 2.0, 0.0)));
}
