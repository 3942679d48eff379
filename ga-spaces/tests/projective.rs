//! Projective space of lines against 4×4 matrices on homogeneous coordinates.
#![cfg(feature = "projective")]

use ga_core::Rational;
use ga_spaces::projective3::{Bivector, Collineation, Line, Trivector};
use nalgebra::{Matrix4, Vector4};
use proptest::prelude::*;

type Four<T = f64> = [T; 4];

fn exact() -> impl Strategy<Value = Rational> {
    (-5_i128..=5, 1_i128..=2).prop_map(|(n, d)| Rational::new(n, d))
}

fn exact_point() -> impl Strategy<Value = Four<Rational>> {
    [exact(), exact(), exact(), exact()]
}

fn float_point() -> impl Strategy<Value = Four> {
    [-3.0..3.0, -3.0..3.0, -3.0..3.0, -3.0..3.0]
}

fn float_matrix() -> impl Strategy<Value = [Four; 4]> {
    [float_point(), float_point(), float_point(), float_point()]
}

fn zero() -> Rational {
    Rational::from_integer(0)
}

fn dot(a: Four<Rational>, b: Four<Rational>) -> Rational {
    (0..4).map(|i| a[i] * b[i]).sum()
}

fn determinant(rows: [Four<Rational>; 4]) -> Rational {
    let minor =
        |i: usize, j: usize, a: usize, b: usize| rows[a][i] * rows[b][j] - rows[a][j] * rows[b][i];
    minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 2, 0, 1) * minor(1, 3, 2, 3)
        + minor(0, 3, 0, 1) * minor(1, 2, 2, 3)
        + minor(1, 2, 0, 1) * minor(0, 3, 2, 3)
        - minor(1, 3, 0, 1) * minor(0, 2, 2, 3)
        + minor(2, 3, 0, 1) * minor(0, 1, 2, 3)
}

fn columns(rows: [Four; 4]) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| rows[i][j])
}

/// How far two homogeneous vectors are from being multiples of each other.
fn apart(a: Four, b: Four) -> f64 {
    let (a, b) = (Vector4::from(a).normalize(), Vector4::from(b).normalize());
    (a - b).norm().min((a + b).norm())
}

fn same_line(a: Line, b: Line) -> f64 {
    let unit = |line: Line| {
        let size = line
            .to_array()
            .into_iter()
            .map(|x| x * x)
            .sum::<f64>()
            .sqrt();
        line / size
    };
    let size = |line: Line| {
        line.to_array()
            .into_iter()
            .map(f64::abs)
            .fold(0.0, f64::max)
    };
    size(unit(a) - unit(b)).min(size(unit(a) + unit(b)))
}

/// The versor acts on points, lines and planes as the matrix does.
fn acts_as(
    versor: Collineation,
    matrix: Matrix4<f64>,
    p: Four,
    q: Four,
    bound: f64,
) -> Result<(), TestCaseError> {
    let on = |x: Four| -> Four { (matrix * Vector4::from(x)).into() };
    let image: Trivector = versor.apply(Trivector::point(p));
    let image = image.point_coordinates().expect("a point");
    prop_assert!(apart(image, on(p)) < bound, "{image:?} is not {:?}", on(p));
    let line: Line = versor.apply(Line::join(p, q));
    prop_assert!(same_line(line, Line::join(on(p), on(q))) < bound);
    let back = matrix.try_inverse().expect("a collineation").transpose();
    let plane: Trivector = versor.apply(Trivector::plane(p));
    let plane = plane.plane_coordinates().expect("a plane");
    prop_assert!(apart(plane, (back * Vector4::from(p)).into()) < bound);
    Ok(())
}

proptest! {
    /// Joins and meets are null, and lines meet exactly where four points are coplanar.
    #[test]
    fn lines_are_null_and_meet(
        p in exact_point(), q in exact_point(), r in exact_point(), s in exact_point(),
    ) {
        let (one, two) = (Line::join(p, q), Line::join(r, s));
        prop_assert_eq!(one.norm_squared(), zero());
        prop_assert_eq!(Line::meet(p, q).norm_squared(), zero());
        prop_assert_eq!(one.scalar_product(two), -determinant([p, q, r, s]));
        // The meet of planes crosses the join of points where two of the incidences balance.
        let crossing = dot(r, p) * dot(s, q) - dot(r, q) * dot(s, p);
        prop_assert_eq!(one.scalar_product(Line::meet(r, s)) == zero(), crossing == zero());
    }

    /// All lines through a point span its 3-blade, all lines of a plane that of the plane.
    #[test]
    fn points_and_planes_hold_their_lines(p in exact_point(), q in exact_point()) {
        let through = Line::join(p, q);
        prop_assert_eq!(Trivector::point(p) ^ through, (Trivector::point(p) ^ through) * zero());
        let within = Line::meet(p, q);
        prop_assert_eq!(Trivector::plane(p) ^ within, (Trivector::plane(p) ^ within) * zero());
    }

    /// Points and planes are null, of opposite families, and their product is the square of
    /// the incidence.
    #[test]
    fn incidence_is_a_product(p in exact_point(), plane in exact_point()) {
        let (point, lines) = (Trivector::point(p), Trivector::plane(plane));
        prop_assert_eq!(point.scalar_product(point), zero());
        prop_assert_eq!(lines.scalar_product(lines), zero());
        prop_assert_eq!(point.point_part(), point);
        prop_assert_eq!(lines.plane_part(), lines);
        let incidence = dot(p, plane);
        prop_assert_eq!(point.scalar_product(lines), -incidence * incidence);
    }

    /// Two points are joined by the line that both hold: three lines through a point give it.
    #[test]
    fn three_lines_span_their_point(p in exact_point(), q in exact_point(), r in exact_point(), s in exact_point()) {
        let blade = Line::join(p, q) ^ Line::join(p, r) ^ Line::join(p, s);
        let expected = Trivector::point(p) * determinant([q, r, s, p]);
        prop_assert!(blade == expected || blade == -expected);
    }

    /// An elation is x + (φ·x) c on points, exactly; a centre off the axis is none.
    #[test]
    fn elations_are_exact(c in exact_point(), u in exact_point(), v in exact_point(), x in exact_point()) {
        // An axis through the centre.
        let axis = [0, 1, 2, 3].map(|i| u[i] * dot(v, c) - v[i] * dot(u, c));
        let versor = Collineation::elation(c, axis).expect("the centre is on the axis");
        let factor = dot(axis, x);
        let image: Trivector<Rational> = versor.apply(Trivector::point(x));
        prop_assert_eq!(image, Trivector::point([0, 1, 2, 3].map(|i| x[i] + factor * c[i])));
        prop_assert_eq!(Collineation::elation(c, u).is_some(), dot(u, c) == zero());
    }

    /// Translations move points and keep directions.
    #[test]
    fn translations_shift(t in [exact(), exact(), exact()], x in exact_point()) {
        let image: Trivector<Rational> = Collineation::translation(t).apply(Trivector::point(x));
        let [a, b, c, w] = x;
        prop_assert_eq!(image, Trivector::point([a + t[0] * w, b + t[1] * w, c + t[2] * w, w]));
    }

    /// An odd versor maps points to planes and keeps incidence: the null polarity of a complex.
    #[test]
    fn odd_versors_are_correlations(
        a in [exact(), exact(), exact(), exact(), exact(), exact()], p in exact_point(), plane in exact_point(),
    ) {
        let mirror = Line::from(a);
        prop_assume!(mirror.norm_squared() != zero());
        let image: Trivector<Rational> = mirror.apply(Trivector::point(p));
        prop_assert_eq!(image.plane_part(), image);
        let other: Trivector<Rational> = mirror.apply(Trivector::plane(plane));
        prop_assert_eq!(other.point_part(), other);
        // A null polarity puts every point into its own plane.
        prop_assert_eq!(image.scalar_product(Trivector::point(p)), zero());
        prop_assert_eq!(
            image.scalar_product(other),
            Trivector::point(p).scalar_product(Trivector::plane(plane))
        );
    }

    /// The exponential of a generator is the exponential of the matrix.
    #[test]
    fn exponentials_are_those_of_matrices(rows in float_matrix(), p in float_point(), q in float_point()) {
        let rows = rows.map(|row| row.map(|x| x / 4.0));
        prop_assume!(Vector4::from(p).norm() > 0.1 && Vector4::from(q).norm() > 0.1);
        prop_assume!(apart(p, q) > 1e-2);
        let versor = Collineation::from_generator(Bivector::generator(rows));
        acts_as(versor, columns(rows).exp(), p, q, 1e-9)?;
    }

    /// Any matrix of positive determinant is a versor; one of negative determinant is none.
    #[test]
    fn matrices_become_versors(rows in float_matrix(), p in float_point(), q in float_point()) {
        let matrix = columns(rows);
        let determinant = matrix.determinant();
        prop_assume!(determinant.abs() > 1e-1);
        prop_assume!(Vector4::from(p).norm() > 0.1 && apart(p, q) > 1e-2);
        let versor = Collineation::from_matrix(rows);
        prop_assert_eq!(versor.is_some(), determinant > 0.0);
        if let Some(versor) = versor {
            acts_as(versor, matrix, p, q, 1e-6)?;
        }
    }

    /// Coordinates come back, up to their weight.
    #[test]
    fn coordinates_come_back(p in float_point()) {
        prop_assume!(Vector4::from(p).norm() > 1e-3);
        let found = Trivector::point(p).point_coordinates().expect("a point");
        prop_assert!(apart(found, p) < 1e-14);
        let found = Trivector::plane(p).plane_coordinates().expect("a plane");
        prop_assert!(apart(found, p) < 1e-14);
        prop_assert_eq!(Trivector::point(p).plane_coordinates(), None);
    }

    /// Whatever the numbers, an answer is finite or none.
    #[test]
    fn any_matrix_is_answered(rows in [[any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()],
        [any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()],
        [any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()],
        [any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()]]) {
        if let Some(versor) = Collineation::from_matrix(rows) {
            prop_assert!(versor.to_array().into_iter().all(f64::is_finite));
        }
        if let Some(p) = Trivector::point(rows[0]).point_coordinates() {
            prop_assert!(p.into_iter().all(f64::is_finite));
        }
    }
}

/// Entries of all sizes, whose elations leave the range of numbers on the way.
#[test]
fn matrices_out_of_range_have_no_versor() {
    let rows = [
        [-0.0, 0.0, 0.0, -8.811_606_504_559_09e-67],
        [
            2.882_581_910_224_325_5e-158,
            -5.277_012_715_087_495e-132,
            0.0,
            0.0,
        ],
        [
            -0.0,
            -1.218_760_991_358_939_4e-209,
            0.0,
            1.398_338_428_750_592e60,
        ],
        [
            -1.261_344_384_359_000_8e-70,
            -3.520_577_686_533_822e-87,
            -1.336_741_740_966_254_2e282,
            0.0,
        ],
    ];
    assert_eq!(Collineation::from_matrix(rows), None);
}

/// Scalings, also with two negative factors; none with one, with zero or with no number.
#[test]
fn scalings_need_a_positive_volume() {
    for factors in [[2.0, 3.0, 0.5], [-2.0, 1.0, -1.0], [1.0, 1.0, 1.0]] {
        let versor = Collineation::scaling(factors).expect("a positive volume");
        let [x, y, z] = factors;
        let matrix = Matrix4::from_diagonal(&Vector4::new(x, y, z, 1.0));
        acts_as(
            versor,
            matrix,
            [1.0, -2.0, 3.0, 1.0],
            [0.0, 1.0, 1.0, -2.0],
            1e-14,
        )
        .expect("alike");
    }
    for factors in [
        [-1.0, 1.0, 1.0],
        [0.0, 1.0, 1.0],
        [f64::NAN, 1.0, 1.0],
        [f64::INFINITY, 1.0, 1.0],
    ] {
        assert_eq!(Collineation::scaling(factors), None, "{factors:?}");
    }
}

/// A matrix that needs its rows exchanged, and some that are none.
#[test]
fn matrices_with_zero_pivots() {
    let cycle = [
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let versor = Collineation::from_matrix(cycle).expect("an even permutation");
    acts_as(
        versor,
        columns(cycle),
        [1.0, 2.0, 3.0, 1.0],
        [0.0, 1.0, 0.0, 1.0],
        1e-13,
    )
    .expect("alike");
    let mut mirror = cycle;
    mirror[3][3] = -1.0;
    assert_eq!(Collineation::from_matrix(mirror), None);
    mirror[3][3] = 0.0;
    assert_eq!(Collineation::from_matrix(mirror), None);
    mirror[3][3] = f64::NAN;
    assert_eq!(Collineation::from_matrix(mirror), None);
    assert_eq!(Collineation::from_matrix([[0.0; 4]; 4]), None);
    assert_eq!(Trivector::<f64>::default().point_coordinates(), None);
    assert_eq!(
        (Trivector::point([1.0; 4]) * f64::NAN).point_coordinates(),
        None
    );
    assert_eq!(
        Bivector::generator(columns_of_identity()),
        Bivector::default()
    );
}

fn columns_of_identity() -> [[f64; 4]; 4] {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| f64::from(u8::from(i == j))))
}
