//! R4,1 in the null basis, in multiples of what a rigid motion of a point costs by nalgebra.

use ga_benches::data::Data;
use ga_benches::ours::conformal as ours;
use ga_benches::ours::conformal::{circle, dense, line, motor, plane, sphere, versor};
use ga_benches::race::{Contestant, ELEMENTS};

use crate::others;
use crate::table::{Contest, Goal, OURS, Table};

/// The contests over one type of numbers.
macro_rules! contests {
    ($float:ident $module:ident) => {
        fn $module(table: &mut Table) {
            use others::$module::{isometry, point, view};

            let scalar = stringify!($float);
            let data = Data::new(ELEMENTS);
            let ([a, b], [x, y, z, _]) = (&data.motions, &data.vectors);
            let motors: Vec<_> = a.iter().map(motor::<$float>).collect();
            let versors: Vec<_> = a.iter().zip(x).map(versor::<$float>).collect();
            let points = data.vectors.each_ref();
            let points = points.map(|x| x.iter().map(ours::point::<$float>).collect::<Vec<_>>());
            let circles = x.iter().zip(y).zip(z).map(|((x, y), z)| circle([x, y, z]));
            let circles: Vec<_> = circles.collect();
            let lines: Vec<_> = x.iter().zip(y).map(line).collect();

            let mut add = |operation, goal, contestants| {
                let yardstick = Contestant::binary(
                    "nalgebra-isometry-on-point",
                    a.iter().map(isometry).collect(),
                    x.iter().map(point).collect(),
                    |m, p| m * p,
                    |p| view((*p).into()),
                );
                table.add(Contest {
                    homogeneous: true,
                    yardstick: Some(yardstick),
                    ..Contest::new(operation, scalar, goal, contestants)
                });
            };
            add(
                "conformal-motor-on-point",
                Goal::OfIsometry(2.1),
                vec![
                    Contestant::binary(
                        OURS,
                        motors.clone(),
                        points[0].clone(),
                        |m, p| m.apply(p),
                        |p| view([p.e1, p.e2, p.e3]),
                    ),
                    Contestant::binary(
                        "nalgebra",
                        a.iter().map(isometry).collect(),
                        x.iter().map(point).collect(),
                        |m, p| m * p,
                        |p| view((*p).into()),
                    ),
                ],
            );
            add(
                "conformal-motor-on-line",
                Goal::Shown,
                vec![Contestant::binary(
                    OURS,
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
                    OURS,
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
                    OURS,
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
                    OURS,
                    [p, q, r, s],
                    |p, q, r, s| p ^ q ^ r ^ s,
                    |c| view(c.to_array()),
                )],
            );
            let spheres: Vec<_> = x.iter().zip(y).map(sphere::<$float>).collect();
            let planes: Vec<_> = data.planes[0].iter().map(plane::<$float>).collect();
            add(
                "sphere∧plane",
                Goal::Shown,
                vec![Contestant::binary(
                    OURS,
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
                    OURS,
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
                    OURS,
                    versors.clone(),
                    points[1].clone(),
                    |v, p| v.apply(p),
                    |p| view(p.to_array()),
                )],
            );
            let dense = |x: &Vec<_>| versors.iter().zip(x).map(dense).collect::<Vec<_>>();
            add(
                "dense-32×32",
                Goal::OfIsometry(50.0),
                vec![Contestant::binary(
                    OURS,
                    dense(x),
                    dense(y),
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
