//! Two scenes to export: a small crystal with its cell, and a knot with a line, a disc and arrows.

use ga_design::export::{ExportError, Line, Material, Placement, Scene};
use ga_design::mesh::{self, Ends};
use std::f64::consts::TAU;

/// The number of balls in [`crystal`].
pub const BALLS: usize = 27;

/// A cubic arrangement of balls of two kinds, which share one sphere, with the frame of its cell.
pub fn crystal() -> Result<Scene, ExportError> {
    let mut scene = Scene::new(
        "crystal",
        "Halite & <its> “cell”",
        "Chloride (green) and sodium (violet) alternate.\nEach ball is one sphere, placed.",
    );
    let sphere = scene.add_shape("sphere", mesh::icosphere(3)?);
    let green = Material::new("chlorine", [76, 180, 90]).with_roughness(0.35)?;
    let violet = Material::new("sodium", [128, 104, 190]).with_roughness(0.35)?;
    let kinds = [
        (scene.add_material(green), 1.02),
        (scene.add_material(violet), 0.66),
    ];
    for number in 0..BALLS {
        let [x, y, z] = [number % 3, number / 3 % 3, number / 9];
        let (kind, radius) = kinds[(x + y + z) % 2];
        let place = [x, y, z].map(|c| 2.82 * c as f64);
        let placement = Placement::at(place)?.scaled([radius; 3])?;
        scene.add_node(format!("ball {number}"), sphere, kind, placement)?;
    }
    let steel = Material::new("cell", [70, 76, 88]).with_metallic(0.6)?;
    let steel = scene.add_material(steel);
    let edges = [[5.64, 0.0, 0.0], [0.0, 5.64, 0.0], [0.0, 0.0, 5.64]];
    scene.add("cell", mesh::box_edges([0.0; 3], edges, 0.06, 12)?, steel)?;
    Ok(scene)
}

/// A trefoil tube with its core circle as a line, a glass disc, a ring and two arrows.
pub fn knot() -> Result<Scene, ExportError> {
    let mut scene = Scene::new(
        "knot",
        "Torus knot",
        "The (2, 3) knot, its axis and its circle.",
    );
    let point = |t: f64, wide: f64, high: f64| {
        let around = 2.0 + wide * (3.0 * t).cos();
        [
            around * (2.0 * t).cos(),
            around * (2.0 * t).sin(),
            high * (3.0 * t).sin(),
        ]
    };
    let turns = |count: usize| (0..count).map(move |i| TAU * i as f64 / count as f64);
    let knot: Vec<_> = turns(240).map(|t| point(t, 0.8, 0.8)).collect();
    let orange = scene.add_material(Material::new("orange", [226, 120, 48]).with_roughness(0.3)?);
    scene.add("knot", mesh::tube(&knot, Ends::Closed, 0.22, 20)?, orange)?;
    let circle = turns(96)
        .map(|t| [2.0 * t.cos(), 2.0 * t.sin(), 0.0])
        .collect();
    let blue = scene.add_material(Material::new("blue", [40, 90, 170]));
    scene.add("circle", Line::new(circle, true)?, blue)?;
    let axis = vec![[0.0, 0.0, -1.6], [0.0, 0.0, 0.0], [0.0, 0.0, 1.2]];
    scene.add("axis", Line::new(axis, false)?, blue)?;
    let glass = scene.add_material(Material::new("glass", [110, 170, 210]).with_opacity(0.3)?);
    scene.add(
        "inside",
        mesh::disc([0.0; 3], [0.0, 0.0, 1.0], 2.0, 96)?,
        glass,
    )?;
    let gold = Material::new("gold", [230, 180, 80])
        .with_metallic(1.0)?
        .with_roughness(0.3)?;
    let gold = scene.add_material(gold);
    let ring = mesh::torus([0.0; 3], [0.0, 0.0, 1.0], 3.3, 0.1, 96, 16)?;
    scene.add("ring", ring, gold)?;
    let arrow = scene.add_shape("arrow", mesh::arrow([0.0; 3], [0.0, 0.0, 1.0], 0.06, 16)?);
    let up = Placement::at([0.0, 0.0, 0.6])?;
    scene.add_node("up", arrow, gold, up)?;
    // A quarter turn about x: z goes to −y.
    let aside = up.rotated([1.0, 1.0, 0.0, 0.0])?.scaled([1.0, 1.0, 1.5])?;
    scene.add_node("aside", arrow, gold, aside)?;
    Ok(scene)
}
