//! Each verdict on a structure that deserves it.

use crate::analysed;
use ga_cga::{Motor, Point, Rotor, Translator, Vector3};
use ga_design::crystallography::Isometry;
use ga_design::tensegrity::{
    GeneratingMember, Member, Octahedron, Prism, Role, Stability, Structure, balanced_twist,
    generate,
};

fn octahedron() -> Structure {
    Octahedron::default().structure().expect("a structure")
}

/// The same structure with the roles of some members exchanged.
fn exchanged(structure: &Structure, which: impl Fn(usize) -> bool) -> Structure {
    let members = structure.members().iter().enumerate();
    let members = members.map(|(index, member)| {
        let role = match (which(index), member.role) {
            (false, role) => role,
            (true, Role::Strut) => Role::Cable,
            (true, Role::Cable) => Role::Strut,
        };
        Member { role, ..*member }
    });
    Structure::new(structure.nodes().to_vec(), members.collect()).expect("a structure")
}

#[test]
fn struts_for_cables_and_cables_for_struts_give_way() {
    let analysis = analysed(&exchanged(&octahedron(), |_| true));
    assert!(analysis.is_proper);
    assert_eq!(analysis.stability, Stability::Unstable);
    assert!(analysis.eigenvalues[0] < -0.1);
}

#[test]
fn a_strut_in_place_of_one_cable_leaves_something_slack() {
    let structure = octahedron();
    let analysis = analysed(&exchanged(&structure, |index| index == 7));
    assert_eq!((analysis.states, analysis.is_proper), (1, false));
    assert_eq!(analysis.stability, Stability::Slack);
}

/// All members of several structures, joined where nodes coincide.
fn joined(structures: &[Structure]) -> Structure {
    let members = structures.iter().flat_map(|structure| {
        structure.members().iter().map(|member| {
            let [from, to] = structure.ends(member);
            let role = member.role;
            GeneratingMember { role, from, to }
        })
    });
    let members: Vec<_> = members.collect();
    generate(&[Isometry::from(Motor::identity())], &members).expect("a structure")
}

#[test]
fn prisms_on_each_other_are_stable_but_not_at_any_prestress() {
    let prism = Prism::default();
    let first = prism.structure().expect("a structure");
    let axis = Vector3::new(0.0, 0.0, 1.0);
    let turn = Rotor::about_axis(axis, balanced_twist(3)).expect("a rotor");
    let up = Motor::rigid(turn, Translator::by(axis * prism.height));
    let second = first.moved(|point| up.apply(point)).expect("a structure");
    let structure = joined(&[first, second]);
    assert_eq!(
        (structure.nodes().len(), structure.members().len()),
        (9, 21)
    );
    assert!(!structure.has_free_struts());
    let analysis = analysed(&structure);
    assert_eq!((analysis.states, analysis.mechanisms), (2, 2));
    assert!(analysis.is_proper);
    // Each prism may be deformed affinely on its own as long as the triangle between them stays.
    assert_eq!(analysis.nullity, 5);
    assert_eq!(analysis.stability, Stability::PrestressStable);
}

#[test]
fn two_structures_side_by_side_are_undecided() {
    let first = Prism::default().structure().expect("a structure");
    let aside = Translator::by(Vector3::new(5.0, 0.0, 0.0));
    let second = first
        .moved(|point| aside.apply(point))
        .expect("a structure");
    let analysis = analysed(&joined(&[first, second]));
    // The six motions of one against the other cost nothing.
    assert_eq!((analysis.states, analysis.mechanisms), (2, 8));
    assert_eq!((analysis.is_proper, analysis.nullity), (true, 8));
    assert_eq!(analysis.stability, Stability::Undecided);
}

#[test]
fn a_node_on_two_loose_cables_is_slack() {
    let prism = Prism::default().structure().expect("a structure");
    let mut nodes = prism.nodes().to_vec();
    nodes.push(Point::at(3.0, 1.0, 0.5));
    let mut members = prism.members().to_vec();
    members.extend([0, 1].map(|end| Member {
        role: Role::Cable,
        ends: [end, 6],
        class: 3,
    }));
    let analysis = analysed(&Structure::new(nodes, members).expect("a structure"));
    assert_eq!((analysis.states, analysis.is_proper), (1, false));
    assert_eq!(analysis.stability, Stability::Slack);
}

#[test]
fn verdicts_have_names() {
    let all = [
        Stability::Unstressed,
        Stability::Slack,
        Stability::Unstable,
        Stability::Undecided,
        Stability::PrestressStable,
        Stability::SuperStable,
    ];
    let mut names: Vec<_> = all.iter().map(|verdict| verdict.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all.len());
}
