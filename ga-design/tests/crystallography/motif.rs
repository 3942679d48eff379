//! Whether motifs of every kind are carried into the right places, and coincident copies merged.

use ga_cga::{
    Circle, DualLine, DualPlane, DualSphere, FlatPoint, Line, Motor, Plane, Point, PointPair,
    Sphere, Vector3,
};
use ga_design::crystallography::motif::add_instances;
use ga_design::crystallography::{
    Cell, CellRange, Coincidence, Curve, Isometry, Labelled, Motif, MotifError, Pattern,
    SpaceGroup, Strut,
};
use ga_design::export::{Material, Scene, flatten};
use ga_design::mesh::{self, Mesh};

fn pattern(symbol: &str, cells: &str) -> Pattern {
    let group = SpaceGroup::from_symbol(symbol).expect("known")[0];
    let (edges, angles) = match group.number {
        143..=194 => ([4.0, 4.0, 6.0], [90.0, 90.0, 120.0]),
        195..=230 => ([4.0; 3], [90.0; 3]),
        _ => ([4.0, 4.0, 6.0], [90.0; 3]),
    };
    let cell = Cell::new(edges, angles).expect("a cell");
    let operations = group.operations().expect("a Hall symbol of the table");
    Pattern::of_group(&operations, &cell, cells.parse().expect("a range")).expect("a fitting cell")
}

/// The number of different copies and how many coincide in each place.
fn counts(pattern: &Pattern, motif: &impl Motif, when: &Coincidence) -> (usize, usize) {
    let copies = pattern.distinct(motif, when).expect("a pattern");
    let coincident = copies.first().map_or(0, |copy| copy.coincident);
    assert!(copies.iter().all(|copy| copy.coincident == coincident));
    assert_eq!((copies.len() * coincident) as u64, pattern.count());
    (copies.len(), coincident)
}

fn z_axis() -> (Point, Vector3) {
    (Point::at(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0))
}

#[test]
fn every_kind_of_multivector_is_moved_and_merged() {
    let (origin, up) = z_axis();
    let (plain, oriented) = (
        Coincidence::default(),
        Coincidence {
            is_oriented: true,
            ..Coincidence::default()
        },
    );
    let point_group = pattern("P 4/m m m", "1");
    let here = Point::at(0.0, 0.0, 0.7);
    // Order 16; on the axis 4 mm keeps a point, 4/mmm the axis and the basal plane.
    assert_eq!(counts(&point_group, &here, &plain), (2, 8));
    assert_eq!(
        counts(&point_group, &Line::along(origin, up), &plain),
        (1, 16)
    );
    assert_eq!(
        counts(&point_group, &Line::along(origin, up), &oriented),
        (2, 8)
    );
    assert_eq!(
        counts(&point_group, &DualLine::along(origin, up), &plain),
        (1, 16)
    );
    let basal = DualPlane::at_distance(up, 0.0);
    assert_eq!(counts(&point_group, &basal, &plain), (1, 16));
    assert_eq!(counts(&point_group, &basal, &oriented), (2, 8));
    assert_eq!(
        counts(&point_group, &DualPlane::at_distance(up, 0.7), &plain),
        (2, 8)
    );
    let plane: Plane = basal.undual();
    assert_eq!(counts(&point_group, &plane, &plain), (1, 16));
    let circle = Circle::with_normal(here, 0.4, up).expect("a circle");
    assert_eq!(counts(&point_group, &circle, &plain), (2, 8));
    // As oriented circles the mirrors turn it round.
    assert_eq!(counts(&point_group, &circle, &oriented), (4, 4));
    let sphere = DualSphere::about(here, 0.16);
    assert_eq!(counts(&point_group, &sphere, &plain), (2, 8));
    let direct: Sphere = sphere.undual();
    assert_eq!(counts(&point_group, &direct, &plain), (2, 8));
    let pair: PointPair = here ^ Point::at(0.0, 0.0, -0.7);
    assert_eq!(counts(&point_group, &pair, &plain), (1, 16));
    assert_eq!(counts(&point_group, &FlatPoint::at(here), &plain), (2, 8));
    // A motor is moved too: a quarter turn about the axis, by the mirrors one the other way.
    let turn = Motor::about_line(DualLine::along(origin, up), 1.0).expect("a turn");
    assert_eq!(counts(&point_group, &turn, &plain), (2, 8));
    // In general position nothing coincides.
    let aside = Point::at(0.3, 0.5, 0.7);
    for count in [
        counts(&point_group, &aside, &plain),
        counts(
            &point_group,
            &Circle::with_normal(aside, 0.4, Vector3::new(1.0, 2.0, 3.0)).expect("a circle"),
            &plain,
        ),
        counts(
            &point_group,
            &Line::along(aside, Vector3::new(1.0, 2.0, 3.0)),
            &plain,
        ),
    ] {
        assert_eq!(count, (16, 1));
    }
}

#[test]
fn lattices_merge_what_lies_along_them() {
    let (origin, up) = z_axis();
    let cells = pattern("P 4", "2x2x3");
    // The axis through the origin is the same for the three cells along it, and for the four turns.
    assert_eq!(
        counts(&cells, &Line::along(origin, up), &Coincidence::default()),
        (4, 12)
    );
    assert_eq!(counts(&cells, &origin, &Coincidence::default()), (12, 4));
    let screws = pattern("P 31 2 1", "1");
    assert_eq!(
        counts(&screws, &Point::at(0.0, 0.0, 0.1), &Coincidence::default()),
        (6, 1)
    );
    // Far from the origin too: 8c of International Tables in each of the two cells.
    let at = Point::at(1.0, 1.0, 1.0);
    let far = pattern("F m -3 m", "200:202x0:1x0:1").gathered(at);
    assert_eq!(counts(&far, &at, &Coincidence::default()), (16, 24));
    // A circle around a body diagonal there, and a line along it: 4 lines pass through every cell.
    let (origin, diagonal) = (Point::at(0.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 1.0));
    let ring = Circle::with_normal(at, 0.5, diagonal).expect("a circle");
    assert_eq!(counts(&far, &ring, &Coincidence::default()), (64, 6));
    let cubic = pattern("P m -3 m", "1");
    assert_eq!(
        counts(
            &cubic,
            &Line::along(origin, diagonal),
            &Coincidence::default()
        ),
        (4, 12)
    );
}

#[test]
fn positions_near_a_special_one_merge_within_the_distance() {
    let cubic = pattern("P m -3 m", "1");
    let near = Point::at(0.001, 0.0005, 1.0);
    let wide = Coincidence {
        distance: 0.01,
        ..Coincidence::default()
    };
    assert_eq!(counts(&cubic, &near, &wide), (6, 8));
    assert_eq!(counts(&cubic, &near, &Coincidence::default()), (48, 1));
}

#[test]
fn struts_curves_and_labels_are_compared_as_what_they_are() {
    let group = pattern("P 4 m m", "1");
    let [a, b] = [Point::at(0.5, 0.0, 0.0), Point::at(-0.5, 0.0, 0.0)];
    let strut = Strut { ends: [a, b] };
    let plain = Coincidence::default();
    let oriented = Coincidence {
        is_oriented: true,
        ..plain
    };
    assert_eq!(counts(&group, &strut, &plain), (2, 4));
    assert_eq!(counts(&group, &strut, &oriented), (4, 2));
    let square: Vec<_> = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]
        .map(|(x, y)| Point::at(x, y, 0.0))
        .to_vec();
    let closed = Curve {
        points: square.clone(),
        is_closed: true,
    };
    assert_eq!(counts(&group, &closed, &plain), (1, 8));
    assert_eq!(counts(&group, &closed, &oriented), (2, 4));
    let open = Curve {
        points: square,
        is_closed: false,
    };
    assert_eq!(counts(&group, &open, &plain), (4, 2));
    let empty = Curve {
        points: Vec::new(),
        is_closed: true,
    };
    assert_eq!(counts(&group, &empty, &plain), (1, 8));
    let labelled = Labelled {
        label: "Na",
        shape: Point::at(0.0, 0.0, 0.2),
    };
    assert_eq!(counts(&group, &labelled, &plain), (1, 8));
}

/// A tetrahedron without symmetry.
fn chiral() -> Mesh {
    let corners = [
        [0.1, 0.2, 0.3],
        [1.1, 0.3, 0.2],
        [0.2, 0.9, 0.1],
        [0.3, 0.1, 1.4],
    ];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let mut parts = Vec::new();
    for face in faces {
        let points: Vec<_> = face.iter().map(|&i: &usize| corners[i]).collect();
        parts.push(Mesh::from_triangles(points, vec![[0, 1, 2]]).expect("a face"));
    }
    Mesh::joined(&parts).expect("a mesh")
}

/// The volume that the triangles enclose, and that the normals do: both are positive for a surface that is
/// the right way out.
fn volumes(positions: &[[f64; 3]], normals: &[[f64; 3]], triangles: &[[u32; 3]]) -> [f64; 2] {
    let at = |i: u32| glam::DVec3::from(positions[i as usize]);
    let mut sums = [0.0; 2];
    for t in triangles {
        let area = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])) / 2.0;
        sums[0] += at(t[0]).dot(area) / 3.0;
        let normal = glam::DVec3::from(normals[t[0] as usize]);
        sums[1] += at(t[0]).dot(normal) * area.length() / 3.0;
    }
    sums
}

#[test]
fn mirrored_meshes_are_the_right_way_out_moved_and_placed() {
    let mesh = chiral();
    let inside = volumes(mesh.positions(), mesh.normals(), mesh.triangles())[0];
    assert!(inside > 0.1);
    let pattern = pattern("P 21/c", "2x1x1");
    let copies = pattern
        .distinct(&mesh, &Coincidence::default())
        .expect("a pattern");
    assert_eq!(copies.len(), 8);
    let mut scene = Scene::new("a", "b", "c");
    let materials = [
        Material::new("turned", [200, 0, 0]),
        Material::new("mirrored", [0, 0, 200]),
    ];
    let materials = materials.map(|material| scene.add_material(material));
    let isometries = copies.iter().map(|copy| copy.isometry);
    add_instances(&mut scene, "piece", &mesh, materials, isometries).expect("a scene");
    // Two shapes, eight places.
    assert_eq!((scene.shapes().len(), scene.nodes().len()), (2, 8));
    for (copy, surface) in copies.iter().zip(flatten::surfaces(&scene)) {
        let moved = &copy.shape;
        for volume in volumes(moved.positions(), moved.normals(), moved.triangles()) {
            assert!((volume - inside).abs() < 1e-9, "{volume}");
        }
        for volume in volumes(&surface.positions, &surface.normals, surface.triangles) {
            assert!((volume - inside).abs() < 1e-9, "{volume}");
        }
        let pairs = surface.positions.iter().zip(moved.positions());
        for (placed, moved) in pairs {
            assert!(glam::DVec3::from(*placed).distance(glam::DVec3::from(*moved)) < 1e-9);
        }
        let is_mirrored = copy.isometry.mirror.is_some();
        assert_eq!(surface.material.name() == "mirrored", is_mirrored);
    }
}

#[test]
fn meshes_in_special_positions_are_merged() {
    let cubic = pattern("P m -3 m", "1");
    // A rod along the fourfold axis with eight sides is kept by 4mm.
    let rod = mesh::cylinder([0.0, 0.0, 0.5], [0.0, 0.0, 1.5], 0.2, 8).expect("a rod");
    let counted = counts(&cubic, &rod, &Coincidence::default());
    assert_eq!(counted, (6, 8));
}

#[test]
fn what_cannot_be_made_says_so() {
    let huge = pattern("F m -3 m", "100");
    let error = huge
        .copies(&Point::at(0.1, 0.2, 0.3))
        .expect_err("192 million");
    assert!(
        matches!(
            error,
            MotifError::TooMany {
                copies: 192_000_000
            }
        ),
        "{error}"
    );
    let small = pattern("P -1", "1");
    let nowhere = Point::at(f64::NAN, 0.0, 0.0);
    let error = small
        .distinct(&nowhere, &Coincidence::default())
        .expect_err("NaN");
    assert_eq!(error.to_string(), MotifError::NotFinite.to_string());
    let far = Mesh::from_triangles(
        vec![[9e17, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        vec![[0, 1, 2]],
    );
    let away = Pattern::on_lattice(
        vec![Isometry {
            mirror: None,
            motor: Motor::identity(),
        }],
        [Vector3::new(9e17, 0.0, 0.0); 3],
        CellRange {
            low: [0; 3],
            high: [2, 1, 1],
        },
    );
    let error = away.copies(&far.expect("a mesh")).expect_err("too far");
    assert!(matches!(error, MotifError::Mesh(_)), "{error}");
    let group = SpaceGroup::from_symbol("P 4").expect("known")[0];
    let cell = Cell::new([4.0, 5.0, 6.0], [90.0; 3]).expect("a cell");
    let operations = group.operations().expect("a Hall symbol of the table");
    let error = Pattern::of_group(&operations, &cell, CellRange::UNIT).expect_err("not tetragonal");
    assert!(matches!(error, MotifError::Placement(_)), "{error}");
    let none = Pattern::of_isometries(Vec::new());
    assert_eq!(
        none.distinct(&Point::at(0.0, 0.0, 0.0), &Coincidence::default()),
        Ok(Vec::new())
    );
}
