//! Whether a separation is that of something slower than light, of light, or of nothing that
//! moves.

use ga_core::Field;

use super::Vector;

/// The kind of a vector of spacetime, which all observers agree on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Character {
    /// Something slower than light is at both ends, first at the tail.
    Future,
    /// Something slower than light is at both ends, first at the tip.
    Past,
    /// Light passes both ends.
    Lightlike,
    /// Nothing can be at both ends; for some observers they are simultaneous.
    Spacelike,
    /// Both ends are the same event.
    Zero,
}

impl<T: Field + PartialOrd> Vector<T> {
    /// The kind of this vector, by the exact sign of its square; `None` where that is no
    /// number.
    ///
    /// ```
    /// use ga_spaces::spacetime::{Character, Vector};
    ///
    /// assert_eq!(Vector::new(5.0, 3.0, 0.0, 4.0).character(), Some(Character::Lightlike));
    /// assert_eq!(Vector::new(-2.0, 1.0, 0.0, 0.0).character(), Some(Character::Past));
    /// assert_eq!(Vector::new(f64::NAN, 1.0, 0.0, 0.0).character(), None);
    /// ```
    pub fn character(self) -> Option<Character> {
        let square = self.norm_squared();
        if self == Vector::default() {
            Some(Character::Zero)
        } else if square > T::ZERO && self.t > T::ZERO {
            Some(Character::Future)
        } else if square > T::ZERO {
            Some(Character::Past)
        } else if square < T::ZERO {
            Some(Character::Spacelike)
        } else {
            (square == T::ZERO).then_some(Character::Lightlike)
        }
    }
}
