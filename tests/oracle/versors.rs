//! Sandwiches and versor application for every pair whose first type has one parity.

use ga::core::ops::*;
use ga::core::{Product, Rational};

use crate::kind::{Kind, has_norm};
use crate::products::Pair;
use crate::reference::{Oracle, Value};
use crate::samples::{Samples, versors};

/// V x̂ Ṽ on the grades of `x`'s type.
fn reference(oracle: &Oracle, versor: &Value, x: &Value, operand: &Kind) -> Value {
    let dense = oracle.dense(versor);
    let odd = dense
        .terms()
        .iter()
        .any(|(blade, _)| blade.grade() % 2 == 1);
    let operand_value = oracle.dense(x);
    let reflected = if odd {
        operand_value.involute()
    } else {
        operand_value
    };
    let reverse = dense.reverse().coefficients().to_vec();
    let image = oracle.product(
        Product::Geometric,
        versor,
        &reflected.coefficients().to_vec(),
    );
    let image = oracle.product(Product::Geometric, &image, &reverse);
    oracle.restricted(&image, operand.grades())
}

/// Whether no coefficient vanishes, so that the image has all coefficients that it can have.
fn is_full<V: Element<Number = Rational>>(v: &V) -> bool {
    (0..V::BLADES.len()).all(|i| v.at(i) != Rational::ZERO)
}

impl<V, X, R> Pair<V, X>
where
    V: Element<Number = Rational> + Sandwich<X, Output = R>,
    X: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// Compares the sandwich, for unit types on unit versors and else on any values.
    pub fn sandwich(&self, oracle: &Oracle) {
        let (left, right, result) = (Kind::of::<V>(), Kind::of::<X>(), Kind::of::<R>());
        assert!(left.is_pure(), "{} is no versor type", left.name);
        let what = format!("{}.sandwich({})", left.name, right.name);
        let mut samples = Samples::new(left.stored.len() as u64 * 7 + right.stored.len() as u64);
        let unit = oracle.units.contains(&left.name.as_str());
        let mut list: Vec<V> = versors(oracle);
        if !unit {
            list.extend([samples.full::<V>(), samples.sparse(4)]);
        }
        // The operand's own type is left only where it does not hold the image.
        let mut fits = list.iter().any(is_full);
        for v in list {
            let x: X = samples.full();
            let (y, z) = (oracle.value(&v), oracle.value(&x));
            let expected = reference(oracle, &y, &z, &right);
            fits &= oracle.element::<X>(&expected).is_some();
            oracle.same(&what, &[&y, &z], &oracle.value(&v.sandwich(x)), &expected);
        }
        assert!(
            !fits || result == right || unit,
            "{what} leaves the operand's type"
        );
    }
}

impl<V, X, R> Pair<V, X>
where
    V: Element<Number = Rational> + Apply<X, Output = R> + Sandwich<X>,
    X: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// Compares V x̂ V⁻¹ on versors with the dense algebra.
    pub fn apply(&self, oracle: &Oracle) {
        let (left, right, result) = (Kind::of::<V>(), Kind::of::<X>(), Kind::of::<R>());
        let what = format!("{}.apply({})", left.name, right.name);
        let mut samples = Samples::new(left.stored.len() as u64 * 5 + right.stored.len() as u64);
        let list: Vec<V> = versors(oracle);
        let mut fits = list.iter().any(is_full);
        for v in list {
            let x: X = samples.full();
            let (y, z) = (oracle.value(&v), oracle.value(&x));
            let image = oracle.dense(&y).apply(&oracle.dense(&z)).expect("a versor");
            let expected = image.coefficients().to_vec();
            fits &= oracle.element::<X>(&expected).is_some();
            oracle.same(&what, &[&y, &z], &oracle.value(&v.apply(x)), &expected);
        }
        assert!(!fits || result == right, "{what} leaves the operand's type");
    }
}

/// What is not generated must not be expected.
pub trait NoVersor {
    fn sandwich(&self, oracle: &Oracle);
    fn apply(&self, oracle: &Oracle);
}

impl<V: Element<Number = Rational>, X: Element<Number = Rational>> NoVersor for Pair<V, X> {
    fn sandwich(&self, oracle: &Oracle) {
        let kind = Kind::of::<V>();
        assert!(
            oracle.dimension > 8 || !kind.is_pure(),
            "{} has no sandwich",
            kind.name
        );
    }

    fn apply(&self, oracle: &Oracle) {
        let kind = Kind::of::<V>();
        let invertible = kind.is_pure() && has_norm(oracle, &kind);
        assert!(
            oracle.dimension > 8 || !invertible,
            "{} has no apply",
            kind.name
        );
    }
}

/// Sandwich and application of a pair.
macro_rules! check_versors {
    ($oracle:ident, $module:ident, $V:ident, $X:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports)]
        use crate::versors::NoVersor;
        let pair = crate::products::Pair::<$module::$V<Q>, $module::$X<Q>>::new();
        pair.sandwich($oracle);
        pair.apply($oracle);
    }};
}
pub(crate) use check_versors;
