//! Decides what is told of a point group, crystallographic or not, and what is drawn of it.

use super::document::{Class, Document, Drawn, Point, RootVectors, Transformation};
use super::request::{Notation, short};
use super::scene::{Drawing, Frame};
use super::versor::Versor;
use super::{Arguments, Made, summary};
use crate::failure::Failure;
use ga_cga::Vector3;
use ga_design::crystallography::{
    CellRange, CrystalClass, Isometry, PointGroup, PointSymbol, PointSymbolError,
};

mod schoenflies;

/// Makes what was asked for of the group that the text means.
pub fn make(arguments: &Arguments, text: &str) -> Result<Made, Failure> {
    let lattice_options = [
        ("--cell", arguments.cell.is_some()),
        ("--cells", arguments.cells.is_some()),
        ("--symmetry", arguments.symmetry),
        ("--domain", arguments.domain),
        ("--at", arguments.at.is_some()),
    ];
    if let Some((option, _)) = lattice_options.into_iter().find(|(_, given)| *given) {
        return Err(Failure::Usage(format!(
            "{option} needs a lattice, which a point group has none of; leave it out, or leave --point out"
        )));
    }
    let found = find(text, arguments.notation)?;
    let mut document = describe(&found.group);
    document.notation = Some(found.notation);
    let drawing = if arguments.out.is_empty() {
        None
    } else {
        let name = document.hm.unwrap_or(&document.schoenflies);
        Some(Drawing::new(
            arguments,
            Frame {
                title: format!("Point group {name} ({})", document.geometric),
                caption: format!(
                    "The point group {name}, of order {}: the copies that a reflection has turned into their \
                     mirror images have the second colour.",
                    document.order
                ),
                isometries: found.group.transformations().to_vec(),
                cell: None,
                edges: [Vector3::default(); 3],
                periodic: [false; 3],
                is_flat: false,
                range: CellRange::UNIT,
                place: None,
                elements: None,
            },
        )?)
    };
    document.drawn = Drawn {
        motif: drawing.as_ref().map(Drawing::place),
        files: arguments.paths(),
    };
    let summary = summary::point(&document);
    Ok(Made {
        document: Document::Point(Box::new(document)),
        summary,
        remarks: found.remarks,
        drawing,
    })
}

struct Found {
    group: PointGroup,
    notation: Notation,
    remarks: Vec<String>,
}

/// The group that a text means: International, Schoenflies, or geometric.
fn find(text: &str, notation: Option<Notation>) -> Result<Found, Failure> {
    if matches!(notation, Some(Notation::Number | Notation::Hall)) {
        return Err(Failure::Usage(String::from(
            "--notation: point groups have international, schoenflies and geometric symbols",
        )));
    }
    let asked = |other: Notation| notation.is_none_or(|wanted| wanted == other);
    let named = |notation, group| (notation, group);
    let mut readings: Vec<(Notation, PointGroup)> = Vec::new();
    let international = PointGroup::from_international(text);
    if asked(Notation::International) {
        readings.extend(
            international
                .iter()
                .cloned()
                .map(|group| named(Notation::International, group)),
        );
    }
    if asked(Notation::Schoenflies) {
        let group =
            schoenflies::symbol(text).and_then(|symbol| PointGroup::from_geometric(&symbol).ok());
        readings.extend(group.map(|group| named(Notation::Schoenflies, group)));
    }
    let geometric = PointGroup::from_geometric(text);
    if asked(Notation::Geometric) {
        readings.extend(
            geometric
                .iter()
                .cloned()
                .map(|group| named(Notation::Geometric, group)),
        );
    }
    let Some((read_as, group)) = readings.first().cloned() else {
        return Err(unknown(text, notation));
    };
    let others = readings.iter().skip(1);
    let remarks = others
        .filter(|(_, other)| other.symbol() != group.symbol())
        .map(|(other, means)| {
            format!(
                "`{}` was read as the {} symbol; as a {} it means {}: --notation {}",
                short(text),
                if read_as == Notation::International {
                    "International"
                } else {
                    read_as.name()
                },
                other.name(),
                schoenflies::name(means),
                format!("{other:?}").to_lowercase(),
            )
        });
    Ok(Found {
        remarks: remarks.collect(),
        notation: read_as,
        group,
    })
}

/// What is said of a text that means no group: why its numbers have no roots, or the nearest names.
fn unknown(text: &str, notation: Option<Notation>) -> Failure {
    let symbol: Result<PointSymbol, PointSymbolError> = text.parse();
    let looks_geometric = notation == Some(Notation::Geometric)
        || matches!(symbol, Err(PointSymbolError::Roots(_)))
        || text.starts_with("b(");
    if let (true, Err(reason)) = (looks_geometric, symbol) {
        return Failure::Usage(format!("`{}`: {reason}", short(text)));
    }
    let near_international = CrystalClass::from_international(text).err();
    let near_schoenflies = CrystalClass::from_schoenflies(text).err();
    let is_schoenflies = notation == Some(Notation::Schoenflies)
        || text
            .trim_start()
            .starts_with(['C', 'D', 'S', 'T', 'O', 'I']);
    let names: Vec<&str> = match (near_international, near_schoenflies) {
        (_, Some(near)) if is_schoenflies => near.suggestions,
        (Some(near), _) => near.suggestions,
        _ => Vec::new(),
    };
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    Failure::Usage(format!(
        "unknown point group `{}`; did you mean {}? International (4/mmm), Schoenflies (D4h, C5v, I) and \
         geometric symbols (42, b(5)b(3)) are known",
        short(text),
        names.join(", ")
    ))
}

/// What is told of a group.
pub fn describe(group: &PointGroup) -> Point {
    let class = group.crystal_class();
    let inversion = group.position(&Isometry::inversion());
    let kind = |number: usize, order: usize| {
        let is_proper = group
            .transformations()
            .get(number)
            .is_some_and(Isometry::is_proper);
        match (is_proper, order) {
            (true, 1) => "identity",
            (true, _) => "rotation",
            (false, _) if Some(number) == inversion => "inversion",
            (false, 2) => "reflection",
            (false, _) => "rotoreflection",
        }
    };
    let classes: Vec<Class> = group
        .conjugacy_classes()
        .into_iter()
        .map(|members| {
            let first = members.first().copied().unwrap_or_default();
            let order = group.order_of(first).unwrap_or_default();
            Class {
                size: members.len(),
                order,
                kind: kind(first, order),
                members,
            }
        })
        .collect();
    // All members of a class have the order and kind of the first.
    let mut of_member = vec![(1, "identity"); group.order()];
    for class in &classes {
        for member in &class.members {
            if let Some(slot) = of_member.get_mut(*member) {
                *slot = (class.order, class.kind);
            }
        }
    }
    let versors = group.transformations().iter().zip(of_member);
    let symbol = group.symbol();
    let place = |class: &CrystalClass| {
        CrystalClass::table()
            .iter()
            .position(|other| other.international == class.international)
    };
    Point {
        kind: "point",
        number: class.and_then(place).map(|at| at + 1),
        hm: class.map(|class| class.international),
        schoenflies: schoenflies::name(group),
        geometric: symbol.to_string(),
        overlined: symbol.overlined(),
        p: symbol.p(),
        q: symbol.q(),
        system: class.map(|class| class.system.to_string()),
        laue_class: class.map(|class| class.laue),
        order: group.order(),
        chiral: group.is_chiral(),
        centrosymmetric: inversion.is_some(),
        notation: None,
        roots: RootVectors::of_point(symbol, Vec::new()),
        generators: group
            .generators()
            .iter()
            .map(|(word, _)| word.to_string())
            .collect(),
        classes,
        versors: versors
            .map(|(isometry, (order, kind))| Transformation {
                order,
                kind,
                versor: Versor::new(None, isometry),
            })
            .collect(),
        drawn: Drawn::default(),
    }
}
