//! Whether the atoms of made-up structures lie on the positions that the program moyo finds for
//! them, after it has recognised the group from the atoms alone.

use ga_design::crystallography::{Cell, SpaceGroup, WyckoffPositions};
use moyo::MoyoDataset;
use moyo::base::{AngleTolerance, Cell as Atoms, Lattice};
use moyo::data::Setting;

/// A cell that a group of this number can have in its standard setting.
pub fn cell_of(number: u32) -> Cell {
    let (edges, angles) = match number {
        1..=2 => ([8.1, 9.3, 10.7], [83.0, 97.0, 101.0]),
        3..=15 => ([8.1, 9.3, 10.7], [90.0, 101.0, 90.0]),
        16..=74 => ([8.1, 9.3, 10.7], [90.0; 3]),
        75..=142 => ([8.1, 8.1, 10.7], [90.0; 3]),
        143..=194 => ([8.1, 8.1, 10.7], [90.0, 90.0, 120.0]),
        _ => ([8.1; 3], [90.0; 3]),
    };
    Cell::new(edges, angles).expect("a cell")
}

#[test]
fn atoms_of_every_group_are_on_the_positions_that_moyo_finds() {
    let (mut special, mut compared) = (0, 0);
    for number in 1..=230 {
        let group = SpaceGroup::standard(number).expect("1 to 230");
        let all = WyckoffPositions::standard(number).expect("1 to 230");
        let operations = group.operations().expect("a Hall symbol");
        // One kind of atom on a general position, which alone gives the group away, and one on a
        // special position, another for each group.
        let mut positions = Vec::new();
        let mut kinds = Vec::new();
        let general = operations.iter().map(|o| o.apply([0.1371, 0.2917, 0.0633]));
        let positions_of_group = all.positions();
        let chosen = &positions_of_group[number as usize % positions_of_group.len()];
        let sites = chosen
            .coordinates()
            .iter()
            .map(|c| c.at([0.2129, 0.0711, 0.3383]));
        for (kind, place) in general.map(|p| (1, p)).chain(sites.map(|p| (2, p))) {
            positions.push(place.map(|value| value.rem_euclid(1.0)).into());
            kinds.push(kind);
        }
        let cell = cell_of(number);
        let lattice = Lattice::from_basis(cell.edge_vectors());
        let atoms = Atoms::new(lattice, positions, kinds);
        let found = MoyoDataset::new(
            &atoms,
            1e-4,
            AngleTolerance::default(),
            Setting::Standard,
            false,
        )
        .unwrap_or_else(|e| panic!("{number}: {e}"));
        assert_eq!(found.number, number as i32, "the atoms have more symmetry");
        // moyo names its letters in its standard cell, at an origin of its own choice.
        let inverse = found.std_linear.try_inverse().expect("a cell");
        for (i, place) in atoms.positions.iter().enumerate() {
            let standard = inverse * (place - found.std_origin_shift);
            let standard = [standard[0], standard[1], standard[2]];
            let site = all.locate(standard, &cell, 1e-3).expect("a place");
            let ours = (site.position.letter, site.position.site_symmetry.as_str());
            let theirs = (found.wyckoffs[i], found.site_symmetry_symbols[i].as_str());
            assert_eq!(ours, theirs, "atom {i} of group {number} at {standard:?}");
            compared += 1;
            special += usize::from(site.position.dimension() < 3);
        }
    }
    assert!(compared > 6000 && special > 1000, "{special} of {compared}");
}
