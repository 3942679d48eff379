//! Where three spheres meet: the places at given distances from three points (figure 2.17).

use ga_cga::{Bivector3, Circle, DualSphere, Point, PointPair, Translator, Vector3};

/// Up to which part of a squared radius the squared half distance of two places is taken for
/// rounding error, and the places for one.
const TANGENT: f64 = 1e-13;

/// Up to which sine of the angle between centres it is taken for rounding error, and the centres
/// for aligned.
const ALIGNED: f64 = 1e-14;

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
    pub fn of(spheres: [DualSphere; 3]) -> Self {
        // About the first centre, where squared radii do not drown in squared distances.
        let center = spheres[0].center().map(Point::position);
        let there = Translator::by(center.unwrap_or_default());
        let [first, second, third] = spheres.map(|sphere| there.reverse().apply(sphere));
        if let Some((second, third)) = second.center().zip(third.center())
            && aligned(second.position(), third.position())
        {
            return Meeting::Aligned;
        }
        let dual: Circle = first ^ second ^ third;
        let radius = first.radius_squared().unwrap_or_default().abs();
        match Self::within(dual.undual(), TANGENT * radius) {
            Meeting::Two(places) => Meeting::Two(places.map(|place| there.apply(place))),
            Meeting::One(place) => Meeting::One(there.apply(place)),
            none => none,
        }
    }

    /// The two points of a point pair, which three spheres share, in the order of its orientation.
    #[must_use]
    pub fn of_pair(pair: PointPair) -> Self {
        Self::within(pair, 0.0)
    }

    /// The points of a pair; squared half distances up to `tangent` are taken for zero.
    fn within(pair: PointPair, tangent: f64) -> Self {
        match pair.center().zip(pair.radius_squared()) {
            Some((center, square)) if square.abs() <= tangent => Meeting::One(center),
            Some((_, square)) if square < 0.0 => Meeting::Apart,
            Some(_) => pair.ends().map_or(Meeting::Aligned, Meeting::Two),
            None => Meeting::Aligned,
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

/// Whether two places are in line with the origin, up to the rounding of their coordinates.
fn aligned(a: Vector3, b: Vector3) -> bool {
    let area: Bivector3 = a ^ b;
    area.norm() <= ALIGNED * a.norm() * b.norm()
}
