//! A vertex of four creases, folded by spheres (figures 2.15–2.17).
//!
//! ```text
//!        2 (third)
//!          |  panel 1–2        panel 0–1 stays where it is,
//!  3 ──────o────── 1           crease 1 is driven,
//!          |  panel 0–1        corner 3 is where three spheres meet
//!        0 (first)
//! ```

use super::{FoldError, Meeting};
use ga_cga::{Bivector3, Motor, Point, Rotor, Trivector3, Vector3};
use std::f64::consts::{PI, TAU};

/// How far the sum of the sectors may be from a whole turn.
const FLATNESS: f64 = 1e-9;

/// A flat vertex of four creases: the angles of the sectors between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    corners: [Point; 4],
}

/// Which of its two motions a vertex makes. The choice of one of the two places where three
/// spheres meet is the choice of the mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldMode {
    /// The crease opposite to the driven one folds the same way, and the other two fold one this
    /// way and one that.
    Alike,
    /// The crease opposite to the driven one folds the other way, and the other two fold the same
    /// way.
    Opposed,
}

/// A folded vertex: its corners, at distance one from it on each crease. The vertex is the origin,
/// and the panel between the first and the second crease stays in the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoldedVertex {
    corners: [Point; 4],
}

impl Vertex {
    /// The vertex with these sector angles in radians: the first from the first crease to the
    /// second, and so on round.
    ///
    /// # Errors
    /// [`FoldError::Sectors`] if an angle is not between 0 and π, or they do not add up to 2π.
    pub fn new(sectors: [f64; 4]) -> Result<Self, FoldError> {
        let inside = |angle: &f64| *angle > 0.0 && *angle < PI;
        let sum: f64 = sectors.iter().sum();
        if !sectors.iter().all(inside) || (sum - TAU).abs() > FLATNESS {
            return Err(FoldError::Sectors { sectors });
        }
        let floor = Bivector3::new(1.0, 0.0, 0.0);
        let first = Vector3::new(1.0, 0.0, 0.0);
        let mut angle = 0.0;
        let mut corners = [Point::from(first); 4];
        for (corner, sector) in corners.iter_mut().zip(sectors) {
            let turn = Rotor::turn(floor, angle).unwrap_or(Rotor::identity());
            *corner = Point::from(turn.apply(first));
            angle += sector;
        }
        Ok(Vertex { corners })
    }

    /// The vertex before folding.
    #[must_use]
    pub fn flat(&self) -> FoldedVertex {
        FoldedVertex {
            corners: self.corners,
        }
    }

    /// The vertex with its second crease folded by an angle in radians, from −π to π; positive
    /// lifts the third corner above the floor.
    ///
    /// The third corner turns on the circle in which the spheres about the vertex and the second
    /// corner meet. The fourth is where the spheres about the vertex, the first and the third
    /// corner meet, all through its place on the flat paper.
    ///
    /// Near the flat state the two places come together, and the root costs half of the digits:
    /// at a fold of ρ the error is about 1e−16/ρ, down to folds of about 10⁻⁶. Below, the two
    /// places count as one, and the corner stays in the floor.
    ///
    /// # Errors
    /// [`FoldError::Angle`] if the angle is out of range, [`FoldError::Apart`] if the mode does
    /// not reach so far, [`FoldError::Open`] if the third corner comes to lie on the first, about
    /// which the fourth is free to turn.
    pub fn fold(&self, angle: f64, mode: FoldMode) -> Result<FoldedVertex, FoldError> {
        let inside = angle.abs() <= PI;
        if !inside {
            return Err(FoldError::Angle {
                what: "the fold of the driven crease",
                value: angle,
                range: "from −π to π",
            });
        }
        let [first, second, third, fourth] = self.corners;
        let vertex = Point::from(Vector3::default());
        let lift = Rotor::about_axis(second.position(), angle);
        let raised = Motor::from(lift.unwrap_or(Rotor::identity())).apply(third);
        let meeting = Meeting::of_moved([vertex, first, third], fourth, [vertex, first, raised]);
        let corner = "the fourth corner";
        if meeting == Meeting::Aligned {
            return Err(FoldError::Open { corner });
        }
        let wanted = match mode {
            FoldMode::Alike => angle.signum(),
            FoldMode::Opposed => -angle.signum(),
        };
        let at = |corner: Point| FoldedVertex {
            corners: [first, second, raised, corner],
        };
        // How far the fourth crease folds the way that the mode wants.
        let folds = |corner: Point| {
            let [.., last] = at(corner).fold_angles();
            wanted * last
        };
        let place = meeting.with_most(folds);
        place.map(at).ok_or(FoldError::Apart { corner })
    }
}

impl FoldedVertex {
    /// The corners, at distance one from the vertex on each crease.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        self.corners
    }

    /// The sector angles in radians, as they are on the folded vertex: those of the flat one.
    #[must_use]
    pub fn sectors(&self) -> [f64; 4] {
        let [a, b, c, d] = self.corners.map(Point::position);
        [(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| {
            let ratio = to * from;
            (from ^ to).norm().atan2(ratio.s)
        })
    }

    /// The fold angles in radians at the four creases, from −π to π: 0 where it is flat, positive
    /// where the panel after the crease is turned up.
    #[must_use]
    pub fn fold_angles(&self) -> [f64; 4] {
        let [a, b, c, d] = self.corners.map(Point::position);
        [(d, a, b), (a, b, c), (b, c, d), (c, d, a)].map(|(before, crease, after)| {
            // The ratio of the panels is the square of the rotor that takes one to the other.
            let (from, to): (Bivector3, Bivector3) = (before ^ crease, crease ^ after);
            let ratio: Rotor = to * from.reverse();
            let turn = Bivector3::new(ratio.e12, ratio.e13, ratio.e23);
            let Trivector3 { e123: volume } = crease ^ turn;
            (-volume).atan2(ratio.s)
        })
    }
}
