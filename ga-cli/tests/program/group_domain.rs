//! What `articulate group` tells of the parts of a pattern: fundamental domains, and the positions of groups
//! that repeat in fewer directions.

use crate::run::{directory, run};
use serde_json::Value;

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| value[i].as_f64().expect("a number"))
}

#[test]
fn a_fundamental_domain_is_a_closed_part_of_the_cell() {
    let directory = directory();
    for (number, operations) in [("2", 2.0), ("19", 4.0), ("225", 192.0)] {
        let words = ["group", number, "--domain", "--json", "--out", "domain.glb"];
        let told = run(directory.path(), &words).json();
        let domain = &told["domain"];
        let lengths = ["a", "b", "c"].map(|edge| told["cell"][edge].as_f64().expect("an edge"));
        let [alpha, beta, gamma] = ["alpha", "beta", "gamma"]
            .map(|angle| told["cell"][angle].as_f64().expect("an angle").cos());
        let product: f64 = lengths.iter().product();
        let cell = product
            * (1.0 - alpha * alpha - beta * beta - gamma * gamma + 2.0 * alpha * beta * gamma)
                .sqrt();
        let volume = domain["volume"].as_f64().expect("a volume");
        assert!((volume * operations / cell - 1.0).abs() < 1e-9, "{number}");
        let corners = domain["vertices"].as_array().expect("corners");
        let faces = domain["faces"].as_array().expect("faces");
        let sides: usize = faces
            .iter()
            .map(|face| face["vertices"].as_array().map_or(0, Vec::len))
            .sum();
        // Euler: each edge is a side of two faces.
        assert_eq!(corners.len() + faces.len(), sides / 2 + 2, "{number}");
        for face in faces {
            let normal = vector(&face["normal"]);
            let distance = face["distance"].as_f64().expect("a distance");
            for corner in face["vertices"].as_array().expect("corners of a face") {
                let at = corner.as_u64().expect("the number of a corner") as usize;
                let point = vector(&corners[at]["cart"]);
                let height: f64 = normal.iter().zip(point).map(|(n, x)| n * x).sum();
                assert!((height - distance).abs() < 1e-9, "{number}");
            }
        }
        let file = std::fs::read(directory.path().join("domain.glb")).expect("the file is there");
        let model = gltf::Gltf::from_slice(&file).expect("a valid GLB file");
        let named = |node: gltf::Node| node.name().is_some_and(|name| name.contains("domain"));
        assert!(model.nodes().any(named), "{number}");
    }
}

#[test]
fn domains_are_for_space_groups() {
    let directory = directory();
    for words in [
        ["group", "4/mmm", "--point", "--domain"],
        ["group", "p4g", "--wallpaper", "--domain"],
        ["group", "5", "--rod", "--domain"],
    ] {
        let message = run(directory.path(), &words).message(2);
        assert!(message.contains("--domain"), "{message}");
    }
}

#[test]
fn plane_groups_tell_the_positions_of_international_tables() {
    let directory = directory();
    // International Tables A, section 6: number 12.
    let told = run(directory.path(), &["group", "p4g", "--wallpaper", "--json"]).json();
    let positions: Vec<String> = told["wyckoff"]
        .as_array()
        .expect("positions")
        .iter()
        .map(|position| {
            format!(
                "{}{} {}",
                position["multiplicity"],
                position["letter"].as_str().unwrap_or("?"),
                position["site_symmetry"].as_str().unwrap_or("?")
            )
        })
        .collect();
    let mut sorted = positions.clone();
    sorted.sort();
    assert_eq!(sorted, ["2a 4..", "2b 2.mm", "4c ..m", "8d 1"]);
    let rod = run(directory.path(), &["group", "5", "--rod", "--json"]).json();
    assert!(rod["wyckoff"].as_array().is_some_and(|all| !all.is_empty()));
}
