//! The dot of the typesetters.

ga::define_algebra! {
    mod wrong: R1_1 {
        basis { no, ni }
        metric { no·ni = -1 }
    }
}

fn main() {}
