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
    /// [`LoopError::Open`] where the loop does not close from there, and those of
    /// [`frames`](ClosedLoop::frames).
    pub fn closed_near(
        &self,
        angles: &[f64],
        driven: usize,
        value: f64,
    ) -> Result<LoopState, LoopError> {
        self.check(angles)?;
        let mut angles = angles.to_vec();
        let slot = angles.get_mut(driven).ok_or(LoopError::Angles {
            given: driven + 1,
            joints: self.joints(),
        })?;
        *slot = value;
        self.check(&angles)?;
        let state = self.newton(angles, driven);
        match state.residual <= CLOSED {
            true => Ok(state),
            false => Err(LoopError::Open {
                joint: driven + 1,
                value,
                residual: state.residual,
            }),
        }
    }

    /// A configuration with one joint, counted from 0, at a given angle, looked for from angles all
    /// over their range, always the same ones.
    ///
    /// # Errors
    /// As [`closed_near`](ClosedLoop::closed_near), with the least that was missing.
    pub fn closed(&self, driven: usize, value: f64) -> Result<LoopState, LoopError> {
        let mut closest: Option<LoopError> = None;
        for number in 0..TRIES {
            let guess: Vec<f64> = (0..self.joints())
                .map(|joint| {
                    // An additive recurrence with a step of its own for each joint.
                    let step = (2.0 + joint as f64).sqrt().fract();
                    ((0.5 + (number + 1) as f64 * step).fract() - 0.5) * std::f64::consts::TAU
                })
                .collect();
            match self.closed_near(&guess, driven, value) {
                Err(LoopError::Open { residual, .. }) => {
                    let best = match closest {
                        Some(LoopError::Open { residual, .. }) => residual,
                        _ => f64::INFINITY,
                    };
                    if residual < best || closest.is_none() {
                        closest = Some(LoopError::Open {
                            joint: driven + 1,
                            value,
                            residual,
                        });
                    }
                }
                other => return other,
            }
        }
        Err(closest.unwrap_or(LoopError::FewLinks { given: 0 }))
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
