//! `articulate group`: a symmetry group by its number or symbol: what International Tables say of it, its
//! versors, and what it makes of a motif.

mod all;
mod cell;
mod document;
mod domain;
mod files;
mod motif;
mod point;
mod request;
mod scene;
mod site;
mod space;
mod subperiodic;
mod summary;
mod versor;

use crate::destination::{self, Destination};
use crate::failure::Failure;
use crate::{output, progress};
use files::Form;
use request::{Kind, Notation};
use std::path::PathBuf;

/// Tells all about a symmetry group, and carries a motif through it into pictures and models.
///
/// Every group is generated from three root vectors: its operations are versors of the conformal
/// algebra. Prints a summary in the terms of International Tables if no result is asked for.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(group = clap::ArgGroup::new("kind").multiple(false))]
pub struct Arguments {
    /// The group: its number in International Tables (227), or its symbol: Hermann–Mauguin, short, full or
    /// extended, with :1 :2 :H :R for origin or axes ("F d -3 m:2", 14:c1), Schoenflies (Oh^7), Hall
    /// ("-F 4vw 2vw 3") or geometric ("F_d 4 3").
    #[arg(
        value_name = "GROUP",
        required_unless_present = "all",
        allow_hyphen_values = true
    )]
    group: Option<String>,
    /// One of the 17 plane groups.
    #[arg(long, group = "kind", visible_alias = "plane")]
    wallpaper: bool,
    /// One of the 7 frieze groups.
    #[arg(long, group = "kind")]
    frieze: bool,
    /// One of the 80 layer groups.
    #[arg(long, group = "kind")]
    layer: bool,
    /// One of the 75 rod groups.
    #[arg(long, group = "kind")]
    rod: bool,
    /// A point group: International (4/mmm), Schoenflies (D4h, C5v, I), or geometric for any p and q
    /// (42, "b(5)b(3)").
    #[arg(long, group = "kind")]
    point: bool,
    /// All groups of the kind: 230 space groups, or 17, 7, 80, 75, or the 32 point groups of crystals.
    #[arg(long, conflicts_with_all = ["group", "cell", "cells", "at", "motif", "size", "out", "symmetry", "domain", "notation", "snap"])]
    all: bool,
    /// Read the symbol in this notation alone, where it means something in several.
    #[arg(long, value_enum)]
    notation: Option<Notation>,
    /// The cell, in ångström and degrees: a,b,c,alpha,beta,gamma, or the free parameters alone, such as
    /// `5` for a cube, `4.9,5.4` for a and c of a hexagonal cell.
    #[arg(long, value_name = "A,B,…", allow_hyphen_values = true)]
    cell: Option<String>,
    /// The cells to build: along all edges (2), along a, b and c (2x2x1), or from corner to corner
    /// (-1:1x-1:1x0:1); for groups that repeat along fewer edges, along those.
    #[arg(long, value_name = "CELLS", allow_hyphen_values = true)]
    cells: Option<String>,
    /// A point, in fractions of the edges: tells its Wyckoff position, its site symmetry and its orbit, and
    /// puts the motif there.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    at: Option<String>,
    /// How far from a special position a point still counts as on it, in ångström.
    #[arg(
        long,
        value_name = "LENGTH",
        requires = "at",
        allow_hyphen_values = true
    )]
    snap: Option<f64>,
    /// What is repeated: comma, hand, strut or helix; or a surface from an .obj or .stl file, or atoms from
    /// an .xyz file. Put in general position, as large as its copies leave room for.
    #[arg(long, value_name = "NAME|FILE", requires = "out")]
    motif: Option<String>,
    /// The radius of the motif, in ångström.
    #[arg(
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        requires = "out"
    )]
    size: Option<f64>,
    /// Draw the symmetry elements into the files, and list those of one cell in JSON (space groups only).
    #[arg(long)]
    symmetry: bool,
    /// Draw the fundamental domain around the motif into the files, in glass, and tell of it in JSON: the
    /// part of space that the group repeats to fill all of it (space groups only).
    #[arg(long)]
    domain: bool,
    #[arg(long, value_name = "FILE", value_parser = Destination::<Form>::parser(), help = Destination::<Form>::help())]
    out: Vec<Destination<Form>>,
    /// Print JSON: the contract is told by --help.
    #[arg(long, long_help = JSON)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  articulate group 227
  articulate group \"P 21/c\" --cell 5,6,7,100 --json
  articulate group 19 --motif hand --out hands.png --out hands.glb
  articulate group 19 --domain --symmetry --out domain.png
  articulate group \"-C 4 2\"
  articulate group 225 --at 0.25,0.25,0.25 --cell 5.64
  articulate group p4g --wallpaper --out p4g.svg
  articulate group p_6_3mc --rod --motif helix --cells 3 --out rod.glb
  articulate group --point 53 --out icosahedral.png
  articulate group --all --json | jq '.[].hm'";

const JSON: &str = "Print JSON:
{kind, number, hm, symbols:{short, full, extended, qualified}, hall, \
schoenflies, point_group, geometric, system, laue_class, order, lattice:{bravais, pearson, centring}, \
setting:{choice, standard, from_standard, others}, notation, also:[{notation, number, hm}],
 centring:[[3]], operations:[\"x,y,z\"], generators:[\"T_c^{1/2} ab\"],
 roots:{p, q, directions:[3], vectors:[3]},
 cell:{a, b, c, alpha, beta, gamma, alpha_deg, beta_deg, gamma_deg, volume},
 generator_versors:[versor], versors:[versor],
 wyckoff:[{letter|null, multiplicity, site_symmetry, coordinates}],
 site:{letter, multiplicity, site_symmetry, place:[3], distance, orbit:[[3]]},
 symmetry_elements,
 domain:{seed:[3], volume, vertices:[{fract:[3], cart:[3]}],
   faces:[{normal:[3], distance, vertices:[…], operation, cell:[3]}]},
 motif:{name, place:[3], size, copies, cells}, files}

`operations` are all modulo the edges of the cell, those of centrings included, `versors` the same in the \
same order, in the cell given: {operation, mirror:{e1, e2, e3, ni}|null, motor:{1, e12, …}}: the reflection \
in the dual plane `mirror` comes first, then the motor. `generators` are words in the roots a, b, c after \
translations, in the standard setting, from which `from_standard` leads here. Lengths are in ångström, alpha, \
beta and gamma in radians and again in degrees. `site` is there with --at, `symmetry_elements` with --symmetry \
(as of `articulate crystal`), `domain` with --domain: what is nearer to `seed` than to any of its images; \
each face is in the plane normal · x = distance (outward, in ångström), its corners are places in `vertices` \
from 0, and beyond it is the neighbour made by `operation` and then moved by `cell` edges. `motif` and `files` with --out.

Plane, frieze, layer and rod groups have the same fields where they make sense, and space_group:{number, hm}, \
whose generators are theirs too. Point groups have {kind, hm, schoenflies, geometric, overlined, p, q, number, \
system, laue_class, order, chiral, centrosymmetric, roots, generators, classes:[{size, order, kind, members}], \
versors:[{order, kind, mirror, motor}]}; what is no point group of crystals has null for hm, number, system. \
With --all a list, without cell, versors and Wyckoff positions.";

/// Finds the group, and prints or saves what was asked for.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let kind = arguments.kind();
    let Some(text) = &arguments.group else {
        return all::run(kind, arguments.json);
    };
    // A word that begins so is no symbol in any notation.
    if text.starts_with("--") {
        let text = request::short(text);
        return Err(Failure::Usage(format!(
            "unexpected argument `{text}`; --help lists those that there are"
        )));
    }
    arguments.check_lengths()?;
    let mark = progress::waiting("generating the group");
    let made = match kind {
        Kind::Space => space::make(arguments, text)?,
        Kind::Subperiodic(kind) => subperiodic::make(arguments, kind, text)?,
        Kind::Point => point::make(arguments, text)?,
    };
    let contents = files::contents(arguments, &made)?;
    // All or none: nothing is written before everything is made.
    ga_design::export::write::write_files(&contents)?;
    mark.finish_and_clear();
    for remark in &made.remarks {
        output::remark(&format!("note: {remark}"));
    }
    if arguments.json {
        output::print_json(&made.document)
    } else if arguments.out.is_empty() {
        output::print(&made.summary)
    } else {
        output::print(&files::written(arguments, &made))
    }
}

/// A group and what was asked for, ready to be printed and saved.
struct Made {
    /// As JSON.
    document: document::Document,
    /// For people.
    summary: String,
    /// What should be said beside the results.
    remarks: Vec<String>,
    /// The pattern, if files are asked for.
    drawing: Option<scene::Drawing>,
}

impl Arguments {
    fn kind(&self) -> Kind {
        use ga_design::crystallography::SubperiodicKind::{Frieze, Layer, Plane, Rod};
        let flags = [
            (self.wallpaper, Plane),
            (self.frieze, Frieze),
            (self.layer, Layer),
            (self.rod, Rod),
        ];
        let chosen = flags.into_iter().find(|(given, _)| *given);
        match chosen {
            Some((_, kind)) => Kind::Subperiodic(kind),
            None if self.point => Kind::Point,
            None => Kind::Space,
        }
    }

    /// The paths of the files to be saved.
    fn paths(&self) -> Vec<PathBuf> {
        destination::paths(&self.out)
    }
}
