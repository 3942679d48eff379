//! Paths from element to element: which versor takes the one to the other.

use ga_core::Real;
use ga_core::ops::Apply;

use super::Way;
use super::versors::Continuous;
use crate::cga3::{
    Bivector3, Circle, DirectionBivector, DirectionVector, DualLine, DualPlane, DualSphere, Even,
    FlatPoint, Line, Motor, Plane, Point, PointPair, Rotor, Sphere, TangentBivector, TangentVector,
    Translator, Vector3,
};

/// Elements that a versor takes to any other of their kind.
pub trait Carry: Copy {
    /// The type of the versor.
    type Versor: Continuous + Apply<Self, Output = Self>;

    /// The unit versor R = √(B/A) that takes this element A to B = `target` (2.66), up to its
    /// size.
    ///
    /// It is the smallest that does: spheres turn or scale in the pencil that they span, circles
    /// in two of them at once. Orientation counts: it is the path to B and not to −B.
    ///
    /// `None` where there is none or it is not unique: from or to what has no inverse, from a real
    /// round to an imaginary one, from an element to its own opposite, from a sphere to one
    /// outside it that is not turned inside out or to one inside it that is (take −B instead),
    /// and from a circle to one that is orthogonal to it and linked with it, for which
    /// [`versor_to_orthogonal`](Circle::versor_to_orthogonal) chooses.
    fn versor_to(self, target: Self) -> Option<Self::Versor>;

    /// The path R_t\[A\] from this element to the target (2.67).
    ///
    /// `None` where [`versor_to`](Carry::versor_to) finds no versor, or it leads no such way.
    fn path_to(self, target: Self, way: Way) -> Option<ElementPath<Self>> {
        ElementPath::along(self, self.versor_to(target)?, way)
    }
}

/// A path R_t\[A\] with R_t = e^{t log R} (2.67; the printed sign of t leads to the inverse).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementPath<X: Carry> {
    start: X,
    generator: <X::Versor as Continuous>::Generator,
}

impl<X: Carry> ElementPath<X> {
    /// The path on which a versor takes an element to its image; `None` if the versor leads no
    /// such way.
    pub fn along(start: X, versor: X::Versor, way: Way) -> Option<Self> {
        let generator = versor.generator(way)?;
        Some(ElementPath { start, generator })
    }

    /// The element at t: the start at 0, the target at 1, always of the size of the start.
    pub fn at(&self, t: <X::Versor as Continuous>::Number) -> X {
        self.versor_at(t).apply(self.start)
    }

    /// The versor R_t that takes the start to the element at t.
    pub fn versor_at(&self, t: <X::Versor as Continuous>::Number) -> X::Versor {
        X::Versor::power(self.generator, t)
    }

    /// The generator log R.
    pub fn generator(&self) -> <X::Versor as Continuous>::Generator {
        self.generator
    }
}

/// Elements whose ratio is of the versor's type.
macro_rules! by_ratio {
    ($($Element:ident => $Versor:ident)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = $Versor<T>;

            fn versor_to(self, target: Self) -> Option<$Versor<T>> {
                let (from, to) = (self.normalized()?, target.normalized()?);
                let versor = (to * from.inverse()?).sqrt()?.renormalized()?;
                // Where the root is not unique, rounding finds one that need not lead there.
                let size = |x: Self| x.to_array().into_iter().fold(T::ZERO, |sum, c| sum + c.abs());
                let bound = (size(from) + size(to)) * T::EPSILON.sqrt();
                let image = versor.apply(from);
                size(image - to).all_le(bound).then_some(versor)
            }
        }
    )*};
}

/// Vectors and their duals, whose ratio is one scalar and one blade: the root is the normalised
/// 1 + B/A (2.38), and without a four-vector part there is nothing that rounding could add.
macro_rules! by_simple_ratio {
    ($($Element:ident => $Versor:ident)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = $Versor<T>;

            fn versor_to(self, target: Self) -> Option<$Versor<T>> {
                let ratio = target.normalized()? * self.normalized()?.inverse()?;
                let sum = ratio + $Versor::from(Rotor::identity());
                // A versor with V Ṽ < 0 leads from a real sphere to an imaginary one, and a sum
                // of that kind from a sphere to one of the opposite orientation.
                let null = |versor: Self::Versor| versor.norm_squared().all_le(T::ZERO);
                if null(ratio) || null(sum) { None } else { sum.normalized() }
            }
        }
    )*};
}

/// Elements that are a Euclidean vector or bivector at the origin or at infinity.
macro_rules! by_direction {
    ($($Element:ident $Euclidean:ident $between:ident)*) => {$(
        impl<T: Real> Carry for $Element<T> {
            type Versor = Rotor<T>;

            fn versor_to(self, target: Self) -> Option<Rotor<T>> {
                let [from, to] = [self, target].map(|x| $Euclidean::from(x.to_array()));
                Rotor::$between(from, to)
            }
        }
    )*};
}

by_simple_ratio! {
    DualPlane => Motor
    Plane => Motor
    DualSphere => Even
    Sphere => Even
}
by_ratio! {
    FlatPoint => Motor
    DualLine => Motor
    Line => Motor
    PointPair => Even
    Circle => Even
}
by_direction! {
    Vector3 Vector3 between
    Bivector3 Bivector3 between_planes
    DirectionVector Vector3 between
    DirectionBivector Bivector3 between_planes
    TangentVector Vector3 between
    TangentBivector Bivector3 between_planes
}

impl<T: Real> Carry for Point<T> {
    type Versor = Translator<T>;

    fn versor_to(self, target: Self) -> Option<Translator<T>> {
        Some(Translator::between(self, target))
    }
}
