//! The greedy search: name the divisor that saves most, until none saves anything.
//!
//! This is the fast extraction of multi-level logic synthesis (Rajski and Vasudevamurthy, 1992),
//! with signs and with the cost of [`Cost`](super::Cost). Sums of more terms are found term by
//! term. Terms are only regrouped and common factors taken out of them; nothing is multiplied out,
//! so that no difference of large values arises where there was none.

mod known;

use super::cube::{LARGEST, Name, Term};
use super::divisors::Occurrence;
use super::network::Network;
use known::Known;

/// Names divisors until none saves anything; whether there was any.
pub fn extract(network: &mut Network) -> bool {
    let mut found = false;
    loop {
        let before = network.sums.len();
        search(network);
        // What is noted at first leaves out divisors that occurred only once then.
        if network.sums.len() == before {
            return found;
        }
        found = true;
    }
}

fn search(network: &mut Network) {
    let mut known = Known::new(network);
    while network.names() < usize::from(LARGEST) {
        let Some((divisor, occurrences)) = known.best(network) else {
            return;
        };
        let name = network.name(divisor.sum());
        let mut changed: Vec<u16> = occurrences.iter().map(|found| found.sum).collect();
        changed.dedup();
        for place in &changed {
            known.forget(*place);
            let here = occurrences.iter().filter(|found| found.sum == *place);
            replace(network, name, *place, here);
        }
        changed.push((network.sums.len() - 1) as u16);
        for place in changed {
            known.note(network, place);
        }
    }
}

/// Writes the named divisor in the place of its occurrences in one sum.
fn replace<'a>(
    network: &mut Network,
    name: Name,
    place: u16,
    occurrences: impl Iterator<Item = &'a Occurrence>,
) {
    let mut gone = Vec::new();
    let mut terms = Vec::new();
    for found in occurrences {
        gone.extend(found.terms);
        terms.push(Term {
            cube: found.cofactor.with(name),
            negative: found.negative,
        });
    }
    let sum = &mut network.sums[usize::from(place)];
    let mut number = 0;
    sum.retain(|_| {
        number += 1;
        !gone.contains(&(number - 1))
    });
    sum.extend(terms);
}
