//! A geometry of the oracle: dense multivectors of 32 digits, an orthogonal frame, and values of
//! generated types as such multivectors.

use ga::core::dense::{Algebra, Dense};
use ga::core::ops::Element;
use ga::core::{Blade, Field, Metric, Real, Scalar};

use crate::wide::Wide;

/// A value of the oracle.
pub type Value = Dense<Wide>;

/// A geometry with an orthogonal frame.
pub struct Space {
    pub name: &'static str,
    pub algebra: Algebra<Wide>,
    pub frame: Vec<Value>,
    /// The products of basis blades, by their bitmasks.
    table: Vec<Vec<(usize, Wide)>>,
}

impl Space {
    /// The geometry of a metric, its frame by Gram and Schmidt; `adapted` vectors replace those of
    /// the basis where they are given.
    pub fn new(name: &'static str, metric: &Metric, adapted: &[&[f64]]) -> Space {
        let algebra = Algebra::new(metric).expect("few dimensions");
        let count = algebra.dimension();
        let mut frame: Vec<Value> = Vec::new();
        for i in 0..count {
            let mut vector = match adapted.get(i) {
                Some(given) => {
                    let given: Vec<Wide> = given.iter().map(|&x| Wide::from(x)).collect();
                    algebra.vector(&given).expect("all components")
                }
                None => algebra
                    .blade(Blade::new(1 << i), Wide::ONE)
                    .expect("a vector"),
            };
            for other in &frame {
                let square = inner(other, other);
                if square.is_invertible() {
                    let factor = inner(&vector, other) / square;
                    vector = vector.sub(&other.scale(factor)).expect("the same algebra");
                }
            }
            frame.push(vector);
        }
        // Unit vectors where they are not null.
        let unit = |vector: &Value| {
            let square = inner(vector, vector).to_f64();
            match square == 0.0 {
                true => vector.clone(),
                false => vector.scale(Wide::ONE / Wide::from(square.abs()).sqrt()),
            }
        };
        let frame = frame.iter().map(unit).collect();
        let blades = 1_u32 << count;
        let blade = |mask: u32| algebra.blade(Blade::new(mask), Wide::ONE).expect("a blade");
        let product = |a: u32, b: u32| -> Vec<(usize, Wide)> {
            let terms = times(&blade(a), &blade(b)).terms();
            let terms = terms
                .into_iter()
                .map(|(blade, c)| (blade.mask() as usize, c));
            terms.collect()
        };
        let rows = (0..blades).flat_map(|a| (0..blades).map(move |b| (a, b)));
        let table = rows.map(|(a, b)| product(a, b)).collect();
        Space {
            name,
            algebra,
            frame,
            table,
        }
    }

    /// The sign of the square of a vector of the frame.
    pub fn sign(&self, index: usize) -> f64 {
        inner(&self.frame[index], &self.frame[index])
            .to_f64()
            .round()
    }

    /// A generated value.
    pub fn value<X: Element<Number: Into<f64>>>(&self, x: &X) -> Value {
        let mut all = self.algebra.zero().coefficients().to_vec();
        for (i, (blade, sign)) in X::BLADES.iter().enumerate() {
            all[blade.mask() as usize] = Wide::from(x.at(i).into() * f64::from(*sign));
        }
        for (blade, sign, numerator, denominator) in X::FIXED {
            let fixed = f64::from(*sign) * *numerator as f64 / *denominator as f64;
            all[blade.mask() as usize] = Wide::from(fixed);
        }
        self.algebra.from_coefficients(all).expect("all blades")
    }

    /// The generated value nearest to one of the oracle; other blades are dropped.
    pub fn rounded<X: Element<Number: Real>>(&self, value: &Value) -> X {
        X::from_fn(|i| {
            let (blade, sign) = X::BLADES[i];
            X::Number::from_f64(value.coefficient(blade).to_f64() * f64::from(sign))
        })
    }

    /// The exponential, by halving the argument until it is small, summing 26 terms, and
    /// squaring.
    pub fn exp(&self, value: &Value) -> Value {
        let mut halvings = 0;
        let mut size = sizes(value);
        while size > 0.5 {
            size /= 2.0;
            halvings += 1;
        }
        let small = value.scale(Wide::from(0.5_f64.powi(halvings)));
        let one = self.algebra.scalar(Wide::ONE);
        let mut sum = one.clone();
        for n in (1..=26).rev() {
            let factor = Wide::ONE / Wide::from(f64::from(n));
            sum = self
                .times(&small, &sum)
                .scale(factor)
                .add(&one)
                .expect("the same algebra");
        }
        for _ in 0..halvings {
            sum = self.times(&sum, &sum);
        }
        sum
    }

    /// The geometric product, by the table.
    pub fn times(&self, a: &Value, b: &Value) -> Value {
        let (a, b) = (a.coefficients(), b.coefficients());
        let mut product = vec![Wide::ZERO; a.len()];
        for (i, &x) in a.iter().enumerate().filter(|(_, x)| **x != Wide::ZERO) {
            for (j, &y) in b.iter().enumerate().filter(|(_, y)| **y != Wide::ZERO) {
                for &(blade, factor) in &self.table[i * b.len() + j] {
                    product[blade] += x * y * factor;
                }
            }
        }
        self.algebra.from_coefficients(product).expect("all blades")
    }
}

/// The geometric product.
pub fn times(a: &Value, b: &Value) -> Value {
    a.geometric(b).expect("the same algebra")
}

/// The scalar product of vectors.
fn inner(a: &Value, b: &Value) -> Wide {
    times(a, b).coefficient(Blade::SCALAR)
}

/// The sum of the sizes of the coefficients.
fn sizes(value: &Value) -> f64 {
    let sizes = value.coefficients().iter().map(|c| c.to_f64().abs());
    sizes.sum()
}

/// The largest coefficient.
pub fn largest(value: &Value) -> f64 {
    let sizes = value.coefficients().iter().map(|c| c.to_f64().abs());
    sizes.fold(0.0, f64::max)
}

/// The largest difference of two coefficients against the largest coefficient of the second.
pub fn error(found: &Value, expected: &Value) -> f64 {
    let difference = found.sub(expected).expect("the same algebra");
    largest(&difference) / largest(expected).max(f64::MIN_POSITIVE)
}
