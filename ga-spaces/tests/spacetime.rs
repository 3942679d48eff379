//! Spacetime against the textbook's formulas of special relativity, written in components.
#![cfg(feature = "spacetime")]

use ga_core::Rational;
use ga_spaces::spacetime::{
    Bivector, Boost, Character, Lorentz, RelativeBivector, RelativeVector, Rotation, Vector,
    VelocityError, compose_velocities, thomas_rotation,
};
use proptest::prelude::*;

type Space = [f64; 3];

fn dot(a: Space, b: Space) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Space, b: Space) -> Space {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn combine(a: f64, u: Space, b: f64, v: Space) -> Space {
    [0, 1, 2].map(|i| a * u[i] + b * v[i])
}

fn gamma(v: Space) -> f64 {
    1.0 / (1.0 - dot(v, v)).sqrt()
}

/// Einstein's addition of velocities.
fn einstein_sum(u: Space, v: Space) -> Space {
    let (g, uv) = (gamma(u), dot(u, v));
    let along = (1.0 + g / (1.0 + g) * uv) / (1.0 + uv);
    combine(along, u, 1.0 / (g * (1.0 + uv)), v)
}

fn relative([x, y, z]: Space) -> RelativeVector {
    RelativeVector::new(x, y, z)
}

/// Velocities up to 0.95 of light's.
fn velocity() -> impl Strategy<Value = Space> {
    ([-1.0..1.0, -1.0..1.0, -1.0..1.0], 0.0..0.95).prop_filter_map(
        "a direction",
        |(d, speed): (Space, f64)| {
            let size = dot(d, d).sqrt();
            (size > 1e-3).then(|| d.map(|c| c * speed / size))
        },
    )
}

fn close(a: f64, b: f64, tolerance: f64) -> Result<(), TestCaseError> {
    prop_assert!(
        (a - b).abs() <= tolerance * (1.0 + b.abs()),
        "{a} is not {b}"
    );
    Ok(())
}

fn small() -> impl Strategy<Value = Rational> {
    (-12_i128..=12, 1_i128..=6).prop_map(|(n, d)| Rational::new(n, d))
}

fn exact_vector() -> impl Strategy<Value = Vector<Rational>> {
    (small(), small(), small(), small()).prop_map(|(t, x, y, z)| Vector::new(t, x, y, z))
}

/// A half velocity of exact coordinates within the unit ball.
fn exact_half_velocity() -> impl Strategy<Value = RelativeVector<Rational>> {
    let part = || (-4_i128..=4).prop_map(|n| Rational::new(n, 7));
    (part(), part(), part()).prop_map(|(x, y, z)| RelativeVector::new(x, y, z))
}

proptest! {
    /// A boost of velocity v moves an event as Lorentz' formulas say.
    #[test]
    fn boosts_are_lorentz_transformations(
        v in velocity(), t in -9.0..9.0, place in [-9.0..9.0, -9.0..9.0, -9.0..9.0],
    ) {
        let boost = Boost::with_velocity(relative(v)).expect("slower than light");
        let image: Vector = boost.apply(Vector::new(t, place[0], place[1], place[2]));
        let (g, along) = (gamma(v), dot(v, place));
        close(image.t, g * (t + along), 1e-12)?;
        let factor = g * g / (1.0 + g) * along + g * t;
        let expected = combine(1.0, place, factor, v);
        for (a, b) in [image.x, image.y, image.z].into_iter().zip(expected) {
            close(a, b, 1e-11)?;
        }
    }

    /// The velocity of the composed boosts is Einstein's sum.
    #[test]
    fn velocities_add_as_einstein_says(u in velocity(), v in velocity()) {
        let sum = compose_velocities(relative(u), relative(v)).expect("slower than light");
        for (a, b) in sum.to_array().into_iter().zip(einstein_sum(u, v)) {
            close(a, b, 1e-13)?;
        }
        prop_assert!(sum.scalar_product(sum) < 1.0);
    }

    /// cos ε = (1 + γ + γᵤ + γᵥ)²/((1+γ)(1+γᵤ)(1+γᵥ)) − 1, in the plane of u and v against
    /// their sense.
    #[test]
    fn boosts_compose_with_thomas_rotation(u in velocity(), v in velocity()) {
        let turn = thomas_rotation(relative(u), relative(v)).expect("slower than light");
        let (gu, gv) = (gamma(u), gamma(v));
        let g = gu * gv * (1.0 + dot(u, v));
        let cosine = (1.0 + g + gu + gv).powi(2) / ((1.0 + g) * (1.0 + gu) * (1.0 + gv)) - 1.0;
        close(turn.angle().cos(), cosine, 1e-11)?;
        let axis = cross(u, v);
        let image: Vector = turn.apply(Vector::new(0.0, u[0], u[1], u[2]));
        let moved = cross(u, [image.x, image.y, image.z]);
        prop_assert!(dot(axis, moved) <= 1e-12);
        // Both factors together are the two boosts.
        let sum = compose_velocities(relative(u), relative(v)).expect("slower than light");
        let one: Lorentz = Boost::with_velocity(sum).expect("slower than light") * turn;
        let both = Boost::with_velocity(relative(u)).expect("slower than light")
            * Boost::with_velocity(relative(v)).expect("slower than light");
        for (a, b) in one.to_array().into_iter().zip(both.to_array()) {
            close(a, b, 1e-11)?;
        }
    }

    /// Intervals are the same for all observers, exactly.
    #[test]
    fn intervals_are_invariant(
        a in exact_vector(), b in exact_vector(),
        u in exact_half_velocity(), v in exact_half_velocity(),
    ) {
        let both = Boost::with_half_velocity(u) * Boost::with_half_velocity(v);
        prop_assume!(both.norm_squared() != Rational::from_integer(0));
        let (c, d): (Vector<Rational>, Vector<Rational>) = (both.apply(a), both.apply(b));
        prop_assert_eq!((a - b).norm_squared(), (c - d).norm_squared());
        prop_assert_eq!(a.scalar_product(b), c.scalar_product(d));
    }

    /// The polar split is exact: B R is the transformation up to a positive factor.
    #[test]
    fn transformations_split_exactly(u in exact_half_velocity(), v in exact_half_velocity()) {
        let both = Boost::with_half_velocity(u) * Boost::with_half_velocity(v);
        let (boost, turn) = both.boost_and_rotation().expect("slower than light");
        let again: Lorentz<Rational> = boost * turn;
        prop_assert_eq!(again, both);
        let still: Vector<Rational> = turn.apply(Vector::observer());
        prop_assert_eq!(still, Vector::observer());
    }

    /// 1 + w is the boost to 2w/(1 + w²), exactly.
    #[test]
    fn half_velocities_compose_with_themselves(w in exact_half_velocity()) {
        let moved: Vector<Rational> = Boost::with_half_velocity(w).apply(Vector::observer());
        let square = w.scalar_product(w);
        let expected = w * (Rational::from_integer(2) / (square + 1));
        prop_assert_eq!(moved.velocity(), Some(expected));
    }

    /// A boost along x mixes the fields across it: E' = γ(E + …), and both invariants stay.
    #[test]
    fn fields_transform(
        v in -0.9..0.9, e in [-5.0..5.0, -5.0..5.0, -5.0..5.0], b in [-5.0..5.0, -5.0..5.0, -5.0..5.0],
    ) {
        // F = E + I B with I = t∧x∧y∧z and B as a relative vector.
        let field = |e: Space, b: Space| -> Bivector {
            let magnetic = relative(b).undual();
            Bivector::from(relative(e)) + Bivector::from(magnetic)
        };
        let boost = Boost::with_velocity(RelativeVector::new(v, 0.0, 0.0)).expect("slower");
        let moved: Bivector = boost.apply(field(e, b));
        // Seen by the observer, the field of a source at rest that now moves with v.
        let g = gamma([v, 0.0, 0.0]);
        let electric = [e[0], g * (e[1] + v * b[2]), g * (e[2] - v * b[1])];
        let magnetic = [b[0], g * (b[1] - v * e[2]), g * (b[2] + v * e[1])];
        let expected = field(electric, magnetic);
        for (a, b) in moved.to_array().into_iter().zip(expected.to_array()) {
            close(a, b, 1e-11)?;
        }
    }

    /// No vector of any kind panics, and what is not finite is an error.
    #[test]
    fn any_velocity_is_answered(v in [any::<f64>(), any::<f64>(), any::<f64>()]) {
        let velocity = relative(v);
        match Boost::with_velocity(velocity) {
            Ok(boost) => prop_assert!(boost.to_array().into_iter().all(f64::is_finite)),
            Err(VelocityError::NotFinite) => {
                prop_assert!(!v.into_iter().all(f64::is_finite));
            }
            Err(_) => prop_assert!(v.into_iter().any(|c| c.abs() > 0.5)),
        }
    }
}

/// k = √((1+v)/(1−v)): light from a source that comes nearer is bluer.
#[test]
fn light_is_shifted_and_stays_light() {
    let light = Vector::new(1.0, 1.0, 0.0, 0.0);
    let moved: Vector = Boost::with_velocity(RelativeVector::new(0.6, 0.0, 0.0))
        .expect("slower than light")
        .apply(light);
    assert!((moved.t - 2.0).abs() < 1e-15);
    assert!(moved.norm_squared().abs() < 1e-14);
    let across = Vector::new(1.0, 0.0, 1.0, 0.0);
    let exact = Boost::with_half_velocity(
        RelativeVector::new(1, 0, 0).map(|n: i64| Rational::new(n.into(), 3)),
    );
    let aberrated: Vector<Rational> =
        exact.apply(across.map(|c: f64| Rational::from_integer(c as i128)));
    // Seen from the ground the light leans forward: cos θ = v = 3/5.
    assert_eq!(aberrated.x / aberrated.t, Rational::new(3, 5));
    assert_eq!(aberrated.character(), Some(Character::Lightlike));
}

/// Rapidities along one direction add.
#[test]
fn rapidities_add() {
    let direction: RelativeVector = RelativeVector::new(2.0, -1.0, 2.0) / 3.0;
    let twice = Boost::with_rapidity(direction * 0.7) * Boost::with_rapidity(direction * 1.1);
    let once = Boost::with_rapidity(direction * 1.8);
    assert!(
        (twice - Lorentz::from(once))
            .to_array()
            .iter()
            .all(|c| c.abs() < 1e-14)
    );
    let velocity = once
        .apply(Vector::observer())
        .velocity()
        .expect("a duration");
    assert!((velocity.scalar_product(velocity).sqrt() - 1.8_f64.tanh()).abs() < 1e-14);
}

/// The rotation x∧y takes x to y.
#[test]
fn rotations_turn_in_their_sense() {
    let plane = RelativeBivector::new(3.0, 0.0, 0.0);
    let quarter = Rotation::turn(plane, std::f64::consts::FRAC_PI_2).expect("an area");
    let image: Vector = quarter.apply(Vector::new(0.0, 1.0, 0.0, 0.0));
    assert!((image.y - 1.0).abs() < 1e-15 && image.x.abs() < 1e-15);
    assert!((quarter.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    assert_eq!(Rotation::turn(plane * 0.0, 1.0), None);
}

/// Light, faster than light, no number, no duration: each has its own answer.
#[test]
fn what_no_observer_does_is_an_error() {
    let along = |x: f64| RelativeVector::new(0.0, x, 0.0);
    let cases = [
        (1.0, VelocityError::Lightlike),
        (-1.0, VelocityError::Lightlike),
        (1.0 + 1e-15, VelocityError::Superluminal),
        (1e300, VelocityError::Superluminal),
        (f64::INFINITY, VelocityError::NotFinite),
        (f64::NAN, VelocityError::NotFinite),
    ];
    for (speed, error) in cases {
        assert_eq!(Boost::with_velocity(along(speed)), Err(error), "{speed}");
        assert_eq!(along(speed).four_velocity(), Err(error), "{speed}");
        assert_eq!(
            compose_velocities(along(0.5), along(speed)),
            Err(error),
            "{speed}"
        );
        assert_eq!(
            thomas_rotation(along(speed), along(0.5)),
            Err(error),
            "{speed}"
        );
    }
    assert_eq!(Vector::new(0.0, 1.0, 0.0, 0.0).velocity(), None);
    assert_eq!(Boost::to_four_velocity(-Vector::<f64>::observer()), None);
    assert_eq!(Lorentz::<f64>::default().boost_and_rotation(), None);
    let still = Boost::with_velocity(along(0.0)).expect("at rest");
    assert_eq!(still, Boost::new(1.0, 0.0, 0.0, 0.0));
}

/// All observers agree on the kind of a separation.
#[test]
fn vectors_have_a_character() {
    let kind = |t, x| {
        Vector::new(t, x, 0, 0)
            .map(|n: i64| Rational::from_integer(n.into()))
            .character()
    };
    assert_eq!(kind(2, 1), Some(Character::Future));
    assert_eq!(kind(-2, 1), Some(Character::Past));
    assert_eq!(kind(1, 2), Some(Character::Spacelike));
    assert_eq!(kind(-2, 2), Some(Character::Lightlike));
    assert_eq!(kind(0, 0), Some(Character::Zero));
}
