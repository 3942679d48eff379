//! Sandwiches and versor application for every pair whose first type has one parity.

use ga::core::ops::*;
use ga::core::{Product, Rational, Unit};

use crate::kind::{Kind, free};
use crate::operation::{Binary, Pair, element, numbers};
use crate::polynomial::{has_norm, images, reversal};
use crate::reference::{Oracle, Value};
use crate::samples::{Form, Samples, unit_versors, versors};

/// From how many terms on the operation is not looked at as a polynomial: the generator then
/// gives all blades of the operand's grades, and so does the oracle.
const LARGEST_POLYNOMIAL: usize = 20_000;

/// The types of the sandwich and of the application; `None` where no type holds them.
fn result_kinds(oracle: &Oracle, versor: &Kind, operand: &Kind) -> Option<[Kind; 2]> {
    let terms = versor.blades().len().pow(2) * operand.blades().len();
    if terms <= LARGEST_POLYNOMIAL {
        let images = images(oracle, versor, operand)?;
        return Some([images.sandwich, images.applied]);
    }
    let wanted = |mask: &u32| operand.grades() >> mask.count_ones() & 1 == 1;
    let blades = (0..1 << oracle.dimension).filter(wanted).collect();
    free(oracle, &blades).map(|kind| [kind.clone(), kind.clone()])
}

/// The result has the operand's own type where that is expected, else as few fields.
fn compare_kinds(what: &str, operand: &Kind, result: &Kind, expected: Option<Kind>) {
    let expected = expected.unwrap_or_else(|| panic!("no type holds {what}"));
    match expected == *operand {
        true => assert_eq!(*result, expected, "type of {what}"),
        false => assert_eq!(
            result.stored.len(),
            expected.stored.len(),
            "fields of {what}"
        ),
    }
}

/// V x̂ W.
fn image(oracle: &Oracle, kind: &Kind, versor: &Value, x: &Value, right: &Value) -> Value {
    let odd = kind.is_odd();
    let reflected = oracle.signed(x, |mask| match odd && mask.count_ones() % 2 == 1 {
        true => -Rational::ONE,
        false => Rational::ONE,
    });
    let image = oracle.product(Product::Geometric, versor, &reflected);
    oracle.product(Product::Geometric, &image, right)
}

/// Compares V x̂ Ṽ on the grades of x, for unit types on unit versors and else on any values.
fn compare_sandwiches(oracle: &Oracle, [left, right, result]: [Kind; 3], compute: Binary) {
    let what = format!("{}.sandwich({})", left.name, right.name);
    assert!(left.is_pure(), "{} is no versor type", left.name);
    let expected = result_kinds(oracle, &left, &right).map(|[sandwich, _]| sandwich);
    compare_kinds(&what, &right, &result, expected);
    let mut samples = Samples::of(&left, &right);
    let mut list = versors(oracle, &left);
    if !oracle.units.contains(&left.name.as_str()) {
        for form in [Form::Fractions, Form::Sparse(4)] {
            list.push(samples.numbers(left.stored.len(), form));
        }
    }
    for v in list {
        let x = right.completed(samples.numbers(right.stored.len(), Form::Fractions));
        let (y, z) = (oracle.value_of(&left, &v), oracle.value_of(&right, &x));
        let reverse = oracle.signed(&y, reversal);
        let expected = image(oracle, &left, &y, &z, &reverse);
        let expected = oracle.restricted(&expected, right.grades());
        let generated = oracle.value_of(&result, &compute(&v, &x));
        oracle.same(&what, &[&y, &z], &generated, &expected);
    }
}

/// Compares V x̂ V⁻¹ on versors.
fn compare_applications(oracle: &Oracle, [left, right, result]: [Kind; 3], compute: Binary) {
    let what = format!("{}.apply({})", left.name, right.name);
    let expected = result_kinds(oracle, &left, &right).map(|[_, applied]| applied);
    compare_kinds(&what, &right, &result, expected);
    let mut samples = Samples::of(&left, &right);
    for v in versors(oracle, &left) {
        let x = right.completed(samples.numbers(right.stored.len(), Form::Fractions));
        let (y, z) = (oracle.value_of(&left, &v), oracle.value_of(&right, &x));
        let inverse = oracle.inverse(&y).expect("a versor");
        let expected = image(oracle, &left, &y, &z, &inverse);
        let generated = oracle.value_of(&result, &compute(&v, &x));
        oracle.same(&what, &[&y, &z], &generated, &expected);
    }
}

/// Compares V x̂ Ṽ of unit versors, which promise nothing by their type.
fn compare_units(oracle: &Oracle, [left, right, result]: [Kind; 3], compute: Binary) {
    let what = format!("Unit<{}>.apply({})", left.name, right.name);
    let mut samples = Samples::of(&left, &right);
    for v in unit_versors(oracle, &left) {
        let x = right.completed(samples.numbers(right.stored.len(), Form::Fractions));
        let (y, z) = (oracle.value_of(&left, &v), oracle.value_of(&right, &x));
        let reverse = oracle.signed(&y, reversal);
        let expected = image(oracle, &left, &y, &z, &reverse);
        let generated = oracle.value_of(&result, &compute(&v, &x));
        oracle.same(&what, &[&y, &z], &generated, &expected);
    }
}

impl<V, X, R> Pair<V, X>
where
    V: Element<Number = Rational> + Sandwich<X, Output = R>,
    X: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    pub fn sandwich(&self, oracle: &Oracle) {
        let kinds = [Kind::of::<V>(), Kind::of::<X>(), Kind::of::<R>()];
        compare_sandwiches(oracle, kinds, |v, x| {
            numbers(&element::<V>(v).sandwich(element::<X>(x)))
        });
    }
}

impl<V, X, R> Pair<V, X>
where
    V: Element<Number = Rational> + Apply<X, Output = R>,
    Unit<V>: Apply<X, Output = R>,
    X: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    pub fn apply(&self, oracle: &Oracle) {
        let kinds = || [Kind::of::<V>(), Kind::of::<X>(), Kind::of::<R>()];
        compare_applications(oracle, kinds(), |v, x| {
            numbers(&element::<V>(v).apply(element::<X>(x)))
        });
        compare_units(oracle, kinds(), |v, x| {
            let unit = Unit::promised(element::<V>(v));
            numbers(&Apply::apply(unit, element::<X>(x)))
        });
        oracle.applications.set(oracle.applications.get() + 1);
    }
}

impl<V, X, R> Pair<V, X>
where
    V: Element<Number = Rational> + Outermorphism<X, Image = R, Number = Rational>,
    V: Apply<X, Output = R>,
    X: Element<Number = Rational>,
    R: Element<Number = Rational>,
{
    /// The matrix does what the application does, alone and on slices of every length.
    pub fn matrix(&self, oracle: &Oracle) {
        let kinds = || [Kind::of::<V>(), Kind::of::<X>(), Kind::of::<R>()];
        compare_applications(oracle, kinds(), |v, x| {
            let map = ga::core::linear_map::linear_map::<V, X>(element(v));
            numbers(&map.apply(element(x)))
        });
        compare_units(oracle, kinds(), |v, x| {
            let map = Unit::promised(element::<V>(v)).linear_map::<X>();
            numbers(&map.apply(element(x)))
        });
        oracle.matrices.set(oracle.matrices.get() + 1);
    }
}

/// Whether a matrix is generated, the versor's own type decides.
pub trait NoMatrix {
    fn matrix(&self, _: &Oracle) {}
}

impl<V, X> NoMatrix for Pair<V, X> {}

/// What is not generated cannot exist.
pub trait NoVersor {
    fn sandwich(&self, oracle: &Oracle);
    fn apply(&self, oracle: &Oracle);
}

/// Whether the sandwich of a pair has a type.
fn has_sandwich(oracle: &Oracle, versor: &Kind, operand: &Kind) -> bool {
    versor.is_pure() && result_kinds(oracle, versor, operand).is_some()
}

impl<V: Element<Number = Rational>, X: Element<Number = Rational>> NoVersor for Pair<V, X> {
    fn sandwich(&self, oracle: &Oracle) {
        let (left, right) = (Kind::of::<V>(), Kind::of::<X>());
        let exists = has_sandwich(oracle, &left, &right);
        assert!(!exists, "{}.sandwich({})", left.name, right.name);
    }

    fn apply(&self, oracle: &Oracle) {
        let (left, right) = (Kind::of::<V>(), Kind::of::<X>());
        let exists = has_norm(oracle, &left) && has_sandwich(oracle, &left, &right);
        assert!(!exists, "{}.apply({})", left.name, right.name);
    }
}

/// Sandwich and application of a pair.
macro_rules! check_versors {
    ($oracle:ident, $module:ident, $V:ident, $X:ident) => {{
        type Q = ga::core::Rational;
        #[allow(unused_imports, reason = "used by pairs without versors")]
        use crate::versors::{NoMatrix, NoVersor};
        let pair = crate::operation::Pair::<$module::$V<Q>, $module::$X<Q>>::new();
        pair.sandwich($oracle);
        pair.apply($oracle);
        pair.matrix($oracle);
    }};
}
pub(crate) use check_versors;
