//! A unit versor of mixed parity.

ga::define_algebra! {
    mod wrong: R3 {
        types { #[unit] Paravector { 1, e1, e2, e3 } }
    }
}

fn main() {}
