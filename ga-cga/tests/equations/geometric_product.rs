//! §2.2.1 to §2.2.4: the axioms, basis blades and the geometric product, (2.1) to (2.15).

use ga_core::Rational;

use super::euclidean::{r1_1_1, r2, r3};
use super::samples::{close, each, near, unit};

type Vector = r3::Vector<Rational>;
type Multivector = r3::Multivector<Rational>;

fn scalar(value: Rational) -> r3::Scalar<Rational> {
    r3::Scalar::new(value)
}

/// a·b = f(a)·f(b) for the orthogonal transformations f, which are the versors.
#[test]
fn equation_2_1_versors_preserve_the_inner_product() {
    each(|samples| {
        let [a, b, u, v, w]: [Vector; 5] = std::array::from_fn(|_| samples.element());
        assert_eq!(u.apply(a) | u.apply(b), a | b);
        let rotation = u * v;
        assert_eq!(rotation.apply(a) | rotation.apply(b), a | b);
        let both = u * v * w;
        assert_eq!(both.apply(a) | both.apply(b), a | b);
    });
}

/// ⟨v, v⟩ = α² + β², and v² = α²e₁e₁ + β²e₂e₂ + αβ(e₁e₂ + e₂e₁) is the same number.
#[test]
fn equations_2_2_and_2_3_the_square_of_a_vector_is_its_metric() {
    each(|samples| {
        let [alpha, beta]: [Rational; 2] = std::array::from_fn(|_| samples.number());
        let v = r2::Vector::new(alpha, beta);
        let [e1, e2]: [r2::Vector<Rational>; 2] = std::array::from_fn(unit);
        assert_eq!(v.norm_squared(), alpha * alpha + beta * beta);
        let square = v * v;
        let expanded = (e1 * e1) * (alpha * alpha)
            + (e2 * e2) * (beta * beta)
            + (e1 * e2 + e2 * e1) * (alpha * beta);
        assert_eq!(square, expanded);
        let number = r2::Scalar::new(alpha * alpha + beta * beta);
        assert_eq!(square, r2::Even::from(number));
    });
}

/// e_i² = ⟨e_i, e_i⟩ = 1.
#[test]
fn equation_2_4_basis_vectors_square_to_one() {
    for i in 0..3 {
        let e: Vector = unit(i);
        assert_eq!(e * e, scalar(1.into()).into());
        assert_eq!(e.norm_squared(), 1.into());
    }
}

/// e_i e_j = −e_j e_i for i ≠ j.
#[test]
fn equation_2_5_different_basis_vectors_anticommute() {
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let (a, b): (Vector, Vector) = (unit(i), unit(j));
        assert_eq!(a * b, -(b * a));
        assert_ne!(a * b, b * a);
    }
}

/// e_i e_j = e_ij: the product of two basis vectors is the basis blade of both subscripts.
#[test]
fn equation_2_6_subscripts_are_concatenated() {
    for (position, (i, j)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
        let (a, b): (Vector, Vector) = (unit(i), unit(j));
        let blade: r3::Bivector<Rational> = unit(position);
        assert_eq!(a * b, blade.into());
        let label = format!("e{}{}", i + 1, j + 1);
        assert_eq!(format!("{}", a * b), label);
    }
    // The example of the subscript rules: e12 e123 = −e3.
    let e12: r3::Bivector<Rational> = unit(0);
    let volume: r3::Trivector<Rational> = unit(0);
    assert_eq!(e12 * volume, -unit::<Vector>(2));
}

/// e_i ∧ e_j = e_ij if i ≠ j, 0 if i = j; stated twice.
#[test]
fn equations_2_7_and_2_15_the_outer_product_of_basis_vectors() {
    for i in 0..3 {
        for j in 0..3 {
            let (a, b): (Vector, Vector) = (unit(i), unit(j));
            let expected = if i == j {
                r3::Bivector::default().into()
            } else {
                a * b
            };
            assert_eq!(r3::Even::from(a ^ b), expected);
        }
    }
}

/// e_i·e_j = m_i δ_ij, with the m_i of the signature; δ is the Kronecker delta of (2.9).
#[test]
fn equations_2_8_and_2_9_the_inner_product_of_basis_vectors_is_the_metric() {
    for (i, m) in [1, -1, 0].into_iter().enumerate() {
        for j in 0..3 {
            let (a, b): (r1_1_1::Vector<Rational>, r1_1_1::Vector<Rational>) = (unit(i), unit(j));
            let expected = if i == j { m } else { 0 };
            assert_eq!(a | b, r1_1_1::Scalar::new(expected.into()));
        }
    }
}

/// e_i·e_j = δ_ij in Euclidean space.
#[test]
fn equation_2_10_the_euclidean_metric() {
    for i in 0..3 {
        for j in 0..3 {
            let (a, b): (Vector, Vector) = (unit(i), unit(j));
            assert_eq!(a | b, scalar(Rational::from_integer((i == j).into())));
        }
    }
}

/// (ab)c = a(bc), for vectors and for everything made of them.
#[test]
fn equation_2_11_the_geometric_product_is_associative() {
    each(|samples| {
        let [a, b, c]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        assert_eq!((a * b) * c, a * (b * c));
        let [x, y, z]: [Multivector; 3] = std::array::from_fn(|_| samples.element());
        assert_eq!((x * y) * z, x * (y * z));
    });
}

/// a ∧ b = −b ∧ a.
#[test]
fn equation_2_12_the_outer_product_of_vectors_is_antisymmetric() {
    each(|samples| {
        let [a, b]: [Vector; 2] = std::array::from_fn(|_| samples.element());
        assert_eq!(a ^ b, -(b ^ a));
        assert_eq!(a ^ a, r3::Bivector::default());
    });
}

/// ab = a·b + a∧b, in the coefficients that §2.2.4 multiplies out.
#[test]
fn equation_2_13_the_geometric_product_is_inner_plus_outer() {
    each(|samples| {
        let [a, b]: [Vector; 2] = std::array::from_fn(|_| samples.element());
        assert_eq!(a * b, r3::Even::from(a | b) + r3::Even::from(a ^ b));
        let ([a1, a2, a3], [b1, b2, b3]) = (a.to_array(), b.to_array());
        let inner = a1 * b1 + a2 * b2 + a3 * b3;
        let outer = [a1 * b2 - a2 * b1, a1 * b3 - a3 * b1, a2 * b3 - a3 * b2];
        assert_eq!(a | b, scalar(inner));
        assert_eq!(a ^ b, r3::Bivector::from(outer));
    });
}

/// ab = cos θ + B sin θ for unit vectors, B the unit blade a∧b/‖a∧b‖; the tolerance is 1e-14.
#[test]
fn equation_2_14_the_product_of_unit_vectors_is_cosine_and_sine() {
    each(|samples| {
        let [a, b]: [r3::Vector; 2] = std::array::from_fn(|_| {
            samples
                .element::<r3::Vector>()
                .normalized()
                .expect("length")
        });
        // The angle by the law of cosines on the chord, without any product of a and b.
        let theta = 2.0 * ((a - b).norm() / 2.0).asin();
        let plane = (a ^ b).normalized().expect("not parallel");
        let expected =
            r3::Even::from(r3::Scalar::new(theta.cos())) + r3::Even::from(plane * theta.sin());
        close(a * b, expected, 1e-14);
        near((plane * plane).s, -1.0, 1e-15);
    });
}
