//! The polynomials of one application: which form is the cheapest, of which type its result is,
//! and whether it is worth a body of its own.

use ga_core::Product;

use super::kernels::{cheaper, moving, multiple, named, onto};
use super::matrix::{Pattern, pattern};
use super::null::{eliminated, squared};
use crate::closure;
use crate::emit::Generator;
use crate::emit::versors::inverse::parity_type;
use crate::emit::versors::reversed;
use crate::factor::Kernel;
use crate::model::Type;
use crate::poly::{Element, Monomial, Poly, Variable, graded_signs, sum};

/// How many terms a sandwich may have to be unrolled where the type looks like a versor.
const VERSOR_LIMIT: usize = 400;
/// How many terms it may have where the type could be anything, in small algebras.
const ELEMENT_LIMIT: usize = 60;
/// Up to how many types an algebra is small.
pub const SMALL_ALGEBRA: usize = 12;
/// How many terms a sandwich may have before collection for its polynomials to be looked at.
pub const LARGEST_POLYNOMIAL: usize = 20_000;

/// What is known of applying one type to another.
pub struct Application {
    /// The type of `V x̂ Ṽ`.
    pub sandwich: usize,
    /// The body of the sandwich, where it is short enough to be unrolled.
    pub sandwich_kernel: Option<Kernel>,
    /// The type of `V x̂ V⁻¹`, where fixed coefficients may be kept.
    pub applied: usize,
    /// The body of the application, given the multiple of the versor whose reverse is the inverse;
    /// where it is not the sandwich itself.
    pub applied_kernel: Option<Kernel>,
    /// Which entries its matrix has, where bodies are wanted and that is known.
    pub pattern: Option<Pattern>,
}

impl Application {
    /// Whether it has a body of its own, of one kind or the other.
    pub fn is_unrolled(&self) -> bool {
        self.sandwich_kernel.is_some() || self.applied_kernel.is_some()
    }
}

/// Whether `V Ṽ = 1` by declaration or by the fixed coefficients.
pub fn is_unit(generator: &Generator<'_>, v: usize) -> bool {
    let versor = &generator.general[v][0];
    if generator.kind(v).unit || !generator.kind(v).has_fixed() {
        return generator.kind(v).unit;
    }
    let one = ga_core::Rational::from_integer(1);
    let square = generator
        .tables
        .product(Product::Geometric, versor, &reversed(versor));
    square.len() == 1 && square.get(&0).and_then(Poly::as_constant) == Some(one)
}

/// Whether unrolling is worth its tokens: declared versors, scalar-plus-blade types, and what
/// versors are made of, vectors and bivectors.
fn looks_like_versor(kind: &Type) -> bool {
    let rotor_like = kind.slot(0).is_some() && kind.field_count() > 1;
    kind.unit || rotor_like || [0b10, 0b100].contains(&kind.grades())
}

/// Derives the application of one type to another; without bodies where they are not wanted.
pub fn application(
    generator: &Generator<'_>,
    [v, x]: [usize; 2],
    even: bool,
    bodies: bool,
) -> Option<Application> {
    let model = generator.model;
    let kind = generator.kind(x);
    let grades = kind.grades();
    let wanted = |mask: u32| grades >> mask.count_ones() & 1 == 1;
    let unit = is_unit(generator, v);
    // Large types in high dimensions would take minutes of polynomial arithmetic for a body
    // that is composed anyway; there the operand's own grades are the result.
    let size = generator.kind(v).slots.len().pow(2) * kind.slots.len();
    if size > LARGEST_POLYNOMIAL {
        let by_grade = closure_of_grades(generator, x).filter(|_| model.is_complete())?;
        return Some(Application {
            sandwich: by_grade,
            sandwich_kernel: None,
            applied: by_grade,
            applied_kernel: None,
            pattern: None,
        });
    }
    let versor = &generator.general[v][0];
    let operand = &generator.general[x][1];
    let reflected = graded_signs(operand, |grade| if even || grade % 2 == 0 { 1 } else { -1 });
    let product = |a: &Element, b: &Element| generator.tables.product(Product::Geometric, a, b);
    let restricted = |a: &Element, b: &Element| {
        generator
            .tables
            .product_onto(Product::Geometric, a, b, wanted)
    };
    let first = product(versor, &reflected);
    let difference = sum(&first, &product(operand, versor), -1);
    let back = reversed(versor);
    let whole = restricted(&first, &back);
    let moved = sum(operand, &restricted(&difference, &back), 1);
    let pick = |element: &Element| {
        // Versors keep a square of 0.
        let same = closure::fits(kind, element);
        same.then_some(x)
            .or_else(|| closure::smallest(model, element))
    };
    // Whether the operand's fixed coefficients stay, is seen from x + (V x̂ − x V) V⁻¹ alone.
    let keeps = kind.is_constrained() && closure::fits(kind, &moved);
    let whole_type = pick(&whole)?;
    let applied = match (keeps, unit) {
        (true, _) => x,
        (false, true) => whole_type,
        (false, false) => generator.sums[whole_type]?,
    };
    if !bodies {
        return Some(Application {
            sandwich: whole_type,
            sandwich_kernel: None,
            applied,
            applied_kernel: None,
            pattern: None,
        });
    }
    let pattern = Some(pattern(generator, [applied, x], &whole));
    let composable = composable(generator, &first, &back);
    let limit = match composable {
        true => unroll_limit(generator, v, applied),
        false => usize::MAX,
    };
    let short = |kernel: Kernel| Some(kernel).filter(|kernel| kernel.terms() <= limit);
    let shortened = |kernel: Kernel| match applied == x {
        true => eliminated(generator, x, kernel),
        false => kernel,
    };
    if unit {
        let kernel = moving(generator, applied, &difference, &back, operand, &whole);
        let expanded = Kernel::expanded(generator.onto_fields(applied, &moved));
        let (kernel, expanded) = (shortened(kernel), shortened(expanded));
        return Some(Application {
            sandwich: applied,
            sandwich_kernel: short(cheaper(expanded, kernel)),
            applied,
            applied_kernel: None,
            pattern,
        });
    }
    // V⁻¹ = W̃ with W = V of a unit versor and W = V/(V Ṽ) of any other: one body for both.
    let multiples = generator.sums[v].filter(|_| looks_like_versor(generator.kind(v)));
    let applied_kernel = multiples.and_then(|multiples| {
        let inverse = reversed(&multiple(generator, [v, multiples]));
        let kernel = moving(generator, applied, &difference, &inverse, operand, &whole);
        short(shortened(kernel).factored())
    });
    // The square of a spinor needs no inverse, and its result is divided where the versor is not
    // unit.
    let spinor = squared(generator, [v, x], even, whole_type).filter(|_| applied == whole_type);
    let spinor = spinor.map(Kernel::factored);
    let spinor = spinor.filter(|spinor| {
        let other = applied_kernel.as_ref().map(Kernel::cost);
        other.is_none_or(|other| spinor.cost() < other)
    });
    if let Some(spinor) = spinor.and_then(short) {
        return Some(Application {
            sandwich: whole_type,
            sandwich_kernel: Some(spinor),
            applied,
            applied_kernel: None,
            pattern,
        });
    }
    // In large algebras one unrolled body per pair has to do.
    let small = model.types.len() <= SMALL_ALGEBRA;
    let sandwich_kernel = if applied_kernel.is_none() || small || !composable {
        let (named, temporaries) = named(&first);
        let second = onto(generator, whole_type, &named, &back, &whole);
        let steps = Kernel {
            temporaries,
            outputs: generator.onto_fields(whole_type, &second),
            form: "(V x) Ṽ".into(),
        };
        let expanded = Kernel::expanded(generator.onto_fields(whole_type, &whole));
        short(cheaper(expanded, steps.without_unused()))
    } else {
        None
    };
    Some(Application {
        sandwich: whole_type,
        sandwich_kernel,
        applied,
        applied_kernel,
        pattern,
    })
}

/// Whether two products can compose the sandwich: whether both have types.
fn composable(generator: &Generator<'_>, first: &Element, back: &Element) -> bool {
    let model = generator.model;
    model.is_complete()
        || closure::smallest(model, first).is_some_and(|between| {
            let between = &generator.general[between][0];
            let product = generator.tables.product(Product::Geometric, between, back);
            closure::smallest(model, &product).is_some()
        })
}

/// How many terms the body may have; in large algebras only versors are unrolled, and not where
/// the result is of a type that holds everything of a parity.
fn unroll_limit(generator: &Generator<'_>, v: usize, result: usize) -> usize {
    let small = generator.model.types.len() <= SMALL_ALGEBRA;
    let everything = parity_type(generator, result) == Some(result);
    if looks_like_versor(generator.kind(v)) && (small || !everything) {
        VERSOR_LIMIT
    } else if small {
        ELEMENT_LIMIT
    } else {
        0
    }
}

/// The smallest type with all blades of the operand's grades.
fn closure_of_grades(generator: &Generator<'_>, x: usize) -> Option<usize> {
    let grades = generator.kind(x).grades();
    let marker = Poly::term(
        Monomial::of(Variable {
            operand: 0,
            slot: 0,
        }),
        ga_core::Rational::from_integer(1),
    );
    let element: Element = (0..1_u32 << generator.model.dimension())
        .filter(|mask| grades >> mask.count_ones() & 1 == 1)
        .map(|mask| (mask, marker.clone()))
        .collect();
    closure::smallest(generator.model, &element)
}
