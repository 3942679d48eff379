//! Decides how the shipped crystals are shown: whole cells with the atoms on all their faces, joined
//! to their neighbours.

use super::GalleryError;
use crate::crystallography::{Atom, Bonding, CellRange, Crystal, Expansion, cif, scene};
use crate::export::{Scene, View};

/// How far beyond the last face an atom still counts as lying on it, in cell edges.
const ON_FACE: f64 = 1e-6;

/// A crystal of the gallery.
struct Example {
    name: &'static str,
    title: &'static str,
    caption: &'static str,
    file: &'static str,
    cells: &'static str,
    view: View,
}

pub(super) fn quartz() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "quartz",
        title: "Quartz",
        caption: "SiO₂, space group P 3₂ 2 1. Every silicon atom stands in a tetrahedron of oxygen, \
                  and the tetrahedra climb around the threefold screw axes: the crystal is left- or \
                  right-handed. Eight cells.",
        file: include_str!("../../data/cif/quartz.cif"),
        cells: "2x2x2",
        view: View {
            azimuth: -1.25,
            elevation: 0.30,
        },
    })
}

pub(super) fn diamond() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "diamond",
        title: "Diamond",
        caption: "C, space group F d -3 m. One carbon atom, carried to all the others by the 192 \
                  operations of the group; each has four neighbours. Eight cells.",
        file: include_str!("../../data/cif/diamond.cif"),
        cells: "2x2x2",
        view: View {
            azimuth: -1.16,
            elevation: 0.22,
        },
    })
}

pub(super) fn halite() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "halite",
        title: "Halite",
        caption: "NaCl, rock salt, space group F m -3 m. Sodium (violet) and chlorine (green) \
                  alternate along all three axes. One cell.",
        file: include_str!("../../data/cif/halite.cif"),
        cells: "1x1x1",
        view: View {
            azimuth: -1.05,
            elevation: 0.38,
        },
    })
}

pub(super) fn rutile() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "rutile",
        title: "Rutile",
        caption: "TiO₂, space group P 4₂/m n m. Octahedra of oxygen (red) around titanium (grey) \
                  share edges in chains along the fourfold screw axes. Twelve cells.",
        file: include_str!("../../data/cif/rutile.cif"),
        cells: "2x2x3",
        view: View {
            azimuth: -1.2,
            elevation: 0.26,
        },
    })
}

pub(super) fn calcite() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "calcite",
        title: "Calcite",
        caption: "CaCO₃, space group R -3 c. Flat carbonate triangles lie between layers of calcium \
                  (green), turned by half a turn from layer to layer by the glide planes. Four cells \
                  on hexagonal axes.",
        file: include_str!("../../data/cif/calcite.cif"),
        cells: "2x2x1",
        view: View {
            azimuth: -1.25,
            elevation: 0.12,
        },
    })
}

pub(super) fn spinel() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "spinel",
        title: "Spinel",
        caption: "MgAl₂O₄, space group F d -3 m. Magnesium and aluminium share both of their sites; \
                  shown is the more frequent: magnesium (green) in tetrahedra, aluminium (grey) in \
                  octahedra of oxygen (red). One cell.",
        file: include_str!("../../data/cif/spinel.cif"),
        cells: "1x1x1",
        view: View {
            azimuth: -1.2,
            elevation: 0.28,
        },
    })
}

pub(super) fn pyrite() -> Result<Scene, GalleryError> {
    build(&Example {
        name: "pyrite",
        title: "Pyrite",
        caption: "FeS₂, fool's gold, space group P a -3. Pairs of sulfur (yellow) point along the \
                  four diagonals of the cube, iron (orange) stands where the sodium of rock salt \
                  would. One cell.",
        file: include_str!("../../data/cif/pyrite.cif"),
        cells: "1x1x1",
        view: View {
            azimuth: -1.1,
            elevation: 0.32,
        },
    })
}

fn build(example: &Example) -> Result<Scene, GalleryError> {
    let reading = cif::read_str(&format!("{}.cif", example.name), example.file)?;
    let cells: CellRange = example.cells.parse()?;
    let atoms = only_the_frequent(atoms_on_faces(&reading.crystal, cells)?);
    let mut scene = scene::scene(
        example.name,
        example.title,
        example.caption,
        &reading.crystal.cell,
        cells,
        &atoms,
    )?;
    let bonds = Bonding::default().between(&atoms)?;
    scene::add_bonds(&mut scene, &atoms, &bonds)?;
    scene.set_view(example.view)?;
    Ok(scene)
}

/// The atoms of the cells and, as in textbooks, those on the far faces, which belong to the next
/// cells.
fn atoms_on_faces(crystal: &Crystal, cells: CellRange) -> Result<Vec<Atom>, GalleryError> {
    let expansion = Expansion::default();
    let unit = expansion.unit_cell(crystal)?;
    let around = CellRange {
        low: cells.low,
        high: cells.high.map(|last| last + 1),
    };
    let mut atoms = expansion.cells(crystal, &unit, around)?;
    atoms.retain(|atom| {
        let mut coordinates = atom.fract.iter().zip(cells.high);
        coordinates.all(|(fraction, last)| *fraction <= f64::from(last) + ON_FACE)
    });
    Ok(atoms)
}

/// Of atoms that share a site, the one that is there most often: a ball can show only one.
fn only_the_frequent(atoms: Vec<Atom>) -> Vec<Atom> {
    let instead = scene::more_frequent(&atoms);
    let shown = atoms.into_iter().zip(instead);
    shown
        .filter_map(|(atom, instead)| instead.is_none().then_some(atom))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crystallography::Bond;

    fn bonds(atoms: &[Atom]) -> Result<Vec<Bond>, GalleryError> {
        Ok(Bonding::default().between(atoms)?)
    }

    fn atoms(file: &str) -> Result<Vec<Atom>, GalleryError> {
        atoms_on_faces(&cif::read_str("file", file)?.crystal, CellRange::UNIT)
    }

    #[test]
    fn a_cell_of_salt_is_shown_with_its_27_ions() -> Result<(), GalleryError> {
        let atoms = atoms(include_str!("../../data/cif/halite.cif"))?;
        assert_eq!(atoms.len(), 27);
        // The edges of the eight small cubes: 3 directions of 2 · 3 · 3.
        assert_eq!(bonds(&atoms)?.len(), 54);
        Ok(())
    }

    #[test]
    fn a_cell_of_diamond_is_shown_with_18_atoms_and_16_bonds() -> Result<(), GalleryError> {
        let atoms = atoms(include_str!("../../data/cif/diamond.cif"))?;
        assert_eq!(atoms.len(), 18);
        assert_eq!(bonds(&atoms)?.len(), 16);
        Ok(())
    }

    #[test]
    fn every_carbonate_has_its_three_oxygens() -> Result<(), GalleryError> {
        let atoms = atoms(include_str!("../../data/cif/calcite.cif"))?;
        let pairs = bonds(&atoms)?;
        let inside = |i: usize| atoms[i].fract.iter().all(|f| *f > 0.1 && *f < 0.9);
        let carbons = (0..atoms.len()).filter(|&i| atoms[i].element.symbol() == "C" && inside(i));
        for carbon in carbons {
            let joined = pairs
                .iter()
                .filter(|pair| pair.atoms.contains(&carbon))
                .count();
            assert_eq!(joined, 3);
        }
        Ok(())
    }

    #[test]
    fn the_two_sites_of_spinel_show_different_metals() -> Result<(), GalleryError> {
        let all = atoms(include_str!("../../data/cif/spinel.cif"))?;
        let shown = only_the_frequent(all);
        for element in ["Mg", "Al"] {
            let here = |atom: &&Atom| atom.element.symbol() == element;
            assert!(shown.iter().filter(here).count() >= 8, "{element}");
        }
        assert!(bonds(&shown)?.len() >= 96);
        Ok(())
    }
}
