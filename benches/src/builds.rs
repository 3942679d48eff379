//! Which builds are measured, and how a measurement builds and runs itself anew.

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
    /// That without its 512-bit vectors, where it has them.
    NativeAvx2,
}

/// The features that this program has, for the other builds of it.
const FEATURES: &[&str] = match cfg!(feature = "clifford") {
    true => &["--features", "clifford"],
    false => &[],
};

impl Build {
    /// All builds.
    pub const ALL: [Build; 4] = [Build::Baseline, Build::V3, Build::Native, Build::NativeAvx2];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Build::Baseline => "baseline",
            Build::V3 => "x86-64-v3",
            Build::Native => "native",
            Build::NativeAvx2 => "native without AVX-512",
        }
    }

    /// The flags for the compiler.
    pub fn flags(self) -> &'static str {
        match self {
            Build::Baseline => "",
            Build::V3 => "-C target-cpu=x86-64-v3",
            Build::Native => "-C target-cpu=native",
            Build::NativeAvx2 => "-C target-cpu=native -C target-feature=-avx512f",
        }
    }

    /// Whether this machine has and runs it.
    pub fn runs_here(self) -> bool {
        match self {
            Build::Baseline | Build::Native => true,
            #[cfg(target_arch = "x86_64")]
            Build::V3 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Build::NativeAvx2 => is_x86_feature_detected!("avx512f"),
            #[cfg(not(target_arch = "x86_64"))]
            Build::V3 | Build::NativeAvx2 => false,
        }
    }

    /// Whether this program itself is that build, as far as features of the processor tell.
    pub fn is_this(self) -> bool {
        self == Build::Baseline && !cfg!(any(target_feature = "avx", target_feature = "sve"))
    }

    /// Compiles a bench for this target and gives what it prints for these arguments. Cargo keeps
    /// what it compiles for different flags apart, and with `--target` compiles macros and build
    /// scripts but once for all of them.
    ///
    /// # Errors
    /// What went wrong, in words: cargo does not run, the bench does not compile or fails.
    pub fn run(self, bench: &str, arguments: &[&str]) -> Result<String, String> {
        eprintln!("building {bench} for {} …", self.name());
        let output = Command::new(env!("CARGO"))
            .args(["bench", "--quiet", "--package", "ga-benches", "--bench"])
            .args([bench, "--target", "host-tuple"])
            .args(FEATURES)
            .arg("--")
            .args(arguments)
            .env("RUSTFLAGS", self.flags())
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .current_dir(env!("CARGO_MANIFEST_DIR"))
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
