//! The crystals that come with the library.

/// Their files.
pub const SHIPPED: [&str; 7] = [
    include_str!("../../data/cif/quartz.cif"),
    include_str!("../../data/cif/diamond.cif"),
    include_str!("../../data/cif/halite.cif"),
    include_str!("../../data/cif/rutile.cif"),
    include_str!("../../data/cif/calcite.cif"),
    include_str!("../../data/cif/pyrite.cif"),
    include_str!("../../data/cif/spinel.cif"),
];
