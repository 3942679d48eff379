//! Lines, points and planes from homogeneous coordinates, and back.

use ga_core::{Field, Real, Scalar as Ring};

use super::{Bivector, Direction, IdealBivector, Line, Moment, OriginBivector, Trivector};

impl<T: Ring> Line<T> {
    /// The line that joins two points given by homogeneous coordinates; zero where they are the
    /// same point.
    ///
    /// ```
    /// use ga_spaces::projective3::Line;
    ///
    /// // Through (1, 0, 0) along y: direction y, moment x × y = z.
    /// let line = Line::join([1, 0, 0, 1], [1, 1, 0, 1]);
    /// assert_eq!(line.to_array(), [0, 1, 0, 0, 0, 1]);
    /// ```
    pub fn join(p: [T; 4], q: [T; 4]) -> Self {
        let minor = |i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
        Line::new(
            minor(3, 0),
            minor(3, 1),
            minor(3, 2),
            minor(1, 2),
            minor(2, 0),
            minor(0, 1),
        )
    }

    /// The line in which two planes meet, given by homogeneous coordinates; zero where they are
    /// the same plane.
    pub fn meet(p: [T; 4], q: [T; 4]) -> Self {
        let [mx, my, mz, dx, dy, dz] = Line::join(p, q).to_array();
        Line::new(dx, dy, dz, mx, my, mz)
    }
}

impl<T: Field> Trivector<T> {
    /// The point with these homogeneous coordinates, quadratic in them: all lines through it.
    ///
    /// At w = 1 it is the origin d₁∧d₂∧d₃ translated.
    pub fn point([x, y, z, w]: [T; 4]) -> Self {
        let origin = Direction::new(T::ONE, T::ZERO, T::ZERO)
            ^ Direction::new(T::ZERO, T::ONE, T::ZERO)
            ^ Direction::new(T::ZERO, T::ZERO, T::ONE);
        moved(origin, w, IdealBivector::new(-x, -y, -z).into())
    }

    /// The plane with these homogeneous coordinates, quadratic in them: all lines in it.
    ///
    /// At d = 1 it is the plane at infinity m₁∧m₂∧m₃ moved by a perspective.
    pub fn plane([a, b, c, d]: [T; 4]) -> Self {
        let infinity = Moment::new(T::ONE, T::ZERO, T::ZERO)
            ^ Moment::new(T::ZERO, T::ONE, T::ZERO)
            ^ Moment::new(T::ZERO, T::ZERO, T::ONE);
        moved(infinity, d, OriginBivector::new(-a, -b, -c).into())
    }

    /// The part in the span of the points, those with X = X I; that of the planes has X = −X I.
    pub fn point_part(self) -> Self {
        (self + self.undual()) * T::from_ratio(1, 2)
    }

    /// The part in the span of the planes.
    pub fn plane_part(self) -> Self {
        (self - self.undual()) * T::from_ratio(1, 2)
    }
}

impl<T: Real> Trivector<T> {
    /// The homogeneous coordinates of a point, of any weight and sign; `None` where no part of
    /// this is a point, or it is not finite. Of what is no point but a sum of points, the
    /// coordinates are those of one of them.
    pub fn point_coordinates(self) -> Option<[T; 4]> {
        let p = self.point_part();
        // The products of two coordinates each, in the blades where `point` puts them.
        root([
            [p.d1m23, p.d2m23, p.d3m23, -p.d12m2],
            [p.d2m23, -p.d2m13, -p.d3m13, p.d12m1],
            [p.d3m23, -p.d3m13, p.d3m12, p.d13m1],
            [-p.d12m2, p.d12m1, p.d13m1, p.d123],
        ])
    }

    /// The homogeneous coordinates of a plane, of any weight and sign; `None` where no part of
    /// this is a plane, or it is not finite.
    pub fn plane_coordinates(self) -> Option<[T; 4]> {
        let q = self.plane_part();
        // As for points with d and m exchanged, where m12∧d2 is d2∧m12.
        root([
            [q.d23m1, q.d23m2, q.d23m3, -q.d2m12],
            [q.d23m2, -q.d13m2, -q.d13m3, q.d1m12],
            [q.d23m3, -q.d13m3, q.d12m3, q.d1m13],
            [-q.d2m12, q.d1m12, q.d1m13, q.m123],
        ])
    }
}

/// The family of lines moved by e^{B/2w}, times w²: the power series in B ends with its square,
/// so the result is quadratic and exists at w = 0.
fn moved<T: Field>(lines: Trivector<T>, weight: T, generator: Bivector<T>) -> Trivector<T> {
    let once = generator.commutator(lines);
    let twice = generator.commutator(once);
    (lines * weight + once) * weight + twice * T::from_ratio(1, 2)
}

/// The vector whose products with itself a symmetric matrix of rank one is, up to a factor: the
/// row with the largest diagonal entry.
fn root<T: Real>(products: [[T; 4]; 4]) -> Option<[T; 4]> {
    let mut largest = (T::ZERO, [T::ZERO; 4]);
    for (i, row) in products.into_iter().enumerate() {
        let size = row[i].abs();
        if !size.is_finite() {
            return None;
        }
        if !size.all_le(largest.0) {
            largest = (size, row);
        }
    }
    let (size, row) = largest;
    let coordinates = row.map(|x| x / size);
    (size.is_invertible() && coordinates.into_iter().all(T::is_finite)).then_some(coordinates)
}
