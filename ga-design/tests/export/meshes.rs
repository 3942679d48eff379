//! Shapes keep their invariants: Euler characteristic, outward faces, unit normals, volume, bounds.

use ga_design::mesh::{self, Ends, Mesh, MeshError};
use std::collections::{HashMap, HashSet};
use std::f64::consts::{PI, TAU};

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The signed volume by the divergence theorem: positive when faces wind anticlockwise from outside.
fn volume(mesh: &Mesh) -> f64 {
    let corner = |i: u32| mesh.positions()[i as usize];
    let sixfold: f64 = mesh
        .triangles()
        .iter()
        .map(|&[a, b, c]| dot(corner(a), cross(corner(b), corner(c))))
        .sum();
    sixfold / 6.0
}

/// V − E + F with vertices of one place taken as one; panics unless every edge is run through once
/// in each direction, which is what makes a surface closed and consistently oriented.
fn euler_of_closed(mesh: &Mesh) -> i64 {
    let key = |p: [f64; 3]| p.map(|c| (c * 1e7).round() as i64);
    let mut numbers = HashMap::new();
    let vertex: Vec<usize> = mesh
        .positions()
        .iter()
        .map(|&p| {
            let next = numbers.len();
            *numbers.entry(key(p)).or_insert(next)
        })
        .collect();
    let mut edges = HashSet::new();
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| vertex[i as usize]);
        for edge in [(a, b), (b, c), (c, a)] {
            assert!(edges.insert(edge), "an edge is used twice in one direction");
        }
    }
    assert!(
        edges.iter().all(|&(a, b)| edges.contains(&(b, a))),
        "the surface has a hole"
    );
    numbers.len() as i64 - edges.len() as i64 / 2 + mesh.triangles().len() as i64
}

/// Every normal is of unit length and points to the same side as the faces around it.
fn assert_normals_outward(mesh: &Mesh) {
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| mesh.positions()[i as usize]);
        let face = cross(subtract(b, a), subtract(c, a));
        for &vertex in triangle {
            let normal = mesh.normals()[vertex as usize];
            assert!((dot(normal, normal) - 1.0).abs() < 1e-12);
            assert!(dot(normal, face) > 0.0);
        }
    }
}

#[test]
fn spheres_are_closed_round_and_outward() {
    for subdivisions in 0..5 {
        let sphere = mesh::icosphere(subdivisions).unwrap();
        assert_eq!(euler_of_closed(&sphere), 2);
        assert_eq!(
            sphere.triangles().len(),
            20 * 4_usize.pow(subdivisions as u32)
        );
        assert_eq!(
            sphere.positions().len(),
            10 * 4_usize.pow(subdivisions as u32) + 2
        );
        assert_normals_outward(&sphere);
        assert!(
            sphere
                .positions()
                .iter()
                .all(|&p| (dot(p, p) - 1.0).abs() < 1e-12)
        );
    }
    let fine = mesh::icosphere(5).unwrap();
    assert!((volume(&fine) - 4.0 * PI / 3.0).abs() < 0.005);
    let globe = mesh::uv_sphere(48, 24).unwrap();
    assert_eq!(euler_of_closed(&globe), 2);
    assert_eq!(globe.positions().len(), 48 * 23 + 2);
    assert_normals_outward(&globe);
    assert!((volume(&globe) - 4.0 * PI / 3.0).abs() < 0.04);
}

#[test]
fn the_smallest_sphere_is_the_regular_icosahedron() {
    let solid = mesh::icosphere(0).unwrap();
    // Volume of the icosahedron in the unit sphere: edge a = 4/√(10 + 2√5), V = 5(3 + √5)a³/12.
    let edge = 4.0 / (10.0 + 2.0 * 5.0_f64.sqrt()).sqrt();
    let exact = 5.0 * (3.0 + 5.0_f64.sqrt()) * edge.powi(3) / 12.0;
    assert!((volume(&solid) - exact).abs() < 1e-12);
}

#[test]
fn solids_are_closed_with_the_right_volume() {
    let inscribed = |segments: f64| segments / TAU * (TAU / segments).sin();
    let rod = mesh::cylinder([1.0, 2.0, 3.0], [1.0, 5.0, 7.0], 0.5, 24).unwrap();
    assert_eq!(euler_of_closed(&rod), 2);
    assert_normals_outward(&rod);
    assert!((volume(&rod) - PI * 0.25 * 5.0 * inscribed(24.0)).abs() < 1e-9);
    let cone = mesh::cone([0.0; 3], [0.0, 0.0, 3.0], 1.0, 24).unwrap();
    assert_eq!(euler_of_closed(&cone), 2);
    assert_normals_outward(&cone);
    assert!((volume(&cone) - PI * inscribed(24.0)).abs() < 1e-9);
    let ring = mesh::torus([1.0, 1.0, 1.0], [1.0, 2.0, -1.0], 2.0, 0.5, 96, 48).unwrap();
    assert_eq!(euler_of_closed(&ring), 0);
    assert_normals_outward(&ring);
    let exact = 2.0 * PI * PI * 2.0 * 0.25;
    assert!((volume(&ring) / exact - 1.0).abs() < 0.01);
}

#[test]
fn a_closed_tube_along_a_knot_is_a_torus_of_even_thickness() {
    let knot: Vec<[f64; 3]> = (0..200)
        .map(|i| {
            let t = TAU * f64::from(i) / 200.0;
            let wide = 2.0 + 0.7 * (3.0 * t).cos();
            [
                wide * (2.0 * t).cos(),
                wide * (2.0 * t).sin(),
                0.7 * (3.0 * t).sin(),
            ]
        })
        .collect();
    let tube = mesh::tube(&knot, Ends::Closed, 0.2, 12).unwrap();
    assert_eq!(euler_of_closed(&tube), 0);
    assert_normals_outward(&tube);
    // The frame closes: no strip is longer across the seam than elsewhere, which a twist would cause.
    let longest = |ring: usize| {
        (0..12)
            .map(|j| {
                let from = tube.positions()[ring * 12 + j];
                let to = tube.positions()[(ring + 1) % 200 * 12 + j];
                dot(subtract(from, to), subtract(from, to)).sqrt()
            })
            .fold(0.0, f64::max)
    };
    let typical = (0..199).map(longest).fold(0.0, f64::max);
    assert!(longest(199) <= typical * 1.001);
}

#[test]
fn a_bent_tube_keeps_the_thickness_of_its_straight_parts() {
    let bend = [[-5.0, 0.0, 0.0], [0.0; 3], [0.0, 5.0, 0.0]];
    let tube = mesh::tube(&bend, Ends::Capped, 1.0, 64).unwrap();
    assert_eq!(euler_of_closed(&tube), 2);
    // The outer corner of the mitre is the corner of a square of side one.
    let [_, greatest] = tube.bounds();
    assert!((greatest[0] - 1.0).abs() < 0.01 && (greatest[2] - 1.0).abs() < 0.01);
    let [least, _] = tube.bounds();
    assert!((least[1] + 1.0).abs() < 0.01);
}

#[test]
fn a_line_that_turns_back_on_itself_has_a_tube() {
    let hairpin = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]];
    let tube = mesh::tube(&hairpin, Ends::Capped, 0.1, 8).unwrap();
    assert_eq!(tube.triangles().len(), 2 * 8 * 2 + 2 * 8);
}

#[test]
fn a_cell_has_twelve_edges_and_eight_corners() {
    let cell = [[2.0, 0.0, 0.0], [0.5, 3.0, 0.0], [0.3, 0.4, 4.0]];
    let edges = mesh::cell_edges([1.0, 1.0, 1.0], cell);
    assert_eq!(edges.len(), 12);
    let key = |p: [f64; 3]| p.map(|c| (c * 1e6).round() as i64);
    let corners: HashSet<_> = edges.iter().flatten().map(|&p| key(p)).collect();
    assert_eq!(corners.len(), 8);
    let frame = mesh::box_edges([0.0; 3], cell, 0.05, 8).unwrap();
    let [least, greatest] = frame.bounds();
    assert!((least[2] + 0.05).abs() < 0.01 && (greatest[2] - 4.05).abs() < 0.01);
}

#[test]
fn what_makes_no_mesh_is_refused() {
    let corner = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let refused = |positions, triangles| Mesh::from_triangles(positions, triangles).unwrap_err();
    assert_eq!(refused(vec![], vec![[0, 1, 2]]), MeshError::Empty);
    assert_eq!(refused(corner.clone(), vec![]), MeshError::Empty);
    let index = refused(corner.clone(), vec![[0, 1, 3]]);
    assert!(matches!(index, MeshError::Index { vertex: 3, .. }));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e19] {
        let mut broken = corner.clone();
        broken[1][2] = bad;
        let error = refused(broken, vec![[0, 1, 2]]);
        assert!(matches!(error, MeshError::Coordinate { .. }), "{error}");
        let line = [[0.0; 3], [bad, 0.0, 0.0]];
        assert!(mesh::tube(&line, Ends::Capped, 0.1, 8).is_err());
        assert!(mesh::tube(&corner, Ends::Closed, bad, 8).is_err());
        assert!(mesh::torus([bad; 3], [0.0, 0.0, 1.0], 1.0, 0.1, 8, 8).is_err());
        assert!(mesh::cone([0.0; 3], [bad, 0.0, 1.0], 1.0, 8).is_err());
        assert!(mesh::arrow([0.0; 3], [bad, 0.0, 1.0], 1.0, 8).is_err());
        assert!(mesh::disc([0.0; 3], [bad, 0.0, 1.0], 1.0, 8).is_err());
        assert!(mesh::parallelogram([0.0; 3], [bad, 0.0, 1.0], [1.0, 0.0, 0.0]).is_err());
    }
    let normals = vec![[0.0, 0.0, 0.5]; 3];
    let error = Mesh::new(corner.clone(), normals, vec![[0, 1, 2]]).unwrap_err();
    assert!(matches!(error, MeshError::Normal { .. }));
    let error = Mesh::new(corner.clone(), vec![], vec![[0, 1, 2]]).unwrap_err();
    assert!(matches!(error, MeshError::Lengths { .. }));
    for radius in [0.0, -1.0] {
        assert!(mesh::cylinder([0.0; 3], [1.0; 3], radius, 8).is_err());
    }
    assert!(mesh::cylinder([1.0; 3], [1.0; 3], 0.1, 8).is_err());
    assert!(mesh::disc([0.0; 3], [0.0; 3], 1.0, 8).is_err());
    assert!(mesh::parallelogram([0.0; 3], [1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]).is_err());
    assert!(mesh::icosphere(8).is_err() && mesh::uv_sphere(2, 2).is_err());
    assert!(mesh::cylinder([0.0; 3], [1.0; 3], 0.1, 2).is_err());
}

#[test]
fn faces_without_area_still_have_unit_normals() {
    let flat = Mesh::from_triangles(vec![[1.0; 3]; 3], vec![[0, 1, 2]]).unwrap();
    assert_eq!(flat.normals(), [[0.0, 0.0, 1.0]; 3]);
    let tiny = vec![[0.0; 3], [1e-200, 0.0, 0.0], [0.0, 0.0, 1e-200]];
    assert!(Mesh::from_triangles(tiny, vec![[0, 1, 2]]).is_ok());
}
