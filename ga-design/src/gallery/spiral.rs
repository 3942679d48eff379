//! A sphere under the powers of a rotor times a dilator makes a string of pearls, each touching the
//! next (the conformal motion of figure 2.14 c with a turn).

use super::GalleryError;
use super::palette::{course, solid};
use crate::export::{Placement, Scene, View};
use crate::mesh;
use ga_cga::{Dilator, DualSphere, MinkowskiPlane, Rotor, Vector3};

/// The number of pearls.
const PEARLS: usize = 64;

/// The radius of a pearl over its distance from the centre.
const RADIUS: f64 = 0.183;

/// The angle from one pearl to the next, in radians.
const ANGLE: f64 = 0.36;

/// The scale from one pearl to the next for which they touch.
///
/// Centres at distances 1 and s whose directions make the angle θ are √(1 + s² − 2 s cos θ) apart, and
/// spheres of radii r and r s touch when that is r (1 + s): a quadratic equation for s, of whose roots,
/// reciprocal to each other, this is the smaller.
fn scale() -> f64 {
    let square = RADIUS * RADIUS;
    let half = (ANGLE.cos() + square) / (1.0 - square);
    half - (half * half - 1.0).max(0.0).sqrt()
}

/// The pearls: one sphere and its images.
fn pearls() -> Result<Vec<DualSphere>, GalleryError> {
    let axis = Vector3::new(0.0, 0.0, 1.0);
    let rotor = Rotor::about_axis(axis, ANGLE);
    let rotor = rotor.ok_or(GalleryError::Degenerate {
        what: "the axis of the spiral",
    })?;
    // e^{−cE/2} scales by e^{−c}.
    let dilator: Dilator = MinkowskiPlane::new(0.5 * scale().ln()).exp();
    let first = DualSphere::with_radius(Vector3::new(1.0, 0.0, 0.0), RADIUS);
    let next = |sphere: &DualSphere| Some(dilator.apply(rotor.apply(*sphere)));
    Ok(std::iter::successors(Some(first), next)
        .take(PEARLS)
        .collect())
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "spiral",
        "String of pearls",
        "One sphere under the powers of a rotor times a dilator. The versor moves the sphere as a whole, \
         centre and radius at once, and keeps angles: because the first two pearls touch, all \
         neighbours do.",
    );
    let sphere = scene.add_shape("sphere", mesh::icosphere(4)?);
    for (number, pearl) in pearls()?.into_iter().enumerate() {
        let Some((centre, square)) = pearl.center().zip(pearl.radius_squared()) else {
            return Err(GalleryError::Degenerate { what: "a pearl" });
        };
        let part = number as f64 / (PEARLS - 1) as f64;
        let color = course(part);
        let name = format!("pearl {number}");
        let material = scene.add_material(solid(&name, color)?);
        let [x, y, z] = centre.position().to_array().map(|c| 4.0 * c);
        let radius = 4.0 * square.abs().sqrt();
        // Every pearl rests on the floor.
        let placement = Placement::at([x, y, z + radius])?.scaled([radius; 3])?;
        scene.add_node(name, sphere, material, placement)?;
    }
    scene.set_view(View {
        azimuth: -1.2,
        elevation: 0.72,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cosine of the angle at which two spheres meet: −1 when they touch from outside.
    fn cosine(one: DualSphere, other: DualSphere) -> f64 {
        one.scalar_product(other) / (one.norm() * other.norm())
    }

    #[test]
    fn all_neighbours_touch() -> Result<(), GalleryError> {
        let pearls = pearls()?;
        for (one, other) in pearls.iter().zip(pearls.iter().skip(1)) {
            assert!((cosine(*one, *other) + 1.0).abs() < 1e-9);
            let apart = one.center().zip(other.center()).map(|(a, b)| a.distance(b));
            let radii =
                [one, other].map(|sphere| sphere.radius_squared().unwrap_or(f64::NAN).sqrt());
            assert!((apart.unwrap_or(f64::NAN) - radii[0] - radii[1]).abs() < 1e-12);
        }
        Ok(())
    }
}
