//! How a group makes a structure of one strut and a few cables: every transformation is applied to
//! their ends, and what coincides is one (3.4, figure 3.9).

use super::structure::{Member, Role, Structure, coincide, size_of};
use super::{MOST_NODES, TensegrityError};
use crate::crystallography::Isometry;
use ga_cga::Point;

/// A strut or a cable of which a group makes the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneratingMember {
    /// What it bears.
    pub role: Role,
    /// One end.
    pub from: Point,
    /// The other end.
    pub to: Point,
}

impl GeneratingMember {
    /// A strut between these points.
    #[must_use]
    pub const fn strut(from: Point, to: Point) -> Self {
        let role = Role::Strut;
        Self { role, from, to }
    }

    /// A cable between these points.
    #[must_use]
    pub const fn cable(from: Point, to: Point) -> Self {
        let role = Role::Cable;
        Self { role, from, to }
    }
}

/// The structure of all images of these members under these transformations; coincident nodes are
/// merged, and so are members between the same nodes. Each generating member makes a class.
///
/// The transformations are those of a whole group, the identity among them: nothing is closed here.
///
/// ```
/// use ga_cga::Point;
/// use ga_design::crystallography::{Isometry, Placement};
/// use ga_design::tensegrity::{GeneratingMember, generate};
///
/// // The three half turns about the axes leave a strut along x three images of itself.
/// let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let group = [vec![], vec![x, y], vec![y, z], vec![z, x]].map(|reflections| {
///     Isometry::from(&Placement { reflections, translation: [0.0; 3] })
/// });
/// let strut = GeneratingMember::strut(Point::at(1.0, 2.0, 3.0), Point::at(1.5, -2.0, 2.0));
/// let structure = generate(&group, &[strut])?;
/// assert_eq!((structure.nodes().len(), structure.struts().count()), (8, 4));
/// # Ok::<(), ga_design::tensegrity::TensegrityError>(())
/// ```
///
/// # Errors
/// [`TensegrityError`] as for [`Structure::new`].
pub fn generate(
    group: &[Isometry],
    members: &[GeneratingMember],
) -> Result<Structure, TensegrityError> {
    let ends: Vec<Point> = members.iter().flat_map(|m| [m.from, m.to]).collect();
    let size = size_of(&ends).max(
        ends.iter()
            .map(|end| end.position().norm())
            .fold(0.0, f64::max),
    );
    let mut nodes: Vec<Point> = Vec::new();
    let mut images: Vec<Member> = Vec::new();
    for (class, member) in members.iter().enumerate() {
        for isometry in group {
            let mut place = |point: Point| {
                let image = isometry.apply(point);
                let known = nodes.iter().position(|&node| coincide(node, image, size));
                known.unwrap_or_else(|| {
                    nodes.push(image);
                    nodes.len() - 1
                })
            };
            let ends = [place(member.from), place(member.to)];
            let image = Member {
                role: member.role,
                ends,
                class,
            };
            let joins_the_same = |other: &Member| {
                other.role == member.role
                    && (other.ends == ends || other.ends == [ends[1], ends[0]])
            };
            if !images.iter().any(joins_the_same) {
                images.push(image);
            }
            // A list that is no group must not make the search above endless.
            if nodes.len() > MOST_NODES {
                return Err(TensegrityError::TooMany {
                    what: "nodes",
                    value: nodes.len(),
                    most: MOST_NODES,
                });
            }
        }
    }
    Structure::new(nodes, images)
}
