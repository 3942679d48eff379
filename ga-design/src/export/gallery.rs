//! Decides what a gallery is: a page that works alone and offline, a GLB and a PNG per scene, and the
//! drawings that go with it.
//!
//! The page holds every model and thumbnail inside itself, so that it opens from a folder, a stick
//! or a mail without a server; the files beside it are for downloading. Its address with `#name`
//! opens the scene of that name.

use super::picture::{self, Settings};
use super::svg::escape;
use super::{Attachment, ExportError, Scene, glb, write};
use base64::{Engine, engine::general_purpose::STANDARD};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

const PAGE: &str = include_str!("../../assets/gallery.html");
const STYLE: &str = include_str!("../../assets/gallery.css");
const SCRIPT: &str = include_str!("../../assets/gallery.js");

/// Writes `index.html` and, for each scene, `NAME.glb`, `NAME.png` and a file `NAME/DRAWING.svg` for
/// each drawing that is attached to it into a directory, which is made if it is not there; gives the
/// path of the page. `drawn` is called with each scene when it has been
/// drawn, to show progress. The settings are those of the pictures; thumbnails are half as large.
///
/// Scenes are drawn side by side on all processors.
///
/// All files are made before the first is put in its place.
///
/// # Errors
/// [`ExportError`] if there is no scene, a name is not made of lower-case letters, digits and hyphens
/// or is used twice, a scene is empty, or a file cannot be written.
pub fn write_gallery(
    scenes: &[Scene],
    directory: &Path,
    settings: &Settings,
    drawn: impl FnMut(&Scene),
) -> Result<PathBuf, ExportError> {
    let mut files = encode(scenes, settings, drawn)?;
    for (path, _) in &mut files {
        *path = directory.join(&*path);
    }
    let mut made = HashSet::new();
    for parent in files.iter().filter_map(|(path, _)| path.parent()) {
        if made.insert(parent) {
            write::create_directory(parent)?;
        }
    }
    write::write_files(&files)?;
    Ok(directory.join("index.html"))
}

/// The files of a gallery, with paths relative to its directory; the page comes last.
///
/// # Errors
/// [`ExportError`] as for [`write_gallery`].
pub fn encode(
    scenes: &[Scene],
    settings: &Settings,
    drawn: impl FnMut(&Scene),
) -> Result<Vec<(PathBuf, Vec<u8>)>, ExportError> {
    if scenes.is_empty() {
        return Err(ExportError::EmptyScene {
            scene: "gallery".to_owned(),
        });
    }
    check_names(scenes)?;
    let mut files = Vec::with_capacity(2 * scenes.len() + 1);
    let mut cards = String::new();
    let mut models = String::new();
    for (scene, made) in scenes.iter().zip(make_all(scenes, settings, drawn)) {
        let Made {
            model,
            image,
            thumbnail,
        } = made?;
        cards += &card(scene, &STANDARD.encode(&thumbnail));
        models += &embedded(scene, &STANDARD.encode(&model));
        files.push((PathBuf::from(format!("{}.glb", scene.name())), model));
        files.push((PathBuf::from(format!("{}.png", scene.name())), image));
        for drawing in scene.attachments() {
            files.push((
                drawing_path(scene, drawing),
                drawing.svg.clone().into_bytes(),
            ));
        }
    }
    let parts = [
        ("{{style}}", STYLE),
        ("{{cards}}", &cards),
        ("{{models}}", &models),
        ("{{script}}", SCRIPT),
    ];
    let page = filled(PAGE, &parts);
    files.push((PathBuf::from("index.html"), page.into_bytes()));
    Ok(files)
}

/// Where a drawing of a scene is, from the directory of the gallery.
#[must_use]
pub fn drawing_path(scene: &Scene, drawing: &Attachment) -> PathBuf {
    PathBuf::from(format!("{}/{}.svg", scene.name(), drawing.name))
}

/// The files of one scene.
struct Made {
    model: Vec<u8>,
    image: Vec<u8>,
    thumbnail: Vec<u8>,
}

fn make(scene: &Scene, settings: &Settings) -> Result<Made, ExportError> {
    let model = glb::encode(scene)?;
    let image = picture::render(scene, settings)?;
    Ok(Made {
        model,
        thumbnail: image.halved().to_png()?,
        image: image.to_png()?,
    })
}

/// The files of all scenes, in order. Each processor takes the next scene that nobody has begun.
fn make_all(
    scenes: &[Scene],
    settings: &Settings,
    mut drawn: impl FnMut(&Scene),
) -> Vec<Result<Made, ExportError>> {
    let next = AtomicUsize::new(0);
    let workers = thread::available_parallelism().map_or(1, usize::from);
    let (sender, receiver) = mpsc::channel();
    let mut all: Vec<_> = thread::scope(|scope| {
        for _ in 0..workers.min(scenes.len()) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                while let Some((index, scene)) = take(scenes, next) {
                    // Nobody receives any more only if the whole call has been given up.
                    if sender.send((index, scene, make(scene, settings))).is_err() {
                        break;
                    }
                }
            });
        }
        // Receiving ends when the last worker is done with its sender.
        drop(sender);
        let report = |(index, scene, made)| {
            drawn(scene);
            (index, made)
        };
        receiver.into_iter().map(report).collect()
    });
    all.sort_by_key(|&(index, _)| index);
    all.into_iter().map(|(_, made)| made).collect()
}

fn take<'a>(scenes: &'a [Scene], next: &AtomicUsize) -> Option<(usize, &'a Scene)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    Some((index, scenes.get(index)?))
}

/// Names become file names and fragments of addresses, so only characters that are plain in both.
fn check_names(scenes: &[Scene]) -> Result<(), ExportError> {
    check_all(scenes.iter().map(Scene::name))?;
    for scene in scenes {
        check_all(scene.attachments().iter().map(|one| one.name.as_str()))?;
    }
    Ok(())
}

fn check_all<'a>(names: impl Iterator<Item = &'a str>) -> Result<(), ExportError> {
    let mut seen = HashSet::new();
    for name in names {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if name.is_empty() || name.len() > 100 || name == "index" || !name.chars().all(plain) {
            return Err(ExportError::SceneName {
                name: name.to_owned(),
            });
        }
        if !seen.insert(name) {
            return Err(ExportError::RepeatedName {
                name: name.to_owned(),
            });
        }
    }
    Ok(())
}

fn card(scene: &Scene, thumbnail: &str) -> String {
    let [name, title, caption] = [scene.name(), scene.title(), scene.caption()].map(escape);
    let drawings: String = scene
        .attachments()
        .iter()
        .map(|drawing| {
            let path = drawing_path(scene, drawing);
            let [path, label] = [&*path.to_string_lossy(), &drawing.name].map(escape);
            format!(" <a href=\"{path}\" aria-label=\"{label} as SVG\">{label}</a>")
        })
        .collect();
    format!(
        "<li class=\"card\" id=\"card-{name}\">\n\
         <a class=\"open\" href=\"#{name}\">\
         <img src=\"data:image/png;base64,{thumbnail}\" alt=\"\" loading=\"lazy\">\
         <h2>{title}</h2></a>\n\
         <p class=\"caption\">{caption}</p>\n\
         <p class=\"files\">\
         <a href=\"{name}.glb\" download aria-label=\"{title} as GLB\">GLB</a> \
         <a href=\"{name}.png\" download aria-label=\"{title} as PNG\">PNG</a>{drawings}</p>\n\
         </li>\n"
    )
}

/// The model as text inside the page; Base64 has no character that could end the element.
fn embedded(scene: &Scene, model: &str) -> String {
    let view = scene.view();
    format!(
        "<script type=\"application/octet-stream\" id=\"model-{}\" \
         data-azimuth=\"{}\" data-elevation=\"{}\">{model}</script>\n",
        escape(scene.name()),
        view.azimuth,
        view.elevation,
    )
}

/// The template with its marks replaced; what is put in is not searched for marks again.
fn filled(template: &str, parts: &[(&str, &str)]) -> String {
    let mut page = String::new();
    let mut rest = template;
    while let Some((start, mark, text)) = parts
        .iter()
        .filter_map(|&(mark, text)| Some((rest.find(mark)?, mark, text)))
        .min_by_key(|&(start, ..)| start)
    {
        let (before, after) = rest.split_at(start);
        page.push_str(before);
        page.push_str(text);
        rest = after.strip_prefix(mark).unwrap_or_default();
    }
    page.push_str(rest);
    page
}
