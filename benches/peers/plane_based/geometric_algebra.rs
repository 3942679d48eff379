//! The contestants of the crate `geometric_algebra`: the same algebra and the same signs, in f32.

use ga_benches::data::{Data, Motion};
use ga_benches::race::Contestant;
use geometric_algebra::ppga3d::{Line, Motor, Plane, Point};
use geometric_algebra::{
    Exp, GeometricProduct, Ln, OuterProduct, RegressiveProduct, Transformation,
};

use super::corners;
use crate::others::single::number;

const NAME: &str = "geometric_algebra";

/// A point of weight 1.
fn point(x: &[f64; 3]) -> Point {
    let [x, y, z] = x.map(number);
    Point::new(1.0, x, y, z)
}

fn plane(plane: &[f64; 4]) -> Plane {
    let [a, b, c, d] = plane.map(number);
    Plane::new(d, a, b, c)
}

/// The product of a translator and a rotor.
fn motor(motion: &Motion) -> Motor {
    let [w, x, y, z] = motion.rotation.map(number);
    let [tx, ty, tz] = motion.translation.map(|t| number(-0.5 * t));
    let translator = Motor::new(1.0, 0.0, 0.0, 0.0, 0.0, tx, ty, tz);
    translator.geometric_product(Motor::new(w, -x, -y, -z, 0.0, 0.0, 0.0, 0.0))
}

fn motors(data: &Data) -> Vec<Motor> {
    data.motions[0].iter().map(motor).collect()
}

fn points(data: &Data) -> Vec<Point> {
    data.vectors[0].iter().map(point).collect()
}

fn lines(data: &Data) -> Vec<Line> {
    let ends = data.vectors[0].iter().zip(&data.vectors[1]);
    ends.map(|(x, y)| point(x).regressive_product(point(y)))
        .collect()
}

fn coordinates(p: &Point) -> Vec<f64> {
    (1..4).map(|i| f64::from(p[i] / p[0])).collect()
}

/// In our order: the direction first.
fn line_coordinates(l: &Line) -> Vec<f64> {
    [3, 4, 5, 0, 1, 2].map(|i| f64::from(l[i])).to_vec()
}

pub fn motor_times_motor(data: &Data) -> Contestant {
    Contestant::binary(
        NAME,
        motors(data),
        data.motions[1].iter().map(motor).collect(),
        |a, b| a.geometric_product(b),
        |m| corners(|x| coordinates(&m.transformation(point(x)))),
    )
}

pub fn motor_on_point(data: &Data) -> Contestant {
    Contestant::binary(
        NAME,
        motors(data),
        points(data),
        |m, p| m.transformation(p),
        coordinates,
    )
}

pub fn motor_on_line(data: &Data) -> Contestant {
    Contestant::binary(
        NAME,
        motors(data),
        lines(data),
        |m, l| m.transformation(l),
        line_coordinates,
    )
}

pub fn motor_on_plane(data: &Data) -> Contestant {
    let planes = data.planes[0].iter().map(plane).collect();
    Contestant::binary(
        NAME,
        motors(data),
        planes,
        |m, p| m.transformation(p),
        |p| [1, 2, 3, 0].map(|i| f64::from(p[i])).to_vec(),
    )
}

pub fn join_of_points(data: &Data) -> Contestant {
    let others = data.vectors[1].iter().map(point).collect();
    Contestant::binary(
        NAME,
        points(data),
        others,
        |p, q| p.regressive_product(q),
        line_coordinates,
    )
}

pub fn meet_of_planes(data: &Data) -> Contestant {
    Contestant::ternary(
        NAME,
        data.planes
            .each_ref()
            .map(|planes| planes.iter().map(plane).collect()),
        |a, b, c| a.outer_product(b).outer_product(c),
        |p: &Point| (0..4).map(|i| f64::from(p[i])).collect(),
    )
}

pub fn exponential(data: &Data) -> Contestant {
    Contestant::unary(NAME, lines(data), Line::exp, |m| {
        [0, 1, 2, 3, 5, 6, 7, 4].map(|i| f64::from(m[i])).to_vec()
    })
}

pub fn logarithm(data: &Data) -> Contestant {
    Contestant::unary(NAME, motors(data), Motor::ln, line_coordinates)
}
