//! Decides what a scene is: named nodes that place shared shapes and materials, a title and a caption.

use super::{Attachment, ExportError, Material, Placement, View};
use crate::mesh::{self, Mesh};

/// A line through points, without thickness.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    points: Vec<[f64; 3]>,
    closed: bool,
}

impl Line {
    /// The line through these points, and back to the first if it is closed.
    ///
    /// # Errors
    /// [`ExportError`] if there are fewer than two points, or a coordinate is not finite or too
    /// large.
    pub fn new(points: Vec<[f64; 3]>, closed: bool) -> Result<Self, ExportError> {
        if points.len() < 2 {
            return Err(ExportError::ShortLine);
        }
        for &point in &points {
            mesh::checked_point("a point of a line", point)?;
        }
        Ok(Self { points, closed })
    }

    /// The points, each once.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// Whether the last point is joined to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }
}

/// What a node shows.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A surface.
    Surface(Mesh),
    /// A line.
    Line(Line),
}

impl Shape {
    /// The vertices or points.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        match self {
            Shape::Surface(mesh) => mesh.positions(),
            Shape::Line(line) => line.points(),
        }
    }
}

impl From<Mesh> for Shape {
    fn from(mesh: Mesh) -> Self {
        Shape::Surface(mesh)
    }
}

impl From<Line> for Shape {
    fn from(line: Line) -> Self {
        Shape::Line(line)
    }
}

/// A shape of one scene, to be named by its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ShapeId(pub(super) usize);

/// A material of one scene, to be named by its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MaterialId(pub(super) usize);

/// One thing in a scene: a shape, of a material, at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is called, such as an atom's label.
    pub name: String,
    /// What it shows.
    pub shape: ShapeId,
    /// How it looks.
    pub material: MaterialId,
    /// Where it stands.
    pub placement: Placement,
}

/// Many things alike: a shape, of a material, at many places.
///
/// A crystal of a million atoms is a few of these, where a node for each atom would be more than
/// most programs open. They have one name together.
#[derive(Debug, Clone, PartialEq)]
pub struct Instances {
    /// What they are called together, such as the name of an element.
    pub name: String,
    /// What each shows.
    pub shape: ShapeId,
    /// How each looks.
    pub material: MaterialId,
    /// Where they stand.
    pub placements: Vec<Placement>,
}

/// A shape at its place, whether a node of its own or one of many instances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed<'a> {
    /// The name of the node, or of the instances together.
    pub name: &'a str,
    /// Where it stands.
    pub placement: &'a Placement,
}

/// A picture's or a model's content, in the unit and the right-handed axes of the design; z is up.
///
/// Shapes are stored once and placed many times: the atoms of a crystal are nodes that share one
/// sphere.
///
/// ```
/// use ga_design::export::{Material, Placement, Scene};
/// let mut scene = Scene::new("pair", "Two balls", "Both are one sphere, placed twice.");
/// let ball = scene.add_shape("sphere", ga_design::mesh::icosphere(2)?);
/// let red = scene.add_material(Material::new("red", [200, 40, 40]));
/// scene.add_node("left", ball, red, Placement::at([-1.0, 0.0, 0.0])?)?;
/// scene.add_node("right", ball, red, Placement::at([1.0, 0.0, 0.0])?)?;
/// assert_eq!(scene.nodes().len(), 2);
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    name: String,
    title: String,
    caption: String,
    view: View,
    shapes: Vec<(String, Shape)>,
    /// The corners of the box around each shape.
    bounds: Vec<[[f64; 3]; 2]>,
    materials: Vec<Material>,
    nodes: Vec<Node>,
    instances: Vec<Instances>,
    attachments: Vec<Attachment>,
}

impl Scene {
    /// An empty scene. The name is for files and links (lower-case letters, digits and hyphens in a
    /// gallery); title and caption are read by people.
    #[must_use]
    pub fn new(
        name: impl Into<String>,
        title: impl Into<String>,
        caption: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            title: title.into(),
            caption: caption.into(),
            view: View::default(),
            shapes: Vec::new(),
            bounds: Vec::new(),
            materials: Vec::new(),
            nodes: Vec::new(),
            instances: Vec::new(),
            attachments: Vec::new(),
        }
    }

    /// Looks at the scene from another direction.
    ///
    /// # Errors
    /// [`ExportError::Number`] if an angle is not finite, or the elevation is beyond ±π/2.
    pub fn set_view(&mut self, view: View) -> Result<(), ExportError> {
        if !view.azimuth.is_finite() {
            return Err(ExportError::Number {
                what: "the azimuth of a view",
                value: view.azimuth,
                remedy: "it must be finite",
            });
        }
        let elevations = -std::f64::consts::FRAC_PI_2..=std::f64::consts::FRAC_PI_2;
        if !elevations.contains(&view.elevation) {
            return Err(ExportError::Number {
                what: "the elevation of a view",
                value: view.elevation,
                remedy: "it must be from −π/2 to π/2",
            });
        }
        self.view = view;
        Ok(())
    }

    /// Adds a shape that nodes may place; the name becomes the name of the mesh in the file.
    pub fn add_shape(&mut self, name: impl Into<String>, shape: impl Into<Shape>) -> ShapeId {
        let shape = shape.into();
        let points = shape.points().iter().map(|&p| glam::DVec3::from(p));
        self.bounds.push(mesh::bounds(points).unwrap_or_default());
        self.shapes.push((name.into(), shape));
        ShapeId(self.shapes.len() - 1)
    }

    /// Adds a material that nodes may have.
    pub fn add_material(&mut self, material: Material) -> MaterialId {
        self.materials.push(material);
        MaterialId(self.materials.len() - 1)
    }

    /// Places a shape.
    ///
    /// # Errors
    /// [`ExportError`] if this scene has no such shape or material, or a placed vertex would be too
    /// far away.
    pub fn add_node(
        &mut self,
        name: impl Into<String>,
        shape: ShapeId,
        material: MaterialId,
        placement: Placement,
    ) -> Result<(), ExportError> {
        let name = name.into();
        let bounds = self.bounds_of(&name, shape, material)?;
        placement.check(bounds)?;
        self.nodes.push(Node {
            name,
            shape,
            material,
            placement,
        });
        Ok(())
    }

    /// Places a shape many times, without a node for each; nothing is added for no placements.
    ///
    /// In a GLB file they are one node with the extension `EXT_mesh_gpu_instancing`; in every other
    /// format each is there like a node.
    ///
    /// # Errors
    /// [`ExportError`] as for [`Scene::add_node`].
    pub fn add_instances(
        &mut self,
        name: impl Into<String>,
        shape: ShapeId,
        material: MaterialId,
        placements: Vec<Placement>,
    ) -> Result<(), ExportError> {
        let name = name.into();
        let bounds = self.bounds_of(&name, shape, material)?;
        for placement in &placements {
            placement.check(bounds)?;
        }
        if !placements.is_empty() {
            self.instances.push(Instances {
                name,
                shape,
                material,
                placements,
            });
        }
        Ok(())
    }

    /// Adds a drawing that a gallery writes beside the scene; other formats leave it out.
    pub fn attach(&mut self, attachment: Attachment) {
        self.attachments.push(attachment);
    }

    /// The drawings that go with the scene.
    #[must_use]
    pub fn attachments(&self) -> &[Attachment] {
        &self.attachments
    }

    /// The box around a shape, if the scene has both the shape and the material.
    fn bounds_of(
        &self,
        name: &str,
        shape: ShapeId,
        material: MaterialId,
    ) -> Result<[[f64; 3]; 2], ExportError> {
        let foreign = |kind| ExportError::Foreign {
            node: name.to_owned(),
            kind,
        };
        let bounds = self.bounds.get(shape.0).ok_or_else(|| foreign("shape"))?;
        if material.0 >= self.materials.len() {
            return Err(foreign("material"));
        }
        Ok(*bounds)
    }

    /// Adds a shape that is used once, where it is.
    ///
    /// # Errors
    /// [`ExportError`] as for [`Scene::add_node`].
    pub fn add(
        &mut self,
        name: &str,
        shape: impl Into<Shape>,
        material: MaterialId,
    ) -> Result<(), ExportError> {
        let shape = self.add_shape(name, shape);
        self.add_node(name, shape, material, Placement::default())
    }

    /// The name for files and links.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The caption.
    #[must_use]
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// The direction from which it is looked at.
    #[must_use]
    pub fn view(&self) -> View {
        self.view
    }

    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The instances that are no nodes.
    #[must_use]
    pub fn instances(&self) -> &[Instances] {
        &self.instances
    }

    /// The materials, in the order in which they were added.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// The shapes with their names, in the order in which they were added.
    #[must_use]
    pub fn shapes(&self) -> &[(String, Shape)] {
        &self.shapes
    }

    /// Everything that is shown, nodes before instances, with shape and material.
    pub fn placed(&self) -> impl Iterator<Item = (Placed<'_>, &Shape, &Material)> {
        let nodes = self.nodes.iter().map(|node| {
            let placed = Placed {
                name: &node.name,
                placement: &node.placement,
            };
            (placed, node.shape, node.material)
        });
        let instances = self.instances.iter().flat_map(|all| {
            let name = &all.name;
            let placed = all
                .placements
                .iter()
                .map(move |placement| Placed { name, placement });
            placed.map(|placed| (placed, all.shape, all.material))
        });
        nodes
            .chain(instances)
            .filter_map(|(placed, shape, material)| {
                let (_, shape) = self.shapes.get(shape.0)?;
                Some((placed, shape, self.materials.get(material.0)?))
            })
    }

    /// An error if nothing is shown.
    pub(super) fn check_not_empty(&self) -> Result<(), ExportError> {
        if self.nodes.is_empty() && self.instances.is_empty() {
            return Err(ExportError::EmptyScene {
                scene: self.title.clone(),
            });
        }
        Ok(())
    }
}
