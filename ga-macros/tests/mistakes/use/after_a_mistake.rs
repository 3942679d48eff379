//! The types of a call with mistakes are there all the same: their use is no further error.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            Vector { e1, e2, e3 }
            Rotor { 1, e12, e23, e32 }
            Line = grade two;
            Point(e1, e2)
        }
        products { wedge, geometrc }
    }
}

use wrong::{Even, Line, Multivector, Point, Rotor, Vector};

/// Fields, which completion offers as well.
fn fields(v: Vector, r: Rotor<f32>) -> (f64, f32) {
    (v.e3, r.e23)
}

fn main() {
    let _: Option<(Even, Line, Multivector, Point)> = None;
    fields(Vector::default(), Rotor::default());
}
