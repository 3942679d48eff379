//! R4,1 in the null basis, in multiples of what a rigid motion of a point costs by nalgebra.

use ga_benches::race::Contestant;

use crate::data::{Motion, Source};
use crate::others;
use crate::ours::conformal::{
    DualPlane, DualSphere, Motor, Multivector, Point, Rotor, Translator, Transversor, Versor,
};
use crate::ours::unit;
use crate::table::{Contest, Goal, Table};

/// The contests over one type of numbers.
macro_rules! contests {
    ($float:ident $module:ident) => {
        fn $module(table: &mut Table) {
            use others::$module::*;

            let scalar = stringify!($float);
            let mut source = Source::new(3);
            let (a, b) = (source.motions(), source.motions());
            let corners: [_; 4] = std::array::from_fn(|_| source.vectors());

            let at = |x: &[f64; 3]| {
                let [x, y, z] = *x;
                let square = 0.5 * (x * x + y * y + z * z);
                Point::new(number(x), number(y), number(z), number(square))
            };
            let motor = |motion: &Motion| -> Motor<$float> {
                let [w, x, y, z] = motion.rotation.map(number);
                let [tx, ty, tz] = motion.translation.map(|t| number(-0.5 * t));
                unit(Translator::new(tx, ty, tz) * Rotor::new(w, -z, y, -x))
            };
            let versor = |(motion, x): (&Motion, &[f64; 3])| -> Versor<$float> {
                let [x, y, z] = x.map(number);
                unit((motor(motion) * Transversor::new(x, y, z)).into())
            };
            let motors: Vec<_> = a.iter().map(motor).collect();
            let versors: Vec<_> = a.iter().zip(&corners[0]).map(versor).collect();
            let points = corners
                .each_ref()
                .map(|x| x.iter().map(at).collect::<Vec<_>>());
            let circles = points[1].iter().zip(&points[2]).zip(&points[3]);
            let circles: Vec<_> = circles.map(|((p, q), r)| *p ^ *q ^ *r).collect();
            let lines: Vec<_> = points[1]
                .iter()
                .zip(&points[2])
                .map(|(p, q)| {
                    let infinity = DualPlane::new(0.0, 0.0, 0.0, 1.0);
                    *p ^ *q ^ infinity
                })
                .collect();

            let mut add = |operation, goal, contestants| {
                let yardstick = Contestant::binary(
                    "nalgebra-isometry-on-point",
                    a.iter().map(isometry).collect(),
                    corners[0].iter().map(point).collect(),
                    |m, p| m * p,
                    |p| view((*p).into()),
                );
                table.add(Contest {
                    operation,
                    scalar,
                    homogeneous: true,
                    goal,
                    yardstick: Some(yardstick),
                    contestants,
                });
            };
            add(
                "conformal-motor-on-point",
                Goal::OfIsometry(2.1),
                vec![
                    Contestant::binary(
                        "ours",
                        motors.clone(),
                        points[0].clone(),
                        |m, p| m.apply(p),
                        |p| view([p.e1, p.e2, p.e3]),
                    ),
                    Contestant::binary(
                        "nalgebra",
                        a.iter().map(isometry).collect(),
                        corners[0].iter().map(point).collect(),
                        |m, p| m * p,
                        |p| view((*p).into()),
                    ),
                ],
            );
            add(
                "conformal-motor-on-line",
                Goal::Shown,
                vec![Contestant::binary(
                    "ours",
                    motors.clone(),
                    lines,
                    |m, l| m.apply(l),
                    |l| view(l.to_array()),
                )],
            );
            add(
                "conformal-motor-on-circle",
                Goal::OfIsometry(4.6),
                vec![Contestant::binary(
                    "ours",
                    motors.clone(),
                    circles,
                    |m, c| m.apply(c),
                    |c| view(c.to_array()),
                )],
            );
            let [p, q, r, s] = points.clone();
            add(
                "p∧q∧r",
                Goal::OfIsometry(2.9),
                vec![Contestant::ternary(
                    "ours",
                    [p, q, r],
                    |p, q, r| p ^ q ^ r,
                    |c| view(c.to_array()),
                )],
            );
            let [p, q, r, _] = points.clone();
            add(
                "sphere-of-four-points",
                Goal::OfIsometry(3.8),
                vec![Contestant::quaternary(
                    "ours",
                    [p, q, r, s],
                    |p, q, r, s| p ^ q ^ r ^ s,
                    |c| view(c.to_array()),
                )],
            );
            let sphere = |(x, [r, ..]): (&[f64; 3], &[f64; 3])| {
                let center = at(x);
                DualSphere::new(
                    1.0,
                    center.e1,
                    center.e2,
                    center.e3,
                    center.ni - number(r * r),
                )
            };
            let spheres: Vec<_> = corners[0].iter().zip(&corners[1]).map(sphere).collect();
            let plane = |x: &[f64; 4]| {
                let [a, b, c, d] = x.map(number);
                DualPlane::new(a, b, c, d)
            };
            let planes: Vec<_> = source.planes().iter().map(plane).collect();
            add(
                "sphere∧plane",
                Goal::Shown,
                vec![Contestant::binary(
                    "ours",
                    spheres,
                    planes,
                    |s, p| s ^ p,
                    |c| view(c.to_array()),
                )],
            );
            add(
                "conformal-motor·motor",
                Goal::Shown,
                vec![Contestant::binary(
                    "ours",
                    motors,
                    b.iter().map(motor).collect(),
                    |a, b| a * b,
                    |m| view(m.to_array()),
                )],
            );
            add(
                "even-versor-on-point",
                Goal::Shown,
                vec![Contestant::binary(
                    "ours",
                    versors.clone(),
                    points[1].clone(),
                    |v, p| v.apply(p),
                    |p| view(p.to_array()),
                )],
            );
            let dense = |versor: &Versor<$float>| Multivector::from(*versor);
            let reversed = |versor: &Versor<$float>| {
                Multivector::from(versor.reverse()) + DualSphere::new(1.0, 2.0, 3.0, 4.0, 5.0)
            };
            add(
                "dense-32×32",
                Goal::OfIsometry(50.0),
                vec![Contestant::binary(
                    "ours",
                    versors.iter().map(dense).collect(),
                    versors.iter().map(reversed).collect(),
                    |a, b| a * b,
                    |m| view(m.to_array()),
                )],
            );
        }
    };
}

contests!(f32 single);
contests!(f64 double);

/// The contests over both types of numbers.
pub fn run(table: &mut Table) {
    single(table);
    double(table);
}
