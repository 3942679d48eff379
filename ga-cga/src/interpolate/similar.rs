//! The similarity between rounds: moved, turned and scaled as a similar figure.

use ga_core::Real;

use super::attitudes::{rotor_between, same_sign};
use super::weight::{both_in_range, factor};
use super::{Carry, ElementPath, NoPath, Way};
use crate::cga3::{Circle, Dilator, DualSphere, Even, Point, PointPair, Rotor, Sphere, Translator};

/// Rounds that a similarity takes to any other round of their kind.
///
/// It leads where the smallest versor does not, from a sphere to any other of the same
/// orientation, and every round on its way is as large as one between the two: it never passes
/// through a plane or a line.
pub trait Resemble: Carry {
    /// The similarity that scales this round about its centre, turns it the short way and moves
    /// it, to become the target up to its weight.
    ///
    /// # Errors
    /// [`NoPath::Null`] for an element that is no round or has radius zero,
    /// [`NoPath::RealToImaginary`], [`NoPath::Reversed`] for spheres of opposite orientation and
    /// [`NoPath::Opposite`] for pairs and circles of opposite attitude.
    fn similarity_to(self, target: Self) -> Result<Self::Versor, NoPath>;

    /// The path to the target as a similar figure: the radius goes by equal factors, and the
    /// centre on a spiral about the point that the similarity keeps, or on a screw where the
    /// radii are equal.
    ///
    /// # Errors
    /// As [`similarity_to`](Resemble::similarity_to), and [`NoPath::DoesNotTurn`] for a long way
    /// that there is not.
    ///
    /// ```
    /// use ga_cga::interpolate::{NoPath, Resemble, Way};
    /// use ga_cga::{DualSphere, Vector3};
    ///
    /// let sphere = |x, r| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), r);
    /// let path = sphere(0.0, 1.0).similar_path_to(sphere(30.0, 4.0), Way::Short)?;
    /// let middle: DualSphere = path.at(0.5);
    /// // Twice as large, and twice as far from the apex of the cone about them, at −10.
    /// assert!((middle.radius_squared().unwrap() - 4.0_f64).abs() < 1e-12);
    /// assert!((middle.center().unwrap().position().e1 - 10.0).abs() < 1e-12);
    /// assert!((path.at(1.0) - sphere(30.0, 4.0)).norm() < 1e-10);
    /// # Ok::<(), NoPath>(())
    /// ```
    fn similar_path_to(self, target: Self, way: Way) -> Result<ElementPath<Self>, NoPath> {
        ElementPath::between(self, target, way, Self::similarity_to)
    }
}

/// The similarity from a centre and squared radius to others, with a turn.
fn similarity<T: Real>(
    from: (Option<Point<T>>, Option<T>),
    to: (Option<Point<T>>, Option<T>),
    turn: Rotor<T>,
) -> Result<Even<T>, NoPath> {
    let [(start, own), (end, other)] = [from, to].map(|(center, radius_squared)| {
        let usable = radius_squared.filter(|square| square.is_invertible());
        (center, usable)
    });
    let place = |center: Option<Point<T>>| center.map(|p| Translator::by(p.position()));
    let (start, end) = place(start).zip(place(end)).ok_or(NoPath::Null)?;
    let (own, other) = own.zip(other).ok_or(NoPath::Null)?;
    let square = other / own;
    if square.all_le(T::ZERO) {
        return Err(NoPath::RealToImaginary);
    }
    let scaling = Dilator::scaling(square.sqrt()).ok_or(NoPath::NotFinite)?;
    Ok(Even::similarity(scaling, turn, end) * start.reverse())
}

macro_rules! by_similarity {
    ($($Round:ident: |$from:ident, $to:ident| $turn:expr;)*) => {$(
        impl<T: Real> Resemble for $Round<T> {
            fn similarity_to(self, target: Self) -> Result<Even<T>, NoPath> {
                let [$from, $to] = both_in_range(self, target)?;
                let figure = |x: Self| (x.center(), x.radius_squared());
                // What is flat has no centre, and its attitude is zero.
                let turn = match (figure($from), figure($to)) {
                    ((Some(_), _), (Some(_), _)) => $turn?,
                    _ => return Err(NoPath::Null),
                };
                let versor = similarity(figure($from), figure($to), turn)?;
                factor(versor.apply($from), $to).map(|_| versor)
            }
        }
    )*};
}

by_similarity! {
    DualSphere: |from, to| same_sign(from.weight(), to.weight());
    Sphere: |from, to| same_sign(from.dual().weight(), to.dual().weight());
    PointPair: |from, to| rotor_between(from.attitude().vector(), to.attitude().vector());
    Circle: |from, to| rotor_between(from.normal(), to.normal());
}
