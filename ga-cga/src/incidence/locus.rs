//! The set of real points of an element, in Euclidean terms.

use ga_core::Real;

use crate::cga3::{Bivector3, Multivector, Point, Vector3};
use crate::classify::range::length;
use crate::classify::{Shape, classify};
use crate::flat::Flat;
use crate::round::Round;
use crate::round::SplitPair;
use crate::tangent::Tangent;

/// A set of real points.
#[derive(Clone, Copy, Debug)]
pub(super) enum Locus<T> {
    Point(Vector3<T>),
    Pair(Vector3<T>, Vector3<T>),
    /// Along a vector of length 1.
    Line(Vector3<T>, Vector3<T>),
    /// With a normal of length 1.
    Plane(Vector3<T>, Vector3<T>),
    Space,
    /// In the plane of a bivector of size 1.
    Circle(Vector3<T>, T, Bivector3<T>),
    Sphere(Vector3<T>, T),
}

impl<T: Real> Locus<T> {
    /// The points of an element in direct form; `None` where it has no real and finite ones.
    pub(super) fn of(element: Multivector<T>) -> Option<Self> {
        let origin = Point::at(T::ZERO, T::ZERO, T::ZERO);
        match classify(element).shape()? {
            Shape::RealRound(Round::PointPair(pair)) => match pair.split() {
                SplitPair::Real { first, second } => {
                    Some(Locus::Pair(first.position(), second.position()))
                }
                _ => None,
            },
            Shape::RealRound(Round::Circle(circle)) => Some(Locus::Circle(
                circle.center()?.position(),
                circle.radius_squared()?.sqrt(),
                circle.attitude().bivector().unit()?,
            )),
            Shape::RealRound(Round::Sphere(sphere)) => Some(Locus::Sphere(
                sphere.center()?.position(),
                sphere.radius_squared()?.sqrt(),
            )),
            Shape::Tangent(tangent) => {
                let point = match tangent {
                    Tangent::Point { point, .. } => point,
                    Tangent::Vector(pair) => pair.center()?,
                    Tangent::Bivector(circle) => circle.center()?,
                    Tangent::Trivector(sphere) => sphere.center()?,
                };
                Some(Locus::Point(point.position()))
            }
            Shape::Flat(Flat::Point(point)) => Some(Locus::Point(point.location()?.position())),
            Shape::Flat(Flat::Line(line)) => Some(Locus::Line(
                line.nearest(origin)?.position(),
                line.direction().unit()?,
            )),
            Shape::Flat(Flat::Plane(plane)) => Some(Locus::Plane(
                plane.nearest(origin)?.position(),
                plane.normal().unit()?,
            )),
            Shape::Flat(Flat::Space(_)) => Some(Locus::Space),
            Shape::ImaginaryRound(_) | Shape::Direction(_) => None,
        }
    }

    /// The point of the set that is nearest to a position; any of them where many are.
    pub(super) fn nearest(self, x: Vector3<T>) -> Vector3<T> {
        match self {
            Locus::Point(p) => p,
            Locus::Pair(p, q) => {
                if length(x - p).all_le(length(x - q)) {
                    p
                } else {
                    q
                }
            }
            Locus::Line(p, t) => p + t * t.scalar_product(x - p),
            Locus::Plane(p, n) => x - n * n.scalar_product(x - p),
            Locus::Space => x,
            Locus::Circle(center, radius, plane) => {
                let from = x - center;
                // The projection of (2.29) onto the plane of the circle.
                let within: Vector3<T> = from.project(plane);
                let (aside, _) = axes(plane);
                center + within.unit().unwrap_or(aside) * radius
            }
            Locus::Sphere(center, radius) => {
                center + (x - center).unit().unwrap_or_else(anywhere) * radius
            }
        }
    }
}

/// Elements over their length.
pub(super) trait Unit: Sized {
    /// The element of size 1; `None` where it has no size.
    fn unit(self) -> Option<Self>;
}

macro_rules! unit {
    ($($Element:ident)*) => {$(
        impl<T: Real> Unit for $Element<T> {
            fn unit(self) -> Option<Self> {
                let size = length(self);
                size.is_invertible().then(|| self.map(|coefficient| coefficient / size))
            }
        }
    )*};
}

unit!(Vector3 Bivector3);

/// Some direction, where all are as good.
pub(super) fn anywhere<T: Real>() -> Vector3<T> {
    Vector3::new(T::ONE, T::ZERO, T::ZERO)
}

/// Some direction at right angles to a vector of length 1.
pub(super) fn aside<T: Real>(normal: Vector3<T>) -> Vector3<T> {
    axes(normal.orthogonal_plane()).0
}

/// Two directions of length 1 that span the plane of a bivector of size 1, at right angles and
/// in its sense.
pub(super) fn axes<T: Real>(plane: Bivector3<T>) -> (Vector3<T>, Vector3<T>) {
    let basis = [
        Vector3::new(T::ONE, T::ZERO, T::ZERO),
        Vector3::new(T::ZERO, T::ONE, T::ZERO),
        Vector3::new(T::ZERO, T::ZERO, T::ONE),
    ];
    // Of the basis vectors in the plane turned by a right angle, the longest.
    let mut longest = Vector3::default();
    for vector in basis {
        let turned: Vector3<T> = vector.left_contract(plane);
        if !length(turned).all_le(length(longest)) {
            longest = turned;
        }
    }
    let first = longest.unit().unwrap_or_else(anywhere);
    (first, first.left_contract(plane))
}
