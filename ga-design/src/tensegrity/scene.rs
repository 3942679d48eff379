//! How a structure is shown: struts as thick warm rods, cables as thin cold ones, a colour for each
//! class, and balls where they meet.

use super::structure::{Member, Role, Structure};
use crate::export::{ExportError, Line, Material, MaterialId, Placement, Scene, ShapeId};
use crate::mesh;
use ga_cga::Point;
use glam::{DQuat, DVec3};

/// The radii of struts, cables and balls, over the mean length of a strut.
const RADII: [f64; 3] = [0.027, 0.0075, 0.034];

/// The colours of the classes of struts, which repeat.
const WARM: [[u8; 3]; 3] = [[214, 106, 44], [196, 78, 50], [226, 140, 56]];

/// The colours of the classes of cables, which repeat.
const COLD: [[u8; 3]; 4] = [
    [38, 104, 178],
    [122, 82, 164],
    [30, 148, 132],
    [92, 102, 118],
];

/// The shapes and materials that structures of one scene share.
#[derive(Debug, Clone)]
pub struct Look {
    rod: ShapeId,
    ball: ShapeId,
    struts: Vec<MaterialId>,
    cables: Vec<MaterialId>,
    ends: MaterialId,
}

impl Look {
    /// Adds the shapes and materials to a scene.
    ///
    /// # Errors
    /// None that a caller could cause.
    pub fn new(scene: &mut Scene) -> Result<Self, ExportError> {
        let rod = mesh::cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, 24)?;
        let rod = scene.add_shape("rod", rod);
        let ball = scene.add_shape("ball", mesh::icosphere(3)?);
        let mut materials = |name: &str, colors: &[[u8; 3]]| {
            let materials = colors.iter().enumerate().map(|(number, &color)| {
                let material = Material::new(format!("{name} {}", number + 1), color);
                Ok(scene.add_material(material.with_roughness(0.4)?))
            });
            materials.collect::<Result<Vec<_>, ExportError>>()
        };
        let struts = materials("struts", &WARM)?;
        let cables = materials("cables", &COLD)?;
        let ends = Material::new("nodes", [232, 226, 214]).with_roughness(0.35)?;
        let ends = scene.add_material(ends);
        Ok(Self {
            rod,
            ball,
            struts,
            cables,
            ends,
        })
    }

    /// Adds a structure to the scene: a node for each strut (`strut 0`, `strut 1` …), for each cable and
    /// for each node of the structure, numbered as in its lists.
    ///
    /// # Errors
    /// [`ExportError`] if the structure is too small or too far away to be drawn.
    pub fn draw(&self, scene: &mut Scene, structure: &Structure) -> Result<(), ExportError> {
        let [strut_radius, cable_radius, ball_radius] =
            RADII.map(|radius| radius * size(structure));
        let first_cable = first_cable_class(structure);
        for (number, member) in structure.struts().enumerate() {
            let material = repeated(&self.struts, member.class, self.ends);
            let placement = rod(structure, member, strut_radius)?;
            scene.add_node(format!("strut {number}"), self.rod, material, placement)?;
        }
        for (number, member) in structure.cables().enumerate() {
            let class = member.class.saturating_sub(first_cable);
            let material = repeated(&self.cables, class, self.ends);
            let placement = rod(structure, member, cable_radius)?;
            scene.add_node(format!("cable {number}"), self.rod, material, placement)?;
        }
        for (number, node) in structure.nodes().iter().enumerate() {
            let placement = Placement::at(coordinates(*node))?.scaled([ball_radius; 3])?;
            scene.add_node(format!("node {number}"), self.ball, self.ends, placement)?;
        }
        Ok(())
    }
}

/// The scene of one structure, z up.
///
/// # Errors
/// [`ExportError`] as for [`Look::draw`].
pub fn scene(
    name: &str,
    title: &str,
    caption: &str,
    structure: &Structure,
) -> Result<Scene, ExportError> {
    let mut scene = Scene::new(name, title, caption);
    Look::new(&mut scene)?.draw(&mut scene, structure)?;
    Ok(scene)
}

/// The scene of one structure in lines without thickness, for pens and plotters.
///
/// # Errors
/// [`ExportError`] as for [`Look::draw`].
pub fn line_scene(
    name: &str,
    title: &str,
    caption: &str,
    structure: &Structure,
) -> Result<Scene, ExportError> {
    let mut scene = Scene::new(name, title, caption);
    let warm = scene.add_material(Material::new("struts", WARM[0]));
    let cold = scene.add_material(Material::new("cables", COLD[0]));
    for (word, material, role) in [("strut", warm, Role::Strut), ("cable", cold, Role::Cable)] {
        let members = structure.members().iter().filter(|m| m.role == role);
        for (number, member) in members.enumerate() {
            let ends = structure.ends(member).map(coordinates);
            let line = Line::new(ends.to_vec(), false)?;
            scene.add(&format!("{word} {number}"), line, material)?;
        }
    }
    Ok(scene)
}

/// The mean length of the struts.
fn size(structure: &Structure) -> f64 {
    let lengths = structure.struts().map(|strut| structure.length(strut));
    lengths.sum::<f64>() / structure.struts().count().max(1) as f64
}

fn first_cable_class(structure: &Structure) -> usize {
    let classes = structure.cables().map(|cable| cable.class);
    classes.min().unwrap_or(0)
}

/// The material of a class; they repeat where there are more classes.
fn repeated(materials: &[MaterialId], class: usize, other: MaterialId) -> MaterialId {
    let index = class.checked_rem(materials.len()).unwrap_or(0);
    materials.get(index).copied().unwrap_or(other)
}

/// Where the rod of unit length and radius along z stands as this member.
fn rod(structure: &Structure, member: &Member, radius: f64) -> Result<Placement, ExportError> {
    let [from, to] = structure
        .ends(member)
        .map(|end| DVec3::from(coordinates(end)));
    let along = mesh::direction(to - from).unwrap_or(DVec3::Z);
    let [x, y, z, w] = DQuat::from_rotation_arc(DVec3::Z, along).to_array();
    Placement::at(from.to_array())?
        .rotated([w, x, y, z])?
        .scaled([radius, radius, structure.length(member)])
}

fn coordinates(point: Point) -> [f64; 3] {
    point.position().to_array()
}
