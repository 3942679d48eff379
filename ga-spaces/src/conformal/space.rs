//! What holds in the conformal model of every dimension: points, spheres, planes and motions,
//! written once with the products.

use core::ops::{Add, Mul, Sub};

use ga_core::convert::pick;
use ga_core::ops::{Apply, Geometric, Reverse, ScalarProduct};
use ga_core::{Blade, Element, Field};

/// The conformal model of a Euclidean space.
///
/// The types are those of one generated algebra; the functions are the same in all.
pub trait ConformalSpace<T: Field>: Sized {
    /// The dimension of the Euclidean space.
    const DIMENSION: usize;
    /// A Euclidean vector; it comes from and goes to an array of its coordinates.
    type Vector: Element<Number = T> + Default + ScalarProduct<Output = T> + Into<Self::Sphere>;
    /// A point of weight 1.
    type Point: Element<Number = T> + ScalarProduct<Output = T> + Into<Self::Sphere>;
    /// A sphere by its dual vector, of one dimension less than the space.
    type Sphere: Element<Number = T>
        + Add<Output = Self::Sphere>
        + Sub<Output = Self::Sphere>
        + Mul<T, Output = Self::Sphere>
        + ScalarProduct<Output = T>
        + Geometric<Output = Self::Versor>
        + Apply<Self::Sphere, Output = Self::Sphere>;
    /// A translation.
    type Translator: Element<Number = T>
        + Into<Self::Versor>
        + Reverse<Output = Self::Translator>
        + Apply<Self::Point, Output = Self::Point>
        + Apply<Self::Sphere, Output = Self::Sphere>;
    /// An even versor: any conformal transformation that keeps orientation.
    type Versor: Element<Number = T>
        + Add<Output = Self::Versor>
        + Geometric<Output = Self::Versor>
        + Apply<Self::Sphere, Output = Self::Sphere>;

    /// The point at the origin n_o.
    fn origin() -> Self::Sphere {
        Self::axis(Self::DIMENSION)
    }

    /// The point at infinity n_∞.
    fn infinity() -> Self::Sphere {
        Self::axis(Self::DIMENSION + 1)
    }

    /// The basis vector at a position of the basis e₁ … eₙ, n_o, n_∞; zero beyond.
    fn axis(position: usize) -> Self::Sphere {
        let on_axis = |blade: Blade| blade.contains(position);
        Self::Sphere::from_fn(|i| {
            if on_axis(Self::Sphere::BLADES[i].0) {
                T::ONE
            } else {
                T::ZERO
            }
        })
    }

    /// The point at a position, n_o + **x** + ½**x**² n_∞ (2.44).
    fn point(x: Self::Vector) -> Self::Point {
        let half_square = x.scalar_product(x) * T::from_ratio(1, 2);
        pick(Self::origin() + x.into() + Self::infinity() * half_square)
    }

    /// The centre of a sphere, which for the image of a point is the point; `None` for a plane
    /// or n_∞.
    fn position(sphere: Self::Sphere) -> Option<Self::Vector> {
        let weight = Self::weight(sphere);
        weight
            .is_invertible()
            .then(|| pick(sphere * (T::ONE / weight)))
    }

    /// The squared distance of two points, −2 p·q (2.46).
    fn squared_distance(p: Self::Point, q: Self::Point) -> T {
        p.scalar_product(q) * T::from_integer(-2)
    }

    /// The sphere about a point with this squared radius, p − ½r² n_∞ (2.52); imaginary where
    /// that is negative, the point itself where it is zero.
    fn dual_sphere(center: Self::Point, radius_squared: T) -> Self::Sphere {
        center.into() - Self::infinity() * (radius_squared * T::from_ratio(1, 2))
    }

    /// The plane **n**·**x** = δ, **n** + δ n_∞.
    fn dual_plane(normal: Self::Vector, offset: T) -> Self::Sphere {
        normal.into() + Self::infinity() * offset
    }

    /// The weight −σ·n_∞ of a sphere; zero for a plane.
    fn weight(sphere: Self::Sphere) -> T {
        -sphere.scalar_product(Self::infinity())
    }

    /// The squared radius σ²/(σ·n_∞)² of a sphere; `None` for a plane or n_∞.
    fn radius_squared(sphere: Self::Sphere) -> Option<T> {
        let weight = Self::weight(sphere);
        let square = weight * weight;
        square
            .is_invertible()
            .then(|| sphere.scalar_product(sphere) / square)
    }

    /// The image of a point, sphere or plane under the inversion in a sphere or the reflection
    /// in a plane (2.28); `None` for a null mirror, a point or n_∞.
    fn reflect(mirror: Self::Sphere, x: Self::Sphere) -> Option<Self::Sphere> {
        let square = mirror.scalar_product(mirror);
        square.is_invertible().then(|| mirror.apply(x))
    }

    /// The translation by a vector, 1 − ½**v** n_∞.
    fn translator(v: Self::Vector) -> Self::Translator {
        // The product of v with n_∞ has no scalar part; the 1 is the type's own.
        pick(v.into().geometric(Self::infinity() * T::from_ratio(-1, 2)))
    }

    /// The rotation about the origin by twice the angle from `a` to `b`, the reflections across
    /// them one after the other: **b** **a**. `None` where one of them is zero.
    fn rotor(a: Self::Vector, b: Self::Vector) -> Option<Self::Versor> {
        let squares = a.scalar_product(a) * b.scalar_product(b);
        squares
            .is_invertible()
            .then(|| b.into().geometric(a.into()))
    }

    /// The scaling about the origin by a factor of either sign, the inversions in the spheres of
    /// squared radius 1 and `factor`; `None` for the factor zero.
    fn dilator(factor: T) -> Option<Self::Versor> {
        let sphere = |square: T| Self::origin() - Self::infinity() * (square * T::from_ratio(1, 2));
        factor
            .is_invertible()
            .then(|| sphere(factor).geometric(sphere(T::ONE)))
    }

    /// The transversion by a vector, 1 − **v** n_o: the inversion in the unit sphere, the
    /// translation by **v** and the inversion again.
    fn transversor(v: Self::Vector) -> Self::Versor {
        let unit = Self::origin() - Self::infinity() * T::from_ratio(1, 2);
        let one = unit.geometric(unit);
        one + v.into().geometric(Self::origin() * -T::ONE)
    }
}
