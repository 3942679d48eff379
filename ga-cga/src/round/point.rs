//! Points of weight 1.

use ga_core::{Field, Real};

use crate::cga3::{Point, Vector3};
use crate::classify::range::length;

impl<T: Field> Point<T> {
    /// The point with these Cartesian coordinates (2.44).
    ///
    /// ```
    /// use ga_cga::Point;
    ///
    /// let p = Point::at(1.0, 2.0, 2.0);
    /// assert_eq!(p.to_string(), "no + e1 + 2 e2 + 2 e3 + 4.5 ni");
    /// assert_eq!(p | p, ga_cga::Scalar::new(0.0));
    /// ```
    pub fn at(x: T, y: T, z: T) -> Self {
        Point::from(Vector3::new(x, y, z))
    }

    /// The position relative to the origin.
    pub fn position(self) -> Vector3<T> {
        Vector3::new(self.e1, self.e2, self.e3)
    }
}

impl<T: Real> Point<T> {
    /// The Euclidean distance to another point, the root of −2 p·q (2.46).
    ///
    /// It is taken from the difference of the positions, which loses nothing far from the
    /// origin.
    ///
    /// ```
    /// use ga_cga::Point;
    ///
    /// assert_eq!(Point::at(1e8, 0.0, 0.0).distance(Point::at(1e8, 3.0, 4.0)), 5.0);
    /// ```
    pub fn distance(self, other: Self) -> T {
        length(self.position() - other.position())
    }
}

impl<T: Field> From<Vector3<T>> for Point<T> {
    /// The point at this position, n_o + **x** + ½**x**² n_∞ (2.44).
    fn from(x: Vector3<T>) -> Self {
        let [e1, e2, e3] = x.to_array();
        Point {
            e1,
            e2,
            e3,
            ni: x.norm_squared() * T::from_ratio(1, 2),
        }
    }
}
