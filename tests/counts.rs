//! Operation counts that may shrink but not grow, read from the ledgers of three algebras.

/// The body of a call of `define_algebra!` in a file.
fn declaration(file: &'static str) -> &'static str {
    let (_, call) = file.split_once("define_algebra! {").expect("a declaration");
    let (call, _) = call.split_once("\n}\n").unwrap_or((call, ""));
    call.trim_end()
}

/// Multiplications, doublings apart, and additions of a function.
fn cost(ledger: &ga_codegen::Ledger, function: &str) -> (usize, usize) {
    let entry = ledger
        .entries
        .iter()
        .find(|entry| entry.function == function);
    let entry = entry.unwrap_or_else(|| panic!("{function} is not in the ledger"));
    let cost = entry
        .cost
        .unwrap_or_else(|| panic!("{function} has no cost of its own"));
    (cost.multiplications, cost.additions)
}

/// Asserts that each sum of functions takes at most so many multiplications.
fn at_most(declaration: &str, limits: &[(&[&str], usize)]) {
    let ledger = ga_codegen::ledger(declaration).unwrap_or_else(|mistakes| panic!("{mistakes}"));
    for (functions, limit) in limits {
        let sum: usize = functions.iter().map(|name| cost(&ledger, name).0).sum();
        assert!(sum <= *limit, "{functions:?}: {sum} of {limit}");
    }
}

#[test]
fn space() {
    at_most(
        "R3",
        &[
            (&["Unit<Even>.apply(Vector)"], 15),
            (&["Even.apply(Vector)"], 23),
            (&["Even.geometric(Even)"], 16),
            (&["Even.linear_map(Vector)"], 9),
        ],
    );
}

#[test]
fn plane_based() {
    at_most(
        declaration(include_str!("../ga-spaces/src/plane_based3.rs")),
        &[
            (&["Unit<Motor>.apply(Point)"], 18),
            (&["Unit<Motor>.apply(Plane)"], 28),
            (&["Unit<Motor>.apply(Line)"], 45),
            (&["Motor.geometric(Motor)"], 48),
            (&["Motor.linear_map(Point)"], 9),
        ],
    );
}

#[test]
fn conformal() {
    at_most(
        declaration(include_str!("../ga-cga/src/algebra.rs")),
        &[
            (&["Unit<Motor>.apply(Point)"], 22),
            (&["Motor.apply(Point)"], 30),
            (&["Unit<Motor>.apply(DualSphere)"], 36),
            (&["Unit<Motor>.apply(Line)"], 45),
            (&["Unit<Motor>.apply(Circle)"], 107),
            (&["Unit<Motor>.apply(PointPair)"], 107),
            (&["Unit<Even>.apply(DualSphere)"], 115),
            (&["Unit<Even>.apply(Point)"], 47),
            (&["Motor.geometric(Motor)"], 48),
            (&["Point.wedge(Point)", "Point.wedge(PointPair)"], 36),
            (
                &[
                    "Point.wedge(Point)",
                    "Point.wedge(PointPair)",
                    "Point.wedge(Circle)",
                ],
                52,
            ),
            (&["Motor.linear_map(DualSphere)"], 18),
            (&["Motor.linear_map(Point)"], 13),
        ],
    );
}

/// Without the promise that points are null: all five coefficients for themselves.
#[test]
fn conformal_points_that_may_be_spheres() {
    let declared = declaration(include_str!("../ga-cga/src/algebra.rs"));
    let general = declared.replace("#[null]", "");
    assert_ne!(declared, general);
    at_most(
        &general,
        &[
            (&["Unit<Motor>.apply(Point)"], 32),
            (&["Motor.apply(Point)"], 44),
            (&["Unit<Even>.apply(Point)"], 107),
        ],
    );
}
