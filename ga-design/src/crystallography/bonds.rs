//! Decides which atoms are bonded: those about as close as their covalent radii say, where nothing
//! stands between them and nothing nearer to them in kind is bonded instead.

use super::{Atom, Cell, Element};

mod choice;
mod neighbours;

use choice::{Candidate, Kind};
use neighbours::Neighbourhood;

/// The most candidates for each atom. Close packing needs a dozen; what has hundreds is no crystal,
/// and looking between all of them would take hours.
const MOST_CANDIDATES: usize = 100;

/// How much farther a hydrogen and a metal may be apart.
const HYDRIDE: f64 = 1.1;

/// Two atoms of a crystal that are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    /// The atoms, as positions in the list; the first is not after the second.
    pub atoms: [usize; 2],
    /// The cell, in whole edges, in which the second atom lies: `[0, 0, 0]` when the bond stays
    /// among the atoms as listed.
    pub image: [i32; 3],
    /// The distance in ångström.
    pub length: f64,
}

/// How bonds are found.
///
/// Candidates are pairs whose distance is from [`Bonding::nearest`] to [`Bonding::farthest`] times
/// the sum of their covalent radii ([`Element::covalent_radius`], after Cordero and others). Of
/// these
///
/// 1. a pair with a non-metal other than hydrogen is bonded,
/// 2. a hydrogen and a metal are, where the hydrogen has no bond by the first rule; for them the
///    greatest distance is a tenth more, since the ion H⁻ of a salt is larger than hydrogen else,
/// 3. two metals, and two hydrogens, are where neither has a bond by the rules before: metals that
///    share the oxygens of an oxide touch these rather than each other,
///
/// but never where a third atom, a candidate to both, stands between them: within the ball whose
/// diameter the bond would be, as the oxygen of a sulfate does between its sulfur and a barium.
/// Atoms of unknown element have no bonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bonding {
    /// The least distance over the sum of the radii (0.6): what is nearer are alternative
    /// positions of disordered atoms.
    pub nearest: f64,
    /// The greatest distance over the sum of the radii (1.2): octahedra of large ions are
    /// complete, second neighbours are not reached.
    pub farthest: f64,
}

/// Why bonds cannot be found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BondError {
    /// More atoms within the length of a bond than any crystal has.
    #[error(
        "the atoms crowd: thousands lie within the length of a bond; check the cell, or leave the \
         bonds out"
    )]
    Crowded,
    /// An atom is nowhere, or too far from the others.
    #[error("the atom at position {0} of the list has no place within a million ångström")]
    Place(usize),
}

impl Default for Bonding {
    fn default() -> Self {
        Self {
            nearest: 0.6,
            farthest: 1.2,
        }
    }
}

impl Bonding {
    /// The bonds of a crystal from the atoms of one unit cell, those across its faces included;
    /// each once, in the order of their first atoms.
    ///
    /// ```
    /// use ga_design::crystallography::{Bonding, Expansion, bonds::coordination, cif};
    ///
    /// let text = include_str!("../../data/cif/diamond.cif");
    /// let crystal = cif::read_str("diamond.cif", text)?.crystal;
    /// let atoms = Expansion::default().unit_cell(&crystal)?;
    /// let bonds = Bonding::default().periodic(&crystal.cell, &atoms)?;
    /// assert_eq!(bonds.len(), 16);
    /// assert_eq!(coordination(&bonds, atoms.len()), [4; 8]);
    /// assert!(bonds.iter().all(|bond| (bond.length - 1.5445).abs() < 1e-3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BondError`] where atoms crowd as in no crystal.
    pub fn periodic(&self, cell: &Cell, atoms: &[Atom]) -> Result<Vec<Bond>, BondError> {
        let positions: Vec<[f64; 3]> = atoms.iter().map(|atom| atom.fract).collect();
        self.find(*cell, &positions, atoms)
    }

    /// The bonds among listed atoms only, wherever they stand; every [`Bond::image`] is zero.
    ///
    /// # Errors
    /// [`BondError`] where atoms crowd as in no crystal.
    pub fn between(&self, atoms: &[Atom]) -> Result<Vec<Bond>, BondError> {
        // A box with so much room around the atoms that none is near the image of another.
        let room = 2.0 * self.reach(atoms) + 1.0;
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for atom in atoms {
            for ((low, high), value) in low.iter_mut().zip(&mut high).zip(atom.cart) {
                *low = low.min(value);
                *high = high.max(value);
            }
        }
        if atoms.is_empty() {
            return Ok(Vec::new());
        }
        let edges = [0, 1, 2].map(|i| high[i] - low[i] + room);
        let Ok(cell) = Cell::new(edges, [90.0; 3]) else {
            return Err(BondError::Place(0));
        };
        let place = |atom: &Atom| [0, 1, 2].map(|i| (atom.cart[i] - low[i]) / edges[i]);
        let positions: Vec<[f64; 3]> = atoms.iter().map(place).collect();
        self.find(cell, &positions, atoms)
    }

    /// The longest that a bond between any two of the atoms can be.
    fn reach(&self, atoms: &[Atom]) -> f64 {
        let mut present: Vec<Element> = Vec::new();
        for atom in atoms {
            if !present.contains(&atom.element) {
                present.push(atom.element);
            }
        }
        let known = present
            .iter()
            .filter(|element| **element != Element::UNKNOWN);
        let largest = known
            .map(|element| element.covalent_radius())
            .fold(0.0, f64::max);
        2.0 * self.farthest.max(0.0) * largest
    }

    fn find(
        &self,
        cell: Cell,
        positions: &[[f64; 3]],
        atoms: &[Atom],
    ) -> Result<Vec<Bond>, BondError> {
        let reach = self.reach(atoms);
        // Without a length there is no bond; NaN counts as none.
        if reach.is_nan() || reach <= 0.0 {
            return Ok(Vec::new());
        }
        let neighbourhood = Neighbourhood::new(cell, positions, reach)?;
        let most = MOST_CANDIDATES * atoms.len();
        let mut candidates = Vec::new();
        neighbourhood.pairs(|bond| {
            let [Some(one), Some(other)] = bond.atoms.map(|at| atoms.get(at)) else {
                return;
            };
            let has_room = candidates.len() <= most;
            if has_room && self.allows(one.element, other.element, bond.length) {
                let kinds = [one, other].map(|atom| Kind::of(atom.element));
                candidates.push(Candidate { bond, kinds });
            }
        })?;
        if candidates.len() > most {
            return Err(BondError::Crowded);
        }
        Ok(choice::bonds(&neighbourhood, atoms.len(), candidates))
    }

    fn allows(&self, one: Element, other: Element, distance: f64) -> bool {
        let sum = one.covalent_radius() + other.covalent_radius();
        let stretch = match [one, other].map(Kind::of) {
            [Kind::Hydrogen, Kind::Metal] | [Kind::Metal, Kind::Hydrogen] => HYDRIDE,
            _ => 1.0,
        };
        one != Element::UNKNOWN
            && other != Element::UNKNOWN
            && (self.nearest * sum..=self.farthest * stretch * sum).contains(&distance)
    }
}

/// How many neighbours each of `atoms` atoms is bonded to: its coordination number.
///
/// A bond of an atom with its own image in another cell counts twice, once for each end.
pub fn coordination(bonds: &[Bond], atoms: usize) -> Vec<usize> {
    let mut counts = vec![0; atoms];
    for bond in bonds {
        for at in bond.atoms {
            if let Some(count) = counts.get_mut(at) {
                *count += 1;
            }
        }
    }
    counts
}
