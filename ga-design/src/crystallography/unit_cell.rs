//! How the sites of a crystal become the atoms of its cells: every operation applied to every
//! site, coincident copies merged.

use std::sync::Arc;

use super::cell_range::CellRange;
use super::crystal::{Crystal, Site};
use super::elements::Element;
use super::placement::{Placement, PlacementError, SymmetricCell};
use super::versor::Isometry;
use ga_cga::Point;

mod grid;

use grid::PeriodicGrid;

/// The most copies (sites times operations) that are made before merging.
const MOST_COPIES: u64 = 20_000_000;

/// A fraction closer than this below 1 counts as 0.
const WRAP_TOLERANCE: f64 = 1e-6;

/// Fractions are rounded to one over this, far above the noise of double precision and far below any
/// measurement, so that 1/2 comes out as 0.5 whichever way it was computed.
const PER_ROUNDING: f64 = 1e12;

/// Two different sites of one element at one place are one atom when their occupancies add up to
/// more than this.
const FULL_OCCUPANCY: f64 = 1.01;

/// An atom of a crystal.
#[derive(Clone, Debug, PartialEq)]
pub struct Atom {
    /// The label of its site.
    pub label: Arc<str>,
    /// The element.
    pub element: Element,
    /// The position in fractions of the cell edges; in `[0, 1)` for the atoms of one unit cell.
    pub fract: [f64; 3],
    /// The position in the Cartesian frame of [`super::Cell`], in ångström.
    pub cart: [f64; 3],
    /// The occupancy of its site.
    pub occupancy: f64,
    /// The index of its site in [`Crystal::sites`].
    pub site: usize,
    /// The index of an operation in [`Crystal::operations`] that carries the site here, modulo
    /// the lattice.
    pub operation: usize,
}

/// Why a crystal cannot be expanded.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExpansionError {
    /// The cell contradicts the operations.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// More atoms than the limit.
    #[error(
        "{atoms} atoms would be built, more than the {limit} allowed; ask for fewer cells \
         (such as 2x2x2)"
    )]
    TooMany {
        /// How many there would be.
        atoms: u64,
        /// The limit.
        limit: u64,
    },
    /// A site went to a place that is no place.
    #[error("the site `{label}` has no finite position")]
    NotFinite {
        /// The label of the site.
        label: String,
    },
    /// Hundreds of atoms in one place.
    #[error("hundreds of atoms crowd around the site `{label}`; no crystal is that dense")]
    Crowded {
        /// The label of the site.
        label: String,
    },
    /// The placements do not belong to the operations.
    #[error("{placements} placements for {operations} operations; there must be one for each")]
    Count {
        /// How many placements there are.
        placements: usize,
        /// How many operations there are.
        operations: usize,
    },
}

/// How a crystal is expanded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion {
    /// Copies of a site closer than this, in ångström, are one atom (0.05): well above what
    /// coordinates of three digits are off from special positions, well below any bond and below
    /// the distances between alternative positions of disordered atoms.
    ///
    /// Never more than a tenth of the smallest distance between opposite faces is used.
    pub merge_distance: f64,
    /// The most atoms to build (5 million): so many take 1.2 gigabytes while they are
    /// made a scene and written.
    pub most_atoms: u64,
}

impl Default for Expansion {
    fn default() -> Self {
        Self {
            merge_distance: 0.05,
            most_atoms: 5_000_000,
        }
    }
}

impl Expansion {
    /// The atoms of one full unit cell, site by site in the order of the operations, each
    /// operation carried out by its versors.
    ///
    /// A site on a special position is moved onto it exactly: its atom is the mean of the
    /// coincident copies.
    pub fn unit_cell(&self, crystal: &Crystal) -> Result<Vec<Atom>, ExpansionError> {
        let (placements, frame) = Placement::of_group(&crystal.operations, &crystal.cell)?;
        let versors = placements.iter().map(Isometry::from);
        let apply: Vec<_> = versors
            .map(|versor| {
                move |[x, y, z]: [f64; 3]| versor.apply(Point::at(x, y, z)).position().to_array()
            })
            .collect();
        self.unit_cell_by(crystal, &frame, &apply)
    }

    /// As [`Expansion::unit_cell`], with the operations applied by the caller: `placements` holds
    /// one map of Cartesian points (ångström, in the axes of `frame`) for each operation of the
    /// crystal, such as the versors built from [`Placement`].
    pub fn unit_cell_by<F>(
        &self,
        crystal: &Crystal,
        frame: &SymmetricCell,
        placements: &[F],
    ) -> Result<Vec<Atom>, ExpansionError>
    where
        F: Fn([f64; 3]) -> [f64; 3],
    {
        if placements.len() != crystal.operations.len() {
            let (placements, operations) = (placements.len(), crystal.operations.len());
            return Err(ExpansionError::Count {
                placements,
                operations,
            });
        }
        let copies = (crystal.sites.len() as u64).saturating_mul(placements.len() as u64);
        if copies > MOST_COPIES {
            return Err(ExpansionError::TooMany {
                atoms: copies,
                limit: MOST_COPIES,
            });
        }
        let faces = crystal.cell.face_distances();
        let smallest = faces.into_iter().fold(f64::INFINITY, f64::min);
        // In this order, so that NaN counts as 0.
        let distance = self.merge_distance.max(0.0).min(0.1 * smallest);
        let mut grid = PeriodicGrid::new(&crystal.cell, distance);
        let mut atoms = Vec::new();
        for (index, site) in crystal.sites.iter().enumerate() {
            let start = atoms.len();
            expand_site(
                crystal,
                (index, site),
                frame,
                placements,
                &mut grid,
                &mut atoms,
            )?;
            let orbit = atoms.get_mut(start..).unwrap_or_default();
            for (atom, at) in orbit.iter_mut().zip(start..) {
                atom.fract = grid.mean(at).map(wrapped);
                atom.cart = crystal.cell.cartesian(atom.fract);
            }
            self.check(atoms.len() as u64)?;
        }
        Ok(atoms)
    }

    /// The atoms of a block of cells, cell by cell, from those of one unit cell.
    ///
    /// ```
    /// use ga_design::crystallography::{CellRange, Expansion, ExpansionError};
    /// # let text = "data_p\n_cell_length_a 3\n_cell_length_b 3\n_cell_length_c 3\n\
    /// # _cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n\
    /// # _space_group_IT_number 221\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
    /// # _atom_site_fract_y\n_atom_site_fract_z\nPo 0 0 0\n";
    /// # let crystal = ga_design::crystallography::cif::read_str("p.cif", text)?.crystal;
    /// let expansion = Expansion::default();
    /// let unit = expansion.unit_cell(&crystal)?;
    /// let block = expansion.cells(&crystal, &unit, "2x2x2".parse()?)?;
    /// assert_eq!(block.len(), 8 * unit.len());
    /// let huge = expansion.cells(&crystal, &unit, "1000x1000x1000".parse()?);
    /// assert!(matches!(huge, Err(ExpansionError::TooMany { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cells(
        &self,
        crystal: &Crystal,
        unit_cell: &[Atom],
        range: CellRange,
    ) -> Result<Vec<Atom>, ExpansionError> {
        self.check((unit_cell.len() as u64).saturating_mul(range.count()))?;
        let moved = range.offsets().flat_map(|offset| {
            unit_cell.iter().map(move |atom| {
                let mut copy = atom.clone();
                for (fraction, cells) in copy.fract.iter_mut().zip(offset) {
                    *fraction += f64::from(cells);
                }
                copy.cart = crystal.cell.cartesian(copy.fract);
                copy
            })
        });
        Ok(moved.collect())
    }

    fn check(&self, atoms: u64) -> Result<(), ExpansionError> {
        let limit = self.most_atoms;
        if atoms > limit {
            Err(ExpansionError::TooMany { atoms, limit })
        } else {
            Ok(())
        }
    }
}

/// Adds the orbit of one site; positions are set from the grid afterwards.
fn expand_site<F>(
    crystal: &Crystal,
    (index, site): (usize, &Site),
    frame: &SymmetricCell,
    placements: &[F],
    grid: &mut PeriodicGrid,
    atoms: &mut Vec<Atom>,
) -> Result<(), ExpansionError>
where
    F: Fn([f64; 3]) -> [f64; 3],
{
    let label: Arc<str> = Arc::from(site.label.as_str());
    let start = frame.cartesian(site.position());
    for (operation, place) in placements.iter().enumerate() {
        let fract = frame.fractional(place(start)).map(wrapped);
        if fract.iter().any(|value| !value.is_finite()) {
            return Err(ExpansionError::NotFinite {
                label: site.label.clone(),
            });
        }
        let coincident = grid.find(fract, |at| {
            atoms.get(at).is_some_and(|other: &Atom| {
                other.site == index
                    || (other.element == site.element
                        && other.occupancy + site.occupancy > FULL_OCCUPANCY)
            })
        });
        match coincident {
            Some(at) if atoms.get(at).is_some_and(|other| other.site == index) => {
                grid.merge(at, fract);
            }
            Some(_) => {}
            None => {
                if !grid.insert(fract) {
                    return Err(ExpansionError::Crowded {
                        label: site.label.clone(),
                    });
                }
                atoms.push(Atom {
                    label: Arc::clone(&label),
                    element: site.element,
                    fract,
                    cart: crystal.cell.cartesian(fract),
                    occupancy: site.occupancy,
                    site: index,
                    operation,
                });
            }
        }
    }
    Ok(())
}

/// A fraction reduced to `[0, 1)`.
fn wrapped(value: f64) -> f64 {
    let fraction = value - value.floor();
    let rounded = (fraction * PER_ROUNDING).round() / PER_ROUNDING;
    if rounded > 1.0 - WRAP_TOLERANCE {
        0.0
    } else {
        rounded
    }
}
