//! Direct spheres.

use ga_core::convert::pick;
use ga_core::{Field, Real};

use super::Degenerate;
use super::degenerate::{coincide, collinear, rounding, underflows};
use crate::cga3::{DualSphere, Plane, Point, Sphere, Translator};
use crate::classify::range::{larger, length};

/// What four points determine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SphereOrPlane<T> {
    /// Their sphere.
    Sphere(Sphere<T>),
    /// The plane that they are on: a sphere through infinity.
    Plane(Plane<T>),
}

impl<T> SphereOrPlane<T> {
    /// The sphere; `None` for a plane.
    pub fn sphere(self) -> Option<Sphere<T>> {
        match self {
            SphereOrPlane::Sphere(sphere) => Some(sphere),
            SphereOrPlane::Plane(_) => None,
        }
    }

    /// The plane; `None` for a sphere.
    pub fn plane(self) -> Option<Plane<T>> {
        match self {
            SphereOrPlane::Sphere(_) => None,
            SphereOrPlane::Plane(plane) => Some(plane),
        }
    }
}

impl<T: Field> Sphere<T> {
    /// The sphere of weight 1 about a centre with this squared radius, imaginary where that is
    /// negative: the undual of (2.52).
    ///
    /// ```
    /// use ga_cga::{Point, Sphere};
    ///
    /// let sphere = Sphere::about(Point::at(0.0, 0.0, 1.0), 4.0);
    /// assert_eq!((Point::at(0.0, 0.0, 3.0) ^ sphere).norm(), 0.0);
    /// assert_eq!(sphere.radius_squared(), Some(4.0));
    /// ```
    pub fn about(center: Point<T>, radius_squared: T) -> Self {
        DualSphere::about(center, radius_squared).undual()
    }
}

impl<T: Real> Sphere<T> {
    /// The sphere a∧b∧c∧d through four points (2.49), or the plane where they are coplanar.
    /// Coplanar means: to within the rounding of the coordinates.
    ///
    /// The product is formed of the differences to the first point, so that spheres far from
    /// the origin are as good as their points.
    ///
    /// ```
    /// use ga_cga::{Degenerate, Point, Sphere};
    ///
    /// let [a, b, c] = [Point::at(1.0, 0.0, 0.0), Point::at(0.0, 1.0, 0.0), Point::at(-1.0, 0.0, 0.0)];
    /// let round = Sphere::through(a, b, c, Point::at(0.0, 0.0, 1.0)).unwrap();
    /// assert_eq!(round.sphere().unwrap().radius_squared(), Some(1.0));
    /// let level = Sphere::through(a, b, c, Point::at(0.0, 0.0, 0.0)).unwrap();
    /// assert!(level.plane().is_some());
    /// let circle = Sphere::through(a, b, c, Point::at(0.0, -1.0, 0.0));
    /// assert_eq!(circle, Err(Degenerate::CocircularPoints));
    /// ```
    ///
    /// # Errors
    /// [`Degenerate::CoincidentPoints`], [`Degenerate::CollinearPoints`] and
    /// [`Degenerate::CocircularPoints`] where many spheres contain the points, and
    /// [`Degenerate::NotFinite`].
    pub fn through(
        a: Point<T>,
        b: Point<T>,
        c: Point<T>,
        d: Point<T>,
    ) -> Result<SphereOrPlane<T>, Degenerate> {
        let positions = [a, b, c, d].map(Point::position);
        let [w, x, y, z] = positions;
        let [q, r, s] = [x, y, z].map(|position| Point::from(position - w));
        let origin = Point::at(T::ZERO, T::ZERO, T::ZERO);
        let local: Sphere<T> = origin.wedge(q).wedge(r).wedge(s);
        let sphere: Sphere<T> = Translator::by(w).apply(local);
        if !length(sphere).is_finite() {
            return Err(Degenerate::NotFinite);
        }
        for (index, one) in positions.iter().enumerate() {
            if positions
                .iter()
                .skip(index + 1)
                .any(|two| coincide(*one, *two))
            {
                return Err(Degenerate::CoincidentPoints);
            }
        }
        let away = positions.map(length).into_iter().fold(T::ZERO, larger);
        let [u, v, t] = [q, r, s].map(|point| length(point.position()));
        let reach = larger(larger(u, v), t);
        if underflows(u * v * t * reach) {
            return Err(Degenerate::NotFinite);
        }
        // A product of three lengths is uncertain by its own rounding and by that of the
        // coordinates; with two more lengths so is the coplanar part.
        let uncertain = |volume: T| {
            let areas = u * v + v * t + t * u;
            rounding(volume) + rounding(away) * areas
        };
        if !local.weight().all_le(uncertain(u * v * t)) {
            return Ok(SphereOrPlane::Sphere(sphere));
        }
        if collinear(w, x, y) && collinear(w, x, z) && collinear(w, y, z) {
            return Err(Degenerate::CollinearPoints);
        }
        let plane: Plane<T> = pick(local);
        if plane.weight().all_le(uncertain(u * v * t) * reach) {
            return Err(Degenerate::CocircularPoints);
        }
        Ok(SphereOrPlane::Plane(Translator::by(w).apply(plane)))
    }
}
