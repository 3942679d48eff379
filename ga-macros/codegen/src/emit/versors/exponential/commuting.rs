//! Which types the functions of a bivector with two commuting planes work on: exponential, split,
//! logarithm, square root and polar normalisation of ga-core.

use std::fmt::Write;

use ga_core::Product;

use super::motors;
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression;
use crate::factor::{Cost, Kernel};
use crate::poly::Element;

/// The products that the functions are made of.
const NEEDED: [Product; 5] = [
    Product::Geometric,
    Product::Wedge,
    Product::Inner,
    Product::ScalarProduct,
    Product::Commutator,
];
/// Up to how many pairs of blades a product of the types may have.
const LARGEST_PRODUCT: usize = 256;

/// The types in which a type's functions are computed.
pub struct Planes {
    /// Holds the bivectors A and their products with the four-vectors.
    pub bivector: usize,
    /// Holds the four-vectors, A∧A among them.
    pub fourth: usize,
    /// Holds 1, bivectors and four-vectors.
    pub versor: usize,
    /// Whether every four-vector commutes with every bivector, whatever their values.
    commuting: bool,
    /// Whether the square of every four-vector is zero.
    null: bool,
    /// What the products of the types cost.
    costs: Costs,
}

/// What the products of the types cost.
struct Costs {
    /// A∧A, the scalar products A A and V V, and V A.
    planes: Cost,
    /// A sum of two multiples of bivectors.
    sum: Cost,
    /// What X X̃ takes besides.
    norm: Cost,
}

/// The grade-`k` part of a general element.
pub(super) fn part(element: &Element, grade: u32) -> Element {
    let own = element
        .iter()
        .filter(|(mask, _)| mask.count_ones() == grade);
    own.map(|(mask, poly)| (*mask, poly.clone())).collect()
}

impl Planes {
    /// The types for the even elements of a type; `None` where one is missing, where a product
    /// is not listed, or where outer squares of bivectors do not square to numbers.
    pub fn of(generator: &Generator<'_>, a: usize) -> Option<Planes> {
        let listed = |product| generator.model.products.contains(product);
        if !NEEDED.iter().all(listed) {
            return None;
        }
        let element = &generator.general[a][0];
        let grades_fit = |mask: &u32| matches!(mask.count_ones(), 0 | 2 | 4);
        if !element.keys().all(grades_fit) {
            return None;
        }
        Self::smallest(generator, element)
    }

    /// The smallest types whose products stay among them.
    fn smallest(generator: &Generator<'_>, element: &Element) -> Option<Planes> {
        let mut bivectors = part(element, 2);
        let mut fourths = part(element, 4);
        for _ in 0..generator.model.dimension() {
            let bivector = closure::smallest(generator.model, &bivectors)?;
            let of_bivector = part(&generator.general[bivector][0], 2);
            let outer = generator
                .tables
                .product(Product::Wedge, &of_bivector, &of_bivector);
            fourths.extend(outer);
            let fourth = closure::smallest(generator.model, &fourths)?;
            let of_fourth = part(&generator.general[fourth][0], 4);
            let turned = generator
                .tables
                .product(Product::Inner, &of_fourth, &of_bivector);
            if part(&turned, 2)
                .keys()
                .all(|mask| of_bivector.contains_key(mask))
            {
                return Self::within(generator, bivector, fourth);
            }
            bivectors.extend(part(&turned, 2));
        }
        None
    }

    /// These types, if four-vectors square to numbers.
    fn within(generator: &Generator<'_>, bivector: usize, fourth: usize) -> Option<Planes> {
        let count = |index: usize| generator.kind(index).slots.len();
        let largest = count(bivector) * count(bivector).max(count(fourth));
        if largest > LARGEST_PRODUCT || !numbers_square(generator, bivector, fourth) {
            return None;
        }
        let product = |product, a: usize, b: usize| {
            let (left, right) = (&generator.general[a][0], &generator.general[b][1]);
            generator.tables.product(product, left, right)
        };
        let outer = product(Product::Wedge, bivector, bivector);
        let turned = product(Product::Inner, fourth, bivector);
        let commutator = product(Product::Commutator, bivector, fourth);
        let others = product(Product::Commutator, fourth, fourth);
        let commuting = commutator.is_empty() && others.is_empty();
        let mut all = generator.general[bivector][0].clone();
        all.extend(generator.general[fourth][0].clone());
        // Any variable polynomial marks the scalar as free.
        let free = all.values().next()?.clone();
        all.insert(0, free);
        let square = product(Product::ScalarProduct, fourth, fourth);
        let plane = product(Product::ScalarProduct, bivector, bivector);
        let cost = |element: &Element| {
            Kernel::expanded(element.values().cloned().collect::<Vec<_>>()).cost()
        };
        let width = generator.kind(bivector).field_count();
        Some(Planes {
            bivector,
            fourth,
            versor: closure::smallest(generator.model, &all)?,
            commuting,
            null: square.is_empty(),
            costs: Costs {
                planes: cost(&outer) + cost(&plane) + cost(&square) + cost(&turned),
                sum: Cost {
                    fused: 2 * width,
                    multiplications: 2 * width,
                    additions: width,
                },
                norm: cost(&outer)
                    + cost(&plane)
                    + cost(&square)
                    + cost(&commutator)
                    + cost(&others),
            },
        })
    }

    /// The arguments that name the types.
    fn types(&self, generator: &Generator<'_>, a: usize) -> String {
        format!(
            "{} => {} ({} {})",
            generator.name(a),
            generator.name(self.versor),
            generator.name(self.bivector),
            generator.name(self.fourth)
        )
    }

    /// Emits `exp` and `split_commuting` of a type of bivectors.
    pub fn bivector_functions(&self, generator: &mut Generator<'_>, a: usize) {
        let fields = generator.kind(self.fourth).field_count();
        let cost = self.costs.planes + self.costs.sum + Cost::multiplying(fields);
        let sentence = expression::cost_sentence(Some(cost));
        let split = format!(
            " The two commuting blades whose sum it is (5.5, 5.12).{sentence} Two divisions and \
             a root."
        );
        let types = self.types(generator, a);
        let _ = writeln!(
            generator.source,
            "algebra::commuting_split! {{ {types} {split:?} }}"
        );
        if self.null {
            motors::exponential(generator, a, self);
            return;
        }
        let exp = format!(
            " The exponential `C(B²) + S(B²) B` (2.62) with the Study number `B² = a + B∧B`, \
             `C(s) = cosh √s` and `S(s) = sinh √s / √s`.{sentence} Besides 22 products of Study \
             numbers and two for each halving."
        );
        let _ = writeln!(
            generator.source,
            "algebra::bivector_exponential! {{ {types} {exp:?} }}"
        );
    }

    /// Emits `log`, `sqrt` and `renormalized` of an even type.
    pub fn versor_functions(&self, generator: &mut Generator<'_>, a: usize) {
        let common = self.costs.planes + self.costs.norm;
        let logarithm = expression::cost_sentence(Some(common + self.costs.sum));
        let fields = Cost::multiplying(1 + generator.kind(self.fourth).field_count());
        let root = expression::cost_sentence(Some(common + self.costs.sum + fields));
        let normal = expression::cost_sentence(Some(self.costs.norm + self.costs.sum + fields));
        let (algorithm, how) = match self.null {
            true => ("motor_logarithm", "one evaluation on dual numbers"),
            false => (
                "logarithm",
                "15 products of Study numbers, with a product and a root for each halving",
            ),
        };
        let log = format!(
            " The principal logarithm of the versor over its norm, `R = c + A` with a Study \
             number `c = cosh z` and `log R = (z / sinh z) A`; `None` where no real one exists or \
             it is not unique, and where `R R̃` is no positive number.{logarithm} Besides {how}."
        );
        let sqrt = format!(
            " The principal square root `h + A/(2h)` with the Study number `h = √((1 + c)/2)` \
             (2.37, 5.11); `None` as for the logarithm.{root} Besides three divisions and three \
             roots."
        );
        let normal = format!(
            " The unit versor `(X X̃)^(−1/2) X`, free of the drift of rounding.{normal} Two \
             divisions and two roots."
        );
        let commuting = if self.commuting {
            "commuting"
        } else {
            "general"
        };
        let types = self.types(generator, a);
        let of_unit = match self.null {
            true => motors::logarithm_of_unit(generator, a, self),
            false => format!(
                "algebra::algorithm::logarithm_of_unit::<T, _, {}<T>, {}<T>>(self)",
                generator.name(self.bivector),
                generator.name(self.fourth)
            ),
        };
        let _ = writeln!(
            generator.source,
            "algebra::versor_functions! {{ {algorithm} {commuting} {types} {log:?} {sqrt:?} {normal:?} of_unit self {{ {of_unit} }} }}"
        );
    }
}

/// Whether four-vectors of a type square to numbers and have no part of grade six with the
/// bivectors: always in up to five dimensions.
fn numbers_square(generator: &Generator<'_>, bivector: usize, fourth: usize) -> bool {
    if generator.model.dimension() <= 5 {
        return true;
    }
    let of_bivector = part(&generator.general[bivector][0], 2);
    let of_fourth = part(&generator.general[fourth][0], 4);
    let square = generator
        .tables
        .product(Product::Geometric, &of_fourth, &of_fourth);
    let outer = generator
        .tables
        .product(Product::Wedge, &of_fourth, &of_bivector);
    outer.is_empty() && square.keys().all(|mask| *mask == 0)
}
