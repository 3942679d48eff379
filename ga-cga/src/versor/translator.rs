//! Translations.

use ga_core::Field;

use crate::cga3::{DirectionVector, Point, Translator, Vector3};

impl<T: Field> Translator<T> {
    /// The translation by a vector, 1 − ½**v** n_∞ = e^{−**v** n_∞/2}.
    ///
    /// ```
    /// use ga_cga::{Point, Translator, Vector3};
    ///
    /// let shift = Translator::by(Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(shift.apply(Point::at(1.0, 1.0, 1.0)), Point::at(2.0, 3.0, 4.0));
    /// ```
    pub fn by(vector: Vector3<T>) -> Self {
        (DirectionVector::from(vector.to_array()) * -T::from_ratio(1, 2)).exp()
    }

    /// The translation that takes one point to another.
    pub fn between(from: Point<T>, to: Point<T>) -> Self {
        Translator::by(to.position() - from.position())
    }

    /// The identity.
    pub fn identity() -> Self {
        Translator::by(Vector3::default())
    }

    /// The vector it translates by.
    pub fn vector(self) -> Vector3<T> {
        Vector3::new(self.e1ni, self.e2ni, self.e3ni) * -T::from_integer(2)
    }
}
