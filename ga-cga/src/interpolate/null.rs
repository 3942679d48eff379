//! What carries null elements, tangents and directions, which have no ratio.

use ga_core::{Element, Real};

use super::NoPath;
use super::attitudes::{rotor_between, same_sign};
use crate::cga3::{Motor, Multivector, Point, Rotor, Translator};
use crate::classify::decide::dimension;
use crate::classify::range::larger;
use crate::classify::{Classification, Shape, Tolerance, classify_within};
use crate::direction::Direction;
use crate::tangent::Tangent;

/// How many of two elements are null, and what takes the one to the other if both are.
pub(super) enum Nulls<T> {
    Neither,
    One,
    Both(Result<Motor<T>, NoPath>),
}

/// What is null of two elements: tangents and directions, to the default tolerance for elements
/// of their own size.
pub(super) fn nulls<T: Real>(from: Multivector<T>, to: Multivector<T>) -> Nulls<T> {
    let length = larger(reach(from), reach(to));
    let usable = length.is_invertible() && length.is_finite();
    let tolerance = Tolerance {
        length: if usable { length } else { T::ONE },
        ..Tolerance::default()
    };
    let null = |x| match classify_within(x, tolerance) {
        Classification::Direct(shape @ (Shape::Tangent(_) | Shape::Direction(_))) => Some(shape),
        _ => None,
    };
    match (null(from), null(to)) {
        (None, None) => Nulls::Neither,
        (Some(from), Some(to)) => Nulls::Both(motor_between(from, to)),
        _ => Nulls::One,
    }
}

/// The distance from the origin and the size that an element has: what balances its coefficients
/// of different dimensions. Zero for directions, which have none.
fn reach<T: Real>(x: Multivector<T>) -> T {
    let mut parts = [T::ZERO; 3];
    let [origin, middle, infinity] = &mut parts;
    for (position, (blade, _)) in Multivector::<T>::BLADES.iter().enumerate() {
        let part = match dimension(*blade) {
            -1 => &mut *origin,
            0 => &mut *middle,
            _ => &mut *infinity,
        };
        *part = larger(*part, x.at(position).abs());
    }
    let [origin, middle, infinity] = parts;
    if origin.is_invertible() {
        larger(middle / origin, (infinity / origin).sqrt())
    } else if middle.is_invertible() {
        infinity / middle
    } else {
        T::ZERO
    }
}

/// The motor that moves one tangent to another along with its attitude, or turns one direction
/// to another.
fn motor_between<T: Real>(from: Shape<T>, to: Shape<T>) -> Result<Motor<T>, NoPath> {
    match (from, to) {
        (Shape::Direction(from), Shape::Direction(to)) => turn_between(from, to).map(Motor::from),
        (Shape::Tangent(from), Shape::Tangent(to)) => {
            let (start, end) = (place(from)?, place(to)?);
            let turn = tangent_turn(from, to)?;
            Ok(end * turn * start.reverse())
        }
        _ => Err(NoPath::DifferentKinds),
    }
}

/// The rotor between directions.
fn turn_between<T: Real>(from: Direction<T>, to: Direction<T>) -> Result<Rotor<T>, NoPath> {
    match (from, to) {
        (Direction::Infinity(from), Direction::Infinity(to)) => same_sign(from, to),
        (Direction::Vector(from), Direction::Vector(to)) => {
            rotor_between(from.vector(), to.vector())
        }
        (Direction::Bivector(from), Direction::Bivector(to)) => {
            rotor_between(from.bivector().normal(), to.bivector().normal())
        }
        (Direction::Trivector(from), Direction::Trivector(to)) => {
            let [[from], [to]] = [from, to].map(|x| x.to_array());
            same_sign(from, to)
        }
        _ => Err(NoPath::DifferentKinds),
    }
}

/// The rotor between the attitudes of tangents.
fn tangent_turn<T: Real>(from: Tangent<T>, to: Tangent<T>) -> Result<Rotor<T>, NoPath> {
    let attitude = |tangent| match tangent {
        Tangent::Point { weight, .. } => Direction::Infinity(weight),
        Tangent::Vector(pair) => Direction::Vector(pair.attitude()),
        Tangent::Bivector(circle) => Direction::Bivector(circle.attitude()),
        Tangent::Trivector(sphere) => Direction::Trivector(sphere.attitude()),
    };
    turn_between(attitude(from), attitude(to))
}

/// The translation from the origin to where a tangent is.
fn place<T: Real>(tangent: Tangent<T>) -> Result<Translator<T>, NoPath> {
    let center = match tangent {
        Tangent::Point { point, .. } => Some(point),
        Tangent::Vector(pair) => pair.center(),
        Tangent::Bivector(circle) => circle.center(),
        Tangent::Trivector(sphere) => sphere.center(),
    };
    let center: Point<T> = center.ok_or(NoPath::NotFinite)?;
    Ok(Translator::by(center.position()))
}
