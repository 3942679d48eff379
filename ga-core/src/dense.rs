//! Multivectors with all their coefficients, in any metric chosen at run time.
//!
//! This is the algebra to use when the metric is not known before the program runs, and the
//! reference that everything faster is compared with. It is slow and follows the definitions;
//! it shares no code with [`product`](crate::product) and [`dual`](crate::dual).
//!
//! ```
//! use ga_core::dense::{Algebra, DenseError};
//! use ga_core::{Blade, Metric};
//!
//! let plane = Algebra::<f64>::new(&Metric::from_signature(2, 0, 0)?)?;
//! let quarter_turn = plane.blade(Blade::new(0b11), -core::f64::consts::FRAC_PI_4)?.exp()?;
//! let e1 = plane.vector(&[1.0, 0.0])?;
//! let turned = quarter_turn.apply(&e1)?;
//! assert!((turned.coefficient(Blade::new(0b10)) - 1.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod algebra;
mod dualities;
mod error;
mod exponential;
mod inverse;
mod multiply;
mod multivector;
mod products;

pub use algebra::Algebra;
pub use error::DenseError;
pub use multivector::Dense;
