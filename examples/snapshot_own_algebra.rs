//! A crate reviews the code of its own algebra: `cargo test --example snapshot_own_algebra`.
//!
//! `algebra_source!` gives what `define_algebra!` with the same body generates, as formatted
//! text. A test compares it with a file that is committed; whoever changes the declaration, or
//! takes a new version of the generator, sees in the diff what became of every function. With
//! `cargo insta` the comparison below is one line, `insta::assert_snapshot!(SOURCE)`.

/// The declaration stands once, and both macros read it.
macro_rules! declaration {
    ($($macro:ident)::+) => {
        $($macro)::+! {
            /// Complex numbers as the even part of the plane.
            pub mod plane: R2 {
                types {
                    /// A vector of the plane.
                    Vector { e1, e2 }
                    /// A complex number.
                    Complex { 1, e12 }
                }
                products { geometric, wedge, inner }
            }
        }
    };
}

declaration!(ga::define_algebra);

/// The generated code as text.
const SOURCE: &str = declaration!(ga::algebra_source);

fn main() {
    println!("{SOURCE}");
    let i = plane::Complex::new(0.0, 1.0);
    println!("// i i = {}", i * i);
}

#[cfg(test)]
mod tests {
    use std::{env, fs};

    /// Compares with the committed file; `UPDATE=1` writes it anew.
    #[test]
    fn the_generated_code_is_the_reviewed_one() -> std::io::Result<()> {
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/examples/snapshot_own_algebra.txt"
        );
        if env::var_os("UPDATE").is_some() {
            fs::write(file, super::SOURCE)?;
        }
        assert_eq!(super::SOURCE, fs::read_to_string(file)?);
        Ok(())
    }
}
