//! Decides what is told of all groups of a kind.

use super::document::{Periodic, Point};
use super::request::Kind;
use super::{cell, point, space, subperiodic, summary};
use crate::failure::Failure;
use crate::output;
use ga_design::crystallography::{CrystalClass, SpaceGroup, SubperiodicGroup, SubperiodicKind};

/// Prints the list.
pub fn run(kind: Kind, json: bool) -> Result<(), Failure> {
    match kind {
        Kind::Space => print(&spaces()?, json, summary::list),
        Kind::Subperiodic(kind) => print(&subperiodics(kind)?, json, summary::list),
        Kind::Point => print(&points(), json, summary::point_list),
    }
}

fn print<T: serde::Serialize>(
    all: &[T],
    json: bool,
    listed: impl Fn(&[T]) -> String,
) -> Result<(), Failure> {
    if json {
        output::print_json(&all)
    } else {
        output::print(&listed(all))
    }
}

/// The 230, each in its standard setting.
fn spaces() -> Result<Vec<Periodic>, Failure> {
    let groups = (1..=230).filter_map(SpaceGroup::standard);
    groups
        .map(|group| {
            let cell = cell::of_shape(group.cell_shape(), None)?;
            let generation = group.generate(&cell);
            let generation = generation.map_err(|reason| Failure::Usage(reason.to_string()))?;
            space::periodic(group, &generation, &generation.operations())
        })
        .collect()
}

fn subperiodics(kind: SubperiodicKind) -> Result<Vec<Periodic>, Failure> {
    let groups = (1..=kind.count()).filter_map(|number| SubperiodicGroup::standard(kind, number));
    groups
        .map(|group| {
            let cell = cell::of_lattice(group, None)?;
            let grown = subperiodic::Grown::new(group, &cell)?;
            Ok(subperiodic::periodic_document(group, &grown))
        })
        .collect()
}

/// The point groups of crystals.
fn points() -> Vec<Point> {
    let classes = CrystalClass::table().iter();
    classes
        .map(|class| {
            let mut told = point::describe(&class.group());
            told.versors.clear();
            told
        })
        .collect()
}
