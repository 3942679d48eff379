//! More dimensions than declared types have.

ga::define_algebra! {
    mod wrong: R13 {
        types { Line { e1^e2 } }
    }
}

fn main() {}
