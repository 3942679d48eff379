//! Widening keeps every coefficient, narrowing undoes it and refuses what would be lost.

use ga::core::ops::Element;
use ga::core::{Narrowing, Rational};

use crate::kind::Kind;
use crate::operation::Pair;
use crate::reference::Oracle;
use crate::samples::Samples;

impl<A, B> Pair<A, B>
where
    A: Element<Number = Rational>,
    B: Element<Number = Rational> + From<A>,
{
    /// The wider value has the same coefficients.
    pub fn widen(&self, oracle: &Oracle) {
        let (from, into) = (Kind::of::<A>(), Kind::of::<B>());
        // Conversions that a crate writes for its own types mean what it says.
        if oracle.embeddings.contains(&(&from.name, &into.name)) {
            return;
        }
        assert!(into.holds_kind(&from), "{} is no {}", from.name, into.name);
        let a: A = Samples::new(31).full();
        let value = oracle.value(&a);
        oracle.same("widening", &[&value], &oracle.value(&B::from(a)), &value);
    }
}

/// No conversion is generated.
pub trait NoWidening {
    fn widen(&self, oracle: &Oracle);
}

impl<A: Element<Number = Rational>, B: Element<Number = Rational>> NoWidening for Pair<A, B> {
    fn widen(&self, _: &Oracle) {
        let (from, into) = (Kind::of::<A>(), Kind::of::<B>());
        assert!(
            !into.holds_kind(&from),
            "{} should be a {}",
            from.name,
            into.name
        );
    }
}

impl<A, B> Pair<A, B>
where
    A: Element<Number = f64> + TryFrom<B, Error = Narrowing>,
    B: Element<Number = f64> + From<A>,
{
    /// Narrowing gives back what was widened, and an error for everything else.
    pub fn narrow(&self) {
        let (narrow, wide) = (Kind::of::<A>(), Kind::of::<B>());
        let names = format!("{} from {}", narrow.name, wide.name);
        let mut samples = Samples::new(37);
        let numbers = (0..A::BLADES.len()).map(|_| samples.thousandth()).collect();
        let exact = narrow.completed(numbers);
        let a = A::from_fn(|i| *exact[i].numer() as f64 / *exact[i].denom() as f64);
        assert!(A::try_from(B::from(a)) == Ok(a), "{names}");
        for position in 0..B::BLADES.len() {
            let wider = B::from(a);
            let disturbed = |change: f64| {
                B::from_fn(|i| wider.at(i) + if i == position { change } else { 0.0 })
            };
            // Of a null type no single coefficient can be another one.
            let free = narrow.null.is_empty();
            let stored = free && narrow.stored.contains(&wide.stored[position]);
            assert_eq!(A::try_from(disturbed(0.5)).is_ok(), stored, "{names}");
            assert!(A::try_from(disturbed(1e-12)).is_ok(), "{names}");
            assert!(A::try_from(disturbed(f64::NAN)).is_err(), "{names}");
        }
    }
}

/// No narrowing is generated.
pub trait NoNarrowing {
    fn narrow(&self);
}

impl<A: Element<Number = f64>, B: Element<Number = f64>> NoNarrowing for Pair<A, B> {
    fn narrow(&self) {
        let (narrow, wide) = (Kind::of::<A>(), Kind::of::<B>());
        let strict = wide.holds_kind(&narrow) && !narrow.holds_kind(&wide);
        assert!(!strict, "{} should narrow from {}", narrow.name, wide.name);
    }
}

/// Conversions of a pair.
macro_rules! check_conversions {
    ($oracle:ident, $module:ident, $A:ident, $B:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without a conversion")]
        use crate::conversions::{NoNarrowing, NoWidening};
        let pair = crate::operation::Pair::<$module::$A<Q>, $module::$B<Q>>::new();
        pair.widen($oracle);
        crate::operation::Pair::<$module::$A<f64>, $module::$B<f64>>::new().narrow();
    }};
}
pub(crate) use check_conversions;

/// Coefficients by bitmask, whatever the order of display.
macro_rules! check_masks {
    ($oracle:ident, $module:ident) => {{
        type M = $module::Multivector<ga::core::Rational>;
        let m: M = crate::samples::Samples::new(41).full();
        assert_eq!(m.to_masks().to_vec(), $oracle.value(&m));
        assert_eq!(M::from_masks(m.to_masks()), m);
    }};
}
pub(crate) use check_masks;
