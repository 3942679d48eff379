//! What the functions are called on.

use ga_benches::data::Data;
use ga_benches::ours::conformal as cga;
use ga_benches::ours::conformal::{Circle, DualPlane, DualSphere, Even, Multivector};
use ga_benches::ours::euclidean::{Rotor, Vector, rotor, vector};
use ga_benches::ours::plane_based as pga;
use ga_benches::ours::plane_based::{Line, Motor, Plane, Point};
use ga_core::{Real, Unit};

/// Lists of elements over one type of numbers.
pub struct Operands<T> {
    pub rotors: Vec<Unit<Rotor<T>>>,
    pub vectors: Vec<Vector<T>>,
    pub motors: Vec<Unit<Motor<T>>>,
    pub points: [Vec<Point<T>>; 2],
    pub lines: Vec<Line<T>>,
    pub planes: Vec<Plane<T>>,
    pub plane_pairs: Vec<(Plane<T>, Plane<T>)>,
    pub conformal_motors: Vec<Unit<cga::Motor<T>>>,
    pub conformal_points: [Vec<cga::Point<T>>; 4],
    pub conformal_lines: Vec<cga::Line<T>>,
    pub conformal_planes: Vec<DualPlane<T>>,
    pub point_pairs: [Vec<(cga::Point<T>, cga::Point<T>)>; 2],
    pub circles: Vec<Circle<T>>,
    pub spheres: Vec<DualSphere<T>>,
    pub versors: Vec<Unit<Even<T>>>,
    pub dense: Vec<Multivector<T>>,
}

impl<T: Real> Operands<T> {
    /// So many of each.
    pub fn new(elements: usize) -> Self {
        let data = Data::new(elements);
        let [x, y, z, _] = &data.vectors;
        let planes = data
            .planes
            .each_ref()
            .map(|list| list.iter().map(pga::plane).collect());
        let [planes, second, third]: [Vec<Plane<T>>; 3] = planes;
        let points = data.vectors.each_ref();
        let points = points.map(|list| list.iter().map(cga::point).collect::<Vec<_>>());
        let pairs = |a: usize, b: usize| {
            points[a]
                .iter()
                .copied()
                .zip(points[b].iter().copied())
                .collect()
        };
        let circles = x.iter().zip(y).zip(z);
        let versors: Vec<Unit<Even<T>>> = data.motions[0].iter().zip(x).map(cga::versor).collect();
        Operands {
            rotors: data.rotations[0].iter().map(rotor).collect(),
            vectors: x.iter().map(vector).collect(),
            motors: data.motions[0].iter().map(pga::motor).collect(),
            points: [x, y].map(|list| list.iter().map(pga::point).collect()),
            lines: x.iter().zip(y).map(pga::line).collect(),
            planes,
            plane_pairs: second.into_iter().zip(third).collect(),
            conformal_motors: data.motions[0].iter().map(cga::motor).collect(),
            conformal_lines: x.iter().zip(y).map(cga::line).collect(),
            conformal_planes: data.planes[0].iter().map(cga::plane).collect(),
            point_pairs: [pairs(1, 2), pairs(0, 3)],
            conformal_points: points,
            circles: circles.map(|((x, y), z)| cga::circle([x, y, z])).collect(),
            spheres: x.iter().zip(y).map(cga::sphere).collect(),
            dense: versors.iter().zip(y).map(cga::dense).collect(),
            versors,
        }
    }
}
