//! Polynomials as Rust expressions and as formulas for people.

use std::fmt::Write;

use ga_core::Rational;
use num_traits::{One, ToPrimitive};

use crate::factor::{Cost, Kernel, MULTIPLE, RECIPROCAL, by_factor};
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
            (RECIPROCAL, _) => "f".to_owned(),
            _ => format!("t{}", variable.slot),
        }
    }

    fn formula(&self, variable: Variable) -> String {
        match (variable.operand, self.field(variable)) {
            (0, Some(field)) => format!("a.{field}"),
            (1, Some(field)) => format!("{}.{field}", self.argument),
            (MULTIPLE, Some(field)) => format!("w.{field}"),
            (RECIPROCAL, _) => "f".to_owned(),
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

/// A polynomial as a Rust expression.
pub fn code(poly: &Poly, names: &Names<'_>) -> String {
    let mut text = String::new();
    for (factor, group) in by_factor(poly) {
        if group.len() == 1 {
            let (monomial, negative) = group[0];
            sign(&mut text, negative);
            product(&mut text, &monomial, &factor, names);
        } else if factor.is_one() {
            for (monomial, negative) in group {
                sign(&mut text, negative);
                product(&mut text, &monomial, &factor, names);
            }
        } else {
            let mut inner = String::new();
            let flip = group[0].1;
            for (monomial, negative) in group {
                sign(&mut inner, negative != flip);
                product(&mut inner, &monomial, &Rational::one(), names);
            }
            sign(&mut text, flip);
            let _ = write!(text, "({inner}) * {}", number(&factor));
        }
    }
    if text.is_empty() {
        "T::ZERO".to_owned()
    } else {
        text
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

fn product(text: &mut String, monomial: &Monomial, factor: &Rational, names: &Names<'_>) {
    let mut factors: Vec<String> = monomial.variables().map(|v| names.code(v)).collect();
    if !factor.is_one() || factors.is_empty() {
        factors.push(number(factor));
    }
    text.push_str(&factors.join(" * "));
}

/// A polynomial as a formula, `a.e1 b.e2 − a.e2 b.e1`.
pub fn formula(poly: &Poly, names: &Names<'_>) -> String {
    let mut text = String::new();
    for (factor, group) in by_factor(poly) {
        for (monomial, negative) in group {
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
    let mut text = format!(
        " {summary} Cost: {}{}.\n\n ```text\n",
        counts(cost),
        if kernel.divisor.is_some() {
            ", 1 division"
        } else {
            ""
        },
    );
    if let Some(divisor) = &kernel.divisor {
        let _ = writeln!(text, " f = 1 / ({})", formula(divisor, names));
    }
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

/// The statements of a kernel up to its result, a struct literal or a bare value.
pub fn body(kernel: &Kernel, result: Option<&Type>, names: &Names<'_>) -> String {
    let mut names = names.clone();
    let mut text = unpack(kernel, &mut names);
    if let Some(divisor) = &kernel.divisor {
        let _ = writeln!(text, "let f = T::ONE / ({});", code(divisor, &names));
    }
    for (i, poly) in kernel.temporaries.iter().enumerate() {
        let _ = writeln!(text, "let t{i} = {};", code(poly, &names));
    }
    match result {
        Some(kind) => {
            let fields: Vec<String> = kind
                .fields()
                .zip(&kernel.outputs)
                .map(|(slot, poly)| format!("{}: {}", slot.field, code(poly, &names)))
                .collect();
            let _ = write!(text, "{} {{ {} }}", kind.name, fields.join(", "));
        }
        None => {
            let values: Vec<String> = kernel.outputs.iter().map(|p| code(p, &names)).collect();
            text.push_str(&values.join(", "));
        }
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
