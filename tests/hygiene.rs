//! Generated code compiles in crates that are not this one, under their names and their lints.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Checks a crate of `tests/hygiene` the way its owner would, apart from this workspace.
///
/// It is copied out of the tree, so that nothing is written there, and takes the versions of
/// the workspace's lock file, so that nothing is fetched.
fn checks(name: &str) -> Result<(), Box<dyn Error>> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    let source = workspace.join("tests/hygiene").join(name);
    let shared = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("hygiene");
    let copy = shared.join(name);
    fs::create_dir_all(&copy)?;
    let root = workspace.display().to_string().replace('\\', "/");
    let manifest = fs::read_to_string(source.join("Cargo.toml"))?.replace("WORKSPACE", &root);
    fs::write(copy.join("Cargo.toml"), manifest)?;
    fs::copy(source.join("lib.rs"), copy.join("lib.rs"))?;
    fs::copy(workspace.join("Cargo.lock"), copy.join("Cargo.lock"))?;
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["check", "--offline", "--quiet", "--manifest-path"])
        .arg(copy.join("Cargo.toml"))
        .env("CARGO_TARGET_DIR", shared.join("target"))
        .output()?;
    if output.status.success() {
        Ok(())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into())
    }
}

/// `algebra = { package = "ga" }`.
#[test]
fn a_renamed_dependency() -> Result<(), Box<dyn Error>> {
    checks("renamed")
}

/// `forbid(unsafe_code)`, `deny(missing_docs, warnings)`, two metrics in one module, types named
/// as in the prelude, every visibility.
#[test]
fn the_strictest_lints() -> Result<(), Box<dyn Error>> {
    checks("strict")
}

/// `no_std`, from ga-core and ga-macros alone.
#[test]
fn no_standard_library() -> Result<(), Box<dyn Error>> {
    checks("bare")
}

/// `crate = path;`, re-exports, and declarations by the user's own macros.
#[test]
fn explicit_paths() -> Result<(), Box<dyn Error>> {
    checks("paths")
}
