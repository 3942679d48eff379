//! What a rigid motion leaves in place, read off its versor: the axis from the logarithm of a motor, the
//! plane and the point from the parts of an odd versor.

use ga_cga::{
    DualLine, DualPlane, FlatPoint, Motor, OddVersor, Point, PointPair, Translator, Vector3,
};
use ga_core::convert::{grade, pick};
use std::f64::consts::PI;

use super::Isometry;

/// Half angles whose sine or cosine is below this count as none: far below any rotation of a crystal,
/// far above rounding.
const SMALL: f64 = 1e-9;

/// The geometric element of a rigid motion, and what the motion does about or along it; lengths in the
/// unit of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MotionElement {
    /// A translation, by zero for the identity.
    Translation(Vector3),
    /// A rotation or screw.
    Screw {
        /// The axis, of weight 1, in the direction against which the rotation is anticlockwise.
        axis: DualLine,
        /// The angle in radians, in (0, π].
        angle: f64,
        /// The translation along the axis in its direction: positive for a right-handed screw.
        advance: f64,
    },
    /// A reflection or glide.
    Glide {
        /// The plane, of weight 1.
        plane: DualPlane,
        /// The translation along the plane, zero for a reflection.
        glide: Vector3,
    },
    /// A rotation about an axis and the inversion in a point of it.
    Rotoinversion {
        /// The axis, of weight 1, in the direction against which the rotation is anticlockwise.
        axis: DualLine,
        /// The angle of the rotation in radians, in (0, π).
        angle: f64,
        /// The point that stays where it is.
        point: Point,
    },
    /// The inversion in a point.
    Inversion(Point),
}

impl Isometry {
    /// The element of the motion; `None` for a motor that is no versor or a mirror without normal.
    ///
    /// ```
    /// use ga_design::crystallography::{Isometry, MotionElement, Placement};
    ///
    /// // Two reflections in planes 45° apart and a translation: a fourfold screw.
    /// let half = 0.5_f64.sqrt();
    /// let screw = Placement {
    ///     reflections: vec![[half, half, 0.0], [1.0, 0.0, 0.0]],
    ///     translation: [1.0, 0.0, 3.0],
    /// };
    /// let Some(MotionElement::Screw { axis, angle, advance }) = Isometry::from(&screw).element()
    /// else {
    ///     panic!("a screw")
    /// };
    /// assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    /// assert!((advance - 3.0).abs() < 1e-12);
    /// let foot = axis.nearest(ga_cga::Point::at(0.0, 0.0, 0.0)).unwrap();
    /// assert!(foot.distance(ga_cga::Point::at(0.5, 0.5, 0.0)) < 1e-12);
    /// ```
    pub fn element(&self) -> Option<MotionElement> {
        match self.mirror {
            None => of_motor(self.motor),
            Some(mirror) => of_odd(self.motor * mirror),
        }
    }
}

fn of_motor(motor: Motor) -> Option<MotionElement> {
    let shift = motor.translation()?.vector();
    // Of the two versors of a motion take the one that turns by at most π.
    let motor = if motor.s < 0.0 { -motor } else { motor };
    let rotation = motor.rotation()?;
    let angle = rotation.angle();
    let Some(direction) = rotation.axis().filter(|_| angle > SMALL) else {
        return Some(MotionElement::Translation(shift));
    };
    // log M = −½ (θ λ + …): what the screw adds to its axis is left out by normalising.
    let generator: DualLine = motor.log()?;
    let axis: DualLine = pick(Motor::from(-generator).renormalized()?);
    Some(MotionElement::Screw {
        axis,
        angle,
        advance: shift.scalar_product(direction),
    })
}

/// An odd versor cos(φ/2) σ − sin(φ/2) λσ turns about a line λ and reflects in a plane σ across it; its
/// part of grade 3 is the dual of the flat point where they meet, or a glide's direction.
fn of_odd(versor: OddVersor) -> Option<MotionElement> {
    let plane: DualPlane = pick(versor);
    let point: PointPair = pick(grade(versor, 3).undual());
    let point: FlatPoint = pick(point);
    let (reflects, inverts) = (plane.weight(), point.weight().abs());
    let size = reflects.hypot(inverts);
    if inverts <= SMALL * size {
        let plane = plane / reflects;
        let shift: Motor = pick(versor * plane);
        let shift: Translator = shift.translation()?;
        let glide = shift.vector();
        return Some(MotionElement::Glide { plane, glide });
    }
    let point = point.location()?;
    if reflects <= SMALL * size {
        return Some(MotionElement::Inversion(point));
    }
    // V σ⁻¹ is the rotation about the normal through the point; the inversion turns by π more.
    let turn: Motor = pick(versor * (plane / reflects));
    let turn = turn.rotation()?;
    let beyond = turn.angle() - PI;
    let direction = turn.axis()? * beyond.signum();
    Some(MotionElement::Rotoinversion {
        axis: DualLine::along(point, direction),
        angle: beyond.abs(),
        point,
    })
}
