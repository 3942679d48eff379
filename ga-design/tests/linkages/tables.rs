//! Forward kinematics of published arms from their tables, against poses computed by others.

use ga_cga::{Motor, Point, Rotor, Vector3};
use ga_design::linkages::{Axis, Chain, Convention, Frame, Freedom, Table, TableError};
use serde_json::Value;

const ROBOTS: &str = include_str!("data/robots.json");

/// An arm with its reference values and the pose that they give.
type Robot = (String, Table, Vec<f64>, [[f64; 4]; 4]);

fn robots() -> Vec<Robot> {
    let file: Value = serde_json::from_str(ROBOTS).unwrap();
    let robots = file["robots"].as_object().unwrap();
    let read = |(name, robot): (&String, &Value)| {
        let (own, table) = Table::from_json(&robot.to_string()).unwrap();
        assert_eq!(own, *name);
        let pose = &robot["example_pose"];
        let values = serde_json::from_value(pose["q"].clone()).unwrap();
        let matrix = serde_json::from_value(pose["T"].clone()).unwrap();
        (own, table, values, matrix)
    };
    robots.iter().map(read).collect()
}

/// Matrices of one row, in the plainest way.
fn transform(row: &Value, value: f64, is_standard: bool) -> [[f64; 4]; 4] {
    let number = |name: &str| row[name].as_f64().unwrap();
    let (mut theta, mut d) = (number("theta"), number("d"));
    if row["joint"] == "P" {
        d = value;
    } else {
        theta = value + number("offset");
    }
    let (st, ct) = theta.sin_cos();
    let rz = [
        [ct, -st, 0.0, 0.0],
        [st, ct, 0.0, 0.0],
        [0.0, 0.0, 1.0, d],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let (sa, ca) = number("alpha").sin_cos();
    let rx = [
        [1.0, 0.0, 0.0, number("a")],
        [0.0, ca, -sa, 0.0],
        [0.0, sa, ca, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    if is_standard {
        product(rz, rx)
    } else {
        product(rx, rz)
    }
}

fn product(a: [[f64; 4]; 4], b: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The largest difference of a frame and a matrix.
fn difference(frame: Frame, matrix: &[[f64; 4]; 4]) -> f64 {
    let found = frame.motor().into_inner().to_matrix().unwrap();
    let pairs = found.iter().flatten().zip(matrix.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn published_arms_reach_their_reference_poses() {
    let robots = robots();
    assert_eq!(robots.len(), 5);
    for (name, table, values, matrix) in robots {
        let pose = table.chain(name.as_str()).pose(&values).unwrap();
        assert!(difference(pose, &matrix) < 1e-12, "{name}");
    }
}

/// Joint values all over their ranges.
fn samples(chain: &Chain) -> Vec<Vec<f64>> {
    let value = |joint: usize, sample: usize| {
        let range = chain.values()[joint].limits.bounded();
        let part = (0.5 + sample as f64 * 0.618_033 + joint as f64 * 0.414_213).fract();
        range.lower + part * (range.upper - range.lower)
    };
    let joints = chain.values().len();
    let pose = |sample| (0..joints).map(|joint| value(joint, sample)).collect();
    (0..50).map(pose).collect()
}

#[test]
fn every_pose_is_the_product_of_the_matrices() {
    let file: Value = serde_json::from_str(ROBOTS).unwrap();
    for (name, table, _, _) in robots() {
        let rows = file["robots"][&name]["rows"].as_array().unwrap();
        let chain = table.chain(name.as_str());
        let is_standard = table.convention == Convention::Standard;
        for values in samples(&chain) {
            let mut matrix =
                std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
            let frames = chain.frames(&values).unwrap();
            for ((row, value), frame) in rows.iter().zip(&values).zip(&frames) {
                matrix = product(matrix, transform(row, *value, is_standard));
                assert!(difference(*frame, &matrix) < 1e-12, "{name} {values:?}");
            }
            assert_eq!(frames.len(), rows.len());
        }
    }
}

#[test]
fn conventions_are_exactly_convertible() {
    for (name, table, _, _) in robots() {
        let other = table.converted();
        let back = other.converted();
        let [one, two, three] = [&table, &other, &back].map(|table| table.chain(name.as_str()));
        assert_ne!(table.convention, other.convention);
        assert_eq!(table.convention, back.convention);
        for values in samples(&one) {
            let matrix = one.pose(&values).unwrap().motor().to_matrix().unwrap();
            assert!(difference(two.pose(&values).unwrap(), &matrix) < 1e-12);
            assert!(difference(three.pose(&values).unwrap(), &matrix) < 1e-12);
        }
    }
}

#[test]
fn links_of_the_dissertation_make_the_same_chain() {
    let quarter = Freedom::Turn(Axis::Z).motion(std::f64::consts::FRAC_PI_2);
    for (name, table, _, _) in robots() {
        let Some(links) = table.links() else {
            assert!(["Panda", "Stanford"].contains(&name.as_str()));
            continue;
        };
        let chain = table.chain(name.as_str());
        for values in samples(&chain) {
            let mut motor = quarter.reverse();
            for ((angle, link), value) in links.iter().zip(&values) {
                motor = motor * Freedom::Turn(Axis::Z).motion(angle + value) * link.motion();
            }
            let matrix = (motor * quarter).to_matrix().unwrap();
            assert!(
                difference(chain.pose(&values).unwrap(), &matrix) < 1e-12,
                "{name}"
            );
        }
    }
}

#[test]
fn screws_are_the_rates_of_the_pose() {
    for (name, table, _, _) in robots() {
        let chain = table.chain(name.as_str());
        for values in samples(&chain).into_iter().take(10) {
            let pose = |joint: usize, step: f64| {
                let mut moved = values.clone();
                moved[joint] += step;
                chain.pose(&moved).unwrap()
            };
            let screws = chain.screws(&values).unwrap();
            for (joint, screw) in screws.into_iter().enumerate() {
                // M(q + h) M(q)⁻¹ is e^{−h S/2}.
                let step = 0.7;
                let turned = pose(joint, step).motor() * pose(joint, 0.0).motor().reverse();
                let own = (screw * (-0.5 * step)).exp();
                let difference = (turned.into_inner() - own).to_array();
                assert!(difference.iter().all(|x| x.abs() < 1e-13), "{name} {joint}");
            }
        }
    }
}

#[test]
fn frames_have_their_axes_planes_and_spheres() {
    let turn = Rotor::about_axis(Vector3::new(1.0, 1.0, 1.0), 2.0).unwrap();
    let frame = Frame::at(Point::at(1.0, -2.0, 0.5), turn).unwrap();
    let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(|axis| frame.axis(axis));
    let position = frame.origin().position();
    for angle in [0.0_f64, 1.0, 2.5] {
        let (sin, cos) = angle.sin_cos();
        let point = Point::from(position + x * (3.0 * cos) + y * (3.0 * sin));
        assert!((point ^ frame.circle_of_rotation(3.0)).norm() < 1e-13);
        assert!((point ^ frame.plane(Axis::Z)).norm() < 1e-13);
        assert!((point | frame.surrounding_sphere(3.0)).s.abs() < 1e-13);
        let on_axis = Point::from(position + z * angle);
        assert!((on_axis ^ frame.line(Axis::Z)).norm() < 1e-13);
    }
    let quaternion = frame.quaternion();
    assert!(quaternion[0] >= 0.0);
    assert!((quaternion.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
    assert_eq!(Frame::new(Motor::default()), None);
    assert_eq!(Frame::new(Motor::identity() * f64::NAN), None);
    let other = frame.then(Freedom::Turn(Axis::Y).motion(0.3));
    assert!(
        (frame.motion_to(other).into_inner() - Freedom::Turn(Axis::Y).motion(0.3).into_inner())
            .norm()
            < 1e-15
    );
}

#[test]
fn wrong_numbers_of_values_are_refused() {
    let (name, table, values, _) = robots().remove(0);
    let chain = table.chain(name.as_str());
    let message = chain.pose(&values[1..]).unwrap_err().to_string();
    assert!(
        message.starts_with("5 joint values for") && message.contains("it takes 6, joint 1, "),
        "{message}"
    );
    let mut wrong = values.clone();
    wrong[2] = f64::INFINITY;
    let message = chain.frames(&wrong).unwrap_err().to_string();
    assert_eq!(message, "the value of joint 3 is inf: it must be finite");
    assert!(chain.screws(&[]).is_err());
}

#[test]
fn what_is_no_table_is_named_with_its_place() {
    for (text, place) in [
        ("{", "no JSON"),
        ("[]", "the table is no object"),
        ("{}", "rows is missing"),
        (r#"{"rows": []}"#, "rows is empty"),
        (r#"{"rows": [{"joint": "R"}]}"#, "convention is missing"),
        (
            r#"{"rows": [{"joint": "R"}], "convention": "craig"}"#,
            r#""standard" or "modified""#,
        ),
        (
            r#"{"rows": [7], "convention": "standard"}"#,
            "rows[0] is no object",
        ),
        (r#"{"rows": [{"joint": "Q"}]}"#, "rows[0].joint must be"),
        (
            r#"{"rows": [{"joint": "R"}, {"joint": "R", "a": "x"}]}"#,
            "rows[1].a is \"x\"",
        ),
        (r#"{"rows": [{"joint": "R", "d": 1e999}]}"#, "no JSON"),
        (
            r#"{"rows": [{"joint": "R", "flip": 1}]}"#,
            "rows[0].flip must be true or false",
        ),
        (
            r#"{"rows": [{"joint": "R", "qlim": [1]}]}"#,
            "rows[0].qlim must be two numbers",
        ),
        (
            r#"{"rows": [{"joint": "R", "qlim": [1, 0]}]}"#,
            "goes from 1 to 0",
        ),
        (
            r#"{"rows": [{"joint": "R"}], "convention": "standard", "base": [1]}"#,
            "base must be a matrix",
        ),
        (
            r#"{"rows": [{"joint": "R"}], "convention": "standard",
                "tool": [[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}"#,
            "tool is no rigid motion",
        ),
    ] {
        let error: TableError = Table::from_json(text).unwrap_err();
        assert!(error.to_string().contains(place), "{text}: {error}");
    }
}
