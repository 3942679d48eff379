//! Decides what a tensegrity is made of: nodes, and struts and cables between pairs of them.

use super::TensegrityError;
use ga_cga::Point;

/// The most nodes that a structure may have: enough for the sixty of the icosahedral ones several times
/// over, and few enough for dense linear algebra.
pub const MOST_NODES: usize = 240;

/// The most members that a structure may have.
pub const MOST_MEMBERS: usize = 960;

/// Nodes closer than this part of the structure's size are one node.
const COINCIDENT: f64 = 1e-9;

/// Nodes farther than this from the origin are refused: the coordinates of a point are squared.
const FARTHEST: f64 = 1e12;

/// What a member bears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// Compression: it keeps its ends from coming closer.
    Strut,
    /// Tension: it keeps its ends from going farther apart.
    Cable,
}

impl Role {
    /// The sign of the force density that it can bear: positive in tension.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Role::Strut => -1.0,
            Role::Cable => 1.0,
        }
    }
}

/// A strut or a cable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Member {
    /// What it bears.
    pub role: Role,
    /// The nodes that it joins, as positions in the list of nodes.
    pub ends: [usize; 2],
    /// Which generating member it is an image of: members of one class are alike.
    pub class: usize,
}

/// Nodes, struts and cables; every number has been checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    nodes: Vec<Point>,
    members: Vec<Member>,
}

impl Structure {
    /// The structure of these nodes and members; the struts are listed first, in their order, then the
    /// cables in theirs.
    ///
    /// # Errors
    /// [`TensegrityError`] if a coordinate is not finite, there are too many nodes or members or fewer
    /// than three struts, a member names a node that is not there, or joins nodes that coincide.
    pub fn new(nodes: Vec<Point>, members: Vec<Member>) -> Result<Self, TensegrityError> {
        let count = |what, value, most| {
            if value > most {
                Err(TensegrityError::TooMany { what, value, most })
            } else {
                Ok(())
            }
        };
        count("nodes", nodes.len(), MOST_NODES)?;
        count("members", members.len(), MOST_MEMBERS)?;
        for point in &nodes {
            for value in point.position().to_array() {
                finite("a coordinate of a node", value)?;
            }
        }
        let near = size_of(&nodes) * COINCIDENT;
        for member in &members {
            let [Some(from), Some(to)] = member.ends.map(|end| nodes.get(end)) else {
                return Err(TensegrityError::NoSuchNode {
                    ends: member.ends,
                    nodes: nodes.len(),
                });
            };
            // Written so that a NaN fails it too.
            let apart = from.distance(*to) > near;
            if !apart {
                return Err(TensegrityError::NoLength { ends: member.ends });
            }
        }
        let struts = members.iter().filter(|m| m.role == Role::Strut).count();
        if struts < 3 {
            return Err(TensegrityError::FewStruts { value: struts });
        }
        let mut members = members;
        members.sort_by_key(|member| member.role);
        Ok(Self { nodes, members })
    }

    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &[Point] {
        &self.nodes
    }

    /// The members, struts first.
    #[must_use]
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// The struts.
    pub fn struts(&self) -> impl Iterator<Item = &Member> {
        self.members.iter().filter(|m| m.role == Role::Strut)
    }

    /// The cables.
    pub fn cables(&self) -> impl Iterator<Item = &Member> {
        self.members.iter().filter(|m| m.role == Role::Cable)
    }

    /// The node at this position of the list; the origin for one that is not there.
    pub(super) fn node(&self, index: usize) -> Point {
        let none = || Point::at(0.0, 0.0, 0.0);
        self.nodes.get(index).copied().unwrap_or_else(none)
    }

    /// The points that a member joins.
    #[must_use]
    pub fn ends(&self, member: &Member) -> [Point; 2] {
        member.ends.map(|end| self.node(end))
    }

    /// The length of a member.
    #[must_use]
    pub fn length(&self, member: &Member) -> f64 {
        let [from, to] = self.ends(member);
        from.distance(to)
    }

    /// The number of classes of members.
    #[must_use]
    pub fn classes(&self) -> usize {
        let classes = self.members.iter().map(|member| member.class);
        classes.max().map_or(0, |last| last.saturating_add(1))
    }

    /// Whether no two struts share a node: “class 1” in the words of Skelton and de Oliveira,
    /// *Tensegrity Systems* (2009).
    #[must_use]
    pub fn has_free_struts(&self) -> bool {
        let mut seen = vec![false; self.nodes.len()];
        let mut ends = self.struts().flat_map(|strut| strut.ends);
        ends.all(|end| {
            seen.get_mut(end)
                .is_some_and(|taken| !std::mem::replace(taken, true))
        })
    }

    /// The same structure with every node moved.
    ///
    /// # Errors
    /// [`TensegrityError`] if a node is moved out of range, or two ends of a member together.
    pub fn moved(&self, motion: impl Fn(Point) -> Point) -> Result<Self, TensegrityError> {
        let nodes = self.nodes.iter().map(|&point| motion(point)).collect();
        Self::new(nodes, self.members.clone())
    }
}

/// The largest distance of a node from the first one.
pub(super) fn size_of(nodes: &[Point]) -> f64 {
    let Some(first) = nodes.first() else {
        return 0.0;
    };
    nodes
        .iter()
        .map(|node| node.distance(*first))
        .fold(0.0, f64::max)
}

/// Whether two points of a structure of this size are one.
pub(super) fn coincide(one: Point, other: Point, size: f64) -> bool {
    one.distance(other) <= size * COINCIDENT
}

/// The number, if it is finite and not too large.
pub(super) fn finite(what: &'static str, value: f64) -> Result<f64, TensegrityError> {
    // Written so that a NaN fails it too.
    let fits = value.abs() <= FARTHEST;
    if fits {
        Ok(value)
    } else {
        Err(TensegrityError::Number {
            what,
            value,
            range: "finite and at most 1e12 in size",
        })
    }
}

/// The length, if it is positive, finite, and neither too small nor too large.
pub(super) fn length(what: &'static str, value: f64) -> Result<f64, TensegrityError> {
    if (1.0 / FARTHEST..=FARTHEST).contains(&value) {
        Ok(value)
    } else {
        Err(TensegrityError::Number {
            what,
            value,
            range: "from 1e-12 to 1e12",
        })
    }
}
