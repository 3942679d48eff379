//! The functions that are counted, each called on the same few operands.

mod operands;

use std::hint::black_box;

use ga_benches::ours::plane_based::screw;
use operands::Operands;

/// How often each function is called.
pub const CALLS: usize = 256;

/// Calls a function on each element; results go to memory, so that no call is left out and none
/// joined with the next.
#[inline(always)]
fn unary<A: Copy, C>(a: &[A], function: impl Fn(A) -> C) {
    for a in a {
        black_box(function(*a));
    }
}

/// The same with two operands.
#[inline(always)]
fn binary<A: Copy, B: Copy, C>(a: &[A], b: &[B], function: impl Fn(A, B) -> C) {
    for (a, b) in a.iter().zip(b) {
        black_box(function(*a, *b));
    }
}

/// The counted functions: the type of the numbers, the name, what is called on what.
macro_rules! functions {
    ($($float:ident $name:ident |$data:ident| $call:expr;)*) => {
        /// The names, as they stand in the limits.
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];

        /// Calls every function.
        pub fn call_all() {
            let single = black_box(Operands::<f32>::new(CALLS));
            let double = black_box(Operands::<f64>::new(CALLS));
            $(functions!(@call $float $name single double);)*
        }

        $(
            #[inline(never)]
            fn $name($data: &Operands<$float>) {
                $call
            }
        )*
    };
    (@call f32 $name:ident $single:ident $double:ident) => {
        $name(&$single)
    };
    (@call f64 $name:ident $single:ident $double:ident) => {
        $name(&$double)
    };
}

functions! {
    f32 rotor_on_vector_f32 |x| binary(&x.rotors, &x.vectors, |r, v| r.apply(v));
    f64 rotor_on_vector |x| binary(&x.rotors, &x.vectors, |r, v| r.apply(v));
    f32 rotor_rotor_f32 |x| binary(&x.rotors, &x.rotors, |a, b| a * b);
    f64 rotor_rotor |x| binary(&x.rotors, &x.rotors, |a, b| a * b);
    f32 motor_motor_f32 |x| binary(&x.motors, &x.motors, |a, b| a * b);
    f64 motor_motor |x| binary(&x.motors, &x.motors, |a, b| a * b);
    f32 motor_on_point_f32 |x| binary(&x.motors, &x.points[0], |m, p| m.apply(p));
    f64 motor_on_point |x| binary(&x.motors, &x.points[0], |m, p| m.apply(p));
    f32 motor_on_line_f32 |x| binary(&x.motors, &x.lines, |m, l| m.apply(l));
    f64 motor_on_line |x| binary(&x.motors, &x.lines, |m, l| m.apply(l));
    f32 motor_on_plane_f32 |x| binary(&x.motors, &x.planes, |m, p| m.apply(p));
    f64 motor_on_plane |x| binary(&x.motors, &x.planes, |m, p| m.apply(p));
    f64 join_of_points |x| binary(&x.points[0], &x.points[1], |p, q| p & q);
    f64 meet_of_three_planes |x| binary(&x.planes, &x.plane_pairs, |p, (q, r)| p ^ q ^ r);
    f32 exp_of_line_f32 |x| unary(&x.lines, screw);
    f64 exp_of_line |x| unary(&x.lines, screw);
    f32 log_of_motor_f32 |x| unary(&x.motors, |m| m.log());
    f64 log_of_motor |x| unary(&x.motors, |m| m.log());
    f64 conformal_motor_on_point |x| {
        binary(&x.conformal_motors, &x.conformal_points[0], |m, p| m.apply(p))
    };
    f64 conformal_motor_on_line |x| {
        binary(&x.conformal_motors, &x.conformal_lines, |m, l| m.apply(l))
    };
    f64 conformal_motor_on_circle |x| {
        binary(&x.conformal_motors, &x.circles, |m, c| m.apply(c))
    };
    f64 conformal_motor_motor |x| {
        binary(&x.conformal_motors, &x.conformal_motors, |a, b| a * b)
    };
    f64 circle_of_three_points |x| {
        binary(&x.conformal_points[0], &x.point_pairs[0], |p, (q, r)| p ^ q ^ r)
    };
    f64 sphere_of_four_points |x| {
        binary(&x.point_pairs[0], &x.point_pairs[1], |(p, q), (r, s)| p ^ q ^ r ^ s)
    };
    f64 sphere_and_plane |x| binary(&x.spheres, &x.conformal_planes, |s, p| s ^ p);
    f64 even_versor_on_point |x| {
        binary(&x.versors, &x.conformal_points[0], |v, p| v.apply(p))
    };
    f64 even_versor_versor |x| binary(&x.versors, &x.versors, |a, b| a * b);
    f64 dense_32_by_32 |x| binary(&x.dense, &x.dense, |a, b| a * b);
}
