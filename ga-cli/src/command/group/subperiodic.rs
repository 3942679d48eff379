//! Decides what is told of a plane, frieze, layer or rod group, and what is drawn of it.

use super::document::{
    Document, Drawn, Lattice, Periodic, Placed, Reading, RootVectors, Setting, Symbols, Wyckoff,
};
use super::request;
use super::scene::{Drawing, Frame};
use super::site::{self, Site};
use super::versor::Versor;
use super::{Arguments, Made, cell, summary};
use crate::failure::Failure;
use crate::unit_cell::UnitCell;
use ga_cga::Vector3;
use ga_design::crystallography::{
    Cell, ChangeOfBasis, CrystalSystem, Generation, Isometry, Operation, SpaceGroup,
    SpaceGroupGenerators, SubperiodicGroup, SubperiodicKind, SubperiodicLattice,
    SubperiodicOperation,
};

/// Makes what was asked for of the group that the text means.
pub fn make(arguments: &Arguments, kind: SubperiodicKind, text: &str) -> Result<Made, Failure> {
    let space_options = [
        ("--symmetry", arguments.symmetry),
        ("--domain", arguments.domain),
        ("--notation", arguments.notation.is_some()),
    ];
    if let Some((option, _)) = space_options.into_iter().find(|(_, given)| *given) {
        return Err(Failure::Usage(format!(
            "{option} is for space groups; leave it out, or leave --{} out",
            flag(kind)
        )));
    }
    let (group, others) = request::subperiodic(kind, text)?;
    let cell = cell::of_lattice(group, arguments.cell.as_deref())?;
    let periodic = kind.periodic();
    let range = cell::range(arguments.cells.as_deref(), periodic, usual_cells(kind))?;
    let grown = Grown::new(group, &cell)?;
    let site = match arguments.point()? {
        Some(point) => Some(located(arguments, &grown, periodic, &cell, point)?),
        None => None,
    };

    let mut document = periodic_document(group, &grown);
    document.setting.others = others
        .iter()
        .map(|group| group.qualified_symbol())
        .collect();
    document.wyckoff = wyckoff(group);
    document.placed = Some(Placed {
        cell: UnitCell::of(&cell),
        generator_versors: grown
            .generators
            .iter()
            .zip(&document.generators)
            .map(|(versor, name)| Versor::new(Some(name.clone()), versor))
            .collect(),
        versors: document
            .operations
            .iter()
            .zip(&grown.elements)
            .map(|(triplet, (_, versor))| Versor::new(Some(triplet.clone()), versor))
            .collect(),
    });
    let drawing = if arguments.out.is_empty() {
        None
    } else {
        Some(Drawing::new(
            arguments,
            Frame {
                title: format!("{kind} group {} (number {})", group.symbol, group.number),
                caption: format!(
                    "The {kind} group {}, number {}: the copies that a reflection has turned into their \
                     mirror images have the second colour.",
                    group.symbol, group.number
                ),
                isometries: grown.elements.iter().map(|(_, versor)| *versor).collect(),
                cell: Some(cell),
                edges: cell.edge_vectors().map(Vector3::from),
                periodic,
                is_flat: kind.dimension() == 2,
                range,
                place: site.as_ref().map(|site| site.place),
                elements: None,
            },
        )?)
    };
    document.drawn = Drawn {
        motif: drawing.as_ref().map(Drawing::place),
        files: arguments.paths(),
    };
    document.site = site;
    let mut remarks = Vec::new();
    if !others.is_empty() {
        let others: Vec<String> = others
            .iter()
            .map(|group| format!("`{}`", group.qualified_symbol()))
            .collect();
        remarks.push(format!(
            "`{}` fits several settings; `{}` was taken, not {}",
            request::short(text),
            group.qualified_symbol(),
            others.join(", ")
        ));
    }
    let summary = summary::periodic(&document);
    Ok(Made {
        document: Document::Periodic(Box::new(document)),
        summary,
        remarks,
        drawing,
    })
}

/// The flag of the kind.
fn flag(kind: SubperiodicKind) -> &'static str {
    match kind {
        SubperiodicKind::Plane => "wallpaper",
        SubperiodicKind::Frieze => "frieze",
        SubperiodicKind::Rod => "rod",
        SubperiodicKind::Layer => "layer",
    }
}

/// How many cells make a pattern that shows what repeats.
fn usual_cells(kind: SubperiodicKind) -> [i32; 3] {
    match kind {
        SubperiodicKind::Plane => [4, 3, 1],
        SubperiodicKind::Frieze => [6, 1, 1],
        SubperiodicKind::Rod => [1, 1, 3],
        SubperiodicKind::Layer => [3, 3, 1],
    }
}

/// A group grown from the generators of its space group.
pub struct Grown {
    /// The space group that has translations along all axes as well, in its standard setting.
    pub space: &'static SpaceGroup,
    /// How its standard setting leads to this group's.
    from_standard: ChangeOfBasis,
    generators: Vec<Isometry>,
    /// Operations modulo the translations, and their versors.
    pub elements: Vec<(SubperiodicOperation, Isometry)>,
    /// The points of the lattice in one cell.
    centring: Vec<Operation>,
}

impl Grown {
    /// The group in a cell.
    pub fn new(group: &SubperiodicGroup, cell: &Cell) -> Result<Self, Failure> {
        let wrong = |reason: &dyn std::fmt::Display| Failure::Usage(reason.to_string());
        let found = group.space_group();
        let all = found.and_then(|found| {
            let generators = SpaceGroupGenerators::of(found.number)?;
            let space = SpaceGroup::standard(found.number)?;
            Some((generators, space, found.from_standard))
        });
        let (generators, space, from_standard) = all.ok_or_else(|| {
            let symbol = group.symbol;
            Failure::Usage(format!("the tables have no generators of {symbol}"))
        })?;
        let generation: Generation = generators
            .generate_in(*cell, &from_standard)
            .map_err(|reason| wrong(&reason))?;
        let operations = generation.operations();
        let elements = operations.iter().zip(generation.versors());
        let elements = elements.map(|(operation, versor)| {
            let operation = SubperiodicOperation::new(group.kind, *operation);
            Ok((operation.map_err(|reason| wrong(&reason))?, versor))
        });
        Ok(Self {
            space,
            from_standard,
            generators: generation.generators().to_vec(),
            elements: elements.collect::<Result<_, Failure>>()?,
            centring: generation.translations().to_vec(),
        })
    }
}

/// What depends on no cell.
pub fn periodic_document(group: &SubperiodicGroup, grown: &Grown) -> Periodic {
    let generators = SpaceGroupGenerators::of(grown.space.number);
    let dimension = group.kind.dimension();
    let centring: Vec<Vec<f64>> = grown
        .centring
        .iter()
        .map(|translation| translation.translation_f64()[..dimension].to_vec())
        .collect();
    Periodic {
        kind: group.kind.to_string(),
        number: group.number,
        hm: group.symbol.to_owned(),
        symbols: Symbols {
            short: group.symbol.to_owned(),
            full: group.full_symbol().to_owned(),
            extended: None,
            qualified: group.qualified_symbol(),
        },
        hall: group.hall.to_owned(),
        schoenflies: None,
        point_group: group.point_group().unwrap_or_default().to_owned(),
        geometric: generators.map_or_else(String::new, |found| found.symbol.to_string()),
        system: system(group),
        laue_class: None,
        order: grown.elements.len() / centring.len().max(1),
        lattice: Lattice {
            bravais: group.lattice().to_string(),
            pearson: None,
            centring: group.symbol.chars().take(1).collect(),
        },
        setting: Setting {
            choice: group.choice.map(String::from),
            standard: group.standard,
            from_standard: Some(grown.from_standard.to_string()),
            others: Vec::new(),
        },
        notation: None,
        also: Vec::new(),
        space_group: Some(Reading::of(grown.space, None)),
        centring,
        operations: grown
            .elements
            .iter()
            .map(|(operation, _)| operation.to_string())
            .collect(),
        generators: generators.map_or_else(Vec::new, |found| {
            found.generators.iter().map(ToString::to_string).collect()
        }),
        roots: generators.map_or(
            RootVectors {
                p: 1,
                q: None,
                directions: Vec::new(),
                vectors: [[0.0; 3]; 3],
            },
            RootVectors::of,
        ),
        placed: None,
        wyckoff: None,
        site: None,
        symmetry_elements: None,
        domain: None,
        drawn: Drawn::default(),
    }
}

/// The Wyckoff positions, the general one last.
fn wyckoff(group: &SubperiodicGroup) -> Option<Vec<Wyckoff>> {
    let positions = group.wyckoff_positions()?;
    let told = positions.into_iter().map(|position| Wyckoff {
        letter: position.letter,
        multiplicity: position.multiplicity,
        coordinates: position.triplets(),
        site_symmetry: position.site_symmetry,
    });
    Some(told.collect())
}

/// The system: in the plane oblique, rectangular, square or hexagonal.
fn system(group: &SubperiodicGroup) -> String {
    let name = match (group.kind.dimension(), group.lattice()) {
        (2, SubperiodicLattice::Line) if group.crystal_system() == CrystalSystem::Triclinic => {
            "oblique"
        }
        (2, SubperiodicLattice::Line) if group.number == 2 => "oblique",
        (2, SubperiodicLattice::Oblique) => "oblique",
        (2, SubperiodicLattice::Square) => "square",
        (2, SubperiodicLattice::Hexagonal) => "hexagonal",
        (2, _) => "rectangular",
        _ => return group.crystal_system().to_string(),
    };
    name.to_owned()
}

/// The orbit of a point, moved onto the special position that it is near.
fn located(
    arguments: &Arguments,
    grown: &Grown,
    periodic: [bool; 3],
    cell: &Cell,
    point: [f64; 3],
) -> Result<Site, Failure> {
    if point.iter().any(|value| value.abs() > 1e6) {
        return Err(Failure::Usage(String::from(
            "--at: the point is too far away to be told from its neighbours; give coordinates near the cell",
        )));
    }
    let operations: Vec<Operation> = grown
        .elements
        .iter()
        .map(|(operation, _)| operation.in_space())
        .collect();
    let place = site::snapped(&operations, periodic, cell, point, arguments.reach());
    let orbit = site::orbit(&operations, periodic, cell, place);
    Ok(Site {
        letter: None,
        multiplicity: orbit.len(),
        site_symmetry: None,
        order: operations.len() / orbit.len().max(1),
        coordinates: None,
        distance: site::distance(cell, periodic, point, place),
        place,
        orbit,
    })
}
