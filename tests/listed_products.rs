//! A list of products brings what its entries are made of, and nothing else.

ga::define_algebra! {
    mod rejecting: R3 {
        types { Line { e1, e2, e3 } Plane = grade 2; }
        products { reject }
    }
}

ga::define_algebra! {
    mod projecting: R3 {
        types { Line { e1, e2, e3 } Plane = grade 2; }
        products { project }
    }
}

ga::define_algebra! {
    mod applying: R3 {
        types { Line { e1, e2, e3 } }
        products { apply }
    }
}

#[test]
fn rejection_needs_no_other_entry() {
    let floor = rejecting::Plane::new(2.0, 0.0, 0.0);
    let rest: rejecting::Line = rejecting::Line::new(1.0, 2.0, 3.0).reject(floor);
    assert_eq!(rest, rejecting::Line::new(0.0, 0.0, 3.0));
}

#[test]
fn projection_needs_no_other_entry() {
    let floor = projecting::Plane::new(2.0, 0.0, 0.0);
    let shadow: projecting::Line = projecting::Line::new(1.0, 2.0, 3.0).project(floor);
    assert_eq!(shadow, projecting::Line::new(1.0, 2.0, 0.0));
}

#[test]
fn application_needs_no_other_entry() {
    let mirror = applying::Line::new(0.0, 0.0, 2.0);
    let image: applying::Line = mirror.apply(applying::Line::new(1.0, 2.0, 3.0));
    assert_eq!(image, applying::Line::new(1.0, 2.0, -3.0));
}
