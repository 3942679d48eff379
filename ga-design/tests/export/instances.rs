//! Whether many things alike are stored as instances, and spelled out where a format has none.

use ga_design::crystallography::{Bonding, CellRange, Expansion, cif, scene};
use ga_design::export::{
    ExportError, Format, Material, Placement, Scene, encode, flatten, glb, save,
};
use ga_design::mesh;
use std::path::Path;

/// A scene with a ball as a node and three as instances, one of them turned and squeezed.
fn few() -> Scene {
    let mut scene = Scene::new("few", "Few", "");
    let ball = scene.add_shape("sphere", mesh::icosphere(0).unwrap());
    let red = scene.add_material(Material::new("red", [200, 40, 40]));
    let at = |x: f64| Placement::at([x, 0.0, 0.0]).unwrap();
    scene.add_node("one", ball, red, at(0.0)).unwrap();
    let turned = at(9.0).rotated([1.0, 0.0, 1.0, 0.0]).unwrap();
    let placements = vec![at(3.0), at(6.0), turned.scaled([1.0, 2.0, 3.0]).unwrap()];
    scene
        .add_instances("others", ball, red, placements)
        .unwrap();
    scene
}

/// The JSON part of a GLB file, and the numbers of an accessor in its binary part.
fn document(bytes: &[u8]) -> (serde_json::Value, Vec<u8>) {
    let read = gltf::binary::Glb::from_slice(bytes).unwrap();
    let json = serde_json::from_slice(&read.json).unwrap();
    (json, read.bin.unwrap().into_owned())
}

fn numbers(json: &serde_json::Value, bin: &[u8], accessor: &serde_json::Value) -> Vec<f32> {
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let start = view["byteOffset"].as_u64().unwrap() as usize;
    let length = view["byteLength"].as_u64().unwrap() as usize;
    bin[start..start + length]
        .chunks_exact(4)
        .map(|four| f32::from_le_bytes(four.try_into().unwrap()))
        .collect()
}

#[test]
fn instances_are_one_node_that_the_gltf_crate_opens() {
    let bytes = glb::encode(&few()).unwrap();
    let read = gltf::Gltf::from_slice(&bytes).unwrap();
    let names: Vec<_> = read
        .nodes()
        .filter_map(|node| node.name().map(str::to_owned))
        .collect();
    assert_eq!(names, ["z up", "one", "others"]);
    assert_eq!(read.meshes().count(), 1);
    let (json, bin) = document(&bytes);
    assert_eq!(
        json["extensionsUsed"],
        serde_json::json!(["EXT_mesh_gpu_instancing"])
    );
    assert!(json.get("extensionsRequired").is_none());
    let attributes = &json["nodes"][2]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    let places = numbers(&json, &bin, &attributes["TRANSLATION"]);
    assert_eq!(places, [3.0, 0.0, 0.0, 6.0, 0.0, 0.0, 9.0, 0.0, 0.0]);
    let scales = numbers(&json, &bin, &attributes["SCALE"]);
    assert_eq!(scales[3..], [1.0, 1.0, 1.0, 1.0, 2.0, 3.0]);
    let half = 0.5_f32.sqrt();
    let turns = numbers(&json, &bin, &attributes["ROTATION"]);
    assert_eq!(turns[4..8], [0.0, 0.0, 0.0, 1.0]);
    assert!(
        turns[8..]
            .iter()
            .zip([0.0, half, 0.0, half])
            .all(|(a, b)| (a - b).abs() < 1e-6)
    );
}

#[test]
fn attributes_that_do_nothing_and_scenes_without_instances_need_no_more() {
    let mut scene = Scene::new("plain", "Plain", "");
    let ball = scene.add_shape("sphere", mesh::icosphere(0).unwrap());
    let red = scene.add_material(Material::new("red", [200, 40, 40]));
    scene.add_instances("none", ball, red, Vec::new()).unwrap();
    assert!(matches!(
        glb::encode(&scene),
        Err(ExportError::EmptyScene { .. })
    ));
    scene
        .add_instances("some", ball, red, vec![Placement::default(); 2])
        .unwrap();
    let (json, _) = document(&glb::encode(&scene).unwrap());
    let attributes = &json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    assert_eq!(attributes.as_object().unwrap().len(), 1);
    let (json, _) = document(&glb::encode(&crate::demo::knot().unwrap()).unwrap());
    assert!(json.get("extensionsUsed").is_none());
}

#[test]
fn other_formats_spell_instances_out() {
    let scene = few();
    let surfaces: Vec<_> = flatten::surfaces(&scene).collect();
    assert_eq!(surfaces.len(), 4);
    assert_eq!(surfaces[3].name, "others");
    let ball = mesh::icosphere(0).unwrap();
    for (surface, x) in surfaces.iter().zip([0.0, 3.0, 6.0]) {
        for (placed, point) in surface.positions.iter().zip(ball.positions()) {
            assert_eq!(*placed, [point[0] + x, point[1], point[2]]);
        }
    }
    let stl = encode(&scene, Format::Stl, Path::new("few.stl")).unwrap();
    let triangles = stl_io::read_stl(&mut std::io::Cursor::new(&stl[0].1))
        .unwrap()
        .faces
        .len();
    assert_eq!(triangles, 4 * ball.triangles().len());
}

#[test]
fn instances_of_what_is_not_there_or_too_far_away_are_refused() {
    let mut other = Scene::new("other", "Other", "");
    other.add_shape("a", mesh::icosphere(0).unwrap());
    let second = other.add_shape("b", mesh::icosphere(0).unwrap());
    let stone = other.add_material(Material::new("stone", [9; 3]));
    let mut scene = few();
    let refused = scene.add_instances("x", second, stone, Vec::new());
    assert!(refused.unwrap_err().to_string().contains("names a shape"));
    let far = vec![Placement::at([9e17; 3]).unwrap().scaled([1e18; 3]).unwrap()];
    let ball = other.add_shape("ball", mesh::icosphere(0).unwrap());
    assert!(other.add_instances("x", ball, stone, far).is_err());
}

#[test]
fn what_would_fill_the_memory_is_refused_with_the_format_that_can() {
    let mut scene = Scene::new("many", "Many", "");
    // 81920 triangles, 123 times.
    let ball = scene.add_shape("sphere", mesh::icosphere(6).unwrap());
    let red = scene.add_material(Material::new("red", [200, 40, 40]));
    let places = vec![Placement::default(); 123];
    scene.add_instances("balls", ball, red, places).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for ending in ["stl", "obj", "ply", "png"] {
        let path = folder.path().join(format!("many.{ending}"));
        let message = save(&scene, &path).unwrap_err().to_string();
        let expected = format!("too large for .{ending}: more than ten million triangles");
        assert!(
            message.contains(&expected) && message.contains(".glb"),
            "{message}"
        );
        assert!(!path.exists());
    }
    save(&scene, &folder.path().join("many.glb")).unwrap();
}

fn halite(cells: &str) -> (Scene, usize) {
    let text = include_str!("../../data/cif/halite.cif");
    let crystal = cif::read_str("halite.cif", text).unwrap().crystal;
    let range: CellRange = cells.parse().unwrap();
    let expansion = Expansion::default();
    let unit = expansion.unit_cell(&crystal).unwrap();
    let atoms = expansion.cells(&crystal, &unit, range).unwrap();
    let mut scene = scene::scene("halite", "Halite", "", &crystal.cell, range, &atoms).unwrap();
    let bonds = Bonding::default().between(&atoms).unwrap();
    scene::add_bonds(&mut scene, &atoms, &bonds).unwrap();
    (scene, atoms.len())
}

#[test]
fn crystals_of_many_atoms_are_instances_by_element() {
    let (scene, atoms) = halite("3x3x3");
    let spheres = |scene: &Scene| scene.nodes().iter().filter(|n| n.name.len() <= 3).count();
    assert_eq!((atoms, spheres(&scene)), (216, 216));
    assert!(scene.instances().is_empty());
    // One cell less along one edge would still be nodes: 8 · 14 · 14 · 13 = 20384 are more than 20000.
    let (scene, atoms) = halite("14x14x13");
    assert_eq!((atoms, spheres(&scene)), (20_384, 0));
    let found: Vec<_> = scene
        .instances()
        .iter()
        .map(|all| (all.name.as_str(), all.placements.len()))
        .collect();
    let [x, y, z] = [28, 28, 26];
    let bonds = (x - 1) * y * z + x * (y - 1) * z + x * y * (z - 1);
    assert_eq!(
        found,
        [
            ("Sodium", 10_192),
            ("Chlorine", 10_192),
            ("bonds", bonds),
            ("bonds", bonds)
        ]
    );
    assert_eq!(scene.nodes().len(), 14 * 14 * 13);
}

#[test]
fn each_half_of_a_bond_reaches_from_its_atom_to_the_middle() {
    let (scene, _) = halite("1x1x1");
    let (rod, _) = scene
        .shapes()
        .iter()
        .enumerate()
        .find(|(_, (name, _))| name == "rod")
        .unwrap();
    let is_atom = |point: [f64; 3]| {
        scene.nodes().iter().any(|node| {
            let [x, y, z] = node.placement.translation();
            let near = (x - point[0]).powi(2) + (y - point[1]).powi(2) + (z - point[2]).powi(2);
            node.name != "bond" && node.name != "cell" && near < 1e-18
        })
    };
    let mut halves = 0;
    for (placed, shape, material) in scene.placed() {
        if placed.name != "bond" {
            continue;
        }
        assert!(std::ptr::eq(shape, &scene.shapes()[rod].1));
        assert!(material.name().starts_with("bonds of "));
        let from = placed.placement.apply([0.0; 3]);
        let middle = placed.placement.apply([0.0, 0.0, 1.0]);
        let far = [0, 1, 2].map(|i| 2.0 * middle[i] - from[i]);
        assert!(is_atom(from) && is_atom(far), "{from:?} {far:?}");
        halves += 1;
    }
    // Eight ions of one cell: a cube of twelve edges, each of two halves.
    assert_eq!(halves, 24);
}

#[test]
fn of_atoms_that_share_a_site_the_most_frequent_is_seen() {
    let text = include_str!("../../data/cif/spinel.cif");
    let crystal = cif::read_str("spinel.cif", text).unwrap().crystal;
    let atoms = Expansion::default().unit_cell(&crystal).unwrap();
    let instead = scene::more_frequent(&atoms);
    let scene = scene::scene("s", "S", "", &crystal.cell, CellRange::UNIT, &atoms).unwrap();
    let mut hidden = 0;
    for ((atom, instead), node) in atoms.iter().zip(instead).zip(scene.nodes()) {
        let Some(outer) = instead else { continue };
        hidden += 1;
        assert_eq!(atoms[outer].fract, atom.fract);
        assert!(atoms[outer].occupancy >= atom.occupancy);
        let size = |node: &ga_design::export::Node| node.placement.scale()[0];
        assert!(size(node) < size(&scene.nodes()[outer]));
    }
    // 24 sites of metals, each with two; the oxygens have theirs alone.
    assert_eq!((atoms.len(), hidden), (80, 24));
}
