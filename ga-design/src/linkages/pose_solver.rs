//! Joint values for a pose: damped least squares on the screws of a chain, started again and
//! again until a try ends inside the limits.
//!
//! Every step solves `(J Jᵀ + λ) y = e`, `q += Jᵀ y`: e is the displacement and the rotation vector
//! from the tool to the target, along the target's axes, and the columns of J are the screws of the
//! joints there. The damping λ follows the error, which is robust where the arm is singular or the
//! target out of reach (Sugihara 2011). Values at a limit that would leave it are held there.
//! The tries begin where it is asked, then at points of a sequence that fills the ranges evenly
//! and is always the same: the same question has the same answer.

mod damped;
mod seeds;

use super::{Chain, ChainError, Frame, Miss, Target};
use damped::Descent;
use seeds::Seeds;

/// How a pose is looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseSolver {
    /// The distance up to which a pose is reached.
    pub position_tolerance: f64,
    /// The angle in radians up to which a pose is reached.
    pub rotation_tolerance: f64,
    /// How many steps one try may take.
    pub steps: usize,
    /// How many tries there may be, the first one included.
    pub tries: usize,
}

/// What was found: the values, and how near they come.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The joint values, inside the limits.
    pub values: Vec<f64>,
    /// Whether both errors are within the tolerances.
    pub converged: bool,
    /// How far the pose of these values is from the target, computed anew from them.
    pub miss: Miss,
    /// The steps of all tries together.
    pub iterations: usize,
    /// How many tries were made.
    pub tries: usize,
}

impl Default for PoseSolver {
    /// Tolerances of 1e-8 lengths and radians, 100 tries of 40 steps.
    fn default() -> Self {
        PoseSolver {
            position_tolerance: 1e-8,
            rotation_tolerance: 1e-8,
            steps: 40,
            tries: 100,
        }
    }
}

impl PoseSolver {
    /// Joint values that take the tool to a target, started from `seed` or, without one, from the
    /// middle of the ranges. Where no try succeeds the closest pose found is told, with
    /// `converged` false.
    ///
    /// ```
    /// use ga_cga::Point;
    /// use ga_design::linkages::{Chain, Frame, Joint, JointKind, Link, PoseSolver, Target};
    ///
    /// let hinge = || Joint { kind: JointKind::Revolute, limits: Vec::new() };
    /// let link = Link { length: 1.0, skew: 0.0, offset: 0.0 }.motion();
    /// let arm = Chain::new("arm", Frame::world())
    ///     .with("shoulder", [Frame::world().motor(), link], hinge())
    ///     .with("elbow", [Frame::world().motor(), link], hinge());
    /// let target = Target::position(Point::at(1.2, 0.5, 0.0)).unwrap();
    /// let solution = PoseSolver::default().solve(&arm, &target, None)?;
    /// assert!(solution.converged);
    /// let tip = arm.pose(&solution.values)?.origin();
    /// assert!(tip.distance(Point::at(1.2, 0.5, 0.0)) < 1e-8);
    /// # Ok::<(), ga_design::linkages::ChainError>(())
    /// ```
    ///
    /// # Errors
    /// [`ChainError`] for a seed of the wrong number of values.
    pub fn solve(
        &self,
        chain: &Chain,
        target: &Target,
        seed: Option<&[f64]>,
    ) -> Result<Solution, ChainError> {
        let mut found = self.solutions(chain, target, seed, 1)?;
        Ok(found.swap_remove(0))
    }

    /// Up to so many different solutions, in the order found; where there is none, one that has
    /// not converged. Two are the same if no joint value differs by more than a thousandth.
    ///
    /// # Errors
    /// As [`solve`](PoseSolver::solve).
    pub fn solutions(
        &self,
        chain: &Chain,
        target: &Target,
        seed: Option<&[f64]>,
        most: usize,
    ) -> Result<Vec<Solution>, ChainError> {
        let middle: Vec<f64> = chain
            .values()
            .iter()
            .map(|joint| joint.limits.middle())
            .collect();
        let seed = seed.unwrap_or(&middle);
        chain.check(seed)?;
        let mut descent = Descent::new(chain, target);
        let mut seeds = Seeds::new(chain);
        let mut found: Vec<Solution> = Vec::new();
        let mut closest: Option<Solution> = None;
        let mut iterations = 0;
        let mut values = seed.to_vec();
        for tries in 1..=self.tries.max(1) {
            descent.start(&values);
            iterations += descent.run(self);
            let solution = self.judged(chain, target, descent.values(), iterations, tries)?;
            match solution.converged {
                true if found.iter().all(|other| other.is_other_than(&solution)) => {
                    found.push(solution);
                    if found.len() >= most {
                        return Ok(found);
                    }
                }
                true => {}
                false => {
                    let best = closest.as_ref().map_or(f64::INFINITY, Solution::size);
                    if solution.size() < best || closest.is_none() {
                        closest = Some(solution);
                    }
                }
            }
            values = seeds.next_values();
        }
        match (found.is_empty(), closest) {
            (true, Some(closest)) => Ok(vec![Solution {
                iterations,
                tries: self.tries.max(1),
                ..closest
            }]),
            _ => Ok(found),
        }
    }

    /// Values with what they reach, found by way of the chain itself.
    fn judged(
        &self,
        chain: &Chain,
        target: &Target,
        values: &[f64],
        iterations: usize,
        tries: usize,
    ) -> Result<Solution, ChainError> {
        let pose: Frame = chain.pose(values)?;
        let miss = target.miss(pose);
        let inside = values.iter().zip(chain.values());
        let inside = inside.fold(true, |all, (x, joint)| all && joint.limits.contains(*x));
        Ok(Solution {
            values: values.to_vec(),
            converged: inside
                && miss.position <= self.position_tolerance
                && miss.rotation <= self.rotation_tolerance,
            miss,
            iterations,
            tries,
        })
    }
}

impl Solution {
    fn is_other_than(&self, other: &Solution) -> bool {
        let pairs = self.values.iter().zip(&other.values);
        pairs.fold(false, |any, (a, b)| any || (a - b).abs() > 1e-3)
    }

    /// What solutions are compared by.
    fn size(&self) -> f64 {
        self.miss.position + self.miss.rotation
    }
}
