//! Functions with bodies of their own, listed by trait and first operand: a list has one head
//! where implementations would have one each.

use std::fmt::Write;

use crate::factor::Kernel;

use super::expression;

/// The functions of one first operand, in lists of the same trait and bound.
pub struct Lists {
    left: String,
    lists: Vec<(&'static str, &'static str, String)>,
}

/// One function, `fn method(self, argument: Right<T>) -> output { body }`.
pub struct Function<'a> {
    /// The trait that it implements.
    pub trait_name: &'static str,
    /// The method of the trait.
    pub method: &'static str,
    /// The bound on the numbers.
    pub bound: &'static str,
    /// The name and the type of an operand between the two.
    pub between: Option<(&'static str, &'a str)>,
    /// The name and the type of the second operand.
    pub argument: (&'static str, &'a str),
    /// The type of the result, with its parameter.
    pub output: &'a str,
    /// The documentation without its comment signs.
    pub documentation: &'a str,
    /// The statements.
    pub body: &'a str,
}

/// The bound that a kernel asks of its numbers.
pub fn bound(kernel: &Kernel) -> &'static str {
    match expression::is_integral(kernel) {
        true => "Number",
        false => "Field",
    }
}

impl Lists {
    /// No functions yet.
    pub fn new(left: String) -> Lists {
        Lists {
            left,
            lists: Vec::new(),
        }
    }

    /// Adds a function to its list.
    pub fn push(&mut self, function: &Function<'_>) {
        let Function {
            trait_name,
            method,
            bound,
            between,
            argument: (argument, right),
            output,
            documentation,
            body,
        } = function;
        let between = between.map_or(String::new(), |(name, kind)| format!("{name}: {kind}<T>, "));
        let text = format!(
            "{} fn {method}(self, {between}{argument}: {right}<T>) -> {output} {{ {body} }}\n",
            expression::doc(documentation)
        );
        let mut known = self.lists.iter_mut();
        match known.find(|(name, limit, _)| name == trait_name && limit == bound) {
            Some((_, _, list)) => list.push_str(&text),
            None => self.lists.push((trait_name, bound, text)),
        }
    }

    /// The lists as calls of `ga_core::unrolled!`.
    pub fn write(self, source: &mut String) {
        for (trait_name, bound, functions) in self.lists {
            let _ = writeln!(
                source,
                "algebra::unrolled! {{ impl<T: {bound}> {trait_name} for {}<T> {{ {functions} }} }}",
                self.left
            );
        }
    }
}
