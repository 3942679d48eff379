//! Scalings about the origin.

use ga_core::{Field, Real};

use crate::cga3::Dilator;

impl<T: Real> Dilator<T> {
    /// The scaling about the origin by a factor, e^{−cE/2} with e^{−c} for the factor (2.4.4; the
    /// printed “dilation of amount c” scales by e^{−c}). A negative factor reflects in the origin
    /// too, which E itself does.
    ///
    /// The two coefficients differ by less and less the farther the factor is from 1: it is kept to
    /// within a few roundings times the factor or its inverse, the larger of the two (10⁻⁸ for a
    /// factor of 10⁸). `None` where nothing of it would be left, from 10¹⁶ and 10⁻¹⁶ on in
    /// double precision, and for a factor of zero or one that is not finite.
    ///
    /// ```
    /// use ga_cga::{Dilator, Point};
    ///
    /// let triple = Dilator::scaling(3.0).unwrap();
    /// let image = Point::at(1.0, -2.0, 0.5).image_under(triple).unwrap();
    /// assert!(image.distance(Point::at(3.0, -6.0, 1.5)) < 1e-15);
    /// ```
    pub fn scaling(factor: T) -> Option<Self> {
        // D scales n_∞ by s + e and n_o by s − e, so the factor is the ratio of the two; the root
        // makes their product one.
        let double_root = factor.abs().sqrt() * T::from_integer(2);
        let dilator = Dilator::new(
            (factor + T::ONE) / double_root,
            (factor - T::ONE) / double_root,
        );
        dilator.factor().filter(|f| f.is_finite()).map(|_| dilator)
    }

    /// The identity.
    pub fn identity() -> Self {
        Dilator::new(T::ONE, T::ZERO)
    }
}

impl<T: Field> Dilator<T> {
    /// The factor it scales by, negative if it reflects in the origin as well; `None` for a null
    /// versor, which maps all points to one.
    pub fn factor(self) -> Option<T> {
        let (kept, scaled) = (self.s - self.noni, self.s + self.noni);
        (kept.is_invertible() && scaled.is_invertible()).then(|| scaled / kept)
    }
}
