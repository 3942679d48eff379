//! Products are known and listed once; without a list, all are generated, and the geometric
//! product always is.

use ga_core::Product;
use proc_macro2::Ident;

use crate::errors::{Errors, Mistake, closest};

/// Names by which other libraries call a product.
const SYNONYMS: [(&str, &str); 12] = [
    ("outer", "wedge"),
    ("exterior", "wedge"),
    ("join", "wedge"),
    ("meet", "regressive"),
    ("vee", "regressive"),
    ("antiwedge", "regressive"),
    ("dot", "inner"),
    ("contract", "left_contract"),
    ("left_contraction", "left_contract"),
    ("right_contraction", "right_contract"),
    ("scalar", "scalar_product"),
    ("gp", "geometric"),
];

/// Operations that take one operand, and are no products.
const OF_ONE_OPERAND: [&str; 15] = [
    "reverse",
    "involute",
    "conjugate",
    "dual",
    "undual",
    "left_complement",
    "right_complement",
    "grade",
    "norm",
    "norm_squared",
    "normalized",
    "inverse",
    "exp",
    "log",
    "sqrt",
];

/// The products to generate, and whether versors can be applied.
pub fn products(listed: Option<&[Ident]>, errors: &mut Errors) -> (Vec<Product>, bool) {
    let Some(listed) = listed else {
        return (Product::ALL.to_vec(), true);
    };
    let mut products = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    let (mut apply, mut project, mut reject) = (false, false, false);
    for token in listed {
        let name = token.to_string();
        if seen.contains(&name) {
            errors.push(token.span(), Mistake::DuplicateProduct(name));
            continue;
        }
        match name.as_str() {
            "apply" | "sandwich" => apply = true,
            "project" => project = true,
            "reject" => reject = true,
            _ => match Product::ALL.iter().find(|product| product.method() == name) {
                Some(product) => products.push(*product),
                None => errors.push(token.span(), unknown(&name)),
            },
        }
        seen.push(name);
    }
    // Sandwiches, inverses and exponentials are made of geometric products, projections of
    // contractions (2.29), rejections of an outer product and a contraction (2.30).
    let mut require = |product: Product, wanted: bool| {
        if wanted && !products.contains(&product) {
            products.push(product);
        }
    };
    require(Product::Geometric, true);
    require(Product::LeftContract, project);
    require(Product::Wedge, reject);
    require(Product::RightContract, reject);
    (products, apply)
}

/// The product meant by another library's name, or the closest name.
fn unknown(name: &str) -> Mistake {
    if OF_ONE_OPERAND.contains(&name) {
        return Mistake::NotAProduct(name.to_owned());
    }
    let synonym = SYNONYMS.iter().find(|(theirs, _)| *theirs == name);
    let methods = Product::ALL.iter().map(|product| product.method());
    let known = methods.chain(["apply", "sandwich", "project", "reject"]);
    let suggestion = synonym.map_or_else(|| closest(name, known), |(_, ours)| Some((*ours).into()));
    Mistake::UnknownProduct {
        name: name.to_owned(),
        suggestion,
    }
}
