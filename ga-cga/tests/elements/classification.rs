//! Every blade is called what it is, at any weight and far from the origin, and nothing else is
//! called a blade.

use ga_cga::{
    Bivector3, Circle, Classification, Direction, DirectionTrivector, DirectionVector, DualLine,
    DualPlane, DualSphere, Even, Flat, FlatPoint, Line, Multivector, Obstacle, Odd, Plane, Point,
    PointPair, Pseudoscalar, Round, Scalar, Shape, Sphere, Tangent, Tolerance, Translator,
    Trivector3, Vector3, classify, classify_dual, classify_within,
};
use ga_core::Element;

use super::oracle::{self, Random, point, vector};

use Classification::{Direct, Dual, NotABlade};
use Shape::{Flat as IsFlat, ImaginaryRound, RealRound, Tangent as IsTangent};

/// Whether a classification fits a pattern.
macro_rules! is {
    ($x:expr, $pattern:pat) => {{
        let found = $x;
        assert!(matches!(found, $pattern), "{found:?}");
    }};
}

/// The default tolerance for elements that were computed in a scene of this size.
fn scene(length: f64) -> Tolerance<f64> {
    Tolerance {
        length,
        ..Tolerance::default()
    }
}

/// Table 2.5: what the basis blades encode.
#[test]
fn table_2_5_basis_blades() {
    let blade = |mask: usize| {
        let mut coefficients = [0.0; 32];
        coefficients[mask] = -2.5;
        classify(Multivector::from_masks(coefficients))
    };
    const NO: usize = 8;
    const NI: usize = 16;
    is!(blade(0), Classification::Number(-2.5));
    is!(blade(NO), Direct(IsTangent(Tangent::Point { .. })));
    is!(
        blade(NI),
        Direct(Shape::Direction(Direction::Infinity(-2.5)))
    );
    is!(blade(NO | NI), Direct(IsFlat(Flat::Point(_))));
    is!(blade(7), Dual(IsFlat(Flat::Point(_))));
    is!(blade(7 | NO), Direct(IsTangent(Tangent::Trivector(_))));
    is!(
        blade(7 | NI),
        Direct(Shape::Direction(Direction::Trivector(_)))
    );
    is!(blade(31), Direct(IsFlat(Flat::Space(_))));
    for euclidean in [1, 2, 4] {
        is!(blade(euclidean), Dual(IsFlat(Flat::Plane(_))));
        is!(blade(euclidean | NO), Direct(IsTangent(Tangent::Vector(_))));
        is!(
            blade(euclidean | NI),
            Direct(Shape::Direction(Direction::Vector(_)))
        );
        is!(blade(euclidean | NO | NI), Direct(IsFlat(Flat::Line(_))));
        let plane = 7 - euclidean;
        is!(blade(plane), Dual(IsFlat(Flat::Line(_))));
        is!(blade(plane | NO), Direct(IsTangent(Tangent::Bivector(_))));
        is!(
            blade(plane | NI),
            Direct(Shape::Direction(Direction::Bivector(_)))
        );
        is!(blade(plane | NO | NI), Direct(IsFlat(Flat::Plane(_))));
    }
}

/// Rounds of all grades by the sign of their squared radius, near and up to 10⁶ away, at
/// weights from 10⁻³⁰⁰ to 10³⁰⁰, with the element handed out unchanged.
#[test]
fn rounds_and_tangents_by_their_squared_radius() {
    let mut random = Random::new(40);
    for _ in 0..5000 {
        let far = 10_f64.powf(6.0 * random.signed().abs());
        let center = point(random.direction() * far);
        let t = vector(random.direction());
        let size = 1.0 + random.signed().abs() * far;
        let heavy = random.signed().signum() * 10_f64.powf(280.0 * random.signed());
        let plane = t.orthogonal_plane();

        for (sign, real) in [(1.0, true), (-1.0, false)] {
            let square = sign * size * size;
            let pair: PointPair = PointPair::about(center, square, t) * heavy;
            let circle: Circle = Circle::about(center, square, plane) * heavy;
            let sphere: Sphere = Sphere::about(center, square) * heavy;
            let dual: DualSphere = DualSphere::about(center, square) * heavy;
            let shape = |round| {
                if real {
                    RealRound(round)
                } else {
                    ImaginaryRound(round)
                }
            };
            assert_eq!(classify(pair), Direct(shape(Round::PointPair(pair))));
            assert_eq!(classify(circle), Direct(shape(Round::Circle(circle))));
            assert_eq!(classify(sphere), Direct(shape(Round::Sphere(sphere))));
            assert_eq!(dual.classify(), Dual(shape(Round::Sphere(dual.undual()))));
            assert_eq!(classify(pair).is_real_round(), real);
            assert_eq!(classify(pair).is_imaginary_round(), !real);
            // Figure 2.12: real pairs are duals of imaginary circles, and the other way round.
            let opposite = |round| {
                if real {
                    ImaginaryRound(round)
                } else {
                    RealRound(round)
                }
            };
            assert_eq!(
                classify_dual(pair),
                Dual(opposite(Round::Circle(pair.undual())))
            );
            assert_eq!(
                classify_dual(circle),
                Dual(opposite(Round::PointPair(circle.undual())))
            );
            assert_eq!(classify_dual(dual), classify(dual));
            assert_eq!(classify(circle).circle(), Some(circle));
        }
        let pair: PointPair = PointPair::tangent(center, t) * heavy;
        let circle: Circle = Circle::tangent(center, plane) * heavy;
        let sphere: Sphere = Sphere::tangent(center) * heavy;
        assert_eq!(classify(pair), Direct(IsTangent(Tangent::Vector(pair))));
        assert_eq!(
            classify(circle),
            Direct(IsTangent(Tangent::Bivector(circle)))
        );
        assert_eq!(
            classify(sphere),
            Direct(IsTangent(Tangent::Trivector(sphere)))
        );
        let Direct(IsTangent(Tangent::Point { point, weight })) = classify(center * heavy) else {
            panic!("a point");
        };
        assert!(point.distance(center) <= 4e-16 * far);
        assert_eq!(weight, heavy);
        assert!(classify(center * heavy).is_tangent());
    }
}

/// Flats, their duals, and directions.
#[test]
fn flats_and_directions() {
    let mut random = Random::new(41);
    for _ in 0..5000 {
        let far = 10_f64.powf(6.0 * random.signed().abs());
        let at = point(random.direction() * far);
        let t = vector(random.direction());
        let heavy = random.signed().signum() * 10_f64.powf(280.0 * random.signed());
        let line: Line = Line::along(at, t) * heavy;
        let plane: Plane = Plane::with_normal(at, t) * heavy;
        let flat: FlatPoint = FlatPoint::at(at) * heavy;
        assert_eq!(classify(line), Direct(IsFlat(Flat::Line(line))));
        assert_eq!(classify(plane), Direct(IsFlat(Flat::Plane(plane))));
        assert_eq!(classify(flat), Direct(IsFlat(Flat::Point(flat))));
        assert_eq!(line.dual().classify(), Dual(IsFlat(Flat::Line(line))));
        assert_eq!(plane.dual().classify(), Dual(IsFlat(Flat::Plane(plane))));
        assert_eq!(flat.dual().classify(), Dual(IsFlat(Flat::Point(flat))));
        assert_eq!(classify(Circle::from(line)).line(), Some(line));
        assert_eq!(classify(Sphere::from(plane)).plane(), Some(plane));
        let direction: DirectionVector = DirectionVector::along(t) * heavy;
        assert_eq!(
            classify(PointPair::from(direction)).direction_vector(),
            Some(direction)
        );
        let across = line.attitude().dual();
        assert_eq!(classify(across).direction_bivector(), Some(across));
        assert!(classify(across).is_direction() && classify(line).is_flat());
    }
    let space = DirectionTrivector::of(Trivector3::new(3.0));
    assert_eq!(
        classify(space),
        Direct(Shape::Direction(Direction::Trivector(space)))
    );
    let all = Pseudoscalar::new(-2.0);
    assert_eq!(classify(all), Direct(IsFlat(Flat::Space(all))));
}

/// Rounding in the coefficients does not make another element of one.
#[test]
fn noise_is_forgiven() {
    let mut random = Random::new(42);
    let infinity = DualSphere::infinity();
    for _ in 0..5000 {
        let [a, b, c, d] = [(); 4].map(|()| random.position(3.0));
        // Products of more points than a flat needs, and translations there and back.
        let shift = Translator::by(vector(random.position(30.0)));
        let back = shift.reverse();
        let within = |x: Multivector| classify_within(x, Tolerance::relative(1e-11));
        let there = |x: Multivector| -> Multivector { back.apply(shift.apply(x)) };
        let on_line = a + (b - a) * random.signed();
        let straight: Circle = point(a) ^ point(on_line) ^ point(b);
        // Nearly coincident points leave little but rounding of their product.
        if oracle::size(straight) < 3.0 {
            continue;
        }
        assert!(classify(straight).line().is_some(), "{straight}");
        assert!(within(there(straight.into())).line().is_some());
        let on_plane = a + (b - a) * random.signed() + (c - a) * random.signed();
        let level: Sphere = point(a) ^ point(b) ^ point(c) ^ point(on_plane);
        if oracle::size(level) < 20.0 {
            continue;
        }
        assert!(classify(level).plane().is_some(), "{level}");
        let sphere: Sphere = point(a) ^ point(b) ^ point(c) ^ point(d);
        assert_eq!(
            classify(sphere).is_real_round(),
            oracle::size(sphere) > 1e-6
        );
        is!(
            within(there(Multivector::from(point(a)))),
            Direct(IsTangent(Tangent::Point { .. }))
        );
        is!(
            within(there((point(a) ^ infinity).into())),
            Direct(IsFlat(Flat::Point(_)))
        );
    }
}

/// Sums of blades that are no blades, and grades that do not belong together.
#[test]
fn what_is_no_blade() {
    let mut random = Random::new(43);
    let screw = |pitch: f64| {
        DualLine::along(Point::at(1.0, 2.0, 3.0), Vector3::new(0.0, 0.0, 1.0))
            + DualLine::from(DirectionVector::along(Vector3::new(0.0, 0.0, pitch)))
    };
    assert!(classify(screw(0.0)).line().is_some());
    assert_eq!(classify(screw(0.5)), NotABlade(Obstacle::NotFactorable));
    assert_eq!(
        classify(screw(0.5).undual()),
        NotABlade(Obstacle::NotFactorable)
    );
    assert_eq!(classify(screw(1e-10)), NotABlade(Obstacle::NotFactorable));
    is!(
        classify_within(screw(1e-10), Tolerance::relative(1e-8)),
        Dual(IsFlat(Flat::Line(_)))
    );
    for _ in 0..2000 {
        let bivector = PointPair::from_fn(|_| random.signed());
        let trivector = Circle::from_fn(|_| random.signed());
        assert_eq!(classify(bivector), NotABlade(Obstacle::NotFactorable));
        assert_eq!(classify(trivector), NotABlade(Obstacle::NotFactorable));
        let even = Even::from_fn(|_| random.signed());
        let odd = Odd::from_fn(|_| random.signed());
        assert_eq!(classify(even), NotABlade(Obstacle::MixedGrades));
        assert_eq!(classify(odd), NotABlade(Obstacle::MixedGrades));
        // Two vectors make a blade, and so do three.
        let [a, b, c] = [(); 3].map(|()| DualSphere::from_fn(|_| random.signed()));
        assert!(classify(a ^ b).shape().is_some());
        assert!(classify(a ^ b ^ c).shape().is_some());
    }
    // A flat point and a dual line at once.
    let both = PointPair::from(FlatPoint::at(Point::at(0.0, 0.0, 0.0)))
        + PointPair::from(Bivector3::new(1.0, 0.0, 0.0));
    assert_eq!(classify(both), NotABlade(Obstacle::NotFactorable));
    assert_eq!(classify(Scalar::new(2.0)), Classification::Number(2.0));
}

/// Zero, infinite and undefined input have names of their own, in every type.
#[test]
fn zero_and_not_finite() {
    macro_rules! each {
        ($($Element:ident)*) => {$(
            let zero: Multivector = ga_cga::$Element::<f64>::from_fn(|_| 0.0).into();
            assert_eq!(classify(zero), Classification::Zero);
            assert_eq!(classify_dual(zero), Classification::Zero);
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let broken = ga_cga::$Element::<f64>::from_fn(|i| if i == 0 { bad } else { 1.0 });
                assert_eq!(classify(broken), Classification::NotFinite);
                assert_eq!(broken.classify(), Classification::NotFinite);
            }
        )*};
    }
    each! {
        Scalar Vector3 Bivector3 Trivector3 DualSphere DualPlane PointPair FlatPoint DirectionVector
        TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector TangentBivector Sphere
        Plane DirectionTrivector TangentTrivector Pseudoscalar Even Odd Multivector
    }
    assert_eq!(
        classify(Point::new(f64::NAN, 0.0, 0.0, 0.0)),
        Classification::NotFinite
    );
}

/// Arbitrary finite coefficients of any size have a class, and what it carries is finite.
#[test]
fn every_finite_input_has_a_class() {
    let mut random = Random::new(44);
    for round in 0..21_000 {
        let grade = round % 7;
        let spread = [3.0, 20.0, 300.0][round % 3];
        let x = Multivector::<f64>::from_fn(|i| {
            let own = Multivector::<f64>::BLADES[i].0.grade() as usize;
            let there = (own == grade || grade == 6) && random.signed() > -0.3;
            if there {
                random.signed() * 10_f64.powf(spread * random.signed())
            } else {
                0.0
            }
        });
        for class in [classify(x), classify_dual(x)] {
            assert_ne!(class, Classification::NotFinite, "{x}");
            if let Some(shape) = class.shape() {
                let carried = Multivector::from(shape);
                let numbers = (0..32).map(|i| carried.at(i));
                assert!(numbers.into_iter().all(|x| !x.is_nan()), "{x}: {shape:?}");
            }
        }
    }
}

/// Spheres that come apart: real, touching, imaginary, concentric (Figure 2.11).
#[test]
fn figure_2_11_meets_of_spheres() {
    let mut random = Random::new(45);
    for _ in 0..5000 {
        let (center, t) = (random.position(5.0), random.direction());
        let (r, s) = (1.0 + random.signed().abs(), 3.0 + random.signed().abs());
        let meet = |apart: f64| -> Classification<f64> {
            let one = DualSphere::with_radius(vector(center), r);
            let two = DualSphere::with_radius(vector(center + t * apart), s);
            classify_within((one ^ two).undual(), scene(10.0))
        };
        is!(meet(s), Direct(RealRound(Round::Circle(_))));
        is!(meet(s - r), Direct(IsTangent(Tangent::Bivector(_))));
        is!(meet(s + r), Direct(IsTangent(Tangent::Bivector(_))));
        is!(meet(s + r + 0.01), Direct(ImaginaryRound(Round::Circle(_))));
        is!(meet(s - r - 0.01), Direct(ImaginaryRound(Round::Circle(_))));
        is!(meet(0.0), Dual(IsFlat(Flat::Point(_))));
    }
    let one = DualSphere::with_radius(Vector3::new(1.0, 2.0, 3.0), 1.0);
    assert_eq!(classify((one ^ one).undual()), Classification::Zero);
    let plane = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 3.0);
    let other = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 4.0);
    is!(
        classify((plane ^ other).undual()),
        Direct(Shape::Direction(Direction::Bivector(_)))
    );
}

/// Single precision is told apart with its own tolerance.
#[test]
fn single_precision() {
    let at = Point::<f32>::at(10.0, 20.0, 30.0);
    is!(classify(at), Direct(IsTangent(Tangent::Point { .. })));
    is!(classify(DualSphere::about(at, 1.0)), Dual(RealRound(_)));
    is!(
        classify(DualSphere::about(at, -1.0)),
        Dual(ImaginaryRound(_))
    );
    is!(
        classify(Line::along(at, Vector3::new(0.6, 0.0, 0.8))),
        Direct(IsFlat(Flat::Line(_)))
    );
}
