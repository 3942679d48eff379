//! §2.4.1 and §2.4.2: the null basis and the Minkowski plane, (2.39) to (2.43).

use ga_cga::{MinkowskiPlane, PointPair, Scalar};
use ga_core::Rational;

use super::euclidean::r1_1;
use super::figures::{infinity, origin, ratio, wide};
use super::samples::unit;

/// e₊ and e₋ of the conformal model.
fn diagonal() -> [ga_cga::DualSphere<Rational>; 2] {
    let half = infinity() * ratio(1, 2);
    [origin() - half, origin() + half]
}

fn number(value: i128) -> Scalar<Rational> {
    Scalar::new(Rational::from_integer(value))
}

/// n_∞ = e₋ − e₊ and n_o = (e₋ + e₊)/2 are null and have inner product −1; the caption of
/// Table 2.6 has them the wrong way round.
#[test]
fn equation_2_39_the_null_basis() {
    let [plus, minus]: [r1_1::Vector<Rational>; 2] = std::array::from_fn(unit);
    let infinity_here = minus - plus;
    let origin_here = (minus + plus) * ratio(1, 2);
    assert_eq!(infinity_here * infinity_here, r1_1::Even::default());
    assert_eq!(origin_here * origin_here, r1_1::Even::default());
    let minus_one = r1_1::Scalar::new(Rational::from_integer(-1));
    assert_eq!(infinity_here | origin_here, minus_one);
    assert_eq!(origin_here | infinity_here, minus_one);
    let [plus, minus] = diagonal();
    assert_eq!(minus - plus, infinity());
    assert_eq!((minus + plus) * ratio(1, 2), origin());
    assert_eq!(origin() | origin(), number(0));
    assert_eq!(infinity() | infinity(), number(0));
    assert_eq!(origin() | infinity(), number(-1));
    // The caption exchanges them, up to a factor.
    assert_eq!((minus - plus) * ratio(1, 2), infinity() * ratio(1, 2));
    assert_eq!(minus + plus, origin() * ratio(2, 1));
}

/// e₊ = n_o − n_∞/2 and e₋ = n_o + n_∞/2 square to 1 and −1 and are orthogonal to each other
/// and to Euclidean space (Tables 2.2 to 2.4).
#[test]
fn equation_2_40_the_diagonal_basis() {
    let [plus, minus] = diagonal();
    assert_eq!(plus | plus, number(1));
    assert_eq!(minus | minus, number(-1));
    assert_eq!(plus | minus, number(0));
    for axis in 1..=3 {
        let e: ga_cga::DualSphere<Rational> = unit(axis);
        assert_eq!(e | e, number(1));
        for other in [plus, minus, origin(), infinity()] {
            assert_eq!(e | other, number(0));
        }
    }
}

/// n_o n_∞ = −1 + E.
#[test]
fn equation_2_41_the_product_of_the_null_vectors() {
    let minkowski: MinkowskiPlane<Rational> = unit(0);
    assert_eq!(
        wide(origin() * infinity()),
        wide(number(-1)) + wide(minkowski)
    );
    assert_eq!(
        wide(infinity() * origin()),
        wide(number(-1)) - wide(minkowski)
    );
}

/// E = n_o∧n_∞ = e₊e₋.
#[test]
fn equation_2_42_the_minkowski_plane() {
    let minkowski: MinkowskiPlane<Rational> = unit(0);
    let [plus, minus] = diagonal();
    assert_eq!(origin() ^ infinity(), PointPair::from(minkowski));
    assert_eq!(wide(plus * minus), wide(minkowski));
}

/// E² = 1, while e_ij² = −1 and (e_i n_∞)² = (e_i n_o)² = 0.
#[test]
fn equation_2_43_the_minkowski_plane_squares_to_one() {
    let minkowski: MinkowskiPlane<Rational> = unit(0);
    assert_eq!(wide(minkowski * minkowski), wide(number(1)));
    for axis in 0..3 {
        let turn: ga_cga::Bivector3<Rational> = unit(axis);
        assert_eq!(wide(turn * turn), wide(number(-1)));
        let shift: ga_cga::DirectionVector<Rational> = unit(axis);
        assert_eq!(wide(shift * shift), wide(number(0)));
        let bend: ga_cga::TangentVector<Rational> = unit(axis);
        assert_eq!(wide(bend * bend), wide(number(0)));
    }
}
