//! Exponentials, logarithms and square roots: closed forms where the square of the generator is a
//! scalar, the functions of commuting planes for other bivectors, a power series and iterated
//! roots for the rest.

mod commuting;
mod iterated;
mod motors;

use std::fmt::Write;

use ga_core::{Product, Rational};

use self::commuting::Planes;
use self::iterated::{iterated_functions, series_exponential};
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::{Cost, Kernel};
use crate::poly::{Element, Poly};

/// Emits `exp` of every type, `log` and `sqrt` of those of the form scalar plus bivector.
pub fn exponential(generator: &mut Generator<'_>, a: usize) {
    if generator.kind(a).has_fixed() {
        unipotent_functions(generator, a);
        if let Some(sum) = generator.sums[a] {
            let (name, wide) = (generator.name(a), generator.name(sum));
            let _ = writeln!(
                generator.source,
                "algebra::widened_exponential! {{ {name} => {wide} }}"
            );
        }
        return;
    }
    let element = generator.general[a][0].clone();
    let generator_part: Element = element
        .iter()
        .filter(|(mask, _)| **mask != 0)
        .map(|(m, p)| (*m, p.clone()))
        .collect();
    let square = generator
        .tables
        .product(Product::Geometric, &generator_part, &generator_part);
    let scalar_square = square.keys().all(|mask| *mask == 0);
    let poly = square.get(&0).cloned().unwrap_or_default();
    let has_scalar = generator.kind(a).slot(0).is_some();
    let bivector = generator_part.keys().all(|mask| mask.count_ones() == 2);
    if scalar_square {
        if has_scalar {
            series_exponential(generator, a);
        } else {
            closed_exponential(generator, a, &element, &poly);
        }
        if has_scalar && bivector && !generator_part.is_empty() {
            rotor_functions(generator, a, &generator_part, &poly);
        }
        return;
    }
    let planes = Planes::of(generator, a);
    match planes {
        Some(planes) if bivector && !has_scalar => planes.bivector_functions(generator, a),
        Some(planes) if has_scalar => {
            series_exponential(generator, a);
            planes.versor_functions(generator, a);
        }
        _ => {
            series_exponential(generator, a);
            if has_scalar {
                iterated_functions(generator, a);
            }
        }
    }
}

fn names<'a>(generator: &'a Generator<'_>, a: usize) -> Names<'a> {
    Names::new(generator.kind(a), None)
}

/// A square as an expression: a sum of negative terms as the opposite of a sum, which takes no
/// negation of a factor.
fn square_code(generator: &Generator<'_>, a: usize, square: &Poly) -> String {
    let names = names(generator, a);
    let zero = Rational::from_integer(0);
    match !square.is_zero() && square.terms().all(|(_, value)| *value < zero) {
        true => {
            let opposite = square.scaled(&Rational::from_integer(-1));
            format!("(-algebra::sum!({}))", expression::code(&opposite, &names))
        }
        false => format!("algebra::sum!({})", expression::code(square, &names)),
    }
}

/// `exp X = C(X²) + S(X²) X` (2.62).
fn closed_exponential(generator: &mut Generator<'_>, a: usize, element: &Element, square: &Poly) {
    let null = square.is_zero();
    let mut with_scalar = element.clone();
    if null {
        with_scalar.insert(0, Poly::constant(Rational::from_integer(1)));
    } else if let Some(first) = element.values().next() {
        // Any variable polynomial marks the scalar as free.
        with_scalar.insert(0, first.clone());
    }
    let Some(result) = closure::smallest(generator.model, &with_scalar) else {
        return;
    };
    let kind = generator.kind(result);
    let outputs = Kernel::expanded(generator.onto_fields(result, element));
    let fields: Vec<String> = kind
        .fields()
        .zip(&outputs.outputs)
        .map(|(slot, poly)| {
            let code = || expression::code(poly, &names(generator, a));
            let value = match (slot.mask, null) {
                (0, true) => "T::ONE".to_owned(),
                (0, false) => "c".to_owned(),
                _ if poly.is_zero() => "T::ZERO".to_owned(),
                (_, true) => code(),
                (_, false) => format!("{} * s", code()),
            };
            format!("{}: {value}", slot.field)
        })
        .collect();
    let (name, output) = (generator.name(a), generator.name(result));
    if null {
        let _ = writeln!(
            generator.source,
            "impl<T: Number> Exponential for {name}<T> {{ type Output = {output}<T>; \
             #[doc = \" The exponential `1 + X`, because `X² = 0`; no operations.\"] \
             #[inline] fn exp(self) -> {output}<T> {{ {output} {{ {} }} }} }}",
            fields.join(", ")
        );
        return;
    }
    let cost = Kernel::expanded(vec![square.clone()]).cost() + Cost::multiplying(fields.len() - 1);
    let text = format!(
        "impl<T: Real> Exponential for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The exponential `C(X²) + S(X²) X` (2.62), with `C(a) = cosh √a` and \
         `S(a) = sinh √a / √a` continued to negative `a`.{} One evaluation of both.\"] \
         #[inline] fn exp(self) -> {output}<T> {{ \
         let (c, s) = {}.cosh_sinhc(); {output} {{ {} }} }} }}\n",
        expression::cost_sentence(Some(cost)),
        square_code(generator, a, square),
        fields.join(", ")
    );
    generator.source.push_str(&text);
}

/// `log` and `sqrt` of `R = c + X` with a bivector `X` of scalar square.
fn rotor_functions(generator: &mut Generator<'_>, a: usize, part: &Element, square: &Poly) {
    let Some(result) = closure::smallest(generator.model, part) else {
        return;
    };
    let names = names(generator, a);
    let scale = |index: usize, element: &Element, scalar: &str| -> String {
        let kernel = Kernel::expanded(generator.onto_fields(index, element));
        let fields: Vec<String> = generator
            .kind(index)
            .fields()
            .zip(&kernel.outputs)
            .map(|(slot, poly)| {
                let value = if slot.mask == 0 {
                    scalar.to_owned()
                } else if poly.is_zero() {
                    "T::ZERO".to_owned()
                } else {
                    format!("{} * f", expression::code(poly, &names))
                };
                format!("{}: {value}", slot.field)
            })
            .collect();
        format!("{} {{ {} }}", generator.name(index), fields.join(", "))
    };
    let (name, output) = (generator.name(a), generator.name(result));
    let Some(scalar_slot) = generator.kind(a).slot(0) else {
        return;
    };
    let field = &scalar_slot.field;
    let fields = generator.kind(a).field_count();
    let cost = Kernel::expanded(vec![square.clone()]).cost() + Cost::multiplying(fields + 2);
    let sentence = expression::cost_sentence(Some(cost));
    let square = square_code(generator, a, square);
    let text = format!(
        "impl<T: Real> Logarithm for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The principal logarithm of the versor over its norm (2.68, 2.69 with the sign \
         of the scalar part respected); `None` where no real one exists or it is not unique.{sentence} \
         One evaluation of the angle over its sine, and where the norm is not 1, four divisions and a root.\"] \
         #[inline] fn log(self) -> ::core::option::Option<{output}<T>> {{ \
         let f = algebra::convert::logarithm_factor(self.{field}, {square})?; Some({}) }} \
         #[inline] fn log_of_unit(self) -> ::core::option::Option<{output}<T>> {{ \
         let f = self.{field}.log_factor({square})?; Some({}) }} }}\n\
         impl<T: Real> SquareRoot for {name}<T> {{ type Output = {name}<T>; \
         #[doc = \" The principal square root (2.37, 2.38), `(R + |R|) / √(2(⟨R⟩ + |R|))`; `None` \
         where no real one exists or it is not unique.{sentence} Two divisions and two roots.\"] \
         #[inline] fn sqrt(self) -> ::core::option::Option<{name}<T>> {{ \
         let (c, f) = algebra::convert::half(self.{field}, {square})?; Some({}) }} }}\n",
        scale(result, part, "T::ZERO"),
        scale(result, part, "T::ZERO"),
        scale(a, part, "c"),
    );
    generator.source.push_str(&text);
    let cost = Kernel::expanded(vec![super::norm_polynomial(generator, a)]).cost()
        + Cost::multiplying(fields);
    let doc = format!(
        " The versor over its norm; `None` where `X X̃` is no positive number.{} A division and a \
         root.",
        expression::cost_sentence(Some(cost))
    );
    let _ = writeln!(
        generator.source,
        "algebra::renormalization! {{ {name} {doc:?} }}"
    );
}

/// `log` and `sqrt` of `1 + X` with `X² = 0`: the scalar part is fixed, and both are exact.
fn unipotent_functions(generator: &mut Generator<'_>, a: usize) {
    let one = Rational::from_integer(1);
    let kind = generator.kind(a);
    let fixed_one = |slot: &crate::model::Slot| slot.mask == 0 && slot.fixed == Some(one);
    if !kind
        .slots
        .iter()
        .all(|slot| slot.fixed.is_none() || fixed_one(slot))
    {
        return;
    }
    let mut part = generator.general[a][0].clone();
    part.remove(&0);
    if !generator
        .tables
        .product(Product::Geometric, &part, &part)
        .is_empty()
    {
        return;
    }
    let Some(result) = closure::smallest(generator.model, &part) else {
        return;
    };
    let names = names(generator, a);
    let fields = |index: usize, factor: &str| -> String {
        generator
            .kind(index)
            .fields()
            .zip(generator.onto_fields(index, &part))
            .map(|(slot, poly)| match poly.is_zero() {
                true => format!("{}: T::ZERO", slot.field),
                false => format!(
                    "{}: {}{factor}",
                    slot.field,
                    expression::code(&poly, &names)
                ),
            })
            .collect::<Vec<_>>()
            .join(", ")
    };
    let (name, output) = (generator.name(a), generator.name(result));
    let text = format!(
        "impl<T: Number> Logarithm for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The logarithm of `1 + X` with `X² = 0` is `X`; it always exists. No operations.\"] \
         #[inline] fn log(self) -> ::core::option::Option<{output}<T>> {{ Some({output} {{ {} }}) }} }}\n\
         impl<T: Field> SquareRoot for {name}<T> {{ type Output = {name}<T>; \
         #[doc = \" The square root of `1 + X` with `X² = 0` is `1 + X/2`; it always exists. One multiplication per coefficient.\"] \
         #[inline] fn sqrt(self) -> ::core::option::Option<{name}<T>> {{ let f = T::from_ratio(1, 2); \
         Some({name} {{ {} }}) }} }}\n",
        fields(result, ""),
        fields(a, " * f"),
    );
    generator.source.push_str(&text);
}
