//! The versors that `articulate group` tells: whether they do what the operations say, by formulas of
//! quaternions that share nothing with the program.

use crate::group::{group, key, texts};
use serde_json::Value;

/// The image of a point under the versor that JSON tells: the reflection in the dual plane n + δ n_∞, then
/// the motor R + q n_∞, as rotation matrix and translation, by formulas of quaternions.
fn moved(versor: &Value, point: [f64; 3]) -> [f64; 3] {
    let mut x = point;
    if let Some(mirror) = versor["mirror"].as_object() {
        let n = ["e1", "e2", "e3"].map(|name| mirror[name].as_f64().unwrap());
        let distance = mirror
            .values()
            .map(|v| v.as_f64().unwrap())
            .next_back()
            .unwrap();
        assert_eq!(mirror.len(), 4);
        let height: f64 = (0..3).map(|i| n[i] * x[i]).sum::<f64>() - distance;
        x = [0, 1, 2].map(|i| x[i] - 2.0 * height * n[i]);
    }
    let motor = versor["motor"].as_object().expect("a motor");
    let part = |name: &str| motor[name].as_f64().unwrap();
    // e23, e31, e12 are minus i, j, k.
    let q = [part("1"), -part("e23"), part("e13"), -part("e12")];
    let product = |a: [f64; 4], b: [f64; 4]| {
        [
            a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
        ]
    };
    let back = [q[0], -q[1], -q[2], -q[3]];
    let turned = product(product(q, [0.0, x[0], x[1], x[2]]), back);
    // (1 − ½ v n_∞) R: the rest of the motor is −½ v n_∞ R = −½ (v R) n_∞ for even R.
    let rest = |names: [&str; 4]| names.map(part);
    let labels: Vec<&str> = motor
        .keys()
        .map(String::as_str)
        .filter(|name| name.contains("ni"))
        .collect();
    assert_eq!(labels.len(), 4, "{labels:?}");
    let find = |blade: &str| {
        labels
            .iter()
            .copied()
            .find(|name| name.replace(['^', '∧'], "") == blade)
            .unwrap()
    };
    let [e1, e2, e3, e123] = rest([find("e1ni"), find("e2ni"), find("e3ni"), find("e123ni")]);
    // v R = −2 (e1, e2, e3, e123); as v is the vector of v R R̃ by components.
    let (s, b12, b13, b23) = (part("1"), part("e12"), part("e13"), part("e23"));
    let (a1, a2, a3, t) = (-2.0 * e1, -2.0 * e2, -2.0 * e3, -2.0 * e123);
    let shift = [
        a1 * s + a2 * b12 + a3 * b13 + t * b23,
        a2 * s - a1 * b12 + a3 * b23 - t * b13,
        a3 * s - a1 * b13 - a2 * b23 + t * b12,
    ];
    [0, 1, 2].map(|i| turned[i + 1] + shift[i])
}

#[test]
fn the_versors_do_what_the_operations_say() {
    for words in [
        ["227", "5"],
        ["14", "5,6,7,100"],
        ["154", "4.9,5.4"],
        ["2", "5,6,7,80,95,110"],
        ["98", "4,7"],
        ["214", "6"],
        ["61", "5,6,7"],
    ] {
        let found = group(&[words[0], "--cell", words[1]]);
        let cell = &found["cell"];
        let number = |name: &str| cell[name].as_f64().unwrap();
        let (a, b, c) = (number("a"), number("b"), number("c"));
        let (ca, cb, cg) = (
            number("alpha").cos(),
            number("beta").cos(),
            number("gamma").cos(),
        );
        let sg = number("gamma").sin();
        let tilt = (ca - cb * cg) / sg;
        let height = (1.0 - cb * cb - tilt * tilt).sqrt();
        // a along x, b in the plane of x and y.
        let cartesian = |f: [f64; 3]| {
            [
                a * f[0] + b * cg * f[1] + c * cb * f[2],
                b * sg * f[1] + c * tilt * f[2],
                c * height * f[2],
            ]
        };
        let point = [0.13, 0.29, 0.41];
        let versors = found["versors"].as_array().expect("a list");
        assert_eq!(
            versors.len(),
            found["operations"].as_array().map_or(0, Vec::len)
        );
        for (versor, operation) in versors.iter().zip(texts(&found["operations"])) {
            assert_eq!(versor["operation"], operation.as_str());
            let (rotation, shift) = key(&operation);
            let image = [0, 1, 2].map(|i| {
                let turned: f64 = (0..3).map(|j| f64::from(rotation[i][j]) * point[j]).sum();
                turned + shift[i] as f64 / 24.0
            });
            let (expected, found) = (cartesian(image), moved(versor, cartesian(point)));
            for (one, other) in expected.iter().zip(found) {
                assert!(
                    (one - other).abs() < 1e-9,
                    "{words:?} {operation}: {expected:?} {found:?}"
                );
            }
        }
    }
}
