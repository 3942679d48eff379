//! Decides how versors are told in JSON: by their coefficients, each under the name of its blade.

use ga_core::Element;
use ga_design::crystallography::Isometry;
use serde::{Serialize, Serializer};

/// Coefficients below this are rounding of numbers near 1.
const ROUNDING: f64 = 1e-13;

/// A rigid motion, with or without a reflection that comes first.
#[derive(Debug, Serialize)]
pub struct Versor {
    /// The operation that it is, as a triplet; nothing for point groups.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub operation: Option<String>,
    /// The dual plane of the reflection.
    pub mirror: Option<Coefficients>,
    /// The motor that follows.
    pub motor: Coefficients,
}

/// The coefficients of an element with the names of their blades.
#[derive(Debug)]
pub struct Coefficients(Vec<(&'static str, f64)>);

impl Versor {
    /// The versor of an operation.
    pub fn new(operation: Option<String>, isometry: &Isometry) -> Self {
        Self {
            operation,
            mirror: isometry.mirror.as_ref().map(Coefficients::of),
            motor: Coefficients::of(&isometry.motor),
        }
    }
}

impl Coefficients {
    fn of<X: Element<Number = f64>>(element: &X) -> Self {
        let labels = X::LABELS.iter().enumerate();
        Self(
            labels
                .map(|(at, label)| (*label, plain(element.at(at))))
                .collect(),
        )
    }
}

impl Serialize for Coefficients {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(label, value)| (label, value)))
    }
}

/// A number without the rounding of a zero, and without its sign.
pub fn plain(value: f64) -> f64 {
    if value.abs() < ROUNDING { 0.0 } else { value }
}
