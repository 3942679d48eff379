//! The decision: which parts of a multivector are there, and what that makes it.

use ga_core::convert::pick;
use ga_core::{Blade, Element, Real, Scalar};

use super::range::{larger, length, within_range};
use super::{Classification, Obstacle, Shape, Tolerance};
use crate::cga3::{Circle, DualSphere, Multivector, Point, PointPair, Pseudoscalar, Sphere};
use crate::direction::Direction;
use crate::flat::Flat;
use crate::round::Round;
use crate::tangent::Tangent;

/// The vectors n_o and n_∞ as bits of a blade.
const ORIGIN: u32 = 1 << 3;
const INFINITY: u32 = 1 << 4;

/// The power of a length that the coefficient of a blade is measured in: a translation by d
/// spreads a coefficient to others with d to the difference of these.
pub(crate) fn dimension(blade: Blade) -> i32 {
    let holds = |vector: u32| i32::from(blade.mask() & vector != 0);
    holds(INFINITY) - holds(ORIGIN)
}

/// The element in units of another length: each coefficient over the power of it that the
/// coefficient is measured in.
pub(crate) fn in_units_of<X>(x: X, unit: X::Number) -> X
where
    X: Element<Number: Real>,
{
    X::from_fn(|position| match dimension(X::BLADES[position].0) {
        1 => x.at(position) / unit,
        -1 => x.at(position) * unit,
        _ => x.at(position),
    })
}

/// The sizes of the four parts of an element against n_o and n_∞, in units of the ordinary
/// length.
struct Parts<T> {
    /// With n_o, without n_∞: there in rounds alone.
    origin: T,
    /// With neither: there in duals of flats.
    neither: T,
    /// With both: there in flats.
    both: T,
    /// With n_∞ alone.
    infinity: T,
}

impl<T: Real> Parts<T> {
    fn of<X: Element<Number = T>>(x: X) -> Self {
        let mut squares = [T::ZERO; 4];
        let [origin, neither, both, infinity] = &mut squares;
        for (position, (blade, _)) in X::BLADES.iter().enumerate() {
            let coefficient = x.at(position);
            let part = match blade.mask() & (ORIGIN | INFINITY) {
                0 => &mut *neither,
                ORIGIN => &mut *origin,
                INFINITY => &mut *infinity,
                _ => &mut *both,
            };
            *part += coefficient * coefficient;
        }
        let [origin, neither, both, infinity] = squares.map(Real::sqrt);
        Parts {
            origin,
            neither,
            both,
            infinity,
        }
    }

    /// The parts that give a flat or dual flat its attitude.
    fn middle(&self) -> T {
        (self.neither * self.neither + self.both * self.both).sqrt()
    }

    /// Whether n_o is there by rounding only: the round would be larger than its distance from
    /// the origin by more than the tolerance can tell.
    fn is_flat(&self, tau: T) -> bool {
        let middle = self.middle();
        let reach = larger(middle, self.infinity);
        // Without an attitude only a part that vanishes against the square is neglected.
        let infinite = tau * tau * self.infinity;
        self.origin == T::ZERO
            || (middle.is_invertible() && (self.origin * reach).all_le(tau * middle * middle))
            || self.origin.all_le(infinite)
    }

    /// Whether the attitude of a flat is there by rounding only.
    fn is_direction(&self, tau: T) -> bool {
        self.middle().all_le(tau * self.infinity)
    }

    /// The distance and size of a flat or round that the parts tell, at least the ordinary
    /// length.
    fn reach(&self) -> T {
        let middle = self.middle();
        let ratio = |a: T, b: T| if b.is_invertible() { a / b } else { T::ZERO };
        let reach = if self.origin == T::ZERO {
            ratio(self.infinity, middle)
        } else {
            larger(
                ratio(middle, self.origin),
                ratio(self.infinity, self.origin).sqrt(),
            )
        };
        larger(T::ONE, reach)
    }
}

/// What the element is.
pub(super) fn decide<T: Real>(
    element: Multivector<T>,
    tolerance: Tolerance<T>,
) -> Classification<T> {
    let Some(x) = within_range(element) else {
        return match super::range::largest(&element) {
            Some(_) => Classification::Zero,
            None => Classification::NotFinite,
        };
    };
    let x = in_units_of(x, tolerance.length);
    let mut grades = [T::ZERO; 6];
    for (mask, coefficient) in x.to_masks().into_iter().enumerate() {
        if let Some(size) = grades.get_mut(mask.count_ones() as usize) {
            *size += coefficient.abs();
        }
    }
    let bound = grades.into_iter().fold(T::ZERO, larger) * tolerance.relative;
    let sizes = grades.into_iter().enumerate();
    let mut present = sizes
        .filter(|(_, size)| !size.all_le(bound))
        .map(|(k, _)| k);
    match (present.next(), present.next()) {
        (Some(0), None) => Classification::Number(element.coefficient(Blade::SCALAR)),
        (Some(1), None) => vector(pick(element), tolerance),
        (Some(2), None) => bivector(pick(element), tolerance),
        (Some(3), None) => trivector(pick(element), tolerance),
        (Some(4), None) => quadvector(pick(element), tolerance),
        (Some(5), None) => {
            let space: Pseudoscalar<T> = pick(element);
            Classification::Direct(Shape::Flat(Flat::Space(space)))
        }
        _ => Classification::NotABlade(Obstacle::MixedGrades),
    }
}

/// What the parts of a blade of one grade say, before the grade is considered.
enum Family {
    Direction,
    Flat,
    DualFlat,
    Tangent,
    RealRound,
    ImaginaryRound,
    NotFactorable,
}

/// What the parts of an element of one grade say. `excess` is the size of what vanishes where
/// the element is a product of vectors.
fn family<X>(
    element: X,
    tolerance: Tolerance<X::Number>,
    excess: impl Fn(X) -> X::Number,
    radius_squared: impl Fn(X) -> Option<X::Number>,
) -> Family
where
    X: Element<Number: Real>,
{
    let tau = tolerance.relative;
    let Some(x) = within_range(in_units_of(element, tolerance.length)) else {
        return Family::NotFactorable;
    };
    let mut parts = Parts::of(x);
    let mut x = x;
    if parts.is_flat(tau) {
        parts.origin = X::Number::ZERO;
        x = X::from_fn(|position| match dimension(X::BLADES[position].0) {
            -1 => X::Number::ZERO,
            _ => x.at(position),
        });
        if parts.is_direction(tau) {
            return Family::Direction;
        }
    }
    let flat = parts.origin == X::Number::ZERO;
    let x = within_range(in_units_of(x, parts.reach())).unwrap_or(x);
    let size = length(x);
    if !excess(x).all_le(tau * size * size) {
        return Family::NotFactorable;
    }
    if flat {
        let middle = parts.middle() * tau;
        return match (parts.neither.all_le(middle), parts.both.all_le(middle)) {
            (true, _) => Family::Flat,
            (false, true) => Family::DualFlat,
            (false, false) => Family::NotFactorable,
        };
    }
    match radius_squared(x) {
        None => Family::NotFactorable,
        Some(square) if square.abs().all_le(tau) => Family::Tangent,
        Some(square) if X::Number::ZERO.all_le(square) => Family::RealRound,
        Some(_) => Family::ImaginaryRound,
    }
}

/// Vectors: dual spheres and planes, points, and the point at infinity.
fn vector<T: Real>(x: DualSphere<T>, tolerance: Tolerance<T>) -> Classification<T> {
    let sphere = || Round::Sphere(x.undual());
    match family(x, tolerance, |_| T::ZERO, DualSphere::radius_squared) {
        Family::Direction => {
            let weight = -Point::at(T::ZERO, T::ZERO, T::ZERO).scalar_product(x);
            Classification::Direct(Shape::Direction(Direction::Infinity(weight)))
        }
        Family::Tangent => match x.center() {
            Some(point) => {
                let weight = x.weight();
                Classification::Direct(Shape::Tangent(Tangent::Point { point, weight }))
            }
            None => Classification::NotABlade(Obstacle::NotFactorable),
        },
        Family::RealRound => Classification::Dual(Shape::RealRound(sphere())),
        Family::ImaginaryRound => Classification::Dual(Shape::ImaginaryRound(sphere())),
        Family::DualFlat | Family::Flat => {
            Classification::Dual(Shape::Flat(Flat::Plane(pick(x.undual()))))
        }
        Family::NotFactorable => Classification::NotABlade(Obstacle::NotFactorable),
    }
}

/// Bivectors: point pairs, tangent vectors, flat points, dual lines, directions of lines.
fn bivector<T: Real>(x: PointPair<T>, tolerance: Tolerance<T>) -> Classification<T> {
    let excess = |x: PointPair<T>| length(x.wedge(x));
    Classification::Direct(
        match family(x, tolerance, excess, PointPair::radius_squared) {
            Family::Direction => Shape::Direction(Direction::Vector(pick(x))),
            Family::Flat => Shape::Flat(Flat::Point(pick(x))),
            Family::DualFlat => {
                return Classification::Dual(Shape::Flat(Flat::Line(pick(x.undual()))));
            }
            Family::Tangent => Shape::Tangent(Tangent::Vector(x)),
            Family::RealRound => Shape::RealRound(Round::PointPair(x)),
            Family::ImaginaryRound => Shape::ImaginaryRound(Round::PointPair(x)),
            Family::NotFactorable => return Classification::NotABlade(Obstacle::NotFactorable),
        },
    )
}

/// Trivectors: circles, tangent bivectors, lines, duals of flat points, directions of planes.
fn trivector<T: Real>(x: Circle<T>, tolerance: Tolerance<T>) -> Classification<T> {
    // A trivector of five dimensions is a product of vectors where its dual is.
    let excess = |x: Circle<T>| length(x.dual().wedge(x.dual()));
    Classification::Direct(match family(x, tolerance, excess, Circle::radius_squared) {
        Family::Direction => Shape::Direction(Direction::Bivector(pick(x))),
        Family::Flat => Shape::Flat(Flat::Line(pick(x))),
        Family::DualFlat => {
            return Classification::Dual(Shape::Flat(Flat::Point(pick(x.undual()))));
        }
        Family::Tangent => Shape::Tangent(Tangent::Bivector(x)),
        Family::RealRound => Shape::RealRound(Round::Circle(x)),
        Family::ImaginaryRound => Shape::ImaginaryRound(Round::Circle(x)),
        Family::NotFactorable => return Classification::NotABlade(Obstacle::NotFactorable),
    })
}

/// Quadvectors: spheres, tangent trivectors, planes, the direction of space.
fn quadvector<T: Real>(x: Sphere<T>, tolerance: Tolerance<T>) -> Classification<T> {
    Classification::Direct(
        match family(x, tolerance, |_| T::ZERO, Sphere::radius_squared) {
            Family::Direction => Shape::Direction(Direction::Trivector(pick(x))),
            Family::Flat | Family::DualFlat => Shape::Flat(Flat::Plane(pick(x))),
            Family::Tangent => Shape::Tangent(Tangent::Trivector(x)),
            Family::RealRound => Shape::RealRound(Round::Sphere(x)),
            Family::ImaginaryRound => Shape::ImaginaryRound(Round::Sphere(x)),
            Family::NotFactorable => return Classification::NotABlade(Obstacle::NotFactorable),
        },
    )
}
