//! R3,0,1: rigid motions, and what is joined and met, against isometries, dual quaternions and
//! matrices, and against `geometric_algebra`, which has the same algebra in f32.

mod geometric_algebra;

use ga_benches::data::Data;
use ga_benches::ours::plane_based as ours;
use ga_benches::ours::plane_based::{Line, motor, plane, screw};
use ga_benches::race::{Contestant, ELEMENTS};
use ga_lanes::{Batch, slices};

use crate::table::{BY_SLICES, Contest, Goal, IN_BATCHES, OURS, Table};
use crate::{clifford, others};

/// Where the corners of a frame are taken: a motion, whatever it is stored as.
const CORNERS: [[f64; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The images of the corners, one after the other.
pub fn corners(image: impl Fn(&[f64; 3]) -> Vec<f64>) -> Vec<f64> {
    CORNERS.iter().flat_map(image).collect()
}

/// One motion on all points: each library by what it has for that.
macro_rules! one_on_many {
    ($float:ident, $data:ident, $points:ident) => {{
        let one = &$data.motions[0][0];
        let (own, isometry, dual) = (motor::<$float>(one), isometry(one), dual_quaternion(one));
        let (affine, matrix, ultra) = (affine(one), matrix(one), ultra_isometry(one));
        let homogeneous = isometry.to_homogeneous();
        let columns = $data.vectors[0].iter().map(point).collect::<Vec<_>>();
        let vecs = $data.vectors[0].iter().map(vec).collect::<Vec<_>>();
        vec![
            Contestant::slice(
                OURS,
                $points.clone(),
                $points.clone(),
                move |points, images| {
                    let done = own.apply_slice(points, images);
                    debug_assert_eq!(done, Ok(()));
                },
                |p| view(p.to_array()),
            ),
            Contestant::unary(
                "nalgebra",
                columns.clone(),
                move |p| isometry * p,
                |p| view((*p).into()),
            ),
            Contestant::unary(
                "nalgebra-dual-quat",
                columns.clone(),
                move |p| dual * p,
                |p| view((*p).into()),
            ),
            Contestant::unary(
                "nalgebra-matrix",
                columns,
                move |p| homogeneous.transform_point(&p),
                |p| view((*p).into()),
            ),
            Contestant::unary(
                "glam-affine",
                vecs.clone(),
                move |p| affine.transform_point3(p),
                |p| view(p.to_array()),
            ),
            Contestant::unary(
                "glam-mat4",
                vecs,
                move |p| matrix.transform_point3(p),
                |p| view(p.to_array()),
            ),
            Contestant::unary(
                "ultraviolet",
                $data.vectors[0].iter().map(ultra_vec).collect(),
                move |p| ultra.transform_vec(p),
                |p| view((*p).into()),
            ),
        ]
    }};
}

/// The contests over one type of numbers.
macro_rules! contests {
    ($float:ident $module:ident) => {
        fn $module(table: &mut Table) {
            use others::$module::*;

            let data = Data::new(ELEMENTS);
            let ([a, b], [x, y, ..]) = (&data.motions, &data.vectors);
            let scalar = stringify!($float);
            let with_geometric_algebra = scalar == "f32";
            let motors: Vec<_> = a.iter().map(motor::<$float>).collect();
            let points: Vec<_> = x.iter().map(ours::point::<$float>).collect();
            let lines: Vec<_> = x.iter().zip(y).map(ours::line::<$float>).collect();
            let mut add = |operation, goal, homogeneous, contestants| {
                let contest = Contest::new(operation, scalar, goal, contestants);
                table.add(match homogeneous {
                    true => contest.homogeneous(),
                    false => contest,
                });
            };
            let planes = data.planes.each_ref();
            let planes =
                planes.map(|planes| planes.iter().map(plane::<$float>).collect::<Vec<_>>());

            let mut contestants = vec![
                Contestant::binary(
                    OURS,
                    motors.clone(),
                    b.iter().map(motor).collect(),
                    |a, b| a * b,
                    |m| corners(|x| view(m.apply(ours::point(x)).to_array())),
                ),
                Contestant::slices(
                    BY_SLICES,
                    motors.clone(),
                    b.iter().map(motor).collect(),
                    motors.clone(),
                    |a, b, products| {
                        let done = slices::geometric(a, b, products);
                        debug_assert_eq!(done, Ok(()));
                    },
                    |m| corners(|x| view(m.apply(ours::point(x)).to_array())),
                ),
                Contestant::binary(
                    "nalgebra",
                    a.iter().map(isometry).collect(),
                    b.iter().map(isometry).collect(),
                    |a, b| a * b,
                    |m| corners(|x| view((m * point(x)).into())),
                ),
                Contestant::binary(
                    "nalgebra-dual-quat",
                    a.iter().map(dual_quaternion).collect(),
                    b.iter().map(dual_quaternion).collect(),
                    |a, b| a * b,
                    |m| corners(|x| view((m * point(x)).into())),
                ),
                Contestant::binary(
                    "glam-affine",
                    a.iter().map(affine).collect(),
                    b.iter().map(affine).collect(),
                    |a, b| a * b,
                    |m| corners(|x| view(m.transform_point3(vec(x)).to_array())),
                ),
                Contestant::binary(
                    "ultraviolet",
                    a.iter().map(ultra_isometry).collect(),
                    b.iter().map(ultra_isometry).collect(),
                    |a, b| a * b,
                    |m| corners(|x| view((*m * ultra_vec(x)).into())),
                ),
            ];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::motor_times_motor(&data));
            }
            contestants.extend(clifford::motor_times_motor::<$float>(&data));
            add("motor·motor", Goal::Fastest, false, contestants);

            let mut contestants = vec![
                Contestant::binary(
                    OURS,
                    motors.clone(),
                    points.clone(),
                    |m, p| m.apply(p),
                    |p| view(p.to_array()),
                ),
                Contestant::slices(
                    BY_SLICES,
                    motors.clone(),
                    points.clone(),
                    points.clone(),
                    |motors, points, images| {
                        let done = slices::apply(motors, points, images);
                        debug_assert_eq!(done, Ok(()));
                    },
                    |p| view(p.to_array()),
                ),
                Contestant::binary(
                    "nalgebra",
                    a.iter().map(isometry).collect(),
                    x.iter().map(point).collect(),
                    |m, p| m * p,
                    |p| view((*p).into()),
                ),
                Contestant::binary(
                    "nalgebra-dual-quat",
                    a.iter().map(dual_quaternion).collect(),
                    x.iter().map(point).collect(),
                    |m, p| m * p,
                    |p| view((*p).into()),
                ),
                Contestant::binary(
                    "glam-affine",
                    a.iter().map(affine).collect(),
                    x.iter().map(vec).collect(),
                    |m, p| m.transform_point3(p),
                    |p| view(p.to_array()),
                ),
                Contestant::binary(
                    "glam-mat4",
                    a.iter().map(matrix).collect(),
                    x.iter().map(vec).collect(),
                    |m, p| m.transform_point3(p),
                    |p| view(p.to_array()),
                ),
                Contestant::binary(
                    "ultraviolet",
                    a.iter().map(ultra_isometry).collect(),
                    x.iter().map(ultra_vec).collect(),
                    |m, p| m.transform_vec(p),
                    |p| view((*p).into()),
                ),
            ];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::motor_on_point(&data));
            }
            contestants.extend(clifford::motor_on_point::<$float>(&data));
            add("motor-on-point", Goal::Fastest, false, contestants);

            let contestants = one_on_many!($float, data, points);
            add("one-motor-on-points", Goal::Fastest, false, contestants);

            let mut contestants = vec![Contestant::binary(
                OURS,
                motors.clone(),
                lines.clone(),
                |m, l| m.apply(l),
                |l| view(l.to_array()),
            )];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::motor_on_line(&data));
            }
            add("motor-on-line", Goal::Times(3.0), true, contestants);

            let mut contestants = vec![Contestant::binary(
                OURS,
                motors.clone(),
                planes[0].clone(),
                |m, p| m.apply(p),
                |p| view(p.to_array()),
            )];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::motor_on_plane(&data));
            }
            add("motor-on-plane", Goal::Times(3.0), true, contestants);

            let others: Vec<_> = y.iter().map(ours::point::<$float>).collect();
            let mut contestants = vec![
                Contestant::binary(
                    OURS,
                    points.clone(),
                    others.clone(),
                    |p, q| p & q,
                    |l: &Line<$float>| view(l.to_array()),
                ),
                Contestant::slices(
                    BY_SLICES,
                    points.clone(),
                    others,
                    lines.clone(),
                    |p, q, joins| {
                        let done = slices::regressive(p, q, joins);
                        debug_assert_eq!(done, Ok(()));
                    },
                    |l: &Line<$float>| view(l.to_array()),
                ),
            ];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::join_of_points(&data));
            }
            add("join-of-points", Goal::Times(3.0), true, contestants);

            let mut contestants = vec![Contestant::ternary(
                OURS,
                planes,
                |a, b, c| (a ^ b) ^ c,
                |p| view(p.to_array()),
            )];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::meet_of_planes(&data));
            }
            add("meet-of-three-planes", Goal::Times(3.0), true, contestants);

            let batch = Batch::from_slice(&lines);
            let mut contestants = vec![
                Contestant::unary(OURS, lines, screw, |m| view(m.to_array())),
                Contestant::container(IN_BATCHES, batch, Batch::exp, |motors, count| {
                    let motors = motors.iter().take(count);
                    motors.map(|m| view(m.to_array())).collect()
                }),
            ];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::exponential(&data));
            }
            add("exp-of-line", Goal::Times(3.0), false, contestants);

            let batch = Batch::from_slice(&motors);
            let mut contestants = vec![
                Contestant::unary(
                    OURS,
                    motors,
                    |m| m.log().unwrap_or_default(),
                    |l| view(l.to_array()),
                ),
                Contestant::container(IN_BATCHES, batch, Batch::log, |lines, count| {
                    let lines = lines.iter().take(count).map(Option::unwrap_or_default);
                    lines.map(|l| view(l.to_array())).collect()
                }),
            ];
            if with_geometric_algebra {
                contestants.push(geometric_algebra::logarithm(&data));
            }
            add("log-of-motor", Goal::Times(3.0), false, contestants);
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
