//! One try: steps of damped least squares from given joint values.

use ga_cga::{DualLine, Motor, Vector3};
use ga_core::Unit;

use super::PoseSolver;
use crate::linkages::{Chain, Coupling, Frame, Freedom, Limits, Target};

/// The damping against the squared error.
const DAMPING: f64 = 0.5;

/// The damping that is left at the target, against the scale of the matrix, which is of order 1.
const LEAST_DAMPING: f64 = 1e-12;

/// A try that takes off less than this part of the error in [`PATIENCE`] steps has stalled.
const PROGRESS: f64 = 0.05;
const PATIENCE: usize = 8;

/// One freedom: what comes before it, and what drives it.
struct Movement {
    before: Unit<Motor>,
    freedom: Freedom,
    screw: DualLine,
    coupling: Coupling,
}

/// The descent of one chain towards one target.
pub struct Descent {
    target: Target,
    rows: [bool; 6],
    movements: Vec<Movement>,
    tool: Unit<Motor>,
    limits: Vec<Limits>,
    /// A length of the size of the arm, by which positions are divided.
    reach: f64,
    values: Vec<f64>,
    /// For each joint value, how the tool moves with it: displacement over reach, and rotation.
    columns: Vec<[f64; 6]>,
}

impl Descent {
    pub fn new(chain: &Chain, target: &Target) -> Self {
        // Everything is told in the target's frame.
        let mut before = target.frame.motion_to(chain.base());
        let mut movements = Vec::new();
        let mut reach = 0.0;
        for segment in chain.segments() {
            reach += length(segment.before) + length(segment.after);
            before = before * segment.before;
            for (freedom, coupling) in segment.freedoms() {
                movements.push(Movement {
                    before,
                    freedom,
                    screw: freedom.screw(),
                    coupling: *coupling,
                });
                before = Unit::promised(Motor::identity());
            }
            before = before * segment.after;
        }
        let tool = before * chain.tool();
        reach += length(chain.tool());
        let limits: Vec<Limits> = chain.values().iter().map(|joint| joint.limits).collect();
        Descent {
            target: *target,
            rows: target.rows(),
            movements,
            tool,
            reach: if reach > 0.0 { reach } else { 1.0 },
            values: vec![0.0; limits.len()],
            columns: vec![[0.0; 6]; limits.len()],
            limits,
        }
    }

    /// Begins at these values, or the nearest inside the limits.
    pub fn start(&mut self, values: &[f64]) {
        for ((own, value), limits) in self.values.iter_mut().zip(values).zip(&self.limits) {
            *own = limits.nearest(*value);
        }
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Steps until the tolerances are met or no more is gained, and says how many.
    pub fn run(&mut self, solver: &PoseSolver) -> usize {
        let mut watched = f64::INFINITY;
        for step in 0..solver.steps {
            let [position, rotation] = self.look();
            let is_near = position.norm() <= 0.5 * solver.position_tolerance;
            if is_near && rotation.norm() <= 0.5 * solver.rotation_tolerance {
                return step;
            }
            let error = self.scaled(position, rotation);
            let size: f64 = error.iter().map(|x| x * x).sum();
            if step % PATIENCE == PATIENCE - 1 {
                if size > watched * (1.0 - PROGRESS) {
                    return step;
                }
                watched = size;
            }
            self.step(error, size);
        }
        solver.steps
    }

    /// Finds the columns for the present values, and gives the error.
    fn look(&mut self) -> [Vector3; 2] {
        self.columns.fill([0.0; 6]);
        let mut motor = Unit::promised(Motor::identity());
        let mut screws = Vec::with_capacity(self.movements.len());
        for movement in &self.movements {
            motor = motor * movement.before;
            screws.push(motor.apply(movement.screw));
            motor = motor * movement.freedom.motion(movement.coupling.of(&self.values));
        }
        let pose = Frame::promised(motor * self.tool);
        let tip = pose.origin().position();
        for (screw, movement) in screws.into_iter().zip(&self.movements) {
            let Some(column) = self.columns.get_mut(movement.coupling.value) else {
                continue;
            };
            // How the screw B + d n∞ moves the tip x, d + x ⌋ B, and the axis it turns about.
            let [xy, xz, yz, dx, dy, dz] = screw.to_array();
            let [x, y, z] = tip.to_array();
            let ratio = movement.coupling.ratio;
            let moved = [
                dx - xy * y - xz * z,
                dy + xy * x - yz * z,
                dz + xz * x + yz * y,
            ];
            let turned = [yz, -xz, xy];
            for (place, part) in column
                .iter_mut()
                .zip(moved.into_iter().map(|x| x / self.reach).chain(turned))
            {
                *place += ratio * part;
            }
        }
        self.target.error(pose)
    }

    /// The error with positions over reach.
    fn scaled(&self, position: Vector3, rotation: Vector3) -> [f64; 6] {
        let ([x, y, z], [rx, ry, rz]) = ((position / self.reach).to_array(), rotation.to_array());
        [x, y, z, rx, ry, rz]
    }

    /// One step; values that it would take out of their limits stop there, and those that stand
    /// at a limit and would leave it take no part.
    fn step(&mut self, error: [f64; 6], size: f64) {
        let damping = DAMPING * size + LEAST_DAMPING;
        let mut held = vec![false; self.values.len()];
        for _ in 0..=self.values.len() {
            let change = self.change(error, damping, &held);
            let mut is_new = false;
            for (((held, value), limits), change) in held
                .iter_mut()
                .zip(&self.values)
                .zip(&self.limits)
                .zip(&change)
            {
                let leaves = (*value <= limits.lower && *change < 0.0)
                    || (*value >= limits.upper && *change > 0.0);
                if leaves && !*held {
                    *held = true;
                    is_new = true;
                }
            }
            if !is_new {
                for ((value, limits), change) in
                    self.values.iter_mut().zip(&self.limits).zip(change)
                {
                    *value = limits.nearest(*value + change);
                }
                return;
            }
        }
    }

    /// Jᵀ (J Jᵀ + λ)⁻¹ e over the joints that are not held.
    fn change(&self, error: [f64; 6], damping: f64, held: &[bool]) -> Vec<f64> {
        let mut matrix = [[0.0; 6]; 6];
        let free = self.columns.iter().zip(held).filter(|(_, held)| !**held);
        for (column, _) in free {
            for (row, a) in matrix.iter_mut().zip(column) {
                for (entry, b) in row.iter_mut().zip(column) {
                    *entry += a * b;
                }
            }
        }
        for (number, (row, counts)) in matrix.iter_mut().zip(self.rows).enumerate() {
            if !counts {
                row.fill(0.0);
            }
            for (entry, counts) in row.iter_mut().zip(self.rows) {
                if !counts {
                    *entry = 0.0;
                }
            }
            if let Some(diagonal) = row.get_mut(number) {
                *diagonal += if counts { damping } else { 1.0 };
            }
        }
        let solved = solve(matrix, error);
        let change = self
            .columns
            .iter()
            .zip(held)
            .map(|(column, held)| match held {
                true => 0.0,
                false => column.iter().zip(solved).map(|(a, b)| a * b).sum(),
            });
        change.collect()
    }
}

/// How far a motion takes the origin.
fn length(motion: Unit<Motor>) -> f64 {
    Frame::promised(motion).origin().position().norm()
}

/// The solution of a symmetric positive definite system, by Cholesky's factors; zero where
/// rounding has made it neither.
fn solve(matrix: [[f64; 6]; 6], right: [f64; 6]) -> [f64; 6] {
    nalgebra::Matrix6::from(matrix)
        .cholesky()
        .map_or([0.0; 6], |factors| {
            factors.solve(&nalgebra::Vector6::from(right)).into()
        })
}
