//! Rotations about the origin.

use ga_core::Real;

use crate::cga3::{Bivector3, Rotor, Trivector3, Vector3};
use crate::classify::range::{length, within_range};

impl<T: Real> Rotor<T> {
    /// The rotation by an angle in radians in the plane of a bivector, in its sense:
    /// e^{−θB/2} (2.35); `None` for a bivector of size zero.
    ///
    /// ```
    /// use ga_cga::{Bivector3, Rotor, Vector3};
    ///
    /// // e12 turns the x axis towards the y axis.
    /// let quarter = Rotor::turn(Bivector3::new(2.0, 0.0, 0.0), core::f64::consts::FRAC_PI_2);
    /// let image = quarter.unwrap().apply(Vector3::new(1.0, 0.0, 0.0));
    /// assert!((image - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-15);
    /// ```
    pub fn turn(plane: Bivector3<T>, angle: T) -> Option<Self> {
        let plane = within_range(plane)?.normalized()?;
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        // Euler's formula (2.33), because an exponent of size 10²⁰⁰ has no square.
        let rotor = Rotor::from(plane * -sin) + Rotor::identity() * cos;
        cos.is_finite().then_some(rotor)
    }

    /// The rotation by an angle in radians about an axis through the origin, anticlockwise
    /// seen against its direction; `None` for an axis of length zero.
    pub fn about_axis(axis: Vector3<T>, angle: T) -> Option<Self> {
        // The plane whose normal the axis is.
        Rotor::turn(axis * Trivector3::new(T::ONE), angle)
    }

    /// The rotation that takes the direction of one vector to that of another in their common
    /// plane, the short way: (1 + ba)/√(2(1 + ⟨ab⟩)) for unit vectors a, b (2.36–2.38).
    ///
    /// `None` if a vector has length zero, or if they are opposite: then every plane through them
    /// is as short a way, and [`between_in`](Rotor::between_in) chooses one.
    ///
    /// ```
    /// use ga_cga::{Rotor, Vector3};
    ///
    /// let (a, b) = (Vector3::new(3.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 1.0));
    /// let image = Rotor::between(a, b).unwrap().apply(a);
    /// assert!((image - b * (3.0 / b.norm())).norm() < 1e-15);
    /// assert_eq!(Rotor::between(a, -a), None);
    /// ```
    pub fn between(from: Vector3<T>, to: Vector3<T>) -> Option<Self> {
        let [from, to] = [within_range(from)?, within_range(to)?];
        let (from, to) = (from.normalized()?, to.normalized()?);
        let (sum, difference) = (from + to, to - from);
        // With the unit vector h half-way, 1 + ba = (a + b) a is a multiple of h a. Near opposite
        // vectors a + b is small and its part along b − a, which should be zero, is rounding
        // error: it is rejected.
        let half_way = if difference.norm_squared().all_le(T::ONE) {
            sum
        } else {
            sum.reject(difference)
        };
        let rotor = half_way.normalized()? * from;
        rotor.normalized()
    }

    /// The rotation that takes the direction of one vector to that of another as
    /// [`between`](Rotor::between) does, and if they are opposite the half turn in the plane
    /// through `from` that is nearest to the given one, in its sense.
    ///
    /// `None` if a vector has length zero, or if they are opposite and the plane is of size zero
    /// or at a right angle to them.
    ///
    /// ```
    /// use ga_cga::{Bivector3, Rotor, Vector3};
    ///
    /// let (a, floor) = (Vector3::new(1.0, 0.0, 0.0), Bivector3::new(1.0, 0.0, 0.0));
    /// let half_turn = Rotor::between_in(a, -a, floor).unwrap();
    /// assert!((half_turn.apply(a) + a).norm() < 1e-15);
    /// // Half a turn in the floor keeps what is upright.
    /// let up = Vector3::new(0.0, 0.0, 1.0);
    /// assert!((half_turn.apply(up) - up).norm() < 1e-15);
    /// ```
    pub fn between_in(from: Vector3<T>, to: Vector3<T>, plane: Bivector3<T>) -> Option<Self> {
        if let Some(rotor) = Rotor::between(from, to) {
            return Some(rotor);
        }
        let (from, _) = (within_range(from)?.normalized()?, within_range(to)?);
        // A quarter turn on in the plane is a ⌋ B, and a ∧ (a ⌋ B) the part of B through a.
        let through = from ^ from.left_contract(within_range(plane)?.normalized()?);
        Rotor::turn(through, T::PI)
    }

    /// The rotation that takes one plane through the origin to another in its sense, about the
    /// line in which they meet: √(B/A) (2.66).
    ///
    /// `None` if a bivector has size zero or they are opposite, when every line of the plane will
    /// do.
    pub fn between_planes(from: Bivector3<T>, to: Bivector3<T>) -> Option<Self> {
        let normal = |plane: Bivector3<T>| plane * Trivector3::new(-T::ONE);
        Rotor::between(normal(from), normal(to))
    }

    /// The angle in radians that it turns by in the sense of its [`plane`](Rotor::plane), in
    /// [0, 2π).
    pub fn angle(self) -> T {
        let plane = Bivector3::new(self.e12, self.e13, self.e23);
        length(plane).atan2(self.s) * T::from_integer(2)
    }

    /// The unit bivector B in whose sense it turns, R = e^{−θB/2}; `None` for the identity.
    pub fn plane(self) -> Option<Bivector3<T>> {
        within_range(Bivector3::new(-self.e12, -self.e13, -self.e23))?.normalized()
    }

    /// The unit vector about which it turns anticlockwise, seen against its direction; `None`
    /// for the identity.
    pub fn axis(self) -> Option<Vector3<T>> {
        Some(self.plane()? * Trivector3::new(-T::ONE))
    }

    /// The identity.
    pub fn identity() -> Self {
        Rotor {
            s: T::ONE,
            ..Rotor::default()
        }
    }
}
