//! Exponentials and logarithms where outer squares of bivectors square to zero, as those of motors
//! do: functions of dual numbers, each in one straight body.

use std::fmt::Write;

use ga_core::{Product, Rational};

use super::commuting::{Planes, part};
use super::square_code;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::{Cost, TEMPORARY};
use crate::poly::{Element, Monomial, Poly, Variable};

/// The temporary of this number as a polynomial.
fn temporary(number: usize) -> Poly {
    let variable = Variable {
        operand: TEMPORARY,
        slot: number as u16,
    };
    Poly::term(Monomial::of(variable), Rational::from_integer(1))
}

/// A polynomial times a temporary.
fn times(poly: &Poly, number: usize) -> Poly {
    let mut product = Poly::default();
    product.add_product(poly, &temporary(number), &Rational::from_integer(1));
    product
}

/// The product V A of a four-vector and a bivector that commute.
fn turned(generator: &Generator<'_>, fourth: &Element, bivector: &Element) -> Element {
    let product = generator.tables.product(Product::Inner, fourth, bivector);
    part(&product, 2)
}

/// Fields with their values as a struct.
fn literal(generator: &Generator<'_>, kind: usize, element: &Element, names: &Names<'_>) -> String {
    let values = generator.onto_fields(kind, element);
    let fields = generator.kind(kind).fields().zip(&values);
    let fields: Vec<String> = fields
        .map(|(slot, poly)| format!("{}: {}", slot.field, expression::code(poly, names)))
        .collect();
    format!("{} {{ {} }}", generator.name(kind), fields.join(", "))
}

fn cost<'p>(polys: impl IntoIterator<Item = &'p Poly>) -> Cost {
    polys
        .into_iter()
        .map(Cost::of)
        .fold(Cost::default(), |sum, cost| sum + cost)
}

/// The exponential `C(a + W) + S(a + W) B` with `W² = 0`: C(a) + S(a) H + (S(a) + 2S′(a) H) B,
/// where H = W/2.
pub fn exponential(generator: &mut Generator<'_>, a: usize, planes: &Planes) {
    let bivector = &generator.general[a][0];
    let product = |product| generator.tables.product(product, bivector, bivector);
    let square = product(Product::ScalarProduct);
    let square = square.get(&0).cloned().unwrap_or_default();
    let half = Rational::new(1, 2);
    let halves = product(Product::Wedge);
    let halves: Vec<(u32, Poly)> = halves
        .iter()
        .map(|(mask, poly)| (*mask, poly.scaled(&half)))
        .collect();
    // t0 = C, t1 = S, t2 = S′, then H and 2S′ H, blade by blade.
    let own = |index: usize| 3 + 2 * index;
    let mut slopes = Element::new();
    let mut result: Element = bivector
        .iter()
        .map(|(mask, poly)| (*mask, times(poly, 1)))
        .collect();
    result.insert(0, temporary(0));
    for (index, (mask, _)) in halves.iter().enumerate() {
        slopes.insert(*mask, temporary(own(index) + 1));
        result.insert(*mask, times(&temporary(own(index)), 1));
    }
    for (mask, poly) in turned(generator, &slopes, bivector) {
        let sum = result.entry(mask).or_default();
        sum.add_scaled(&poly, &Rational::from_integer(1));
    }
    let kind = generator.kind(a);
    let names = Names::new(kind, None);
    let mut temporaries = String::new();
    for (index, (_, poly)) in halves.iter().enumerate() {
        let (half, slope) = (own(index), own(index) + 1);
        let code = expression::code(poly, &names);
        let _ = write!(
            temporaries,
            "let t{half} = {code}; let t{slope} = (t2 + t2) * t{half}; "
        );
    }
    let doubled = Cost::of(&times(&temporary(2), 0))
        + Cost::of(&temporary(2).scaled(&Rational::from_integer(2)));
    let total = halves
        .iter()
        .fold(cost([&square]) + cost(result.values()), |sum, (_, poly)| {
            sum + Cost::of(poly) + doubled
        });
    let (name, output) = (generator.name(a), generator.name(planes.versor));
    let text = format!(
        "impl<T: Real> Exponential for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The exponential `C(B²) + S(B²) B` (2.62) with the Study number `B² = a + W` of which \
         `W² = 0`, `t0 = C(a) = cosh √a`, `t1 = S(a) = sinh √a / √a` and `t2 = S′(a)`.{} One evaluation \
         of the three.\"] \
         #[inline(always)] fn exp(self) -> {output}<T> {{ algebra::kernel! {{ \
         let [t0, t1, t2] = <[T; 3]>::from({}.cosh_sinhc_slope()); \
         {temporaries} return {} }} }} }}\n",
        expression::cost_sentence(Some(total)),
        square_code(generator, a, &square),
        literal(generator, planes.versor, &result, &names),
    );
    generator.source.push_str(&text);
}

/// The logarithm of a versor that is promised to be a unit one: f(c) A + f′(c) V A.
pub fn logarithm_of_unit(generator: &Generator<'_>, a: usize, planes: &Planes) -> String {
    let versor = &generator.general[a][0];
    let (bivector, fourth) = (part(versor, 2), part(versor, 4));
    let square = generator
        .tables
        .product(Product::ScalarProduct, &bivector, &bivector);
    let square = square.get(&0).cloned().unwrap_or_default();
    // t0 = f, t1 = f′, then f′ V, blade by blade.
    let mut slopes = Element::new();
    for (index, mask) in fourth.keys().enumerate() {
        slopes.insert(*mask, temporary(2 + index));
    }
    let mut result: Element = bivector
        .iter()
        .map(|(mask, poly)| (*mask, times(poly, 0)))
        .collect();
    for (mask, poly) in turned(generator, &slopes, &bivector) {
        let sum = result.entry(mask).or_default();
        sum.add_scaled(&poly, &Rational::from_integer(1));
    }
    let names = Names::new(generator.kind(a), None);
    let mut temporaries = String::new();
    for (index, poly) in fourth.values().enumerate() {
        let (number, code) = (2 + index, expression::code(&times(poly, 1), &names));
        let _ = write!(temporaries, "let t{number} = {code}; ");
    }
    let scalar = expression::code(&versor.get(&0).cloned().unwrap_or_default(), &names);
    format!(
        "match algebra::algorithm::motor_factor({scalar}, {}, algebra::sum!({})) {{ \
         Some((t0, t1)) => Some({{ algebra::kernel! {{ {temporaries} return {} }} }}), \
         None => algebra::algorithm::motor_logarithm_apart::<T, _, {}<T>, {}<T>>(self) }}",
        expression::code(&square, &names),
        expression::code(
            &unbounded(&square, bivector.values().chain(fourth.values())),
            &names
        ),
        literal(generator, planes.bivector, &result, &names),
        generator.name(planes.bivector),
        generator.name(planes.fourth),
    )
}

/// The sum of the squares of those coefficients that a number near −1 or 0 in place of this square
/// leaves open: where it is a sum of negative squares, it bounds what it is made of.
fn unbounded<'p>(square: &Poly, coefficients: impl Iterator<Item = &'p Poly>) -> Poly {
    let is_square = |monomial: &Monomial| {
        let mut variables = monomial.variables();
        variables.next() == variables.next()
    };
    let zero = Rational::from_integer(0);
    let definite = square
        .terms()
        .all(|(monomial, value)| is_square(monomial) && *value < zero);
    let mut sum = Poly::default();
    for poly in coefficients {
        let mut own = Poly::default();
        own.add_product(poly, poly, &Rational::from_integer(1));
        let bounded = definite
            && own
                .terms()
                .all(|(monomial, _)| square.coefficient(monomial) < zero);
        if !bounded {
            sum.add_scaled(&own, &Rational::from_integer(1));
        }
    }
    sum
}
