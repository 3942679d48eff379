//! The pose solver on published arms: random reachable targets, parts of targets, what is out of
//! reach.

use ga_cga::Point;
use ga_design::linkages::{Attitude, Axis, Chain, PoseSolver, Solution, Table, Target};
use serde_json::Value;

fn arms() -> Vec<Chain> {
    let file: Value = serde_json::from_str(include_str!("data/robots.json")).unwrap();
    let robots = file["robots"].as_object().unwrap().values();
    let chain = |robot: &Value| {
        let (name, table) = Table::from_json(&robot.to_string()).unwrap();
        table.chain(name)
    };
    robots.map(chain).collect()
}

/// Reproducible numbers between 0 and 1.
struct Samples(u64);

impl Samples {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn values(&mut self, chain: &Chain) -> Vec<f64> {
        let ranges = chain.values().iter().map(|joint| joint.limits.bounded());
        ranges
            .map(|range| range.lower + self.next() * (range.upper - range.lower))
            .collect()
    }
}

fn solver() -> PoseSolver {
    PoseSolver::default()
}

/// The solution is honest: what it says of its values is what the chain says.
fn assert_honest(chain: &Chain, target: &Target, solution: &Solution) {
    let miss = target.miss(chain.pose(&solution.values).unwrap());
    assert_eq!(miss, solution.miss);
    let reached = miss.position <= 1e-8 && miss.rotation <= 1e-8;
    assert_eq!(reached, solution.converged);
    for (value, joint) in solution.values.iter().zip(chain.values()) {
        assert!(joint.limits.contains(*value));
    }
}

#[test]
fn reachable_poses_are_reached_inside_the_limits() {
    for chain in arms() {
        let mut samples = Samples(7);
        let mut solved = 0;
        for _ in 0..1000 {
            let pose = chain.pose(&samples.values(&chain)).unwrap();
            let target = Target::pose(pose);
            let solution = solver().solve(&chain, &target, None).unwrap();
            assert_honest(&chain, &target, &solution);
            solved += usize::from(solution.converged);
        }
        assert!(solved >= 999, "{}: {solved}", chain.name());
    }
}

#[test]
fn parts_of_a_pose_are_reached_too() {
    for chain in arms() {
        let mut samples = Samples(8);
        for _ in 0..100 {
            let pose = chain.pose(&samples.values(&chain)).unwrap();
            let whole = Target::pose(pose);
            let position = Target::position(pose.origin()).unwrap();
            let drill = Target {
                attitude: Attitude::Along(Axis::Z),
                ..whole
            };
            let height = Target {
                position: [false, false, true],
                attitude: Attitude::Along(Axis::Y),
                ..whole
            };
            for target in [position, drill, height] {
                let solution = solver().solve(&chain, &target, None).unwrap();
                assert_honest(&chain, &target, &solution);
                assert!(solution.converged, "{} {target:?}", chain.name());
            }
            let solution = solver().solve(&chain, &drill, None).unwrap();
            let reached = chain.pose(&solution.values).unwrap();
            assert!((reached.axis(Axis::Z) - pose.axis(Axis::Z)).norm() < 1e-7);
        }
    }
}

#[test]
fn a_target_out_of_reach_is_told_with_the_closest_pose() {
    for chain in arms() {
        for distance in [3.0, 30.0] {
            let far = Point::at(distance, 0.0, 0.5);
            let target = Target::position(far).unwrap();
            let quick = PoseSolver {
                tries: 10,
                ..solver()
            };
            let solution = quick.solve(&chain, &target, None).unwrap();
            assert_honest(&chain, &target, &solution);
            assert!(!solution.converged);
            // The arm is stretched towards it as far as its limits allow.
            assert!(solution.miss.position < distance - 0.5, "{solution:?}");
            assert_eq!(solution.tries, 10);
        }
    }
}

#[test]
fn several_solutions_are_different_and_always_the_same() {
    for chain in arms() {
        let mut samples = Samples(9);
        let values = samples.values(&chain);
        let target = Target::pose(chain.pose(&values).unwrap());
        let found = solver().solutions(&chain, &target, None, 4).unwrap();
        assert!(!found.is_empty());
        for (number, solution) in found.iter().enumerate() {
            assert_honest(&chain, &target, solution);
            for other in &found[..number] {
                let pairs = solution.values.iter().zip(&other.values);
                assert!(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) > 1e-3);
            }
        }
        assert_eq!(found, solver().solutions(&chain, &target, None, 4).unwrap());
        // Started at a solution it stays there.
        let near = solver().solve(&chain, &target, Some(&values)).unwrap();
        assert_eq!(
            (near.values.as_slice(), near.iterations),
            (values.as_slice(), 0)
        );
        assert!(solver().solve(&chain, &target, Some(&values[1..])).is_err());
    }
}
