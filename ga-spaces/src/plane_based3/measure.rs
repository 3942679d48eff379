//! Distances and angles between planes, lines and points, from their products.

use ga_core::Real;

use super::{Line, Plane, Point};

impl<T: Real> Point<T> {
    /// The distance to another point, the norm of the line that joins them.
    pub fn distance(self, other: Self) -> T {
        (self & other).norm()
    }
}

impl<T: Real> Plane<T> {
    /// The signed distance of a point, positive on the side of the normal; `None` for the
    /// plane at infinity.
    pub fn signed_distance(self, point: Point<T>) -> Option<T> {
        Some((self.normalized()? ^ point).e0123)
    }

    /// The angle in radians between the normals, in [0, π]; `None` where one plane is the one
    /// at infinity.
    pub fn angle(self, other: Self) -> Option<T> {
        let turn = self.normalized()? * other.normalized()?;
        Some(
            (self.normalized()? ^ other.normalized()?)
                .norm()
                .atan2(turn.s),
        )
    }
}

impl<T: Real> Line<T> {
    /// The distance of a point, the norm of the plane that joins them; `None` for a line at
    /// infinity.
    pub fn distance_to_point(self, point: Point<T>) -> Option<T> {
        Some((self.normalized()? & point).norm())
    }

    /// The shortest distance to another line; `None` where one is at infinity.
    ///
    /// The commutator of two unit lines is the common perpendicular times the sine of their
    /// angle, their outer product the distance times that sine. For parallel lines both vanish,
    /// up to rounding, and the commutator is the line at infinity whose size is the distance.
    pub fn distance(self, other: Self) -> Option<T> {
        let (a, b) = (self.normalized()?, other.normalized()?);
        let perpendicular = a.commutator(b);
        let sine = perpendicular.norm();
        if !sine.all_le(T::EPSILON * T::from_integer(64)) {
            return Some((a ^ b).e0123.abs() / sine);
        }
        let [_, _, _, x, y, z] = perpendicular.to_array();
        Some((x * x + y * y + z * z).sqrt())
    }

    /// The angle in radians between the directions, in [0, π]; `None` where one line is at
    /// infinity.
    pub fn angle(self, other: Self) -> Option<T> {
        let (a, b) = (self.normalized()?, other.normalized()?);
        Some(a.commutator(b).norm().atan2(-a.scalar_product(b)))
    }
}
