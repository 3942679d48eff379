//! Decides what is told of a space group, and what is drawn of it.

use super::document::{
    Document, Drawn, Lattice, Periodic, Placed, Reading, RootVectors, Setting, Symbols, Wyckoff,
};
use super::request::{self, Found, Unlisted};
use super::scene::{Drawing, Frame};
use super::site::{self, Site};
use super::versor::Versor;
use super::{Arguments, Made, cell, domain, summary};
use crate::command::crystal::symmetry;
use crate::failure::Failure;
use crate::unit_cell::UnitCell;
use ga_cga::Vector3;
use ga_design::crystallography::{
    BravaisLattice, Centring, Generation, Operation, SpaceGroup, SpaceGroupGenerators,
    SymmetryElements, WyckoffPositions,
};
use ga_design::export::ExportError;

/// Makes what was asked for of the group that the text means.
pub fn make(arguments: &Arguments, text: &str) -> Result<Made, Failure> {
    let found = request::space(text, arguments.notation)?;
    let group = found.group;
    let wrong = |reason: &dyn std::fmt::Display| Failure::Usage(reason.to_string());
    let wanted = arguments.cell.as_deref();
    let (cell, generation, positions) = match &found.unlisted {
        None => {
            let cell = cell::of_shape(group.cell_shape(), wanted)?;
            (cell, group.generate(&cell), group.wyckoff_positions())
        }
        Some(Unlisted { setting, .. }) => {
            let cell = cell::of_setting(setting, wanted)?;
            let change = &setting.from_standard;
            let positions = WyckoffPositions::in_setting(setting.number, change);
            (cell, setting.generate(&cell), positions)
        }
    };
    let generation = generation.map_err(|reason| wrong(&reason))?;
    let range = cell::range(arguments.cells.as_deref(), [true; 3], [1; 3])?;
    let operations = generation.operations();
    let versors = generation.versors();
    let edges = cell.edge_vectors().map(Vector3::from);

    let site = match arguments.point()? {
        Some(point) => Some(located(
            arguments,
            &operations,
            positions.as_ref(),
            &cell,
            point,
        )?),
        None => None,
    };
    let elements = if arguments.symmetry {
        Some(SymmetryElements::of(&operations).map_err(|reason| wrong(&reason))?)
    } else {
        None
    };

    let mut document = periodic(group, &generation, &operations)?;
    if let Some(unlisted) = &found.unlisted {
        rename(&mut document, unlisted, &generation);
    }
    document.setting.others = found
        .others
        .iter()
        .map(|group| group.qualified_symbol())
        .collect();
    document.notation = Some(found.notation);
    document.also = found
        .also
        .iter()
        .map(|(notation, group)| Reading::of(group, Some(*notation)))
        .collect();
    document.wyckoff = positions.as_ref().map(wyckoff);
    let triplets = operations
        .iter()
        .map(|operation| Some(operation.to_string()));
    document.placed = Some(Placed {
        cell: UnitCell::of(&cell),
        generator_versors: generation
            .generators()
            .iter()
            .zip(&document.generators)
            .map(|(versor, name)| Versor::new(Some(name.clone()), versor))
            .collect(),
        versors: triplets
            .zip(&versors)
            .map(|(operation, versor)| Versor::new(operation, versor))
            .collect(),
    });
    document.symmetry_elements = elements.as_ref().map(symmetry::described);

    let frame = Frame {
        title: format!("{} (number {})", document.hm, group.number),
        caption: caption(&document, elements.as_ref(), arguments.domain),
        isometries: versors,
        cell: Some(cell),
        edges,
        periodic: [true; 3],
        is_flat: false,
        range,
        place: site.as_ref().map(|site| site.place),
        elements,
    };
    let domain = if arguments.domain {
        Some(domain::find(&operations, &cell, frame.middle())?)
    } else {
        None
    };
    document.domain = domain
        .as_ref()
        .map(|domain| domain::described(domain, &operations, &cell));
    let drawing = if arguments.out.is_empty() {
        None
    } else {
        let mut drawing = Drawing::new(arguments, frame)?;
        if let Some(domain) = &domain {
            let parts = domain::parts(domain).map_err(ExportError::from)?;
            drawing.parts.extend(parts);
        }
        Some(drawing)
    };
    document.drawn = Drawn {
        motif: drawing.as_ref().map(Drawing::place),
        files: arguments.paths(),
    };
    document.site = site;
    let summary = summary::periodic(&document);
    Ok(Made {
        document: Document::Periodic(Box::new(document)),
        summary,
        remarks: remarks(&found, text),
        drawing,
    })
}

/// What depends on no cell.
pub fn periodic(
    group: &SpaceGroup,
    generation: &Generation,
    operations: &[Operation],
) -> Result<Periodic, Failure> {
    let generators = SpaceGroupGenerators::of(group.number);
    let generators = generators.ok_or_else(|| {
        Failure::Usage(format!(
            "the tables have no generators of group {}",
            group.number
        ))
    })?;
    let centring = Centring::from_letter(group.centring());
    let bravais = centring.and_then(|letter| BravaisLattice::of(group.crystal_system(), letter));
    let fractions = generation.translations().iter();
    Ok(Periodic {
        kind: String::from("space"),
        number: group.number,
        hm: group.symbol.to_owned(),
        symbols: Symbols {
            short: group.short_symbol(),
            full: group.full_symbol().to_owned(),
            extended: Some(group.extended_symbol()),
            qualified: group.qualified_symbol(),
        },
        hall: group.hall.to_owned(),
        schoenflies: Some(group.schoenflies()),
        point_group: group.point_group.to_owned(),
        geometric: generators.symbol.to_string(),
        system: group.crystal_system().to_string(),
        laue_class: Some(group.laue_class()),
        order: generation.representatives().len(),
        lattice: Lattice {
            bravais: bravais.map_or_else(String::new, |lattice| spaced(&format!("{lattice:?}"))),
            pearson: bravais.map(BravaisLattice::pearson),
            centring: group.centring().to_string(),
        },
        setting: Setting {
            choice: group.choice.map(String::from),
            standard: group.standard,
            from_standard: group.from_standard().map(|change| change.to_string()),
            others: Vec::new(),
        },
        notation: None,
        also: Vec::new(),
        space_group: None,
        centring: fractions
            .map(|translation| translation.translation_f64().to_vec())
            .collect(),
        operations: operations.iter().map(ToString::to_string).collect(),
        generators: generators
            .generators
            .iter()
            .map(ToString::to_string)
            .collect(),
        roots: RootVectors::of(generators),
        placed: None,
        wyckoff: None,
        site: None,
        symmetry_elements: None,
        domain: None,
        drawn: Drawn::default(),
    })
}

/// Names a setting that is in no table, where the document has the standard one.
fn rename(document: &mut Periodic, unlisted: &Unlisted, generation: &Generation) {
    let symbol = format!("{} ({})", document.hm, unlisted.setting.from_standard);
    document.symbols = Symbols {
        short: symbol.clone(),
        full: symbol.clone(),
        extended: None,
        qualified: symbol.clone(),
    };
    document.hm = symbol;
    document.hall.clone_from(&unlisted.hall);
    let mut points = generation.translations().to_vec();
    points.sort_unstable();
    let centring = Centring::ALL.into_iter().find(|centring| {
        let mut translations = centring.translations();
        translations.sort_unstable();
        translations == points
    });
    // Of a cell that no letter stands for, the points alone tell.
    document.lattice.centring =
        centring.map_or_else(String::new, |known| known.letter().to_string());
    document.setting = Setting {
        choice: None,
        standard: false,
        from_standard: Some(unlisted.setting.from_standard.to_string()),
        others: Vec::new(),
    };
}

/// The Wyckoff positions, the general one last.
fn wyckoff(positions: &WyckoffPositions) -> Vec<Wyckoff> {
    let all = positions.positions().iter();
    all.map(|position| Wyckoff {
        letter: Some(position.letter),
        multiplicity: position.multiplicity,
        site_symmetry: position.site_symmetry.clone(),
        coordinates: position
            .coordinates()
            .iter()
            .map(ToString::to_string)
            .collect(),
    })
    .collect()
}

/// The Wyckoff position of a point and its orbit.
fn located(
    arguments: &Arguments,
    operations: &[Operation],
    positions: Option<&WyckoffPositions>,
    cell: &ga_design::crystallography::Cell,
    point: [f64; 3],
) -> Result<Site, Failure> {
    let found = positions.and_then(|all| all.locate(point, cell, arguments.reach()));
    let found = found.ok_or_else(|| {
        Failure::Usage(String::from(
            "--at: the point is too far away to be told from its neighbours; give coordinates near the cell",
        ))
    })?;
    Ok(Site {
        letter: Some(found.position.letter),
        multiplicity: found.position.multiplicity,
        site_symmetry: Some(found.position.site_symmetry.clone()),
        order: found.position.site_group().len(),
        coordinates: Some(found.coordinates.to_string()),
        place: found.place,
        distance: found.distance,
        orbit: site::orbit(operations, [true; 3], cell, found.place),
    })
}

/// What should be known of how the text was read.
fn remarks(found: &Found, text: &str) -> Vec<String> {
    let mut remarks = Vec::new();
    let text = request::short(text);
    if let Some(unlisted) = &found.unlisted {
        remarks.push(format!(
            "`{text}` is the Hall symbol of an unusual setting of {} (number {}), to which {} leads from the \
             standard one",
            found.group.symbol, found.group.number, unlisted.setting.from_standard
        ));
    }
    if !found.others.is_empty() {
        let others: Vec<String> = found
            .others
            .iter()
            .map(|group| format!("`{}`", group.qualified_symbol()))
            .collect();
        remarks.push(format!(
            "`{text}` fits several settings; `{}` was taken, not {}",
            found.group.qualified_symbol(),
            others.join(", ")
        ));
    }
    for (notation, other) in &found.also {
        remarks.push(format!(
            "`{text}` was read as a {}; as a {} it means {} (number {}): --notation {}",
            found.notation.name(),
            notation.name(),
            other.symbol,
            other.number,
            format!("{notation:?}").to_lowercase(),
        ));
    }
    remarks
}

fn caption(group: &Periodic, elements: Option<&SymmetryElements>, domain: bool) -> String {
    let mut base = format!(
        "Space group {}, number {}, {}: the copies that a reflection has turned into their mirror images \
         have the second colour.",
        group.hm, group.number, group.system
    );
    if domain {
        base.push_str(
            " In glass what is nearer to one of them than to any other: a fundamental domain.",
        );
    }
    symmetry::caption(base, elements)
}

/// A name of several words, as its identifier: `cubic, face centred`.
fn spaced(identifier: &str) -> String {
    let mut words = String::new();
    for c in identifier.chars() {
        if c.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(c.to_lowercase());
    }
    words
}
