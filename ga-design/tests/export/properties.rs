//! Whatever finite numbers make a scene, every format is written without panic and without NaN.

use ga_design::export::picture::{Settings, render};
use ga_design::export::{ExportError, Format, Line, Material, Placement, Scene, encode, glb, stl};
use ga_design::mesh::{self, Ends, Mesh};
use proptest::prelude::*;
use std::path::Path;

/// Ordinary numbers, and now and then one from the whole range.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -10.0..10.0,
        1 => -1e18..1e18,
        1 => -1e-300..1e-300,
        1 => Just(0.0),
        1 => any::<f64>(),
    ]
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

/// Adds what can be made of the numbers; what cannot is refused with an error and left out.
fn scene(
    points: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    rotation: [f64; 4],
    [radius, opacity]: [f64; 2],
    name: String,
) -> Scene {
    let mut scene = Scene::new("any", name.clone(), name.clone());
    let material = Material::new(name.clone(), [200, 100, 50]);
    let material = material.clone().with_opacity(opacity).unwrap_or(material);
    let material = scene.add_material(material);
    let first = points.first().copied().unwrap_or_default();
    let second = points.get(1).copied().unwrap_or_default();
    let shapes = [
        Mesh::from_triangles(points.clone(), triangles),
        mesh::tube(&points, Ends::Closed, radius, 5),
        mesh::tube(&points, Ends::Capped, radius, 5),
        mesh::torus(first, second, radius, radius / 4.0, 9, 5),
        mesh::arrow(first, second, radius, 5),
        mesh::disc(first, second, radius, 7),
        mesh::parallelogram(first, second, [radius; 3]),
        mesh::box_edges(first, [first, second, [radius; 3]], radius, 5),
    ];
    let place = |at: [f64; 3]| -> Result<Placement, ExportError> {
        Placement::at(at)?
            .rotated(rotation)?
            .scaled([radius, radius, 1.0])
    };
    for shape in shapes.into_iter().flatten() {
        let shape = scene.add_shape(name.clone(), shape);
        if let Ok(placement) = place(second) {
            let _ = scene.add_node(name.clone(), shape, material, placement);
        }
        let _ = scene.add_node(name.clone(), shape, material, Placement::default());
    }
    for closed in [false, true] {
        if let Ok(line) = Line::new(points.clone(), closed) {
            let _ = scene.add(&name, line, material);
        }
    }
    scene
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_scene_panics_or_writes_nan(
        points in prop::collection::vec(point(), 0..9),
        triangles in prop::collection::vec([0..9_u32, 0..9, 0..9], 0..6),
        rotation in [number(), number(), number(), number()],
        radius in prop_oneof![0.01..2.0, number()],
        opacity in prop_oneof![0.0..1.0, Just(1.0)],
        name in ".{0,12}",
    ) {
        let scene = scene(points, triangles, rotation, [radius, opacity], name);
        for format in Format::ALL.into_iter().filter(|&format| format != Format::Png) {
            let path = Path::new("any").with_extension(format.ending());
            for (_, bytes) in encode(&scene, format, &path).into_iter().flatten() {
                if matches!(format, Format::Obj | Format::Svg) {
                    let text = String::from_utf8(bytes).unwrap();
                    let is_number = |word: &str| !matches!(word, "NaN" | "inf" | "-inf");
                    let mut lines = text.lines().filter(|l| l.starts_with('v') || l.starts_with("<path"));
                    prop_assert!(lines.all(|l| l.split([' ', '"', 'M', 'L']).all(is_number)));
                }
            }
        }
        if let Ok(bytes) = glb::encode(&scene) {
            let read = gltf::Gltf::from_slice(&bytes);
            prop_assert!(read.is_ok(), "{:?}", read.err());
            let read = read.unwrap();
            for primitive in read.meshes().flat_map(|m| m.primitives().collect::<Vec<_>>()) {
                let reader = primitive.reader(|_| read.blob.as_deref());
                let mut numbers = reader.read_positions().unwrap().flatten();
                prop_assert!(numbers.all(f32::is_finite));
                for normal in reader.read_normals().into_iter().flatten() {
                    let squared: f32 = normal.iter().map(|c| c * c).sum();
                    prop_assert!((squared - 1.0).abs() < 1e-3);
                }
            }
        }
        if let Ok(bytes) = stl::encode(&scene) {
            let numbers = bytes[84..].chunks(50).flat_map(|facet| facet[..48].chunks(4));
            let mut numbers = numbers.map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
            prop_assert!(numbers.all(f32::is_finite));
        }
        let settings = Settings { width: 24, height: 18, samples: 1 };
        if !scene.nodes().is_empty() {
            prop_assert!(render(&scene, &settings).is_ok());
        }
    }
}
