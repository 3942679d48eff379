//! Which candidates are bonds: by the kinds of their atoms, and by what stands between them.

use super::super::Element;
use super::Bond;
use super::neighbours::Neighbourhood;

/// What decides how an element is bonded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Hydrogen,
    NonMetal,
    Metal,
}

impl Kind {
    pub fn of(element: Element) -> Self {
        match element.number() {
            1 => Self::Hydrogen,
            // Helium, boron to neon, silicon to argon, germanium to krypton, antimony to xenon,
            // astatine and radon: half-metals are bonded as non-metals are.
            2 | 5..=10 | 14..=18 | 32..=36 | 51..=54 | 85 | 86 => Self::NonMetal,
            _ => Self::Metal,
        }
    }
}

/// A pair at the distance of a bond.
pub struct Candidate {
    pub bond: Bond,
    pub kinds: [Kind; 2],
}

/// The rules in their order, as the documentation of `Bonding` numbers them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rule {
    NonMetal,
    Hydride,
    Alike,
}

impl Candidate {
    fn rule(&self) -> Rule {
        match self.kinds {
            [Kind::NonMetal, _] | [_, Kind::NonMetal] => Rule::NonMetal,
            [one, other] if one == other => Rule::Alike,
            _ => Rule::Hydride,
        }
    }

    /// Whether the rule joins the pair, given which atoms the rules before it have joined.
    fn is_free(&self, joined: &[bool]) -> bool {
        let rule = self.rule();
        let mut ends = self.bond.atoms.iter().zip(self.kinds);
        ends.all(|(at, kind)| {
            let is_free = joined.get(*at).is_some_and(|joined| !joined);
            match rule {
                Rule::NonMetal => true,
                Rule::Hydride => is_free || kind == Kind::Metal,
                Rule::Alike => is_free,
            }
        })
    }
}

/// The bonds among the candidates, in their order.
pub fn bonds(near: &Neighbourhood, atoms: usize, mut candidates: Vec<Candidate>) -> Vec<Bond> {
    let around = Around::new(atoms, &candidates);
    candidates.retain(|candidate| !around.parts(near, &candidate.bond));
    let mut joined = vec![false; atoms];
    let mut kept = vec![false; candidates.len()];
    for rule in [Rule::NonMetal, Rule::Hydride, Rule::Alike] {
        // A rule looks at what those before it have joined, not at its own bonds.
        let before = joined.clone();
        for (candidate, kept) in candidates.iter().zip(&mut kept) {
            *kept |= candidate.rule() == rule && candidate.is_free(&before);
            if *kept {
                for at in candidate.bond.atoms {
                    if let Some(mark) = joined.get_mut(at) {
                        *mark = true;
                    }
                }
            }
        }
    }
    let chosen = candidates.into_iter().zip(kept);
    chosen
        .filter_map(|(candidate, kept)| kept.then_some(candidate.bond))
        .collect()
}

/// The candidates of each atom, seen from it.
struct Around {
    /// Where those of each atom begin in `ends`, and the end.
    starts: Vec<usize>,
    ends: Vec<End>,
}

#[derive(Clone, Copy, Default)]
struct End {
    other: usize,
    image: [i32; 3],
    length: f64,
}

impl Around {
    fn new(atoms: usize, candidates: &[Candidate]) -> Self {
        let both = |bond: &Bond| {
            let [one, other] = bond.atoms;
            let Bond { image, length, .. } = *bond;
            let there = End {
                other,
                image,
                length,
            };
            let back = End {
                other: one,
                image: image.map(|step| -step),
                length,
            };
            [(one, there), (other, back)]
        };
        let mut starts = vec![0; atoms + 1];
        for (at, _) in candidates.iter().flat_map(|one| both(&one.bond)) {
            if let Some(next) = starts.get_mut(at + 1) {
                *next += 1;
            }
        }
        for at in 1..starts.len() {
            starts[at] += starts[at - 1];
        }
        let mut free = starts.clone();
        let mut ends = vec![End::default(); 2 * candidates.len()];
        for (at, end) in candidates.iter().flat_map(|one| both(&one.bond)) {
            if let Some(place) = free.get_mut(at) {
                if let Some(slot) = ends.get_mut(*place) {
                    *slot = end;
                }
                *place += 1;
            }
        }
        Self { starts, ends }
    }

    fn of(&self, atom: usize) -> &[End] {
        match (self.starts.get(atom), self.starts.get(atom + 1)) {
            (Some(from), Some(to)) => self.ends.get(*from..*to).unwrap_or_default(),
            _ => &[],
        }
    }

    /// Whether a candidate to both ends stands between them: sees them under an obtuse angle.
    fn parts(&self, near: &Neighbourhood, bond: &Bond) -> bool {
        let [one, other] = bond.atoms;
        let square = bond.length * bond.length * (1.0 - 1e-9);
        self.of(one).iter().any(|middle| {
            if middle.length >= bond.length {
                return false;
            }
            let image = [0, 1, 2].map(|i| bond.image[i] - middle.image[i]);
            let rest = near.distance(middle.other, other, image);
            let onward = |end: &End| end.other == other && end.image == image;
            middle.length * middle.length + rest * rest < square
                && self.of(middle.other).iter().any(onward)
        })
    }
}
