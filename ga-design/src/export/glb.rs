//! Decides how a scene becomes a binary glTF 2.0 file: one mesh per shape and material in use.
//!
//! glTF has y up, designs have z up: a root node turns the whole scene by −90° about x, so that every
//! node below it keeps the coordinates of the design. Each node is a child of that root and keeps its
//! name; nodes of one shape and one material share one mesh, which has the name of the shape, and
//! meshes of one shape share their vertices. Instances are one node with the extension
//! `EXT_mesh_gpu_instancing`. Positions, normals and placements are stored in single precision.

use super::{ExportError, Format, Line, MaterialId, Placement, Scene, Shape, ShapeId};
use crate::mesh::Mesh;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

// Constants of the glTF 2.0 specification, sections 3.6 and 3.7.
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const LINE_LOOP: u32 = 2;
const LINE_STRIP: u32 = 3;
const TRIANGLES: u32 = 4;

// Listed as used, not as required: a program that lacks it still opens the file and shows one of each.
const INSTANCING: &str = "EXT_mesh_gpu_instancing";

// The container: section 4.4.
const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;

/// The bytes of a GLB file with the whole scene.
///
/// ```
/// use ga_design::export::{Material, Scene, glb};
/// let mut scene = Scene::new("ball", "A ball", "");
/// let red = scene.add_material(Material::new("red", [200, 40, 40]));
/// scene.add("ball", ga_design::mesh::icosphere(1)?, red)?;
/// assert!(glb::encode(&scene)?.starts_with(b"glTF"));
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
///
/// # Errors
/// [`ExportError`] if the scene is empty or larger than the format's four gigabytes.
pub fn encode(scene: &Scene) -> Result<Vec<u8>, ExportError> {
    scene.check_not_empty()?;
    let mut parts = Parts::default();
    let mut nodes = vec![root(scene)];
    for node in scene.nodes() {
        if let Some(mesh) = parts.mesh(scene, node.shape, node.material) {
            nodes.push(node_value(node, mesh));
        }
    }
    for all in scene.instances() {
        if let Some(mesh) = parts.mesh(scene, all.shape, all.material) {
            let attributes = parts.buffer.placements(&all.placements);
            nodes.push(json!({
                "name": all.name,
                "mesh": mesh,
                "extensions": { INSTANCING: { "attributes": attributes } },
            }));
        }
    }
    let Parts {
        buffer,
        meshes,
        materials,
        ..
    } = parts;
    let mut document = json!({
        "asset": {
            "version": "2.0",
            "generator": concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")),
        },
        "scene": 0,
        "scenes": [{
            "name": scene.title(),
            "nodes": [0],
            "extras": { "caption": scene.caption() },
        }],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{ "byteLength": buffer.bytes.len() }],
    });
    if let (false, Value::Object(fields)) = (scene.instances().is_empty(), &mut document) {
        fields.insert("extensionsUsed".into(), json!([INSTANCING]));
    }
    container(document.to_string().into_bytes(), buffer.bytes)
}

/// What nodes refer to; shapes and materials that none uses are not written.
#[derive(Default)]
struct Parts {
    buffer: Buffer,
    primitives: BTreeMap<ShapeId, Value>,
    mesh_numbers: BTreeMap<(ShapeId, MaterialId), usize>,
    material_numbers: BTreeMap<MaterialId, usize>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
}

impl Parts {
    /// The number of the mesh that shows this shape in this material.
    fn mesh(&mut self, scene: &Scene, shape: ShapeId, material: MaterialId) -> Option<usize> {
        if let Some(mesh) = self.mesh_numbers.get(&(shape, material)) {
            return Some(*mesh);
        }
        let (name, content) = scene.shapes().get(shape.0)?;
        let look = scene.materials().get(material.0)?;
        let material_number = *self.material_numbers.entry(material).or_insert_with(|| {
            self.materials.push(material_value(look));
            self.materials.len() - 1
        });
        let buffer = &mut self.buffer;
        let primitive = self
            .primitives
            .entry(shape)
            .or_insert_with(|| match content {
                Shape::Surface(mesh) => buffer.surface(mesh),
                Shape::Line(line) => buffer.line(line),
            });
        let mut primitive = primitive.clone();
        if let Value::Object(fields) = &mut primitive {
            fields.insert("material".into(), json!(material_number));
        }
        self.meshes
            .push(json!({ "name": name, "primitives": [primitive] }));
        let number = self.meshes.len() - 1;
        self.mesh_numbers.insert((shape, material), number);
        Some(number)
    }
}

/// The root that turns z up into y up, with every other node below it.
fn root(scene: &Scene) -> Value {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    json!({
        "name": "z up",
        "rotation": [-half, 0.0, 0.0, half],
        "children": (1..=scene.nodes().len() + scene.instances().len()).collect::<Vec<_>>(),
    })
}

fn node_value(node: &super::Node, mesh: usize) -> Value {
    let mut fields = Map::new();
    fields.insert("name".into(), json!(node.name));
    fields.insert("mesh".into(), json!(mesh));
    let translation = node.placement.translation().map(single);
    if translation != [0.0; 3] {
        fields.insert("translation".into(), json!(translation));
    }
    let [w, x, y, z] = node.placement.rotation().map(single);
    if [x, y, z] != [0.0; 3] {
        fields.insert("rotation".into(), json!([x, y, z, w]));
    }
    let scale = node.placement.scale().map(single);
    if scale != [1.0; 3] {
        fields.insert("scale".into(), json!(scale));
    }
    Value::Object(fields)
}

fn material_value(material: &super::Material) -> Value {
    let [red, green, blue] = material.linear_color().map(single);
    let opacity = single(material.opacity());
    let mut value = json!({
        "name": material.name(),
        "doubleSided": true,
        "pbrMetallicRoughness": {
            "baseColorFactor": [red, green, blue, opacity],
            "metallicFactor": single(material.metallic()),
            "roughnessFactor": single(material.roughness()),
        },
    });
    if let (true, Value::Object(fields)) = (material.opacity() < 1.0, &mut value) {
        fields.insert("alphaMode".into(), json!("BLEND"));
    }
    value
}

/// In single precision; every number of a scene is small enough to stay finite.
fn single(value: f64) -> f32 {
    value as f32
}

/// The binary part of the file, and what describes it.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    fn surface(&mut self, mesh: &Mesh) -> Value {
        let positions = self.vectors(mesh.positions(), true);
        let normals = self.vectors(mesh.normals(), false);
        let indices = self.indices(mesh.triangles(), mesh.positions().len());
        json!({
            "attributes": { "POSITION": positions, "NORMAL": normals },
            "indices": indices,
            "mode": TRIANGLES,
        })
    }

    fn line(&mut self, line: &Line) -> Value {
        let positions = self.vectors(line.points(), true);
        let mode = if line.is_closed() {
            LINE_LOOP
        } else {
            LINE_STRIP
        };
        json!({ "attributes": { "POSITION": positions }, "mode": mode })
    }

    /// The attributes of instances: those that do more than nothing, and always the places.
    fn placements(&mut self, placements: &[Placement]) -> Value {
        let mut attributes = Map::new();
        let places = placements.iter().map(Placement::translation);
        attributes.insert("TRANSLATION".into(), json!(self.columns(places, "VEC3")));
        let turns = placements.iter().map(|placement| {
            let [w, x, y, z] = placement.rotation();
            [x, y, z, w]
        });
        if turns.clone().any(|turn| turn != [0.0, 0.0, 0.0, 1.0]) {
            attributes.insert("ROTATION".into(), json!(self.columns(turns, "VEC4")));
        }
        let scales = placements.iter().map(Placement::scale);
        if scales.clone().any(|scale| scale != [1.0; 3]) {
            attributes.insert("SCALE".into(), json!(self.columns(scales, "VEC3")));
        }
        Value::Object(attributes)
    }

    /// An accessor of numbers that are no vertices.
    fn columns<const N: usize>(
        &mut self,
        rows: impl Iterator<Item = [f64; N]>,
        kind: &str,
    ) -> usize {
        let start = self.bytes.len();
        let mut count = 0;
        for row in rows {
            self.bytes
                .extend(row.map(|value| single(value).to_le_bytes()).as_flattened());
            count += 1;
        }
        let view = self.view(start, None);
        self.accessor(json!({
            "bufferView": view,
            "componentType": FLOAT,
            "count": count,
            "type": kind,
        }))
    }

    /// An accessor of vectors; bounds are required of positions, and must be those of the rounded
    /// numbers.
    fn vectors(&mut self, vectors: &[[f64; 3]], bounded: bool) -> usize {
        let start = self.bytes.len();
        let mut least = [f32::INFINITY; 3];
        let mut greatest = [f32::NEG_INFINITY; 3];
        for vector in vectors {
            for (axis, value) in vector.iter().copied().map(single).enumerate() {
                self.bytes.extend(value.to_le_bytes());
                if let Some(bound) = least.get_mut(axis) {
                    *bound = bound.min(value);
                }
                if let Some(bound) = greatest.get_mut(axis) {
                    *bound = bound.max(value);
                }
            }
        }
        let mut accessor = json!({
            "bufferView": self.view(start, Some(ARRAY_BUFFER)),
            "componentType": FLOAT,
            "count": vectors.len(),
            "type": "VEC3",
        });
        if let (true, Value::Object(fields)) = (bounded, &mut accessor) {
            fields.insert("min".into(), json!(least));
            fields.insert("max".into(), json!(greatest));
        }
        self.accessor(accessor)
    }

    fn indices(&mut self, triangles: &[[u32; 3]], vertices: usize) -> usize {
        let start = self.bytes.len();
        // The largest value of each type is reserved for restarting a primitive.
        let short = vertices < usize::from(u16::MAX);
        for &index in triangles.iter().flatten() {
            match u16::try_from(index) {
                Ok(index) if short => self.bytes.extend(index.to_le_bytes()),
                _ => self.bytes.extend(index.to_le_bytes()),
            }
        }
        let accessor = json!({
            "bufferView": self.view(start, Some(ELEMENT_ARRAY_BUFFER)),
            "componentType": if short { UNSIGNED_SHORT } else { UNSIGNED_INT },
            "count": 3 * triangles.len(),
            "type": "SCALAR",
        });
        self.accessor(accessor)
    }

    fn accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// A view of the bytes since `start`; what follows begins at a multiple of four, as floats must.
    fn view(&mut self, start: usize, target: Option<u32>) -> usize {
        let mut view = json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.bytes.len() - start,
        });
        if let (Some(target), Value::Object(fields)) = (target, &mut view) {
            fields.insert("target".into(), json!(target));
        }
        self.views.push(view);
        pad(&mut self.bytes, 0);
        self.views.len() - 1
    }
}

/// Both chunks of a GLB file: JSON is padded with spaces, binary with zeros.
fn container(mut document: Vec<u8>, mut binary: Vec<u8>) -> Result<Vec<u8>, ExportError> {
    pad(&mut document, b' ');
    pad(&mut binary, 0);
    let length = |bytes: usize| {
        u32::try_from(bytes).map_err(|_| ExportError::TooLarge {
            format: Format::Glb,
            what: "more than four gigabytes",
        })
    };
    let whole = 12 + 8 + document.len() + 8 + binary.len();
    let mut bytes = Vec::with_capacity(whole);
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend(length(whole)?.to_le_bytes());
    for (kind, chunk) in [(b"JSON", document), (b"BIN\0", binary)] {
        bytes.extend(length(chunk.len())?.to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    Ok(bytes)
}

fn pad(bytes: &mut Vec<u8>, filler: u8) {
    bytes.resize(bytes.len().next_multiple_of(4), filler);
}
