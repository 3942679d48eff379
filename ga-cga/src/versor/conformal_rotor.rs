//! General conformal transformations: even ones, simple and compound, and odd ones.

use crate::cga3::{Even, Odd};

/// A general conformal rotor e^{−κ/2} of a point pair κ or of any bivector (2.62, Table 2.6).
///
/// A *simple* one has a blade for its generator and no part of grade 4: along a real point pair
/// it moves points from one of the two to the other on circles through both, about an imaginary
/// one it turns on the circles around the pair's dual. A *compound* one is a product of two
/// simple ones that commute; [`split_commuting`](crate::PointPair::split_commuting) of its
/// logarithm names them.
///
/// ```
/// use ga_cga::{ConformalRotor, Point, PointPair};
///
/// let [from, to] = [Point::at(-1.0, 0.0, 0.0), Point::at(1.0, 0.0, 0.0)];
/// let pair: PointPair = from ^ to;
/// let boost: ConformalRotor = (pair * 0.3).exp();
/// // The two points stay where they are; others move along circles through both.
/// assert!(from.image_under(boost).unwrap().distance(from) < 1e-12);
/// let moved = Point::at(0.0, 1.0, 0.0).image_under(boost).unwrap().position();
/// assert!((moved.norm() - 1.0).abs() < 1e-12 && moved.e1.abs() > 0.1);
/// // Its logarithm is the pair again.
/// let log = boost.log().unwrap();
/// assert!((log - pair * 0.3).to_array().iter().all(|c: &f64| c.abs() < 1e-12));
/// ```
pub type ConformalRotor<T = f64> = Even<T>;

/// A general conformal transformation with an odd number of reflections: a dual sphere or plane
/// times a [`ConformalRotor`].
///
/// ```
/// use ga_cga::{DualPlane, OddVersor, Point, Translator, Vector3};
///
/// // A glide: the reflection in the plane z = 0, then a translation along it.
/// let mirror = DualPlane::new(0.0, 0.0, 1.0, 0.0);
/// let glide: OddVersor = Translator::by(Vector3::new(1.0, 0.0, 0.0)) * mirror;
/// let image = Point::at(0.0, 0.0, 2.0).image_under(glide).unwrap();
/// assert!(image.distance(Point::at(1.0, 0.0, -2.0)) < 1e-15);
/// ```
pub type OddVersor<T = f64> = Odd<T>;
