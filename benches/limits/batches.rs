//! The batches that are measured: a list of motors, each on an element of another list, or one of
//! them on all.

use std::hint::black_box;

use ga_benches::data::Data;
use ga_benches::ours::{conformal, plane_based};
use ga_core::ops::Element;
use ga_core::{Real, Unit};
use ga_lanes::{Batch, Lanes, Number, One, ZipMap};

use crate::slots::{Slot, slots};

/// An operation on batches.
pub struct Work {
    /// What is done.
    pub name: &'static str,
    /// The type of the numbers.
    pub scalar: &'static str,
    /// Multiply-add slots for an element.
    pub slots: u32,
    /// Bytes that an element takes from memory and gives to it.
    pub bytes: usize,
    /// The call on batches of this length.
    pub prepare: fn(usize) -> Box<dyn FnMut() + Send>,
}

/// Elements of which longer batches are made by repetition.
const SOME: usize = 4096;

/// So many elements.
fn batch<X: Element<Number: Number>>(count: usize, some: Vec<X>) -> Batch<X> {
    some.into_iter().cycle().take(count).collect()
}

/// The bytes of an element.
const fn bytes<X: Element>() -> usize {
    X::BLADES.len() * size_of::<X::Number>()
}

/// An operand that counts slots.
fn counting<X: Element<Number = Slot>>() -> X {
    X::from_fn(|_| Slot(1.0))
}

/// Elements moved by unit motors.
struct Moved;

macro_rules! moved {
    ($($algebra:ident::$Operand:ident)*) => {$(
        impl<F: Number> ZipMap<$algebra::$Operand<F>, $algebra::Motor<F>> for Moved {
            type Output = $algebra::$Operand<F>;

            #[inline(always)]
            fn call<L: Lanes<F>>(
                &self,
                x: $algebra::$Operand<L>,
                motor: $algebra::Motor<L>,
            ) -> $algebra::$Operand<L> {
                Unit::promised(motor).apply(x)
            }
        }
    )*};
}

moved! {
    plane_based::Point
    conformal::Point
    conformal::Circle
}

/// Motors on elements: on every one its own, or one on all.
macro_rules! work {
    ($name:literal $how:ident $float:ident $algebra:ident $Operand:ident $operands:ident) => {
        Work {
            name: $name,
            scalar: stringify!($float),
            slots: slots(|| {
                let motor = Unit::promised(counting::<$algebra::Motor<Slot>>());
                motor.apply(counting::<$algebra::$Operand<Slot>>())
            }),
            bytes: 2 * bytes::<$algebra::$Operand<$float>>()
                + work!(@bytes $how $algebra::Motor<$float>),
            prepare: |count| {
                let data = Data::new(SOME);
                let motors = data.motions[0].iter().map($algebra::motor::<$float>);
                let motors = motors.map(Unit::into_inner);
                let operands = batch(count, $operands::<$float>(&data));
                let motors = work!(@motors $how count motors);
                let mut results = Batch::new();
                Box::new(move || {
                    let operands = black_box(&operands);
                    // Both are of one length, so that nothing is refused.
                    let _ = operands.zip_map_into(work!(@right $how motors), &Moved, &mut results);
                    black_box(&mut results);
                })
            },
        }
    };
    (@bytes each $Motor:ty) => { bytes::<$Motor>() };
    (@bytes one $Motor:ty) => { 0 };
    (@motors each $count:ident $motors:ident) => { batch($count, $motors.collect()) };
    (@motors one $count:ident $motors:ident) => { One($motors.take(1).sum()) };
    (@right each $motors:ident) => { black_box(&$motors) };
    (@right one $motors:ident) => { black_box($motors) };
}

/// All that is measured.
pub fn all() -> Vec<Work> {
    vec![
        work!("motor-on-point" each f32 plane_based Point points),
        work!("motor-on-point" each f64 plane_based Point points),
        work!("one-motor-on-points" one f32 plane_based Point points),
        work!("one-motor-on-points" one f64 plane_based Point points),
        work!("conformal-motor-on-point" each f32 conformal Point conformal_points),
        work!("conformal-motor-on-point" each f64 conformal Point conformal_points),
        work!("conformal-motor-on-circle" each f32 conformal Circle circles),
        work!("conformal-motor-on-circle" each f64 conformal Circle circles),
        work!("one-conformal-motor-on-circles" one f32 conformal Circle circles),
        work!("one-conformal-motor-on-circles" one f64 conformal Circle circles),
    ]
}

fn points<T: Real>(data: &Data) -> Vec<plane_based::Point<T>> {
    data.vectors[0].iter().map(plane_based::point).collect()
}

fn conformal_points<T: Real>(data: &Data) -> Vec<conformal::Point<T>> {
    data.vectors[0].iter().map(conformal::point).collect()
}

fn circles<T: Real>(data: &Data) -> Vec<conformal::Circle<T>> {
    let [x, y, z, _] = &data.vectors;
    let triples = x.iter().zip(y).zip(z);
    triples
        .map(|((x, y), z)| conformal::circle([x, y, z]))
        .collect()
}
