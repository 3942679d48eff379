//! What must hold of every file whatsoever: read, built, bonded and written without panic or NaN.

use ga_design::crystallography::{Bonding, CellRange, Expansion, SpaceGroup, cif, xyz};

/// Few enough for a test of a file to end at once.
const MOST_ATOMS: u64 = 20_000;

/// Reads a file and does with it what the program does; whatever comes out must be finite, errors
/// must name the file in one line, and what is written must read back the same.
pub fn survives(bytes: &[u8]) {
    let crystal = match cif::read_bytes("f.cif", bytes) {
        Ok(reading) => reading.crystal,
        Err(error) => {
            let message = error.to_string();
            assert!(message.starts_with("f.cif:"), "{message}");
            assert!(!message.contains(['\n', '\r']), "{message}");
            return;
        }
    };
    let written = cif::write(&crystal);
    match cif::read_str("again.cif", &written) {
        Ok(again) => {
            let again = again.crystal;
            assert_eq!(again.cell, crystal.cell, "{written}");
            assert_eq!(again.operations, crystal.operations, "{written}");
            if SpaceGroup::identify(&crystal.operations).is_some() {
                assert_eq!(again.number, crystal.number, "{written}");
                assert_eq!(again.hermann_mauguin, crystal.hermann_mauguin);
            }
            assert_eq!(again.sites.len(), crystal.sites.len(), "{written}");
            for (found, site) in again.sites.iter().zip(&crystal.sites) {
                assert_eq!(found.position(), site.position(), "{written}");
                assert_eq!(found.element, site.element, "{written}");
                assert_eq!(found.occupancy, site.occupancy, "{written}");
            }
        }
        Err(error) => panic!("{error}\n{written}"),
    }
    let expansion = Expansion {
        most_atoms: MOST_ATOMS,
        ..Expansion::default()
    };
    let Ok(atoms) = expansion.unit_cell(&crystal) else {
        return;
    };
    for atom in &atoms {
        assert!(atom.cart.iter().all(|value| value.is_finite()));
        assert!(atom.fract.iter().all(|value| (0.0..1.0).contains(value)));
    }
    for bond in Bonding::default()
        .periodic(&crystal.cell, &atoms)
        .unwrap_or_default()
    {
        assert!(bond.length > 0.0 && bond.atoms.iter().all(|at| *at < atoms.len()));
    }
    let lines = xyz::write(&crystal.name, &crystal.cell, CellRange::UNIT, &atoms);
    assert_eq!(lines.lines().count(), atoms.len() + 2);
    let _ = cif::write_block(&crystal, CellRange::UNIT, &atoms);
}
