//! Whatever finite numbers come in, no transformation panics or answers with a number that is
//! none.

use crate::random::size;
use ga_cga::*;
use proptest::prelude::*;

/// Numbers of all sizes, with zeros and extremes often.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        1 => prop::sample::select(vec![f64::MAX, -f64::MAX, f64::MIN_POSITIVE, 5e-324, 1e200, -1e-200]),
        4 => -2.0..2.0_f64,
        2 => prop::num::f64::NORMAL,
    ]
}

fn vector() -> impl Strategy<Value = Vector3> {
    prop::array::uniform3(number()).prop_map(Vector3::from)
}

fn finite<X>(answer: Option<X>) -> bool
where
    X: ga_core::ops::Element<Number = f64>,
{
    answer.is_none_or(|x| (0..X::BLADES.len()).all(|i| x.at(i).is_finite()))
}

proptest! {
    #[test]
    fn constructions_answer_or_refuse(a in vector(), b in vector(), t in number(), h in number()) {
        let plane = Bivector3::from(b.to_array());
        prop_assert!(finite(Rotor::between(a, b)));
        prop_assert!(finite(Rotor::between(a, -a)));
        prop_assert!(finite(Rotor::between_in(a, -a, plane)));
        prop_assert!(finite(Rotor::between_planes(Bivector3::from(a.to_array()), plane)));
        prop_assert!(finite(Rotor::turn(plane, t)));
        prop_assert!(finite(Rotor::about_axis(a, t)));
        prop_assert!(finite(Dilator::scaling(t)));
        let [x, y, z] = a.to_array();
        let [u, v, w] = b.to_array();
        let line = DualLine::new(x, y, z, u, v, w);
        prop_assert!(finite(Motor::about_line(line, t)));
        prop_assert!(finite(Motor::screw(line, t, h).filter(|m| size(*m).is_finite())));
        let motor = Motor::new(t, x, y, z, u, v, w, h);
        prop_assert!(finite(motor.renormalized()));
        prop_assert!(finite(motor.rotation()));
    }

    #[test]
    fn images_of_points_are_points_or_nothing(
        coefficients in prop::array::uniform16(number()), p in vector(),
    ) {
        let p = Point::from(p);
        let even = Even::from(coefficients);
        prop_assert!(finite(p.image_under(even)));
        prop_assert!(finite(p.image_under(Odd::from(coefficients))));
        prop_assert!(finite(even.renormalized()));
        if let Some((scaling, rotation, translation)) = even.similarity_parts(1e-6) {
            prop_assert!(finite(Some(scaling)) && finite(Some(rotation)));
            prop_assert!(finite(Some(translation)));
        }
        if let Some(matrix) = even.to_matrix(1e-6) {
            prop_assert!(matrix.as_flattened().iter().all(|c| c.is_finite()));
        }
    }

    #[test]
    fn matrices_are_taken_or_refused(
        rows in prop::array::uniform4(prop::array::uniform4(number())),
        infinite in prop::sample::select(vec![f64::NAN, f64::INFINITY]),
    ) {
        let mut affine = rows;
        affine[3] = [0.0, 0.0, 0.0, 1.0];
        for matrix in [rows, affine] {
            prop_assert!(finite(Motor::from_matrix(matrix, 1e-6).ok()));
            prop_assert!(finite(Even::from_matrix(matrix, 1e-6).ok()));
        }
        affine[1][2] = infinite;
        prop_assert_eq!(
            Motor::from_matrix(affine, 1e-6),
            Err(interop::MatrixError::NotFinite)
        );
    }
}

/// Null versors of every kind take no point anywhere.
#[test]
fn null_versors_have_no_images() {
    let p = Point::at(1.0, 2.0, 3.0);
    assert_eq!(p.image_under(DualSphere::<f64>::default()), None);
    assert_eq!(p.image_under(DualSphere::<f64>::infinity()), None);
    assert_eq!(
        p.image_under(DualSphere::from(Point::at(0.0, 0.0, 1.0))),
        None
    );
    assert_eq!(p.image_under(Motor::<f64>::default()), None);
    assert_eq!(p.image_under(Dilator::new(1.0, 1.0)), None);
    assert_eq!(p.image_under(Odd::<f64>::default()), None);
    assert_eq!(p.image_under(PointPair::<f64>::default()), None);
    assert_eq!(p.image_under(Circle::<f64>::default()), None);
    assert_eq!(Motor::<f64>::default().translation(), None);
    assert_eq!(Motor::<f64>::default().to_matrix(), None);
    assert_eq!(Rotor::<f64>::default().to_matrix(), None);
}
