//! Where and when something was measured.

use std::fmt::Write;
use std::process::Command;
use std::time::SystemTime;

/// The machine, the date, the compiler, the state of the sources and the flags, as a list.
pub fn description() -> String {
    let mut list = String::new();
    let mut item = |name: &str, value: String| {
        let _ = writeln!(list, "- {name}: {value}");
    };
    item("machine", machine());
    let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    item("date", now.split('T').next().unwrap_or_default().to_owned());
    item("compiler", first_line("rustc", &["--version"]));
    item("sources", sources());
    item(
        "builds",
        "baseline is cargo's profile `bench` without flags; the others have the `RUSTFLAGS` that \
         stand beside their names"
            .to_owned(),
    );
    list
}

/// The processor, its cores and what it is called by the compiler.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = information
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'))
        .map_or("processor of unknown name", |(_, name)| name.trim());
    let native = Command::new("rustc")
        .args(["--print", "target-cpus"])
        .output()
        .map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
        .unwrap_or_default();
    let native = native
        .split_once("currently ")
        .and_then(|(_, rest)| rest.split_once(')'))
        .map_or("unknown", |(name, _)| name);
    let system = std::env::consts::OS;
    format!("{model} (target-cpu {native}), {cores} cores, {system}")
}

/// The commit, and whether anything differs from it.
fn sources() -> String {
    let commit = first_line("git", &["rev-parse", "--short", "HEAD"]);
    let changed = first_line(
        "git",
        &["status", "--porcelain", "--", ":!benches/RESULTS.md"],
    );
    match changed.is_empty() {
        true => commit,
        false => format!("{commit} and changes"),
    }
}

/// The first line that a program prints; empty where it does not run.
fn first_line(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    text.unwrap_or_default()
        .lines()
        .next()
        .unwrap_or_default()
        .to_owned()
}
