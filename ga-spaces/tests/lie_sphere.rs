//! Lie's sphere geometry against distances and radii in components.
#![cfg(feature = "lie-sphere")]

use ga_core::Rational;
use ga_spaces::lie_sphere::{
    Contacts, Offset, OrientedElement, Plane, Quadvector, Rotor, Sphere, Translator, Unoriented,
    Vector,
};
use nalgebra::Vector3;
use proptest::prelude::*;

type Space<T = f64> = [T; 3];

fn exact() -> impl Strategy<Value = Rational> {
    (-6_i128..=6, 1_i128..=3).prop_map(|(n, d)| Rational::new(n, d))
}

fn exact_sphere() -> impl Strategy<Value = (Space<Rational>, Rational)> {
    ([exact(), exact(), exact()], exact())
}

/// A unit vector with rational coordinates, by stereographic projection.
fn exact_unit() -> impl Strategy<Value = Space<Rational>> {
    (exact(), exact()).prop_map(|(u, v)| {
        let one = Rational::from_integer(1);
        let two = Rational::from_integer(2);
        let square = u * u + v * v;
        [two * u, two * v, square - one].map(|c| c / (square + one))
    })
}

fn dot(a: Space<Rational>, b: Space<Rational>) -> Rational {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Space<Rational>, b: Space<Rational>) -> Space<Rational> {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn zero() -> Rational {
    Rational::from_integer(0)
}

/// The miss of oriented contact, |c₁ − c₂| = |ρ₁ − ρ₂| or n·c − δ = ρ, in plain coordinates.
fn miss(element: OrientedElement, center: Space, radius: f64) -> f64 {
    match element {
        OrientedElement::Sphere(sphere) => {
            let apart = (Vector3::from(sphere.center()) - Vector3::from(center)).norm();
            (apart - (sphere.radius() - radius).abs()).abs()
        }
        OrientedElement::Plane(plane) => {
            let height = Vector3::new(plane.e1, plane.e2, plane.e3).dot(&Vector3::from(center));
            (height - plane.ni - radius).abs()
        }
        OrientedElement::Infinity => f64::INFINITY,
    }
}

fn joined(spheres: [(Space, f64); 4]) -> Quadvector {
    let [a, b, c, d] = spheres.map(|(center, radius)| Sphere::about(center, radius));
    a ^ b ^ c ^ d
}

proptest! {
    /// Spheres are null, and their product is ½((ρ₁ − ρ₂)² − (c₁ − c₂)²): zero exactly at
    /// oriented contact.
    #[test]
    fn contact_is_a_product((c, r) in exact_sphere(), (d, s) in exact_sphere()) {
        let (one, two) = (Sphere::about(c, r), Sphere::about(d, s));
        prop_assert_eq!(one.norm_squared(), zero());
        let apart = minus(c, d);
        let expected = (r - s) * (r - s) - dot(apart, apart);
        prop_assert_eq!(one.scalar_product(two) * Rational::from_integer(2), expected);
    }

    /// Two spheres that are made to touch do; with one orientation reversed they do not, unless
    /// one is a point.
    #[test]
    fn touching_spheres_touch((c, r) in exact_sphere(), u in exact_unit(), s in exact()) {
        // The centre of a sphere of radius s inside or outside on the normal u.
        let d = [0, 1, 2].map(|i| c[i] + u[i] * (r - s));
        let (one, two) = (Sphere::about(c, r), Sphere::about(d, s));
        prop_assert_eq!(one.scalar_product(two), zero());
        let reversed = one.scalar_product(two.reversed_orientation());
        prop_assert_eq!(reversed == zero(), r * s == zero());
    }

    /// A plane touches the spheres at their radius above it.
    #[test]
    fn planes_touch_at_the_height_of_the_radius(n in exact_unit(), offset in exact(), (c, r) in exact_sphere()) {
        let [x, y, z] = n;
        let plane = Plane::new(x, y, z, offset, Rational::from_integer(1));
        prop_assert_eq!(plane.norm_squared(), zero());
        prop_assert_eq!(plane.scalar_product(Sphere::about(c, r)), dot(n, c) - offset - r);
    }

    /// Laguerre: an offset adds to every radius and moves planes along their normals; planes
    /// stay planes.
    #[test]
    fn offsets_grow((c, r) in exact_sphere(), h in exact(), n in exact_unit(), offset in exact()) {
        let grown: Sphere<Rational> = Offset::by(h).apply(Sphere::about(c, r));
        prop_assert_eq!(grown, Sphere::about(c, r + h));
        let [x, y, z] = n;
        let one = Rational::from_integer(1);
        let moved: Plane<Rational> = Offset::by(h).apply(Plane::new(x, y, z, offset, one));
        prop_assert_eq!(moved, Plane::new(x, y, z, offset - h, one));
    }

    /// Translations keep radii.
    #[test]
    fn translations_move((c, r) in exact_sphere(), v in [exact(), exact(), exact()]) {
        let moved: Sphere<Rational> = Translator::by(v).apply(Sphere::about(c, r));
        prop_assert_eq!(moved, Sphere::about([0, 1, 2].map(|i| c[i] + v[i]), r));
    }

    /// Möbius: inversions keep contact and keep points points.
    #[test]
    fn inversions_keep_contact(
        (c, r) in exact_sphere(), u in exact_unit(), s in exact(), (m, q) in exact_sphere(),
    ) {
        prop_assume!(q != zero());
        let inversion = Unoriented::about(m, q);
        let d = [0, 1, 2].map(|i| c[i] + u[i] * (r - s));
        let images = [(c, r), (d, s)].map(|(c, r)| -> Vector<Rational> {
            inversion.apply(Sphere::about(c, r))
        });
        prop_assert_eq!(images[0].scalar_product(images[1]), zero());
        let point: Vector<Rational> = inversion.apply(Sphere::about(c, zero()));
        prop_assert_eq!(point.r, zero());
        // The point is where inversion in coordinates has it.
        let apart = minus(c, m);
        let square = dot(apart, apart);
        if square == zero() {
            prop_assert_eq!(point.no, zero());
        } else {
            let place = [0, 1, 2].map(|i| m[i] + apart[i] * q / square);
            prop_assert_eq!([point.e1, point.e2, point.e3].map(|x| x / point.no), place);
        }
    }

    /// Any reflection of Lie's geometry keeps contact: any vector that is not null will do.
    #[test]
    fn versors_keep_contact(
        (c, r) in exact_sphere(), u in exact_unit(), s in exact(),
        v in [exact(), exact(), exact(), exact(), exact(), exact()],
    ) {
        let [no, e1, e2, e3, ni, last] = v;
        let mirror = Vector::new(no, e1, e2, e3, ni, last);
        prop_assume!(mirror.norm_squared() != zero());
        let d = [0, 1, 2].map(|i| c[i] + u[i] * (r - s));
        let images = [(c, r), (d, s)].map(|(c, r)| -> Vector<Rational> {
            mirror.apply(Sphere::about(c, r))
        });
        prop_assert_eq!(images[0].norm_squared(), zero());
        prop_assert_eq!(images[0].scalar_product(images[1]), zero());
    }

    /// Apollonius: every answer touches all four.
    #[test]
    fn apollonius_is_solved(
        a in ([-3.0..3.0, -3.0..3.0, -3.0..3.0], -1.0..1.0_f64),
        b in ([-3.0..3.0, -3.0..3.0, -3.0..3.0], -1.0..1.0_f64),
        c in ([-3.0..3.0, -3.0..3.0, -3.0..3.0], -1.0..1.0_f64),
        d in ([-3.0..3.0, -3.0..3.0, -3.0..3.0], -1.0..1.0_f64),
    ) {
        let all = [a, b, c, d];
        let Contacts::Two(answers) = joined(all).contacts(1e-10) else {
            return Ok(());
        };
        for answer in answers {
            let size = match answer {
                OrientedElement::Sphere(sphere) => sphere.radius().abs() + 1.0,
                _ => 1.0,
            };
            prop_assume!(size < 1e3);
            for (center, radius) in all {
                let miss = miss(answer, center, radius);
                prop_assert!(miss < 1e-8 * size, "{answer:?} misses by {miss}");
            }
        }
    }

    /// Nothing panics, and every answer is of finite numbers.
    #[test]
    fn any_elements_are_answered(raw in [[any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()],
        [any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()]]) {
        let [[a, b, c, d], [e, f, ..]] = raw;
        let spheres = [([a, b, c], d), ([b, c, e], f), ([0.0, 1.0, e], 1.0), ([f, 0.0, 1.0], 0.0)];
        if let Contacts::Two(found) = joined(spheres).contacts(1e-9) {
            for element in found {
                if let OrientedElement::Sphere(sphere) = element {
                    prop_assert!(sphere.to_array().into_iter().all(|x| !x.is_nan()));
                }
            }
        }
    }
}

/// Four spheres of radius 1 about the corners of a regular tetrahedron: the answers are the
/// balls about its centre that hold them and, with the other orientation, fit between them.
#[test]
fn a_tetrahedron_of_balls() {
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    let Contacts::Two(found) = joined(corners.map(|corner| (corner, 1.0))).contacts(1e-9) else {
        panic!("two balls");
    };
    let mut radii = found.map(|element| match element {
        OrientedElement::Sphere(sphere) => {
            assert!(Vector3::from(sphere.center()).norm() < 1e-14);
            sphere.radius()
        }
        other => panic!("{other:?} is no ball"),
    });
    radii.sort_by(f64::total_cmp);
    let far = 3.0_f64.sqrt();
    assert!((radii[0] - (1.0 - far)).abs() < 1e-14);
    assert!((radii[1] - (1.0 + far)).abs() < 1e-14);
}

/// Three balls on a table and a fourth: the table, and one ball more.
#[test]
fn planes_are_answers() {
    let spheres = [
        ([3.0, 0.0, 1.0], 1.0),
        ([0.0, 3.0, 1.0], 1.0),
        ([-3.0, 0.0, 2.0], 2.0),
        ([1.0, -1.0, 0.5], 0.5),
    ];
    let contacts = joined(spheres).contacts(1e-9);
    let Contacts::Two(found) = contacts else {
        panic!("two answers, not {contacts:?}");
    };
    let tables = found.iter().filter(|element| {
        matches!(element, OrientedElement::Plane(plane)
            if (plane.e3 - 1.0).abs() < 1e-12 && plane.ni.abs() < 1e-12)
    });
    assert_eq!(tables.count(), 1);
    for element in found {
        for (center, radius) in spheres {
            assert!(miss(element, center, radius) < 1e-12);
        }
    }
}

/// Balls that touch the table in points of one circle: the table counts twice.
#[test]
fn answers_coincide() {
    let spheres = [
        ([3.0, 0.0, 1.0], 1.0),
        ([0.0, 3.0, 1.0], 1.0),
        ([-3.0, 0.0, 2.0], 2.0),
        ([0.0, -3.0, 0.5], 0.5),
    ];
    let contacts = joined(spheres).contacts(1e-9);
    let Contacts::One(OrientedElement::Plane(plane)) = contacts else {
        panic!("the table, not {contacts:?}");
    };
    assert_eq!(plane, Plane::new(0.0, 0.0, 1.0, 0.0, 1.0));
}

/// One sphere within the others, in contact with none: no answer; dependent ones: too many.
#[test]
fn apollonius_without_an_answer() {
    let inner = [
        ([0.0, 0.0, 0.0], 0.1),
        ([0.1, 0.0, 0.0], 5.0),
        ([0.0, 0.2, 0.0], 9.0),
        ([0.0, 0.0, 0.3], 0.0),
    ];
    assert_eq!(joined(inner).contacts(1e-9), Contacts::None);
    let same = [([0.0, 0.0, 0.0], 1.0); 4];
    assert_eq!(joined(same).contacts(1e-9), Contacts::Undetermined);
    assert_eq!(
        Quadvector::<f64>::default().contacts(1e-9),
        Contacts::Undetermined
    );
    let infinite = Quadvector::<f64>::default().map(|_| f64::INFINITY);
    assert_eq!(infinite.contacts(1e-9), Contacts::Undetermined);
}

/// A vector is told by its kind.
#[test]
fn null_vectors_are_unpacked() {
    let kind = |v: Vector| v.element(1e-12);
    let sphere = Sphere::about([1.0, 2.0, 4.0], -3.0);
    let Some(OrientedElement::Sphere(found)) = kind(Vector::from(sphere) * 8.0) else {
        panic!("a sphere");
    };
    assert!((found - sphere).to_array().iter().all(|c| c.abs() < 1e-14));
    let plane = Plane::facing([0.0, 0.0, 2.0], 4.0).expect("a normal");
    assert_eq!(plane, Plane::new(0.0, 0.0, 1.0, 2.0, 1.0));
    assert_eq!(
        kind(Vector::from(plane) * -3.0),
        Some(OrientedElement::Plane(plane))
    );
    assert_eq!(kind(Vector::infinity()), Some(OrientedElement::Infinity));
    assert_eq!(kind(Vector::default()), None);
    assert_eq!(kind(Vector::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0)), None);
    assert_eq!(kind(Vector::infinity() * f64::NAN), None);
    assert_eq!(Plane::facing([0.0, 0.0, 0.0], 1.0), None);
    assert_eq!(Plane::facing([f64::NAN, 0.0, 0.0], 1.0), None);
}

/// Rotations turn centres and keep radii.
#[test]
fn rotations_turn_centres() {
    let quarter = Rotor::new(1.0, -1.0, 0.0, 0.0);
    let image: Sphere = quarter.apply(Sphere::about([2.0, 0.0, 1.0], -1.5));
    assert_eq!(image, Sphere::about([0.0, 2.0, 1.0], -1.5));
}
