//! Brackets nested beyond all measure.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]] }
    }
}

fn main() {}
