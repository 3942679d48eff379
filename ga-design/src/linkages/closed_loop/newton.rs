//! Closing a loop: Newton's method on the screws of the joints that are not driven.

use nalgebra::{DMatrix, DVector};

use super::{CLOSED, ClosedLoop, LoopError, LoopState, RANK, rank};

/// Steps of one try.
const STEPS: usize = 60;
/// Tries from different angles.
const TRIES: usize = 400;
/// How far a step may turn a joint.
const LONGEST: f64 = 0.6;

impl ClosedLoop {
    /// The configuration near these angles with one joint, counted from 0, at a given angle.
    ///
    /// # Errors
    /// [`LoopError::Open`] where the loop does not close from there, [`LoopError::Joint`], and those
    /// of [`frames`](ClosedLoop::frames).
    pub fn closed_near(
        &self,
        angles: &[f64],
        driven: usize,
        value: f64,
    ) -> Result<LoopState, LoopError> {
        self.check_joint(driven)?;
        let mut angles = angles.to_vec();
        if let Some(angle) = angles.get_mut(driven) {
            *angle = value;
        }
        self.check(&angles)?;
        closed(self.newton(angles, driven), driven, value)
    }

    /// A configuration with one joint, counted from 0, at a given angle, looked for from angles all
    /// over their range, always the same ones.
    ///
    /// # Errors
    /// As [`closed_near`](ClosedLoop::closed_near), with the least that was missing.
    pub fn closed(&self, driven: usize, value: f64) -> Result<LoopState, LoopError> {
        self.check_joint(driven)?;
        let guess = |number: usize| -> Vec<f64> {
            let part = |joint: usize| {
                // An additive recurrence with a step of its own for each joint.
                let step = (2.0 + joint as f64).sqrt().fract();
                (0.5 + number as f64 * step).fract() - 0.5
            };
            let angle = |joint: usize| match joint == driven {
                true => value,
                false => part(joint) * std::f64::consts::TAU,
            };
            (0..self.joints()).map(angle).collect()
        };
        self.check(&guess(0))?;
        let mut closest = self.newton(guess(0), driven);
        for number in 1..TRIES {
            if closest.residual <= CLOSED {
                break;
            }
            let state = self.newton(guess(number), driven);
            if state.residual < closest.residual {
                closest = state;
            }
        }
        closed(closest, driven, value)
    }

    /// Steps of least squares, of least length where there are several.
    fn newton(&self, mut angles: Vec<f64>, driven: usize) -> LoopState {
        let mut best = self.judged(&angles);
        for _ in 0..STEPS {
            if best.residual <= 0.1 * CLOSED {
                break;
            }
            let gap = DVector::from_column_slice(&self.gap(self.walk(&angles).1));
            let mut columns = self.jacobian(&angles);
            if let Some(mut column) = (driven < columns.ncols()).then(|| columns.column_mut(driven))
            {
                column.fill(0.0);
            }
            let Some(change) = least_squares(columns, &gap) else {
                break;
            };
            let longest = change.amax();
            let scale = if longest > LONGEST {
                LONGEST / longest
            } else {
                1.0
            };
            for (angle, change) in angles.iter_mut().zip(change.iter()) {
                *angle -= scale * change;
            }
            let state = self.judged(&angles);
            if state.residual < best.residual {
                best = state;
            }
        }
        best
    }
}

/// A state that is closed.
fn closed(state: LoopState, driven: usize, value: f64) -> Result<LoopState, LoopError> {
    match state.residual <= CLOSED {
        true => Ok(state),
        false => Err(LoopError::Open {
            joint: driven + 1,
            value,
            residual: state.residual,
        }),
    }
}

/// The shortest x with least |A x − b|; none where the decomposition does not converge.
fn least_squares(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let decomposition = matrix.try_svd(true, true, f64::EPSILON, 1000)?;
    let values = &decomposition.singular_values;
    let largest = values.iter().copied().fold(0.0, f64::max);
    if rank(values) == 0 {
        return None;
    }
    decomposition.solve(right, RANK * largest).ok()
}
