//! How long the 230 space groups take to grow from three roots to full lists of operations, on
//! one core: `cargo bench -p ga-design --bench space_groups`.

use std::hint::black_box;
use std::time::Instant;

use ga_design::crystallography::{GenerationError, PointGroup, SpaceGroup, hall};

/// The budget that the project holds itself to, for the 230 standard settings.
const BUDGET_MILLISECONDS: f64 = 50.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let standard: Vec<&SpaceGroup> = (1..=230).filter_map(SpaceGroup::standard).collect();
    let all: Vec<&SpaceGroup> = SpaceGroup::table().iter().collect();
    // The tables are read once, before anything is measured.
    let operations = grow(&standard)?;
    println!("{} groups, {operations} operations", standard.len());

    let milliseconds = fastest(|| grow(&standard))?;
    let verdict = if milliseconds <= BUDGET_MILLISECONDS {
        "kept"
    } else {
        "EXCEEDED"
    };
    println!(
        "{} groups from roots:       {milliseconds:>8.2} ms; budget of {BUDGET_MILLISECONDS} ms {verdict}",
        standard.len()
    );
    let milliseconds = fastest(|| grow(&all))?;
    println!(
        "{} settings from roots:     {milliseconds:>8.2} ms",
        all.len()
    );
    let milliseconds = fastest(|| {
        let counts = all.iter().map(|group| hall::operations(group.hall));
        counts.map(|found| found.map(|list| list.len())).sum()
    })?;
    println!(
        "{} settings from Hall:      {milliseconds:>8.2} ms",
        all.len()
    );
    let milliseconds = fastest(|| PointGroup::from_geometric("53").map(|group| group.order()))?;
    println!("icosahedral group of 120:    {milliseconds:>8.2} ms");
    Ok(())
}

/// Grows the groups and counts their operations.
fn grow(groups: &[&SpaceGroup]) -> Result<usize, GenerationError> {
    let mut count = 0;
    for group in groups {
        count += black_box(black_box(group).generate_operations()?).len();
    }
    Ok(count)
}

/// The fastest of ten runs, in milliseconds.
fn fastest<E>(mut work: impl FnMut() -> Result<usize, E>) -> Result<f64, E> {
    let mut best = f64::INFINITY;
    for _ in 0..10 {
        let start = Instant::now();
        black_box(work()?);
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    Ok(best)
}
