//! R3: rotors on vectors and rotors times rotors, against quaternions and rotors of others.

use ga_benches::race::{Contestant, ELEMENTS};
use ga_lanes::slices;

use crate::table::{BY_SLICES, Contest, Goal, OURS, Table};
use crate::{clifford, others};
use ga_benches::data::Data;
use ga_benches::ours::euclidean::{rotor, vector};

/// The contests over one type of numbers.
macro_rules! contests {
    ($float:ident $module:ident) => {
        fn $module(table: &mut Table) {
            use others::$module::*;

            let scalar = stringify!($float);
            let data = Data::new(ELEMENTS);
            let [a, b] = &data.rotations;
            let x = &data.vectors[0];

            let mut add = |operation, contestants| {
                table.add(Contest::new(operation, scalar, Goal::Fastest, contestants));
            };
            let mut contestants = vec![
                Contestant::binary(
                    OURS,
                    a.iter().map(rotor::<$float>).collect(),
                    x.iter().map(vector).collect(),
                    |q, x| q.apply(x),
                    |x| view(x.to_array()),
                ),
                Contestant::slices(
                    BY_SLICES,
                    a.iter().map(rotor::<$float>).collect(),
                    x.iter().map(vector).collect(),
                    x.iter().map(vector).collect(),
                    |rotors, vectors, images| {
                        let done = slices::apply(rotors, vectors, images);
                        debug_assert_eq!(done, Ok(()));
                    },
                    |x| view(x.to_array()),
                ),
                Contestant::binary(
                    "nalgebra",
                    a.iter().map(quaternion).collect(),
                    x.iter().map(column).collect(),
                    |q, x| q * x,
                    |x| view((*x).into()),
                ),
                Contestant::binary(
                    "glam",
                    a.iter().map(quat).collect(),
                    x.iter().map(vec).collect(),
                    |q, x| q * x,
                    |x| view(x.to_array()),
                ),
                Contestant::binary(
                    "ultraviolet",
                    a.iter().map(ultra_rotor).collect(),
                    x.iter().map(ultra_vec).collect(),
                    |q, x| q * x,
                    |x| view((*x).into()),
                ),
            ];
            contestants.extend(clifford::rotor_on_vector::<$float>(&data));
            add("rotor-on-vector", contestants);
            let mut contestants = vec![
                Contestant::binary(
                    OURS,
                    a.iter().map(rotor::<$float>).collect(),
                    b.iter().map(rotor).collect(),
                    |a, b| a * b,
                    |q| view(q.reverse().to_array()),
                ),
                Contestant::slices(
                    BY_SLICES,
                    a.iter().map(rotor::<$float>).collect(),
                    b.iter().map(rotor).collect(),
                    b.iter().map(rotor).collect(),
                    |a, b, products| {
                        let done = slices::geometric(a, b, products);
                        debug_assert_eq!(done, Ok(()));
                    },
                    |q| view(q.reverse().to_array()),
                ),
                Contestant::binary(
                    "nalgebra",
                    a.iter().map(quaternion).collect(),
                    b.iter().map(quaternion).collect(),
                    |a, b| a * b,
                    |q| view([q.w, q.i, q.j, q.k]),
                ),
                Contestant::binary(
                    "glam",
                    a.iter().map(quat).collect(),
                    b.iter().map(quat).collect(),
                    |a, b| a * b,
                    |q| view([q.w, q.x, q.y, q.z]),
                ),
                Contestant::binary(
                    "ultraviolet",
                    a.iter().map(ultra_rotor).collect(),
                    b.iter().map(ultra_rotor).collect(),
                    |a, b| a * b,
                    |q| view([q.s, -q.bv.yz, q.bv.xz, -q.bv.xy]),
                ),
            ];
            contestants.extend(clifford::rotor_times_rotor::<$float>(&data));
            add("rotor·rotor", contestants);
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
