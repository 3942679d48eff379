//! How a change of basis at the end of a Hall symbol is read and carried out.

use num_rational::Ratio;

use super::super::change_of_basis::ChangeOfBasis;
use super::super::operation::{DENOMINATOR, Operation, affine};
use super::ChangeError;

type Exact = Ratio<i64>;

/// Reads `(0 0 1)` or `(x,y,z)`, brackets included: the map from old coordinates to new ones, so
/// the inverse of what International Tables call the change.
pub fn read(bytes: &[u8]) -> Result<ChangeOfBasis, ChangeError> {
    let text = std::str::from_utf8(bytes).map_err(|_| ChangeError::Form)?;
    let inner = text
        .trim()
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'))
        .ok_or(ChangeError::Bracket)?;
    let (linear, shift) = if inner.contains(',') {
        let map = affine(inner)?;
        (map.linear, map.shift)
    } else {
        (ChangeOfBasis::identity().linear(), twelfths(inner)?)
    };
    let bound = Exact::from_integer(12);
    let coarse = |value: &Exact| 12 % value.denom() == 0 && *value <= bound && *value >= -bound;
    let fits = |value: &Exact| i64::from(DENOMINATOR) % value.denom() == 0;
    if !linear.iter().flatten().all(coarse) || !shift.iter().all(fits) {
        return Err(ChangeError::Singular);
    }
    let change = ChangeOfBasis::new(linear, shift).ok_or(ChangeError::Singular)?;
    Ok(change.inverse())
}

/// The operations in the new basis: `V S V⁻¹` for each, and the old lattice translations, which
/// may be fractions of the new ones.
pub fn carry(
    change: &ChangeOfBasis,
    operations: &[Operation],
) -> Result<Vec<Operation>, ChangeError> {
    let mut carried = change
        .old_lattice()
        .ok_or(ChangeError::NotIntegral)?
        .to_vec();
    for old in operations {
        carried.push(change.operation(old).ok_or(ChangeError::NotIntegral)?);
    }
    Ok(carried)
}

fn twelfths(text: &str) -> Result<[Exact; 3], ChangeError> {
    let mut shift = [Exact::from_integer(0); 3];
    let mut words = text
        .split(|c: char| c.is_whitespace() || c == '_')
        .filter(|w| !w.is_empty());
    for value in &mut shift {
        let number: i8 = words
            .next()
            .and_then(|w| w.parse().ok())
            .ok_or(ChangeError::Form)?;
        *value = Exact::new(number.into(), 12);
    }
    if words.next().is_some() {
        Err(ChangeError::Form)
    } else {
        Ok(shift)
    }
}
