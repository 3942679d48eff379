//! The one table of products: names, symbols, meanings and rules.

use crate::involution::Involution;

/// A bilinear product of multivectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Product {
    /// The geometric product `a b`.
    Geometric,
    /// The outer product `a ∧ b`.
    Wedge,
    /// The left contraction `a ⌋ b`.
    LeftContract,
    /// The right contraction `a ⌊ b`.
    RightContract,
    /// The inner product `a · b` of (2.71).
    Inner,
    /// The scalar part of the geometric product.
    ScalarProduct,
    /// The regressive product `a ∨ b`.
    Regressive,
    /// Half the difference `(ab − ba)/2`.
    Commutator,
    /// Half the sum `(ab + ba)/2`.
    Anticommutator,
}

/// Everything that distinguishes a product from the others.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The product.
    pub product: Product,
    /// The name of the method.
    pub method: &'static str,
    /// The name of the trait that holds the method.
    pub trait_name: &'static str,
    /// The operator that stands for it, if one does.
    pub operator: Option<&'static str>,
    /// Its meaning in one sentence.
    pub doc: &'static str,
    /// Its definition on basis blades.
    pub rule: Rule,
}

/// How a product of basis blades is formed.
#[derive(Clone, Copy, Debug)]
pub enum Rule {
    /// The parts of the geometric product for which the function of the left grade, the right
    /// grade and the grade of the part is true.
    Grades(fn(left: u32, right: u32, part: u32) -> bool),
    /// The left complement of the outer product of the right complements.
    Complements,
}

/// The products, each at the position of its variant.
pub const TABLE: [Row; 9] = [
    Row {
        product: Product::Geometric,
        method: "geometric",
        trait_name: "Geometric",
        operator: Some("*"),
        doc: "The geometric product `a b`.",
        rule: Rule::Grades(|_, _, _| true),
    },
    Row {
        product: Product::Wedge,
        method: "wedge",
        trait_name: "Wedge",
        operator: Some("^"),
        doc: "The outer product `a ∧ b`: what both span together.",
        rule: Rule::Grades(|left, right, part| part == left + right),
    },
    Row {
        product: Product::LeftContract,
        method: "left_contract",
        trait_name: "LeftContract",
        operator: Some("<<"),
        doc: "The left contraction `a ⌋ b`: the part of `b` that is orthogonal to `a`, of grade b − a.",
        rule: Rule::Grades(|left, right, part| left + part == right),
    },
    Row {
        product: Product::RightContract,
        method: "right_contract",
        trait_name: "RightContract",
        operator: None,
        doc: "The right contraction `a ⌊ b`: the part of `a` that is orthogonal to `b`, of grade a − b.",
        rule: Rule::Grades(|left, right, part| right + part == left),
    },
    Row {
        product: Product::Inner,
        method: "inner",
        trait_name: "Inner",
        operator: Some("|"),
        doc: "The inner product `a · b` of grade |a − b|, zero when either side is a scalar (2.71).",
        rule: Rule::Grades(|left, right, part| {
            left > 0 && right > 0 && part == left.abs_diff(right)
        }),
    },
    Row {
        product: Product::ScalarProduct,
        method: "scalar_product",
        trait_name: "ScalarProduct",
        operator: None,
        doc: "The scalar product `⟨a b⟩`: the scalar part of the geometric product.",
        rule: Rule::Grades(|_, _, part| part == 0),
    },
    Row {
        product: Product::Regressive,
        method: "regressive",
        trait_name: "Regressive",
        operator: Some("&"),
        doc: "The regressive product `a ∨ b`: what both have in common, without use of the metric.",
        rule: Rule::Complements,
    },
    Row {
        product: Product::Commutator,
        method: "commutator",
        trait_name: "Commutator",
        operator: None,
        doc: "The commutator product `(a b − b a)/2`.",
        rule: Rule::Grades(|left, right, part| exchange_sign(left, right, part) < 0),
    },
    Row {
        product: Product::Anticommutator,
        method: "anticommutator",
        trait_name: "Anticommutator",
        operator: None,
        doc: "The anticommutator product `(a b + b a)/2`.",
        rule: Rule::Grades(|left, right, part| exchange_sign(left, right, part) > 0),
    },
];

/// The sign between ⟨ab⟩ₖ and ⟨ba⟩ₖ for blades `a` and `b`: since (ab)~ = b̃ã, it is the product
/// of the three signs of reversal.
const fn exchange_sign(left: u32, right: u32, part: u32) -> i32 {
    let reverse = Involution::Reverse;
    reverse.sign(left) * reverse.sign(right) * reverse.sign(part)
}

impl Product {
    /// Every product, in the order of the table.
    pub const ALL: [Product; TABLE.len()] = {
        let mut all = [Product::Geometric; TABLE.len()];
        let mut index = 0;
        while index < TABLE.len() {
            all[index] = TABLE[index].product;
            assert!(all[index] as usize == index, "the table is out of order");
            index += 1;
        }
        all
    };

    /// The row of the table.
    pub const fn row(self) -> &'static Row {
        const ROWS: &[Row; TABLE.len()] = &TABLE;
        &ROWS[self as usize]
    }

    /// The name of the method, such as `left_contract`.
    pub const fn method(self) -> &'static str {
        self.row().method
    }

    /// The name of the trait, such as `LeftContract`.
    pub const fn trait_name(self) -> &'static str {
        self.row().trait_name
    }

    /// The operator that stands for the product, such as `^`, if one does.
    pub const fn operator(self) -> Option<&'static str> {
        self.row().operator
    }

    /// The meaning in one sentence.
    pub const fn doc(self) -> &'static str {
        self.row().doc
    }
}
