//! What an isometry is, geometrically: turn, screw, mirror, glide, inversion, and where.

use ga_cga::{DualPlane, Point, Rotor, Trivector3, Vector3};

use super::Isometry;

/// Turns below this angle, and translations below this length, are rounding.
const TOLERANCE: f64 = 1e-7;

/// An isometry by its kind, with what it leaves in place and the part of its translation that no
/// choice of origin removes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Nothing moves.
    Identity,
    /// All points move alike.
    Translation {
        /// By how much.
        vector: Vector3,
    },
    /// A rotation, or a screw if there is a rise.
    Screw {
        /// A point on the axis.
        through: Point,
        /// The unit direction of the axis, such that the angle is positive.
        axis: Vector3,
        /// The angle in radians, anticlockwise seen against the axis, in (0, π].
        angle: f64,
        /// The translation along the axis: zero for a rotation, positive for a right-handed
        /// screw. The hand of a screw by π depends on the sense that is given to its axis.
        rise: f64,
    },
    /// A reflection, or a glide if there is a translation along the plane.
    Glide {
        /// The mirror.
        plane: DualPlane,
        /// The translation along it.
        vector: Vector3,
    },
    /// An inversion in a point, or a roto-inversion: a rotation followed by the inversion in a
    /// point of its axis.
    RotoInversion {
        /// The point that stays.
        center: Point,
        /// The unit direction of the axis; `None` for the inversion alone.
        axis: Option<Vector3>,
        /// The angle of the rotation in radians, in [0, π).
        angle: f64,
    },
}

impl Isometry {
    /// The kind of the isometry, its place, and its screw or glide part.
    ///
    /// ```
    /// use ga_design::crystallography::{Cell, Isometry, Motion};
    ///
    /// let cell = Cell::new([5.0, 5.0, 8.0], [90.0, 90.0, 90.0])?;
    /// let screw = Isometry::of_operation(&"-y,x,z+1/4".parse()?, &cell)?;
    /// let Motion::Screw { axis, angle, rise, .. } = screw.motion() else { panic!("a screw") };
    /// // 4₁ is right-handed: up by a quarter of c with a quarter turn to the left.
    /// assert!((axis.e3 - 1.0).abs() < 1e-12 && (rise - 2.0).abs() < 1e-12);
    /// assert!((angle.to_degrees() - 90.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn motion(&self) -> Motion {
        if self.is_proper() {
            self.proper_motion()
        } else {
            self.improper_motion()
        }
    }

    fn proper_motion(&self) -> Motion {
        let shift = self.shift();
        let Some((axis, angle)) = self.turn() else {
            return if shift.norm() <= TOLERANCE {
                Motion::Identity
            } else {
                Motion::Translation { vector: shift }
            };
        };
        let rise = shift.scalar_product(axis);
        Motion::Screw {
            through: Point::from(fixed(shift - axis * rise, axis, angle)),
            axis,
            angle,
            rise: if rise.abs() <= TOLERANCE { 0.0 } else { rise },
        }
    }

    fn improper_motion(&self) -> Motion {
        let shift = self.shift();
        // Followed by the inversion in the origin the rest is a rotation: by 180° about the
        // normal for a mirror, by nothing for an inversion.
        let rotation = Self::inversion().after(self);
        match rotation.turn() {
            None => Motion::RotoInversion {
                center: Point::from(shift * 0.5),
                axis: None,
                angle: 0.0,
            },
            Some((normal, angle)) if std::f64::consts::PI - angle <= TOLERANCE => {
                let distance = shift.scalar_product(normal);
                let glide = shift - normal * distance;
                let none = glide.norm() <= TOLERANCE;
                Motion::Glide {
                    plane: DualPlane::at_distance(normal, distance * 0.5),
                    vector: if none { Vector3::default() } else { glide },
                }
            }
            Some((axis, angle)) => {
                // Along the axis the motion is an inversion, across it a turn by π more.
                let along = axis * shift.scalar_product(axis);
                let across = fixed(shift - along, axis, angle + std::f64::consts::PI);
                Motion::RotoInversion {
                    center: Point::from(along * 0.5 + across),
                    axis: Some(axis),
                    angle,
                }
            }
        }
    }

    /// The direction of the axis and the angle in (0, π] of the rotation that remains about the
    /// origin; `None` for none.
    fn turn(&self) -> Option<(Vector3, f64)> {
        let rotor = self.motor.rotation()?;
        // Of the two rotors R and −R of a rotation the one that goes the short way.
        let rotor = if rotor.s < 0.0 { -rotor } else { rotor };
        let plane = rotor.plane()?;
        let angle = rotor.angle();
        let axis: Vector3 = plane * Trivector3::new(-1.0);
        (angle > TOLERANCE).then_some((axis, angle))
    }
}

/// The point nearest to the origin that a turn about `axis` and the step `across`, perpendicular
/// to the axis, leave in place.
///
/// From there the step is seen as a chord of the angle: half of it, and on from its middle by
/// the height of the isosceles triangle.
fn fixed(across: Vector3, axis: Vector3, angle: f64) -> Vector3 {
    let (sine, cosine) = (angle * 0.5).sin_cos();
    let quarter_turn = Rotor::about_axis(axis, std::f64::consts::FRAC_PI_2);
    let aside = quarter_turn.map_or(Vector3::default(), |rotor| rotor.apply(across));
    if sine == 0.0 {
        return across * 0.5;
    }
    across * 0.5 + aside * (0.5 * cosine / sine)
}
