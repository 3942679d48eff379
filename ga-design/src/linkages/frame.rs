//! What a frame of reference is: a position and an orientation as one motor (4.2).

use ga_cga::{
    Bivector3, Circle, DualSphere, Line, Motor, Plane, Point, Rotor, Translator, Vector3,
};
use ga_core::Unit;

/// One of the three axes of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis, which joints turn about and slide along.
    Z,
}

impl Axis {
    /// The unit vector of the axis.
    pub(crate) fn vector(self) -> Vector3 {
        match self {
            Axis::X => Vector3::new(1.0, 0.0, 0.0),
            Axis::Y => Vector3::new(0.0, 1.0, 0.0),
            Axis::Z => Vector3::new(0.0, 0.0, 1.0),
        }
    }
}

/// Where a body stands and how it is turned: the motor M = T R that takes the origin and the
/// world's axes to those of the body (4.2). It is a unit motor whose numbers are finite.
///
/// ```
/// use ga_cga::{Point, Rotor, Vector3};
/// use ga_design::linkages::{Axis, Frame};
///
/// let quarter = Rotor::about_axis(Vector3::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2);
/// let frame = Frame::at(Point::at(1.0, 2.0, 3.0), quarter.unwrap()).unwrap();
/// assert!((frame.axis(Axis::X) - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-15);
/// assert!(frame.origin().distance(Point::at(1.0, 2.0, 3.0)) < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    motor: Unit<Motor>,
}

impl Axis {
    /// A plane that the axis lies in.
    pub(crate) fn plane_through(self) -> Bivector3 {
        match self {
            Axis::X | Axis::Y => Bivector3::new(1.0, 0.0, 0.0),
            Axis::Z => Bivector3::new(0.0, 1.0, 0.0),
        }
    }
}

impl Frame {
    /// The frame of the world.
    #[must_use]
    pub fn world() -> Self {
        Frame {
            motor: Unit::promised(Motor::identity()),
        }
    }

    /// The frame that a motor takes the world's to; `None` for zero and for numbers that are not
    /// finite.
    #[must_use]
    pub fn new(motor: Motor) -> Option<Self> {
        let motor = Unit::promised(motor.renormalized()?);
        let finite = motor.to_array().into_iter().all(f64::is_finite);
        finite.then_some(Frame { motor })
    }

    /// The frame of a motor that is unit and finite.
    pub(super) fn promised(motor: Unit<Motor>) -> Self {
        Frame { motor }
    }

    /// The frame at a point, turned by a rotation; `None` as for [`new`](Frame::new).
    #[must_use]
    pub fn at(origin: Point, attitude: Rotor) -> Option<Self> {
        let translation = Translator::by(origin.position());
        Frame::new(Motor::rigid(attitude, translation))
    }

    /// The motor that takes the world's frame to this one.
    #[must_use]
    pub fn motor(self) -> Unit<Motor> {
        self.motor
    }

    /// The frame that a motion in this frame takes this frame to: M of the one is M of the other
    /// times the motion.
    #[must_use]
    pub fn then(self, motion: Unit<Motor>) -> Self {
        Frame {
            motor: self.motor * motion,
        }
    }

    /// The motion in this frame that takes it to the other: `self.then(motion)` is `other`.
    #[must_use]
    pub fn motion_to(self, other: Frame) -> Unit<Motor> {
        self.motor.reverse() * other.motor
    }

    /// This frame as it is seen from another: the motion from that to this one, from the world's
    /// frame.
    #[must_use]
    pub fn relative_to(self, other: Frame) -> Frame {
        Frame {
            motor: other.motion_to(self),
        }
    }

    /// Where the frame stands.
    #[must_use]
    pub fn origin(self) -> Point {
        self.motor.apply(Point::at(0.0, 0.0, 0.0))
    }

    /// How it is turned: the rotation R of M = T R.
    #[must_use]
    pub fn attitude(self) -> Rotor {
        let motor = self.motor;
        Rotor::new(motor.s, motor.e12, motor.e13, motor.e23)
    }

    /// How it is turned as a quaternion w, x, y, z with w of at least zero, and where that is zero
    /// the first other number that is not.
    #[must_use]
    pub fn quaternion(self) -> [f64; 4] {
        let quaternion = self.attitude().to_quaternion();
        // What rounding leaves of zero has no sign to go by.
        let leading = quaternion.into_iter().find(|x| x.abs() > 1e-9);
        match leading {
            Some(number) if number < 0.0 => quaternion.map(|x| 0.0 - x),
            _ => quaternion,
        }
    }

    /// One of its axes, a unit vector.
    #[must_use]
    pub fn axis(self, axis: Axis) -> Vector3 {
        Unit::<Rotor>::promised(self.attitude()).apply(axis.vector())
    }

    /// The line through its origin along one of its axes.
    #[must_use]
    pub fn line(self, axis: Axis) -> Line {
        Line::along(self.origin(), self.axis(axis))
    }

    /// The plane through its origin at a right angle to one of its axes: for [`Axis::Z`] the
    /// plane of rotation Π = M[e₁₂ ∧ n_o ∧ n_∞] of a joint there.
    #[must_use]
    pub fn plane(self, normal: Axis) -> Plane {
        Plane::with_normal(self.origin(), self.axis(normal))
    }

    /// The circle of that radius about its origin in its plane of rotation, which a point on the
    /// x-axis runs through as the joint turns.
    #[must_use]
    pub fn circle_of_rotation(self, radius: f64) -> Circle {
        let floor = Bivector3::new(1.0, 0.0, 0.0);
        let turned = Unit::<Rotor>::promised(self.attitude()).apply(floor);
        Circle::about(self.origin(), radius * radius, turned)
    }

    /// The sphere σ of that radius about its origin: where what is a link of that length away can
    /// be.
    #[must_use]
    pub fn surrounding_sphere(self, radius: f64) -> DualSphere {
        DualSphere::about(self.origin(), radius * radius)
    }
}
