//! Scaling, and the two flows of a point pair and a circle: what dilators and general conformal versors
//! make of circles (figure 2.14 c, d).

use super::GalleryError;
use super::motif::{ball, ring};
use super::palette::{SLATE, course, solid};
use crate::export::{Scene, View};
use ga_cga::interpolate::Continuous;
use ga_cga::{Circle, Even, Point, PointPair};
use std::f64::consts::PI;

/// One of the three motions: where it stands, its generator, how far it goes either way, and the circle
/// it moves.
struct Motion {
    name: &'static str,
    generator: PointPair,
    range: [f64; 2],
    circles: u32,
    start: Circle,
}

fn at(x: f64, y: f64, z: f64) -> Point {
    Point::at(x, y, z)
}

/// The level circle about a place.
fn level([x, y, z]: [f64; 3], radius: f64) -> Circle {
    at(x + radius, y, z) ^ at(x, y + radius, z) ^ at(x - radius, y, z)
}

/// The generator of a real pair or circle, of size one.
fn unit(generator: PointPair) -> Result<PointPair, GalleryError> {
    generator.normalized().ok_or(GalleryError::Degenerate {
        what: "the generator of a motion",
    })
}

fn motions() -> Result<[Motion; 3], GalleryError> {
    let center = at(-3.6, 0.0, -0.9);
    let scaling: PointPair = center ^ ga_cga::DualSphere::infinity();
    let [source, sink] = [at(0.0, 0.0, -0.9), at(0.0, 0.0, 1.9)];
    let axis = level([4.1, 0.0, 0.5], 1.0);
    Ok([
        Motion {
            name: "dilation",
            generator: unit(scaling)?,
            range: [-0.6, 0.42],
            circles: 11,
            start: level([-3.6, 0.0, 0.4], 0.75),
        },
        Motion {
            name: "flow of a point pair",
            generator: unit(source ^ sink)?,
            range: [-1.25, 1.25],
            circles: 23,
            start: level([0.0, 0.0, 0.5], 1.4),
        },
        Motion {
            name: "flow about a circle",
            generator: unit(axis.dual())?,
            range: [0.0, PI * 23.0 / 24.0],
            circles: 24,
            start: level([4.1, 0.0, 0.5], 1.75),
        },
    ])
}

impl Motion {
    /// The versor that has gone this part of the way.
    fn versor(&self, part: f64) -> Even {
        let [from, to] = self.range;
        Even::power(self.generator, from + (to - from) * part)
    }

    /// The circles on the way.
    fn circles(&self) -> Vec<(f64, Circle)> {
        (0..self.circles)
            .map(|i| {
                let part = f64::from(i) / f64::from(self.circles - 1);
                (part, self.versor(part).apply(self.start))
            })
            .collect()
    }
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "conformal-motions",
        "Dilation and conformal flows",
        "One circle and its images, from blue to orange, under exponentials of three point pairs. If one \
         of the two points is at infinity they scale. A real pair makes them flow from the one point to \
         the other. An imaginary pair, the dual of the dark circle, makes them turn about that circle.",
    );
    let slate = scene.add_material(solid("generators", SLATE)?);
    for motion in motions()? {
        for (part, circle) in motion.circles() {
            let name = format!("{} {part:.2}", motion.name);
            let material = scene.add_material(solid(&name, course(part))?);
            scene.add(&name, ring(circle, 0.024)?, material)?;
        }
    }
    for place in [[-3.6, 0.0, -0.9], [0.0, 0.0, -0.9], [0.0, 0.0, 1.9]] {
        scene.add("point", ball(place, 0.09)?, slate)?;
    }
    scene.add("circle", ring(level([4.1, 0.0, 0.5], 1.0), 0.045)?, slate)?;
    scene.set_view(View {
        azimuth: -1.57,
        elevation: 0.38,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn the_generators_stay_where_they_are() -> Result<(), GalleryError> {
        for motion in motions()? {
            let moved = motion.versor(0.3).apply(motion.generator);
            assert!((moved - motion.generator).norm() < 1e-12);
        }
        Ok(())
    }

    /// The flow of a pair scales the ratio of the distances to its points; the flow about a circle comes
    /// back after a whole turn, which the versor calls half of 2π.
    #[test]
    fn the_flows_do_what_they_are_named_for() -> Result<(), GalleryError> {
        let [_, pair, circle] = motions()?;
        let [source, sink] = [at(0.0, 0.0, -0.9), at(0.0, 0.0, 1.9)];
        let ratio = |point: Point| point.distance(source) / point.distance(sink);
        let start = at(1.3, 0.4, 0.2);
        let images = [0.2, 0.4, 0.6].map(|t| {
            let image = start.image_under(Even::power(pair.generator, t));
            ratio(image.unwrap_or_default())
        });
        assert!((images[1] * images[1] - images[0] * images[2]).abs() < 1e-12);
        let whole = start.image_under(Even::power(circle.generator, TAU / 2.0));
        assert!(whole.unwrap_or_default().distance(start) < 1e-12);
        Ok(())
    }
}
