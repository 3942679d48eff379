//! §2.4.3.3, first half: dual spheres, planes and lines, and their meets, (2.52) to (2.56).

use ga_cga::{Circle, DualLine, DualPlane, DualSphere, Line, Point, PointPair, Scalar, Sphere};
use ga_core::Rational;

use super::figures::{Circular, exactly, infinity, position, pseudoscalar, ratio, wide};
use super::samples::each;

/// The squared radius of a circle, −K²/(K∧n_∞)².
fn radius_squared(circle: Circle<Rational>) -> Rational {
    let carrier = circle ^ infinity();
    -(circle * circle).s / (carrier * carrier).s
}

/// σ = p − ½r² n_∞ squares to r² and holds exactly the points at distance r.
#[test]
fn equation_2_52_real_dual_spheres() {
    each(|samples| {
        let figure = Circular::random(samples);
        let center = Point::from(figure.center);
        let square = figure.radius * figure.radius;
        let sphere = DualSphere::from(center) - infinity() * (square * ratio(1, 2));
        assert_eq!(DualSphere::about(center, square), sphere);
        assert_eq!(wide(sphere * sphere), wide(Scalar::new(square)));
        let points = figure.points_of_sphere();
        for p in points {
            assert_eq!(p | sphere, Scalar::default());
        }
        let elsewhere = Point::from(figure.center + position(samples) * ratio(1, 7));
        let distance = (elsewhere.position() - figure.center).norm_squared();
        // p·σ = ½(r² − d²), positive inside.
        assert_eq!((elsewhere | sphere).s, (square - distance) * ratio(1, 2));
        // It is the dual of the sphere through its points.
        let [a, b, c, d, ..] = points;
        let direct: Sphere<Rational> = a ^ b ^ c ^ d;
        let dual = direct.dual();
        assert_eq!(dual * (ratio(1, 1) / dual.weight()), sphere);
    });
}

/// σ = p + ½r² n_∞ is imaginary: it squares to −r² and holds no point.
#[test]
fn equation_2_53_imaginary_dual_spheres() {
    each(|samples| {
        let figure = Circular::random(samples);
        let center = Point::from(figure.center);
        let square = figure.radius * figure.radius;
        let sphere = DualSphere::from(center) + infinity() * (square * ratio(1, 2));
        assert_eq!(DualSphere::about(center, -square), sphere);
        assert_eq!(wide(sphere * sphere), wide(Scalar::new(-square)));
        for p in figure.points_of_sphere().into_iter().chain([center]) {
            assert!((p | sphere).s < Rational::default());
        }
    });
}

/// π = **x** + δ n_∞ is the plane with normal **x** at distance δ; the difference of two points
/// is the plane that bisects them.
#[test]
fn equation_2_54_dual_planes() {
    each(|samples| {
        let [u, v, normal] = Circular::random(samples).frame;
        let distance: Rational = samples.number();
        let plane = DualSphere::from(normal) + infinity() * distance;
        assert_eq!(plane, DualPlane::at_distance(normal, distance).into());
        let steps = position(samples);
        let foot = normal * distance + u * steps.e1 + v * steps.e2;
        assert_eq!(Point::from(foot) | plane, Scalar::default());
        let above = Point::from(foot + normal * steps.e3);
        assert_eq!((above | plane).s, steps.e3);
        let [a, b] = [(); 2].map(|()| position(samples));
        let bisector = DualSphere::from(Point::from(b)) - DualSphere::from(Point::from(a));
        assert_eq!(bisector.weight(), Rational::default());
        assert_eq!(exactly::<_, DualPlane<Rational>>(bisector).normal(), b - a);
        let middle = (a + b) * ratio(1, 2);
        assert_eq!(Point::from(middle) | bisector, Scalar::default());
    });
}

/// λ = **B** + **d** n_∞ is the dual of the line along the normal of **B**; with **d** = −**x**·**B** it
/// passes through **x**.
#[test]
fn equation_2_55_dual_lines() {
    each(|samples| {
        let [u, v, along] = Circular::random(samples).frame;
        let x = position(samples);
        let plane = u ^ v;
        let support = -(x << plane);
        let dual = wide(plane) + wide(support * infinity());
        let dual: DualLine<Rational> = exactly(dual);
        let line: Line<Rational> = exactly(Point::from(x) ^ Point::from(x + along) ^ infinity());
        // The frame is right-handed: λ turns anticlockwise about the direction of the line.
        assert_eq!(wide(line.dual()), wide(dual));
        for step in [-2, 0, 1, 5] {
            let p = Point::from(x + along * ratio(step, 3));
            assert_eq!(wide(p << dual), wide(Scalar::<Rational>::default()));
        }
        let beside = Point::from(x + u * ratio(1, 3));
        assert_ne!(wide(beside << dual), wide(Scalar::<Rational>::default()));
        // **d** is as long as the line is far from the origin, and it lies in **B**.
        let nearest = x - along * (x | along).s;
        assert_eq!(support.norm_squared(), nearest.norm_squared());
        assert_eq!(support | along, Scalar::default());
        assert_eq!(support | nearest, Scalar::default());
    });
}

/// K = (σ∧π)⁻*: sphere and plane meet in a circle, real, tangent or imaginary.
#[test]
fn equation_2_56_a_sphere_and_a_plane_meet_in_a_circle() {
    each(|samples| {
        let figure = Circular::random(samples);
        let normal = figure.frame[2];
        let height = samples.whole(3);
        let center = Point::from(figure.center - normal * height);
        let distance = (figure.center | normal).s;
        let plane = DualPlane::at_distance(normal, distance);
        let square = figure.radius * figure.radius;
        let sphere = DualSphere::about(center, square + height * height);
        let dual: PointPair<Rational> = sphere ^ plane;
        let circle: Circle<Rational> = dual.undual();
        assert_eq!(wide(circle), wide(dual) * wide(pseudoscalar()));
        assert_eq!(circle.dual(), dual);
        for p in figure.points() {
            assert_eq!(p ^ circle, Sphere::default());
        }
        assert_eq!(radius_squared(circle), square);
        let [a, b, c, ..] = figure.points();
        let through: Circle<Rational> = a ^ b ^ c;
        let weight = (through | circle).s / (circle | circle).s;
        assert_eq!(through, circle * weight);
        // A smaller sphere touches the plane, and a still smaller one misses it.
        let touching = (DualSphere::about(center, height * height) ^ plane).undual();
        assert_eq!(radius_squared(touching), Rational::default());
        assert_eq!(Point::from(figure.center) ^ touching, Sphere::default());
        let missing = (DualSphere::about(center, Rational::default()) ^ plane).undual();
        assert_eq!(radius_squared(missing), -height * height);
    });
}
