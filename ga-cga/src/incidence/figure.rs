//! Which types are elements of geometry, and how each is read.

use ga_core::Real;

use crate::cga3::{
    Bivector3, Circle, DirectionBivector, DirectionTrivector, DirectionVector, DualLine, DualPlane,
    DualSphere, FlatPoint, Line, MinkowskiPlane, Multivector, Plane, Point, PointPair,
    Pseudoscalar, Sphere, TangentBivector, TangentTrivector, TangentVector, Trivector3, Vector3,
};
use crate::classify::Shape;

/// An element of geometry that can lie to another one.
///
/// Direct types stand for their points p with p∧X = 0. [`DualSphere`], [`DualPlane`] and
/// [`DualLine`] stand for their points with p⌋X = 0; a point with a weight is stored as a
/// [`DualSphere`] and is read as a sphere of radius zero. Euclidean vectors, bivectors and
/// trivectors stand for the directions that they span. A [`Shape`] stands for itself.
pub trait Figure: Copy {
    /// The type of the coefficients.
    type Number: Real;

    /// The element in direct form.
    fn direct(self) -> Multivector<Self::Number>;
}

/// Each type in a group is read by the expression of its group.
macro_rules! figures {
    ($(($x:ident => $direct:expr) { $($Figure:ident)* })*) => {$($(
        impl<T: Real> Figure for $Figure<T> {
            type Number = T;

            fn direct(self) -> Multivector<T> {
                let $x = self;
                Multivector::from($direct)
            }
        }
    )*)*};
}

figures! {
    (x => x) {
        Point PointPair Circle Sphere FlatPoint Line Plane Pseudoscalar MinkowskiPlane Shape
        DirectionVector DirectionBivector DirectionTrivector
        TangentVector TangentBivector TangentTrivector
    }
    (x => x.undual()) { DualSphere DualPlane DualLine }
    (x => DirectionVector::along(x)) { Vector3 }
    (x => DirectionBivector::of(x)) { Bivector3 }
    (x => DirectionTrivector::of(x)) { Trivector3 }
}
