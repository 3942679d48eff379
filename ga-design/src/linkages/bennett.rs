//! The linkage of Bennett: four hinges that are neither parallel nor meet, and move all the same
//! (4.4, Algorithms 4.7 and 4.8).

use std::f64::consts::PI;

use ga_cga::{DualSphere, Motor, Plane, Point, PointPair, Rotor, Vector3};
use ga_core::Unit;

use super::{Axis, ClosedLoop, Frame, Freedom, Link, LoopError, LoopState};

/// A Bennett linkage: links of lengths a₁, a₂, a₁, a₂ and skews α₁, α₂, α₁, α₂ with
/// sin α₂ = −sin α₁ · a₂/a₁ (4.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bennett {
    lengths: [f64; 2],
    skews: [f64; 2],
}

impl Bennett {
    /// The linkage with these lengths and the skew α₁ in radians. Of the two skews α₂ with the
    /// sine that it must have, that whose cosine has the sign of cos α₁, so that equal lengths
    /// have opposite skews.
    ///
    /// ```
    /// use ga_design::linkages::Bennett;
    ///
    /// let bennett = Bennett::new([1.0, 0.8], 60_f64.to_radians())?;
    /// let state = bennett.state(30_f64.to_radians())?;
    /// assert!(state.residual < 1e-14);
    /// assert_eq!(state.angles[0], state.angles[2]);
    /// # Ok::<(), ga_design::linkages::LoopError>(())
    /// ```
    ///
    /// # Errors
    /// [`LoopError::Number`] for lengths that are not positive and a skew that is not between −π
    /// and π, and [`LoopError::Impossible`] if |a₂ sin α₁/a₁| > 1, which no skew has for its sine.
    pub fn new(lengths: [f64; 2], skew: f64) -> Result<Self, LoopError> {
        let [first, second] = lengths;
        for (name, value) in [("a₁", first), ("a₂", second)] {
            if value.is_nan() || value <= 0.0 || value >= 1e100 {
                return Err(LoopError::Number {
                    what: format!("the length {name}"),
                    value,
                    range: "above 0, and below 1e100",
                });
            }
        }
        if skew.is_nan() || skew.abs() >= PI {
            return Err(LoopError::Number {
                what: "the skew α₁".to_owned(),
                value: skew,
                range: "between −π and π",
            });
        }
        let sine = -skew.sin() * (second / first);
        if sine.abs() > 1.0 {
            let least = second * skew.sin().abs();
            return Err(LoopError::Impossible(format!(
                "no Bennett linkage has a₁ = {first}, a₂ = {second} and α₁ = {skew} rad: \
                 a₂ sin α₁/a₁ is {:.6}, and no skew α₂ has such a sine; let a₁ be at least {least}, \
                 or α₁ smaller",
                -sine
            )));
        }
        let other = match skew.cos() < 0.0 {
            true => PI.copysign(sine) - sine.asin(),
            false => sine.asin(),
        };
        Ok(Bennett {
            lengths,
            skews: [skew, other],
        })
    }

    /// The skews α₁ and α₂ in radians.
    #[must_use]
    pub fn skews(&self) -> [f64; 2] {
        self.skews
    }

    /// The four links.
    #[must_use]
    pub fn links(&self) -> [Link; 4] {
        let [a, b] = self.lengths;
        let [alpha, beta] = self.skews;
        [(a, alpha), (b, beta), (a, alpha), (b, beta)].map(|(length, skew)| Link {
            length,
            skew,
            offset: 0.0,
        })
    }

    /// The linkage as a loop.
    ///
    /// # Errors
    /// None that a linkage has; those of [`ClosedLoop::new`].
    pub fn closed_loop(&self) -> Result<ClosedLoop, LoopError> {
        ClosedLoop::new(self.links().to_vec())
    }

    /// The angle θ₂ for θ₁: tan(θ₁/2) tan(θ₂/2) = cos((α₂ + α₁)/2)/cos((α₂ − α₁)/2). It is π where
    /// θ₁ is 0, when the linkage is folded.
    #[must_use]
    pub fn output(&self, input: f64) -> f64 {
        let [alpha, beta] = self.skews;
        let (sin, cos) = (0.5 * input).sin_cos();
        let [sum, difference] = [0.5 * (beta + alpha), 0.5 * (beta - alpha)].map(f64::cos);
        // Both are turned over together where that keeps the angle in (−π, π].
        let (y, x) = (sum * cos, difference * sin);
        2.0 * match x < 0.0 {
            true => (-y).atan2(-x),
            false => y.atan2(x),
        }
    }

    /// The state with θ₁ at an angle in radians, by the relation of input and output: θ₃ = θ₁ and
    /// θ₄ = θ₂.
    ///
    /// # Errors
    /// [`LoopError::Number`] for an angle that is not finite.
    pub fn state(&self, input: f64) -> Result<LoopState, LoopError> {
        let output = self.output(input);
        self.closed_loop()?.state(&[input, output, input, output])
    }

    /// The same state by construction (Algorithm 4.7): frame 2 from the first joint, frame 4 as the
    /// inverse of the last link, frame 3 where the spheres about both, with the lengths of the links
    /// between, meet the plane of rotation of frame 2. Of the two places that which closes the
    /// loop is taken; the angles follow from the places (Algorithm 4.8).
    ///
    /// Where the places come together, in the folded states, half of the digits are lost: there
    /// [`state`](Bennett::state) is exact.
    ///
    /// # Errors
    /// [`LoopError::Number`], and [`LoopError::Open`] if the spheres do not meet, or no place
    /// closes the loop up to 1e-6.
    pub fn by_spheres(&self, input: f64) -> Result<LoopState, LoopError> {
        let closed_loop = self.closed_loop()?;
        closed_loop.state(&[input, 0.0, 0.0, 0.0])?;
        let [first, second, third, last] = self.links();
        let start = Frame::world();
        let next = start
            .then(Freedom::Turn(Axis::Z).motion(input))
            .then(first.motion());
        let previous = start.then(last.motion().reverse());
        let sphere =
            |frame: Frame, link: Link| -> DualSphere { frame.surrounding_sphere(link.length) };
        let plane: Plane = next.plane(Axis::Z);
        let pair: PointPair =
            (sphere(next, second) ^ sphere(previous, third) ^ plane.dual()).undual();
        let mut best: Option<LoopState> = None;
        // Where they touch, or miss each other by rounding, the middle is the place.
        for place in pair.ends().into_iter().flatten().chain(pair.center()) {
            let corners = [start, next].map(Frame::origin);
            let angles = self.angles([corners[0], corners[1], place, previous.origin()]);
            let state = closed_loop.state(&angles)?;
            if best
                .as_ref()
                .is_none_or(|best| state.residual < best.residual)
            {
                best = Some(state);
            }
        }
        match best {
            Some(state) if state.residual < 1e-6 => Ok(state),
            other => Err(LoopError::Open {
                joint: 1,
                value: input,
                residual: other.map_or(f64::INFINITY, |state| state.residual),
            }),
        }
    }

    /// The joint angles from the places of the joints (Algorithm 4.8): in each plane of rotation the
    /// turn from the y-axis to the next joint.
    fn angles(&self, places: [Point; 4]) -> [f64; 4] {
        let mut attitude = Unit::<Rotor>::promised(Rotor::identity());
        let [a, b, c, d] = places;
        let mut angles = [0.0; 4];
        let steps = [(a, b), (b, c), (c, d), (d, a)];
        for ((angle, (from, to)), link) in angles.iter_mut().zip(steps).zip(self.links()) {
            let toward: Vector3 = attitude.reverse().apply(to.position() - from.position());
            *angle = (-toward.e1).atan2(toward.e2);
            let motion: Unit<Motor> = Freedom::Turn(Axis::Z).motion(*angle) * link.motion();
            let turn = Frame::promised(motion).attitude();
            attitude = attitude * Unit::promised(turn);
        }
        angles
    }
}
