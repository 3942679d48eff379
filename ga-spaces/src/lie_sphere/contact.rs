//! Oriented contact: when two elements touch, what a null vector is, and the spheres that touch
//! four given ones.

use ga_core::{Element, Field, Real, Scalar};

use super::{Bivector, Plane, Quadvector, Sphere, Vector};

/// What a null vector of Lie's geometry is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OrientedElement<T = f64> {
    /// A sphere, or a point where its radius is zero.
    Sphere(Sphere<T>),
    /// A plane with a unit normal.
    Plane(Plane<T>),
    /// The point at infinity.
    Infinity,
}

/// What is in oriented contact with four elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contacts<T = f64> {
    /// Two elements.
    Two([OrientedElement<T>; 2]),
    /// One, which counts twice.
    One(OrientedElement<T>),
    /// None that is real.
    None,
    /// No finite number: the four do not determine it.
    Undetermined,
}

impl<T: Real> Sphere<T> {
    /// Whether the spheres are in oriented contact: their inner product
    /// −½(**c**₁ − **c**₂)² + ½(ρ₁ − ρ₂)² is zero, up to the tolerance.
    pub fn touches(self, other: Self, tolerance: T) -> bool {
        self.scalar_product(other).abs().all_le(tolerance)
    }
}

impl<T: Real> Vector<T> {
    /// The sphere, plane or infinity that a null vector of any weight is. What is below the
    /// tolerance against the largest coefficient counts as zero. `None` for a vector that is not
    /// null, is zero or is not finite.
    pub fn element(self, tolerance: T) -> Option<OrientedElement<T>> {
        let unit = self * (T::ONE / finite_size(self)?);
        let small = |x: T| x.abs().all_le(tolerance);
        if !small(unit.norm_squared()) {
            return None;
        }
        let [weight, x, y, z, ni, r] = unit.to_array();
        Some(if !small(weight) {
            let center = [x, y, z].map(|c| c / weight);
            OrientedElement::Sphere(Sphere::about(center, r / weight))
        } else if !small(r) {
            OrientedElement::Plane(Plane::new(x, y, z, ni, r) * (T::ONE / r))
        } else {
            OrientedElement::Infinity
        })
    }
}

impl<T: Real> Quadvector<T> {
    /// The spheres, planes and infinity in oriented contact with four elements, given as their
    /// outer product: the problem of Apollonius.
    ///
    /// The vectors orthogonal to all four span a plane of the algebra, the dual of their outer
    /// product; its null directions are the answers. What is below the tolerance against the
    /// largest coefficient counts as zero.
    pub fn contacts(self, tolerance: T) -> Contacts<T> {
        let plane: Bivector<T> = self.dual();
        match finite_size(plane) {
            Some(size) => in_plane(plane * (T::ONE / size), tolerance),
            None => Contacts::Undetermined,
        }
    }
}

/// The null directions of a bivector of size about 1.
fn in_plane<T: Real>(plane: Bivector<T>, tolerance: T) -> Contacts<T> {
    let square = plane.scalar_product(plane);
    let tangent = square.abs().all_le(tolerance);
    if !tangent && square.all_le(T::ZERO) {
        return Contacts::None;
    }
    // Of an orthonormal basis one vector at least projects to one that is not null, unless the
    // square of the plane is zero; then each projects to the one null direction, or to nothing.
    let projected = orthonormal().map(|axis| axis.left_contract(plane));
    let turned = projected.map(|v| v.left_contract(plane));
    let elements = if tangent {
        let best = largest(turned.map(|v| (size(v), v)));
        [best.element(tolerance), None]
    } else {
        let root = square.sqrt();
        let (v, w) = largest([0, 1, 2, 3, 4, 5].map(|i| {
            let (v, w) = (projected[i], turned[i]);
            (v.norm_squared().abs(), (v, w))
        }));
        [
            (v * root + w).element(tolerance),
            (v * root - w).element(tolerance),
        ]
    };
    match elements {
        [Some(a), Some(b)] => Contacts::Two([a, b]),
        [Some(a), None] if tangent => Contacts::One(a),
        _ => Contacts::Undetermined,
    }
}

/// An orthonormal basis, with e₊ = n_o − ½n_∞ and e₋ = n_o + ½n_∞ (2.40).
fn orthonormal<T: Real>() -> [Vector<T>; 6] {
    let half = T::from_ratio(1, 2);
    let axis = |i: usize| Vector::from_fn(|j| if i == j { T::ONE } else { T::ZERO });
    let [no, e1, e2, e3, ni, r] = [0, 1, 2, 3, 4, 5].map(axis);
    [no - ni * half, no + ni * half, e1, e2, e3, r]
}

/// The entry with the largest measure.
fn largest<T: Real, X: Copy>(entries: [(T, X); 6]) -> X {
    let [first, rest @ ..] = entries;
    let pick = |best: (T, X), next: (T, X)| if next.0.all_le(best.0) { best } else { next };
    rest.into_iter().fold(first, pick).1
}

/// The size of the largest coefficient.
fn size<X: Element<Number: Real>>(x: X) -> X::Number {
    (0..X::BLADES.len())
        .map(|i| x.at(i).abs())
        .fold(X::Number::ZERO, |a, b| if b.all_le(a) { a } else { b })
}

/// The size of the largest coefficient, if it is neither zero nor infinite.
fn finite_size<X: Element<Number: Real>>(x: X) -> Option<X::Number> {
    let size = size(x);
    (size.is_invertible() && size.is_finite()).then_some(size)
}
