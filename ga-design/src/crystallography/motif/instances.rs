//! How a mesh is shown in many places: stored once, and once more mirrored for the copies of the other
//! hand, and placed by every isometry.

use ga_cga::{DualPlane, Motor, Vector3};

use super::surface::image;
use crate::crystallography::Isometry;
use crate::export::{ExportError, MaterialId, Placement, Scene};
use crate::mesh::Mesh;

/// Adds a node for each isometry that places the mesh there; those with a reflection place its mirror
/// image, with a material of their own, so that nothing is turned inside out.
///
/// # Errors
/// [`ExportError`] if a material is of another scene, or a copy would be too far away.
pub fn add_instances(
    scene: &mut Scene,
    name: &str,
    mesh: &Mesh,
    [turned, mirrored]: [MaterialId; 2],
    isometries: impl IntoIterator<Item = Isometry>,
) -> Result<(), ExportError> {
    let across = DualPlane::at_distance(Vector3::new(1.0, 0.0, 0.0), 0.0);
    let reflection = Isometry::from(across);
    let mut shapes = [None; 2];
    for (number, isometry) in isometries.into_iter().enumerate() {
        // The image of the mesh is that of its mirror image after the mirror is undone.
        let (slot, motor, material) = match isometry.mirror {
            None => (0, isometry.motor, turned),
            Some(mirror) => (1, isometry.motor * (mirror * across), mirrored),
        };
        let shape = match shapes.get(slot).copied().flatten() {
            Some(shape) => shape,
            None => {
                let (name, mesh) = if slot == 0 {
                    (name.to_owned(), mesh.clone())
                } else {
                    let image = image(mesh, &reflection)?;
                    (format!("{name}, mirrored"), image)
                };
                let shape = scene.add_shape(name, mesh);
                if let Some(known) = shapes.get_mut(slot) {
                    *known = Some(shape);
                }
                shape
            }
        };
        scene.add_node(format!("{name} {number}"), shape, material, placed(motor)?)?;
    }
    Ok(())
}

/// The placement that a motor is; one that is no versor has none and counts as too far away.
fn placed(motor: Motor) -> Result<Placement, ExportError> {
    let parts = motor.rotation().zip(motor.translation());
    let (rotation, shift) = parts.map_or(([f64::NAN; 4], [f64::NAN; 3]), |(rotor, translator)| {
        (rotor.to_quaternion(), translator.vector().to_array())
    });
    Placement::at(shift)?.rotated(rotation)
}
