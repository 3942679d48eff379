//! Functions of the user's own, and the lanes that they see.

use ga_core::Real;
use ga_lanes::{Batch, Kernel, Lanes, Map, Number, Target, ZipMap, dispatch, dispatch_on};

use super::plane::{Circle, Motor, Point, Vector};
use super::samples::{LENGTHS, assert_same, elements, on_every_target};

/// The circle through a point, its image and the image of that.
struct Orbit;

impl ZipMap<Motor<f64>, Point<f64>> for Orbit {
    type Output = Circle<f64>;

    #[inline(always)]
    fn call<L: Lanes<f64>>(&self, motor: Motor<L>, point: Point<L>) -> Circle<L> {
        let image = motor.apply(point);
        point ^ image ^ motor.apply(image)
    }
}

/// A number for each element.
struct Weight(f64);

impl Map<Vector<f64>> for Weight {
    type Output = f64;

    #[inline(always)]
    fn call<L: Lanes<f64>>(&self, x: Vector<L>) -> L {
        x.no.select_le(L::splat(self.0), L::ZERO, x.no)
    }
}

/// The mirror image in the line that is perpendicular to e₁.
struct Mirror;

impl Map<Vector<f64>> for Mirror {
    type Output = Vector<f64>;

    #[inline(always)]
    fn call<L: Lanes<f64>>(&self, x: Vector<L>) -> Vector<L> {
        Vector { e1: -x.e1, ..x }
    }
}

#[test]
fn functions_of_ones_own_agree_with_single_elements() {
    on_every_target(|| {
        for len in LENGTHS {
            let (motors, points) = (
                elements::<Motor<f64>>(len, 1),
                elements::<Point<f64>>(len, 2),
            );
            let orbits = Batch::from_slice(&motors).zip_map(&Batch::from_slice(&points), &Orbit);
            let expected: Vec<_> = motors
                .iter()
                .zip(&points)
                .map(|(motor, point)| {
                    let image = motor.apply(*point);
                    *point ^ image ^ motor.apply(image)
                })
                .collect();
            assert_same(&orbits.unwrap(), &expected, "orbit");

            let vectors = elements::<Vector<f64>>(len, 3);
            let mut batch = Batch::from_slice(&vectors);
            let weights: Vec<_> = vectors
                .iter()
                .map(|x| if x.no <= 0.5 { 0.0 } else { x.no })
                .collect();
            assert_eq!(batch.map(&Weight(0.5)).to_vec(), weights);
            batch.map_in_place(&Mirror);
            let mirrored: Vec<_> = vectors.iter().map(|x| Vector { e1: -x.e1, ..*x }).collect();
            assert_eq!(batch.to_vec(), mirrored);
        }
    });
}

/// How many lanes there are, and whether what they compute is right in each.
struct Arithmetic;

impl<F: Number + Into<f64>> Kernel<F> for Arithmetic {
    type Output = usize;

    #[inline(always)]
    fn run<L: Lanes<F>>(self) -> usize {
        let numbers = L::array(|lane| F::from_f64(lane as f64 - 1.5));
        let x = L::load(&numbers);
        let (two, half) = (L::from_integer(2), L::from_ratio(1, 2));
        let check = |result: L, expected: &dyn Fn(f64) -> f64| {
            let mut array = numbers;
            result.store(&mut array);
            for (own, number) in array.as_ref().iter().zip(numbers.as_ref()) {
                let (own, expected) = ((*own).into(), expected((*number).into()));
                let near =
                    (own - expected).abs() <= <F as Real>::EPSILON.into() * 4.0 * expected.abs();
                assert!(
                    near || own.is_nan() && expected.is_nan(),
                    "{own} not {expected}"
                );
            }
        };
        check(x + two, &|x| x + 2.0);
        check(x - two, &|x| x - 2.0);
        check(x * half, &|x| x / 2.0);
        check(two / x, &|x| 2.0 / x);
        check(-x, &|x| -x);
        check(x.abs(), &f64::abs);
        check(x.sqrt(), &f64::sqrt);
        check(x.plus_product(two, x), &|x| 3.0 * x);
        check(x.minus_product(two, half), &|x| x - 1.0);
        check(x.select_le(half, two, x), &|x| {
            if x <= 0.5 { 2.0 } else { x }
        });
        check(x.exp(), &f64::exp);
        check(x.ln(), &f64::ln);
        check(x.sin_cos().0, &f64::sin);
        check(x.sin_cos().1, &f64::cos);
        check(x.atan2(half), &|x| x.atan2(0.5));
        check(L::PI * x, &|x| std::f64::consts::PI * x);
        check((x * L::from_integer(5)).exp(), &|x| (5.0 * x).exp());
        assert!(x.all_le(L::from_integer(20)) && !x.all_le(two - L::from_integer(3)));
        assert!(x.is_finite() && !(x / L::ZERO).is_finite() && !x.sqrt().is_finite());
        let same = x;
        assert!(x.is_invertible() && !(x - same).is_invertible());
        assert!(!(x + L::from_ratio(3, 2)).is_invertible());
        assert!(x == same && x != x + half && x.sqrt() != x.sqrt());
        assert_eq!(format!("{:?}", L::ONE).matches('1').count(), L::COUNT);
        assert_eq!(L::default(), L::ZERO);
        L::COUNT
    }
}

#[test]
fn lanes_compute_what_numbers_do() {
    let counts = |target| {
        let single = dispatch_on::<f32, _>(target, Arithmetic);
        (single, dispatch_on::<f64, _>(target, Arithmetic))
    };
    assert_eq!(counts(Target::Portable), (Some(4), Some(2)));
    for (target, single, double) in [(Target::V3, 8, 4), (Target::V4, 16, 8)] {
        let expected = target.is_available().then_some(());
        assert_eq!(
            counts(target),
            (expected.map(|()| single), expected.map(|()| double))
        );
        let scoped = target.scope(|| dispatch::<f64, _>(Arithmetic));
        assert_eq!(scoped, expected.map(|()| double));
    }
}
