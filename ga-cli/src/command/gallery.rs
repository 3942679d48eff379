//! `articulate gallery`: the scenes that there are, as a page to look at and as files.

use crate::failure::Failure;
use crate::{output, progress};
use clap::builder::PossibleValuesParser;
use ga_design::export::gallery::drawing_path;
use ga_design::export::picture::Settings;
use ga_design::export::{Scene, write_gallery};
use ga_design::gallery::{Entry, entries};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Draws every scene into a folder: an interactive page that works offline, a GLB and a PNG for each
/// scene, and in plane-groups/ an SVG drawing for each of the 17 plane groups.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The folder; it is made if it is not there, and files of the same names in it are replaced.
    #[arg(long, value_name = "DIR", default_value = "gallery")]
    out: PathBuf,
    /// Draw only these scenes, in the order of the gallery.
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        value_parser = PossibleValuesParser::new(entries().iter().map(|entry| entry.name))
    )]
    only: Vec<String>,
    /// Print the scenes and their files as JSON.
    #[arg(long, help = JSON)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  articulate gallery
  articulate gallery --only quartz,covariance --out pictures";

const JSON: &str = "Print the scenes and their files as JSON: {index, scenes:[{name, title, caption, glb, \
                    png, svg:[…]}]}; svg holds the drawings that go with the scene";

#[derive(Serialize)]
struct Made<'a> {
    index: &'a Path,
    scenes: Vec<MadeScene<'a>>,
}

#[derive(Serialize)]
struct MadeScene<'a> {
    name: &'a str,
    title: &'a str,
    caption: &'a str,
    glb: PathBuf,
    png: PathBuf,
    svg: Vec<PathBuf>,
}

/// Draws the scenes and tells where to look.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let asked = |entry: &&Entry| {
        arguments.only.is_empty() || arguments.only.iter().any(|name| name == entry.name)
    };
    let scenes = entries()
        .iter()
        .filter(asked)
        .map(made)
        .collect::<Result<Vec<_>, _>>()?;
    let bar = progress::steps(scenes.len());
    let index = write_gallery(&scenes, &arguments.out, &Settings::default(), |scene| {
        bar.set_message(scene.title().to_owned());
        bar.inc(1);
    });
    bar.finish_and_clear();
    let index = index?;
    if arguments.json {
        let scenes = scenes
            .iter()
            .map(|scene| described(scene, &arguments.out))
            .collect();
        return output::print_json(&Made {
            index: &index,
            scenes,
        });
    }
    let plural = if scenes.len() == 1 { "scene" } else { "scenes" };
    output::print(&format!(
        "{} {plural} in {}\nOpen {} in a browser.\n",
        scenes.len(),
        arguments.out.display(),
        index.display(),
    ))
}

fn made(entry: &Entry) -> Result<Scene, Failure> {
    entry.scene().map_err(|reason| Failure::Scene {
        scene: entry.name,
        reason,
    })
}

fn described<'a>(scene: &'a Scene, directory: &Path) -> MadeScene<'a> {
    let name = scene.name();
    MadeScene {
        name,
        title: scene.title(),
        caption: scene.caption(),
        glb: directory.join(format!("{name}.glb")),
        png: directory.join(format!("{name}.png")),
        svg: scene
            .attachments()
            .iter()
            .map(|drawing| directory.join(drawing_path(scene, drawing)))
            .collect(),
    }
}
