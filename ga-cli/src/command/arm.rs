//! `articulate arm`: where a robot's tool is for joint values, and joint values for where it should be.

mod document;
mod input;
mod robot;

use std::path::PathBuf;
use std::time::Instant;

use crate::destination::Destination;
use crate::failure::Failure;
use clap::Subcommand;
use document::{Form, PoseRow, SolutionRow};
use ga_design::export::write::write_files;
use ga_design::linkages::{Attitude, Axis, PoseSolver, Target};

/// Moves robot arms: forward and inverse kinematics of a URDF file or a Denavit–Hartenberg table.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// The poses of the tool for joint values.
    Fk(Forward),
    /// Joint values for poses of the tool.
    Ik(Inverse),
}

/// What both tasks take.
#[derive(Debug, clap::Args)]
struct Common {
    /// The robot: a URDF file (.urdf, .xml) or a Denavit–Hartenberg table (.json).
    #[arg(long, value_name = "FILE", long_help = ROBOT)]
    robot: PathBuf,
    /// The link of a URDF file to which the chain goes, if it has several tips.
    #[arg(long, value_name = "LINK")]
    tip: Option<String>,
    #[arg(
        long,
        value_name = "FILE",
        value_parser = Destination::<Form>::parser(),
        help = Destination::<Form>::help()
    )]
    out: Vec<Destination<Form>>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, clap::Args)]
struct Forward {
    #[command(flatten)]
    common: Common,
    /// Joint values, radians or lengths, a row for each pose: JSON, a list of lists, or CSV.
    #[arg(long, value_name = "FILE")]
    input: PathBuf,
}

#[derive(Debug, clap::Args)]
struct Inverse {
    #[command(flatten)]
    common: Common,
    /// Targets, poses or positions: JSON, or CSV with the columns x, y, z, qw, qx, qy, qz.
    #[arg(long, value_name = "FILE", long_help = TARGETS)]
    input: PathBuf,
    /// Joint values to start from, separated by commas; the middle of the ranges without it.
    #[arg(
        long,
        value_name = "Q,…",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    seed: Option<Vec<f64>>,
    /// Let the tool turn freely about this axis of its own: x, y or z.
    #[arg(long, value_name = "AXIS", value_parser = axis)]
    free_about: Option<Axis>,
    /// How many tries there may be for one target.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    tries: u32,
    /// The distance up to which a target is reached.
    #[arg(long, value_name = "LENGTH", default_value_t = 1e-8, value_parser = tolerance)]
    position_tolerance: f64,
    /// The angle in radians up to which a target is reached.
    #[arg(long, value_name = "ANGLE", default_value_t = 1e-8, value_parser = tolerance)]
    rotation_tolerance: f64,
}

const EXAMPLES: &str = "Examples:
  articulate arm fk --robot puma.json --input poses.json --json
  articulate arm ik --robot ur5.urdf --input targets.csv --out joints.csv
  articulate arm ik --robot panda.urdf --tip panda_link8 --input targets.json --free-about z --json";

const ROBOT: &str = "The robot: a URDF file (.urdf, .xml) or a Denavit–Hartenberg table (.json):
{name, convention: \"standard\"|\"modified\",
 rows: [{joint: \"R\"|\"P\", theta, d, a, alpha, offset, flip, qlim: [least, largest]}, …],
 base: 4x4, tool: 4x4}
Angles are in radians; what is left out of a row is 0, limits that are left out are none, and base and \
tool the identity.";

const TARGETS: &str = "Targets, in the frame of the robot's root: JSON
[{position: [x, y, z], quaternion: [w, x, y, z]}, …], or CSV with the columns x, y, z and, unless only \
the position counts, qw, qx, qy, qz. A target of JSON without a quaternion asks for the position only.

Results are, with --json or in a .json file,
[{joints: […], converged, position_error, rotation_error, iterations, tries, micros}, …];
a .csv file has a row for each target. Where a target is not reached, the closest pose found is told.";

/// Does what was asked for.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.task {
        Task::Fk(forward) => forward.run(),
        Task::Ik(inverse) => inverse.run(),
    }
}

impl Forward {
    fn run(&self) -> Result<(), Failure> {
        let chain = robot::chain(&self.common.robot, self.common.tip.as_deref())?;
        let rows = input::joint_values(&self.input, &chain)?;
        let poses = rows.iter().enumerate().map(|(row, values)| {
            let pose = chain.pose(values);
            let pose = pose.map_err(|reason| input::wrong_row(&self.input, row, &reason))?;
            Ok(PoseRow::new(pose))
        });
        let poses: Vec<PoseRow> = poses.collect::<Result<_, Failure>>()?;
        self.common.tell(&poses, &chain, document::poses_table)
    }
}

impl Inverse {
    fn run(&self) -> Result<(), Failure> {
        let chain = robot::chain(&self.common.robot, self.common.tip.as_deref())?;
        let mut targets = input::targets(&self.input)?;
        if let Some(axis) = self.free_about {
            for target in &mut targets {
                if target.attitude == Attitude::Fixed {
                    target.attitude = Attitude::Along(axis);
                }
            }
        }
        let solver = PoseSolver {
            position_tolerance: self.position_tolerance,
            rotation_tolerance: self.rotation_tolerance,
            tries: self.tries as usize,
            ..PoseSolver::default()
        };
        let solve = |target: &Target| {
            let start = Instant::now();
            let solution = solver.solve(&chain, target, self.seed.as_deref());
            let solution =
                solution.map_err(|reason| Failure::Usage(format!("--seed: {reason}")))?;
            Ok(SolutionRow::new(solution, start.elapsed()))
        };
        let solutions: Vec<SolutionRow> =
            targets.iter().map(solve).collect::<Result<_, Failure>>()?;
        self.common
            .tell(&solutions, &chain, document::solutions_table)
    }
}

/// One of the axes, by its name.
fn axis(text: &str) -> Result<Axis, String> {
    match text {
        "x" | "X" => Ok(Axis::X),
        "y" | "Y" => Ok(Axis::Y),
        "z" | "Z" => Ok(Axis::Z),
        _ => Err("write x, y or z".to_owned()),
    }
}

/// A number above 0.
fn tolerance(text: &str) -> Result<f64, String> {
    let number = text
        .parse()
        .ok()
        .filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "write a number above 0, such as 1e-5".to_owned())
}
