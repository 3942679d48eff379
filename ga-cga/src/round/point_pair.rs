//! Point pairs.

use ga_core::{Field, Real};

use super::Degenerate;
use crate::cga3::{DualSphere, Point, PointPair, Vector3};
use crate::classify::range::{length, within_range};
use crate::classify::{Classification, Shape, Tolerance, classify_within};
use crate::flat::Flat;
use crate::round::{Round, coincide};
use crate::tangent::Tangent;

/// What a point pair comes apart into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplitPair<T> {
    /// Two points, in the order of the pair's orientation: κ is a positive multiple of
    /// `first`∧`second`.
    Real {
        /// The point that the pair starts at, p₋.
        first: Point<T>,
        /// The point that the pair leads to, p₊.
        second: Point<T>,
    },
    /// One point twice, and the direction in which the two came together.
    Tangent {
        /// The point.
        point: Point<T>,
        /// The direction, as long as the weight.
        direction: Vector3<T>,
    },
    /// Two points with complex coordinates, centre ∓ i ρ **t**/|**t**|.
    Imaginary {
        /// The centre, which is real.
        center: Point<T>,
        /// The squared radius −ρ², negative.
        radius_squared: T,
        /// The direction **t**, as long as the weight.
        direction: Vector3<T>,
    },
    /// A point and the point at infinity.
    WithInfinity(Point<T>),
    /// No pair at all: a dual line, a direction, zero, no blade, or not finite.
    NoPair(Classification<T>),
}

impl<T: Field> PointPair<T> {
    /// The pair about a centre along a vector, with this squared radius: the points are
    /// centre ∓ r **t**/|**t**|, in that order, imaginary where the squared radius is negative
    /// (2.59). Its weight is |**t**|.
    ///
    /// ```
    /// use ga_cga::{Point, PointPair, Vector3};
    ///
    /// let pair = PointPair::about(Point::at(1.0, 0.0, 0.0), 4.0, Vector3::new(1.0, 0.0, 0.0));
    /// // The product of the points themselves has the weight of their distance.
    /// assert_eq!(pair * 4.0, Point::at(-1.0, 0.0, 0.0) ^ Point::at(3.0, 0.0, 0.0));
    /// ```
    pub fn about(center: Point<T>, radius_squared: T, direction: Vector3<T>) -> Self {
        DualSphere::about(center, -radius_squared).pair_along(direction)
    }
}

impl<T: Real> PointPair<T> {
    /// The pair a∧b of two points (2.47), of the weight of their distance.
    ///
    /// # Errors
    /// [`Degenerate::CoincidentPoints`] where the points are one, and
    /// [`Degenerate::NotFinite`].
    pub fn between(a: Point<T>, b: Point<T>) -> Result<Self, Degenerate> {
        let pair = a.wedge(b);
        if !length(pair).is_finite() {
            return Err(Degenerate::NotFinite);
        }
        if coincide(a.position(), b.position()) {
            return Err(Degenerate::CoincidentPoints);
        }
        Ok(pair)
    }

    /// The two points, in the order of the pair's orientation (2.57): for κ = p₋∧p₊
    /// p∓ = (κ ∓ √κ²)/(−n_∞⌋κ). To the default tolerance of [`Tolerance`].
    ///
    /// The dissertation prints the signs the other way round, and for κ² < 0 the formula gives
    /// vectors that are no points: these are told apart here.
    ///
    /// ```
    /// use ga_cga::{Point, PointPair, SplitPair, Vector3};
    ///
    /// let (a, b) = (Point::at(3.0, 0.0, 0.0), Point::at(1.0, 0.0, 0.0));
    /// assert_eq!((a ^ b).split(), SplitPair::Real { first: a, second: b });
    /// assert_eq!((b ^ a).split(), SplitPair::Real { first: b, second: a });
    /// let direction = Vector3::new(0.0, 0.0, 2.0);
    /// let imaginary = PointPair::about(a, -1.0, direction);
    /// assert_eq!(imaginary.split(), SplitPair::Imaginary { center: a, radius_squared: -1.0, direction });
    /// let touching = PointPair::tangent(a, direction);
    /// assert_eq!(touching.split(), SplitPair::Tangent { point: a, direction });
    /// ```
    pub fn split(self) -> SplitPair<T> {
        self.split_within(Tolerance::default())
    }

    /// The two points, with a given tolerance for what counts as one point twice.
    pub fn split_within(self, tolerance: Tolerance<T>) -> SplitPair<T> {
        let classification = classify_within(self, tolerance);
        let split = match classification {
            Classification::Direct(Shape::RealRound(Round::PointPair(pair))) => {
                let ends = pair.ends();
                ends.map(|[first, second]| SplitPair::Real { first, second })
            }
            Classification::Direct(Shape::ImaginaryRound(Round::PointPair(pair))) => {
                let place = pair.center().zip(pair.radius_squared());
                place.map(|(center, radius_squared)| SplitPair::Imaginary {
                    center,
                    radius_squared,
                    direction: pair.attitude().vector(),
                })
            }
            Classification::Direct(Shape::Tangent(Tangent::Vector(pair))) => {
                pair.center().map(|point| SplitPair::Tangent {
                    point,
                    direction: pair.attitude().vector(),
                })
            }
            Classification::Direct(Shape::Flat(Flat::Point(flat))) => {
                flat.location().map(SplitPair::WithInfinity)
            }
            _ => None,
        };
        split.unwrap_or(SplitPair::NoPair(classification))
    }

    /// The two points of a real pair, in the order of its orientation (2.57).
    ///
    /// Nothing is decided by a tolerance, as [`split`](PointPair::split) does: any positive
    /// squared radius makes two points. `None` where it is zero, negative, or there is none.
    ///
    /// ```
    /// use ga_cga::{Point, PointPair, Vector3};
    ///
    /// let (a, b) = (Point::at(1.0, 2.0, 3.0), Point::at(1.0, 2.0, 5.0));
    /// assert_eq!((a ^ b).ends(), Some([a, b]));
    /// let direction = Vector3::new(0.0, 0.0, 1.0);
    /// assert_eq!(PointPair::about(a, -4.0, direction).ends(), None);
    /// assert_eq!(PointPair::tangent(a, direction).ends(), None);
    /// ```
    pub fn ends(self) -> Option<[Point<T>; 2]> {
        let pair = within_range(self)?;
        // X X̃ = −κ² for a bivector.
        let square = -pair.norm_squared();
        if square.all_le(T::ZERO) {
            return None;
        }
        // κ/v for the vector v = −n_∞⌋κ is (κ⌊v)/v², and the weight is divided out again.
        let along: DualSphere<T> = -DualSphere::infinity().left_contract(pair);
        let root = square.sqrt();
        let middle = -along.left_contract(pair);
        let [first, second] = [-root, root].map(|root| (middle + along * root).center());
        Some([first?, second?])
    }
}
