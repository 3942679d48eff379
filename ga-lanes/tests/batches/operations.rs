//! Products, versors, involutions: what has a value for every element.

use ga_core::Unit;
use ga_core::ops::{ApplyUnit, Outermorphism, Versor};
use ga_lanes::{Batch, LengthMismatch, Number, One};

use super::plane;
use super::r3;
use super::samples::{LENGTHS, assert_same, elements, on_every_target};

macro_rules! binary {
    ($float:ident: $($algebra:ident $A:ident $B:ident: $($method:ident $into:ident)*;)*) => {{$(
        for len in LENGTHS {
            let a = elements::<$algebra::$A<$float>>(len, 1);
            let b = elements::<$algebra::$B<$float>>(len, 2);
            let (first, second) = (Batch::from_slice(&a), Batch::from_slice(&b));
            let one_a = elements::<$algebra::$A<$float>>(1, 3)[0];
            let one_b = elements::<$algebra::$B<$float>>(1, 4)[0];
            $({
                let name = concat!(stringify!($A), ".", stringify!($method), "(", stringify!($B), ")");
                let pairs = a.iter().zip(&b);
                let each: Vec<_> = pairs.map(|(a, b)| a.$method(*b)).collect();
                assert_same(&first.$method(&second).unwrap(), &each, name);
                let left: Vec<_> = b.iter().map(|b| one_a.$method(*b)).collect();
                assert_same(&One(one_a).$method(&second), &left, name);
                let right: Vec<_> = a.iter().map(|a| a.$method(one_b)).collect();
                assert_same(&first.$method(One(one_b)).unwrap(), &right, name);
                // Into a batch that is longer, and into one that is shorter.
                for former in [0, 40] {
                    let mut out = Batch::zeros(former);
                    first.$into(&second, &mut out).unwrap();
                    assert_same(&out, &each, name);
                    One(one_a).$into(&second, &mut out);
                    assert_same(&out, &left, name);
                }
            })*
        }
    )*}};
}

macro_rules! unary {
    ($float:ident: $($algebra:ident $A:ident: $($method:ident)*;)*) => {{$(
        for len in LENGTHS {
            let a = elements::<$algebra::$A<$float>>(len, 5);
            let batch = Batch::from_slice(&a);
            $({
                let name = concat!(stringify!($A), ".", stringify!($method), "()");
                let each: Vec<_> = a.iter().map(|a| a.$method()).collect();
                assert_same(&batch.$method(), &each, name);
            })*
        }
    )*}};
}

macro_rules! all {
    ($float:ident) => {{
        binary! { $float:
            r3 Vector Vector: geometric geometric_into wedge wedge_into inner inner_into
                left_contract left_contract_into right_contract right_contract_into
                scalar_product scalar_product_into commutator commutator_into
                anticommutator anticommutator_into;
            r3 Bivector Bivector: regressive regressive_into;
            r3 Even Vector: apply apply_into sandwich sandwich_into quotient quotient_into;
            r3 Multivector Multivector: geometric geometric_into wedge wedge_into;
            plane Point Point: geometric geometric_into wedge wedge_into inner inner_into;
            plane Circle Circle: regressive regressive_into geometric geometric_into;
            plane Motor Point: apply apply_into sandwich sandwich_into;
            plane Motor Circle: apply apply_into;
            plane Motor Motor: geometric geometric_into;
            plane Vector Pair: left_contract left_contract_into apply apply_into;
            plane Even Even: geometric geometric_into commutator commutator_into;
        }
        unary! { $float:
            r3 Even: reverse involute conjugate dual undual left_complement right_complement
                norm_squared norm;
            r3 Bivector: exp;
            plane Point: reverse dual norm_squared norm;
            plane Pair: reverse dual exp norm;
            plane Even: reverse involute norm_squared;
        }
    }};
}

#[test]
fn single_precision_agrees_with_single_elements() {
    on_every_target(|| {
        all!(f32);
    });
}

#[test]
fn double_precision_agrees_with_single_elements() {
    on_every_target(|| {
        all!(f64);
    });
}

#[test]
fn sums_multiples_and_negatives_agree_with_single_elements() {
    on_every_target(|| {
        for len in LENGTHS {
            let a = elements::<plane::Vector<f64>>(len, 6);
            let b = elements::<plane::Point<f64>>(len, 7);
            let numbers = elements::<f64>(len, 8);
            let (first, second) = (Batch::from_slice(&a), Batch::from_slice(&b));
            let factors = Batch::from_slice(&numbers);
            let zip = |f: fn(plane::Vector<f64>, plane::Point<f64>) -> plane::Vector<f64>| {
                a.iter().zip(&b).map(|(a, b)| f(*a, *b)).collect::<Vec<_>>()
            };
            assert_same(&first.plus(&second).unwrap(), &zip(|a, b| a + b), "plus");
            assert_same(&first.minus(&second).unwrap(), &zip(|a, b| a - b), "minus");
            let opposite: Vec<_> = a.iter().map(|a| -a).collect();
            assert_same(&first.opposite(), &opposite, "opposite");
            let multiples: Vec<_> = a.iter().zip(&numbers).map(|(a, n)| *a * *n).collect();
            assert_same(&first.geometric(&factors).unwrap(), &multiples, "multiples");
            let quotients: Vec<_> = a.iter().map(|a| *a / 3.0).collect();
            assert_same(&first.quotient(One(3.0)).unwrap(), &quotients, "quotients");
        }
    });
}

#[test]
fn operations_in_place_replace_the_right_operand() {
    on_every_target(|| {
        for len in LENGTHS {
            let motors = elements::<plane::Motor<f32>>(len, 9);
            let points = elements::<plane::Point<f32>>(len, 10);
            let one = elements::<plane::Motor<f32>>(1, 11)[0];
            let mut batch = Batch::from_slice(&points);
            Batch::from_slice(&motors)
                .apply_in_place(&mut batch)
                .unwrap();
            let moved: Vec<_> = motors
                .iter()
                .zip(&points)
                .map(|(m, p)| m.apply(*p))
                .collect();
            assert_same(&batch, &moved, "apply_in_place");
            let mut batch = Batch::from_slice(&points);
            One(one).apply_in_place(&mut batch);
            let moved: Vec<_> = points.iter().map(|p| one.apply(*p)).collect();
            assert_same(&batch, &moved, "apply_in_place");
        }
    });
}

#[test]
fn unit_versors_apply_as_single_ones_do() {
    on_every_target(|| {
        for len in LENGTHS {
            let rotors: Vec<_> = elements::<r3::Even<f64>>(len, 14)
                .into_iter()
                .filter_map(Unit::new)
                .collect();
            let vectors = elements::<r3::Vector<f64>>(len, 15);
            let (units, batch) = (Batch::from_slice(&rotors), Batch::from_slice(&vectors));
            let pairs = rotors.iter().zip(&vectors);
            let turned: Vec<_> = pairs.map(|(r, x)| r.apply(*x)).collect();
            assert_same(&units.apply(&batch).unwrap(), &turned, "apply");
            let back: Vec<_> = rotors.iter().map(|r| r.reverse()).collect();
            assert_same(&units.reverse(), &back, "reverse");
            if let Some(one) = rotors.first() {
                let turned: Vec<_> = vectors.iter().map(|x| one.apply(*x)).collect();
                assert_same(&One(*one).apply(&batch), &turned, "apply");
            }
        }
    });
}

/// One versor on every element, against matrices of single numbers where there are enough elements
/// for one.
macro_rules! linear {
    ($($float:ident $algebra:ident $Versor:ident $Operand:ident;)*) => {{$(
        // The last is long enough for a matrix.
        for len in LENGTHS.into_iter().chain([1003]) {
            let versor = elements::<$algebra::$Versor<$float>>(1, 21)[0];
            let operands = elements::<$algebra::$Operand<$float>>(len, 22);
            let map = versor.linear_map::<$algebra::$Operand<$float>>();
            let least = <$algebra::$Versor<$float> as Outermorphism<$algebra::$Operand<$float>>>::WORTHWHILE;
            let by_matrix = least.is_some_and(|least| len >= least * <$float as Number>::LINE);
            let image = |x: &$algebra::$Operand<$float>| match by_matrix {
                true => map.apply(*x),
                false => versor.apply_with(versor.over_norm(), *x),
            };
            let expected: Vec<_> = operands.iter().map(image).collect();
            let mut batch = Batch::from_slice(&operands);
            assert_same(&One(versor).apply_linear(&batch), &expected, "linear");
            for former in [0, 40] {
                let mut out = Batch::zeros(former);
                One(versor).apply_linear_into(&batch, &mut out);
                assert_same(&out, &expected, "linear into");
            }
            One(versor).apply_linear_in_place(&mut batch);
            assert_same(&batch, &expected, "linear in place");
        }
    )*}};
}

#[test]
fn matrices_of_versors_act_as_those_of_single_ones() {
    on_every_target(|| {
        linear! {
            f32 r3 Even Vector;
            f64 r3 Even Vector;
            f64 r3 Even Bivector;
            f64 r3 Vector Vector;
            f32 plane Motor Point;
            f64 plane Motor Point;
            f64 plane Motor Circle;
            f64 plane Even Vector;
            f64 plane Even Pair;
        }
    });
}

#[test]
fn matrices_of_null_versors_give_no_numbers() {
    on_every_target(|| {
        let vectors = Batch::from_slice(&elements::<r3::Vector<f64>>(20, 1));
        let images = One(r3::Even::<f64>::default()).apply_linear(&vectors);
        assert!(
            images
                .iter()
                .all(|image| image.e1.is_nan() && image.e3.is_nan())
        );
        assert!(
            One(r3::Even::<f64>::default())
                .apply_linear(&Batch::<r3::Vector>::new())
                .is_empty()
        );
    });
}

#[test]
fn batches_of_different_lengths_are_refused() {
    let motors = Batch::from_slice(&elements::<plane::Motor<f64>>(7, 1));
    let points = elements::<plane::Point<f64>>(9, 2);
    let mut batch = Batch::from_slice(&points);
    let mismatch = LengthMismatch { left: 7, right: 9 };
    assert_eq!(motors.apply(&batch), Err(mismatch));
    assert_eq!(motors.apply_in_place(&mut batch), Err(mismatch));
    assert_eq!(batch.to_vec(), points);
    let mut out = Batch::from_slice(&points[..2]);
    assert_eq!(motors.apply_into(&batch, &mut out), Err(mismatch));
    assert_eq!(out.to_vec(), points[..2]);
    assert_eq!(
        mismatch.to_string(),
        "7 elements do not go with 9 one by one; give as many on both sides"
    );
}
