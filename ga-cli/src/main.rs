//! The program `articulate`.
fn main() {}
