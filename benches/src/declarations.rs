//! The declarations of the library's own algebras, as the generator reads them.

/// The conformal model of space.
pub fn conformal() -> &'static str {
    body(include_str!("../../ga-cga/src/algebra.rs"))
}

/// The plane-based model of space.
pub fn plane_based() -> &'static str {
    body(include_str!("../../ga-spaces/src/plane_based3.rs"))
}

/// The body of the one call of `define_algebra!` in a file.
fn body(source: &'static str) -> &'static str {
    let call = source.split_once("define_algebra! {");
    let call = call.map_or(source, |(_, call)| call);
    call.split_once("\n}\n").map_or(call, |(body, _)| body)
}
