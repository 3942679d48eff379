//! Decides which chain a file describes.

use std::path::Path;

use super::input::{invalid, read};
use crate::failure::Failure;
use ga_design::linkages::{Chain, Table, Tree};

/// The chain of a URDF file or a Denavit–Hartenberg table, told apart by what they begin with.
pub fn chain(file: &Path, tip: Option<&str>) -> Result<Chain, Failure> {
    let text = read(
        file,
        "give a URDF file or a Denavit–Hartenberg table in JSON",
    )?;
    if text.trim_start().starts_with('<') {
        let tree = Tree::from_urdf(&text).map_err(|reason| invalid(file, &reason))?;
        return tree.chain(tip).map_err(|reason| {
            let option = if tip.is_some() { "--tip: " } else { "" };
            invalid(file, &format!("{option}{reason} (--tip LINK)"))
        });
    }
    if tip.is_some() {
        let problem =
            "--tip chooses among the links of a URDF file; a table has one chain, leave it out";
        return Err(Failure::Usage(problem.to_owned()));
    }
    let (name, table) = Table::from_json(&text).map_err(|reason| invalid(file, &reason))?;
    Ok(table.chain(name))
}
