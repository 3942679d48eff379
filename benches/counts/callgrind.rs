//! How instructions are counted: this program under callgrind, and the totals of its profile.

use std::process::{Command, Stdio};

/// Whether callgrind runs.
///
/// # Errors
/// That it does not, and where to get it.
pub fn is_there() -> Result<(), String> {
    let valgrind = Command::new("valgrind")
        .args(["--tool=callgrind", "--help"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    match valgrind {
        Ok(status) if status.success() => Ok(()),
        _ => Err(
            "valgrind is not installed (Debian, Ubuntu: apt install valgrind; Fedora: dnf install \
             valgrind; https://valgrind.org)"
                .to_owned(),
        ),
    }
}

/// The instructions that each of these functions of this program needs, with all that it calls.
///
/// # Errors
/// What went wrong: the run, or a function that does not stand in the profile.
pub fn instructions(names: &[&str]) -> Result<Vec<u64>, String> {
    is_there()?;
    let program = std::env::current_exe().map_err(|error| format!("no own path: {error}"))?;
    let profile = program.with_extension(format!("callgrind.{}", std::process::id()));
    let status = Command::new("valgrind")
        .args([
            "--tool=callgrind",
            "--quiet",
            "--compress-strings=no",
            "--compress-pos=no",
        ])
        .arg(format!("--callgrind-out-file={}", profile.display()))
        .arg(&program)
        .arg("--call")
        .status();
    let text = std::fs::read_to_string(&profile);
    // The profile is of no further use, whether it could be read or not.
    let _ = std::fs::remove_file(&profile);
    match status {
        Ok(status) if status.success() => {}
        Ok(status) => return Err(format!("valgrind ended with {status}")),
        Err(error) => return Err(format!("valgrind does not run: {error}")),
    }
    let text = text.map_err(|error| format!("valgrind left no profile: {error}"))?;
    let count = |name: &&str| {
        inclusive(&text, name).ok_or_else(|| format!("{name} does not stand in the profile"))
    };
    names.iter().map(count).collect()
}

/// The cost of a function and of all that it calls. In a profile a function is a block that
/// opens with `fn=`; a line in it with two numbers is a position and a cost, the function's own
/// or, after a line `calls=`, that of a call.
fn inclusive(profile: &str, name: &str) -> Option<u64> {
    let symbol = format!("::functions::{name}");
    let mut inside = false;
    let mut found = None;
    for line in profile.lines() {
        if let Some(function) = line.strip_prefix("fn=") {
            // A hash or a mark of the compiler may follow the name.
            inside = function.split_once(&symbol).is_some_and(|(_, rest)| {
                !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')
            });
        } else if inside && line.starts_with(|c: char| c.is_ascii_digit()) {
            let cost = line.split_whitespace().nth(1)?.parse::<u64>().ok()?;
            *found.get_or_insert(0) += cost;
        }
    }
    found
}
