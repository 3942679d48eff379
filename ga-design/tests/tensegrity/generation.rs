//! What groups make of a strut: images in general and in special position (figure 3.8), merged where
//! they coincide.

use crate::analysed;
use ga_cga::Point;
use ga_design::crystallography::PointGroup;
use ga_design::tensegrity::{GeneratingMember, Role, Structure, TensegrityError, generate};

fn generated(group: &str, members: &[GeneratingMember]) -> Result<Structure, TensegrityError> {
    let group = PointGroup::from_geometric(group).expect("a group");
    generate(group.transformations(), members)
}

#[test]
fn a_strut_in_general_position_has_as_many_images_as_the_group_elements() {
    let strut = GeneratingMember::strut(Point::at(1.0, 0.2, 0.4), Point::at(0.3, 1.1, -0.7));
    for (group, order) in [
        ("b(3)b(3)", 12),
        ("b(4)b(3)", 24),
        ("b(5)b(3)", 60),
        ("33", 24),
        ("43", 48),
    ] {
        let structure = generated(group, &[strut]).expect(group);
        assert_eq!(structure.struts().count(), order, "{group}");
        assert_eq!(structure.nodes().len(), 2 * order, "{group}");
        assert_eq!(structure.classes(), 1);
    }
}

#[test]
fn a_strut_across_an_axis_of_half_turns_has_half_as_many() {
    // The half turn ac about e₂ exchanges these ends.
    let strut = GeneratingMember::strut(Point::at(0.4, 0.6, 0.5), Point::at(-0.4, 0.6, -0.5));
    for (group, count) in [("b(3)b(3)", 6), ("b(4)b(3)", 12), ("b(5)b(3)", 30)] {
        let structure = generated(group, &[strut]).expect(group);
        assert_eq!(structure.struts().count(), count, "{group}");
        assert_eq!(structure.nodes().len(), 2 * count, "{group}");
    }
}

#[test]
fn the_images_are_all_alike() {
    let from = Point::at(1.0, 0.2, 0.4);
    let members = [
        GeneratingMember::strut(from, Point::at(-1.0, 0.5, -0.2)),
        GeneratingMember::cable(from, Point::at(0.2, 1.0, 0.3)),
    ];
    let structure = generated("b(4)b(3)", &members).expect("a structure");
    for (class, role, length) in [(0, Role::Strut, members[0]), (1, Role::Cable, members[1])]
        .map(|(class, role, member)| (class, role, member.from.distance(member.to)))
    {
        let mut count = 0;
        for member in structure.members().iter().filter(|m| m.class == class) {
            assert_eq!(member.role, role);
            assert!((structure.length(member) - length).abs() < 1e-12);
            count += 1;
        }
        assert_eq!(count, 24);
    }
    // Struts come first, and nothing is tightened in such a loose heap.
    assert_eq!(structure.members()[0].role, Role::Strut);
    analysed(&structure);
}

#[test]
fn coincident_nodes_are_merged_far_away_too() {
    for size in [1e-6, 1.0, 1e6] {
        let at = |x: f64, y: f64, z: f64| Point::at(size * x, size * y, size * z);
        let strut = GeneratingMember::strut(at(0.4, 0.6, 0.5), at(-0.4, 0.6, -0.5));
        let cable = GeneratingMember::cable(at(0.4, 0.6, 0.5), at(0.9, 0.1, 0.3));
        let structure = generated("b(4)b(3)", &[strut, cable]).expect("a structure");
        assert_eq!(structure.struts().count(), 12, "{size}");
    }
}
