//! What the promise that an element is null saves: a coefficient that the others determine, and
//! the sandwich as the square of a spinor.

use std::collections::{BTreeMap, HashMap};

use ga_core::{Product, Rational};
use num_traits::{One, Signed, Zero};

use super::kernels::temporary;
use crate::emit::Generator;
use crate::emit::versors::reversed;
use crate::factor::Kernel;
use crate::poly::{Element, Monomial, Poly, Variable, graded_signs, sum};

/// The coefficients of a null operand that the others determine: the slot, and its value. In
/// `x² = 0` such a one stands alone with a constant factor.
fn determined(generator: &Generator<'_>, x: usize) -> Vec<(u16, Poly)> {
    let operand = &generator.general[x][1];
    if !generator.kind(x).null {
        return Vec::new();
    }
    let square = generator
        .tables
        .product(Product::Geometric, operand, operand);
    let mut found = Vec::new();
    for form in square.values() {
        for (monomial, factor) in form.terms().filter(|(monomial, _)| monomial.degree() == 1) {
            let times = |other: &Monomial| {
                let shared = |v: Variable| monomial.variables().any(|own| own == v);
                other.variables().any(shared)
            };
            if form.terms().filter(|(other, _)| times(other)).count() > 1 {
                continue;
            }
            let mut value = Poly::default();
            for (other, own) in form.terms().filter(|(other, _)| !times(other)) {
                value.add_term(*other, -*own / *factor);
            }
            found.extend(monomial.variables().map(|v| (v.slot, value.clone())));
        }
    }
    found
}

/// The kernel of an application to a null type, whose image is null: a coefficient that the others
/// determine is computed from them, where that is cheaper.
pub fn eliminated(generator: &Generator<'_>, x: usize, kernel: Kernel) -> Kernel {
    let candidates = determined(generator, x).into_iter();
    let shorter =
        candidates.filter_map(|(slot, value)| eliminate(generator, x, &kernel, slot, &value));
    let cheapest = shorter.min_by_key(Kernel::cost);
    match cheapest.filter(|cheapest| cheapest.cost() < kernel.cost()) {
        Some(cheapest) => cheapest,
        None => kernel,
    }
}

fn eliminate(
    generator: &Generator<'_>,
    x: usize,
    kernel: &Kernel,
    slot: u16,
    value: &Poly,
) -> Option<Kernel> {
    let slots = &generator.kind(x).slots;
    let fields = slots.iter().enumerate();
    let fields: Vec<usize> = fields
        .filter(|(_, slot)| slot.fixed.is_none())
        .map(|(place, _)| place)
        .collect();
    let field = |slot: u16| fields.iter().position(|place| *place == usize::from(slot));
    let own = field(slot)?;
    let mut kernel = kernel.clone();
    kernel.outputs[own] = Poly::default();
    let mut kernel = kernel.without_unused();
    let mut image = HashMap::new();
    for variable in value.terms().flat_map(|(monomial, _)| monomial.variables()) {
        let place = field(variable.slot)?;
        image.entry(variable).or_insert_with(|| {
            let name = temporary(kernel.temporaries.len());
            let output = std::mem::take(&mut kernel.outputs[place]);
            kernel.temporaries.push(output);
            kernel.outputs[place] = Poly::term(Monomial::of(name), Rational::one());
            name
        });
    }
    kernel.outputs[own] = value.renamed(|v| image.get(&v).copied().unwrap_or(v));
    kernel.form = "x + (V x − x V) V⁻¹ with x² = 0".into();
    Some(kernel)
}

/// A spinor `s` of a null vector type: linear in the coefficients, and `x = f s m s̃` for a null
/// vector `m` and a number `f`.
struct Spinor {
    spinor: Element,
    vector: Element,
    factor: Rational,
}

/// The spinor `s = T n`, where the type has a fixed coefficient on the null vector `n`: the
/// translation `T = 1 + Σ xᵢ eᵢ m / (2 m·n)` takes `n` to `x`, which is verified.
fn spinor(generator: &Generator<'_>, x: usize) -> Option<Spinor> {
    let (kind, metric) = (generator.kind(x), &generator.model.metric);
    let operand = &generator.general[x][1];
    if !kind.null || kind.grades() != 0b10 {
        return None;
    }
    let one = Rational::one();
    let vector = |mask: u32| Element::from([(mask, Poly::constant(one))]);
    let product = |a: &Element, b: &Element| generator.tables.product(Product::Geometric, a, b);
    let index = |mask: u32| mask.trailing_zeros() as usize;
    let is_null = |mask: u32| metric.gram(index(mask), index(mask)).is_zero();
    for fixed in kind
        .slots
        .iter()
        .filter(|slot| slot.fixed.is_some() && is_null(slot.mask))
    {
        let weight = operand.get(&fixed.mask).and_then(Poly::as_constant)?;
        for (slot, value) in determined(generator, x) {
            let m = kind.slots[usize::from(slot)].mask;
            let inner = metric.gram(index(fixed.mask), index(m));
            if !is_null(m) || inner.is_zero() {
                continue;
            }
            // T n, of which the first term is n with its weight.
            let double = inner * Rational::from_integer(2);
            let mut spinor = vector(fixed.mask);
            spinor.insert(fixed.mask, Poly::constant(weight));
            for (mask, coefficient) in operand.iter().filter(|(mask, _)| **mask != m) {
                if *mask == fixed.mask {
                    continue;
                }
                let direction = Element::from([(*mask, coefficient.scaled(&(one / double)))]);
                let turned = product(&product(&direction, &vector(m)), &vector(fixed.mask));
                spinor = sum(&spinor, &turned, 1);
            }
            let factor = one / (weight * double);
            let image = product(&product(&spinor, &vector(m)), &reversed(&spinor));
            let sign = Rational::from_integer(i128::from(kind.slots[usize::from(slot)].sign));
            let mut expected = operand.clone();
            expected.insert(m, value.scaled(&sign));
            let expected = expected
                .into_iter()
                .map(|(mask, poly)| (mask, poly.scaled(&(one / factor))));
            if sum(&image, &expected.collect(), -1).is_empty() {
                let vector = vector(m);
                return Some(Spinor {
                    spinor,
                    vector,
                    factor,
                });
            }
        }
    }
    None
}

/// The sandwich of a null vector as the square of a spinor: of `x = f s m s̃` the image is
/// `f (V s) m (V s)~`, where only what survives in `V s` is computed.
pub fn squared(
    generator: &Generator<'_>,
    [v, x]: [usize; 2],
    even: bool,
    result: usize,
) -> Option<Kernel> {
    let Spinor {
        spinor,
        vector,
        factor,
    } = spinor(generator, x)?;
    let product = |a: &Element, b: &Element| generator.tables.product(Product::Geometric, a, b);
    let mut temporaries = Vec::new();
    let spinor = distinct(&spinor, &mut temporaries);
    let moved = product(&generator.general[v][0], &spinor);
    let moved = collected(&moved, &mut temporaries);
    let moved = distinct(&moved, &mut temporaries);
    let image = product(&product(&moved, &vector), &reversed(&moved));
    // x̂ = −x is what odd versors apply to.
    let signed = graded_signs(&image, |_| if even { 1 } else { -1 });
    let scaled = signed
        .into_iter()
        .map(|(mask, poly)| (mask, poly.scaled(&factor)));
    let kernel = Kernel {
        temporaries,
        outputs: generator.onto_fields(result, &scaled.collect()),
        form: "s m s̃ with x = s₀ m s̃₀ and s = V s₀".into(),
    };
    Some(kernel.without_unused())
}

/// The element with the sums of coefficients of the versor by which the same coefficient of the
/// operand is multiplied in temporaries, each sum once.
fn collected(element: &Element, temporaries: &mut Vec<Poly>) -> Element {
    let mut known = HashMap::new();
    let collected = element.iter().map(|(mask, poly)| {
        let mut factors: BTreeMap<Monomial, Poly> = BTreeMap::new();
        for (monomial, value) in poly.terms() {
            let (mut own, mut rest) = (Monomial::ONE, Monomial::ONE);
            for variable in monomial.variables() {
                let part = if variable.operand == 0 {
                    &mut own
                } else {
                    &mut rest
                };
                *part = part.times(&Monomial::of(variable));
            }
            factors.entry(rest).or_default().add_term(own, *value);
        }
        let mut result = Poly::default();
        for (rest, factor) in factors {
            let term = Poly::term(rest, Rational::one());
            let first = factor.terms().next().map(|(_, first)| *first);
            let factor = match first.filter(|_| factor.len() > 1 && rest.degree() > 0) {
                Some(scale) => multiple_of_temporary(&factor, scale, &mut known, temporaries),
                None => factor,
            };
            result.add_product(&factor, &term, &Rational::one());
        }
        (*mask, result)
    });
    collected.collect()
}

/// A polynomial as this multiple of a temporary, which is new unless it is known already.
fn multiple_of_temporary(
    poly: &Poly,
    scale: Rational,
    known: &mut HashMap<Poly, usize>,
    temporaries: &mut Vec<Poly>,
) -> Poly {
    let normal = poly.scaled(&(Rational::one() / scale));
    let number = *known.entry(normal.clone()).or_insert_with(|| {
        temporaries.push(normal);
        temporaries.len() - 1
    });
    Poly::term(Monomial::of(temporary(number)), scale)
}

/// The element in temporaries, of which one serves all coefficients that differ by a factor;
/// constants and single coefficients stay.
fn distinct(element: &Element, temporaries: &mut Vec<Poly>) -> Element {
    let mut known = HashMap::new();
    let named = element.iter().map(|(mask, poly)| {
        let Some((monomial, first)) = poly.terms().next() else {
            return (*mask, poly.clone());
        };
        let single = poly.len() == 1 && monomial.degree() <= 1;
        let plain = single && (first.abs().is_one() || monomial.degree() == 0);
        if plain {
            return (*mask, poly.clone());
        }
        // A multiple of one coefficient is named as large as it is.
        let scale = if single { first.signum() } else { *first };
        let name = multiple_of_temporary(poly, scale, &mut known, temporaries);
        (*mask, name)
    });
    named.collect()
}
