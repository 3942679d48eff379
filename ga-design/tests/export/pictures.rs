//! Pictures show the whole scene, in its colours, the same on every run.

use crate::demo;
use ga_design::export::picture::{Image, Settings, render};
use ga_design::export::{ExportError, Line, Material, Placement, Scene, View};
use ga_design::mesh;

const SMALL: Settings = Settings {
    width: 160,
    height: 120,
    samples: 2,
};

fn pixels(image: &Image) -> impl Iterator<Item = ([u32; 2], [u8; 3])> {
    (0..image.height())
        .flat_map(move |y| (0..image.width()).map(move |x| ([x, y], image.pixel(x, y).unwrap())))
}

/// Whether one channel stands out, as in no backdrop or shadow.
fn is_colorful([red, green, blue]: [u8; 3]) -> bool {
    let [least, greatest] = [red.min(green).min(blue), red.max(green).max(blue)];
    greatest - least > 40
}

/// The box around the colourful pixels.
fn extent(image: &Image) -> [u32; 4] {
    let colorful = pixels(image).filter(|&(_, color)| is_colorful(color));
    colorful.fold([u32::MAX, u32::MAX, 0, 0], |[l, t, r, b], ([x, y], _)| {
        [l.min(x), t.min(y), r.max(x), b.max(y)]
    })
}

fn ball(center: [f64; 3], radius: f64) -> Result<Scene, ExportError> {
    let mut scene = Scene::new("ball", "A ball", "");
    let sphere = scene.add_shape("sphere", mesh::icosphere(3)?);
    let red = scene.add_material(Material::new("red", [200, 40, 40]));
    scene.add_node(
        "ball",
        sphere,
        red,
        Placement::at(center)?.scaled([radius; 3])?,
    )?;
    Ok(scene)
}

#[test]
fn the_scene_is_framed_whole_and_centred_wherever_and_however_large_it_is() {
    for (center, radius) in [
        ([0.0; 3], 1.0),
        ([1e3, -2e3, 5e2], 1e-3),
        ([1e9, 0.0, 0.0], 1e12),
    ] {
        let image = render(&ball(center, radius).unwrap(), &SMALL).unwrap();
        let [left, top, right, bottom] = extent(&image);
        assert!(left.abs_diff(160 - 1 - right) <= 2, "{left} {right}");
        assert!(top.abs_diff(120 - 1 - bottom) <= 2, "{top} {bottom}");
        // 86 % of the height.
        assert!((bottom - top).abs_diff(103) <= 3, "{top} {bottom}");
        assert!((right - left).abs_diff(bottom - top) <= 2);
    }
}

#[test]
fn every_part_of_a_scene_is_inside_the_picture_from_everywhere() {
    let mut scene = demo::crystal().unwrap();
    for azimuth in [-3.0, -1.0, 0.4, 2.0] {
        for elevation in [-1.5, -0.5, 0.0, 0.7, std::f64::consts::FRAC_PI_2] {
            scene.set_view(View { azimuth, elevation }).unwrap();
            let image = render(
                &scene,
                &Settings {
                    width: 80,
                    height: 60,
                    samples: 1,
                },
            )
            .unwrap();
            let [left, top, right, bottom] = extent(&image);
            assert!(left > 0 && top > 0 && right < 79 && bottom < 59);
        }
    }
}

#[test]
fn a_picture_is_the_same_every_time_and_survives_its_encoding() {
    let scene = demo::knot().unwrap();
    let image = render(&scene, &SMALL).unwrap();
    assert_eq!(image, render(&scene, &SMALL).unwrap());
    let file = image.to_png().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    let original: Vec<u8> = pixels(&image).flat_map(|(_, color)| color).collect();
    assert_eq!(bytes, original);
}

#[test]
fn near_things_hide_far_ones_and_glass_lets_them_through() {
    let scene = |opacity: f64| -> Result<Scene, ExportError> {
        let mut scene = Scene::new("two", "Two", "");
        let sphere = scene.add_shape("sphere", mesh::icosphere(3)?);
        let blue = Material::new("blue", [30, 60, 220]).with_opacity(opacity)?;
        let blue = scene.add_material(blue);
        let red = scene.add_material(Material::new("red", [220, 40, 30]));
        // Seen along x: the blue ball is nearer.
        scene.set_view(View {
            azimuth: 0.0,
            elevation: 0.0,
        })?;
        scene.add_node("near", sphere, blue, Placement::at([2.0, 0.0, 0.0])?)?;
        scene.add_node("far", sphere, red, Placement::at([-2.0, 0.0, 0.0])?)?;
        Ok(scene)
    };
    let middle = |opacity| {
        let image = render(&scene(opacity).unwrap(), &SMALL).unwrap();
        image.pixel(80, 60).unwrap()
    };
    let [red, _, blue] = middle(1.0);
    assert!(blue > red + 60);
    let [red, _, blue] = middle(0.15);
    assert!(red > blue + 40);
}

#[test]
fn a_ball_throws_a_shadow_on_the_floor() {
    let image = render(&ball([0.0; 3], 1.0).unwrap(), &SMALL).unwrap();
    let gray = |x: u32, y: u32| image.pixel(x, y).unwrap()[0];
    // The light comes from the left: at the same height the right side is darker.
    let darkest = |range: std::ops::Range<u32>| range.map(|x| gray(x, 104)).min().unwrap();
    assert!(
        darkest(130..160) + 8 < darkest(0..30),
        "{} {}",
        darkest(130..160),
        darkest(0..30)
    );
}

#[test]
fn lines_points_and_flat_scenes_are_drawn() {
    let mut scene = Scene::new("lines", "Lines", "");
    let ink = scene.add_material(Material::new("ink", [20, 20, 160]));
    let cross = vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    scene
        .add("line", Line::new(cross, false).unwrap(), ink)
        .unwrap();
    // A line all of whose points coincide, closed or not, shows nothing and breaks nothing.
    scene
        .add("dot", Line::new(vec![[0.5; 3]; 4], true).unwrap(), ink)
        .unwrap();
    let large = Settings {
        width: 640,
        height: 480,
        samples: 1,
    };
    let image = render(&scene, &large).unwrap();
    assert!(
        pixels(&image)
            .filter(|&(_, color)| is_colorful(color))
            .count()
            > 500
    );
    let mut dot = Scene::new("dot", "Dot", "");
    let ink = dot.add_material(Material::new("ink", [20, 20, 160]));
    dot.add("dot", Line::new(vec![[7.0; 3]; 2], false).unwrap(), ink)
        .unwrap();
    assert!(render(&dot, &SMALL).is_ok());
}

#[test]
fn impossible_sizes_are_refused() {
    let scene = ball([0.0; 3], 1.0).unwrap();
    for (width, height) in [
        (0, 10),
        (10, 0),
        (8193, 10),
        (8192, 8192),
        (u32::MAX, u32::MAX),
    ] {
        let settings = Settings {
            width,
            height,
            samples: 1,
        };
        let error = render(&scene, &settings).unwrap_err();
        assert!(matches!(error, ExportError::PictureSize { .. }));
    }
    let one = Settings {
        width: 1,
        height: 1,
        samples: 0,
    };
    let image = render(&scene, &one).unwrap();
    assert_eq!((image.width(), image.height()), (1, 1));
    assert_eq!(image.halved(), image);
}
