//! The frame in which two elements are compared: at their place and in their size.

use ga_core::convert::pick;
use ga_core::{Real, Scalar};

use crate::cga3::{
    Circle, DualSphere, Multivector, Point, PointPair, Scalar as Number, Sphere, Translator,
    Vector3,
};
use crate::classify::decide::in_units_of;
use crate::classify::range::{larger, length, power_of_two, within_range};
use crate::classify::{Classification, Shape, Tolerance, classify};
use crate::flat::Flat;
use crate::round::Round;
use crate::tangent::Tangent;

/// Two elements in a frame of their own.
pub(super) struct Frame<T> {
    pub(super) a: Multivector<T>,
    pub(super) b: Multivector<T>,
    /// What is zero in this frame, where the sizes of both are between 1 and 2.
    pub(super) tolerance: Tolerance<T>,
    place: Vector3<T>,
    unit: T,
    /// What the elements were divided by.
    weights: [T; 2],
}

impl<T: Real> Frame<T> {
    /// The frame of two elements.
    ///
    /// # Errors
    /// What an element is that is none: zero, not finite, no blade or a number.
    pub(super) fn of(a: Multivector<T>, b: Multivector<T>) -> Result<Self, Classification<T>> {
        let shapes = [shape(a)?, shape(b)?];
        let origin = Point::at(T::ZERO, T::ZERO, T::ZERO);
        // Flats are where they come near the other element, which takes two looks.
        let first = extent(shapes[0], origin);
        let second = extent(shapes[1], first.map_or(origin, |(place, _)| place));
        let first = extent(shapes[0], second.map_or(origin, |(place, _)| place));
        // Without a round there is no size but that of the distance and of the ordinary length.
        let size = |radius: T, apart: T| {
            let least = if radius.is_invertible() {
                radius
            } else {
                T::ONE
            };
            larger(least, apart)
        };
        let (place, unit) = match (first, second) {
            (Some((p, r)), Some((q, s))) => (p, size(larger(r, s), p.distance(q))),
            (Some((p, r)), None) | (None, Some((p, r))) => (p, size(r, T::ZERO)),
            (None, None) => (origin, T::ONE),
        };
        let place = place.position();
        let default = Tolerance::default();
        let far = length(place);
        // What is smaller than the rounding of its place has no size to go by.
        let visible = larger(far, T::ONE) * default.relative;
        let unit = if unit.all_le(visible) {
            T::ONE
        } else {
            power_of_two(unit)
        };
        let ratio = far / unit;
        let round = shapes
            .iter()
            .any(|shape| !matches!(shape, Shape::Flat(_) | Shape::Direction(_)));
        let growth = if round { ratio * ratio } else { ratio };
        let tolerance = Tolerance::relative(default.relative * (T::ONE + growth));
        let back = Translator::by(-place);
        let local = |element: Multivector<T>| {
            let local = in_units_of(translated(back, element), unit);
            let size = power_of_two(length(local));
            (local.map(|coefficient| coefficient / size), size)
        };
        let ((a, a_weight), (b, b_weight)) = (local(a), local(b));
        let finite = |x: &Multivector<T>| within_range(*x).is_some();
        if !(finite(&a) && finite(&b) && tolerance.relative.is_finite()) {
            return Err(Classification::NotFinite);
        }
        Ok(Frame {
            a,
            b,
            tolerance,
            place,
            unit,
            weights: [a_weight, b_weight],
        })
    }

    /// What a product of the two elements is, carried back to the place where it belongs, at
    /// the weight that both give it.
    pub(super) fn carry_back(&self, element: Multivector<T>) -> Classification<T> {
        self.carry(element, self.weights)
    }

    /// The same for a part of the first element, at the weight of that alone.
    pub(super) fn carry_back_first(&self, element: Multivector<T>) -> Classification<T> {
        self.carry(element, [self.weights[0], T::ONE])
    }

    fn carry(&self, element: Multivector<T>, [a, b]: [T; 2]) -> Classification<T> {
        if length(element).all_le(self.tolerance.relative) {
            return Classification::Zero;
        }
        let local = crate::classify::classify_within(element, self.tolerance);
        let there = Translator::by(self.place);
        let carried = |weight: T| {
            local.map(|x| {
                let weighted = x.map(|coefficient| coefficient * weight);
                translated(there, in_units_of(weighted, T::ONE / self.unit))
            })
        };
        let in_range = |classification: &Classification<T>| {
            let element = classification.shape().map(Multivector::from);
            element.is_none_or(|element| within_range(element).is_some())
        };
        // A weight beyond the range of the numbers is left out.
        let mut candidates = [a * b, T::ONE].into_iter().map(carried);
        candidates
            .find(in_range)
            .unwrap_or(Classification::NotFinite)
    }

    /// What is zero in products of the two elements.
    pub(super) fn vanishes(&self, element: Multivector<T>) -> bool {
        length(element).all_le(self.tolerance.relative)
    }
}

fn shape<T: Real>(element: Multivector<T>) -> Result<Shape<T>, Classification<T>> {
    let classification = classify(element);
    classification.shape().ok_or(classification)
}

/// Where an element is, near a point, and how large; `None` for directions and for space.
fn extent<T: Real>(shape: Shape<T>, near: Point<T>) -> Option<(Point<T>, T)> {
    let round = |center: Option<Point<T>>, square: Option<T>| {
        center.zip(square.map(|square| square.abs().sqrt()))
    };
    match shape {
        Shape::RealRound(any) | Shape::ImaginaryRound(any) => match any {
            Round::PointPair(pair) => round(pair.center(), pair.radius_squared()),
            Round::Circle(circle) => round(circle.center(), circle.radius_squared()),
            Round::Sphere(sphere) => round(sphere.center(), sphere.radius_squared()),
        },
        Shape::Tangent(tangent) => {
            let center = match tangent {
                Tangent::Point { point, .. } => Some(point),
                Tangent::Vector(pair) => pair.center(),
                Tangent::Bivector(circle) => circle.center(),
                Tangent::Trivector(sphere) => sphere.center(),
            };
            center.map(|center| (center, T::ZERO))
        }
        Shape::Flat(flat) => {
            let place = match flat {
                Flat::Point(point) => point.location(),
                Flat::Line(line) => line.nearest(near),
                Flat::Plane(plane) => plane.nearest(near),
                Flat::Space(_) => None,
            };
            place.map(|place| (place, T::ZERO))
        }
        Shape::Direction(_) => None,
    }
}

/// The image of an element of one grade, in the type of that grade: scalars and pseudoscalars
/// stay as they are.
fn translated<T: Real>(by: Translator<T>, element: Multivector<T>) -> Multivector<T> {
    match main_grade(element) {
        1 => by.apply(pick::<_, DualSphere<T>>(element)).into(),
        2 => by.apply(pick::<_, PointPair<T>>(element)).into(),
        3 => by.apply(pick::<_, Circle<T>>(element)).into(),
        4 => by.apply(pick::<_, Sphere<T>>(element)).into(),
        _ => element,
    }
}

/// The grade of the largest coefficient: that of an element of one grade.
pub(super) fn main_grade<T: Real>(element: Multivector<T>) -> u32 {
    let mut best = (T::ZERO, 0);
    for (mask, coefficient) in element.to_masks().into_iter().enumerate() {
        if !coefficient.abs().all_le(best.0) {
            best = (coefficient.abs(), mask.count_ones());
        }
    }
    best.1
}

/// The largest of many elements, zero if there is none.
pub(super) fn largest_of<T: Real>(
    elements: impl Iterator<Item = Multivector<T>>,
) -> Multivector<T> {
    let zero = Multivector::from(Number::new(T::ZERO));
    elements.fold(zero, |best, element| {
        if length(element).all_le(length(best)) {
            best
        } else {
            element
        }
    })
}

/// A basis blade.
pub(super) fn basis_blade<T: Scalar>(mask: usize) -> Multivector<T> {
    Multivector::from_masks(core::array::from_fn(|own| {
        if own == mask { T::ONE } else { T::ZERO }
    }))
}
