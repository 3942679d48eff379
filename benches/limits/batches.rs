//! The batches that are measured: a list of motions, each on an element of another list, or one
//! of them on all.

use std::hint::black_box;

use ga_benches::data::Data;
use ga_benches::ours::{conformal, plane_based, unit};
use ga_core::Real;
use ga_core::ops::Element;
use ga_lanes::{Batch, Number, One};

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

/// The bytes of one of these.
fn bytes<X: Element>(_: &[X]) -> usize {
    X::BLADES.len() * size_of::<X::Number>()
}

/// An operand that counts slots.
fn counting<X: Element<Number = Slot>>() -> X {
    X::from_fn(|_| Slot(1.0))
}

/// The motors of some motions on some elements.
macro_rules! work {
    ($name:literal $how:ident $float:ident $algebra:ident $Operand:ident $operands:expr) => {
        Work {
            name: $name,
            scalar: stringify!($float),
            slots: slots(|| {
                let motor = unit(counting::<$algebra::Motor<Slot>>());
                motor.apply(counting::<$algebra::$Operand<Slot>>())
            }),
            bytes: {
                let data = Data::new(1);
                let motors: Vec<_> = data.motions[0].iter().map($algebra::motor::<$float>).collect();
                let operands: Vec<$algebra::$Operand<$float>> = $operands(&data);
                let results = [motors[0].apply(operands[0])];
                work!(@read $how motors) + bytes(&operands) + bytes(&results)
            },
            prepare: |count| {
                let data = Data::new(SOME);
                let motors = data.motions[0].iter().map($algebra::motor::<$float>).collect();
                let motors = work!(@left $how count motors);
                let operands: Vec<$algebra::$Operand<$float>> = $operands(&data);
                let operands = batch(count, operands);
                let mut results = Batch::new();
                Box::new(move || {
                    let (motors, operands) = (black_box(&motors), black_box(&operands));
                    // Both have one length.
                    let _ = motors.apply_into(operands, &mut results);
                    black_box(&mut results);
                })
            },
        }
    };
    (@read pairs $motors:ident) => { bytes(&$motors) };
    (@read one $motors:ident) => { 0 };
    (@left pairs $count:ident $motors:ident) => { batch($count, $motors) };
    (@left one $count:ident $motors:ident) => {{
        let motors: Vec<_> = $motors;
        One(motors[0])
    }};
}

/// All that is measured.
pub fn all() -> Vec<Work> {
    vec![
        work!("motor-on-point" pairs f32 plane_based Point points),
        work!("motor-on-point" pairs f64 plane_based Point points),
        work!("one-motor-on-points" one f32 plane_based Point points),
        work!("one-motor-on-points" one f64 plane_based Point points),
        work!("conformal-motor-on-point" pairs f32 conformal Point conformal_points),
        work!("conformal-motor-on-point" pairs f64 conformal Point conformal_points),
        work!("conformal-motor-on-circle" pairs f32 conformal Circle circles),
        work!("conformal-motor-on-circle" pairs f64 conformal Circle circles),
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
