//! Structures of struts and cables, against the numbers of the literature and against statics done by
//! hand.

mod balance;
mod failures;
mod families;
mod generation;
mod stability;
mod towers;

use ga_cga::Vector3;
use ga_design::tensegrity::{Analysis, Structure};

/// The largest sum of forces at a node, from the force densities and the nodes alone.
fn unbalanced(structure: &Structure, densities: &[f64]) -> f64 {
    let zero = Vector3::new(0.0, 0.0, 0.0);
    let mut sums = vec![zero; structure.nodes().len()];
    for (member, density) in structure.members().iter().zip(densities) {
        let [from, to] = structure.ends(member).map(|end| end.position());
        sums[member.ends[0]] += (to - from) * *density;
        sums[member.ends[1]] += (from - to) * *density;
    }
    sums.iter().map(|sum| sum.norm()).fold(0.0, f64::max)
}

/// The analysis of a structure, after what every analysis must fulfil has been checked: balance at each
/// node, Maxwell's count, the kernel of the stress matrix.
fn analysed(structure: &Structure) -> Analysis {
    let analysis = Analysis::of(structure).expect("an analysis");
    let (members, nodes) = (structure.members().len(), structure.nodes().len());
    // Maxwell and Calladine: states − mechanisms = members − 3 nodes + 6.
    assert_eq!(
        analysis.states + 3 * nodes,
        analysis.mechanisms + members + 6
    );
    if analysis.states > 0 {
        assert_eq!(analysis.force_densities.len(), members);
        let size = structure.nodes().iter().map(|node| node.position().norm());
        let size = size.fold(0.0, f64::max);
        assert!(unbalanced(structure, &analysis.force_densities) < 1e-11 * size);
        assert!(analysis.residual(structure) < 1e-11);
        let struts = structure.struts().count();
        let mean = analysis.force_densities[..struts].iter().sum::<f64>() / struts as f64;
        assert!((mean + 1.0).abs() < 1e-12, "{mean}");
        // Translations and the three coordinates themselves are always in it.
        assert!(analysis.nullity >= 4);
        assert_eq!(analysis.eigenvalues.len(), nodes);
    } else {
        assert!(analysis.force_densities.is_empty() && analysis.eigenvalues.is_empty());
    }
    analysis
}
