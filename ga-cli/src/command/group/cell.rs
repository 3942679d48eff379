//! Decides which cell a group is shown in: the one of `--cell`, checked against the constraints of its
//! system, or one of a handy size; and which cells of the lattice are built.

use super::request::short;
use crate::failure::Failure;
use ga_design::crystallography::lattice::Axis;
use ga_design::crystallography::{
    Cell, CellParameters, CellRange, CellShape, CrystalSystem, Recognition, SpaceGroup,
    SubperiodicGroup, SubperiodicKind, SubperiodicLattice,
};

/// The size of the cell that is taken when none is given: edges of 10 to 15 ångström.
const HANDY: f64 = 10.0;

/// The cell of these parameters, or one of the shape.
pub fn of_shape(shape: CellShape, text: Option<&str>) -> Result<Cell, Failure> {
    let Some(text) = text else {
        return handy(shape);
    };
    let numbers = numbers("--cell", text)?;
    let given = |parameters: CellParameters| parameters.cell().map_err(wrong_cell);
    let cell = match (shape, numbers.as_slice()) {
        (_, &[a, b, c, alpha, beta, gamma]) => {
            Cell::new([a, b, c], [alpha, beta, gamma]).map_err(wrong_cell)?
        }
        (CellShape::Monoclinic(unique), &[a, b, c, angle]) => given(CellParameters::Monoclinic {
            edges: [a, b, c],
            unique,
            angle,
        })?,
        (CellShape::Orthorhombic, &[a, b, c]) => {
            given(CellParameters::Orthorhombic { edges: [a, b, c] })?
        }
        // Three edges, of which some must be equal, as the check below tells.
        (CellShape::Tetragonal | CellShape::Cubic, &[a, b, c]) => {
            Cell::new([a, b, c], [90.0; 3]).map_err(wrong_cell)?
        }
        (CellShape::Hexagonal, &[a, b, c]) => {
            Cell::new([a, b, c], [90.0, 90.0, 120.0]).map_err(wrong_cell)?
        }
        (CellShape::Tetragonal, &[a, c]) => given(CellParameters::Tetragonal { a, c })?,
        (CellShape::Hexagonal, &[a, c]) => given(CellParameters::Hexagonal { a, c })?,
        (CellShape::Rhombohedral, &[a, alpha]) => given(CellParameters::Rhombohedral { a, alpha })?,
        (CellShape::Cubic, &[a]) => given(CellParameters::Cubic { a })?,
        _ => {
            let six = match shape {
                CellShape::Triclinic => "",
                _ => ", or all six a,b,c,alpha,beta,gamma",
            };
            return Err(Failure::Usage(format!(
                "--cell {}: a cell that is {shape} has the parameters {}{six}; here are {}",
                short(text),
                names(shape),
                numbers.len()
            )));
        }
    };
    shape.check(&cell).map_err(wrong_cell)?;
    shape.idealized(&cell).map_err(wrong_cell)
}

/// The cell of these parameters in a setting that is in no table, or one of a handy size.
pub fn of_setting(setting: &Recognition, text: Option<&str>) -> Result<Cell, Failure> {
    let Some(text) = text else {
        let standard = SpaceGroup::standard(setting.number);
        let shape = standard.map_or(CellShape::Triclinic, SpaceGroup::cell_shape);
        return setting.cell(&handy(shape)?).map_err(wrong_cell);
    };
    match numbers("--cell", text)?.as_slice() {
        &[a, b, c, alpha, beta, gamma] => {
            let cell = Cell::new([a, b, c], [alpha, beta, gamma]).map_err(wrong_cell)?;
            setting.idealized(&cell).map_err(|reason| {
                Failure::Usage(format!("--cell: in the standard setting, {reason}"))
            })
        }
        other => Err(Failure::Usage(format!(
            "--cell {}: the cell of a setting that is in no table has all six parameters \
             a,b,c,alpha,beta,gamma; here are {}",
            short(text),
            other.len()
        ))),
    }
}

fn wrong_cell(reason: impl std::fmt::Display) -> Failure {
    Failure::Usage(format!("--cell: {reason}"))
}

/// The free parameters, as they are written.
fn names(shape: CellShape) -> &'static str {
    match shape {
        CellShape::Triclinic => "a,b,c,alpha,beta,gamma",
        CellShape::Monoclinic(Axis::A) => "a,b,c,alpha",
        CellShape::Monoclinic(Axis::B) => "a,b,c,beta",
        CellShape::Monoclinic(Axis::C) => "a,b,c,gamma",
        CellShape::Orthorhombic => "a,b,c",
        CellShape::Tetragonal | CellShape::Hexagonal => "a,c",
        CellShape::Rhombohedral => "a,alpha",
        CellShape::Cubic => "a",
    }
}

fn handy(shape: CellShape) -> Result<Cell, Failure> {
    let example = shape.example().cell().map_err(wrong_cell)?;
    let edges = example.edges().map(|edge| edge * HANDY);
    Cell::new(edges, example.angles()).map_err(wrong_cell)
}

/// The cell of a group with fewer translations. Its free parameters are those of its translations; the
/// other edges count for nothing and are as long as the first, at right angles.
pub fn of_lattice(group: &SubperiodicGroup, text: Option<&str>) -> Result<Cell, Failure> {
    let (kind, lattice) = (group.kind, group.lattice());
    let is_threefold = matches!(
        group.crystal_system(),
        CrystalSystem::Trigonal | CrystalSystem::Hexagonal
    );
    // The axes across a rod of threefold or sixfold symmetry are those of a hexagonal cell.
    let across = if is_threefold { 120.0 } else { 90.0 };
    let numbers = text.map(|text| numbers("--cell", text)).transpose()?;
    let given = numbers.as_deref();
    let wrong = |needed: &str| {
        Failure::Usage(format!(
            "--cell {}: the {lattice} lattice of a {kind} group has the parameters {needed}; here are {}",
            short(text.unwrap_or_default()),
            given.map_or(0, <[f64]>::len)
        ))
    };
    let (edges, gamma) = match (kind, lattice, given) {
        (SubperiodicKind::Rod, _, None) => ([HANDY; 3], across),
        (SubperiodicKind::Rod, _, Some(&[c])) => ([c; 3], across),
        (SubperiodicKind::Rod, ..) => return Err(wrong("c")),
        (_, SubperiodicLattice::Line, None) => ([HANDY; 3], 90.0),
        (_, SubperiodicLattice::Line, Some(&[a])) => ([a; 3], 90.0),
        (_, SubperiodicLattice::Line, _) => return Err(wrong("a")),
        (_, SubperiodicLattice::Oblique, None) => ([HANDY, 0.8 * HANDY, HANDY], 105.0),
        (_, SubperiodicLattice::Oblique, Some(&[a, b, gamma])) => ([a, b, a], gamma),
        (_, SubperiodicLattice::Oblique, _) => return Err(wrong("a,b,gamma")),
        (_, SubperiodicLattice::Square, None) => ([HANDY; 3], 90.0),
        (_, SubperiodicLattice::Square, Some(&[a])) => ([a; 3], 90.0),
        (_, SubperiodicLattice::Square, _) => return Err(wrong("a")),
        (_, SubperiodicLattice::Hexagonal, None) => ([HANDY; 3], 120.0),
        (_, SubperiodicLattice::Hexagonal, Some(&[a])) => ([a; 3], 120.0),
        (_, SubperiodicLattice::Hexagonal, _) => return Err(wrong("a")),
        (_, _, None) => ([HANDY, 0.75 * HANDY, HANDY], 90.0),
        (_, _, Some(&[a, b])) => ([a, b, a], 90.0),
        (_, _, Some(_)) => return Err(wrong("a,b")),
    };
    Cell::new(edges, [90.0, 90.0, gamma]).map_err(wrong_cell)
}

/// The numbers of a list, parted by commas or blanks.
pub fn numbers(option: &str, text: &str) -> Result<Vec<f64>, Failure> {
    let words: Vec<&str> = match text.contains(',') {
        true => text.split(',').map(str::trim).collect(),
        false => text.split_whitespace().collect(),
    };
    words
        .into_iter()
        .map(|word| {
            let value: Option<f64> = word.parse().ok();
            value.filter(|value| value.is_finite()).ok_or_else(|| {
                Failure::Usage(format!(
                    "{option} {}: `{}` is no finite number; write numbers parted by commas",
                    short(text),
                    short(word)
                ))
            })
        })
        .collect()
}

/// Three numbers.
pub fn triple(option: &str, text: &str) -> Result<[f64; 3], Failure> {
    let all = numbers(option, text)?;
    <[f64; 3]>::try_from(all.as_slice()).map_err(|_| {
        Failure::Usage(format!(
            "{option} {}: three numbers x,y,z are needed; here are {}",
            short(text),
            all.len()
        ))
    })
}

/// The cells to build along the edges with translations: of three parts those without must be 1.
pub fn range(
    text: Option<&str>,
    periodic: [bool; 3],
    otherwise: [i32; 3],
) -> Result<CellRange, Failure> {
    let Some(text) = text else {
        let high = [0, 1, 2].map(|i| if periodic[i] { otherwise[i] } else { 1 });
        return Ok(CellRange { low: [0; 3], high });
    };
    let parts: Vec<&str> = text.split(['x', 'X', '×', ',']).map(str::trim).collect();
    let along = periodic.iter().filter(|along| **along).count();
    // One part for all edges with translations, or one for each of them, or one for each edge.
    let mut left = parts.iter();
    let written: [&str; 3] = match parts.as_slice() {
        [a, b, c] => [a, b, c],
        some => periodic.map(|is_periodic| match (is_periodic, some) {
            (false, _) => "1",
            (true, [all]) => all,
            (true, _) => left.next().copied().unwrap_or_default(),
        }),
    };
    let wrong = |reason: String| Failure::Usage(format!("--cells {}: {reason}", short(text)));
    if ![1, along, 3].contains(&parts.len()) {
        return Err(wrong(format!(
            "the group repeats along {along} of three edges; write one number for all of them, one for \
             each, or three, 1 where it does not repeat"
        )));
    }
    // What is wrong is told of the text as it was given.
    let spelled = if along == 3 {
        text.to_owned()
    } else {
        written.join("x")
    };
    let range: CellRange = spelled
        .parse()
        .map_err(|reason| wrong(format!("{reason}; ask for a few cells, such as 2x2x2")))?;
    for (i, axis) in ['a', 'b', 'c'].into_iter().enumerate() {
        if !periodic[i] && (range.low[i], range.high[i]) != (0, 1) {
            return Err(wrong(format!(
                "the group does not repeat along {axis}: write 1 there"
            )));
        }
    }
    Ok(range)
}
