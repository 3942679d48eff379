//! How a loop moves as one joint is turned: its states one after the other, and where it cannot go
//! on or could go on in two ways.

use std::f64::consts::TAU;

use super::{ClosedLoop, LoopError, LoopState, rank};

/// The configurations of a loop, from the first to the last that it reaches.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The states; angles run on, without jumps at π.
    pub states: Vec<LoopState>,
    /// What happens on the way.
    pub turns: Vec<Turn>,
}

/// A place on the way of a loop where it is not like elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turn {
    /// The driven joint can turn no further.
    Dead {
        /// Its angle in radians.
        angle: f64,
    },
    /// The other joints have more freedom than before: the loop may go on in several ways.
    Branch {
        /// The angle of the driven joint in radians.
        angle: f64,
    },
}

/// How far another joint may turn in one step, in radians.
const LONGEST: f64 = 0.3;
/// The step of the driven joint at which it is taken to stand still, in radians.
const SHORTEST: f64 = 1e-7;

impl ClosedLoop {
    /// Turns a joint, counted from 0, from where it is in a state to an angle, in so many equal
    /// steps. Where the loop cannot go on it ends earlier, with the last state that it reaches.
    ///
    /// # Errors
    /// As [`frames`](ClosedLoop::frames) for the state and the angle, and [`LoopError::Joint`].
    pub fn moved(
        &self,
        start: &LoopState,
        driven: usize,
        to: f64,
        steps: usize,
    ) -> Result<Motion, LoopError> {
        self.check(&start.angles)?;
        self.check_joint(driven)?;
        let from = start.angles.get(driven).copied().unwrap_or_default();
        if !to.is_finite() {
            return Err(LoopError::Number {
                what: format!("the last angle of joint {}", driven + 1),
                value: to,
                range: "finite",
            });
        }
        let steps = steps.max(1);
        let mut motion = Motion {
            states: vec![start.clone()],
            turns: Vec::new(),
        };
        let usual = self.other_rank(&start.angles, driven);
        let mut was_branch = false;
        let mut walk = Walk {
            angles: start.angles.clone(),
            slope: vec![0.0; self.joints()],
            value: from,
        };
        for step in 1..=steps {
            let target = from + (to - from) * step as f64 / steps as f64;
            let is_there = self.walk_to(&mut walk, driven, target);
            let residual = self.judged(&walk.angles).residual;
            motion.states.push(LoopState {
                angles: walk.angles.clone(),
                residual,
            });
            if !is_there {
                motion.turns.push(Turn::Dead { angle: walk.value });
                break;
            }
            let is_branch = self.other_rank(&walk.angles, driven) < usual;
            if is_branch && !was_branch {
                motion.turns.push(Turn::Branch { angle: target });
            }
            was_branch = is_branch;
        }
        Ok(motion)
    }

    /// Walks to a value of the driven joint in steps as long as the loop follows; whether it got
    /// there.
    fn walk_to(&self, walk: &mut Walk, driven: usize, target: f64) -> bool {
        let mut step = target - walk.value;
        while (target - walk.value).abs() > 0.0 {
            if step.abs() > (target - walk.value).abs() {
                step = target - walk.value;
            }
            let value = if step == target - walk.value {
                target
            } else {
                walk.value + step
            };
            let pairs = walk.angles.iter().zip(&walk.slope);
            let guess: Vec<f64> = pairs.map(|(angle, slope)| angle + slope * step).collect();
            let found = self.closed_near(&guess, driven, value).ok();
            let angles = found.map(|state| unwrapped(&state.angles, &guess, driven, value));
            let pairs = angles
                .as_ref()
                .map(|angles| angles.iter().zip(&walk.angles));
            let longest = pairs.map(|pairs| pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max));
            match (angles, longest) {
                (Some(angles), Some(longest)) if longest <= LONGEST.max(2.0 * step.abs()) => {
                    for ((slope, new), old) in walk.slope.iter_mut().zip(&angles).zip(&walk.angles)
                    {
                        *slope = (new - old) / step;
                    }
                    walk.angles = angles;
                    walk.value = value;
                    step *= 2.0;
                }
                _ if step.abs() > SHORTEST => step /= 2.0,
                _ => return false,
            }
        }
        true
    }

    /// The rank of the screws of the joints that are not driven.
    fn other_rank(&self, angles: &[f64], driven: usize) -> usize {
        let columns = self.jacobian(angles);
        if driven >= columns.ncols() {
            return 0;
        }
        rank(&columns.remove_column(driven).singular_values())
    }
}

/// Where a walk is, and how the angles go with the driven one.
struct Walk {
    angles: Vec<f64>,
    slope: Vec<f64>,
    value: f64,
}

/// Angles by whole turns from these, the nearest to the guess.
fn unwrapped(angles: &[f64], guess: &[f64], driven: usize, value: f64) -> Vec<f64> {
    let pairs = angles.iter().zip(guess).enumerate();
    pairs
        .map(|(joint, (angle, guess))| match joint == driven {
            true => value,
            false => angle + ((guess - angle) / TAU).round() * TAU,
        })
        .collect()
}
