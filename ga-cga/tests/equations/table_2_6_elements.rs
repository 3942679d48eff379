//! Table 2.6, the elements: one test per row, from the scalar to the tangent trivector.

use ga_cga::{
    Bivector3, Circle, DirectionBivector, DirectionTrivector, DirectionVector, DualLine, DualPlane,
    DualSphere, FlatPoint, Line, MinkowskiPlane, Plane, Point, PointPair, Pseudoscalar, Scalar,
    Sphere, TangentBivector, TangentTrivector, TangentVector, Translator, Trivector3, cga3,
};
use ga_core::Rational;

use super::figures::{
    Circular, Direction, exactly, infinity, origin, position, pseudoscalar, ratio, wide,
};
use super::samples::{each, unit};

type Multivector = cga3::Multivector<Rational>;

/// The row's grade, and that no other is there.
fn has_grade(x: impl Into<Multivector>, grade: u32) {
    let x = x.into();
    assert_eq!(x.grade(grade), x);
    assert_ne!(x, Multivector::default());
}

/// Nothing.
fn zero() -> Multivector {
    Multivector::default()
}

/// Scalar α: it commutes with everything and scales it.
#[test]
fn table_2_6_scalar() {
    each(|samples| {
        let alpha: Rational = samples.number();
        let x: Multivector = samples.element();
        has_grade(Scalar::new(alpha), 0);
        assert_eq!(Scalar::new(alpha) * x, x * alpha);
        assert_eq!(x * Scalar::new(alpha), x * alpha);
    });
}

/// Vector **a** = α e₁ + β e₂ + γ e₃: its square is the Euclidean one.
#[test]
fn table_2_6_vector() {
    each(|samples| {
        let a: Direction = samples.element();
        let [alpha, beta, gamma] = a.to_array();
        let [e1, e2, e3]: [Direction; 3] = std::array::from_fn(unit);
        assert_eq!(e1 * alpha + e2 * beta + e3 * gamma, a);
        has_grade(a, 1);
        let square = alpha * alpha + beta * beta + gamma * gamma;
        assert_eq!(wide(a * a), wide(Scalar::new(square)));
    });
}

/// Bivector **B** = **a**∧**b**: the plane of both, with the square of minus the area squared.
#[test]
fn table_2_6_bivector() {
    each(|samples| {
        let [a, b]: [Direction; 2] = std::array::from_fn(|_| samples.element());
        let plane: Bivector3<Rational> = a ^ b;
        has_grade(plane, 2);
        assert_eq!(plane ^ (a * ratio(2, 1) - b), Trivector3::default());
        let inner = (a | b).s;
        let area = a.norm_squared() * b.norm_squared() - inner * inner;
        assert_eq!(wide(plane * plane), wide(Scalar::new(-area)));
    });
}

/// Trivector **I**₃ = **a**∧**b**∧**c**: the determinant of the three.
#[test]
fn table_2_6_trivector() {
    each(|samples| {
        let [a, b, c]: [Direction; 3] = std::array::from_fn(|_| samples.element());
        let volume: Trivector3<Rational> = a ^ b ^ c;
        has_grade(volume, 3);
        let ([a1, a2, a3], [b1, b2, b3]) = (a.to_array(), b.to_array());
        let [c1, c2, c3] = c.to_array();
        let determinant =
            a1 * (b2 * c3 - b3 * c2) + a2 * (b3 * c1 - b1 * c3) + a3 * (b1 * c2 - b2 * c1);
        assert_eq!(volume, Trivector3::new(determinant));
    });
}

/// Point p = n_o + **a** + ½**a**² n_∞: null, and at the place **a** from the origin.
#[test]
fn table_2_6_point() {
    each(|samples| {
        let a: Direction = samples.element();
        let p = Point::from(a);
        let form = origin() + DualSphere::from(a) + infinity() * (a.norm_squared() * ratio(1, 2));
        assert_eq!(wide(p), wide(form));
        has_grade(p, 1);
        assert_eq!(wide(p * p), zero());
        assert_eq!(
            Translator::by(a).apply(Point::at(0.into(), 0.into(), 0.into())),
            p
        );
    });
}

/// Point pair κ = p_a∧p_b: two points, of positive square.
#[test]
fn table_2_6_point_pair() {
    each(|samples| {
        let [a, b, ..] = Circular::random(samples).points();
        let pair: PointPair<Rational> = a ^ b;
        has_grade(pair, 2);
        assert_eq!((wide(a ^ pair), wide(b ^ pair)), (zero(), zero()));
        assert!((pair * pair).s > Rational::default());
    });
}

/// Circle K = p_a∧p_b∧p_c: all points of the circle through three.
#[test]
fn table_2_6_circle() {
    each(|samples| {
        let [a, b, c, d, e] = Circular::random(samples).points();
        let circle: Circle<Rational> = a ^ b ^ c;
        has_grade(circle, 3);
        assert_eq!((wide(d ^ circle), wide(e ^ circle)), (zero(), zero()));
    });
}

/// Sphere Σ = p_a∧p_b∧p_c∧p_d: all points of the sphere through four.
#[test]
fn table_2_6_sphere() {
    each(|samples| {
        let [a, b, c, d, e, f] = Circular::random(samples).points_of_sphere();
        let sphere: Sphere<Rational> = a ^ b ^ c ^ d;
        has_grade(sphere, 4);
        assert_eq!((wide(e ^ sphere), wide(f ^ sphere)), (zero(), zero()));
    });
}

/// Flat point Φ = p∧n_∞: p and infinity, whatever the weight of p and the sphere about it.
#[test]
fn table_2_6_flat_point() {
    each(|samples| {
        let p = Point::from(position(samples));
        let flat: FlatPoint<Rational> = exactly(p ^ infinity());
        has_grade(flat, 2);
        assert_eq!((wide(p ^ flat), wide(infinity() ^ flat)), (zero(), zero()));
        let sphere = DualSphere::about(p, samples.number());
        assert_eq!(wide(sphere ^ infinity()), wide(flat));
        // Φ = E + **x** n_∞, which squares to 1.
        let direction = p.position() ^ infinity();
        assert_eq!(wide(flat), wide(origin() ^ infinity()) + wide(direction));
        assert_eq!(wide(flat * flat), wide(Scalar::new(ratio(1, 1))));
    });
}

/// Line Λ = p_a∧p_b∧n_∞: all points of the line through two.
#[test]
fn table_2_6_line() {
    each(|samples| {
        let [a, b, c, ..] = Circular::random(samples).points();
        let line: Line<Rational> = exactly(a ^ b ^ infinity());
        has_grade(line, 3);
        let along = b.position() - a.position();
        let p = Point::from(a.position() + along * samples.number::<Rational>());
        assert_eq!(wide(p ^ line), zero());
        assert_ne!(wide(c ^ line), zero());
        // Λ² is the squared distance of the two points.
        assert_eq!((line * line).s, along.norm_squared());
    });
}

/// Dual line λ = **B** + **d** n_∞ with **d** in **B**: the dual of the line normal to **B**.
#[test]
fn table_2_6_dual_line() {
    each(|samples| {
        let [u, v, along] = Circular::random(samples).frame;
        let [x, y]: [Rational; 2] = std::array::from_fn(|_| samples.number());
        let support = u * x + v * y;
        let dual: DualLine<Rational> = exactly(wide(u ^ v) + wide(support * infinity()));
        has_grade(dual, 2);
        let line: Line<Rational> = exactly(dual.undual());
        // **d** is the place turned back by a right angle in **B**.
        let place = v * x - u * y;
        for step in [-1, 0, 2] {
            let p = Point::from(place + along * ratio(step, 1));
            assert_eq!(wide(p << dual), zero());
            assert_eq!(wide(p ^ line), zero());
        }
        assert_eq!(line.dual(), dual);
    });
}

/// Plane Π = p_a∧p_b∧p_c∧n_∞: all points of the plane through three.
#[test]
fn table_2_6_plane() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, c, ..] = figure.points();
        let plane: Plane<Rational> = exactly(a ^ b ^ c ^ infinity());
        has_grade(plane, 4);
        let [s, t]: [Rational; 2] = std::array::from_fn(|_| samples.number());
        let [to_b, to_c] = [b, c].map(|p| p.position() - a.position());
        let inside = a.position() + to_b * s + to_c * t;
        assert_eq!(wide(Point::from(inside) ^ plane), zero());
        let off = inside + figure.frame[2] * s;
        assert_ne!(wide(Point::from(off) ^ plane), zero());
    });
}

/// Dual plane π = **n** + δ n_∞: the dual of the plane with unit normal **n** at distance δ.
#[test]
fn table_2_6_dual_plane() {
    each(|samples| {
        let [u, v, normal] = Circular::random(samples).frame;
        let distance: Rational = samples.number();
        let dual: DualPlane<Rational> = exactly(DualSphere::from(normal) + infinity() * distance);
        has_grade(dual, 1);
        let [a, b, c] = [Direction::default(), u, v].map(|by| Point::from(normal * distance + by));
        let plane: Plane<Rational> = exactly(a ^ b ^ c ^ infinity());
        let found: DualPlane<Rational> = plane.dual();
        assert_eq!(
            (wide(found ^ dual), wide(found) * wide(found)),
            (zero(), wide(dual * dual))
        );
        for p in [a, b, c] {
            assert_eq!(p | dual, Scalar::default());
        }
    });
}

/// Minkowski plane E = n_o∧n_∞: it squares to 1, and I = **I**₃ E.
#[test]
fn table_2_6_minkowski_plane() {
    let minkowski: MinkowskiPlane<Rational> = exactly(origin() ^ infinity());
    assert_eq!(minkowski, unit(0));
    has_grade(minkowski, 2);
    assert_eq!(wide(minkowski * minkowski), wide(Scalar::new(ratio(1, 1))));
    let volume: Trivector3<Rational> = unit(0);
    assert_eq!(wide(volume * minkowski), wide(pseudoscalar()));
    assert_eq!(minkowski.dual(), -volume);
}

/// A direction is the same everywhere: translations leave it.
fn is_free_of_place(direction: impl Into<Multivector>, shift: Direction) {
    let direction = direction.into();
    let moved: Multivector = Translator::by(shift).apply(direction);
    assert_eq!(moved, direction);
    assert_eq!(direction ^ wide(infinity()), zero());
    assert_eq!(direction * direction, zero());
}

/// Direction vector **t** n_∞: the step from one flat point to another.
#[test]
fn table_2_6_direction_vector() {
    each(|samples| {
        let [t, x] = [(); 2].map(|()| position(samples));
        let direction: DirectionVector<Rational> = exactly(t * infinity());
        has_grade(direction, 2);
        is_free_of_place(direction, x);
        let step = (Point::from(x + t) ^ infinity()) - (Point::from(x) ^ infinity());
        assert_eq!(wide(step), wide(direction));
    });
}

/// Direction bivector **B** n_∞: what a plane has of direction.
#[test]
fn table_2_6_direction_bivector() {
    each(|samples| {
        let [s, t, x] = [(); 3].map(|()| samples.element::<Direction>());
        let direction: DirectionBivector<Rational> = exactly((s ^ t) * infinity());
        has_grade(direction, 3);
        is_free_of_place(direction, x);
        let flat = Point::from(x) ^ infinity();
        let plane: Plane<Rational> = exactly(wide(s ^ t) ^ wide(flat));
        assert_eq!(wide(infinity()) ^ wide(plane), zero());
        // −n_∞·Π is the direction.
        assert_eq!(-wide(infinity() << plane), wide(direction));
    });
}

/// Direction trivector **I**₃ n_∞: that of all space, the dual of n_∞ up to sign.
#[test]
fn table_2_6_direction_trivector() {
    each(|samples| {
        let volume = unit::<Trivector3<Rational>>(0) * samples.number::<Rational>();
        let direction: DirectionTrivector<Rational> = exactly(volume * infinity());
        has_grade(direction, 4);
        is_free_of_place(direction, samples.element());
        assert_eq!(wide(direction.dual() ^ infinity()), zero());
    });
}

/// A tangent has no size: it is null, and no point but its own is in it.
fn is_only_at_the_origin(tangent: impl Into<Multivector>, elsewhere: Direction) {
    let tangent = tangent.into();
    assert_eq!(tangent * tangent, zero());
    assert_eq!(wide(origin()) ^ tangent, zero());
    assert_ne!(wide(Point::from(elsewhere)) ^ tangent, zero());
}

/// Tangent vector n_o **t**: a point pair of size zero in the direction **t**.
#[test]
fn table_2_6_tangent_vector() {
    each(|samples| {
        let t: Direction = samples.element();
        let tangent: TangentVector<Rational> = exactly(origin() * t);
        has_grade(tangent, 2);
        is_only_at_the_origin(tangent, t * ratio(2, 1));
        // Its carrier is the line through the origin along **t**.
        let here = Point::from(Direction::default());
        let line = here ^ Point::from(t) ^ infinity();
        assert_eq!(wide(tangent ^ infinity()), wide(line));
    });
}

/// Tangent bivector n_o **B**: a circle of size zero in the plane of **B**.
#[test]
fn table_2_6_tangent_bivector() {
    each(|samples| {
        let [s, t]: [Direction; 2] = std::array::from_fn(|_| samples.element());
        let tangent: TangentBivector<Rational> = exactly(origin() * (s ^ t));
        has_grade(tangent, 3);
        is_only_at_the_origin(tangent, s + t);
        let here = Point::from(Direction::default());
        let plane = here ^ Point::from(s) ^ Point::from(t) ^ infinity();
        assert_eq!(wide(tangent ^ infinity()), wide(plane));
    });
}

/// Tangent trivector n_o **I**₃: a sphere of size zero, the dual of the origin up to sign.
#[test]
fn table_2_6_tangent_trivector() {
    each(|samples| {
        let volume = unit::<Trivector3<Rational>>(0) * samples.number::<Rational>();
        let tangent: TangentTrivector<Rational> = exactly(origin() * volume);
        has_grade(tangent, 4);
        is_only_at_the_origin(tangent, samples.element());
        assert_eq!(wide(tangent.dual() ^ origin()), zero());
        assert_ne!(wide(tangent ^ infinity()), wide(Pseudoscalar::default()));
    });
}
