//! Vectors and rotors of Euclidean 3-space: `cargo run --example first_steps`.

ga::define_algebra!(R3);

use r3::{Bivector, Vector};

fn main() {
    let a = Vector::new(1.0, 2.0, 3.0);
    let b = Vector::new(4.0, 5.0, 6.0);
    println!("a         = {a}");
    println!("b         = {b}");
    println!("a ∧ b     = {}", a ^ b);
    println!("a · b     = {}", a | b);
    println!("a b       = {}", a * b);
    println!("dual of a = {}", !a);

    // A rotor e^{−θB/2} turns by θ in the plane B: here a quarter turn from e1 to e2.
    let plane = Bivector::new(1.0, 0.0, 0.0);
    let quarter = (plane * (-std::f64::consts::FRAC_PI_4)).exp();
    println!("R         = {quarter:.4}");
    println!(
        "R[e1]     = {:.4}",
        quarter.apply(Vector::new(1.0, 0.0, 0.0))
    );
    println!(
        "R R[e1]   = {:.4}",
        (quarter * quarter).apply(Vector::new(1.0, 0.0, 0.0))
    );

    // What need not exist is an `Option`: the zero vector has no inverse.
    println!(
        "1/a       = {:?}",
        a.inverse().map(|inverse| inverse.to_string())
    );
    println!("1/0       = {:?}", Vector::new(0.0, 0.0, 0.0).inverse());
}
