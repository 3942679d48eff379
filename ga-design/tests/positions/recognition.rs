//! Whether every space group is recognised in whatever cell and origin it comes, and nothing else
//! is.

use crate::structures::cell_of;
use std::collections::HashSet;

use ga_design::crystallography::{ChangeOfBasis, Operation, SpaceGroup, close};
use moyo::MoyoDataset;
use moyo::base::Cell;
use num_rational::Ratio;

fn operations(group: &SpaceGroup) -> Vec<Operation> {
    group.operations().expect("a Hall symbol of the table")
}

/// Recognised as `number`, and carried from the standard setting by the change that is returned.
fn assert_recognised(given: &[Operation], number: u32, what: &str) {
    let found = SpaceGroup::recognise(given).unwrap_or_else(|| panic!("{what} is not recognised"));
    assert_eq!(found.number, number, "{what}");
    let change = found.from_standard;
    assert!(*change.determinant().numer() > 0, "{what} turns the hand");
    let standard = operations(SpaceGroup::standard(number).expect("1 to 230"));
    let carried = change
        .operations(&standard)
        .unwrap_or_else(|| panic!("{what}: {change} is no change of the group"));
    let carried: HashSet<_> = carried.into_iter().collect();
    assert_eq!(carried, given.iter().copied().collect(), "{what}: {change}");
}

/// A reproducible sequence of small numbers.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: i64) -> i64 {
        // Knuth's multiplier; the high bits are the good ones.
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound as u64) as i64
    }

    /// A unimodular matrix: a product of shears, and a cyclic exchange of the axes.
    fn unimodular(&mut self) -> [[i64; 3]; 3] {
        let mut m = [[0, 1, 0], [0, 0, 1], [1, 0, 0]];
        for _ in 0..3 {
            let from = self.below(3) as usize;
            let to = (from + 1 + self.below(2) as usize) % 3;
            let times = self.below(3) - 1;
            for row in &mut m {
                row[to] += times * row[from];
            }
        }
        m
    }

    fn change(&mut self) -> ChangeOfBasis {
        let linear = self.unimodular().map(|row| row.map(Ratio::from_integer));
        let shift = [0; 3].map(|_| Ratio::new(self.below(24), 24));
        ChangeOfBasis::new(linear, shift).expect("small numbers")
    }
}

#[test]
fn all_558_settings_are_recognised() {
    for group in SpaceGroup::table() {
        let given = operations(group);
        assert_recognised(&given, group.number, &group.qualified_symbol());
        // With another origin they are no setting of the table any more.
        let moved: ChangeOfBasis = "x+1/5,y+1/7,z+1/3".parse().expect("a change");
        let moved = moved.operations(&given).expect("the same cell");
        assert_recognised(&moved, group.number, &group.qualified_symbol());
    }
}

#[test]
fn all_230_groups_are_recognised_in_odd_cells() {
    let mut numbers = Numbers(20);
    let mut unknown = 0;
    for number in 1..=230 {
        let standard = operations(SpaceGroup::standard(number).expect("1 to 230"));
        for round in 0..3 {
            let change = numbers.change();
            let Some(given) = change.operations(&standard) else {
                panic!("{number}: {change}");
            };
            unknown += usize::from(SpaceGroup::identify(&given).is_none());
            assert_recognised(&given, number, &format!("{number} in {change}, {round}"));
        }
    }
    assert!(unknown > 400, "only {unknown} were not in the table");
}

#[test]
fn primitive_cells_and_supercells_are_recognised() {
    let primitive = [
        ("F m -3 m", "1/2y+1/2z,1/2x+1/2z,1/2x+1/2y"),
        (
            "I 41/a m d",
            "-1/2x+1/2y+1/2z,1/2x-1/2y+1/2z,1/2x+1/2y-1/2z",
        ),
        ("C 1 2/c 1", "1/2x+1/2y,-1/2x+1/2y,z"),
        ("R -3 c", "2/3x-1/3y-1/3z,1/3x+1/3y-2/3z,1/3x+1/3y+1/3z"),
        ("F d d 2", "1/2y+1/2z,1/2x+1/2z,1/2x+1/2y"),
        ("P 43 21 2", "2x,2y,2z"),
        ("P 32 2 1", "x+y,-x+2y,5z"),
        ("P 1 21/c 1", "3x,y,2z+x"),
        ("I a -3 d", "2x,2y,2z"),
    ];
    for (symbol, change) in primitive {
        let group = SpaceGroup::from_symbol(symbol).expect("a symbol")[0];
        let change: ChangeOfBasis = change.parse().expect("a change");
        let Some(given) = change.operations(&operations(group)) else {
            panic!("{symbol} has no cell {change}");
        };
        assert_recognised(&given, group.number, symbol);
    }
}

#[test]
fn mirror_images_are_told_apart() {
    let pairs = [
        (76, 78),
        (91, 95),
        (92, 96),
        (144, 145),
        (151, 153),
        (152, 154),
        (169, 170),
        (171, 172),
        (178, 179),
        (180, 181),
        (212, 213),
    ];
    let mirror: ChangeOfBasis = "-x,-y,-z".parse().expect("a change");
    let odd: ChangeOfBasis = "x+y,-z+1/6,y".parse().expect("a change");
    for (left, right) in pairs {
        for (one, other) in [(left, right), (right, left)] {
            let standard = operations(SpaceGroup::standard(one).expect("a number"));
            let image = mirror.operations(&standard).expect("the same cell");
            assert_recognised(&image, other, "the mirror image");
            let Some(odd_image) = odd.operations(&image) else {
                panic!("{one} has no such cell");
            };
            assert_recognised(&odd_image, other, "the mirror image in an odd cell");
        }
    }
    // All others are their own mirror images.
    for number in (1..=230).filter(|n| !pairs.iter().any(|(l, r)| l == n || r == n)) {
        let standard = operations(SpaceGroup::standard(number).expect("a number"));
        let image = mirror.operations(&standard).expect("the same cell");
        assert_recognised(&image, number, "the mirror image");
    }
}

#[test]
fn moyo_recognises_the_same_group_from_atoms() {
    let mut numbers = Numbers(7);
    let sites = [[0.1371, 0.2917, 0.0633], [0.4129, 0.0711, 0.2383]];
    let mut compared = 0;
    for number in (1..=230).step_by(3) {
        let group = SpaceGroup::standard(number).expect("a number");
        let change = numbers.change();
        let given = change.operations(&operations(group)).expect("a cell");
        let cell = cell_of(number);
        let p = change.linear().map(|row| row.map(|v| *v.numer() as f64));
        let columns = [0, 1, 2].map(|j| cell.cartesian(p.map(|row| row[j])));
        let lattice = nalgebra_lattice(columns);
        let mut positions = Vec::new();
        let mut kinds = Vec::new();
        for (kind, site) in sites.iter().enumerate() {
            let site = change.to_new(*site);
            for operation in &given {
                let image = operation.apply(site);
                positions.push(image.map(|value| value.rem_euclid(1.0)).into());
                kinds.push(kind as i32);
            }
        }
        let atoms = Cell::new(lattice, positions, kinds);
        let theirs = MoyoDataset::with_default(&atoms, 1e-4).expect("a crystal");
        assert_eq!(theirs.number, number as i32, "the atoms have more symmetry");
        assert_recognised(&given, theirs.number as u32, "from atoms");
        compared += 1;
    }
    assert_eq!(compared, 77);
}

/// moyo takes the edge vectors as columns.
fn nalgebra_lattice(columns: [[f64; 3]; 3]) -> moyo::base::Lattice {
    let [a, b, c] = columns;
    moyo::base::Lattice::from_basis([a, b, c])
}

#[test]
fn what_is_no_group_is_not_recognised() {
    assert_eq!(SpaceGroup::recognise(&[]), None);
    let read = |text: &str| -> Operation { text.parse().expect("an operation") };
    // Not closed: the square of the screw is missing.
    let open = [Operation::IDENTITY, read("-y,x,z+1/4")];
    assert_eq!(SpaceGroup::recognise(&open), None);
    // Endless: a shear.
    let shear = [Operation::IDENTITY, read("x+y,y,z")];
    assert_eq!(SpaceGroup::recognise(&shear), None);
    // Without the identity.
    assert_eq!(SpaceGroup::recognise(&[read("-x,-y,-z")]), None);
    // Twice the same operation does no harm.
    let twice = [Operation::IDENTITY, read("-x,-y,-z"), read("-x,-y,-z")];
    assert_eq!(
        SpaceGroup::recognise(&twice).map(|found| found.number),
        Some(2)
    );
    let closed = close(&open).expect("a finite group");
    assert_eq!(
        SpaceGroup::recognise(&closed).map(|found| found.number),
        Some(76)
    );
}
