//! Decides how a scene becomes a picture: framed, rasterised, lit, and averaged down.
//!
//! A small renderer for quiet, clear pictures of structures, without a graphics card and with the
//! same result on every run: a depth buffer with several samples per pixel, one soft key light with
//! shadows, a fill light and a sky, ambient occlusion, thin outlines where one thing passes in front
//! of another, and a floor that is seen only by the shadow that falls on it.

mod backdrop;
pub mod camera;
mod geometry;
mod height_map;
mod image;
mod occlusion;
mod raster;
mod shade;
mod shadow;

pub use image::Image;

use super::{ExportError, Format, Scene, flatten};
use backdrop::Backdrop;
use camera::Camera;
use geometry::Geometry;
use glam::Vec3;
use raster::{FLOOR, NOTHING, Samples};
use shade::Light;
use shadow::ShadowMap;

/// The size and care of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Settings {
    /// Pixels across, from 1 to 8192.
    pub width: u32,
    /// Pixels down, from 1 to 8192.
    pub height: u32,
    /// Samples per pixel along each side; more than four are taken as four, none as one, and a very
    /// large picture has fewer.
    pub samples: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            width: 960,
            height: 720,
            samples: 2,
        }
    }
}

/// The most samples that are held at once, some forty bytes each.
const MOST_SAMPLES: usize = 1 << 25;

/// The picture of a scene, seen from its view and framed to fill the picture.
///
/// Lines are drawn as thin rods. Equal scenes give equal pictures.
///
/// ```
/// use ga_design::export::{Material, Scene, picture};
/// let mut scene = Scene::new("ball", "A ball", "");
/// let red = scene.add_material(Material::new("red", [200, 40, 40]));
/// scene.add("ball", ga_design::mesh::icosphere(2)?, red)?;
/// let settings = picture::Settings { width: 32, height: 24, samples: 1 };
/// let image = picture::render(&scene, &settings)?;
/// let [red, green, _] = image.pixel(16, 12).unwrap_or_default();
/// assert!(red > green);
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
///
/// # Errors
/// [`ExportError`] if the scene is empty or the picture has no pixels or too many.
pub fn render(scene: &Scene, settings: &Settings) -> Result<Image, ExportError> {
    flatten::check_drawable(scene, Format::Png)?;
    let sides = 1..=8192;
    let [across, down] = [settings.width, settings.height].map(|side| side as usize);
    let fits = sides.contains(&across) && sides.contains(&down) && across * down <= MOST_SAMPLES;
    if !fits {
        return Err(ExportError::PictureSize {
            width: settings.width,
            height: settings.height,
        });
    }
    let affordable = (MOST_SAMPLES / (across * down)).isqrt();
    let per_side = (settings.samples as usize).clamp(1, 4).min(affordable);
    let [width, height] = [across, down].map(|side| side * per_side);
    let geometry = Geometry::of(scene);
    let camera = Camera::framing(&geometry, scene.view(), width, height);
    let light = Light::of(&camera);
    let shadows = ShadowMap::cast(&geometry, light.key, width.max(height));
    let backdrop = Backdrop::below(&geometry, &camera, &light);

    let mut samples = Samples::new(width, height);
    raster::draw_opaque(&mut samples, &geometry, &camera);
    backdrop.draw_floor(&mut samples, &camera);
    let openness = occlusion::openness(&samples, &camera);
    let mut colors = vec![Vec3::ZERO; width * height];
    for (index, color) in colors.iter_mut().enumerate() {
        let pixel = [index % width, index / width];
        let Some(sample) = samples.get(index) else {
            continue;
        };
        let open = openness.get(index).copied().unwrap_or(1.0);
        *color = match sample.surface {
            NOTHING => backdrop.color(pixel[1], height),
            FLOOR => {
                let point = camera.point(pixel, sample.nearness);
                let lit = shadows.lit(point, sample.normal, pixel);
                backdrop.floor_color(point, lit, open, pixel[1], height)
            }
            _ => match geometry.look_of(sample.surface) {
                Some(look) => {
                    let point = camera.point(pixel, sample.nearness);
                    let lit = shadows.lit(point, sample.normal, pixel);
                    let seen = light.shade(look, &camera, point, sample.normal, lit, open);
                    seen * outline(&samples, &geometry, pixel, sample)
                }
                None => Vec3::ZERO,
            },
        };
    }
    raster::blend_transparent(
        &mut colors,
        &samples,
        &geometry,
        &camera,
        |look, point, normal, pixel| {
            let lit = shadows.lit(point, normal, pixel);
            light.shade(look, &camera, point, normal, lit, 1.0)
        },
    );
    Ok(Image::averaged(&colors, width, height, per_side))
}

/// How much an outline darkens a sample: it does where a neighbour belongs to something that lies
/// farther away.
fn outline(
    samples: &Samples,
    geometry: &Geometry,
    [x, y]: [usize; 2],
    here: raster::Sample,
) -> f32 {
    const DARKENING: f32 = 0.45;
    let is_rod = |surface| geometry.look_of(surface).is_some_and(|look| look.is_line);
    if is_rod(here.surface) {
        return 1.0;
    }
    let neighbours = [
        [x.wrapping_sub(1), y],
        [x + 1, y],
        [x, y.wrapping_sub(1)],
        [x, y + 1],
    ];
    let behind = neighbours.into_iter().any(|[x, y]| {
        samples.at(x, y).is_some_and(|other| {
            other.surface != here.surface && other.nearness < here.nearness * 0.997
        })
    });
    if behind { DARKENING } else { 1.0 }
}
