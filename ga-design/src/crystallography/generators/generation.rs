//! How generators as versors become a group: closure modulo the translations of the lattice.
//!
//! [`close`](super::super::close) does the same for exact operations of any origin, supercells
//! included. Here every element keeps the versor that it was composed as, one for each coset, so
//! that a wrong generator shows as too many of them.

use std::collections::HashSet;

use ga_cga::Vector3;

use super::super::{Cell, Isometry, NotOfLattice, Operation};
use super::generate::GenerationError;

/// The most cosets that the translations have in a space group: the order of the largest point
/// group of a lattice.
const MOST_COSETS: usize = 48;

/// A space group as versors in a cell: one for each coset of the lattice translations, and the
/// operations that they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Generation {
    cell: Cell,
    generators: Vec<Isometry>,
    representatives: Vec<(Operation, Isometry)>,
    translations: Vec<Operation>,
}

impl Generation {
    /// Closes generators under composition, modulo the edges of the cell and the further
    /// translations that are given as operations, the identity first.
    pub(super) fn close(
        cell: Cell,
        generators: Vec<Isometry>,
        translations: Vec<Operation>,
    ) -> Result<Self, GenerationError> {
        let identity = (Operation::IDENTITY, Isometry::identity());
        let mut representatives = vec![identity];
        let mut known: HashSet<Operation> = translations.iter().copied().collect();
        let mut next = 0;
        while let Some((_, element)) = representatives.get(next).copied() {
            for generator in &generators {
                let product = generator.after(&element);
                let operation = product.operation(&cell)?;
                if known.contains(&operation) {
                    continue;
                }
                if representatives.len() >= MOST_COSETS {
                    return Err(GenerationError::Endless);
                }
                for translation in &translations {
                    let beside = translation.after(&operation);
                    known.insert(beside.ok_or(GenerationError::Endless)?);
                }
                representatives.push((operation, placed(&product, &operation, &cell)));
            }
            next += 1;
        }
        Ok(Self {
            cell,
            generators,
            representatives,
            translations,
        })
    }

    /// The cell, with the constraints of its system kept exactly.
    pub fn cell(&self) -> &Cell {
        &self.cell
    }

    /// The generators, as versors.
    pub fn generators(&self) -> &[Isometry] {
        &self.generators
    }

    /// One operation and its versor for each coset of the lattice translations, the identity
    /// first: as many as the point group has elements. Translations are in `[0, 1)` of the edges.
    pub fn representatives(&self) -> &[(Operation, Isometry)] {
        &self.representatives
    }

    /// The lattice points of one cell, as translations; the identity first.
    pub fn translations(&self) -> &[Operation] {
        &self.translations
    }

    /// All operations modulo the edges of the cell, those of the representatives first.
    pub fn operations(&self) -> Vec<Operation> {
        let mut all = Vec::with_capacity(self.representatives.len() * self.translations.len());
        for translation in &self.translations {
            let moved = self
                .representatives
                .iter()
                .filter_map(|(operation, _)| translation.after(operation));
            all.extend(moved);
        }
        all
    }

    /// The versors of [`operations`](Generation::operations), in the same order.
    pub fn versors(&self) -> Vec<Isometry> {
        let mut all = Vec::with_capacity(self.representatives.len() * self.translations.len());
        for translation in &self.translations {
            let moved = self
                .representatives
                .iter()
                .filter_map(|(operation, versor)| {
                    let operation = translation.after(operation)?;
                    Some(placed(versor, &operation, &self.cell))
                });
            all.extend(moved);
        }
        all
    }
}

/// The isometry with the translation that an operation has in the cell, without rounding.
fn placed(isometry: &Isometry, operation: &Operation, cell: &Cell) -> Isometry {
    let shift = Vector3::from(cell.cartesian(operation.translation_f64()));
    Isometry::translation(shift - isometry.shift()).after(isometry)
}

impl From<NotOfLattice> for GenerationError {
    fn from(error: NotOfLattice) -> Self {
        Self::Lattice(error)
    }
}
