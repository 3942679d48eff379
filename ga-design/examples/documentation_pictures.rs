//! Draws the pictures in the documentation of ga-cga anew, from the scenes of the gallery:
//! `cargo run --release -p ga-design --example documentation_pictures`.

use std::error::Error;
use std::fs;
use std::path::Path;

use base64::{Engine, engine::general_purpose::STANDARD};
use ga_design::export::picture::{self, Settings};
use ga_design::gallery;

/// The scenes that the documentation shows, and what a reader who cannot see them is told.
const PICTURES: [(&str, &str); 4] = [
    (
        "covariance",
        "A circle carried by a screw, with the points that span it",
    ),
    (
        "meets",
        "Circles and point pairs where spheres and a plane meet",
    ),
    ("motions", "A rotation, a translation and a screw"),
    (
        "conformal-motions",
        "A scaling, a transversion and a motion along a circle",
    ),
];

/// Small enough to stand in a page without a file of its own.
const SIZE: Settings = Settings {
    width: 320,
    height: 240,
    samples: 3,
};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../ga-cga/pictures");
    for (name, description) in PICTURES {
        let entry = gallery::entries().iter().find(|entry| entry.name == name);
        let scene = entry.ok_or("no such scene")?.scene()?;
        let image = STANDARD.encode(picture::render(&scene, &SIZE)?.to_png()?);
        let text = format!("![{description}](data:image/png;base64,{image})\n");
        fs::write(folder.join(format!("{name}.md")), text)?;
    }
    Ok(())
}
