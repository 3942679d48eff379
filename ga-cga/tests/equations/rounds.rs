//! §2.4.3.3, second half: point pairs taken apart, and rounds with their surrounds, (2.57) to
//! (2.61).

use ga_cga::{Circle, DualSphere, Line, Point, PointPair, Scalar, Sphere};
use ga_core::Rational;

use super::figures::{Circular, exactly, infinity, ratio, wide};
use super::samples::each;

/// (κ ± √κ²)/(−n_∞·κ), for a given root.
fn end(pair: PointPair<Rational>, root: Rational) -> DualSphere<Rational> {
    let shifted = wide(pair) + wide(Scalar::new(root));
    let divisor = -(infinity() | pair);
    exactly(shifted * wide(divisor.inverse().expect("two points at a distance")))
}

/// p∓ = (κ ± √|κ²|)/(−n_∞·κ): for κ = p₋∧p₊ the + root is p₊ and the − root p₋, the other
/// way round than printed. Where κ² < 0 there are no null vectors to find.
#[test]
fn equation_2_57_a_point_pair_splits_into_its_points() {
    each(|samples| {
        let [first, second, ..] = Circular::random(samples).points();
        let weight: Rational = samples.positive(5);
        let pair: PointPair<Rational> = (first ^ second) * weight;
        // κ² = w²(p₋·p₊)² has an exact root.
        let root = -(first | second).s * weight;
        assert_eq!((pair * pair).s, root * root);
        assert_eq!(end(pair, root), second.into());
        assert_eq!(end(pair, -root), first.into());

        let pair = pair_about(
            first.position(),
            Circular::random(samples).frame[0],
            ratio(-4, 1),
        );
        assert!((pair * pair).s < Rational::default());
        let not_null = end(pair, ratio(2, 1));
        assert_ne!((not_null * not_null).s, Rational::default());
    });
}

/// The pair about a centre along a direction, with a squared radius.
fn pair_about(
    center: super::figures::Direction,
    along: super::figures::Direction,
    square: Rational,
) -> PointPair<Rational> {
    let sphere = DualSphere::about(Point::from(center), -square);
    exactly(sphere ^ (sphere << (along ^ infinity())))
}

/// κ = (Λ*∧σ)*: a line meets a sphere in a pair with the orientation of the line, so that the
/// − root is the first point along it. Undualising instead turns the order round.
#[test]
fn equation_2_58_a_line_meets_a_sphere_in_a_point_pair() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, ..] = figure.points_of_sphere();
        let square = figure.radius * figure.radius;
        let sphere = DualSphere::about(Point::from(figure.center), square);
        // The line runs through a to b; it is given by other points of it.
        let step = b.position() - a.position();
        let from = Point::from(a.position() - step * samples.positive(4));
        let to = Point::from(a.position() + step * samples.positive(4));
        let line: Line<Rational> = exactly(from ^ to ^ infinity());
        let dual = line.dual() ^ sphere;
        let pair: PointPair<Rational> = dual.dual();
        let expected: PointPair<Rational> = a ^ b;
        let weight = (pair | expected).s / (expected | expected).s;
        assert_eq!(pair, expected * weight);
        assert!(weight > Rational::default());
        let root = -(a | b).s * weight;
        assert_eq!(end(pair, -root), a.into());
        assert_eq!(end(pair, root), b.into());
        assert_eq!(dual.undual(), -pair);
    });
}

/// σ∧(σ·(−Â n_∞)) is a round in the direction **A** about the centre of σ: imaginary for a real
/// sphere σ, real for the imaginary σ′ of the same size.
#[test]
fn equation_2_59_rounds_from_a_sphere_and_a_direction() {
    each(|samples| {
        let figure = Circular::random(samples);
        let center = Point::from(figure.center);
        let square = figure.radius * figure.radius;
        let real = DualSphere::about(center, square);
        let imaginary = DualSphere::about(center, -square);
        let [u, v, _] = figure.frame;

        // A vector: −Â = A.
        let pair = |sphere: DualSphere<Rational>| -> PointPair<Rational> {
            exactly(
                sphere ^ (sphere | exactly::<_, PointPair<Rational>>(-u.involute() ^ infinity())),
            )
        };
        let ends =
            [-1, 1].map(|sign| Point::from(figure.center + u * (figure.radius * ratio(sign, 1))));
        let expected: PointPair<Rational> = ends[0] ^ ends[1];
        let found = pair(imaginary);
        let weight = (found | expected).s / (expected | expected).s;
        assert_eq!(found, expected * weight);
        assert_eq!(squared_radius(pair(imaginary), 1), square);
        assert_eq!(squared_radius(pair(real), 1), -square);

        // A bivector: −Â = −A.
        let circle = |sphere: DualSphere<Rational>| -> Circle<Rational> {
            exactly(
                sphere
                    ^ (sphere | exactly::<_, Circle<Rational>>(-(u ^ v).involute() ^ infinity())),
            )
        };
        for p in figure.points() {
            assert_eq!(p ^ circle(imaginary), Sphere::default());
        }
        assert_eq!(squared_radius(circle(imaginary), -1), square);
        assert_eq!(squared_radius(circle(real), -1), -square);
    });
}

/// ±X²/(X∧n_∞)², the squared radius of pairs and, with the minus, of circles.
fn squared_radius<X>(round: X, sign: i128) -> Rational
where
    X: Into<ga_cga::Multivector<Rational>>,
{
    let round = wide(round);
    let carrier = round ^ wide(infinity());
    (round * round).s / (carrier * carrier).s * ratio(sign, 1)
}

/// σ = κ/(−n_∞·κ) is a dual sphere about the centre of κ; of a real pair or circle it is the
/// imaginary one, σ² = −r², not the surround of (2.61).
#[test]
fn equation_2_60_the_imaginary_sphere_of_a_round() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [_, _, normal] = figure.frame;
        let [a, b, c, ..] = figure.points();
        let square = figure.radius * figure.radius;
        let imaginary = DualSphere::about(Point::from(figure.center), -square);
        let sphere = |round: ga_cga::Multivector<Rational>| -> DualSphere<Rational> {
            let divisor = -(wide(infinity()) | round);
            exactly(round * divisor.inverse().expect("a round has a carrier"))
        };
        assert_eq!(sphere(wide(a ^ b ^ c)), imaginary);
        let end = |sign| Point::from(figure.center + normal * (figure.radius * ratio(sign, 1)));
        assert_eq!(sphere(wide(end(-1) ^ end(1))), imaginary);
        // The centre is n_∞ reflected in the round; its position is the part off E.
        let center = (a ^ b ^ c).apply(infinity());
        let weight = -(center | infinity()).s;
        assert_eq!(
            center,
            DualSphere::from(Point::from(figure.center)) * weight
        );
        let e = infinity() ^ super::figures::origin();
        let off = exactly::<_, super::figures::Direction>(imaginary.reject(e));
        assert_eq!(off, figure.center);
    });
}

/// σ = κ/(κ∧n_∞) is the surround, the smallest sphere that holds the round: with weight 1 for
/// circles, −1 for pairs and spheres, so it is to be normalised.
#[test]
fn equation_2_61_the_surround_of_a_round() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [_, _, normal] = figure.frame;
        let square = figure.radius * figure.radius;
        let surround = DualSphere::about(Point::from(figure.center), square);
        let sphere = |round: ga_cga::Multivector<Rational>| -> DualSphere<Rational> {
            let carrier = round ^ wide(infinity());
            exactly(round * carrier.inverse().expect("a round has a carrier"))
        };
        let [a, b, c, ..] = figure.points();
        assert_eq!(sphere(wide(a ^ b ^ c)), surround);
        let end = |sign| Point::from(figure.center + normal * (figure.radius * ratio(sign, 1)));
        assert_eq!(sphere(wide(end(-1) ^ end(1))), -surround);
        let [a, b, c, d, ..] = figure.points_of_sphere();
        assert_eq!(sphere(wide(a ^ b ^ c ^ d)), -surround);
    });
}
