//! The batches that are measured: a list of motors, each on an element of another list, or one of
//! them on all.

use std::hint::black_box;

use ga_benches::data::Data;
use ga_benches::ours::{conformal, plane_based};
use ga_core::ops::Element;
use ga_core::{Real, Unit};
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
    /// How many numbers an element takes from memory.
    pub read: usize,
    /// How many numbers it gives to memory.
    pub written: usize,
    /// The call on batches of this length.
    pub prepare: fn(usize) -> Box<dyn FnMut() + Send>,
}

impl Work {
    /// The bytes of a number.
    pub fn number(&self) -> usize {
        match self.scalar {
            "f32" => size_of::<f32>(),
            _ => size_of::<f64>(),
        }
    }

    /// The bytes that an element takes from memory and gives to it.
    pub fn bytes(&self) -> usize {
        (self.read + self.written) * self.number()
    }
}

/// Elements of which longer batches are made by repetition.
const SOME: usize = 4096;

/// So many elements.
fn batch<X: Element<Number: Number>>(count: usize, some: Vec<X>) -> Batch<X> {
    some.into_iter().cycle().take(count).collect()
}

/// An operand that counts slots.
fn counting<X: Element<Number = Slot>>() -> X {
    X::from_fn(|_| Slot(1.0))
}

/// Motors on elements: on every one its own, or one on all.
macro_rules! work {
    ($name:literal $how:ident $float:ident $algebra:ident $Operand:ident $operands:ident) => {
        Work {
            name: $name,
            scalar: stringify!($float),
            slots: {
                let motor = Unit::promised(counting::<$algebra::Motor<Slot>>());
                let operand = counting::<$algebra::$Operand<Slot>>();
                work!(@slots $how motor operand)
            },
            read: $algebra::$Operand::<$float>::BLADES.len()
                + work!(@read $how $algebra::Motor::<$float>),
            written: $algebra::$Operand::<$float>::BLADES.len(),
            prepare: |count| {
                let data = Data::new(SOME);
                let motors = data.motions[0].iter().map($algebra::motor::<$float>);
                let operands = batch(count, $operands::<$float>(&data));
                let mut results = Batch::new();
                work!(@prepare $how count motors operands results)
            },
        }
    };
    (@slots each $motor:ident $operand:ident) => { slots(|| $motor.apply($operand)) };
    (@slots one $motor:ident $operand:ident) => {{
        let map = $motor.linear_map();
        slots(|| map.apply($operand))
    }};
    (@read each $($Motor:tt)*) => { $($Motor)*::BLADES.len() };
    (@read one $($Motor:tt)*) => { 0 };
    (@prepare each $count:ident $motors:ident $operands:ident $results:ident) => {{
        let motors = batch($count, $motors.collect());
        Box::new(move || {
            // Both are of one length, so that nothing is refused.
            let _ = black_box(&motors).apply_into(black_box(&$operands), &mut $results);
            black_box(&mut $results);
        })
    }};
    (@prepare one $count:ident $motors:ident $operands:ident $results:ident) => {{
        let motor = One($motors.map(Unit::into_inner).next().unwrap_or_default());
        Box::new(move || {
            black_box(motor).apply_linear_into(black_box(&$operands), &mut $results);
            black_box(&mut $results);
        })
    }};
}

/// Motors on elements, bound by arithmetic or memory.
pub fn all() -> Vec<Work> {
    vec![
        work!("motor-on-point" each f32 plane_based Point points),
        work!("motor-on-point" each f64 plane_based Point points),
        work!("one-motor-on-points" one f32 plane_based Point points),
        work!("one-motor-on-points" one f64 plane_based Point points),
        work!("conformal-motor-on-point" each f32 conformal Point conformal_points),
        work!("conformal-motor-on-point" each f64 conformal Point conformal_points),
        work!("one-conformal-motor-on-points" one f32 conformal Point conformal_points),
        work!("one-conformal-motor-on-points" one f64 conformal Point conformal_points),
        work!("conformal-motor-on-circle" each f32 conformal Circle circles),
        work!("conformal-motor-on-circle" each f64 conformal Circle circles),
        work!("one-conformal-motor-on-circles" one f32 conformal Circle circles),
        work!("one-conformal-motor-on-circles" one f64 conformal Circle circles),
    ]
}

/// A function of every element of a batch.
pub struct Function {
    /// What is computed.
    pub name: &'static str,
    /// The type of the numbers.
    pub scalar: &'static str,
    /// The call on a batch of this length.
    pub prepare: fn(usize) -> Box<dyn FnMut()>,
}

/// A batch of so many motors.
macro_rules! motors {
    ($algebra:ident $float:ident $count:ident) => {{
        let data = Data::new(SOME);
        let motors = data.motions[0].iter().map($algebra::motor::<$float>);
        batch($count, motors.collect())
    }};
}

/// Exponentials and logarithms of unit motors.
macro_rules! functions {
    ($($exp:literal $log:literal $algebra:ident $float:ident)*) => {
        vec![$(
            Function {
                name: $exp,
                scalar: stringify!($float),
                prepare: |count| {
                    let generators = motors!($algebra $float count).log().or_zeros();
                    Box::new(move || {
                        black_box(black_box(&generators).exp());
                    })
                },
            },
            Function {
                name: $log,
                scalar: stringify!($float),
                prepare: |count| {
                    let motors = motors!($algebra $float count);
                    Box::new(move || {
                        black_box(black_box(&motors).log());
                    })
                },
            },
        )*]
    };
}

/// Functions of motors and of their generators.
pub fn functions() -> Vec<Function> {
    functions! {
        "exp" "log" plane_based f32
        "exp" "log" plane_based f64
        "conformal-exp" "conformal-log" conformal f32
        "conformal-exp" "conformal-log" conformal f64
    }
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
