//! serde, bytemuck, approx and rand on the types of the conformal model.

#[cfg(feature = "serde")]
mod serde {
    use ga_cga::{Motor, Point};

    #[test]
    fn fields_have_their_names_and_fixed_coefficients_are_left_out() {
        let json = serde_json::to_string(&Point::at(1.0, 2.0, 2.0)).unwrap();
        assert_eq!(json, r#"{"e1":1.0,"e2":2.0,"e3":2.0,"ni":4.5}"#);
        let motor = Motor::<f32>::from([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
        let json = serde_json::to_string(&motor).unwrap();
        assert_eq!(serde_json::from_str::<Motor<f32>>(&json).unwrap(), motor);
    }

    #[cfg(feature = "wide")]
    #[test]
    fn lanes_are_lists() {
        let lanes = wide::f64x2::new([1.0, 2.0]);
        let points = Point::at(lanes, lanes, lanes);
        let json = serde_json::to_string(&points).unwrap();
        assert_eq!(
            serde_json::from_str::<Point<wide::f64x2>>(&json).unwrap(),
            points
        );
    }
}

#[cfg(feature = "bytemuck")]
#[test]
fn points_are_their_coefficients_in_memory() {
    use ga_cga::{Motor, Point};

    let points = [Point::at(1.0_f32, 2.0, 2.0), Point::at(0.0, 0.0, 1.0)];
    let numbers: &[f32] = bytemuck::cast_slice(&points);
    assert_eq!(numbers, [1.0, 2.0, 2.0, 4.5, 0.0, 0.0, 1.0, 0.5]);
    let mut motors = [Motor::<f64>::default(); 2];
    let numbers: &mut [f64] = bytemuck::cast_slice_mut(&mut motors);
    assert_eq!(numbers.len(), 16);
    numbers[8] = 1.0;
    assert_eq!(motors[1], Motor::identity());
    assert!(bytemuck::try_cast_slice::<u8, Point<f64>>(&[0; 31]).is_err());
}

#[cfg(feature = "approx")]
#[test]
fn rounding_is_approximately_equal() {
    use ga_cga::{Rotor, Vector3};

    let axis = Vector3::new(1.0, 2.0, 3.0);
    let third = Rotor::about_axis(axis, core::f64::consts::TAU / 3.0).unwrap();
    let turned = third.apply(third.apply(third.apply(axis)));
    approx::assert_relative_eq!(turned, axis, max_relative = 1e-14);
    approx::assert_abs_diff_eq!(turned, axis, epsilon = 1e-14);
    approx::assert_abs_diff_ne!(turned, -axis);
    approx::assert_ulps_eq!(axis, axis);
}

#[cfg(feature = "rand")]
#[test]
fn vectors_are_drawn_from_the_unit_cube() {
    use ga_cga::Vector3;
    use rand::distr::{Distribution, StandardUniform};
    use rand::{SeedableRng, rngs::StdRng};

    let drawn = StandardUniform.sample_iter(StdRng::seed_from_u64(1));
    let drawn: Vec<Vector3<f64>> = drawn.take(1000).collect();
    assert!(
        drawn
            .iter()
            .all(|v| v.to_array().iter().all(|c| (0.0..1.0).contains(c)))
    );
    let mean = drawn.iter().sum::<Vector3<f64>>() / 1000.0;
    assert!((mean - Vector3::new(0.5, 0.5, 0.5)).norm() < 0.05, "{mean}");
}

/// A user's own algebra in a crate without unsafe code has the same traits.
mod own {
    ga_macros::define_algebra!(R2_0_1);

    #[cfg(all(feature = "bytemuck", feature = "serde"))]
    #[test]
    fn a_users_own_algebra_has_the_traits() {
        let even = r2_0_1::Even::new(1.0, 2.0, 3.0, 4.0);
        assert_eq!(bytemuck::cast::<_, [f64; 4]>(even), even.to_array());
        let json = serde_json::to_value(even).unwrap();
        assert_eq!(json["s"], 1.0);
        assert_eq!(serde_json::from_value::<r2_0_1::Even>(json).unwrap(), even);
    }
}
