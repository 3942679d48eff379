//! The conformal model in its null basis: every pair of its types.

use ga::cga::cga3;

use crate::conversions::{check_conversions, check_masks};
use crate::divisions::check_divisions;
use crate::metrics::null_basis;
use crate::operators::{check_operators, check_references, check_sums};
use crate::products::check_products;
use crate::unary::{check_duals, check_unary};
use crate::versors::check_versors;

const UNITS: [&str; 2] = ["Translator", "Transversor"];

macro_rules! with_types {
    ($oracle:ident, $each:ident, $check:ident) => {
        $each!(
            $oracle, cga3,
            [Vector3 Bivector3 Trivector3 Point DualSphere DualPlane PointPair FlatPoint
             DirectionVector TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector
             TangentBivector Sphere Plane DirectionTrivector TangentTrivector Pseudoscalar Rotor
             Translator Motor Dilator Transversor Scalar Even Odd Multivector],
            $check
        );
    };
}

macro_rules! kinds {
    ($oracle:ident, $module:ident, $types:tt, $check:ident) => {
        let mut $oracle = oracle!($module null_basis(), units UNITS, $types);
        $oracle.embeddings = &[("Vector3", "Point")];
    };
}

#[test]
fn products() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_pair, check_products);
}

#[test]
fn versors() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_pair, check_versors);
    let versors = oracle.versors.borrow();
    let promised = [
        "Motor",
        "Rotor",
        "Dilator",
        "DualPlane",
        "DualSphere",
        "Even",
        "Odd",
    ];
    for name in UNITS.iter().chain(&promised) {
        let list = versors.get(&((*name).to_owned(), true));
        assert!(list.is_some_and(|list| !list.is_empty()), "{name}");
    }
}

#[test]
fn conversions() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_pair, check_conversions);
}

#[test]
fn single_operands_and_laws() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_type, check_unary);
    with_types!(oracle, each_type, check_duals);
    check_masks!(oracle, cga3);
    type Q = ga::core::Rational;
    type M = cga3::Multivector<Q>;
    crate::laws::products::<M>(&oracle);
    crate::laws::duals::<M>(&oracle);
    crate::laws::versors::<cga3::Even<Q>, M>(&oracle);
    crate::laws::versors::<cga3::Odd<Q>, M>(&oracle);
    crate::laws::versors::<cga3::Motor<Q>, M>(&oracle);
    crate::laws::versors::<cga3::DualSphere<Q>, M>(&oracle);
}

#[test]
fn divisions() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_pair, check_divisions);
}

#[test]
fn operators() {
    with_types!(oracle, kinds, none);
    with_types!(oracle, each_pair, check_operators);
    with_types!(oracle, each_pair, check_sums);
    // References only forward, by one macro for all pairs.
    each_pair!(
        oracle,
        cga3,
        [Vector3 Point DualSphere PointPair DualLine Circle Motor Translator Even Multivector],
        check_references
    );
}
