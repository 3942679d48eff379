//! Closed loops: Bennett's linkage by relation, by spheres and by the general solver; mobility;
//! motion with its dead and branch points; what is refused.

use std::f64::consts::{FRAC_PI_2, PI};

use ga_design::linkages::{Bennett, ClosedLoop, Link, LoopError, Turn};

fn links(rows: &[(f64, f64)]) -> Vec<Link> {
    let link = |&(length, skew): &(f64, f64)| Link {
        length,
        skew,
        offset: 0.0,
    };
    rows.iter().map(link).collect()
}

fn bennetts() -> Vec<Bennett> {
    let mut all = Vec::new();
    for (a, b) in [(1.0, 1.0), (1.0, 0.8), (0.7, 0.5), (3.0, 2.9)] {
        for degrees in [10.0_f64, 45.0, 60.0, 90.0, 120.0, -30.0] {
            all.extend(Bennett::new([a, b], degrees.to_radians()));
        }
    }
    assert!(all.len() > 20);
    all
}

#[test]
fn bennett_linkages_close_all_around() {
    for bennett in bennetts() {
        for step in -36..=36 {
            let input = f64::from(step) * PI / 36.0;
            let state = bennett.state(input).unwrap();
            assert!(state.residual <= 1e-12, "{bennett:?} {input}: {state:?}");
            let points = bennett
                .closed_loop()
                .unwrap()
                .points(&state.angles)
                .unwrap();
            for (number, link) in bennett.links().iter().enumerate() {
                let distance = points[number].distance(points[(number + 1) % 4]);
                assert!((distance - link.length).abs() <= 1e-12);
            }
        }
    }
}

#[test]
fn spheres_and_plane_give_the_same_states() {
    for bennett in bennetts() {
        for step in 1..36 {
            for sign in [1.0, -1.0] {
                let input = sign * f64::from(step) * PI / 36.0;
                let [state, built] =
                    [bennett.state(input), bennett.by_spheres(input)].map(Result::unwrap);
                for (a, b) in state.angles.iter().zip(&built.angles) {
                    let difference = (a - b).rem_euclid(2.0 * PI);
                    let difference = difference.min(2.0 * PI - difference);
                    assert!(
                        difference < 1e-6,
                        "{bennett:?} {input}: {state:?} {built:?}"
                    );
                }
                assert!(built.residual < 1e-7, "{bennett:?} {input}: {built:?}");
            }
        }
    }
}

#[test]
fn the_general_solver_finds_bennetts_states() {
    for bennett in bennetts() {
        let closed_loop = bennett.closed_loop().unwrap();
        let state = closed_loop.closed(0, 1.1).unwrap();
        assert!(state.residual <= 1e-12);
        let expected = bennett.state(1.1).unwrap();
        let mobility = closed_loop.mobility(&expected.angles).unwrap();
        assert_eq!(
            (mobility.kutzbach, mobility.rank, mobility.freedoms),
            (-2, 3, 1)
        );
    }
}

#[test]
fn a_planar_four_bar_follows_freudenstein() {
    // Ground 4, crank 2, coupler 3.5, rocker 3: the crank turns all around (Grashof).
    let [ground, crank, coupler, rocker] = [4.0, 2.0, 3.5, 3.0];
    let rows = [(crank, 0.0), (coupler, 0.0), (rocker, 0.0), (ground, 0.0)];
    let closed_loop = ClosedLoop::new(links(&rows)).unwrap();
    let start = closed_loop.closed(0, 1.0).unwrap();
    let motion = closed_loop.moved(&start, 0, 1.0 + 2.0 * PI, 72).unwrap();
    assert_eq!(motion.states.len(), 73);
    assert!(motion.turns.is_empty(), "{:?}", motion.turns);
    for state in &motion.states {
        assert!(state.residual <= 1e-12);
        let points = closed_loop.points(&state.angles).unwrap();
        // The last joint stands where the ground ends, and the distances are those of the links.
        assert!((points[3].distance(points[0]) - ground).abs() < 1e-11);
        assert!((points[2].distance(points[3]) - rocker).abs() < 1e-11);
        assert!((points[1].distance(points[2]) - coupler).abs() < 1e-11);
        // Freudenstein: K1 cos ψ − K2 cos φ + K3 = cos(φ − ψ), with angles from the ground.
        let [p, q, r, s] = [0, 1, 2, 3].map(|i| points[i].position());
        let along = (s - p) / ground;
        let across = |v: ga_cga::Vector3| {
            let area: ga_cga::Bivector3 = along ^ v;
            area.e12
        };
        let angle = |v: ga_cga::Vector3| across(v).atan2((along | v).s);
        let (phi, psi) = (angle(q - p), angle(r - s));
        let (k1, k2) = (ground / crank, ground / rocker);
        let k3 = (ground * ground + crank * crank + rocker * rocker - coupler * coupler)
            / (2.0 * crank * rocker);
        assert!((k1 * psi.cos() - k2 * phi.cos() + k3 - (phi - psi).cos()).abs() < 1e-10);
    }
    let mobility = closed_loop.mobility(&start.angles).unwrap();
    assert_eq!(
        (mobility.kutzbach, mobility.rank, mobility.freedoms),
        (-2, 3, 1)
    );
}

#[test]
fn a_crank_that_cannot_turn_around_ends_at_its_dead_point() {
    // No Grashof: crank 3 on ground 4 with coupler and rocker 2.
    let rows = [(3.0, 0.0), (2.0, 0.0), (2.0, 0.0), (4.0, 0.0)];
    let closed_loop = ClosedLoop::new(links(&rows)).unwrap();
    let start = closed_loop.closed(0, 2.0 * PI / 3.0 + 0.7).unwrap();
    let motion = closed_loop
        .moved(&start, 0, start.angles[0] + 2.0 * PI, 90)
        .unwrap();
    let Some(Turn::Dead { angle }) = motion.turns.last().copied() else {
        panic!("it turns around: {:?}", motion.turns);
    };
    // There coupler and rocker are stretched or folded: 4² = 3² + 4² − 24 cos of the angle between.
    let points = closed_loop
        .points(&motion.states.last().unwrap().angles)
        .unwrap();
    assert!(
        (points[1].distance(points[3]) - 4.0).abs() < 1e-6,
        "{angle}"
    );
    for state in &motion.states {
        assert!(state.residual <= 1e-12);
    }
}

#[test]
fn a_parallelogram_branches_where_it_is_flat() {
    let rows = [(2.0, 0.0), (3.0, 0.0), (2.0, 0.0), (3.0, 0.0)];
    let closed_loop = ClosedLoop::new(links(&rows)).unwrap();
    let start = closed_loop.closed(0, FRAC_PI_2).unwrap();
    let motion = closed_loop.moved(&start, 0, FRAC_PI_2 + PI, 60).unwrap();
    assert!(
        motion
            .turns
            .iter()
            .any(|turn| matches!(turn, Turn::Branch { .. })),
        "{:?}",
        motion.turns
    );
}

#[test]
fn impossible_linkages_are_told_why() {
    let message = Bennett::new([0.5, 1.0], 80_f64.to_radians())
        .unwrap_err()
        .to_string();
    assert!(message.contains("a₂ sin α₁/a₁ is 1.96"), "{message}");
    for (lengths, skew, what) in [
        ([0.0, 1.0], 0.5, "the length a₁ is 0"),
        ([1.0, f64::NAN], 0.5, "the length a₂ is NaN"),
        ([1.0, f64::INFINITY], 0.5, "the length a₂ is inf"),
        ([1.0, 1.0], 4.0, "the skew α₁ is 4"),
        ([1.0, 1.0], f64::NAN, "the skew α₁ is NaN"),
    ] {
        let message = Bennett::new(lengths, skew).unwrap_err().to_string();
        assert!(message.starts_with(what), "{message}");
    }
    let bennett = Bennett::new([1.0, 1.0], 0.5).unwrap();
    assert!(bennett.state(f64::NAN).is_err());
    assert!(bennett.by_spheres(f64::INFINITY).is_err());
    assert_eq!(
        ClosedLoop::new(links(&[(1.0, 0.0), (1.0, 0.0)])),
        Err(LoopError::FewLinks { given: 2 })
    );
    // Sides 1, 1 and 3 make no triangle with a fourth of 0.5.
    let open = ClosedLoop::new(links(&[(1.0, 0.0), (1.0, 0.0), (3.0, 0.0), (0.5, 0.0)])).unwrap();
    let message = open.closed(0, 0.3).unwrap_err().to_string();
    assert!(
        message.contains("does not close with joint 1 at 0.3 rad"),
        "{message}"
    );
    assert!(open.frames(&[0.0; 3]).is_err());
    let message = open.closed(9, 0.3).unwrap_err().to_string();
    assert_eq!(message, "there is no joint 10: the loop has 4");
    assert!(open.closed(0, f64::NAN).is_err());
}
