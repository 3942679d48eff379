//! Independent readers open each format and find what the scene holds.

use crate::demo;
use ga_design::export::{Format, Scene, Shape, encode, flatten, glb, obj, ply, stl, svg};
use std::collections::HashMap;
use std::io::Cursor;
use std::path::Path;

fn scenes() -> [Scene; 2] {
    [demo::crystal().unwrap(), demo::knot().unwrap()]
}

/// The totals that every format without shared shapes must have.
fn totals(scene: &Scene) -> (usize, usize, [[f32; 3]; 2]) {
    let mut vertices = 0;
    let mut triangles = 0;
    let mut bounds = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for surface in flatten::surfaces(scene) {
        vertices += surface.positions.len();
        triangles += surface.triangles.len();
        for position in surface.positions {
            for axis in 0..3 {
                bounds[0][axis] = bounds[0][axis].min(position[axis] as f32);
                bounds[1][axis] = bounds[1][axis].max(position[axis] as f32);
            }
        }
    }
    (vertices, triangles, bounds)
}

fn grown(bounds: &mut [[f32; 3]; 2], point: [f32; 3]) {
    for axis in 0..3 {
        bounds[0][axis] = bounds[0][axis].min(point[axis]);
        bounds[1][axis] = bounds[1][axis].max(point[axis]);
    }
}

const NO_BOUNDS: [[f32; 3]; 2] = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];

#[test]
fn glb_is_opened_by_the_gltf_crate() {
    for scene in scenes() {
        let bytes = glb::encode(&scene).unwrap();
        let read = gltf::Gltf::from_slice(&bytes).unwrap();
        let blob = read.blob.as_deref().unwrap();
        let shown = read.default_scene().unwrap();
        assert_eq!(shown.name(), Some(scene.title()));
        let root = shown.nodes().next().unwrap();
        assert_eq!(root.children().count(), scene.nodes().len());
        for (child, (node, shape, material)) in root.children().zip(scene.placed()) {
            assert_eq!(child.name(), Some(node.name));
            let (translation, rotation, scale) = child.transform().decomposed();
            assert_eq!(translation, node.placement.translation().map(|c| c as f32));
            let [w, x, y, z] = node.placement.rotation().map(|c| c as f32);
            assert_eq!(rotation, [x, y, z, w]);
            assert_eq!(scale, node.placement.scale().map(|c| c as f32));
            let mesh = child.mesh().unwrap();
            let primitive = mesh.primitives().next().unwrap();
            assert_eq!(primitive.material().name(), Some(material.name()));
            let reader = primitive.reader(|_| Some(blob));
            let points: Vec<_> = reader.read_positions().unwrap().collect();
            let expected: Vec<_> = shape.points().iter().map(|p| p.map(|c| c as f32)).collect();
            assert_eq!(points, expected);
            let mut bounds = NO_BOUNDS;
            points.iter().for_each(|&p| grown(&mut bounds, p));
            let stated = primitive.bounding_box();
            assert_eq!([stated.min, stated.max], bounds);
            match shape {
                Shape::Surface(mesh) => {
                    let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
                    assert_eq!(indices, mesh.triangles().concat());
                    for normal in reader.read_normals().unwrap() {
                        let squared: f32 = normal.iter().map(|c| c * c).sum();
                        assert!((squared - 1.0).abs() < 1e-5);
                    }
                }
                Shape::Line(line) => {
                    let mode = primitive.mode();
                    assert_eq!(mode == gltf::mesh::Mode::LineLoop, line.is_closed());
                    assert_eq!(mode == gltf::mesh::Mode::LineStrip, !line.is_closed());
                }
            }
        }
    }
}

#[test]
fn glb_stores_a_shared_sphere_once_and_places_it_for_every_ball() {
    let bytes = glb::encode(&demo::crystal().unwrap()).unwrap();
    let read = gltf::Gltf::from_slice(&bytes).unwrap();
    let named = |name: &'static str| {
        move |node: &gltf::Node| node.mesh().is_some_and(|mesh| mesh.name() == Some(name))
    };
    assert_eq!(read.nodes().filter(named("sphere")).count(), demo::BALLS);
    // One mesh for each of the two materials, over the same vertices.
    let spheres: Vec<_> = read
        .meshes()
        .filter(|m| m.name() == Some("sphere"))
        .collect();
    assert_eq!(spheres.len(), 2);
    let vertices = |mesh: &gltf::Mesh| {
        let primitive = mesh.primitives().next().unwrap();
        primitive.get(&gltf::Semantic::Positions).unwrap().index()
    };
    assert_eq!(vertices(&spheres[0]), vertices(&spheres[1]));
}

#[test]
fn glb_turns_z_up_to_y_up_and_keeps_colours() {
    let bytes = glb::encode(&demo::knot().unwrap()).unwrap();
    let read = gltf::Gltf::from_slice(&bytes).unwrap();
    let root = read.default_scene().unwrap().nodes().next().unwrap();
    let columns = root.transform().matrix();
    // The image of z is the third column.
    let image: Vec<f32> = columns[2][..3]
        .iter()
        .map(|c| (c * 1e6).round() / 1e6)
        .collect();
    assert_eq!(image, [0.0, 1.0, 0.0]);
    let materials: HashMap<_, _> = read
        .materials()
        .map(|m| (m.name().unwrap(), m.clone()))
        .collect();
    let glass = &materials["glass"];
    assert_eq!(glass.alpha_mode(), gltf::material::AlphaMode::Blend);
    assert_eq!(glass.pbr_metallic_roughness().base_color_factor()[3], 0.3);
    let gold = materials["gold"].pbr_metallic_roughness();
    assert_eq!(gold.metallic_factor(), 1.0);
    // sRGB 230 is 0.7913 of full light (IEC 61966-2-1).
    assert!((gold.base_color_factor()[0] - 0.7913).abs() < 1e-3);
}

#[test]
fn stl_is_opened_by_stl_io() {
    for scene in scenes() {
        let bytes = stl::encode(&scene).unwrap();
        assert!(!bytes.starts_with(b"solid"));
        let read = stl_io::read_stl(&mut Cursor::new(bytes)).unwrap();
        let (_, triangles, expected) = totals(&scene);
        assert_eq!(read.faces.len(), triangles);
        let mut bounds = NO_BOUNDS;
        for vertex in &read.vertices {
            grown(&mut bounds, [vertex[0], vertex[1], vertex[2]]);
        }
        assert_eq!(bounds, expected);
    }
    let bytes = stl::encode(&demo::crystal().unwrap()).unwrap();
    let read = stl_io::read_stl(&mut Cursor::new(bytes)).unwrap();
    for face in &read.faces {
        let squared: f32 = (0..3).map(|i| face.normal[i] * face.normal[i]).sum();
        assert!((squared - 1.0).abs() < 1e-5);
    }
}

#[test]
fn ply_is_opened_by_a_ply_reader() {
    use ply_rs_bw::parser::Parser;
    use ply_rs_bw::ply::{DefaultElement, Property};
    for scene in scenes() {
        let bytes = ply::encode(&scene).unwrap();
        let parser = Parser::<DefaultElement>::new();
        let read = parser.read_ply(&mut Cursor::new(bytes)).unwrap();
        let (vertices, triangles, expected) = totals(&scene);
        assert_eq!(read.payload["vertex"].len(), vertices);
        assert_eq!(read.payload["face"].len(), triangles);
        let mut bounds = NO_BOUNDS;
        for vertex in &read.payload["vertex"] {
            let number = |name: &str| match vertex[name] {
                Property::Float(value) => value,
                ref other => panic!("{name} is {other:?}"),
            };
            grown(&mut bounds, ["x", "y", "z"].map(number));
            let squared: f32 = ["nx", "ny", "nz"].map(number).iter().map(|c| c * c).sum();
            assert!((squared - 1.0).abs() < 1e-5);
        }
        assert_eq!(bounds, expected);
        for face in &read.payload["face"] {
            let Property::ListInt(corners) = &face["vertex_indices"] else {
                panic!("a face without corners");
            };
            assert_eq!(corners.len(), 3);
            assert!(corners.iter().all(|&i| (i as usize) < vertices));
        }
        let color = flatten::surfaces(&scene).next().unwrap().material.color();
        let first = &read.payload["vertex"][0];
        for (name, channel) in ["red", "green", "blue"].into_iter().zip(color) {
            assert!(matches!(first[name], Property::UChar(value) if value == channel));
        }
    }
}

#[test]
fn obj_is_opened_by_tobj() {
    for scene in scenes() {
        let files = obj::encode(&scene, "scene.mtl").unwrap();
        let read = |ignore_lines| {
            let options = tobj::LoadOptions {
                ignore_lines,
                ..Default::default()
            };
            tobj::load_obj_buf(&mut Cursor::new(&files.geometry), &options, |library| {
                assert_eq!(library, Path::new("scene.mtl"));
                tobj::load_mtl_buf(&mut Cursor::new(&files.materials))
            })
            .unwrap()
        };
        let (with_lines, materials) = read(false);
        let materials = materials.unwrap();
        assert_eq!(materials.len(), scene.materials().len());
        assert_eq!(with_lines.len(), scene.nodes().len());
        let (_, triangles, _) = totals(&scene);
        let mut found = 0;
        let (models, _) = read(true);
        for (model, surface) in models.iter().zip(flatten::surfaces(&scene)) {
            assert_eq!(model.name, surface.name.replace(' ', "_"));
            let material = &materials[model.mesh.material_id.unwrap()];
            assert_eq!(material.name, surface.material.name());
            let red = material.diffuse.unwrap()[0];
            assert!((red - f32::from(surface.material.color()[0]) / 255.0).abs() < 1e-4);
            assert_eq!(
                material.dissolve.unwrap(),
                surface.material.opacity() as f32
            );
            found += model.mesh.indices.len() / 3;
            let mesh = &model.mesh;
            let corners = surface.triangles.iter().flatten();
            for (corner, (&at, &normal_at)) in
                corners.zip(mesh.indices.iter().zip(&mesh.normal_indices))
            {
                let vector = |values: &[f32], i: u32| {
                    let start = 3 * i as usize;
                    [values[start], values[start + 1], values[start + 2]]
                };
                let expected = surface.positions[*corner as usize].map(|c| c as f32);
                assert_eq!(vector(&mesh.positions, at), expected);
                let expected = surface.normals[*corner as usize].map(|c| c as f32);
                assert_eq!(vector(&mesh.normals, normal_at), expected);
            }
        }
        assert_eq!(found, triangles);
    }
}

#[test]
fn svg_is_well_formed_and_inside_its_own_frame() {
    let scene = demo::knot().unwrap();
    let text = svg::encode(&scene).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let root = document.root_element();
    let side = |name: &str| root.attribute(name).unwrap().parse::<f64>().unwrap();
    let [width, height] = [side("width"), side("height")];
    let paths: Vec<_> = document
        .descendants()
        .filter(|n| n.has_tag_name("path"))
        .collect();
    assert_eq!(paths.len(), 2);
    let closed = paths
        .iter()
        .filter(|p| p.attribute("d").unwrap().ends_with('Z'));
    assert_eq!(closed.count(), 1);
    for path in paths {
        let numbers = path.attribute("d").unwrap();
        let numbers = numbers
            .split(['M', 'L', 'Z', ' '])
            .filter(|part| !part.is_empty());
        let numbers: Vec<f64> = numbers.map(|part| part.parse().unwrap()).collect();
        for pair in numbers.chunks(2) {
            assert!((0.0..=width).contains(&pair[0]) && (0.0..=height).contains(&pair[1]));
        }
    }
}

#[test]
fn every_format_encodes_the_same_bytes_twice() {
    let [one, two] = [demo::knot().unwrap(), demo::knot().unwrap()];
    for format in Format::ALL.into_iter().filter(|&f| f != Format::Png) {
        let path = Path::new("scene").with_extension(format.ending());
        assert_eq!(
            encode(&one, format, &path).unwrap(),
            encode(&two, format, &path).unwrap()
        );
    }
}
