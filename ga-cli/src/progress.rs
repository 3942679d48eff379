//! Decides how the progress of long work is shown: as a bar on a terminal, not at all in a pipe.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A bar for this many steps, on standard error if that is a terminal.
pub fn steps(count: usize) -> ProgressBar {
    let bar = ProgressBar::new(count as u64);
    // The template is a constant; were it refused, the standard bar would do.
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

/// A turning mark beside a message for work of unknown length, on standard error if that is a
/// terminal.
pub fn waiting(message: &'static str) -> ProgressBar {
    let mark = ProgressBar::new_spinner().with_message(message);
    mark.enable_steady_tick(Duration::from_millis(100));
    mark
}
