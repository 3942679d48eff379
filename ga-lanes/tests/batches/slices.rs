//! Slices of structs against single elements, on every target, whatever is left behind the last
//! whole block.

use std::ops::Sub;

use ga_core::{Blade, Element, Scalar, Unit};
use ga_lanes::{Lanes, LengthMismatch, Map, Number, One, ZipMap, slices};

use super::plane;
use super::r3;
use super::samples::{assert_same_element, elements, on_every_target};

/// Up to one more than two blocks of the longest: 8 lanes.
const LENGTHS: std::ops::RangeInclusive<usize> = 0..=17;

/// Asserts that the elements of a slice are others up to rounding.
fn assert_same<X>(slice: &[X], expected: &[X], operation: &str)
where
    X: Element<Number: Number + Into<f64>> + std::fmt::Debug,
{
    assert_eq!(slice.len(), expected.len(), "{operation}");
    for (index, (one, other)) in slice.iter().zip(expected).enumerate() {
        assert_same_element(
            one,
            other,
            &format!("{operation} at {index} of {}", slice.len()),
        );
    }
}

macro_rules! binary {
    ($float:ident: $($algebra:ident $A:ident $B:ident: $($method:ident)*;)*) => {{$(
        for len in LENGTHS {
            let a = elements::<$algebra::$A<$float>>(len, 1);
            let b = elements::<$algebra::$B<$float>>(len, 2);
            let one_a = elements::<$algebra::$A<$float>>(1, 3)[0];
            let one_b = elements::<$algebra::$B<$float>>(1, 4)[0];
            $({
                let name = concat!(stringify!($A), ".", stringify!($method), "(", stringify!($B), ")");
                let each: Vec<_> = a.iter().zip(&b).map(|(a, b)| a.$method(*b)).collect();
                let mut out = vec![Default::default(); len];
                slices::$method(a.as_slice(), &b, &mut out).unwrap();
                assert_same(&out, &each, name);
                let each: Vec<_> = b.iter().map(|b| one_a.$method(*b)).collect();
                slices::$method(One(one_a), &b, &mut out).unwrap();
                assert_same(&out, &each, name);
                let each: Vec<_> = a.iter().map(|a| a.$method(one_b)).collect();
                slices::$method(&a, One(one_b), &mut out).unwrap();
                assert_same(&out, &each, name);
                slices::$method(One(one_a), One(one_b), &mut out).unwrap();
                assert_same(&out, &vec![one_a.$method(one_b); len], name);
            })*
        }
    )*}};
}

macro_rules! all {
    ($float:ident) => {
        binary! { $float:
            r3 Vector Vector: geometric wedge inner left_contract right_contract scalar_product
                commutator anticommutator;
            r3 Bivector Bivector: regressive;
            r3 Even Vector: apply sandwich quotient;
            r3 Trivector Scalar: geometric;
            r3 Multivector Multivector: geometric wedge;
            plane Point Point: geometric wedge inner;
            plane Circle Circle: regressive geometric;
            plane Motor Point: apply sandwich;
            plane Motor Motor: geometric;
            plane Vector Pair: left_contract apply;
            space Multivector Vector: wedge;
            space Multivector Multivector: left_contract;
        }
    };
}

// Five dimensions: 32 coefficients, more than are transposed in registers.
ga_macros::define_algebra! {
    crate = ga_core;
    /// Exterior algebra of five dimensions.
    mod space: R5 {
        products { wedge, left_contract }
    }
}

#[test]
fn single_precision_agrees_with_single_elements() {
    on_every_target(|| all!(f32));
}

#[test]
fn double_precision_agrees_with_single_elements() {
    on_every_target(|| all!(f64));
}

macro_rules! widths {
    ($float:ident $($Type:ident)*) => {$(
        for len in LENGTHS {
            let a = elements::<widths::$Type<$float>>(len, 5);
            let b = elements::<widths::$Type<$float>>(len, 6);
            let mut out = vec![widths::$Type::default(); len];
            slices::minus(&a, &b, &mut out).unwrap();
            let each: Vec<_> = a.iter().zip(&b).map(|(a, b)| *a - *b).collect();
            // One subtraction: nothing is rounded twice, so that every bit is the same.
            assert_eq!(out, each, "{} of {len}", stringify!($Type));
            slices::minus_in_place(&a, &mut out).unwrap();
            let each: Vec<_> = a.iter().zip(&each).map(|(a, b)| *a - *b).collect();
            assert_eq!(out, each, "{} of {len} in place", stringify!($Type));
        }
    )*};
}

ga_macros::define_algebra! {
    crate = ga_core;
    /// Types of one to nine coefficients, and of sixteen and seventeen.
    mod widths: R5 {
        types {
            One { e1 }
            Two { e1, e2 }
            Three { e1, e2, e3 }
            Four { e1, e2, e3, e4 }
            Five { e1, e2, e3, e4, e5 }
            Six { 1, e1, e2, e3, e4, e5 }
            Seven { e12, e1, e2, e3, e4, e5, 1 }
            Eight { e12, e13, e1, e2, e3, e4, e5, 1 }
            Nine { e12, e13, e14, e1, e2, e3, e4, e5, 1 }
            Sixteen = even;
            Seventeen {
                1, e1, e2, e3, e4, e5, e12, e13, e14, e15, e23, e24, e25, e34, e35, e45, e12345
            }
        }
        products { wedge }
    }
}

#[test]
fn structs_of_any_length_are_read_and_written_whole() {
    on_every_target(|| {
        widths!(f32 One Two Three Four Five Six Seven Eight Nine Sixteen Seventeen);
        widths!(f64 One Two Three Four Five Six Seven Eight Nine Sixteen Seventeen);
    });
}

/// An element by hand, which stores its coefficients in the opposite order, behind something else.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Backwards<T> {
    mark: u64,
    last: T,
    first: T,
}

impl<T: Scalar> Element for Backwards<T> {
    type Number = T;
    type Over<U: Scalar> = Backwards<U>;
    const BLADES: &'static [(Blade, i8)] = &[(Blade::new(1), 1), (Blade::new(2), 1)];
    const FIXED: &'static [(Blade, i8, i64, i64)] = &[];
    const LABELS: &'static [&'static str] = &["e1", "e2"];

    fn at(&self, position: usize) -> T {
        self.place(position).copied().unwrap_or(T::ZERO)
    }

    fn from_fn(mut coefficient: impl FnMut(usize) -> T) -> Self {
        let (mark, first) = (7, coefficient(0));
        let last = coefficient(1);
        Backwards { mark, last, first }
    }

    fn place(&self, position: usize) -> Option<&T> {
        [&self.first, &self.last].get(position).copied()
    }
}

impl<T: Scalar> Sub for Backwards<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Backwards::from_fn(|position| self.at(position) - other.at(position))
    }
}

#[test]
fn elements_of_another_layout_are_read_and_written_as_they_say() {
    on_every_target(|| {
        for len in LENGTHS {
            let a = elements::<Backwards<f32>>(len, 22);
            let b = elements::<Backwards<f32>>(len, 23);
            let mut out = b.clone();
            slices::minus(&a, &b, &mut out).unwrap();
            let each: Vec<_> = a.iter().zip(&b).map(|(a, b)| *a - *b).collect();
            assert_eq!(out, each);
        }
    });
}

#[test]
fn numbers_are_elements() {
    on_every_target(|| {
        for len in LENGTHS {
            let vectors = elements::<r3::Vector<f32>>(len, 7);
            let numbers = elements::<f32>(len, 8);
            let mut out = vec![r3::Vector::default(); len];
            slices::geometric(&vectors, &numbers, &mut out).unwrap();
            let pairs = vectors.iter().zip(&numbers);
            let each: Vec<_> = pairs.map(|(x, n)| *x * *n).collect();
            assert_same(&out, &each, "multiples");
            let mut sums = vec![0.0; len];
            slices::plus(&numbers, One(1.5), &mut sums).unwrap();
            let each: Vec<_> = numbers.iter().map(|n| n + 1.5).collect();
            assert_eq!(sums, each);
        }
    });
}

#[test]
fn unit_versors_stay_unit_versors() {
    on_every_target(|| {
        for len in LENGTHS {
            let rotors: Vec<_> = elements::<r3::Even<f64>>(len, 9)
                .into_iter()
                .filter_map(Unit::new)
                .collect();
            let vectors = elements::<r3::Vector<f64>>(rotors.len(), 10);
            let mut turned = vec![r3::Vector::default(); rotors.len()];
            slices::apply(&rotors, &vectors, &mut turned).unwrap();
            let pairs = rotors.iter().zip(&vectors);
            let each: Vec<_> = pairs.map(|(r, x)| r.apply(*x)).collect();
            assert_same(&turned, &each, "apply");
            let mut squares = rotors.clone();
            slices::geometric(&rotors, &rotors, &mut squares).unwrap();
            let each: Vec<Unit<_>> = rotors.iter().map(|r| *r * *r).collect();
            assert_same(&squares, &each, "geometric");
        }
    });
}

#[test]
fn operations_in_place_replace_the_right_operand() {
    on_every_target(|| {
        for len in LENGTHS {
            let motors = elements::<plane::Motor<f32>>(len, 11);
            let points = elements::<plane::Point<f32>>(len, 12);
            let one = elements::<plane::Motor<f32>>(1, 13)[0];
            let mut moved = points.clone();
            slices::apply_in_place(&motors, &mut moved).unwrap();
            let pairs = motors.iter().zip(&points);
            let each: Vec<_> = pairs.map(|(m, p)| m.apply(*p)).collect();
            assert_same(&moved, &each, "apply_in_place");
            let mut moved = points.clone();
            slices::apply_in_place(One(one), &mut moved).unwrap();
            let each: Vec<_> = points.iter().map(|p| one.apply(*p)).collect();
            assert_same(&moved, &each, "apply_in_place");
        }
    });
}

/// The exterior product with a fixed vector, and that of two vectors.
struct Area;

impl<F: Number> Map<r3::Vector<F>> for Area {
    type Output = r3::Bivector<F>;

    #[inline(always)]
    fn call<L: Lanes<F>>(&self, x: r3::Vector<L>) -> r3::Bivector<L> {
        x.wedge(r3::Vector::new(L::ONE, L::ONE, L::ZERO))
    }
}

impl<F: Number> ZipMap<r3::Vector<F>, r3::Vector<F>> for Area {
    type Output = r3::Bivector<F>;

    #[inline(always)]
    fn call<L: Lanes<F>>(&self, x: r3::Vector<L>, y: r3::Vector<L>) -> r3::Bivector<L> {
        x.wedge(y)
    }
}

#[test]
fn own_functions_are_called_for_every_element() {
    on_every_target(|| {
        for len in LENGTHS {
            let a = elements::<r3::Vector<f32>>(len, 14);
            let b = elements::<r3::Vector<f32>>(len, 15);
            let mut out = vec![r3::Bivector::default(); len];
            slices::map(&a, &Area, &mut out).unwrap();
            let fixed = r3::Vector::new(1.0, 1.0, 0.0);
            let each: Vec<_> = a.iter().map(|x| x.wedge(fixed)).collect();
            assert_same(&out, &each, "map");
            slices::zip_map(&a, &b, &Area, &mut out).unwrap();
            let each: Vec<_> = a.iter().zip(&b).map(|(x, y)| x.wedge(*y)).collect();
            assert_same(&out, &each, "zip_map");
        }
    });
}

#[test]
fn parts_of_slices_are_not_touched_outside() {
    on_every_target(|| {
        for start in 0..5 {
            for len in LENGTHS {
                let a = elements::<r3::Vector<f32>>(30, 16);
                let mut out = a.clone();
                let part = start..start + len;
                slices::plus(&a[part.clone()], &a[part.clone()], &mut out[part.clone()]).unwrap();
                for (index, (one, former)) in out.iter().zip(&a).enumerate() {
                    let expected = match part.contains(&index) {
                        true => *former + *former,
                        false => *former,
                    };
                    assert_eq!(*one, expected, "{index} of {part:?}");
                }
            }
        }
    });
}

#[test]
fn what_is_not_finite_stays_in_its_element() {
    on_every_target(|| {
        for wrong in [f32::NAN, f32::INFINITY] {
            for place in 0..17 {
                let mut a = elements::<r3::Vector<f32>>(17, 17);
                let b = elements::<r3::Vector<f32>>(17, 18);
                a[place].e2 = wrong;
                let mut out = vec![r3::Bivector::default(); 17];
                slices::wedge(&a, &b, &mut out).unwrap();
                for (index, area) in out.iter().enumerate() {
                    let finite = area.to_array().iter().all(|x| x.is_finite());
                    assert_eq!(finite, index != place, "{index} beside {place}");
                }
            }
        }
    });
}

#[test]
fn slices_of_different_lengths_are_refused() {
    let motors = elements::<plane::Motor<f64>>(7, 19);
    let points = elements::<plane::Point<f64>>(9, 20);
    let refused = |left, right| Err(LengthMismatch { left, right });
    let mut out = points.clone();
    assert_eq!(slices::apply(&motors, &points, &mut out), refused(7, 9));
    assert_eq!(
        slices::apply(&motors, &points[..7], &mut out),
        refused(7, 9)
    );
    assert_eq!(
        slices::apply(&motors, &points, &mut out[..7]),
        refused(7, 9)
    );
    assert_eq!(
        slices::apply(One(motors[0]), &points, &mut out[..8]),
        refused(9, 8)
    );
    assert_eq!(
        slices::apply(&motors, One(points[0]), &mut out),
        refused(7, 9)
    );
    assert_eq!(slices::apply_in_place(&motors, &mut out), refused(7, 9));
    let vectors = elements::<r3::Vector<f64>>(3, 21);
    let mut areas = [r3::Bivector::default(); 4];
    assert_eq!(slices::map(&vectors, &Area, &mut areas), refused(3, 4));
    assert_eq!(
        slices::zip_map(&vectors, &vectors[1..], &Area, &mut areas),
        refused(3, 2)
    );
    assert_eq!(out, points);
    assert_eq!(areas, [r3::Bivector::default(); 4]);
}
