//! Every mistake in a call is named on the tokens that are wrong, all of one call together.
//!
//! One case per mistake, in the folder of its kind; the file beside it is what the compiler says.
//! The folder `use` shows what stands around a call with mistakes: its types in use, and the macro
//! without the facade (that a right call compiles so is shown by the crate `tests/hygiene/bare`
//! of the root package).
//!
//! The cases stand here and not beside the other tests of the facade because each is compiled with
//! all that its package depends on, and no more is wanted than the macro.

/// Every case fails to compile with exactly the messages stored.
#[test]
fn every_mistake_is_named_where_it_is() {
    let cases = trybuild::TestCases::new();
    for kind in [
        "signature",
        "basis",
        "metric",
        "types",
        "products",
        "syntax",
        "use",
    ] {
        cases.compile_fail(format!("tests/mistakes/{kind}/*.rs"));
    }
    cases.compile_fail("tests/mistakes/*.rs");
}
