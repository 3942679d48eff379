//! One row for each operation and scalar: our time, the best of the others, their ratio.

use std::fmt;

use ga_benches::race::{Contestant, agree, race};

use crate::remarks::remark;

/// What a row must reach.
#[derive(Clone, Copy)]
pub enum Goal {
    /// No slower than the fastest other, within the noise.
    Fastest,
    /// That, and so many times as fast as the library `geometric_algebra`.
    Times(f64),
    /// At most so many times a rigid motion of a point by nalgebra in the same run.
    OfIsometry(f64),
    /// Nothing: the row is there to be read.
    Shown,
}

/// What one contest is about.
pub struct Contest {
    /// The operation, without spaces.
    pub operation: &'static str,
    /// The type of the numbers.
    pub scalar: &'static str,
    /// Whether results are compared up to a factor.
    pub homogeneous: bool,
    /// What must be reached.
    pub goal: Goal,
    /// What the goal is a multiple of, if it is not among the contestants.
    pub yardstick: Option<Contestant>,
    /// This library first; where it has other ways too, they are named [`BY_SLICES`] or [`IN_BATCHES`]
    /// and get a row of their own against the same others.
    pub contestants: Vec<Contestant>,
}

impl Contest {
    /// A contest of results that are compared as they are, without a yardstick.
    pub fn new(
        operation: &'static str,
        scalar: &'static str,
        goal: Goal,
        contestants: Vec<Contestant>,
    ) -> Self {
        Contest {
            operation,
            scalar,
            homogeneous: false,
            goal,
            yardstick: None,
            contestants,
        }
    }

    /// One whose results are compared up to a factor.
    pub fn homogeneous(self) -> Self {
        Contest {
            homogeneous: true,
            ..self
        }
    }
}

/// This library by a loop, or whatever a user would write first.
pub const OURS: &str = "ours";
/// This library by the functions on slices of `ga_lanes`.
pub const BY_SLICES: &str = "ours-by-slices";
/// This library by the batches of `ga_lanes`, coefficient by coefficient.
pub const IN_BATCHES: &str = "ours-in-batches";

struct Row {
    operation: &'static str,
    /// Which way of this library.
    way: &'static str,
    scalar: &'static str,
    goal: Goal,
    times: Vec<(&'static str, f64)>,
    yardstick: Option<f64>,
}

/// The rows, in the order of the contests.
pub struct Table {
    rows: Vec<Row>,
    /// What the names of the operations must contain.
    only: String,
    /// What the contestants did not agree on.
    pub disagreements: Vec<String>,
}

/// The noise that a ratio may have.
const NOISE: f64 = 1.05;

impl Table {
    /// A table of the operations whose names contain this.
    pub fn of(only: String) -> Self {
        Table {
            rows: Vec::new(),
            only,
            disagreements: Vec::new(),
        }
    }

    /// Compares the results of a contest, then times it.
    pub fn add(&mut self, mut contest: Contest) {
        if !contest.operation.contains(&self.only) {
            return;
        }
        let Contest {
            operation,
            scalar,
            goal,
            ..
        } = contest;
        let tolerance = if scalar == "f32" { 1e-4 } else { 1e-11 };
        if let Err(difference) = agree(&contest.contestants, tolerance, contest.homogeneous) {
            self.disagreements
                .push(format!("{operation} {scalar}: {difference}"));
        }
        let names: Vec<_> = contest.contestants.iter().map(|each| each.name).collect();
        contest.contestants.extend(contest.yardstick);
        let nanoseconds = race(&mut contest.contestants);
        let yardstick = nanoseconds.get(names.len()).copied();
        let times: Vec<_> = names.into_iter().zip(nanoseconds).collect();
        let ways = times.iter().map(|(name, _)| *name);
        self.rows
            .extend(ways.filter(|name| is_ours(name)).map(|way| Row {
                operation,
                way,
                scalar,
                goal,
                times: times.clone(),
                yardstick,
            }));
    }
}

/// Whether a contestant is this library.
fn is_ours(name: &str) -> bool {
    [OURS, BY_SLICES, IN_BATCHES].contains(&name)
}

impl Row {
    /// The operation, and how it was called.
    fn name(&self) -> String {
        match self.way.strip_prefix("ours-") {
            None => self.operation.to_owned(),
            Some(way) => format!("{}-{way}", self.operation),
        }
    }

    /// The other libraries.
    fn others(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let times = self.times.iter().copied();
        times.filter(|(name, _)| !is_ours(name))
    }

    fn time(&self, name: &str) -> Option<f64> {
        self.times
            .iter()
            .find(|(other, _)| *other == name)
            .map(|(_, time)| *time)
    }

    fn ours(&self) -> f64 {
        self.time(self.way).unwrap_or(f64::NAN)
    }

    fn best(&self) -> Option<(&'static str, f64)> {
        self.others().min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Ours over the best other; 0 where there is none.
    fn ratio(&self) -> f64 {
        self.best().map_or(0.0, |(_, best)| self.ours() / best)
    }

    /// How many times the yardstick ours takes.
    fn multiple(&self) -> Option<f64> {
        self.yardstick.map(|time| self.ours() / time)
    }

    /// How many times as fast as `geometric_algebra` ours is.
    fn gain(&self) -> Option<f64> {
        Some(self.time("geometric_algebra")? / self.ours())
    }

    /// Whether the goal is reached.
    fn is_reached(&self) -> bool {
        let fastest = self.ratio() <= NOISE;
        match self.goal {
            Goal::Shown => true,
            Goal::Fastest => fastest,
            Goal::Times(times) => fastest && self.gain().is_none_or(|gain| gain >= times),
            Goal::OfIsometry(times) => self.multiple().is_none_or(|multiple| multiple <= times),
        }
    }

    /// What was asked, and what it is.
    fn verdict(&self) -> String {
        let verdict = if self.is_reached() {
            "reached"
        } else {
            "MISSED"
        };
        let gain = self.gain().unwrap_or(f64::NAN);
        let multiple = self.multiple().unwrap_or(f64::NAN);
        match self.goal {
            Goal::Shown if self.yardstick.is_none() => String::new(),
            Goal::Shown => format!("{multiple:.2} isometries on a point"),
            Goal::Fastest => format!("asked: fastest, {verdict}"),
            Goal::Times(_) if gain.is_nan() => format!("asked: fastest, {verdict}"),
            Goal::Times(times) => {
                format!("asked: {times} times geometric_algebra, is {gain:.1}, {verdict}")
            }
            Goal::OfIsometry(times) => {
                format!("asked: {times} isometries on a point, is {multiple:.2}, {verdict}")
            }
        }
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "{:<34} {:<6} {:>7}  {:<22} {:>7} {:>6}  all and goal",
            "operation", "scalar", "ours_ns", "best_name", "best_ns", "ratio"
        )?;
        for row in &self.rows {
            let ours = row.ours();
            write!(f, "{:<34} {:<6} {ours:>7.2}  ", row.name(), row.scalar)?;
            match row.best() {
                Some((name, best)) => write!(f, "{name:<22} {best:>7.2} {:>6.2}  ", row.ratio())?,
                None => write!(f, "{:<22} {:>7} {:>6}  ", "-", "-", "-")?,
            }
            for (name, time) in row.others() {
                write!(f, "{name} {time:.2}, ")?;
            }
            writeln!(f, "{}", row.verdict())?;
        }
        // They are about loops over structs.
        let loops = self.rows.iter().filter(|row| row.way == OURS);
        let missed = loops.filter(|row| !row.is_reached());
        let mut operations: Vec<_> = missed.map(|row| row.operation).collect();
        operations.sort_unstable();
        operations.dedup();
        for operation in operations {
            if let Some(remark) = remark(operation) {
                writeln!(f, "{operation}: {remark}")?;
            }
        }
        for disagreement in &self.disagreements {
            writeln!(f, "results differ: {disagreement}")?;
        }
        Ok(())
    }
}
