//! Which directions of a crystal system the places of a Hermann–Mauguin symbol speak of
//! (*International Tables* A, table 2.1.3.1).

use super::direction::Direction;
use super::lattice::CrystalSystem;

/// One class of equivalent directions for each place, on conventional axes: b unique in
/// monoclinic, hexagonal ones in trigonal crystals. A rhombohedral lattice has the first two.
pub fn symmetry_directions(system: CrystalSystem) -> &'static [&'static [Direction]] {
    const EDGES: [&[Direction]; 3] = [&[[1, 0, 0]], &[[0, 1, 0]], &[[0, 0, 1]]];
    const SQUARE: [&[Direction]; 3] = [
        &[[0, 0, 1]],
        &[[1, 0, 0], [0, 1, 0]],
        &[[1, -1, 0], [1, 1, 0]],
    ];
    const HEXAGON: [&[Direction]; 3] = [
        &[[0, 0, 1]],
        &[[1, 0, 0], [0, 1, 0], [1, 1, 0]],
        &[[1, -1, 0], [1, 2, 0], [2, 1, 0]],
    ];
    const CUBE: [&[Direction]; 3] = [
        &[[0, 0, 1], [0, 1, 0], [1, 0, 0]],
        &[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]],
        &[
            [1, -1, 0],
            [1, 1, 0],
            [0, 1, -1],
            [0, 1, 1],
            [1, 0, -1],
            [1, 0, 1],
        ],
    ];
    match system {
        CrystalSystem::Triclinic => &[],
        CrystalSystem::Monoclinic => &[EDGES[1]],
        CrystalSystem::Orthorhombic => &EDGES,
        CrystalSystem::Tetragonal => &SQUARE,
        CrystalSystem::Trigonal | CrystalSystem::Hexagonal => &HEXAGON,
        CrystalSystem::Cubic => &CUBE,
    }
}
