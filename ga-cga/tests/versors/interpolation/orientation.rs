//! Where orientation is in the way: the nearer orientation, and the way of similar figures.

use super::law::{apart, obeys};
use crate::random::Random;
use ga_cga::interpolate::{Carry, NoPath, Resemble, Way};
use ga_cga::*;

/// A round of each kind, real or imaginary.
fn rounds(random: &mut Random, square: f64) -> (DualSphere, PointPair, Circle) {
    let (center, along) = (random.point(), random.direction());
    let square = square * 4.0_f64.powf(random.number());
    let weight = 3.0_f64.powf(random.number());
    (
        DualSphere::about(center, square) * weight,
        PointPair::about(center, square, along) * weight,
        DualSphere::about(center, -square).circle_in(along.orthogonal_plane()) * weight,
    )
}

/// Every round goes to every other of its kind in the nearer orientation.
#[test]
fn the_nearer_orientation_is_always_reached() {
    let mut random = Random::new(91);
    let mut reversed = 0;
    for square in [1.0, -1.0] {
        for _ in 0..1_000 {
            let (a, b, c) = rounds(&mut random, square);
            let (d, e, f) = rounds(&mut random, square);
            let path = a.path_to_either(d, Way::Short).expect("spheres of a kind");
            let end = if apart(path.at(1.0), d) < 1e-6 { d } else { -d };
            obeys(path, a, end, 1e-6);
            reversed += u32::from(end == -d);
            // A kept orientation is not given up for a farther one.
            if end == -d
                && let Ok(kept) = a.path_to(d, Way::Short)
            {
                let turn = |path: &dyn Fn(f64) -> Even| path(1.0).s.abs();
                assert!(turn(&|t| path.versor_at(t)) >= turn(&|t| kept.versor_at(t)));
            }
            let path = b.path_to_either(-e, Way::Short).expect("pairs of a kind");
            let end = if apart(path.at(1.0), e) < 1e-6 { e } else { -e };
            obeys(path, b, end, 1e-6);
            let path = c.path_to_either(-f, Way::Short).expect("circles of a kind");
            let end = if apart(path.at(1.0), f) < 1e-6 { f } else { -f };
            obeys(path, c, end, 1e-6);
        }
    }
    assert!(reversed > 500, "{reversed}");
}

/// Planes and lines turn by a right angle at most, directions too.
#[test]
fn what_has_no_orientation_turns_by_a_right_angle_at_most() {
    let mut random = Random::new(92);
    for _ in 0..1_000 {
        let (u, v) = (random.direction(), random.direction());
        let path = u.path_to_either(v, Way::Short).expect("not null");
        assert!(path.versor_at(1.0).s >= std::f64::consts::FRAC_1_SQRT_2 - 1e-12);
        let (p, q) = (random.plane(), random.plane());
        let path = p.path_to_either(q, Way::Short).expect("planes");
        assert!(path.versor_at(1.0).s >= std::f64::consts::FRAC_1_SQRT_2 - 1e-12);
        // A direction is its own opposite.
        let still = u.path_to_either(-u, Way::Short).expect("nothing to do");
        assert!(apart(still.at(0.5), u) < 1e-14);
    }
    let apex = Point::at(1.0, 2.0, 3.0);
    let path = apex
        .path_to_either(apex, Way::Short)
        .expect("points have no orientation");
    assert_eq!(path.at(0.5), apex);
}

/// As similar figures all rounds of a kind reach each other, spheres outside one another too:
/// the radius by equal factors, the weight and so all of the element exactly.
#[test]
fn similar_figures_lead_everywhere() {
    let mut random = Random::new(93);
    for square in [1.0, -1.0] {
        for _ in 0..1_000 {
            let (a, b, c) = rounds(&mut random, square);
            let (d, e, f) = rounds(&mut random, square);
            let between = |a: Option<f64>, b: Option<f64>, t: f64| {
                let (a, b) = (a.expect("a round"), b.expect("a round"));
                a.signum() * a.abs().powf(1.0 - t) * b.abs().powf(t)
            };
            macro_rules! alike {
                ($($from:ident $to:ident)*) => {$(
                    let path = $from.similar_path_to($to, Way::Short).expect("similar");
                    obeys(path, $from, $to, 1e-8);
                    for t in [0.2, 0.5, 0.8] {
                        let expected = between($from.radius_squared(), $to.radius_squared(), t);
                        let square = path.at(t).radius_squared().expect("a round");
                        assert!((square / expected - 1.0).abs() < 1e-7, "{square} {expected}");
                    }
                )*};
            }
            let (s, o) = (a.undual(), d.undual());
            alike! { a d b e c f s o }
            assert_eq!(a.similar_path_to(-d, Way::Short), Err(NoPath::Reversed));
            assert_eq!(a.similar_path_to(d, Way::Long), Err(NoPath::DoesNotTurn));
            let long = c.similar_path_to(f, Way::Long).expect("circles turn");
            obeys(long, c, f, 1e-7);
            let opposite = Err(NoPath::Opposite);
            assert_eq!(b.similar_path_to(-b, Way::Short), opposite);
        }
    }
}

/// By hand: of two spheres on the x axis with radii 1 and 4 and centres 0 and 30 the apex of the
/// common cone is at −10, and the sphere half-way has radius 2 and its centre at 10.
#[test]
fn a_cone_has_its_apex_where_it_should() {
    let sphere = |x, r| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), r);
    let path = sphere(0.0, 1.0).similar_path_to(sphere(30.0, 4.0), Way::Short);
    let path = path.expect("spheres");
    let apex = Point::at(-10.0, 0.0, 0.0);
    let image = apex
        .image_under(path.versor_at(0.37))
        .expect("a similarity");
    assert!(image.distance(apex) < 1e-12);
    // Equal radii: a translation, in equal steps.
    let path = sphere(1.0, 2.0).similar_path_to(sphere(5.0, 2.0), Way::Short);
    let quarter = path.expect("spheres").at(0.25).center().expect("a sphere");
    assert!(quarter.distance(Point::at(2.0, 0.0, 0.0)) < 1e-13);
}

#[test]
fn only_rounds_are_similar() {
    let sphere = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
    let imaginary = DualSphere::about(Point::at(0.0, 0.0, 0.0), -1.0);
    let plane = DualSphere::from(DualPlane::new(0.0, 0.0, 1.0, 2.0));
    let point = DualSphere::from(Point::at(1.0, 0.0, 0.0));
    let zero = DualSphere::default();
    for (other, reason) in [
        (imaginary, NoPath::RealToImaginary),
        (plane, NoPath::Null),
        (point, NoPath::Null),
        (zero, NoPath::Null),
        (sphere * f64::INFINITY, NoPath::NotFinite),
    ] {
        assert_eq!(sphere.similar_path_to(other, Way::Short), Err(reason));
        assert_eq!(other.similar_path_to(sphere, Way::Short), Err(reason));
    }
    let line = PointPair::from(DualLine::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    let pair = PointPair::about(Point::at(0.0, 0.0, 0.0), 1.0, Vector3::new(1.0, 0.0, 0.0));
    assert_eq!(pair.similar_path_to(line, Way::Short), Err(NoPath::Null));
}
