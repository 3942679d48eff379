//! Rotation, translation and screw: what a rotor, a translator and a motor make of one letter
//! (figure 2.14 a, b, e).

use super::GalleryError;
use super::motif::{Letter, path};
use super::palette::{SLATE, course, solid};
use crate::export::{Scene, View};
use crate::mesh;
use ga_cga::{Motor, Point, Rotor, Translator, Vector3};
use std::f64::consts::TAU;

/// One of the three motions: where its axis stands, and how far it turns and climbs.
struct Motion {
    name: &'static str,
    axis: f64,
    angle: f64,
    rise: f64,
    letters: u32,
}

const MOTIONS: [Motion; 3] = [
    Motion {
        name: "rotation",
        axis: -2.6,
        angle: 11.0 / 12.0 * TAU,
        rise: 0.0,
        letters: 12,
    },
    Motion {
        name: "translation",
        axis: 0.0,
        angle: 0.0,
        rise: 2.8,
        letters: 5,
    },
    Motion {
        name: "screw",
        axis: 2.6,
        angle: 1.5 * TAU,
        rise: 2.8,
        letters: 19,
    },
];

/// The height of the letters.
const SIZE: f64 = 0.5;

impl Motion {
    /// The motor that has gone this part of the way: a turn about the upright axis and a climb along it.
    fn motor(&self, part: f64) -> Result<Motor, GalleryError> {
        let up = Vector3::new(0.0, 0.0, 1.0);
        let to_axis = Translator::by(Vector3::new(self.axis, 0.0, 0.0));
        let from_axis = Translator::by(Vector3::new(-self.axis, 0.0, 0.0));
        let rotor = Rotor::about_axis(up, part * self.angle);
        let rotor = rotor.ok_or(GalleryError::Degenerate {
            what: "the axis of a motion",
        })?;
        let climb = Translator::by(up * (part * self.rise));
        Ok(to_axis * climb * rotor * from_axis)
    }

    /// The letter that it moves, in front of the axis.
    fn letter(&self) -> Letter {
        let distance = if self.angle == 0.0 { 0.0 } else { 1.05 };
        Letter::standing(
            [self.axis, -distance, 0.0],
            [SIZE, 0.0, 0.0],
            [0.0, 0.0, SIZE],
        )
    }

    /// The way of a point.
    fn way(&self, start: Point) -> Result<Vec<Point>, GalleryError> {
        (0..=160)
            .map(|i| Ok(self.motor(f64::from(i) / 160.0)?.apply(start)))
            .collect()
    }
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "motions",
        "Rotation, translation, screw",
        "What a rotor, a translator and the motor that is their product make of the letter F, from blue \
         to orange. Lines show the way of its foot: a circle, a straight line, a helix.",
    );
    let slate = scene.add_material(solid("ways", SLATE)?);
    let pale = scene.add_material(solid("axes", [168, 176, 188])?);
    for motion in &MOTIONS {
        let letter = motion.letter();
        for number in 0..motion.letters {
            let part = f64::from(number) / f64::from(motion.letters - 1);
            let motor = motion.motor(part)?;
            let name = format!("{} {number}", motion.name);
            let material = scene.add_material(solid(&name, course(part))?);
            letter
                .moved(|point| motor.apply(point))
                .draw(&mut scene, &name, material, 0.045)?;
        }
        scene.add(
            motion.name,
            path(&motion.way(letter.foot())?, 0.016)?,
            slate,
        )?;
        if motion.angle != 0.0 {
            let [low, high] = [-0.3, motion.rise + 0.9].map(|z| [motion.axis, 0.0, z]);
            scene.add("axis", mesh::cylinder(low, high, 0.02, 16)?, pale)?;
        }
    }
    scene.set_view(View {
        azimuth: -1.57,
        elevation: 0.34,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_letter_keeps_its_shape() -> Result<(), GalleryError> {
        for motion in &MOTIONS {
            let given: Vec<Point> = motion.letter().points().collect();
            for step in 0..=10 {
                let motor = motion.motor(f64::from(step) / 10.0)?;
                let moved: Vec<Point> = given.iter().map(|&p| motor.apply(p)).collect();
                for (i, j) in (0..given.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
                    let change = moved[i].distance(moved[j]) - given[i].distance(given[j]);
                    assert!(change.abs() < 1e-13);
                }
            }
        }
        Ok(())
    }

    #[test]
    fn the_ways_keep_their_distance_from_the_axis_and_climb_evenly() -> Result<(), GalleryError> {
        for motion in &MOTIONS {
            let foot = motion.letter().foot();
            let [x, y, z] = foot.position().to_array();
            let distance = (x - motion.axis).hypot(y);
            for (i, point) in motion.way(foot)?.into_iter().enumerate() {
                let [x, y, height] = point.position().to_array();
                assert!(((x - motion.axis).hypot(y) - distance).abs() < 1e-13);
                assert!((height - z - motion.rise * i as f64 / 160.0).abs() < 1e-13);
            }
        }
        Ok(())
    }
}
