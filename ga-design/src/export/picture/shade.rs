//! Decides how bright a surface is: a key light, a fill light, a sky, and their reflections.

use super::camera::Camera;
use super::geometry::Look;
use glam::{DVec3, Vec3};
use std::f32::consts::PI;

/// The lights of a picture; they stand beside the eye and turn with it.
pub(super) struct Light {
    /// The unit vector towards the key light: above and to the left of the eye.
    pub key: DVec3,
    fill: Vec3,
}

const KEY_STRENGTH: f32 = 0.74;
const FILL_STRENGTH: f32 = 0.16;
const SKY: Vec3 = Vec3::new(0.44, 0.46, 0.49);
const EARTH: Vec3 = Vec3::new(0.25, 0.24, 0.23);

impl Light {
    pub fn of(camera: &Camera) -> Self {
        let key = camera.towards * 0.55 - camera.right * 0.5 + DVec3::Z * 0.55 + camera.up * 0.25;
        let fill = camera.towards * 0.5 + camera.right * 0.8 + camera.up * 0.1;
        Self {
            key: key.normalize_or(DVec3::Z),
            fill: fill.as_vec3().normalize_or(Vec3::X),
        }
    }

    /// The light, in red, green and blue, that goes from a point to the eye.
    pub fn shade(
        &self,
        look: &Look,
        camera: &Camera,
        point: Vec3,
        normal: Vec3,
        lit: f32,
        open: f32,
    ) -> Vec3 {
        let to_eye = (camera.eye.as_vec3() - point).normalize_or(Vec3::Z);
        let key = self.key.as_vec3();
        let facing = normal.dot(key).max(0.0) * lit;
        let filled = normal.dot(self.fill).max(0.0);
        let ambient = sky(normal.z);
        let diffuse = look.color
            * (1.0 - look.metallic)
            * (Vec3::splat(KEY_STRENGTH * facing + FILL_STRENGTH * filled * open) + ambient * open);

        // Metals reflect in their own colour, all else a twenty-fifth of white (Schlick 1994).
        let straight = Vec3::splat(0.04).lerp(look.color, look.metallic);
        let slant = (1.0 - normal.dot(to_eye).max(0.0)).powi(5);
        let smooth = 1.0 - look.roughness;
        let grazing = Vec3::splat(0.5 * smooth).max(straight) - straight;
        let mirrored = straight + grazing * slant;
        let reflected = 2.0 * normal.dot(to_eye) * normal - to_eye;
        let highlight = self.highlight(look, normal, to_eye) * facing * KEY_STRENGTH;
        let surroundings = sky((reflected.z * (0.4 + 0.6 * smooth)).clamp(-1.0, 1.0)) * 1.8;
        diffuse + mirrored * (Vec3::splat(highlight) + surroundings * open)
    }

    /// The key light's reflection on microscopic facets (Walter, Marschner, Li, Torrance 2007),
    /// without the slope-dependent part that only matters at grazing angles.
    fn highlight(&self, look: &Look, normal: Vec3, to_eye: Vec3) -> f32 {
        let halfway = (self.key.as_vec3() + to_eye).normalize_or(normal);
        let spread = look.roughness.max(0.18).powi(4);
        let cosine = normal.dot(halfway).max(0.0);
        let fall = cosine * cosine * (spread - 1.0) + 1.0;
        (spread / (PI * fall * fall)).min(12.0)
    }
}

/// The light from above and below, by the upward part of a direction.
fn sky(up: f32) -> Vec3 {
    EARTH.lerp(SKY, 0.5 + 0.5 * up)
}
