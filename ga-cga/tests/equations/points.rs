//! §2.4.3.1: points as null vectors, (2.44) to (2.46).

use ga_cga::{DualSphere, Point, Scalar, Vector3};
use ga_core::Rational;

use super::figures::{Direction, infinity, origin, ratio, wide};
use super::samples::{close, each, near};

/// **x** ↦ p = n_o + **x** + ½**x**² n_∞, and back.
#[test]
fn equation_2_44_the_point_at_a_position() {
    each(|samples| {
        let x: Direction = samples.element();
        let square = (x * x).s;
        let point = origin() + DualSphere::from(x) + infinity() * (square * ratio(1, 2));
        assert_eq!(DualSphere::from(Point::from(x)), point);
        assert_eq!(Point::from(x).position(), x);
        // Stereographic projection: in the basis e₊, e₋ the point over its e₋ part lies on
        // the unit sphere, where the line from the pole through **x** meets it.
        let height = ratio(1, 2) + square * ratio(1, 2);
        let [plus, minus] = [
            origin() - infinity() * ratio(1, 2),
            origin() + infinity() * ratio(1, 2),
        ];
        assert_eq!((point | minus).s, -height);
        let up = (point | plus).s / height;
        let beside = x * (ratio(1, 1) / height);
        assert_eq!(beside.norm_squared() + up * up, ratio(1, 1));
        let foot = beside * (ratio(1, 1) / (ratio(1, 1) + up));
        let other_foot = beside * (ratio(1, 1) / (ratio(1, 1) - up));
        assert!(foot == x || other_foot == x);
    });
}

/// p² = 0, and a vector with any other n_∞ part is not null.
#[test]
fn equation_2_45_points_are_null() {
    each(|samples| {
        let x: Direction = samples.element();
        let p = Point::from(x);
        assert_eq!(wide(p * p), wide(Scalar::<Rational>::default()));
        let elsewhere = DualSphere::from(p) + infinity() * samples.number::<Rational>();
        assert_ne!((elsewhere * elsewhere).s, Rational::default());
    });
}

/// p_a·p_b = −½δ², δ the Euclidean distance; of the root, the tolerance is 1e-14.
#[test]
fn equation_2_46_inner_products_of_points_are_distances() {
    each(|samples| {
        let [a, b]: [Direction; 2] = std::array::from_fn(|_| samples.element());
        let difference = (a - b).to_array().map(|part| part * part);
        let square: Rational = difference.into_iter().sum();
        let inner = Point::from(a) | Point::from(b);
        assert_eq!(inner, Scalar::new(square * ratio(-1, 2)));
        let [a, b]: [Vector3; 2] = std::array::from_fn(|_| samples.element());
        let distance = Point::from(a).distance(Point::from(b));
        near(
            (-2.0 * (Point::from(a) | Point::from(b)).s).sqrt(),
            distance,
            1e-14,
        );
        close(Scalar::new(distance), Scalar::new((a - b).norm()), 1e-14);
    });
}
