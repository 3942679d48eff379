//! Whether speed costs accuracy: kernels in single precision against their polynomials in double.

use std::collections::HashMap;

use ga_core::Rational;

use super::{Kernel, TEMPORARY, Whole, conformal, kernels, multiplied_out};
use crate::poly::{Poly, Variable};

/// Values of variables.
type Values<F> = HashMap<Variable, F>;

/// Reproducible numbers between −1 and 1 with 24 significant bits.
struct Samples(u64);

impl Samples {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1 << 23) as f32 - 1.0
    }

    /// A value for every variable of two kernels, in an order that does not depend on hashes.
    fn values(&mut self, kernels: [&Kernel; 2]) -> Values<f32> {
        let polynomials = kernels.into_iter().flat_map(Kernel::polynomials);
        let terms = polynomials.flat_map(Poly::terms);
        let mut variables: Vec<Variable> = terms.flat_map(|(term, _)| term.variables()).collect();
        variables.sort_unstable();
        variables.dedup();
        variables.into_iter().map(|v| (v, self.next())).collect()
    }
}

fn number(constant: &Rational) -> f64 {
    *constant.numer() as f64 / *constant.denom() as f64
}

/// The outputs of a kernel whose polynomials are evaluated by `sum`.
fn outputs<F: Copy>(
    kernel: &Kernel,
    mut values: Values<F>,
    sum: impl Fn(&Poly, &Values<F>) -> F,
) -> Vec<F> {
    for (slot, poly) in kernel.temporaries.iter().enumerate() {
        let variable = Variable {
            operand: TEMPORARY,
            slot: slot as u16,
        };
        let value = sum(poly, &values);
        values.insert(variable, value);
    }
    let outputs = kernel.outputs.iter();
    outputs.map(|poly| sum(poly, &values)).collect()
}

/// A sum in single precision, each term added to those before, rounded once where it is fused.
fn rounded(poly: &Poly, values: &Values<f32>, is_fused: bool) -> f32 {
    poly.terms().fold(0.0, |sum, (term, constant)| {
        let constant = number(constant) as f32;
        let factors: Vec<f32> = term.variables().map(|v| values[&v]).collect();
        match factors.split_last() {
            None => sum + constant,
            Some((last, others)) => {
                let product = others.iter().fold(constant, |product, x| product * x);
                match is_fused {
                    true => product.mul_add(*last, sum),
                    false => sum + product * last,
                }
            }
        }
    })
}

/// The sum of the absolute values of all terms.
fn size(poly: &Poly, values: &Values<f64>) -> f64 {
    let terms = poly.terms().map(|(term, constant)| {
        let factors = term.variables().map(|v| values[&v]);
        factors.fold(number(constant).abs(), |product, x| product * x)
    });
    terms.sum()
}

/// The value of a polynomial.
fn exact(whole: &Whole, values: &Values<f32>) -> f64 {
    let terms = whole.iter().map(|(variables, constant)| {
        let factors = variables.iter().map(|v| f64::from(values[v]));
        factors.fold(number(constant), |product, x| product * x)
    });
    terms.sum()
}

/// The largest error of an output, in units in the last place of the sum of the sizes of the terms
/// that it has before factoring.
fn error([before, after]: &[Kernel; 2], samples: &mut Samples) -> f64 {
    let wholes = multiplied_out(before);
    let mut worst = 0.0;
    for _ in 0..8 {
        let values = samples.values([before, after]);
        let sizes = values.iter().map(|(v, x)| (*v, f64::from(x.abs())));
        let sizes = outputs(before, sizes.collect(), size);
        for is_fused in [false, true] {
            let sum = |poly: &Poly, values: &Values<f32>| rounded(poly, values, is_fused);
            let found = outputs(after, values.clone(), sum);
            for ((found, whole), size) in found.iter().zip(&wholes).zip(&sizes) {
                let unit = f64::from(f32::EPSILON) * 2.0_f64.powf(size.log2().floor());
                let error = (f64::from(*found) - exact(whole, &values)).abs();
                worst = f64::max(worst, error / unit.max(f64::MIN_POSITIVE));
            }
        }
    }
    worst
}

#[test]
fn factored_functions_are_as_accurate_as_their_terms() {
    for declaration in ["R2", "R3", "R3_0_1", conformal()] {
        let mut samples = Samples(1);
        for kernels in &kernels(declaration) {
            let error = error(kernels, &mut samples);
            assert!(error <= 4.0, "{error}: {:?}", kernels[1]);
        }
    }
}
