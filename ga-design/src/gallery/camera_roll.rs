//! Cameras that look at one target: turned the shortest way they roll, by algorithm 2.1 they stay
//! upright (figure 2.7).

use super::GalleryError;
use super::motif::ball;
use super::palette::{BLUE, ORANGE, SLATE, TEAL, YELLOW, solid};
use crate::camera::{directly, without_roll};
use crate::export::{Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::{Point, Rotor, Vector3};
use std::f64::consts::{PI, TAU};

/// The number of cameras in a row.
const CAMERAS: u32 = 5;

/// The target, and the two rows about it: height, radius.
const ROWS: [(f64, f64); 2] = [(2.3, 3.6), (-1.0, 3.6)];

fn target() -> Point {
    Point::at(0.0, 0.6, 0.0)
}

/// Where the cameras of a row stand, in a frame whose y axis is upright as the algorithm has it.
fn places((height, radius): (f64, f64)) -> Vec<Point> {
    (0..CAMERAS)
        .map(|i| {
            let angle = PI * (0.12 + 0.76 * f64::from(i) / f64::from(CAMERAS - 1)) - 0.5 * PI;
            Point::at(radius * angle.sin(), height, -radius * angle.cos())
        })
        .collect()
}

/// The turn that stands the y axis up along the z axis of the scene.
fn upright() -> Rotor {
    let axis = Vector3::new(1.0, 0.0, 0.0);
    Rotor::about_axis(axis, TAU / 4.0).unwrap_or(Rotor::identity())
}

/// A camera as a frame of arrows and a pyramid that opens along its line of sight.
fn draw(
    scene: &mut Scene,
    name: &str,
    place: Point,
    turn: Rotor,
    color: [u8; 3],
) -> Result<(), GalleryError> {
    let stand = upright();
    let at = |x: f64, y: f64, z: f64| {
        let point = place.position() + turn.apply(Vector3::new(x, y, z));
        stand.apply(point).to_array()
    };
    let origin = at(0.0, 0.0, 0.0);
    for (axis, color, tip) in [
        ("x", ORANGE, at(0.55, 0.0, 0.0)),
        ("y", TEAL, at(0.0, 0.75, 0.0)),
        ("z", BLUE, at(0.0, 0.0, 0.95)),
    ] {
        let name = format!("{name} {axis}");
        let material = scene.add_material(solid(&name, color)?);
        scene.add(&name, mesh::arrow(origin, tip, 0.028, 20)?, material)?;
    }
    let (width, height, depth) = (0.36, 0.24, 0.6);
    let corners = [
        at(width, height, depth),
        at(-width, height, depth),
        at(-width, -height, depth),
        at(width, -height, depth),
    ];
    let mut rods = vec![mesh::tube(&corners, Ends::Closed, 0.014, 10)?];
    for corner in corners {
        rods.push(mesh::tube(&[origin, corner], Ends::Capped, 0.014, 10)?);
    }
    let material = scene.add_material(solid(name, color)?);
    scene.add(name, Mesh::joined(&rods)?, material)?;
    Ok(())
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "camera-roll",
        "Cameras with and without roll",
        "All cameras look at the yellow target. Those of the lower row have been turned there by the \
         shortest way, and roll: their green y axes lean. Those of the upper row are turned once more, so \
         that y lies on the projection of the upright onto their picture plane.",
    );
    let missing = GalleryError::Degenerate {
        what: "the direction of a camera",
    };
    let [upper, lower] = ROWS;
    for (number, place) in places(upper).into_iter().enumerate() {
        let Some(turn) = without_roll(place, target()) else {
            return Err(missing);
        };
        draw(&mut scene, &format!("upright {number}"), place, turn, SLATE)?;
    }
    for (number, place) in places(lower).into_iter().enumerate() {
        let Some(turn) = directly(target().position() - place.position()) else {
            return Err(missing);
        };
        draw(
            &mut scene,
            &format!("rolled {number}"),
            place,
            turn,
            [150, 158, 170],
        )?;
    }
    let yellow = scene.add_material(solid("target", YELLOW)?);
    let center = upright().apply(target().position());
    scene.add("target", ball(center.to_array(), 0.28)?, yellow)?;
    scene.set_view(View {
        azimuth: 1.2,
        elevation: 0.3,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_row_stands_upright_and_the_lower_leans() {
        let x = Vector3::new(1.0, 0.0, 0.0);
        let lean = |turn: Option<Rotor>| turn.map(|turn| turn.apply(x).e2.abs());
        for place in places(ROWS[0]) {
            assert!(lean(without_roll(place, target())).is_some_and(|lean| lean < 1e-14));
        }
        let worst = places(ROWS[1]).into_iter().map(|place| {
            let turn = directly(target().position() - place.position());
            lean(turn).unwrap_or_default()
        });
        assert!(worst.fold(0.0, f64::max) > 0.15);
    }
}
