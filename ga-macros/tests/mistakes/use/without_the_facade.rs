//! The macro without the facade: a right call takes the core from its own crate, a wrong one
//! is marked as it is through the facade.

ga_macros::define_algebra!(R2);

ga_macros::define_algebra! {
    crate = ::ga_core;
    mod wrong: R3 {
        basis { x, y, z }
        types { Vector { x, y, w } }
    }
}

ga_macros::define_algebra!(R4-1);

fn main() {
    let _ = r2::Vector::new(1.0, 2.0) ^ r2::Vector::new(3.0, 4.0);
    let _ = wrong::Vector::<f64>::default();
}
