//! Whether fundamental domains have their share of the cell and tile space with their images.

use crate::standard_cell::cell;
use ga_cga::Point;
use ga_design::crystallography::{
    Cell, FundamentalDomain, FundamentalDomainError, Isometry, Operation, Placement, SpaceGroup,
};
use proptest::prelude::*;

fn group(number: u32) -> Vec<Operation> {
    let group = SpaceGroup::standard(number).expect("a number from 1 to 230");
    group.operations().expect("a Hall symbol of the table")
}

#[test]
fn domains_of_all_groups_have_their_share_and_close() {
    for number in 1..=230 {
        let (operations, cell) = (group(number), cell(number));
        let domain = FundamentalDomain::of(&operations, &cell)
            .unwrap_or_else(|error| panic!("{number}: {error}"));
        let share = cell.volume() / operations.len() as f64;
        assert!((domain.volume() / share - 1.0).abs() < 1e-9, "{number}");
        // Convex: every corner is on or behind every plane, and the seed inside.
        let corners = domain.faces().iter().flat_map(|face| &face.corners);
        for corner in corners {
            assert!(domain.depth(*corner).abs() < 1e-9, "{number}");
        }
        assert!(domain.depth(domain.seed()) > 0.01, "{number}");
        // Euler: each edge belongs to two faces, in opposite directions, so that the surface is closed.
        let mesh = domain.mesh().expect("a mesh");
        assert!((enclosed(&mesh) / share - 1.0).abs() < 1e-9, "{number}");
        // The seed's image beyond each face is the mirror image of the seed in the face's plane.
        let (placements, frame) = Placement::of_group(&operations, &cell).expect("a fitting cell");
        for face in domain.faces() {
            let image = Isometry::from(&placements[face.operation]).apply(domain.seed());
            let shift = frame.cartesian(face.cell.map(f64::from));
            let position = image.position().to_array();
            let there = [0, 1, 2].map(|i| position[i] + shift[i]);
            let mirrored: Point = face.plane.apply(domain.seed());
            assert!(
                mirrored.distance(Point::at(there[0], there[1], there[2])) < 1e-9,
                "{number}"
            );
        }
    }
}

/// The volume that a surface encloses, by the divergence theorem.
fn enclosed(mesh: &ga_design::mesh::Mesh) -> f64 {
    let corner = |i: u32| glam::DVec3::from(mesh.positions()[i as usize]);
    let triangles = mesh.triangles().iter();
    triangles
        .map(|t| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0)
        .sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn every_point_is_in_exactly_one_image(number in 1_u32..=230, x in prop::array::uniform3(0.0..1.0)) {
        let (operations, cell) = (group(number), cell(number));
        let domain = FundamentalDomain::of(&operations, &cell).expect("a domain");
        let (placements, frame) = Placement::of_group(&operations, &cell).expect("a fitting cell");
        let mut inside = 0;
        for placement in &placements {
            // The operations are a group: images of the point in the domain, for domains at the point.
            let isometry = Isometry::from(placement);
            let [a, b, c] = frame.cartesian(x);
            let image = isometry.apply(Point::at(a, b, c));
            let fraction = frame.fractional(image.position().to_array());
            for cell in 0..343 {
                let offset = [cell / 49, cell / 7 % 7, cell % 7];
                let moved = [0, 1, 2].map(|i| {
                    fraction[i] - fraction[i].floor() + f64::from(offset[i]) - 3.0
                });
                let [a, b, c] = frame.cartesian(moved);
                let depth = domain.depth(Point::at(a, b, c));
                // Too close to a face to tell.
                prop_assume!(depth.abs() > 1e-9);
                inside += usize::from(depth > 0.0);
            }
        }
        prop_assert_eq!(inside, 1);
    }
}

#[test]
fn a_domain_without_symmetry_is_the_voronoi_cell_of_the_lattice() {
    // Body-centred cubic: the truncated octahedron; face-centred: the rhombic dodecahedron.
    for (symbol, faces) in [("P 1", 6), ("I m -3 m", 14), ("F m -3 m", 12)] {
        let all = SpaceGroup::from_symbol(symbol).expect("known")[0];
        let operations = all.operations().expect("a Hall symbol of the table");
        let lattice: Vec<_> = operations
            .into_iter()
            .filter(Operation::is_translation)
            .collect();
        let cell = Cell::new([4.0; 3], [90.0; 3]).expect("a cell");
        let domain = FundamentalDomain::about(&lattice, &cell, [0.2, 0.3, 0.4]).expect("a domain");
        let large = domain.faces().iter().filter(|face| face.corners.len() > 3);
        assert_eq!(large.count(), faces, "{symbol}");
    }
}

#[test]
fn points_on_elements_and_what_is_no_group_are_refused() {
    let (operations, cell) = (group(225), cell(225));
    for seed in [
        [0.0; 3],
        [0.1, 0.1, 0.3],
        [f64::NAN; 3],
        [f64::INFINITY, 0.1, 0.2],
        [1e300; 3],
    ] {
        let error = FundamentalDomain::about(&operations, &cell, seed).expect_err("special");
        assert!(
            matches!(error, FundamentalDomainError::Special(_)),
            "{error}"
        );
    }
    let quarter: Operation = "-y,x,z".parse().expect("a rotation");
    // Any two points per cell are images of each other in the middle between them; three are not.
    let third: Operation = "z,x,y".parse().expect("a rotation");
    let three = [Operation::IDENTITY, quarter, third];
    let seed = [0.1, 0.25, 0.37];
    let error = FundamentalDomain::about(&three, &cell, seed).expect_err("no group");
    assert!(
        matches!(error, FundamentalDomainError::NotAGroup { .. }),
        "{error}"
    );
    let oblique = Cell::new([1.0, 1.0, 400.0], [90.0; 3]).expect("a cell");
    assert!(FundamentalDomain::of(&group(1), &oblique).is_ok());
    let misfit = FundamentalDomain::of(&operations, &oblique).expect_err("not cubic");
    assert!(
        matches!(misfit, FundamentalDomainError::Placement(_)),
        "{misfit}"
    );
    let sheared = Cell::new([1.0, 500.0, 500.0], [90.0, 90.0, 0.2]).expect("a cell");
    let error = FundamentalDomain::of(&group(1), &sheared).expect_err("oblique");
    assert!(matches!(error, FundamentalDomainError::Oblique), "{error}");
}
