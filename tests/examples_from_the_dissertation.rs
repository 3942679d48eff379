//! The worked examples of appendix A.4 and Table A.1: results as printed, and the instruction
//! lists as formulas of the generated documentation.

use ga::core::Blade;
use ga::core::ops::Element;

ga::define_algebra!(R3);

use r3::{Bivector, Even, Multivector, Scalar, Vector};

const A: Vector = Vector::new(1.0, 2.0, 3.0);
const B: Vector = Vector::new(4.0, 5.0, 6.0);

/// The blades of a type as the dissertation prints them, e₁ at the lowest bit.
fn bits<X: Element>() -> Vec<(&'static str, String)> {
    let labels = X::LABELS.iter().copied();
    let masks = X::BLADES
        .iter()
        .map(|(blade, _)| format!("{:03b}", blade.mask()));
    labels.zip(masks).collect()
}

fn printed(list: &[(&'static str, &str)]) -> Vec<(&'static str, String)> {
    list.iter()
        .map(|(label, bits)| (*label, (*bits).to_owned()))
        .collect()
}

#[test]
fn inner_product() {
    assert_eq!(A.inner(B), Scalar::new(32.0));
    assert_eq!(A | B, Scalar::new(32.0));
    assert_eq!((A | B).to_string(), "32");
    assert_eq!(bits::<Scalar>(), printed(&[("1", "000")]));
}

#[test]
fn outer_product() {
    assert_eq!(A.wedge(B), Bivector::new(-3.0, -6.0, -3.0));
    assert_eq!(A ^ B, A.wedge(B));
    assert_eq!((A ^ B).to_string(), "-3 e12 - 6 e13 - 3 e23");
    let blades = printed(&[("e12", "011"), ("e13", "101"), ("e23", "110")]);
    assert_eq!(bits::<Bivector>(), blades);
}

#[test]
fn geometric_product() {
    assert_eq!(A.geometric(B), Even::new(32.0, -3.0, -6.0, -3.0));
    assert_eq!(A * B, A.geometric(B));
    assert_eq!((A * B).to_string(), "32 - 3 e12 - 6 e13 - 3 e23");
    let blades = printed(&[("1", "000"), ("e12", "011"), ("e13", "101"), ("e23", "110")]);
    assert_eq!(bits::<Even>(), blades);
}

/// The documentation lines above a function of a list.
fn documentation<'a>(source: &'a str, list: &str, function: &str) -> Vec<&'a str> {
    let start = source.find(list).expect("the list is generated");
    let list = &source[start..];
    let end = list.find(function).expect("the function is generated");
    let lines = list[..end].lines().map(str::trim).rev().skip(1);
    lines
        .map_while(|line| line.strip_prefix("///"))
        .map(str::trim)
        .collect()
}

/// The instruction lists of A.4: `a[i] * b[j] /*eij*/ -a[j] * b[i] /*eij*/`.
fn holds_instructions(dimension: usize, blades: &[(usize, usize)]) {
    let source = ga_codegen::expand(&format!("R{dimension}"));
    let lines = documentation(
        &source,
        "Wedge for Vector<T> {",
        "fn wedge(self, b: Vector<T>)",
    );
    let text = lines.join("\n");
    for (i, j) in blades {
        let formula = format!("e{i}{j} = a.e{i} b.e{j} − a.e{j} b.e{i}");
        assert!(text.contains(&formula), "{formula} is not in\n{text}");
    }
}

#[test]
fn instructions_of_the_outer_product_of_two_vectors() {
    holds_instructions(3, &[(1, 2), (1, 3), (2, 3)]);
    holds_instructions(4, &[(1, 2), (1, 3), (2, 3), (1, 4), (2, 4), (3, 4)]);
}

/// Table A.1: binary representation of the basis blades, with their grades.
#[test]
fn table_of_basis_blades() {
    let table = [
        ("1", "000", 0),
        ("e1", "001", 1),
        ("e2", "010", 1),
        ("e3", "100", 1),
        ("e12", "011", 2),
        ("e13", "101", 2),
        ("e23", "110", 2),
        ("e123", "111", 3),
    ];
    let blades = table.map(|(label, bits, _)| (label, bits.to_owned()));
    assert_eq!(bits::<Multivector>(), blades.to_vec());
    for (_, bits, grade) in table {
        let mask = u32::from_str_radix(bits, 2).expect("binary digits");
        assert_eq!(Blade::new(mask).grade(), grade);
    }
}
