//! Sections for an algebra without a name.

ga::define_algebra! {
    R3 { products { wedge } }
}

fn main() {}
