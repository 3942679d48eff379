//! R2,4, conformal spacetime: events, light cones and the transformations that keep them.
//!
//! Spacetime has the signature (1, 3), time squares to 1, as in `spacetime`;
//! n_o and n_∞ add (1, 1). An event is the null vector n_o + **x** + ½**x**² n_∞, and the inner
//! product of two events is −½ of the interval between them: zero exactly where light connects
//! them. So the light cone of an event is the event itself, read as an equation. Versors keep
//! inner products zero: besides Poincaré's transformations they are the scalings, inversion and
//! the special conformal transformations, which map light to light.
//!
//! ```
//! use ga_spaces::conformal_spacetime::{Event, Transversor, Vector4};
//!
//! let here = Event::at(0.0_f64, 0.0, 0.0, 0.0);
//! let there = Event::at(5.0, 3.0, 4.0, 0.0);
//! assert_eq!(here.interval(there), 0.0);
//!
//! let bend = Transversor::by(Vector4::new(0.0, 0.5, 0.0, 0.0));
//! let (here, there) = (bend.apply(here).center().unwrap(), bend.apply(there).center().unwrap());
//! assert!(here.interval(there).abs() < 1e-13);
//! ```
//!
//! Sources: Lasenby, *Conformal models of de Sitter space, initial conditions for inflation and
//! the CMB* (2003); Doran and Lasenby, *Geometric Algebra for Physicists* (2003), §10.7.

use ga_core::{Field, Real};

ga_macros::define_algebra! {
    mod algebra: R2_4 {
        basis { t, x, y, z, no, ni }
        metric { t^2 = 1, x^2 = -1, y^2 = -1, z^2 = -1, no.ni = -1 }
        types {
            /// A vector of spacetime.
            Vector4 { t, x, y, z }
            /// A bivector of spacetime: the generator of a Lorentz transformation.
            Bivector4 { x^t, y^t, z^t, x^y, x^z, y^z }
            /// An event of weight 1; read as an equation, its light cone.
            #[null]
            Event { no = 1, t, x, y, z, ni }
            /// Any vector: an event with a weight; a hyperboloid of the events at one interval
            /// from a centre; a hyperplane where the weight is zero. Its versor is the
            /// reflection in it.
            Hyperboloid { no, t, x, y, z, ni }
            /// A pair of events and any other bivector.
            Bivector = grade 2;
            /// A translation, of unit norm.
            #[unit]
            Translator { 1 = 1, t^ni, x^ni, y^ni, z^ni }
            /// A special conformal transformation, of unit norm: a translation between two
            /// inversions.
            #[unit]
            Transversor { 1 = 1, t^no, x^no, y^no, z^no }
            /// A Lorentz transformation that keeps the origin.
            Lorentz { 1, x^t, y^t, z^t, x^y, x^z, y^z, t^x^y^z }
            /// A scaling about the origin.
            Dilator { 1, no^ni }
        }
        products { geometric, wedge, scalar_product, sandwich }
    }
}

pub use algebra::*;

impl<T: Field> Event<T> {
    /// The event with these coordinates.
    pub fn at(t: T, x: T, y: T, z: T) -> Self {
        Event::from(Vector4::new(t, x, y, z))
    }

    /// The place in spacetime relative to the origin.
    pub fn position(self) -> Vector4<T> {
        Vector4::new(self.t, self.x, self.y, self.z)
    }

    /// The interval to another event, −2 p·q: positive where something slower than light can
    /// be at both, zero where light is, negative where nothing is.
    pub fn interval(self, other: Self) -> T {
        self.scalar_product(other) * T::from_integer(-2)
    }
}

impl<T: Field> From<Vector4<T>> for Event<T> {
    /// The event n_o + **x** + ½**x**² n_∞.
    fn from(place: Vector4<T>) -> Self {
        let [t, x, y, z] = place.to_array();
        let ni = place.norm_squared() * T::from_ratio(1, 2);
        Event { t, x, y, z, ni }
    }
}

impl<T: Field> Hyperboloid<T> {
    /// The events at a squared interval from a centre, p − ½s² n_∞; its light cone where the
    /// interval is zero.
    pub fn about(center: Event<T>, interval: T) -> Self {
        let mut hyperboloid = Hyperboloid::from(center);
        hyperboloid.ni -= interval * T::from_ratio(1, 2);
        hyperboloid
    }

    /// The centre, which for the image of an event is the event; `None` for a hyperplane or n_∞,
    /// which have none. A transformation that moves events to infinity does so with the whole
    /// light cone of one event.
    pub fn center(self) -> Option<Event<T>> {
        let [weight, t, x, y, z, _] = self.to_array();
        weight
            .is_invertible()
            .then(|| Event::at(t / weight, x / weight, y / weight, z / weight))
    }

    /// The squared interval of its events from the centre; `None` for a hyperplane or n_∞.
    pub fn interval(self) -> Option<T> {
        let square = self.no * self.no;
        square.is_invertible().then(|| self.norm_squared() / square)
    }
}

impl<T: Field> Translator<T> {
    /// The translation by a vector, 1 − ½**v** n_∞.
    pub fn by(v: Vector4<T>) -> Self {
        let [t, x, y, z] = (v * T::from_ratio(-1, 2)).to_array();
        Translator::new(t, x, y, z)
    }
}

impl<T: Field> Transversor<T> {
    /// The special conformal transformation x ↦ (x + x²**b**)/(1 + 2 **b**·x + **b**²x²),
    /// 1 − **b** n_o: inversion, translation by **b**, inversion.
    pub fn by(b: Vector4<T>) -> Self {
        let [t, x, y, z] = (-b).to_array();
        Transversor::new(t, x, y, z)
    }
}

impl<T: Real> Lorentz<T> {
    /// The exponential of a bivector of spacetime, e^{B/2}: a boost by the size of a bivector
    /// with t, a rotation by that of one without.
    pub fn from_generator(generator: Bivector4<T>) -> Self {
        ga_core::convert::pick((generator * T::from_ratio(1, 2)).exp())
    }
}
