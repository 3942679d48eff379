//! The same functions on lanes and on dual numbers.

use ga::core::Dual;
use ga::core::ops::Element;
use wide::f64x4;

use crate::families::families;
use crate::{conformal_space, r3_0_1, r4, space};
use ga::cga::cga3;

/// Four samples at a time against each alone.
macro_rules! lanes_agree {
    ($module:ident $Bivector:ident $space:expr) => {{
        let space = $space;
        let samples: Vec<$module::$Bivector> = families(&space)
            .iter()
            .filter(|sample| sample.gap >= 1e-5)
            .map(|sample| space.rounded(&sample.bivector))
            .collect();
        let count = samples.len();
        // Neighbours and strangers share lanes.
        for first in (0..count).step_by(3) {
            let chosen = [0, 1, count / 3, count / 2].map(|step| samples[(first + step) % count]);
            let lanes = $module::$Bivector::<f64x4>::from_fn(|i| {
                f64x4::new(chosen.map(|bivector| bivector.at(i)))
            });
            let (exp, log) = (lanes.exp(), lanes.exp().log());
            let root = lanes.exp().sqrt();
            for (lane, bivector) in chosen.into_iter().enumerate() {
                let alone = bivector.exp();
                close(&exp, lane, &alone, 1e-13);
                if let (Some(log), Some(alone)) = (log, alone.log()) {
                    close(&log, lane, &alone, 1e-9);
                }
                if let (Some(root), Some(alone)) = (root, alone.sqrt()) {
                    close(&root, lane, &alone, 1e-9);
                }
            }
            let all = chosen.iter().all(|bivector| bivector.exp().log().is_some());
            assert_eq!(log.is_some(), all, "{chosen:?}");
        }
    }};
}

fn close<X, Y>(lanes: &X, lane: usize, alone: &Y, allowed: f64)
where
    X: Element<Number = f64x4>,
    Y: Element<Number = f64>,
{
    let sizes = (0..Y::BLADES.len()).map(|i| alone.at(i).abs());
    let largest = sizes.fold(0.0, f64::max);
    for i in 0..Y::BLADES.len() {
        let difference = (lanes.at(i).to_array()[lane] - alone.at(i)).abs();
        assert!(
            difference <= allowed * largest,
            "{difference:e} of {largest}"
        );
    }
}

#[test]
fn lanes() {
    lanes_agree!(r4 Bivector space("R4", 4, 0, 0));
    lanes_agree!(r3_0_1 Bivector space("R3_0_1", 3, 0, 1));
    lanes_agree!(cga3 DualLine conformal_space());
    lanes_agree!(cga3 PointPair conformal_space());
}

/// Derivatives along a line of bivectors against differences.
macro_rules! derivatives_agree {
    ($module:ident $Bivector:ident $from:expr, $along:expr) => {{
        let (from, along) = (
            $module::$Bivector::from($from),
            $module::$Bivector::from($along),
        );
        let dual = $module::$Bivector::<Dual<f64>>::from_fn(|i| Dual::new(from.at(i), along.at(i)));
        let step = 1e-5;
        let (ahead, behind) = ((from + along * step).exp(), (from - along * step).exp());
        let exp = dual.exp();
        for i in 0..exp.to_array().len() {
            let difference = (ahead.at(i) - behind.at(i)) / (2.0 * step);
            assert!((exp.at(i).eps - difference).abs() < 1e-8, "exp {i}");
        }
        let log = exp.log().expect("principal");
        for i in 0..log.to_array().len() {
            assert!((log.at(i).re - from.at(i)).abs() < 1e-12, "log {i}");
            assert!((log.at(i).eps - along.at(i)).abs() < 1e-8, "log {i}");
        }
        let (ahead, behind) = ((from + along * step) * 0.5, (from - along * step) * 0.5);
        let (ahead, behind) = (ahead.exp(), behind.exp());
        let root = exp.sqrt().expect("principal");
        for i in 0..root.to_array().len() {
            let difference = (ahead.at(i) - behind.at(i)) / (2.0 * step);
            assert!((root.at(i).eps - difference).abs() < 1e-8, "sqrt {i}");
        }
    }};
}

#[test]
fn derivatives() {
    let along = [0.2, -0.5, 0.3, 0.7, -0.1, 0.4];
    for size in [0.0, 1e-3, 0.5, 1.2, 2.3] {
        let from = [0.5, 0.3, -0.2, 0.1, 0.6, -0.4].map(|x| x * size);
        derivatives_agree!(r4 Bivector from, along);
        derivatives_agree!(r3_0_1 Bivector from, along);
        derivatives_agree!(cga3 DualLine from, along);
    }
}
