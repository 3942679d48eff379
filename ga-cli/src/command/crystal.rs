//! `articulate crystal`: a CIF file as the atoms of its cells: as files, as JSON, or as a summary.

mod document;
mod files;
mod summary;
mod symmetry;

use crate::failure::Failure;
use crate::{output, progress};
use clap::builder::{PathBufValueParser, TypedValueParser};
use document::Document;
use files::Destination;
use ga_design::crystallography::{CellRange, CellRangeError, Expansion, cif, scene};
use ga_design::export::write::write_files;
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
    /// A file to save, in the format of its ending: .glb .obj .stl .ply .png .json. Can be given
    /// several times; if one file cannot be made, none is.
    #[arg(long, value_name = "FILE", value_parser = PathBufValueParser::new().try_map(Destination::new))]
    out: Vec<Destination>,
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
  articulate crystal quartz.cif --json | jq '.atoms | length'";

const JSON: &str = "Print JSON:
{name, formula, number, hm,
 cell:{a, b, c, alpha, beta, gamma, alpha_deg, beta_deg, gamma_deg, volume},
 atoms:[{label, element, fract:[3], cart:[3], occupancy}],
 cells:{from:[3], to:[3], atoms}, files:[…]}

`atoms` is one full unit cell, whatever --cells says; `cells` is the block that files hold. Lengths \
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

    let elements = symmetry::elements(file, crystal, arguments.symmetry)?;
    let mut document = Document::new(crystal, &atoms, range, &arguments.out);
    document.symmetry_elements = elements.as_ref().map(symmetry::described);
    if !arguments.out.is_empty() {
        let caption = symmetry::caption(summary::caption(&document), elements.as_ref());
        let scene = scene::scene(
            &name_of(file),
            &crystal.name,
            &caption,
            &crystal.cell,
            range,
            &built,
        );
        let drawing = |reason| Failure::Drawing {
            file: file.clone(),
            reason,
        };
        let mut scene = scene.map_err(drawing)?;
        symmetry::draw(file, &mut scene, elements.as_ref(), &crystal.cell, range)?;
        let mut contents = Vec::new();
        for destination in &arguments.out {
            contents.extend(destination.contents(&scene, &document)?);
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
    if arguments.json {
        output::print_json(&document)
    } else if arguments.out.is_empty() {
        output::print(&summary::text(&document))
    } else {
        output::print(&files::written(&arguments.out, built.len()))
    }
}

/// The name of a file without directory and ending.
fn name_of(file: &Path) -> String {
    file.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
