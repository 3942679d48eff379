//! How operations become a whole space group: closure under composition modulo the lattice.
//!
//! Whatever a file lists, in any setting; generators as versors are closed by
//! [`Generation`](super::Generation).

use std::collections::HashSet;

use super::operation::Operation;

/// The most operations that a group may have per cell.
///
/// A face-centred cubic group has 192; the rest is room for supercells.
pub const MOST_OPERATIONS: usize = 4096;

/// Why generators do not make a space group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ClosureError {
    /// The products go on without end.
    #[error(
        "the operations do not form a group: their products go on beyond {MOST_OPERATIONS}; \
         one of them does not belong to this lattice"
    )]
    Endless,
}

/// All operations that the generators produce, modulo the lattice; the identity comes first, and
/// given operations keep their order before those that had to be added.
///
/// Each operation costs one product per independent generator, so that a complete list is
/// confirmed quickly.
///
/// ```
/// use ga_design::crystallography::{Operation, close};
///
/// let screw: Operation = "-y,x-y,z+1/3".parse()?;
/// assert_eq!(close(&[screw])?.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn close(generators: &[Operation]) -> Result<Vec<Operation>, ClosureError> {
    let mut group = vec![Operation::IDENTITY];
    let mut known = HashSet::from([Operation::IDENTITY]);
    let mut independent = Vec::new();
    for generator in generators {
        if known.contains(generator) {
            continue;
        }
        independent.push(*generator);
        // Every element so far times the new generator, then everything new times all generators:
        // a finite set closed under right multiplication by the generators is the group.
        let mut next = 0;
        while next < group.len() {
            for factor in &independent {
                let product = group[next].after(factor).ok_or(ClosureError::Endless)?;
                if known.insert(product) {
                    if group.len() >= MOST_OPERATIONS {
                        return Err(ClosureError::Endless);
                    }
                    group.push(product);
                }
            }
            next += 1;
        }
    }
    Ok(in_given_order(generators, group))
}

/// The identity, then the given operations as given, then the rest.
fn in_given_order(given: &[Operation], group: Vec<Operation>) -> Vec<Operation> {
    let mut ordered = Vec::with_capacity(group.len());
    let mut placed = HashSet::with_capacity(group.len());
    let all = std::iter::once(&Operation::IDENTITY)
        .chain(given)
        .chain(&group);
    for operation in all {
        if placed.insert(*operation) {
            ordered.push(*operation);
        }
    }
    ordered
}
