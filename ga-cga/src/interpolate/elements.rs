//! Paths from element to element: what they promise, and where their weight goes.

use ga_core::ops::Apply;
use ga_core::{Blade, Element, Real, Scalar};

use super::versors::{Connect, Continuous};
use super::weight::{Weight, both_in_range, factor, finite, in_range, scaled};
use super::{NoPath, Way};

/// Elements that a versor takes to any other of their kind.
///
/// Every type of element has it: those of Table 2.6, and the numbers.
pub trait Carry: Element<Number: Real> {
    /// The type of the versor.
    type Versor: Continuous + Element<Number = Self::Number> + Apply<Self, Output = Self>;

    /// The unit versor R that takes this element A to B = `target` up to its weight.
    ///
    /// Where A has an inverse it is √(B/A) (2.66), the smallest that does: spheres turn or scale
    /// in the pencil that they span, circles in two of them at once. Tangents and directions,
    /// which are null and have no ratio, are moved and turned: a tangent along its screw, a
    /// direction in the plane of the two. Orientation counts: it is the way to B and not to −B.
    ///
    /// # Errors
    /// [`NoPath`] tells why there is none or it is not unique. Where it is
    /// [`Reversed`](NoPath::Reversed), as for spheres outside one another, the way to −B exists
    /// ([`path_to_either`](Carry::path_to_either)), and for rounds one as similar figures
    /// ([`similar_path_to`](super::Resemble::similar_path_to)). Of linked and orthogonal circles
    /// [`versor_to_orthogonal`](crate::Circle::versor_to_orthogonal) chooses one of
    /// [`ManyWays`](NoPath::ManyWays).
    fn versor_to(self, target: Self) -> Result<Self::Versor, NoPath> {
        let [from, to] = both_in_range(self, target)?;
        let Some([there, back]) = from.frame() else {
            return from.versor_near(to);
        };
        let versor = back.apply(from).versor_near(back.apply(to))?;
        Ok(back.followed_by(versor).followed_by(there))
    }

    /// What [`versor_to`](Carry::versor_to) is, computed with the coefficients as they are.
    ///
    /// # Errors
    /// As [`versor_to`](Carry::versor_to).
    fn versor_near(self, target: Self) -> Result<Self::Versor, NoPath>;

    /// The translation from the origin to this element and the one back, if it is farther away
    /// than it is large: then its coefficients are large and their differences count, and what
    /// is computed where it is is more exact. `None` where nothing is gained.
    fn frame(self) -> Option<[Self::Versor; 2]> {
        None
    }

    /// The path from this element to the target (2.67).
    ///
    /// # Errors
    /// As [`versor_to`](Carry::versor_to), and [`NoPath::DoesNotTurn`] for a long way that there
    /// is not.
    ///
    /// ```
    /// use ga_cga::interpolate::{Carry, NoPath, Way};
    /// use ga_cga::{Line, Point, Vector3};
    ///
    /// let east = Line::along(Point::at(0.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
    /// let north = Line::along(Point::at(0.0, 0.0, 2.0), Vector3::new(0.0, 4.0, 0.0));
    /// let path = east.path_to(north, Way::Short)?;
    /// assert!((path.at(1.0) - north).norm() < 1e-14);
    /// // The weight goes from 1 to 4 by equal factors, the height by equal steps.
    /// let middle: Line = path.at(0.5);
    /// assert!((middle.weight() - 2.0_f64).abs() < 1e-14);
    /// # Ok::<(), NoPath>(())
    /// ```
    fn path_to(self, target: Self, way: Way) -> Result<ElementPath<Self>, NoPath> {
        ElementPath::between(self, target, way, Self::versor_near)
    }

    /// The path from this element to the target in whichever orientation is nearer: to B or to
    /// −B, which is the same figure turned inside out or run through backwards.
    ///
    /// # Errors
    /// As [`path_to`](Carry::path_to), where there is no path to either.
    ///
    /// ```
    /// use ga_cga::interpolate::{Carry, NoPath, Way};
    /// use ga_cga::{DualSphere, Vector3};
    ///
    /// let [left, right] = [-3.0, 3.0]
    ///     .map(|x| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), 1.0));
    /// assert_eq!(left.path_to(right, Way::Short), Err(NoPath::Reversed));
    /// // In the pencil of the two the way leads over the plane in their middle.
    /// let path = left.path_to_either(right, Way::Short)?;
    /// let middle: f64 = path.at(0.5).weight();
    /// assert!(middle.abs() < 1e-14);
    /// assert!((path.at(1.0) + right).norm() < 1e-12);
    /// # Ok::<(), NoPath>(())
    /// ```
    fn path_to_either(self, target: Self, way: Way) -> Result<ElementPath<Self>, NoPath> {
        let opposite = scaled(target, -Self::Number::ONE);
        let (kept, reversed) = (
            self.path_to(target, Way::Short),
            self.path_to(opposite, Way::Short),
        );
        // The scalar part is the cosine of half the turn: the nearer, the larger.
        let near = |path: &ElementPath<Self>| {
            let versor = Self::Versor::power(path.generator, Self::Number::ONE);
            versor.coefficient(Blade::SCALAR).abs()
        };
        let (path, end) = match (kept, reversed) {
            (Ok(kept), Ok(reversed)) if !near(&reversed).all_le(near(&kept)) => {
                (reversed, opposite)
            }
            (Ok(kept), _) => (kept, target),
            (Err(_), Ok(reversed)) => (reversed, opposite),
            (Err(reason), Err(_)) => return Err(reason),
        };
        match way {
            Way::Short => Ok(path),
            Way::Long => self.path_to(end, way),
        }
    }
}

/// A path w^t R_t\[A\] with R_t = e^{t log R} (2.67; the printed sign of t leads to the inverse)
/// and the weight w of the target over that of the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementPath<X: Carry> {
    /// The translations to where start and generator are meant, and back.
    frame: Option<[X::Versor; 2]>,
    start: X,
    weight: Weight<X::Number>,
    generator: <X::Versor as Continuous>::Generator,
}

impl<X: Carry> ElementPath<X> {
    /// The path on which a versor takes an element to its image, of constant weight.
    ///
    /// # Errors
    /// [`NoPath`] where the versor leads no such way.
    pub fn along(start: X, versor: X::Versor, way: Way) -> Result<Self, NoPath> {
        let frame = in_range(start)?.0.frame();
        let local = match frame {
            Some([there, back]) => there.followed_by(versor).followed_by(back),
            None => versor,
        };
        let (start, unit) = seen_from(frame, start)?;
        Ok(ElementPath {
            frame,
            start,
            weight: Weight::constant(unit),
            generator: local.generator(way)?,
        })
    }

    /// The path to a target by the versor that is found between the two where they are.
    pub(super) fn between(
        start: X,
        target: X,
        way: Way,
        find: impl Fn(X, X) -> Result<X::Versor, NoPath>,
    ) -> Result<Self, NoPath> {
        let [near, _] = both_in_range(start, target)?;
        let frame = near.frame();
        let (start, unit) = seen_from(frame, start)?;
        let (end, _) = seen_from(frame, target)?;
        let path = ElementPath {
            frame,
            start,
            weight: Weight::constant(unit),
            generator: find(start, end)?.generator(way)?,
        };
        path.ending_at(target)
    }

    /// The same way with a weight that goes geometrically from that of the start to that of this
    /// target.
    ///
    /// # Errors
    /// [`NoPath::Imprecise`] where the way does not end at a multiple of the target,
    /// [`NoPath::Reversed`] where it ends at a negative one, [`NoPath::NotFinite`] where the
    /// weights are out of range.
    pub fn ending_at(self, target: X) -> Result<Self, NoPath> {
        let (end, unit) = seen_from(self.frame, target)?;
        let image = X::Versor::power(self.generator, X::Number::ONE).apply(self.start);
        let factor = factor(image, end)?;
        if factor.all_le(X::Number::ZERO) {
            return Err(NoPath::Reversed);
        }
        let weight = self.weight.grown(factor, unit)?;
        let path = ElementPath { weight, ..self };
        finite(path.at(X::Number::ONE)).map(|_| path)
    }

    /// The element at t: the start at 0 and the target at 1, weights included. In between the
    /// weight goes by equal factors, |w₀|^{1−t} |w₁|^t, so that equal steps of t are equal in
    /// everything: the step from 0 to t takes the element at s to the one at s + t.
    ///
    /// It is finite at 0 and 1, and elsewhere unless what it should be is out of range.
    pub fn at(&self, t: X::Number) -> X {
        let local = X::Versor::power(self.generator, t).apply(self.start);
        let moved = match self.frame {
            Some([there, _]) => there.apply(local),
            None => local,
        };
        scaled(moved, self.weight.at(t))
    }

    /// The versor R_t that takes the start to the element at t up to its weight.
    ///
    /// For rounds far from the origin its coefficients are large, and [`at`](ElementPath::at) is
    /// more exact.
    pub fn versor_at(&self, t: X::Number) -> X::Versor {
        let local = X::Versor::power(self.generator, t);
        match self.frame {
            Some([there, back]) => back.followed_by(local).followed_by(there),
            None => local,
        }
    }

    /// The factor w^t that the weight has grown by at t.
    pub fn weight_at(&self, t: X::Number) -> X::Number {
        Weight {
            start: X::Number::ONE,
            ..self.weight
        }
        .at(t)
    }

    /// The generator log R.
    pub fn generator(&self) -> <X::Versor as Continuous>::Generator {
        match self.frame {
            Some([there, _]) => there.apply(self.generator),
            None => self.generator,
        }
    }
}

/// An element in a frame, near 1, and what it is there over that.
fn seen_from<X: Carry>(frame: Option<[X::Versor; 2]>, x: X) -> Result<(X, X::Number), NoPath> {
    let (x, unit) = in_range(x)?;
    let Some([_, back]) = frame else {
        return Ok((x, unit));
    };
    let (x, local) = in_range(back.apply(x))?;
    Ok((x, unit * local))
}
