//! Exponentials, logarithms and roots where neighbours take other forms: an element has the value
//! that it has alone, to the last bit but for general logarithms, and that of single numbers up to
//! rounding.

use ga_core::Element;
use ga_lanes::Batch;

use super::plane;
use super::samples::{elements, on_every_target};
use super::space;

/// What a function gives for the elements of a batch, for each of them in a batch of its own, and
/// for each as single numbers.
macro_rules! assert_alike {
    ($elements:expr, $tolerance:expr, $beside:expr, $($method:ident)*) => {{$(
        let batch = Batch::from_slice(&$elements).$method();
        for (index, element) in $elements.iter().enumerate() {
            let alone = Batch::from_slice(&[*element]).$method().get(0);
            let own = batch.get(index);
            assert_eq!(
                own.is_some(),
                alone.is_some(),
                "{} of {element} beside others",
                stringify!($method)
            );
            if let (Some(own), Some(alone)) = (&own, &alone) {
                assert!(distance(own, alone) <= $beside, "{own} beside others, {alone} alone");
            }
            let single = Option::from(element.$method());
            assert_eq!(own.is_some(), single.is_some(), "{} of {element}", stringify!($method));
            if let (Some(own), Some(single)) = (own, single) {
                let distance = distance(&own, &single);
                assert!(distance <= $tolerance, "{own} instead of {single}");
            }
        }
    )*}};
}

/// The largest difference of coefficients, over the largest coefficient where that is above 1.
fn distance<X: Element<Number: Into<f64>>>(one: &X, other: &X) -> f64 {
    let largest = |number: fn(f64, f64) -> f64| {
        let pairs = (0..X::BLADES.len()).map(|i| (one.at(i).into(), other.at(i).into()));
        pairs.fold(0.0, |largest: f64, (a, b)| largest.max(number(a, b).abs()))
    };
    largest(|a, b| a - b) / largest(|_, b| b).max(1.0)
}

macro_rules! all {
    ($float:ident $tolerance:expr) => {{
        let lines = elements::<space::Line<$float>>(40, 1);
        // Turns of nothing, of a little, and of several times around; pitches; none.
        let sizes = [0.0, 1e-3, 0.3, 1.0, 2.5, 20.0];
        let generators: Vec<_> = lines
            .iter()
            .zip(sizes.into_iter().cycle())
            .map(|(line, size)| *line * size as $float)
            .collect();
        assert_alike!(generators, $tolerance, 0.0, exp);
        // Unit motors, multiples, the negative, one near −1, one at the pole, no versor.
        let mut motors: Vec<_> = generators.iter().map(|line| (*line * 0.1).exp()).collect();
        motors[3] *= 2.0;
        motors[20] = -motors[20];
        motors[21] = -(lines[21] * 1e-3).exp();
        motors[30] = space::Motor::from_fn(|position| if position == 0 { -1.0 } else { 0.0 });
        motors[35] = space::Motor::from_fn(|_| 0.0);
        assert_alike!(motors, 1e4 * $tolerance, 0.0, log sqrt);

        let pairs = elements::<plane::Pair<$float>>(40, 2);
        assert_alike!(pairs, $tolerance, 0.0, exp);
        let mut versors: Vec<_> = pairs.iter().map(|pair| (*pair * 0.4).exp()).collect();
        versors[7] *= 0.5;
        versors[8] = -versors[8];
        versors[9] = plane::Even::from_fn(|_| 0.0);
        // Their logarithms take as many halvings as the neighbour that takes most.
        assert_alike!(versors, 1e4 * $tolerance, $tolerance, log);
        assert_alike!(versors, 1e4 * $tolerance, 0.0, sqrt);
    }};
}

#[test]
fn functions_do_not_depend_on_neighbours() {
    on_every_target(|| {
        all!(f32 1e-5);
        all!(f64 1e-13);
    });
}
