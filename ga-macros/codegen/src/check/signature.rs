//! A signature is `R` and up to three counts, of a dimension that can be generated.

use crate::ast::{Algebra, Signature};
use crate::errors::{Errors, Mistake};
use crate::model::{COMPLETE_LIMIT, DECLARED_LIMIT};

/// How many basis vectors square to a positive number, to a negative one, and to zero.
pub type Counts = (usize, usize, usize);

/// The number of basis vectors.
pub fn total((p, q, r): Counts) -> usize {
    p.saturating_add(q).saturating_add(r)
}

/// The shortest name of a signature: `R3`, `R4_1`, `R3_0_1`.
pub fn text(p: usize, q: usize, r: usize) -> String {
    match (q, r) {
        (0, 0) => format!("R{p}"),
        (_, 0) => format!("R{p}_{q}"),
        _ => format!("R{p}_{q}_{r}"),
    }
}

/// The signature is of the form `Rp_q_r`.
pub fn counts(signature: &Signature, errors: &mut Errors) -> Option<Counts> {
    if signature.text.is_empty() {
        return None; // Reported where it is missing.
    }
    let counts = read(&signature.text);
    if counts.is_none() {
        let mistake = if is_several(&signature.text) {
            Mistake::SeveralSignatures
        } else {
            Mistake::UnknownSignature {
                text: signature.text.clone(),
                suggestion: suggestion(&signature.text),
            }
        };
        errors.push_range(signature.spans, mistake);
    }
    counts
}

fn read(text: &str) -> Option<Counts> {
    let mut counts = [0; 3];
    let mut parts = text.strip_prefix('R')?.split('_');
    for count in &mut counts {
        match parts.next() {
            None => break,
            Some(part) => *count = number(part)?,
        }
    }
    let [p, q, r] = counts;
    parts.next().is_none().then_some((p, q, r))
}

/// Whether these are signatures side by side, `R3, R4` or `R3 R4`.
fn is_several(text: &str) -> bool {
    let mut words = text.split([',', ' ']).filter(|word| !word.is_empty());
    words.clone().count() > 1 && words.all(|word| read(word).is_some())
}

/// A count; one beyond all limits is as good as any other beyond them.
fn number(digits: &str) -> Option<usize> {
    let valid = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    valid.then(|| digits.parse().unwrap_or(usize::MAX))
}

/// What `R4-1`, `Cl(4, 1)` or `r4_1` probably means: the numbers in it.
fn suggestion(text: &str) -> Option<String> {
    let numbers: Option<Vec<usize>> = text
        .split(|c: char| !c.is_ascii_digit())
        .filter(|digits| !digits.is_empty())
        .map(|digits| digits.parse().ok())
        .collect();
    let (p, q, r) = match numbers?.as_slice() {
        [p] => (*p, 0, 0),
        [p, q] => (*p, *q, 0),
        [p, q, r] => (*p, *q, *r),
        _ => return None,
    };
    (1..=DECLARED_LIMIT)
        .contains(&total((p, q, r)))
        .then(|| self::text(p, q, r))
}

/// How many basis vectors to work with.
pub struct Dimension {
    /// Their number.
    pub vectors: usize,
    /// Whether the call says so, rather than the number being a guess to go on with.
    pub known: bool,
}

/// The dimension is at least one and within the limits.
pub fn dimension(algebra: &Algebra, counts: Option<Counts>, errors: &mut Errors) -> Dimension {
    let signature = &algebra.signature;
    let limit = if algebra.types.is_none() {
        COMPLETE_LIMIT
    } else {
        DECLARED_LIMIT
    };
    let within = |vectors: &usize| (1..=limit).contains(vectors);
    let declared = counts.map(total);
    match declared {
        Some(0) => {
            let mistake = Mistake::NoDimension(signature.text.clone());
            errors.push_range(signature.spans, mistake);
        }
        Some(vectors) if !within(&vectors) => {
            let mistake = Mistake::TooManyDimensions {
                signature: signature.text.clone(),
                limit,
                preset: algebra.types.is_none(),
            };
            errors.push_range(signature.spans, mistake);
        }
        _ => {}
    }
    // The basis says what the user has in mind where the signature does not.
    let named = algebra.basis.as_ref().map(Vec::len);
    match named.filter(within).or(declared.filter(within)) {
        Some(vectors) => Dimension {
            vectors,
            known: match (named, declared) {
                (Some(named), Some(declared)) => named == declared,
                (Some(one), None) | (None, Some(one)) => within(&one),
                (None, None) => false,
            },
        },
        None => Dimension {
            vectors: COMPLETE_LIMIT,
            known: false,
        },
    }
}
