//! Many mistakes in one call come out together.

ga::define_algebra! {
    mod wrong: R4-1 {
        basis { e1, e2, e3, e2, ni }
        metric { e1^2 = one, e3^3 = 1, e4^2 = 1 }
        types {
            point { e1, e2, e12, e21 }
            Circle { e1^e5, e2 = 0 }
            Scalar = grade 7;
            #[derive(Hash)]
            Nothing {}
        }
        prodcts { wedge }
        products { wedge, dot, wedge }
    }
}

fn main() {}
