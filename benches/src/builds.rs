//! Which builds are measured, and how a measurement builds and runs itself anew.

use std::path::Path;
use std::process::Command;

/// What a build is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Build {
    /// What `cargo build` makes: every 64-bit machine of the family runs it.
    Baseline,
    /// x86-64-v3: AVX2 and fused multiply-add, on every machine since about 2015.
    V3,
    /// The processor that it is compiled on.
    Native,
}

impl Build {
    /// All builds, slowest first.
    pub const ALL: [Build; 3] = [Build::Baseline, Build::V3, Build::Native];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Build::Baseline => "baseline",
            Build::V3 => "x86-64-v3",
            Build::Native => "native",
        }
    }

    /// The flags for the compiler.
    pub fn flags(self) -> &'static str {
        match self {
            Build::Baseline => "",
            Build::V3 => "-C target-cpu=x86-64-v3",
            Build::Native => "-C target-cpu=native",
        }
    }

    /// Whether this machine runs it.
    pub fn runs_here(self) -> bool {
        match self {
            Build::Baseline | Build::Native => true,
            #[cfg(target_arch = "x86_64")]
            Build::V3 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(not(target_arch = "x86_64"))]
            Build::V3 => false,
        }
    }

    /// Whether this program itself is that build, as far as features of the processor tell.
    pub fn is_this(self) -> bool {
        self == Build::Baseline && !cfg!(any(target_feature = "avx", target_feature = "sve"))
    }

    /// Compiles a bench for this target and gives what it prints for these arguments. Each
    /// target has a directory of its own, so that nothing else is compiled again.
    ///
    /// # Errors
    /// What went wrong, in words: cargo does not run, the bench does not compile or fails.
    pub fn run(self, bench: &str, arguments: &[&str]) -> Result<String, String> {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let root = package.parent().unwrap_or(package);
        eprintln!("building {bench} for {} …", self.name());
        let output = Command::new(env!("CARGO"))
            .args([
                "bench",
                "--quiet",
                "--package",
                "ga-benches",
                "--bench",
                bench,
            ])
            .arg("--target-dir")
            .arg(root.join("target/benches").join(self.name()))
            .arg("--")
            .args(arguments)
            .env("RUSTFLAGS", self.flags())
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .current_dir(root)
            .output()
            .map_err(|error| format!("cargo does not run: {error}"))?;
        match output.status.success() {
            true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
            false => Err(format!(
                "the {} build of {bench} failed:\n{}",
                self.name(),
                String::from_utf8_lossy(&output.stderr)
            )),
        }
    }
}
