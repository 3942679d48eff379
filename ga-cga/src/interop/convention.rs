//! Which rotor a quaternion is, and which motor a dual quaternion.

use ga_core::Scalar;

use crate::cga3::{Motor, Rotor};

impl<T: Scalar> Rotor<T> {
    /// The rotor of the quaternion w + x i + y j + z k.
    ///
    /// ```
    /// use ga_cga::{Rotor, Vector3};
    ///
    /// // k turns half-way about z.
    /// let half_turn = Rotor::from_quaternion([0.0, 0.0, 0.0, 1.0]);
    /// let image = half_turn.apply(Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(image, Vector3::new(-1.0, -2.0, 3.0));
    /// assert_eq!(half_turn.to_quaternion(), [0.0, 0.0, 0.0, 1.0]);
    /// ```
    pub fn from_quaternion([w, x, y, z]: [T; 4]) -> Self {
        Rotor {
            s: w,
            e12: -z,
            e13: y,
            e23: -x,
        }
    }

    /// The quaternion w, x, y, z of the rotor.
    pub fn to_quaternion(self) -> [T; 4] {
        [self.s, -self.e23, self.e13, -self.e12]
    }
}

impl<T: Scalar> Motor<T> {
    /// The motor of the dual quaternion q + ε p, each part as w, x, y, z.
    ///
    /// ε is −**I**₃ n_∞, so that the translation by v is 1 + ½ ε v in dual quaternions as well,
    /// and q + ½ ε v q turns by q first.
    ///
    /// ```
    /// use ga_cga::{Motor, Translator, Vector3};
    ///
    /// let shift = Motor::from_dual_quaternion([[1.0, 0.0, 0.0, 0.0], [0.0, 0.5, 1.0, 1.5]]);
    /// assert_eq!(shift, Motor::from(Translator::by(Vector3::new(1.0, 2.0, 3.0))));
    /// ```
    pub fn from_dual_quaternion([real, [w, x, y, z]]: [[T; 4]; 2]) -> Self {
        Motor {
            e123ni: -w,
            e1ni: -x,
            e2ni: -y,
            e3ni: -z,
            ..Motor::from(Rotor::from_quaternion(real))
        }
    }

    /// The dual quaternion q + ε p of the motor, each part as w, x, y, z.
    pub fn to_dual_quaternion(self) -> [[T; 4]; 2] {
        let real = Rotor::new(self.s, self.e12, self.e13, self.e23);
        [
            real.to_quaternion(),
            [-self.e123ni, -self.e1ni, -self.e2ni, -self.e3ni],
        ]
    }
}
