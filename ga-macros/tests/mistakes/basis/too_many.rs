//! More names than vectors.

ga::define_algebra! {
    mod wrong: R3 {
        basis { x, y, z, w }
    }
}

fn main() {}
