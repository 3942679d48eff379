//! Decides what is said about a structure, to other programs and to people.

use crate::output;
use ga_design::tensegrity::{Analysis, Member, Role, Structure};
use serde::Serialize;
use std::path::PathBuf;

/// A structure, as JSON tells it; fields may be added, never renamed.
#[derive(Debug, Serialize)]
pub struct Document {
    /// What it is called.
    pub shape: String,
    /// The coordinates of the nodes.
    pub nodes: Vec<[f64; 3]>,
    /// The nodes that struts join, as positions in `nodes`.
    pub struts: Vec<[usize; 2]>,
    /// The nodes that cables join.
    pub cables: Vec<[usize; 2]>,
    /// The force densities of struts and cables, in this order.
    pub self_stress: Vec<f64>,
    /// The number of independent states of self-stress.
    pub states: usize,
    /// The number of independent infinitesimal mechanisms.
    pub mechanisms: usize,
    /// How firmly it stands.
    pub stability: &'static str,
    /// Whether every strut is pressed and every cable pulled.
    pub proper: bool,
    /// The lengths.
    pub lengths: Members<f64>,
    /// Which generating member each is an image of.
    pub classes: Members<usize>,
    /// The eigenvalues of the stress matrix.
    pub eigenvalues: Vec<f64>,
    /// How many of these are zero.
    pub nullity: usize,
    /// The largest sum of forces at a node over the largest force.
    pub residual: f64,
    /// The files that were saved.
    pub files: Vec<PathBuf>,
}

/// A number for each strut and each cable.
#[derive(Debug, Serialize)]
pub struct Members<T> {
    /// Those of the struts.
    pub struts: Vec<T>,
    /// Those of the cables.
    pub cables: Vec<T>,
}

impl<T> Members<T> {
    fn of(structure: &Structure, number: impl Fn(&Member) -> T) -> Self {
        Self {
            struts: structure.struts().map(&number).collect(),
            cables: structure.cables().map(&number).collect(),
        }
    }
}

impl Document {
    /// What is to be said about a structure.
    pub fn new(
        shape: &str,
        structure: &Structure,
        analysis: &Analysis,
        files: Vec<PathBuf>,
    ) -> Self {
        let ends = Members::of(structure, |member| member.ends);
        let nodes = structure.nodes().iter();
        Self {
            shape: shape.to_owned(),
            nodes: nodes.map(|node| node.position().to_array()).collect(),
            struts: ends.struts,
            cables: ends.cables,
            self_stress: analysis.force_densities.clone(),
            states: analysis.states,
            mechanisms: analysis.mechanisms,
            stability: analysis.stability.name(),
            proper: analysis.is_proper,
            lengths: Members::of(structure, |member| structure.length(member)),
            classes: Members::of(structure, |member| member.class),
            eigenvalues: analysis.eigenvalues.clone(),
            nullity: analysis.nullity,
            residual: analysis.residual(structure),
            files,
        }
    }

    /// One sentence, to stand under a picture.
    pub fn caption(&self) -> String {
        format!(
            "{} struts and {} cables on {} nodes; states of self-stress: {}, mechanisms: {}; {}.",
            self.struts.len(),
            self.cables.len(),
            self.nodes.len(),
            self.states,
            self.mechanisms,
            self.stability,
        )
    }

    /// The numbers for people, and a line for each class of members.
    pub fn summary(&self) -> String {
        let rows = [
            ("tensegrity", self.shape.clone()),
            ("nodes", self.nodes.len().to_string()),
            ("struts", self.struts.len().to_string()),
            ("cables", self.cables.len().to_string()),
            ("states of self-stress", self.states.to_string()),
            ("mechanisms", self.mechanisms.to_string()),
            ("stability", self.stability.to_owned()),
        ];
        let mut text: String = rows
            .iter()
            .map(|(name, value)| format!("{name:<23}{value}\n"))
            .collect();
        text.push('\n');
        text.push_str(&output::table(&self.classes_table()));
        text
    }

    /// A row for each class: its members, their length and force density.
    fn classes_table(&self) -> Vec<Vec<String>> {
        let headings = ["class", "members", "length", "force density"];
        let mut rows = vec![headings.map(str::to_owned).to_vec()];
        let kinds = [
            (Role::Strut, &self.classes.struts, &self.lengths.struts, 0),
            (
                Role::Cable,
                &self.classes.cables,
                &self.lengths.cables,
                self.struts.len(),
            ),
        ];
        for (role, classes, lengths, offset) in kinds {
            let word = match role {
                Role::Strut => "struts",
                Role::Cable => "cables",
            };
            let mut seen: Vec<usize> = classes.clone();
            seen.sort_unstable();
            seen.dedup();
            for (number, class) in seen.iter().enumerate() {
                let first = classes.iter().position(|other| other == class).unwrap_or(0);
                let count = classes.iter().filter(|other| *other == class).count();
                let length = lengths.get(first).copied().unwrap_or(0.0);
                let density = self.self_stress.get(offset + first);
                rows.push(vec![
                    format!("{word} {}", number + 1),
                    count.to_string(),
                    format!("{length:.7}"),
                    density.map_or_else(|| "-".to_owned(), |density| format!("{density:.7}")),
                ]);
            }
        }
        rows
    }
}
