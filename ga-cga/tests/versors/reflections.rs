//! Reflections in every kind of element (2.26–2.28), against plain vector geometry.

use crate::random::Random;
use ga_cga::{DualLine, DualPlane, DualSphere, FlatPoint, Line, Plane, Point, Scalar, Vector3};

/// (2.26), (2.27), (2.29), (2.30): −b a b⁻¹ negates the projection on b and keeps the rejection.
#[test]
fn a_vector_reflects_as_2_27_says() {
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let (a, b) = (random.vector(), random.vector());
        let (along, across) = (a.project(b), a.reject(b));
        assert!((along + across - a).norm() < 1e-13);
        assert!((along ^ b).norm() < 1e-13);
        assert!(across.scalar_product(b).abs() < 1e-13);
        let image: Vector3 = b.apply(a);
        assert!((image - (across - along)).norm() < 1e-13);
    }
}

/// (2.28): with the grade involution the reflection of a product is the product of reflections.
#[test]
fn the_grade_involution_makes_2_28_multiplicative() {
    let mut random = Random::new(2);
    for _ in 0..1000 {
        let (a, b, mirror) = (random.vector(), random.vector(), random.direction());
        let product = mirror.apply(a ^ b);
        assert!((product - (mirror.apply(a) ^ mirror.apply(b))).norm() < 1e-13);
        let scalar = mirror.apply(Scalar::new(3.0));
        assert!((scalar.s - 3.0).abs() < 1e-14);
    }
}

/// A plane, direct or dual, reflects in itself and keeps weights apart from the sign.
#[test]
fn planes_mirror() {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let plane = random.plane();
        let direct: Plane = plane.undual();
        let p = random.point();
        let height = plane.normal().scalar_product(p.position()) - plane.ni;
        let expected = Point::from(p.position() - plane.normal() * (2.0 * height));
        let image: Point = plane.apply(p);
        assert!(image.distance(expected) < 1e-13);
        assert!((image.ni - expected.ni).abs() < 1e-12);
        let image = p.image_under(direct).expect("planes map points to points");
        assert!(image.distance(expected) < 1e-13);
        // The plane itself turns round: as a dual vector it is negated.
        let own: DualPlane = plane.apply(plane);
        assert!((own + plane).norm() < 1e-13);
    }
}

/// A sphere inverts: c + r² (x − c)/|x − c|², with r² < 0 for imaginary ones.
#[test]
fn spheres_invert() {
    let mut random = Random::new(4);
    for _ in 0..1000 {
        let (sphere, p) = (random.sphere(), random.point());
        let center = sphere.center().expect("a sphere").position();
        let square = sphere.radius_squared().expect("a sphere");
        let arm = p.position() - center;
        if arm.norm() < 1e-2 {
            continue;
        }
        let expected = Point::from(center + arm * (square / arm.norm_squared()));
        for image in [p.image_under(sphere), p.image_under(sphere.undual())] {
            let image = image.expect("not the centre");
            let tolerance = 1e-11 * (1.0 + expected.position().norm());
            assert!(image.distance(expected) < tolerance);
        }
        // The centre is the image of infinity, and goes there.
        assert_eq!(Point::from(center).image_under(sphere), None);
    }
}

/// A line, direct or dual, makes a half turn about itself.
#[test]
fn lines_turn_half_way() {
    let mut random = Random::new(5);
    for _ in 0..1000 {
        let (a, b, p) = (random.point(), random.point(), random.point());
        let line: Line = (a ^ b ^ DualSphere::infinity())
            .narrow(1e-12)
            .expect("a line");
        let dual: DualLine = line.dual();
        let direction = (b.position() - a.position()) / a.distance(b);
        let arm = p.position() - a.position();
        let along = direction * arm.scalar_product(direction);
        let expected = Point::from(a.position() + along * 2.0 - arm);
        for image in [p.image_under(line), p.image_under(dual)] {
            assert!(image.expect("a point").distance(expected) < 1e-10);
        }
    }
}

/// A flat point reflects in the point; a circle takes its axis to itself and fixes its own
/// points, as inverting in its sphere and mirroring in its plane does.
#[test]
fn flat_points_and_circles_reflect() {
    let mut random = Random::new(6);
    for _ in 0..1000 {
        let (a, b, c, p) = (
            random.point(),
            random.point(),
            random.point(),
            random.point(),
        );
        let flat: FlatPoint = (a ^ DualSphere::infinity())
            .narrow(0.0)
            .expect("a flat point");
        let image = p.image_under(flat).expect("a point");
        let expected = Point::from(a.position() * 2.0 - p.position());
        assert!(image.distance(expected) < 1e-12);

        let circle = a ^ b ^ c;
        let size = circle.norm();
        if size < 0.5 {
            continue;
        }
        for own in [a, b, c] {
            let image = own.image_under(circle).expect("points of the circle stay");
            assert!(image.distance(own) < 1e-9);
        }
        let carrier: DualPlane = (circle ^ DualSphere::infinity())
            .dual()
            .narrow(1e-12)
            .expect("a plane");
        let around = circle.left_contract(circle ^ DualSphere::infinity());
        let mirrored: Point = carrier.apply(p);
        let both = mirrored.image_under(around).expect("not the centre");
        let image = p.image_under(circle).expect("not the centre");
        assert!(image.distance(both) < 1e-8 * (1.0 + both.position().norm()));
    }
}
