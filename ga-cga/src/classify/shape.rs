//! The answers of a classification.

use ga_core::Scalar;
use ga_core::convert::pick;

use crate::cga3::{
    Circle, DirectionBivector, DirectionVector, DualSphere, FlatPoint, Line, Multivector, Plane,
    Point, PointPair, Sphere,
};
use crate::direction::Direction;
use crate::flat::Flat;
use crate::round::Round;
use crate::tangent::Tangent;

/// What a multivector is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Classification<T> {
    /// Zero in every coefficient.
    Zero,
    /// A coefficient is infinite or not a number.
    NotFinite,
    /// No product of vectors, hence no element of geometry.
    NotABlade(Obstacle),
    /// A number: the dual of all of space.
    Number(T),
    /// The element itself: the points p with p∧X = 0 are its points.
    Direct(Shape<T>),
    /// The dual of this (direct) element: the points p with p⌋X = 0 are its points.
    Dual(Shape<T>),
}

/// Why a multivector is not a blade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// It has parts of several grades.
    MixedGrades,
    /// It has one grade, but is not an outer product of vectors: the generator of a screw, for
    /// example.
    NotFactorable,
}

/// An element of geometry in direct form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<T> {
    /// A round with a positive squared radius.
    RealRound(Round<T>),
    /// A round with a negative squared radius, which has no real points.
    ImaginaryRound(Round<T>),
    /// A round of radius zero: a point, or an attitude at a point.
    Tangent(Tangent<T>),
    /// An element that passes through infinity.
    Flat(Flat<T>),
    /// An element at infinity: an attitude without a place.
    Direction(Direction<T>),
}

/// One question per kind.
macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident: $Type:ident = $($pattern:pat_param)|+ => $value:expr;)*) => {
        impl<T: Copy> Shape<T> {
            $(
                $(#[$doc])*
                pub fn $name(self) -> Option<$Type<T>> {
                    match self {
                        $($pattern)|+ => Some($value),
                        _ => None,
                    }
                }
            )*
        }

        impl<T: Copy> Classification<T> {
            $(
                $(#[$doc])*
                /// Of a dual, what it is the dual of.
                pub fn $name(self) -> Option<$Type<T>> {
                    self.shape()?.$name()
                }
            )*
        }
    };
}

kinds! {
    /// The point, if it is one.
    point: Point = Shape::Tangent(Tangent::Point { point, .. }) => point;
    /// The point pair, if it is one, real or imaginary.
    point_pair: PointPair = Shape::RealRound(Round::PointPair(pair))
        | Shape::ImaginaryRound(Round::PointPair(pair)) => pair;
    /// The circle, if it is one, real or imaginary.
    circle: Circle = Shape::RealRound(Round::Circle(circle))
        | Shape::ImaginaryRound(Round::Circle(circle)) => circle;
    /// The sphere, if it is one, real or imaginary.
    sphere: Sphere = Shape::RealRound(Round::Sphere(sphere))
        | Shape::ImaginaryRound(Round::Sphere(sphere)) => sphere;
    /// The flat point, if it is one.
    flat_point: FlatPoint = Shape::Flat(Flat::Point(point)) => point;
    /// The line, if it is one.
    line: Line = Shape::Flat(Flat::Line(line)) => line;
    /// The plane, if it is one.
    plane: Plane = Shape::Flat(Flat::Plane(plane)) => plane;
    /// The direction of lines, if it is one.
    direction_vector: DirectionVector = Shape::Direction(Direction::Vector(vector)) => vector;
    /// The direction of planes, if it is one.
    direction_bivector: DirectionBivector = Shape::Direction(Direction::Bivector(plane)) => plane;
}

impl<T: Copy> Classification<T> {
    /// The element of geometry, whether it was met directly or as a dual; `None` where there is
    /// none.
    pub fn shape(self) -> Option<Shape<T>> {
        match self {
            Classification::Direct(shape) | Classification::Dual(shape) => Some(shape),
            _ => None,
        }
    }

    /// Whether it is a real point pair, circle or sphere, or the dual of one.
    pub fn is_real_round(self) -> bool {
        matches!(self.shape(), Some(Shape::RealRound(_)))
    }

    /// Whether it is an imaginary point pair, circle or sphere, or the dual of one.
    pub fn is_imaginary_round(self) -> bool {
        matches!(self.shape(), Some(Shape::ImaginaryRound(_)))
    }

    /// Whether it is a point or another tangent, or the dual of one.
    pub fn is_tangent(self) -> bool {
        matches!(self.shape(), Some(Shape::Tangent(_)))
    }

    /// Whether it is a flat point, a line, a plane or all of space, or the dual of one.
    pub fn is_flat(self) -> bool {
        matches!(self.shape(), Some(Shape::Flat(_)))
    }

    /// Whether it is a direction, or the dual of one.
    pub fn is_direction(self) -> bool {
        matches!(self.shape(), Some(Shape::Direction(_)))
    }
}

impl<T: ga_core::Field> From<Shape<T>> for Multivector<T> {
    /// The element as a multivector, weight included.
    fn from(shape: Shape<T>) -> Self {
        match shape {
            Shape::RealRound(round) | Shape::ImaginaryRound(round) => match round {
                Round::PointPair(pair) => pair.into(),
                Round::Circle(circle) => circle.into(),
                Round::Sphere(sphere) => sphere.into(),
            },
            Shape::Tangent(tangent) => match tangent {
                Tangent::Point { point, weight } => (point * weight).into(),
                Tangent::Vector(pair) => pair.into(),
                Tangent::Bivector(circle) => circle.into(),
                Tangent::Trivector(sphere) => sphere.into(),
            },
            Shape::Flat(flat) => match flat {
                Flat::Point(point) => point.into(),
                Flat::Line(line) => line.into(),
                Flat::Plane(plane) => plane.into(),
                Flat::Space(space) => space.into(),
            },
            Shape::Direction(direction) => match direction {
                Direction::Infinity(weight) => infinity(weight),
                Direction::Vector(vector) => vector.into(),
                Direction::Bivector(bivector) => bivector.into(),
                Direction::Trivector(trivector) => trivector.into(),
            },
        }
    }
}

impl<T: ga_core::Real> Classification<T> {
    /// The image under a map that keeps the kind of the element, as motions and scalings do.
    pub(crate) fn map(self, image: impl Fn(Multivector<T>) -> Multivector<T>) -> Self {
        match self {
            Classification::Direct(shape) => Classification::Direct(shape.map(image)),
            Classification::Dual(shape) => Classification::Dual(shape.map(image)),
            other => other,
        }
    }
}

impl<T: ga_core::Real> Shape<T> {
    fn map(self, image: impl Fn(Multivector<T>) -> Multivector<T>) -> Self {
        macro_rules! moved {
            ($x:expr) => {
                pick(image(Multivector::from($x)))
            };
        }
        let round = |round| match round {
            Round::PointPair(pair) => Round::PointPair(moved!(pair)),
            Round::Circle(circle) => Round::Circle(moved!(circle)),
            Round::Sphere(sphere) => Round::Sphere(moved!(sphere)),
        };
        match self {
            Shape::RealRound(real) => Shape::RealRound(round(real)),
            Shape::ImaginaryRound(imaginary) => Shape::ImaginaryRound(round(imaginary)),
            Shape::Tangent(tangent) => Shape::Tangent(match tangent {
                Tangent::Point { point, weight } => {
                    let moved: DualSphere<T> = moved!(point * weight);
                    Tangent::Point {
                        point: moved.center().unwrap_or(point),
                        weight: moved.weight(),
                    }
                }
                Tangent::Vector(pair) => Tangent::Vector(moved!(pair)),
                Tangent::Bivector(circle) => Tangent::Bivector(moved!(circle)),
                Tangent::Trivector(sphere) => Tangent::Trivector(moved!(sphere)),
            }),
            Shape::Flat(flat) => Shape::Flat(match flat {
                Flat::Point(point) => Flat::Point(moved!(point)),
                Flat::Line(line) => Flat::Line(moved!(line)),
                Flat::Plane(plane) => Flat::Plane(moved!(plane)),
                Flat::Space(space) => Flat::Space(moved!(space)),
            }),
            Shape::Direction(direction) => Shape::Direction(match direction {
                Direction::Infinity(weight) => {
                    let moved: DualSphere<T> = moved!(infinity(weight));
                    Direction::Infinity(moved.ni)
                }
                Direction::Vector(vector) => Direction::Vector(moved!(vector)),
                Direction::Bivector(bivector) => Direction::Bivector(moved!(bivector)),
                Direction::Trivector(trivector) => Direction::Trivector(moved!(trivector)),
            }),
        }
    }
}

fn infinity<T: Scalar>(weight: T) -> Multivector<T> {
    Multivector::from(DualSphere::infinity() * weight)
}
