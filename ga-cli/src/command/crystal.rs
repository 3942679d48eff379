//! `articulate crystal`: a CIF file as the atoms of its cells: as files, as JSON, or as a summary.

mod document;
mod files;
mod summary;
pub mod symmetry;

use crate::destination::{self, Destination};
use crate::failure::Failure;
use crate::{output, progress};
use document::Document;
use files::Form;
use ga_design::crystallography::{
    Atom, Bonding, CellRange, CellRangeError, Crystal, Expansion, cif, scene,
};
use ga_design::export::write::write_files;
use ga_design::export::{ExportError, Scene};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Builds the cells of a crystal from a CIF file; prints a summary if no result is asked for.
///
/// The symmetry operations become versors of the conformal algebra, which are applied to the sites;
/// coincident copies are merged.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The CIF file; of several crystals in it the first is read.
    #[arg(value_name = "FILE.cif")]
    file: PathBuf,
    /// The cells to build: numbers of cells along a, b and c, or ranges from corner to corner such as
    /// -1:1x-1:1x0:1.
    #[arg(
        long,
        value_name = "CELLS",
        default_value = "1x1x1",
        allow_hyphen_values = true
    )]
    cells: Cells,
    #[arg(long, value_name = "FILE", value_parser = Destination::<Form>::parser(), help = Destination::<Form>::help())]
    out: Vec<Destination<Form>>,
    /// Find the bonds, and show them as rods. By default they are found where the block has at most
    /// 20000 atoms: those as close as the sum of their covalent radii, a fifth more at most.
    #[arg(long, overrides_with = "no_bonds")]
    bonds: bool,
    /// Leave the bonds out.
    #[arg(long, overrides_with = "bonds")]
    no_bonds: bool,
    /// Draw the symmetry elements of the cells into the files, and list those of one cell in JSON: axes,
    /// screws, mirror and glide planes, inversion centres, with the symbols of International Tables.
    #[arg(long)]
    symmetry: bool,
    /// Print JSON: the contract is told by --help.
    #[arg(long, long_help = JSON)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  articulate crystal quartz.cif
  articulate crystal quartz.cif --cells 2x2x2 --out quartz.glb --out quartz.png
  articulate crystal quartz.cif --symmetry --out quartz.png
  articulate crystal quartz.cif --cells 3 --no-bonds --out quartz.xyz --out block.cif
  articulate crystal quartz.cif --json | jq '.atoms | length'

Colours are those of the program Jmol, radii the covalent radii of Cordero and others (2008). Of a \
block of more than 20000 atoms a .glb file holds instances (EXT_mesh_gpu_instancing), one set for each \
element, instead of a node for each atom; .stl .obj .ply .png hold up to ten million triangles, which \
is some 120000 atoms. A .cif file holds the asymmetric unit with its symmetry if one cell is built, and \
a large cell without symmetry (P 1) if several are.";

const JSON: &str = "Print JSON:
{name, formula, number, hm,
 cell:{a, b, c, alpha, beta, gamma, alpha_deg, beta_deg, gamma_deg, volume}, density,
 atoms:[{label, element, fract:[3], cart:[3], occupancy, coordination}],
 bonds:[{atoms:[2], image:[3], length}],
 cells:{from:[3], to:[3], atoms}, files:[…]}

`atoms` is one full unit cell, whatever --cells says; `cells` is the block that files hold. A bond \
joins two of the atoms, counted from 0, the second in the cell `image` edges away; each stands once, \
and `coordination` counts both its ends. Where bonds are not found both are null. Lengths \
and `cart` are in ångström, alpha, beta and gamma in radians and again in degrees. a lies along x, b \
in the plane of x and y. What the file does not say is null. A .json file holds the same.

With --symmetry also, for the elements of one cell modulo whole edges:
 symmetry_elements:[{kind, symbol, direction:[3], point:[3], glide|screw:[3], inversion_points:[[3]]}]

`kind` is rotation, screw, rotoinversion, mirror, glide or inversion. `symbol` is that of International Tables: 2, 3_1, -4, 2_1/m (inversion centres on the axis), m, a, b, c, n, d, e, g, -1. `direction` is [uvw] of an axis, (hkl) of a plane, null for a centre. `point` is on the element, `screw` and `glide` are the translations along it (of a screw by one n-th of a turn, anticlockwise against its direction), all in fractions of the edges.";

/// The cells asked for. A block too far away is no mistake of spelling: it is kept, to be reported
/// together with the file.
#[derive(Debug, Clone)]
struct Cells(Result<CellRange, CellRangeError>);

impl FromStr for Cells {
    type Err = CellRangeError;

    fn from_str(text: &str) -> Result<Self, CellRangeError> {
        match text.parse() {
            Err(mistake @ (CellRangeError::Form { .. } | CellRangeError::Empty { .. })) => {
                Err(mistake)
            }
            range => Ok(Self(range)),
        }
    }
}

/// Reads the crystal, builds its cells, and saves or prints what was asked for.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = &arguments.file;
    let unbuildable = |reason| Failure::Expansion {
        file: file.clone(),
        reason,
    };
    let range = arguments.cells.0.clone();
    let range = range.map_err(|reason| Failure::Cells {
        file: file.clone(),
        reason,
    })?;
    let mark = progress::waiting("building the crystal");
    let reading = cif::read_file(file)?;
    let crystal = &reading.crystal;
    let expansion = Expansion::default();
    let atoms = expansion.unit_cell(crystal).map_err(unbuildable)?;
    let built = expansion
        .cells(crystal, &atoms, range)
        .map_err(unbuildable)?;

    let mut bonding = arguments.bonding(built.len());
    let unbonded = |reason| Failure::Bonds {
        file: file.clone(),
        reason,
    };
    let found = bonding.map(|bonding| bonding.periodic(&crystal.cell, &atoms));
    let (bonds, without_bonds) = match found.transpose() {
        Ok(bonds) => (bonds, None),
        Err(reason) if arguments.bonds => return Err(unbonded(reason)),
        // Nobody asked for them: the crystal is given without.
        Err(reason) => {
            bonding = None;
            (None, Some(reason))
        }
    };
    let block = Block {
        crystal,
        range,
        atoms: &built,
    };
    let elements = symmetry::elements(file, crystal, arguments.symmetry)?;
    let mut document = Document::new(
        crystal,
        &atoms,
        bonds.as_deref(),
        range,
        destination::paths(&arguments.out),
    );
    document.symmetry_elements = elements.as_ref().map(symmetry::described);
    if !arguments.out.is_empty() {
        let scene = if arguments.out.iter().any(Destination::is_drawn) {
            let caption = symmetry::caption(summary::caption(&document), elements.as_ref());
            let mut scene = block.scene(file, &caption)?;
            if let Some(bonding) = bonding {
                let shown = bonding.between(&built).map_err(unbonded)?;
                let added = scene::add_bonds(&mut scene, &built, &shown);
                added.map_err(|reason| drawing(file, reason))?;
            }
            symmetry::draw(file, &mut scene, elements.as_ref(), &crystal.cell, range)?;
            Some(scene)
        } else {
            None
        };
        let mut contents = Vec::new();
        for destination in &arguments.out {
            contents.extend(destination.contents(scene.as_ref(), &block, &document)?);
        }
        // All or none: nothing is written before everything is made.
        write_files(&contents)?;
    }
    mark.finish_and_clear();

    for warning in &reading.warnings {
        output::remark(&format!(
            "warning: {}:{}: {}",
            file.display(),
            warning.line,
            warning.message
        ));
    }
    if let Some(reason) = without_bonds {
        output::remark(&format!("warning: {}: {reason}", file.display()));
    }
    if arguments.json {
        output::print_json(&document)
    } else if arguments.out.is_empty() {
        output::print(&summary::text(&document))
    } else {
        output::print(&files::written(&arguments.out, built.len()))
    }
}

impl Arguments {
    /// How bonds are found, if they are in a block of so many atoms.
    fn bonding(&self, atoms: usize) -> Option<Bonding> {
        let wanted = self.bonds || (!self.no_bonds && atoms <= scene::MOST_NODES);
        wanted.then(Bonding::default)
    }
}

/// The cells that were built.
struct Block<'a> {
    crystal: &'a Crystal,
    range: CellRange,
    atoms: &'a [Atom],
}

impl Block<'_> {
    /// The picture of the atoms and cells, without bonds.
    fn scene(&self, file: &Path, caption: &str) -> Result<Scene, Failure> {
        let Crystal { name, cell, .. } = self.crystal;
        scene::scene(&name_of(file), name, caption, cell, self.range, self.atoms)
            .map_err(|reason| drawing(file, reason))
    }
}

fn drawing(file: &Path, reason: ExportError) -> Failure {
    Failure::Drawing {
        file: file.to_owned(),
        reason,
    }
}

/// The name of a file without directory and ending.
fn name_of(file: &Path) -> String {
    file.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
