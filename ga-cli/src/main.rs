//! The program `articulate`: reads the command line, runs one command, and turns its failure into a
//! message and an exit code.

mod angle;
mod command;
mod destination;
mod failure;
mod output;
mod progress;
mod unit_cell;

use clap::Parser;
use command::Command;
use std::process::ExitCode;

/// Makes structures with geometric algebra: symmetry groups, crystals and figures as files for viewers, modellers and
/// printers, and the algebras themselves as Rust.
///
/// Exits with 0 when all went well, 1 when a file or an algebra is wrong, 2 when the command line is.
#[derive(Debug, Parser)]
#[command(
    name = "articulate",
    version,
    arg_required_else_help = true,
    after_long_help = EXAMPLES,
    after_help = EXAMPLES
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "Examples:
  articulate gallery                             make the gallery; open gallery/index.html
  articulate group 227                           tell all about a symmetry group
  articulate group 19 --motif hand --out hands.png --out hands.glb
                                                 carry a motif through it
  articulate crystal quartz.cif --out quartz.glb --cells 2x2x2
                                                 save a block of a crystal for a viewer
  articulate crystal quartz.cif --json           print the atoms of its unit cell
  articulate tensegrity tower --out tower.glb    save a tower of struts and cables
  articulate expand R4_1 --ledger                print what each product of an algebra costs

`articulate COMMAND --help` explains a command.";

fn main() -> ExitCode {
    // Bad usage ends here, with a message and exit code 2.
    let arguments = Arguments::parse();
    match arguments.command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
