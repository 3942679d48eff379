//! Decides how the symbols of plane groups are written: strokes of round rods, lying in the plane.

use super::super::GalleryError;
use super::super::motif::ball;
use crate::mesh::{self, Ends, Mesh};

/// The thickness of a rod and the gap after a letter, over the height of a figure.
const RADIUS: f64 = 0.075;
const GAP: f64 = 0.26;

/// The letters and figures of a word one unit high, its foot at the origin; and how long it is. Others
/// than those of plane groups are left out.
pub(super) fn strokes(word: &str) -> (Vec<Vec<[f64; 2]>>, f64) {
    let mut along = 0.0;
    let mut all = Vec::new();
    for (glyph, width) in word.chars().filter_map(glyph) {
        all.extend(glyph.into_iter().map(|stroke| {
            let points = stroke.into_iter();
            points.map(|[x, y]| [x + along, y]).collect::<Vec<_>>()
        }));
        along += width + GAP;
    }
    (all, (along - GAP).max(0.0))
}

/// The word as rods of this height, centred at a place.
pub(super) fn written(word: &str, [x, y]: [f64; 2], height: f64) -> Result<Mesh, GalleryError> {
    let (strokes, length) = strokes(word);
    let radius = RADIUS * height;
    let mut parts = Vec::new();
    for stroke in strokes {
        let line: Vec<[f64; 3]> = stroke
            .iter()
            .map(|[u, v]| [x + (u - length / 2.0) * height, y + v * height, radius])
            .collect();
        parts.push(mesh::tube(&line, Ends::Capped, radius, 10)?);
        for end in line.first().into_iter().chain(line.last()) {
            parts.push(ball(*end, radius)?);
        }
    }
    Ok(Mesh::joined(&parts)?)
}

/// The strokes of a letter or figure, and its width.
fn glyph(letter: char) -> Option<(Vec<Vec<[f64; 2]>>, f64)> {
    let bowl = || arc([0.27, 0.31], [0.27, 0.31], 0.0, 360.0);
    Some(match letter {
        'p' => (vec![vec![[0.0, 0.62], [0.0, -0.36]], bowl()], 0.54),
        'c' => (vec![arc([0.27, 0.31], [0.27, 0.31], 45.0, 315.0)], 0.48),
        'g' => {
            let mut hook = vec![[0.54, 0.62]];
            hook.extend(arc([0.27, -0.12], [0.27, 0.24], 0.0, -150.0));
            (vec![bowl(), hook], 0.54)
        }
        'm' => {
            let arch = |left: f64| {
                let mut arch = arc([left + 0.21, 0.41], [0.21, 0.21], 180.0, 0.0);
                arch.push([left + 0.42, 0.0]);
                arch
            };
            (
                vec![vec![[0.0, 0.62], [0.0, 0.0]], arch(0.0), arch(0.42)],
                0.84,
            )
        }
        '1' => (vec![vec![[0.0, 0.78], [0.22, 1.0], [0.22, 0.0]]], 0.24),
        '2' => {
            let mut stroke = arc([0.27, 0.72], [0.27, 0.28], 160.0, -35.0);
            stroke.extend([[0.0, 0.0], [0.56, 0.0]]);
            (vec![stroke], 0.56)
        }
        '3' => {
            let mut stroke = arc([0.25, 0.76], [0.24, 0.24], 150.0, -90.0);
            stroke.extend(arc([0.25, 0.26], [0.28, 0.26], 90.0, -150.0));
            (vec![stroke], 0.54)
        }
        '4' => (
            vec![
                vec![[0.44, 0.0], [0.44, 1.0]],
                vec![[0.44, 1.0], [0.0, 0.32]],
                vec![[0.0, 0.32], [0.6, 0.32]],
            ],
            0.6,
        ),
        '6' => (
            vec![
                arc([0.28, 0.31], [0.28, 0.31], 0.0, 360.0),
                arc([0.5, 0.31], [0.5, 0.69], 180.0, 95.0),
            ],
            0.56,
        ),
        _ => return None,
    })
}

/// Points of an arc of an ellipse, from one angle in degrees to another.
fn arc([x, y]: [f64; 2], [across, up]: [f64; 2], from: f64, to: f64) -> Vec<[f64; 2]> {
    const STEPS: u32 = 24;
    let part = |step| f64::from(step) / f64::from(STEPS);
    (0..=STEPS)
        .map(|step| {
            let (sine, cosine) = (from + (to - from) * part(step)).to_radians().sin_cos();
            [x + across * cosine, y + up * sine]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crystallography::{SubperiodicGroup, SubperiodicKind};

    #[test]
    fn every_character_of_a_plane_group_can_be_written() {
        for group in SubperiodicGroup::table() {
            if group.kind == SubperiodicKind::Plane {
                for letter in group.symbol.chars().filter(|letter| *letter != ' ') {
                    let (strokes, width) = glyph(letter).expect("a letter of a plane group");
                    for [x, y] in strokes.into_iter().flatten() {
                        assert!((-0.05..=width + 0.1).contains(&x), "{letter}: {x}");
                        assert!((-0.37..=1.01).contains(&y), "{letter}: {y}");
                    }
                }
            }
        }
        assert_eq!(strokes("").1, 0.0);
        assert!(written("?", [0.0; 2], 1.0).is_err());
    }
}
