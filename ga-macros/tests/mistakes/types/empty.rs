//! A type without blades.

ga::define_algebra! {
    mod wrong: R3 {
        types { Nothing {} }
    }
}

fn main() {}
