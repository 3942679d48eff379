//! Exponentials, logarithms and square roots where the square of the generator is a scalar;
//! exponentials of everything else by scaling and squaring.

use std::fmt::Write;

use ga_core::Product;

use super::inverse::parity_type;
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::Kernel;
use crate::poly::{Element, Poly};

/// Emits `exp` of every type, `log` and `sqrt` of those of the form scalar plus bivector.
pub fn exponential(generator: &mut Generator<'_>, a: usize) {
    if generator.kind(a).has_fixed() {
        // A fixed coefficient is neither a generator nor a rotor of every size.
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
    if scalar_square && !has_scalar {
        closed_exponential(generator, a, &element, &poly);
    } else {
        series_exponential(generator, a);
    }
    let bivector = generator_part.keys().all(|mask| mask.count_ones() == 2);
    if scalar_square && has_scalar && bivector && !generator_part.is_empty() {
        rotor_functions(generator, a, &generator_part, &poly);
    }
}

fn names<'a>(generator: &'a Generator<'_>, a: usize) -> Names<'a> {
    Names::new(generator.kind(a), None)
}

fn square_code(generator: &Generator<'_>, a: usize, square: &Poly) -> String {
    expression::code(square, &names(generator, a))
}

/// `exp X = C(X²) + S(X²) X` (2.62).
fn closed_exponential(generator: &mut Generator<'_>, a: usize, element: &Element, square: &Poly) {
    let mut with_scalar = element.clone();
    // Any variable polynomial marks the scalar as free.
    if let Some(first) = element.values().next() {
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
            let value = if slot.mask == 0 {
                "c".to_owned()
            } else if poly.is_zero() {
                "T::ZERO".to_owned()
            } else {
                format!("{} * s", expression::code(poly, &names(generator, a)))
            };
            format!("{}: {value}", slot.field)
        })
        .collect();
    let (name, output) = (generator.name(a), generator.name(result));
    let text = format!(
        "impl<T: Real> Exponential for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The exponential `C(X²) + S(X²) X` (2.62), with `C(a) = cosh √a` and \
         `S(a) = sinh √a / √a` continued to negative `a`.\"] \
         #[inline] fn exp(self) -> {output}<T> {{ \
         let (c, s) = ({}).cosh_sinhc(); {output} {{ {} }} }} }}\n",
        square_code(generator, a, square),
        fields.join(", ")
    );
    generator.source.push_str(&text);
}

/// The exponential as a power series on the smallest complete type.
fn series_exponential(generator: &mut Generator<'_>, a: usize) {
    let Some(result) = parity_type(generator, a) else {
        return;
    };
    // Powers of an odd element are odd and even, so only even elements stay in `Even`.
    let odd = generator.kind(a).parity() == Some(false);
    let whole = generator.model.type_named("Multivector").filter(|_| odd);
    let result = whole.unwrap_or(result);
    if !generator.model.products.contains(&Product::Geometric) {
        return;
    }
    let (name, output) = (generator.name(a), generator.name(result));
    let _ = writeln!(
        generator.source,
        "algebra::series_exponential! {{ {name} => {output} }}"
    );
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
    let square = square_code(generator, a, square);
    let text = format!(
        "impl<T: Real> Logarithm for {name}<T> {{ type Output = {output}<T>; \
         #[doc = \" The principal logarithm of the versor over its norm (2.68, 2.69 with the sign \
         of the scalar part respected); `None` where no real one exists or it is not unique.\"] \
         #[inline] fn log(self) -> Option<{output}<T>> {{ \
         let (r, square) = algebra::convert::polar(self.{field}, {square})?; \
         let f = (self.{field} / r).log_factor(square / (r * r))? / r; Some({}) }} }}\n\
         impl<T: Real> SquareRoot for {name}<T> {{ type Output = {name}<T>; \
         #[doc = \" The principal square root (2.37, 2.38), `(R + |R|) / √(2(⟨R⟩ + |R|))`; `None` \
         where no real one exists or it is not unique.\"] \
         #[inline] fn sqrt(self) -> Option<{name}<T>> {{ \
         let (c, f) = algebra::convert::half(self.{field}, {square})?; Some({}) }} }}\n",
        scale(result, part, "T::ZERO"),
        scale(a, part, "c"),
    );
    generator.source.push_str(&text);
}
