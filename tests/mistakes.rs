//! Every mistake in a call is named on the tokens that are wrong, all of one call together.
//!
//! One case per mistake, in the folder of its kind; the file beside it is what the compiler says.

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
    ] {
        cases.compile_fail(format!("tests/mistakes/{kind}/*.rs"));
    }
    cases.compile_fail("tests/mistakes/*.rs");
}
