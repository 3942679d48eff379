//! Polynomials as Rust expressions and as formulas for people.

use std::fmt::Write;

use ga_core::Rational;
use num_traits::{One, Signed, ToPrimitive};

use crate::factor::{Cost, Kernel, MULTIPLE};
use crate::model::Type;
use crate::poly::{Monomial, Poly, Variable};

/// How the operands of a kernel are called.
#[derive(Clone)]
pub struct Names<'a> {
    /// The types of `self`, of the argument, and of the multiple `w` of a versor.
    pub operands: [Option<&'a Type>; 3],
    /// The name of the argument, `b` or `x`.
    pub argument: &'static str,
    /// Which operands are taken apart into one variable per field, `a_e1`, at the start.
    unpacked: [bool; 3],
    /// The constants that have names.
    constants: Vec<Rational>,
}

/// The operands that [`Names`] names, in its order.
const NAMED: [u8; 3] = [0, 1, MULTIPLE];

impl<'a> Names<'a> {
    /// Operands `self` and, where there is one, an argument of this name.
    pub fn new(receiver: &'a Type, argument: Option<(&'static str, &'a Type)>) -> Self {
        let name = argument.map_or("b", |(name, _)| name);
        let operands = [Some(receiver), argument.map(|(_, kind)| kind), None];
        Names {
            operands,
            argument: name,
            unpacked: [false; 3],
            constants: Vec::new(),
        }
    }

    /// The same with the multiple `w` of a versor.
    pub fn with_multiple(mut self, kind: &'a Type) -> Self {
        self.operands[2] = Some(kind);
        self
    }
}

impl Names<'_> {
    fn field(&self, variable: Variable) -> Option<&str> {
        let place = NAMED.iter().position(|own| *own == variable.operand)?;
        let kind = self.operands[place]?;
        kind.slots
            .get(usize::from(variable.slot))
            .map(|slot| slot.field.as_str())
    }

    fn code(&self, variable: Variable) -> String {
        match (variable.operand, self.field(variable)) {
            (0, Some(field)) if self.unpacked[0] => format!("a_{field}"),
            (0, Some(field)) => format!("self.{field}"),
            (1, Some(field)) if self.unpacked[1] => format!("{}_{field}", self.argument),
            (1, Some(field)) => format!("{}.{field}", self.argument),
            (MULTIPLE, Some(field)) if self.unpacked[2] => format!("w_{field}"),
            (MULTIPLE, Some(field)) => format!("w.{field}"),
            _ => format!("t{}", variable.slot),
        }
    }

    fn formula(&self, variable: Variable) -> String {
        match (variable.operand, self.field(variable)) {
            (0, Some(field)) => format!("a.{field}"),
            (1, Some(field)) => format!("{}.{field}", self.argument),
            (MULTIPLE, Some(field)) => format!("w.{field}"),
            _ => format!("t{}", variable.slot),
        }
    }
}

/// Whether every coefficient is an integer, so that a ring is enough.
pub fn is_integral(kernel: &Kernel) -> bool {
    kernel
        .polynomials()
        .flat_map(Poly::terms)
        .all(|(_, value)| value.is_integer())
}

/// Whether every coefficient fits the numbers that generated code can name.
pub fn fits(kernel: &Kernel) -> bool {
    kernel
        .polynomials()
        .flat_map(Poly::terms)
        .all(|(_, value)| value.numer().to_i64().is_some() && value.denom().to_i64().is_some())
}

/// A positive number as an expression.
fn number(value: &Rational) -> String {
    if value.is_one() {
        "T::ONE".to_owned()
    } else if value.is_integer() {
        format!("T::from_integer({})", value.numer())
    } else {
        format!("T::from_ratio({}, {})", value.numer(), value.denom())
    }
}

/// What a constant is called where it has a name.
fn constant_name(value: &Rational) -> String {
    match (value.numer(), value.denom()) {
        (2, 1) => "two".to_owned(),
        (1, 2) => "half".to_owned(),
        (numerator, 1) => format!("c{numerator}"),
        (numerator, denominator) => format!("c{numerator}_{denominator}"),
    }
}

/// A term: its variables, the absolute value of its coefficient, and whether it is subtracted.
type Term = (Monomial, Rational, bool);

/// The terms in the order in which they are added: what is no product opens the sum, then come
/// the products, each of which is one fused operation; in both, what is subtracted stands last.
///
/// So a chain of fused operations begins with values that are ready, a leading sign is rare, and
/// the order does not depend on the target.
fn ordered(poly: &Poly) -> [Vec<Term>; 2] {
    let mut parts = [Vec::new(), Vec::new()];
    for (monomial, value) in poly.terms() {
        let part = usize::from(is_product(monomial, value));
        parts[part].push((*monomial, value.abs(), value.is_negative()));
    }
    for part in &mut parts {
        part.sort_by_key(|(_, _, negative)| *negative);
    }
    parts
}

/// Whether evaluating a term takes a multiplication.
fn is_product(monomial: &Monomial, value: &Rational) -> bool {
    monomial.degree() > 1 || (monomial.degree() == 1 && !value.abs().is_one())
}

/// A polynomial as a Rust expression: a sum of products of two factors, at most opened by a sum in
/// parentheses, which is what `ga_core::kernel!` reads.
pub fn code(poly: &Poly, names: &Names<'_>) -> String {
    let [plain, products] = ordered(poly);
    let mut text = String::new();
    for (monomial, factor, negative) in &plain {
        sign(&mut text, *negative);
        text.push_str(&factors(monomial, factor, names).join(" * "));
    }
    let is_variable = |(monomial, _, negative): &Term| monomial.degree() == 1 && !negative;
    if !products.is_empty() && (plain.len() > 1 || !plain.iter().all(is_variable)) {
        text = format!("({text})");
    }
    for (monomial, factor, negative) in &products {
        let mut factors = factors(monomial, factor, names);
        if text.is_empty() && *negative {
            factors[0] = format!("(-{})", factors[0]);
        } else {
            sign(&mut text, *negative);
        }
        let last = factors.pop().unwrap_or_default();
        match factors.as_slice() {
            [] => text.push_str(&last),
            [first] => {
                let _ = write!(text, "{first} * {last}");
            }
            _ => {
                let _ = write!(text, "({}) * {last}", factors.join(" * "));
            }
        }
    }
    if text.is_empty() {
        "T::ZERO".to_owned()
    } else {
        text
    }
}

/// The value of a field or a temporary as `ga_core::kernel!` reads it: what is neither a variable
/// nor a constant of the numbers nor a sum of products stands in parentheses.
fn value(poly: &Poly, names: &Names<'_>) -> String {
    let text = code(poly, names);
    let fused = poly
        .terms()
        .any(|(monomial, value)| is_product(monomial, value));
    let simple =
        |(monomial, value): (&Monomial, &Rational)| monomial.degree() <= 1 && value.is_one();
    if fused || (poly.len() <= 1 && poly.terms().all(simple)) {
        text
    } else {
        format!("({text})")
    }
}

fn sign(text: &mut String, negative: bool) {
    match (text.is_empty(), negative) {
        (true, true) => text.push('-'),
        (true, false) => {}
        (false, true) => text.push_str(" - "),
        (false, false) => text.push_str(" + "),
    }
}

/// The factors of a term, a constant first.
fn factors(monomial: &Monomial, factor: &Rational, names: &Names<'_>) -> Vec<String> {
    let mut factors = Vec::new();
    if !factor.is_one() || monomial.degree() == 0 {
        factors.push(match names.constants.contains(factor) {
            true => constant_name(factor),
            false => number(factor),
        });
    }
    factors.extend(monomial.variables().map(|v| names.code(v)));
    factors
}

/// A polynomial as a formula, `a.e1 b.e2 − a.e2 b.e1`.
pub fn formula(poly: &Poly, names: &Names<'_>) -> String {
    let mut text = String::new();
    for (monomial, factor, negative) in ordered(poly).into_iter().flatten() {
        match (text.is_empty(), negative) {
            (true, true) => text.push('−'),
            (true, false) => {}
            (false, true) => text.push_str(" − "),
            (false, false) => text.push_str(" + "),
        }
        let mut words: Vec<String> = monomial.variables().map(|v| names.formula(v)).collect();
        if !factor.is_one() || words.is_empty() {
            words.insert(0, crate::blades::rational_text(&factor));
        }
        text.push_str(&words.join(" "));
    }
    if text.is_empty() {
        "0".to_owned()
    } else {
        text
    }
}

/// The documentation of a kernel: its cost, then a line per temporary and per field.
pub fn documentation(
    summary: &str,
    kernel: &Kernel,
    result: Option<&Type>,
    names: &Names<'_>,
) -> String {
    documentation_at(summary, kernel.cost(), kernel, result, names)
}

/// The documentation of a kernel whose values another function computes, at this cost.
pub fn documentation_at(
    summary: &str,
    cost: Cost,
    kernel: &Kernel,
    result: Option<&Type>,
    names: &Names<'_>,
) -> String {
    let mut text = format!(" {summary} Cost: {}.\n\n ```text\n", counts(cost));
    for (i, poly) in kernel.temporaries.iter().enumerate() {
        let _ = writeln!(text, " t{i} = {}", formula(poly, names));
    }
    match result {
        Some(kind) => {
            for (slot, poly) in kind.fields().zip(&kernel.outputs) {
                let _ = writeln!(text, " {} = {}", slot.field, formula(poly, names));
            }
        }
        None => {
            for poly in &kernel.outputs {
                let _ = writeln!(text, " {}", formula(poly, names));
            }
        }
    }
    text.push_str(" ```");
    text
}

/// The operation counts of a function that is composed of others, as a sentence.
pub fn cost_sentence(cost: Option<Cost>) -> String {
    cost.map_or_else(String::new, |cost| {
        format!(" Cost: at most {}.", counts(cost))
    })
}

/// Operation counts as part of a sentence.
pub fn counts(cost: Cost) -> String {
    format!(
        "{}, {}",
        counted(cost.multiplications, "multiplication"),
        counted(cost.additions, "addition"),
    )
}

fn counted(number: usize, noun: &str) -> String {
    match number {
        0 => format!("no {noun}s"),
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    }
}

/// The statements of a kernel up to its result, a struct literal or a bare value, as
/// `ga_core::kernel!` reads them. They are Rust as they stand, too.
pub fn body(kernel: &Kernel, result: Option<&Type>, names: &Names<'_>) -> String {
    let mut names = names.clone();
    let mut text = unpack(kernel, &mut names);
    text.push_str(&constants(kernel, &mut names));
    for (i, poly) in kernel.temporaries.iter().enumerate() {
        let _ = writeln!(text, "let t{i} = {};", value(poly, &names));
    }
    text.push_str("return ");
    let mut values = kernel.outputs.iter().map(|poly| value(poly, &names));
    match result {
        Some(kind) => {
            let fields: Vec<String> = kind
                .fields()
                .zip(values)
                .map(|(slot, value)| format!("{}: {value}", slot.field))
                .collect();
            let _ = write!(text, "{} {{ {} }}", kind.name, fields.join(", "));
        }
        None => text.push_str(&values.next().unwrap_or_default()),
    }
    text
}

/// The result of a kernel that neither multiplies nor names anything, as a struct literal.
pub fn linear_body(kernel: &Kernel, result: &Type, names: &Names<'_>) -> String {
    let fields: Vec<String> = result
        .fields()
        .zip(&kernel.outputs)
        .map(|(slot, poly)| format!("{}: {}", slot.field, code(poly, names)))
        .collect();
    format!("{} {{ {} }}", result.name, fields.join(", "))
}

/// Names the constants.
fn constants(kernel: &Kernel, names: &mut Names<'_>) -> String {
    for (monomial, value) in kernel.polynomials().flat_map(Poly::terms) {
        let factor = value.abs();
        if monomial.degree() > 0 && !factor.is_one() && !names.constants.contains(&factor) {
            names.constants.push(factor);
        }
    }
    let mut text = String::new();
    if !names.constants.is_empty() {
        let left: Vec<String> = names.constants.iter().map(constant_name).collect();
        let right: Vec<String> = names.constants.iter().map(number).collect();
        let _ = writeln!(text, "let [{}] = [{}];", left.join(", "), right.join(", "));
    }
    text
}

/// Takes an operand apart where its fields occur so often that the body becomes shorter.
fn unpack(kernel: &Kernel, names: &mut Names<'_>) -> String {
    let mut text = String::new();
    for (place, operand) in NAMED.into_iter().enumerate() {
        let Some(kind) = names.operands[place] else {
            continue;
        };
        let polys = kernel.polynomials();
        let mut uses = vec![0_usize; kind.slots.len()];
        for (monomial, _) in polys.flat_map(Poly::terms) {
            for variable in monomial.variables().filter(|v| v.operand == operand) {
                uses[usize::from(variable.slot)] += 1;
            }
        }
        if uses.iter().sum::<usize>() <= kind.field_count() + 5 {
            continue;
        }
        let (prefix, value) = match operand {
            0 => ("a", "self"),
            MULTIPLE => ("w", "w"),
            _ => (names.argument, names.argument),
        };
        let fields: Vec<String> = kind
            .slots
            .iter()
            .zip(&uses)
            .filter(|(slot, _)| slot.fixed.is_none())
            .map(|(slot, uses)| match uses {
                0 => "_".to_owned(),
                _ => format!("{prefix}_{}", slot.field),
            })
            .collect();
        let _ = writeln!(text, "let [{}] = {value}.to_array();", fields.join(", "));
        names.unpacked[place] = true;
    }
    text
}

/// A documentation attribute with this text.
pub fn doc(text: &str) -> String {
    format!("#[doc = {text:?}]")
}
