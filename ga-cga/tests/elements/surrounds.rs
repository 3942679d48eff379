//! The sphere about a round, real and imaginary.

use ga_cga::{Circle, DualSphere, PointPair, Sphere};

use super::oracle::{self, Random, close, near, point, vector};

/// (2.60), (2.61): X/(−n_∞⌋X) is the imaginary, X/(X∧n_∞) the real surround, up to weight.
#[test]
fn equations_2_60_and_2_61_surrounds() {
    let mut random = Random::new(24);
    let infinity = DualSphere::infinity();
    for _ in 0..1000 {
        let center = random.position(4.0);
        let radius_squared = 0.1 + 4.0 * random.signed().abs();
        let t = vector(random.direction());
        let pair = PointPair::about(point(center), radius_squared, t);
        let circle = Circle::about(point(center), radius_squared, t.orthogonal_plane());
        let sphere = Sphere::about(point(center), radius_squared);
        let vector_part = |quotient: ga_cga::Multivector| -> DualSphere {
            quotient.narrow(1e-10).expect("a vector")
        };
        let printed_2_60 = [
            vector_part((pair / -(infinity << pair)).into()),
            vector_part((circle / -(infinity << circle)).into()),
        ];
        for surround in printed_2_60 {
            let found = surround.radius_squared().expect("a sphere");
            assert!(
                (found + radius_squared).abs() < 1e-10,
                "(2.60) is the imaginary one"
            );
            close(
                surround.center().expect("a sphere").position(),
                center,
                1e-11,
            );
        }
        // The squared radius X²/(X∧n_∞)², negated for circles.
        let squares = [
            (pair.norm_squared(), pair.carrier().norm_squared(), 1.0),
            (circle.norm_squared(), circle.carrier().norm_squared(), -1.0),
            (sphere.norm_squared(), sphere.carrier().norm_squared(), 1.0),
        ];
        // X X̃ is X² or −X² by the grade; the signs of X and its carrier differ but for circles.
        let squared = |grade: u32, reverse: f64| if grade % 4 < 2 { reverse } else { -reverse };
        for (grade, (own, carrier, sign)) in (2..).zip(squares) {
            let found = sign * squared(grade, own) / squared(grade + 1, carrier);
            assert!((found - radius_squared).abs() < 1e-11, "grade {grade}");
        }
        let printed_2_61 = [
            (
                vector_part((pair / pair.carrier()).into()),
                pair.surround(),
                -1.0,
            ),
            (
                vector_part((circle / circle.carrier()).into()),
                circle.surround(),
                1.0,
            ),
            (
                vector_part((sphere / sphere.carrier()).into()),
                sphere.surround(),
                -1.0,
            ),
        ];
        for (printed, surround, sign) in printed_2_61 {
            near(
                printed.weight(),
                sign,
                1e-13,
                "(2.61): the weight has to be divided out",
            );
            let surround = surround.expect("a sphere");
            near(surround.weight(), 1.0, 1e-15, "normalised");
            assert!(oracle::distance(printed * sign, surround) < 1e-10, "(2.61)");
            let found = surround.radius_squared().expect("a sphere");
            assert!(
                (found - radius_squared).abs() < 1e-11,
                "(2.61) is the real one"
            );
        }
    }
}
