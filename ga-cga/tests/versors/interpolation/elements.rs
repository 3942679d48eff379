//! Paths from element to element (2.66, 2.67).

use super::law::{BOTH, STRAIGHT, apart, neither, single, ways};
use crate::random::{Random, size};
use ga_cga::interpolate::{Carry, ElementPath, NoPath, Way};
use ga_cga::*;
use ga_core::ops::{Element, NormSquared};

/// The element over its norm.
fn unit<X>(x: X) -> X
where
    X: Element<Number = f64> + NormSquared<Output = f64>,
{
    let norm = x.norm_squared().abs().sqrt();
    X::from_fn(|i| x.at(i) / norm)
}

/// A weight of either sign from 1/9 to 9.
fn weight(random: &mut Random) -> f64 {
    let sign = if random.number() < 0.0 { -1.0 } else { 1.0 };
    sign * 9.0_f64.powf(random.number())
}

/// The flats through two points each, of any weight.
fn flats(random: &mut Random) -> (FlatPoint, Line, Plane) {
    let infinity = DualSphere::infinity();
    let [a, b, c] = [random.point(), random.point(), random.point()];
    let flat: FlatPoint = (a ^ infinity).narrow(1e-12).expect("a flat point");
    let line: Line = (a ^ b ^ infinity).narrow(1e-12).expect("a line");
    let plane: Plane = (a ^ b ^ c ^ infinity).narrow(1e-12).expect("a plane");
    (
        flat * weight(random).abs(),
        line * weight(random),
        plane * weight(random),
    )
}

#[test]
fn flats_are_carried() {
    let mut random = Random::new(81);
    for _ in 0..2_000 {
        let (f, l, p) = flats(&mut random);
        let (g, m, q) = flats(&mut random);
        assert_eq!(ways(l, m, 1e-9), BOTH);
        assert_eq!(ways(l.dual(), m.dual(), 1e-9), BOTH);
        assert_eq!(ways(p, q, 1e-9), BOTH);
        assert_eq!(ways(p.dual(), q.dual(), 1e-9), BOTH);
        assert_eq!(ways(f, g, 1e-10), STRAIGHT);
        assert_eq!(ways(f, -g, 1e-10), neither(NoPath::Reversed));
        // Each of them is a plane, a line, a flat point at every time.
        let line: Line = l.path_to(m, Way::Long).expect("not opposite").at(0.4);
        assert!(size(line.dual().wedge(line.dual())) < 1e-9 * size(line) * size(line));
    }
}

#[test]
fn directions_and_tangents_at_the_origin_are_carried() {
    let mut random = Random::new(85);
    for _ in 0..2_000 {
        let (u, v) = (random.direction() * weight(&mut random), random.vector());
        assert_eq!(ways(u, v, 1e-12), BOTH);
        macro_rules! alike {
            ($($Element:ident)*) => {$(
                let [a, b] = [u, v].map(|x| $Element::from(x.to_array()));
                assert_eq!(ways(a, b, 1e-12), BOTH);
                assert_eq!(ways(a, -a, 1e-12), neither(NoPath::Opposite));
            )*};
        }
        alike! { Bivector3 DirectionVector DirectionBivector TangentVector TangentBivector }
        // Lengths go by equal factors.
        let middle: Vector3 = u.path_to(v, Way::Short).expect("not opposite").at(0.5);
        assert!((middle.norm() - (u.norm() * v.norm()).sqrt()).abs() < 1e-12);
        let (a, b) = (random.point(), random.point());
        assert_eq!(ways(a, b, 1e-12), STRAIGHT);
        let third = a.position() * (2.0 / 3.0) + b.position() / 3.0;
        let path = a.path_to(b, Way::Short).expect("points always");
        assert!((path.at(1.0 / 3.0).position() - third).norm() < 1e-14);
    }
}

/// What has one coefficient changes its weight, by equal factors and never its sign.
#[test]
fn weights_alone_are_carried() {
    macro_rules! alike {
        ($($Element:ident)*) => {$(
            let [two, eight] = [2.0, 8.0].map($Element::new);
            assert_eq!(ways(two, eight, 1e-14), STRAIGHT);
            assert_eq!(ways(-two, -eight, 1e-14), STRAIGHT);
            assert_eq!(ways(two, -eight, 1e-14), neither(NoPath::Reversed));
            assert_eq!(ways(two, $Element::new(0.0), 1e-14), neither(NoPath::Null));
            let middle = two.path_to(eight, Way::Short).expect("a weight").at(0.5);
            assert!(apart(middle, $Element::new(4.0)) < 1e-15);
            let either = two.path_to_either(-eight, Way::Short).expect("a weight");
            assert!(apart(either.at(1.0), eight) < 1e-15);
        )*};
    }
    alike! {
        Scalar Trivector3 DirectionTrivector TangentTrivector MinkowskiPlane Pseudoscalar
    }
}

/// Crossing lines are joined by the screw about their common perpendicular: by their angle and
/// their distance.
#[test]
fn lines_are_joined_by_their_common_perpendicular() {
    let infinity = DualSphere::infinity();
    let line = |a: [f64; 3], b: [f64; 3]| -> DualLine {
        let [a, b] = [a, b].map(|[x, y, z]| Point::at(x, y, z));
        let line: Line = (a ^ b ^ infinity).narrow(0.0).expect("a line");
        line.dual()
    };
    let along_x = line([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let above = line([0.0, 0.0, 2.0], [0.0, 1.0, 2.0]);
    let path = along_x.path_to(above, Way::Short).expect("not opposite");
    let motor = path.versor_at(1.0);
    let image = motor.apply(Point::at(1.0, 0.0, 0.0));
    assert!(image.distance(Point::at(0.0, 1.0, 2.0)) < 1e-14);
    let half_way = path.versor_at(0.5).apply(Point::at(0.0, 0.0, 0.0));
    assert!(half_way.distance(Point::at(0.0, 0.0, 1.0)) < 1e-14);
}

/// (5.3.5): spheres of any weight, real to real and imaginary to imaginary. Crossing ones go all
/// ways, to either orientation; of the others one orientation is within reach.
#[test]
fn spheres_are_carried() {
    let mut random = Random::new(82);
    let mut kinds = [0; 3];
    for _ in 0..3_000 {
        let (a, b) = (random.sphere() * weight(&mut random), random.sphere());
        let [kept, reversed] = [b, -b].map(|b| ways(a, b, 1e-7));
        let [kept_dual, reversed_dual] = [b, -b].map(|b| ways(a.undual(), b.undual(), 1e-7));
        assert_eq!((kept, reversed), (kept_dual, reversed_dual));
        let cosine = unit(a).scalar_product(unit(b));
        let same_kind = (a.norm_squared() > 0.0) == (b.norm_squared() > 0.0);
        if !same_kind {
            kinds[0] += 1;
            assert_eq!(kept, neither(NoPath::RealToImaginary));
            assert_eq!(reversed, neither(NoPath::RealToImaginary));
        } else if cosine.abs() < 1.0 {
            kinds[1] += 1;
            assert_eq!((kept, reversed), (BOTH, BOTH), "{cosine}: {a} and {b}");
        } else {
            kinds[2] += 1;
            let refused = neither(NoPath::Reversed);
            let one = [(STRAIGHT, refused), (refused, STRAIGHT)];
            assert!(one.contains(&(kept, reversed)), "{cosine}: {a} and {b}");
            // The sign of σ₁·σ₂ over σ₁² tells which.
            let alike = cosine * a.norm_squared() > 0.0;
            assert_eq!(kept == STRAIGHT, alike);
        }
    }
    assert!(kinds.into_iter().all(|count| count > 50), "{kinds:?}");
}

/// Every sphere on the way is in the pencil of the two, and from a sphere to one inside it the
/// radius shrinks all the way.
#[test]
fn the_way_between_spheres_is_in_their_pencil() {
    let mut random = Random::new(86);
    for _ in 0..2_000 {
        let (a, b) = (random.sphere(), random.sphere());
        if let Ok(path) = a.path_to(b, Way::Short) {
            let pencil = unit(a) ^ unit(b);
            let between = unit(path.at(0.3));
            let off = size((between ^ pencil).grade(3));
            assert!(off < 1e-9 * (1.0 + size(pencil)) * size(between), "{off}");
        }
        let outer = random.point();
        let radius = 1.5 + random.number();
        let inside = random.direction() * (0.4 * radius * random.number());
        let start = DualSphere::about(outer, radius * radius);
        let end = DualSphere::with_radius(outer.position() + inside, 0.5 * radius);
        let path = start.path_to(end, Way::Short);
        let path = path.expect("the one is inside the other");
        let mut last = f64::INFINITY;
        for i in 0..=10 {
            let sphere: DualSphere = path.at(f64::from(i) / 10.0);
            let square = sphere.radius_squared().expect("a sphere");
            assert!(square < last && square > 0.24 * radius * radius);
            last = square;
        }
    }
}

/// Crossing spheres turn about the circle in which they meet: every sphere of the path contains it.
#[test]
fn crossing_spheres_turn_about_their_circle() {
    let a = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 2.0);
    let b = DualSphere::with_radius(Vector3::new(2.0, 0.0, 0.0), 1.5);
    let path = a.path_to(b, Way::Short).expect("they cross");
    let meet = unit(a ^ b);
    for i in 0..=8 {
        let sphere: DualSphere = path.at(f64::from(i) / 8.0);
        assert!(size((sphere ^ meet).grade(3)) < 1e-13);
    }
}

/// Pairs and circles reach each other in either orientation, both ways.
#[test]
fn circles_and_pairs_are_carried() {
    let mut random = Random::new(83);
    for _ in 0..3_000 {
        let mut p = || random.point();
        let circles: [Circle; 2] = [p() ^ p() ^ p(), p() ^ p() ^ p()];
        let pairs: [PointPair; 2] = [p() ^ p(), p() ^ p()];
        for sign in [2.0, -0.5] {
            assert_eq!(ways(circles[0], circles[1] * sign, 1e-6), BOTH);
            assert_eq!(ways(pairs[0], pairs[1] * sign, 1e-6), BOTH);
        }
        // On the way they stay blades of the same kind.
        let path = circles[0].path_to(circles[1], Way::Short);
        let between: Circle = unit(path.expect("as above").at(0.6));
        assert!((between.norm_squared() - unit(circles[1]).norm_squared()).abs() < 1e-6);
        let dual = between.dual();
        assert!(size(dual ^ dual) < 1e-6 * (1.0 + size(dual) * size(dual)));
    }
}

/// Imaginary circles and pairs go to their like, and not to real ones.
#[test]
fn imaginary_rounds_are_carried() {
    let mut random = Random::new(87);
    for _ in 0..1_000 {
        let mut round = |square: f64| {
            let (center, along) = (random.point(), random.direction());
            let plane = along.orthogonal_plane();
            let pair = PointPair::about(center, square, along);
            (pair, DualSphere::about(center, -square).circle_in(plane))
        };
        let [(pair, ring), (other, circle)] = [round(-1.0), round(-2.5)];
        let (real_pair, real_circle) = round(1.0);
        for sign in [1.0, -3.0] {
            assert_eq!(ways(pair, other * sign, 1e-6)[0], None);
            assert_eq!(ways(ring, circle * sign, 1e-6)[0], None);
            let refused = neither(NoPath::RealToImaginary);
            assert_eq!(ways(pair, real_pair * sign, 1e-6), refused);
            assert_eq!(ways(real_circle, ring * sign, 1e-6), refused);
        }
    }
}

/// All of it in single precision.
#[test]
fn elements_are_carried_in_single_precision() {
    let mut random = Random::new(88);
    for _ in 0..1_000 {
        let (f, l, p) = flats(&mut random);
        let (g, m, q) = flats(&mut random);
        let close = 2e-3;
        let flat = ways::<FlatPoint<f32>>(single(f), single(g), close);
        assert_eq!(flat, STRAIGHT);
        assert_eq!(ways::<Line<f32>>(single(l), single(m), close)[0], None);
        assert_eq!(ways::<Plane<f32>>(single(p), single(q), close)[0], None);
        let (u, v): (Vector3, Vector3) = (random.direction(), random.direction());
        assert_eq!(ways::<Vector3<f32>>(single(u), single(v), close)[0], None);
        let radius = 2.0 + random.number();
        let center = random.point();
        let around = DualSphere::about(center, 9.0 * radius * radius) * 3.0;
        let within = DualSphere::with_radius(center.position() + u, radius);
        let inward = ways::<DualSphere<f32>>(single(around), single(within), close);
        assert_eq!(inward, STRAIGHT);
    }
}

/// (5.16) as corrected: a circle goes to its axis and to circles that are linked with it at a
/// right angle, by the way that a point chooses.
#[test]
fn orthogonal_circles_are_carried_as_a_point_chooses() {
    let mut random = Random::new(84);
    let at = Point::at;
    let ring: Circle = at(1.0, 0.0, 0.0) ^ at(0.0, 1.0, 0.0) ^ at(-1.0, 0.0, 0.0);
    let axis: Circle = at(0.0, 0.0, 1.0) ^ at(0.0, 0.0, 0.0) ^ DualSphere::infinity();
    for _ in 0..2_000 {
        // Any conformal image of a ring and its axis.
        let bend = Transversor::by(random.vector());
        let versor = random.motor() * bend;
        let [from, to]: [Circle; 2] = [ring, axis].map(|circle| unit(versor.apply(circle)));
        // Rounding may find one of the ways.
        let found = from.versor_to(to);
        assert!(found.is_err() || found.is_ok_and(|v| apart(unit(v.apply(from)), to) < 1e-6));
        let nearest = random.point();
        let chosen = from
            .versor_to_orthogonal(to, nearest)
            .unwrap_or_else(|| panic!("{from} and {to} are orthogonal near {nearest}"));
        let end = unit(chosen.apply(from));
        assert!(
            apart(end, to) < 1e-9 * (1.0 + size(to)),
            "{end} is not {to}"
        );
        let path = ElementPath::along(from, chosen, Way::Short).expect("a quarter turn twice");
        let path = path.ending_at(to * 3.0).expect("it ends there");
        assert!(apart(path.at(1.0), to * 3.0) < 1e-8);
    }
    let far: Circle = at(5.0, 0.0, 0.0) ^ at(6.0, 1.0, 0.0) ^ at(7.0, 0.0, 0.0);
    assert_eq!(ring.versor_to_orthogonal(far, at(0.0, 0.0, 1.0)), None);
    assert_eq!(ring.versor_to(axis), Err(NoPath::ManyWays));
    assert_eq!(ring.versor_to_orthogonal(ring, at(0.0, 0.0, 1.0)), None);
    assert_eq!(
        ring.versor_to_orthogonal(Circle::default(), at(0.0, 0.0, 1.0)),
        None
    );
}

/// At a distance of 10⁴ a path ends where it should, and in between too: at what the same path
/// is near the origin.
#[test]
fn far_elements_are_carried_as_near_ones() {
    let mut random = Random::new(89);
    let far = 1e4;
    for _ in 0..300 {
        let shift = Translator::by(random.direction() * far);
        let (center, radius) = (random.point(), 1.5 + random.number());
        let along = random.direction();
        let other = Point::from(center.position() + random.vector());
        let spheres = [
            DualSphere::about(center, radius * radius),
            DualSphere::about(other, 4.0 * radius * radius),
        ];
        let pairs = [along, random.direction()].map(|along| spheres[0].pair_along(along));
        let planes = [along, random.direction()].map(|along| DualPlane::at_distance(along, 1.0));
        macro_rules! alike {
            ($($list:ident: $Type:ident)*) => {$(
                let [from, to] = $list;
                let near = from.path_to(to, Way::Short).expect("near");
                let [a, b] = [from, to].map(|x| shift.apply(x));
                let path = a.path_to(b, Way::Short).expect("far");
                for t in [0.0, 0.4, 1.0] {
                    let expected: $Type = shift.apply(near.at(t));
                    let off = apart(path.at(t), expected);
                    // What the coefficients know of a radius, 10⁻¹⁶ d², and what becomes of
                    // it where the two are nearly opposite.
                    assert!(off < 1e-5, "{off} at {t}");
                }
                let back: $Type = shift.reverse().apply(path.at(1.0));
                assert!(size(back - to) < 1e-7 * (1.0 + size(to)));
                assert!(apart(path.at(1.0), b) < 1e-7);
            )*};
        }
        alike! { spheres: DualSphere pairs: PointPair planes: DualPlane }
    }
}
