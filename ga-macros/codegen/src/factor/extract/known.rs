//! Where divisors occur and what naming each of them would save, kept while sums change.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::hash::{BuildHasher, BuildHasherDefault, Hasher};

use crate::factor::cost::Weight;
use crate::factor::divisors::{Divisor, Occurrence, divisors};
use crate::factor::network::Network;

/// What naming a divisor saves: fused operations, multiplications, additions.
type Gain = [isize; 3];

/// A divisor that may be worth a name.
#[derive(Default)]
struct Candidate {
    occurrences: Vec<Occurrence>,
    /// What it saves, and how often it is used then; `None` where its sums changed.
    gain: Option<(Gain, usize)>,
}

/// Where the divisors of all sums occur.
pub struct Known {
    candidates: HashMap<Divisor, Candidate, Hashing>,
    /// The divisors of each sum.
    of_sum: Vec<Vec<Divisor>>,
}

impl Known {
    /// The divisors of a network, without those that occur only once and have no common factor.
    pub fn new(network: &Network) -> Known {
        let hashing = Hashing::default();
        let mut hashes = Vec::new();
        for (place, sum) in network.sums.iter().enumerate() {
            divisors(place as u16, sum, |divisor, found| {
                if !found.is_multiple() {
                    hashes.push(hashing.hash_one(divisor));
                }
            });
        }
        hashes.sort_unstable();
        let runs = hashes.chunk_by(|a, b| a == b);
        let repeated: Vec<u64> = runs.filter(|run| run.len() > 1).map(|run| run[0]).collect();
        let mut known = Known {
            candidates: HashMap::default(),
            of_sum: Vec::new(),
        };
        for place in 0..network.sums.len() {
            known.note_where(network, place as u16, |divisor, found| {
                found.is_multiple() || repeated.binary_search(&hashing.hash_one(divisor)).is_ok()
            });
        }
        known
    }

    /// Notes the divisors of a sum.
    pub fn note(&mut self, network: &Network, place: u16) {
        self.note_where(network, place, |_, _| true);
    }

    fn note_where(
        &mut self,
        network: &Network,
        place: u16,
        wanted: impl Fn(&Divisor, &Occurrence) -> bool,
    ) {
        let mut list = Vec::new();
        divisors(
            place,
            &network.sums[usize::from(place)],
            |divisor, found| {
                if wanted(&divisor, &found) {
                    let candidate = self.candidates.entry(divisor).or_default();
                    candidate.occurrences.push(found);
                    candidate.gain = None;
                    list.push(divisor);
                }
            },
        );
        self.of_sum.resize(network.sums.len(), Vec::new());
        self.of_sum[usize::from(place)] = list;
    }

    /// Forgets the divisors of a sum that is about to change.
    pub fn forget(&mut self, place: u16) {
        for divisor in std::mem::take(&mut self.of_sum[usize::from(place)]) {
            if let Some(candidate) = self.candidates.get_mut(&divisor) {
                candidate.occurrences.retain(|found| found.sum != place);
                candidate.gain = None;
                if candidate.occurrences.is_empty() {
                    self.candidates.remove(&divisor);
                }
            }
        }
    }

    /// The divisor that saves most, and its occurrences; of equals the one that is used most
    /// often, then the smallest.
    pub fn best(&mut self, network: &Network) -> Option<(Divisor, Vec<Occurrence>)> {
        let mut best: Option<(Gain, usize, Reverse<Divisor>)> = None;
        for (divisor, candidate) in &mut self.candidates {
            if let [single] = candidate.occurrences.as_slice()
                && !single.is_multiple()
            {
                continue;
            }
            let (gain, uses) = *candidate.gain.get_or_insert_with(|| {
                candidate.occurrences.sort_unstable();
                let chosen = apart(&candidate.occurrences);
                (gain(network, *divisor, &chosen), chosen.len())
            });
            let found = (gain, uses, Reverse(*divisor));
            if gain > [0; 3] && best.is_none_or(|known| known < found) {
                best = Some(found);
            }
        }
        let Reverse(divisor) = best?.2;
        Some((divisor, apart(&self.candidates.get(&divisor)?.occurrences)))
    }
}

/// Of sorted occurrences those that share no term, the first ones first.
fn apart(occurrences: &[Occurrence]) -> Vec<Occurrence> {
    let mut chosen: Vec<Occurrence> = Vec::with_capacity(occurrences.len());
    for found in occurrences {
        let overlaps = |other: &Occurrence| other.terms.iter().any(|i| found.terms.contains(i));
        let mut here = chosen
            .iter()
            .rev()
            .take_while(|other| other.sum == found.sum);
        if !here.any(overlaps) {
            chosen.push(*found);
        }
    }
    chosen
}

/// What is saved by naming a divisor where it occurs.
fn gain(network: &Network, divisor: Divisor, occurrences: &[Occurrence]) -> Gain {
    let mut gain = [0; 3];
    let mut add = |weight: Weight, sign: isize| {
        let cost = weight.cost();
        let counts = [cost.fused, cost.multiplications, cost.additions];
        for (total, count) in gain.iter_mut().zip(counts) {
            *total += sign * count as isize;
        }
    };
    add(network.sum_weight(&divisor.sum()), -1);
    for group in occurrences.chunk_by(|a, b| a.sum == b.sum) {
        let sum = &network.sums[usize::from(group[0].sum)];
        let before = network.sum_weight(sum);
        let mut after = before;
        for found in group {
            let [i, j] = found.terms.map(usize::from);
            after = after.minus(network.weight(sum[i].cube));
            if i != j {
                after = after.minus(network.weight(sum[j].cube));
            }
            after = after.plus(network.named_weight(found.cofactor));
        }
        add(before, 1);
        add(after, -1);
    }
    gain
}

/// Divisors are a few small numbers: multiplying them is hash enough.
type Hashing = BuildHasherDefault<Multiplying>;

#[derive(Default)]
struct Multiplying(u64);

impl Hasher for Multiplying {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }

    fn write_u64(&mut self, value: u64) {
        self.0 = (self.0.rotate_left(26) ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn write_isize(&mut self, value: isize) {
        self.write_u64(value as u64);
    }
}
