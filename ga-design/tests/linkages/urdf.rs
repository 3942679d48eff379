//! Robots from URDF: poses against plain matrices, and all that makes no tree.

use ga_design::linkages::{PoseSolver, Target, Tree};

type Matrix = [[f64; 4]; 4];

/// A robot with every kind of joint, two tips and a gripper whose fingers mimic each other.
const ROBOT: &str = r#"<robot name="everything">
  <link name="floor"/> <link name="base"/> <link name="upper"/> <link name="slide"/>
  <link name="hand"/> <link name="left"/> <link name="right"/> <link name="camera"/>
  <joint name="stand" type="fixed">
    <origin xyz="0 0 0.4" rpy="0 0 0.5"/> <parent link="floor"/> <child link="base"/>
  </joint>
  <joint name="shoulder" type="revolute">
    <origin xyz="0.1 0.2 0.3" rpy="0.3 -0.4 0.5"/> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 1 0"/> <limit lower="-2" upper="2.5" effort="1" velocity="1"/>
  </joint>
  <joint name="rail" type="prismatic">
    <origin xyz="0.5 0 0" rpy="0 1.5707963267948966 0"/> <parent link="upper"/> <child link="slide"/>
    <axis xyz="1 1 0"/> <limit lower="-0.2" upper="0.3" effort="1" velocity="1"/>
  </joint>
  <joint name="wrist" type="continuous">
    <origin xyz="0 0 0.2" rpy="1 2 3"/> <parent link="slide"/> <child link="hand"/>
    <axis xyz="0 0 -1"/>
  </joint>
  <joint name="finger" type="prismatic">
    <origin xyz="0 0.05 0.1"/> <parent link="hand"/> <child link="left"/>
    <axis xyz="0 1 0"/> <limit lower="0" upper="0.04" effort="1" velocity="1"/>
  </joint>
  <joint name="other_finger" type="prismatic">
    <origin xyz="0 -0.05 0.1"/> <parent link="hand"/> <child link="right"/>
    <axis xyz="0 1 0"/> <limit lower="-0.04" upper="0" effort="1" velocity="1"/>
    <mimic joint="finger" multiplier="-1" offset="0.01"/>
  </joint>
  <joint name="mount" type="fixed">
    <origin xyz="0 0 0.1"/> <parent link="base"/> <child link="camera"/>
  </joint>
</robot>"#;

fn product(a: Matrix, b: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// What URDF says: roll, pitch, yaw about fixed axes, then the translation.
fn origin([x, y, z]: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Matrix {
    let about = |axis: [f64; 3], angle: f64| turn(axis, angle);
    let turned = product(
        about([0.0, 0.0, 1.0], yaw),
        product(about([0.0, 1.0, 0.0], pitch), about([1.0, 0.0, 0.0], roll)),
    );
    product(shift([x, y, z]), turned)
}

fn shift([x, y, z]: [f64; 3]) -> Matrix {
    [
        [1.0, 0.0, 0.0, x],
        [0.0, 1.0, 0.0, y],
        [0.0, 0.0, 1.0, z],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// Rodrigues' formula for a unit axis.
fn turn([x, y, z]: [f64; 3], angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    let v = 1.0 - c;
    [
        [c + x * x * v, x * y * v - z * s, x * z * v + y * s, 0.0],
        [y * x * v + z * s, c + y * y * v, y * z * v - x * s, 0.0],
        [z * x * v - y * s, z * y * v + x * s, c + z * z * v, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

fn assert_near(found: Matrix, expected: Matrix) {
    for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((a - b).abs() < 1e-14, "{found:?} {expected:?}");
    }
}

#[test]
fn poses_are_what_urdf_says() {
    let tree = Tree::from_urdf(ROBOT).unwrap();
    assert_eq!(
        (tree.name(), tree.tips()),
        ("everything", vec!["left", "right", "camera"])
    );
    let chain = tree.chain(Some("right")).unwrap();
    let names: Vec<&str> = chain
        .values()
        .iter()
        .map(|value| value.name.as_str())
        .collect();
    // The finger that moves the other one is not on the way, but gives the value.
    assert_eq!(names, ["shoulder", "rail", "wrist", "finger"]);
    let values = [0.7, -0.1, 5.0, 0.02];
    let half = 0.5_f64.sqrt();
    let hand = [
        origin([0.0, 0.0, 0.4], [0.0, 0.0, 0.5]),
        origin([0.1, 0.2, 0.3], [0.3, -0.4, 0.5]),
        turn([0.0, 1.0, 0.0], 0.7),
        origin([0.5, 0.0, 0.0], [0.0, std::f64::consts::FRAC_PI_2, 0.0]),
        shift([-0.1 * half, -0.1 * half, 0.0]),
        origin([0.0, 0.0, 0.2], [1.0, 2.0, 3.0]),
        turn([0.0, 0.0, -1.0], 5.0),
    ];
    let hand = hand.into_iter().reduce(product).unwrap();
    let frames = chain.frames(&values).unwrap();
    assert_eq!(frames.len(), 5);
    assert_near(frames[3].motor().to_matrix().unwrap(), hand);
    let right = product(hand, shift([0.0, -0.05 - 0.02 + 0.01, 0.1]));
    assert_near(
        chain.pose(&values).unwrap().motor().to_matrix().unwrap(),
        right,
    );
    // The way to the camera has no joints.
    let camera = tree.chain(Some("camera")).unwrap();
    assert!(camera.values().is_empty());
    assert!(camera.pose(&[]).is_ok());
}

#[test]
fn chains_of_urdf_are_solved() {
    let chain = Tree::from_urdf(ROBOT)
        .unwrap()
        .chain(Some("right"))
        .unwrap();
    let pose = chain.pose(&[0.7, -0.1, 1.0, 0.02]).unwrap();
    let solution = PoseSolver::default()
        .solve(&chain, &Target::pose(pose), None)
        .unwrap();
    assert!(solution.converged, "{solution:?}");
}

#[test]
fn what_makes_no_tree_or_no_chain_is_named() {
    let link = |name: &str| format!("<link name=\"{name}\"/>");
    let joint = |name: &str, [parent, child]: [&str; 2], more: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/>\
             <child link=\"{child}\"/>{more}<limit lower=\"-1\" upper=\"1\" effort=\"1\" \
             velocity=\"1\"/></joint>"
        )
    };
    let robot = |parts: &[String]| format!("<robot name=\"r\">{}</robot>", parts.concat());
    let (a, b, c) = (link("a"), link("b"), link("c"));
    let axis = "<axis xyz=\"0 0 1\"/>";
    for (parts, problem) in [
        (vec![], "has no link"),
        (vec![a.clone(), a.clone()], "two links named `a`"),
        (
            vec![a.clone(), joint("j", ["a", "x"], axis)],
            "`j` hangs on link `x`, which is not there",
        ),
        (vec![a.clone(), b.clone()], "links a, b hang on nothing"),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], axis),
                joint("j", ["a", "b"], axis),
            ],
            "two joints named `j`",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], axis),
                joint("k", ["a", "b"], axis),
            ],
            "child of joints `j` and `k`",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], axis),
                joint("k", ["b", "a"], axis),
            ],
            "link `a` hangs on itself, by way of k, j",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                c.clone(),
                joint("j", ["b", "c"], axis),
                joint("k", ["c", "b"], axis),
            ],
            "hangs on itself",
        ),
        (
            vec![a.clone(), joint("j", ["a", "a"], axis)],
            "link `a` hangs on itself",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], "<axis xyz=\"0 0 0\"/>"),
            ],
            "axis without direction",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], axis).replace("upper=\"1\"", "upper=\"-3\""),
            ],
            "limits from -1 to -3",
        ),
        (
            vec![
                a.clone(),
                b.clone(),
                joint("j", ["a", "b"], "<origin xyz=\"0 inf 0\"/>"),
            ],
            "has the number inf",
        ),
    ] {
        let text = robot(&parts);
        let message = Tree::from_urdf(&text).unwrap_err().to_string();
        assert!(message.contains(problem), "{text}: {message}");
    }
    for text in ["", "<robot", "{}", "<robot name=\"r\"><link/></robot>"] {
        let message = Tree::from_urdf(text).unwrap_err().to_string();
        assert!(message.starts_with("no URDF: "), "{text}: {message}");
    }
    let tree = Tree::from_urdf(ROBOT).unwrap();
    let message = tree.chain(None).unwrap_err().to_string();
    assert_eq!(
        message,
        "the robot has several tips; choose one of left, right, camera"
    );
    let message = tree.chain(Some("tail")).unwrap_err().to_string();
    assert!(message.contains("no link `tail`"), "{message}");
    let floating = ROBOT.replace("\"continuous\"", "\"floating\"");
    let message = Tree::from_urdf(&floating)
        .unwrap()
        .chain(Some("left"))
        .unwrap_err();
    assert!(message.to_string().contains("`wrist` floats"), "{message}");
    for (other, problem) in [
        ("other_finger", "itself"),
        ("thumb", "`thumb`, which is not there"),
    ] {
        let mimic = ROBOT.replace(
            "mimic joint=\"finger\"",
            &format!("mimic joint=\"{other}\""),
        );
        let message = Tree::from_urdf(&mimic)
            .unwrap()
            .chain(Some("right"))
            .unwrap_err();
        assert!(message.to_string().contains(problem), "{message}");
    }
}
