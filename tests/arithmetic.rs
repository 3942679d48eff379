//! Sums of different types, references on both sides, and narrowing: with a tolerance, or exactly.

#![expect(clippy::op_ref, reason = "references on both sides are what is tested")]

ga::define_algebra!(R3);

use ga::core::Element;
use r3::{Bivector, Even, Multivector, Scalar, Vector};

#[test]
fn sums_of_different_types_widen_to_the_smallest() {
    let rotor: Even = Scalar::new(1.0) + Bivector::new(0.0, 2.0, 0.0);
    assert_eq!(rotor, Even::new(1.0, 0.0, 2.0, 0.0));
    let all: Multivector = rotor - Vector::new(1.0, 0.0, 0.0);
    assert_eq!(all.to_string(), "1 - 1 e1 + 2 e13");
}

#[test]
fn products_take_references_on_both_sides() {
    let (a, b) = (Vector::new(1.0, 2.0, 3.0), Vector::new(4.0, 5.0, 6.0));
    assert_eq!(&a * &b, a * b);
    assert_eq!(a ^ &b, a ^ b);
    assert_eq!(&a | b, a | b);
    assert_eq!(&a + &b, a + b);
    assert_eq!(-&a, -a);
    assert_eq!(&a * 2.0, 2.0 * &a);
    assert_eq!(a / &b, a / b);
}

#[test]
fn literals_keep_inferring_in_single_precision() {
    let a: Vector<f32> = Vector::new(1.0, 2.0, 3.0);
    assert_eq!(a * 2.0, Vector::new(2.0, 4.0, 6.0));
    assert_eq!(a / 2.0, Vector::new(0.5, 1.0, 1.5));
}

#[test]
fn narrowing_asks_for_a_tolerance() {
    let nearly = Even::new(1e-9, 1.0, 0.0, 0.0);
    let plane: Bivector = nearly.try_into().expect("1e-9 is negligible");
    assert_eq!(plane, Bivector::new(1.0, 0.0, 0.0));
    let strict: Result<Bivector, _> = nearly.narrow(1e-12);
    assert_eq!(strict.unwrap_err().blade, ga::core::Blade::SCALAR);
}

#[test]
fn exact_numbers_narrow_where_nothing_is_lost() {
    use ga::cga::cga3::{Even as Versor, Point, Translator, Vector3};
    use ga::core::{Dual, Rational};
    let [one, three, tiny] = [(1, 1), (3, 1), (1, 1_000_000_000_000)]
        .map(|(numerator, denominator)| Rational::new(numerator, denominator));
    let plane = Bivector::new(one, Rational::ZERO, three);
    assert_eq!(Bivector::try_from(Even::from(plane)), Ok(plane));
    let nearly = Even::from(plane) + Scalar::new(tiny);
    let refused = Bivector::try_from(nearly).unwrap_err();
    assert_eq!(refused.blade, ga::core::Blade::SCALAR);
    // A fixed coefficient has to have its value exactly.
    let translator = Translator::new(one, three, tiny);
    assert_eq!(
        Translator::try_from(Versor::from(translator)),
        Ok(translator)
    );
    assert!(Translator::try_from(Versor::from(translator) * three).is_err());
    let point: Point<Rational> = translator.apply(Point::from(Vector3::new(one, one, three)));
    assert_eq!(Point::try_from(point * one), Ok(point));
    assert!(Point::try_from(point * three).is_err());
    // Derivatives of exact numbers, which compare by value.
    let moving = Even::from(plane).map(Dual::constant);
    assert!(Bivector::try_from(moving).is_ok());
    assert!(Bivector::try_from(nearly.map(Dual::constant)).is_err());
}

/// The largest coefficient may be so large that twice its size is not finite.
#[test]
fn narrowing_neglects_nothing_beside_what_overflows() {
    let large = |scalar: f64| Even::new(scalar, f64::MAX, -f64::MAX, 0.0);
    assert!(Bivector::try_from(large(1e300)).is_ok());
    for scalar in [1e304, f64::MAX, f64::INFINITY, f64::NAN] {
        assert!(Bivector::try_from(large(scalar)).is_err(), "{scalar}");
        assert!(large(scalar).narrow::<Bivector>(1e-6).is_err(), "{scalar}");
    }
    let infinite = Even::new(1.0, f64::INFINITY, 0.0, 0.0);
    assert!(Bivector::try_from(infinite).is_err());
    assert!(infinite.narrow::<Bivector>(1e-6).is_err());
}

/// Each lane is judged against its own largest coefficient.
#[test]
fn lanes_narrow_where_every_lane_does() {
    use wide::f64x4;
    const LANES: [usize; 4] = [0, 1, 2, 3];
    const SIZES: [f64; 4] = [1.0, 1e-9, 1e9, 1e300];
    let rotor = |scalars: [f64; 4]| {
        Even::from_fn(|i| {
            f64x4::new(LANES.map(|lane| [scalars[lane], SIZES[lane], 0.0, -SIZES[lane]][i]))
        })
    };
    assert!(Bivector::try_from(rotor([1e-9, 1e-18, 1.0, 1e290])).is_ok());
    assert!(Bivector::try_from(rotor([1e-9, 1e-9, 1.0, 1e290])).is_err());
    assert!(Bivector::try_from(rotor([0.0, 0.0, 0.0, f64::NAN])).is_err());
}

ga::define_algebra! {
    /// Four oblique vectors whose products need fractions.
    pub mod oblique4: R4 {
        basis { a, b, c, d }
        metric { a^2 = 1, b^2 = 3/2, c^2 = 2, d^2 = 1, a.b = 1/2, c.d = 1/3 }
    }
}

/// Products that hand on to wider ones ask for fractions where those do.
#[test]
fn fractional_metrics_hand_products_on() {
    use ga::core::Rational;
    use oblique4::{Bivector, Even, Multivector, Vector};
    let [one, two] = [1, 2].map(Rational::from);
    let zero = Rational::ZERO;
    let vector = Vector::new(one, two, zero, one);
    let plane = Bivector::new(one, zero, two, zero, zero, one);
    let whole: Multivector<Rational> = vector.geometric(Multivector::from(plane));
    assert_eq!(whole, Multivector::from(vector.geometric(plane)));
    let even: Even<Rational> = plane.geometric(Even::from(plane));
    assert_eq!(even, plane.geometric(plane));
}
