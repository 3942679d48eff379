//! How the tests run the program, and what they look at.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What came of running the program.
pub struct Ran {
    /// The exit code; −1 if it was killed.
    pub code: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// The program with these words, in this directory.
pub fn program(directory: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_articulate"));
    command
        .current_dir(directory)
        .args(words)
        .stdin(Stdio::null());
    command
}

/// Runs the program with these words in this directory.
pub fn run(directory: &Path, words: &[&str]) -> Ran {
    let Output {
        status,
        stdout,
        stderr,
    } = program(directory, words)
        .output()
        .expect("the program starts");
    Ran {
        code: status.code().unwrap_or(-1),
        stdout: String::from_utf8(stdout).expect("standard output is UTF-8"),
        stderr: String::from_utf8(stderr).expect("standard error is UTF-8"),
    }
}

impl Ran {
    /// The standard output of a run that went well and said nothing else.
    pub fn well(self) -> String {
        assert_eq!(self.code, 0, "{}", self.stderr);
        assert_eq!(self.stderr, "");
        self.stdout
    }

    /// The same as JSON.
    pub fn json(self) -> serde_json::Value {
        serde_json::from_str(&self.well()).expect("standard output is JSON")
    }

    /// The message of a run that failed with this code and printed nothing but one message.
    pub fn message(self, code: i32) -> String {
        assert_eq!(self.code, code, "{}{}", self.stdout, self.stderr);
        assert_eq!(self.stdout, "");
        assert_eq!(self.stderr.matches("error:").count(), 1, "{}", self.stderr);
        assert!(self.stderr.starts_with("error: "), "{}", self.stderr);
        assert!(!self.stderr.contains("panicked"), "{}", self.stderr);
        self.stderr
    }
}

/// A directory of its own for a test.
pub fn directory() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary directory")
}

/// The names of the files in a directory, sorted.
pub fn names(directory: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(directory).expect("the directory is there");
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        entry
            .expect("an entry")
            .file_name()
            .to_string_lossy()
            .into_owned()
    };
    let mut names: Vec<_> = entries.map(name).collect();
    names.sort();
    names
}

/// The directory of the shipped crystals.
pub fn crystals() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../ga-design/data/cif")
}

/// The path of a shipped crystal.
pub fn shipped(name: &str) -> String {
    crystals()
        .join(name)
        .to_str()
        .expect("a path in UTF-8")
        .to_owned()
}

/// The number of nodes of a GLB file that show the mesh named `sphere`, read by the `gltf` crate.
pub fn spheres(file: &Path) -> usize {
    let bytes = std::fs::read(file).expect("the file is there");
    let model = gltf::Gltf::from_slice(&bytes).expect("a valid GLB file");
    let is_sphere = |node: &gltf::Node| {
        node.mesh()
            .is_some_and(|mesh| mesh.name() == Some("sphere"))
    };
    model.nodes().filter(is_sphere).count()
}
