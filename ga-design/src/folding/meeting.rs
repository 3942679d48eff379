//! Where three spheres meet: the places at given distances from three points (figure 2.17).

use ga_cga::{Circle, DualSphere, Point, PointPair};

/// Up to which part of a squared radius the squared half distance of two places is taken for
/// rounding error, and the places for one.
const TANGENT: f64 = 1e-13;

/// The places that three spheres have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meeting {
    /// Two places, mirror images in the plane of the centres. The first is on the side from
    /// which the centres are seen in anticlockwise order.
    Two([Point; 2]),
    /// One place, where the spheres touch: it lies in the plane of the centres.
    One(Point),
    /// No place: the spheres are too small or too large.
    Apart,
    /// The centres are on a line, so that the spheres share a circle or nothing.
    Aligned,
}

impl Meeting {
    /// Where the spheres about three points that pass through a fourth would meet, were the
    /// first three moved: `flat` are the places before and `centers` the places now.
    ///
    /// The spheres keep the distances from `flat` to `corner`, that is the lengths of the paper.
    #[must_use]
    pub fn of_moved(flat: [Point; 3], corner: Point, centers: [Point; 3]) -> Self {
        let spheres = std::array::from_fn(|i| {
            let radius = flat[i].distance(corner);
            DualSphere::about(centers[i], radius * radius)
        });
        Self::of(spheres)
    }

    /// Where three spheres meet.
    ///
    /// ```
    /// use ga_cga::{DualSphere, Point};
    /// use ga_design::folding::Meeting;
    ///
    /// let unit = |x, y| DualSphere::about(Point::at(x, y, 0.0), 1.0);
    /// let meeting = Meeting::of([unit(0.0, 0.0), unit(1.0, 0.0), unit(0.0, 1.0)]);
    /// let Meeting::Two([above, below]) = meeting else { panic!("they meet twice") };
    /// let height = 0.5_f64.sqrt();
    /// assert!(above.distance(Point::at(0.5, 0.5, height)) < 1e-15);
    /// assert!(below.distance(Point::at(0.5, 0.5, -height)) < 1e-15);
    /// ```
    #[must_use]
    pub fn of([first, second, third]: [DualSphere; 3]) -> Self {
        let dual: Circle = first ^ second ^ third;
        let radius = first.radius_squared().unwrap_or_default().abs();
        Self::within(dual.undual(), TANGENT * radius)
    }

    /// The two points of a point pair, which three spheres share, in the order of its orientation.
    #[must_use]
    pub fn of_pair(pair: PointPair) -> Self {
        Self::within(pair, 0.0)
    }

    /// The points of a pair; squared half distances up to `tangent` are taken for zero.
    fn within(pair: PointPair, tangent: f64) -> Self {
        // p∓ = (κ ± √κ²)/(−n_∞·κ) (2.57): the sphere half-way between the two points, which is
        // the plane of the centres, and from it the half distance either way.
        let plane: DualSphere = -DualSphere::infinity().left_contract(pair);
        let weight = plane.norm_squared();
        let middle: DualSphere = pair.right_contract(plane);
        let (Some(center), true) = (middle.center(), weight > 0.0) else {
            return Meeting::Aligned;
        };
        let square = pair.scalar_product(pair) / weight;
        if square.abs() <= tangent {
            return Meeting::One(center);
        }
        if square.is_nan() || square < 0.0 {
            return Meeting::Apart;
        }
        let half = plane * (square.sqrt() * weight.sqrt());
        match [middle - half, middle + half].map(DualSphere::center) {
            [Some(before), Some(after)] => Meeting::Two([before, after]),
            _ => Meeting::Aligned,
        }
    }

    /// The two places, where there are two.
    #[must_use]
    pub fn both(self) -> Option<[Point; 2]> {
        match self {
            Meeting::Two(points) => Some(points),
            _ => None,
        }
    }

    /// The one place, or the one of the two for which a measure is larger.
    #[must_use]
    pub fn with_most(self, measure: impl Fn(Point) -> f64) -> Option<Point> {
        match self {
            Meeting::Two([first, second]) if measure(first) > measure(second) => Some(first),
            Meeting::Two([_, second]) => Some(second),
            Meeting::One(point) => Some(point),
            Meeting::Apart | Meeting::Aligned => None,
        }
    }
}
