//! A null pair counts once as positive and once as negative.

ga::define_algebra! {
    mod wrong: R4 {
        basis { e1, e2, no, ni }
        metric { e1^2 = 1, e2^2 = 1, no.ni = -1 }
        types { Point { e1, e2, no, ni } }
    }
}

fn main() {}
