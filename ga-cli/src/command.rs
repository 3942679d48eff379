//! Decides which commands there are; each is a file of its own with its arguments and what it does.

mod arm;
mod crystal;
mod expand;
mod gallery;
mod group;
mod tensegrity;

use crate::failure::Failure;
use clap::Subcommand;

/// What the program is asked to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    Gallery(gallery::Arguments),
    Group(Box<group::Arguments>),
    Crystal(crystal::Arguments),
    Tensegrity(tensegrity::Arguments),
    Arm(arm::Arguments),
    Expand(expand::Arguments),
}

impl Command {
    /// Does it.
    pub fn run(&self) -> Result<(), Failure> {
        match self {
            Command::Gallery(arguments) => gallery::run(arguments),
            Command::Group(arguments) => group::run(arguments),
            Command::Crystal(arguments) => crystal::run(arguments),
            Command::Tensegrity(arguments) => tensegrity::run(arguments),
            Command::Arm(arguments) => arm::run(arguments),
            Command::Expand(arguments) => expand::run(arguments),
        }
    }
}
