//! The Platonic and Archimedean families: which rotations join the nodes of which solid, in the three
//! patterns of Pugh.

use super::balanced::{Balance, Pattern};
use super::rotations::{Rotations, icosahedral, octahedral, tetrahedral};
use super::structure::length;
use super::{GeneratingMember, Hand, Structure, TensegrityError, generate};
use ga_cga::{DualPlane, Point, Rotor, Vector3};

/// A solid whose edges the cables follow.
///
/// In the *diamond* pattern each strut is the long diagonal of a rhombus of four cables; in the *zigzag*
/// pattern it joins the ends of three cables in a Z, and the solids are the five regular ones truncated;
/// in the *circuit* pattern the struts join in closed polygons (A. Pugh, *An Introduction to Tensegrity*,
/// 1976).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Solid {
    /// Diamond pattern of the tetrahedron: 6 struts, 24 cables; with equal cables the expanded
    /// octahedron.
    Icosahedron,
    /// Diamond pattern of the cube: 12 struts, 48 cables.
    Rhombicuboctahedron,
    /// Diamond pattern of the dodecahedron: 30 struts, 120 cables.
    Rhombicosidodecahedron,
    /// Zigzag pattern: 6 struts, 18 cables.
    TruncatedTetrahedron,
    /// Zigzag pattern: 12 struts, 36 cables.
    TruncatedCube,
    /// Zigzag pattern: 12 struts, 36 cables.
    TruncatedOctahedron,
    /// Zigzag pattern: 30 struts, 90 cables.
    TruncatedDodecahedron,
    /// Zigzag pattern: 30 struts, 90 cables.
    TruncatedIcosahedron,
    /// Circuit pattern: 12 struts in four triangles, 24 cables.
    Cuboctahedron,
    /// Circuit pattern: 30 struts in six pentagons, 60 cables.
    Icosidodecahedron,
}

impl Solid {
    /// All of them.
    pub const ALL: [Solid; 10] = [
        Solid::Icosahedron,
        Solid::Rhombicuboctahedron,
        Solid::Rhombicosidodecahedron,
        Solid::TruncatedTetrahedron,
        Solid::TruncatedCube,
        Solid::TruncatedOctahedron,
        Solid::TruncatedDodecahedron,
        Solid::TruncatedIcosahedron,
        Solid::Cuboctahedron,
        Solid::Icosidodecahedron,
    ];

    /// The name, in lower-case letters and hyphens.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Solid::Icosahedron => "icosahedron",
            Solid::Rhombicuboctahedron => "rhombicuboctahedron",
            Solid::Rhombicosidodecahedron => "rhombicosidodecahedron",
            Solid::TruncatedTetrahedron => "truncated-tetrahedron",
            Solid::TruncatedCube => "truncated-cube",
            Solid::TruncatedOctahedron => "truncated-octahedron",
            Solid::TruncatedDodecahedron => "truncated-dodecahedron",
            Solid::TruncatedIcosahedron => "truncated-icosahedron",
            Solid::Cuboctahedron => "cuboctahedron",
            Solid::Icosidodecahedron => "icosidodecahedron",
        }
    }

    fn rotations(self) -> Result<Rotations, TensegrityError> {
        match self {
            Solid::Icosahedron | Solid::TruncatedTetrahedron => tetrahedral(),
            Solid::Rhombicuboctahedron
            | Solid::TruncatedCube
            | Solid::TruncatedOctahedron
            | Solid::Cuboctahedron => octahedral(),
            Solid::Rhombicosidodecahedron
            | Solid::TruncatedDodecahedron
            | Solid::TruncatedIcosahedron
            | Solid::Icosidodecahedron => icosahedral(),
        }
    }

    /// How the nodes are joined; `None` for the circuits, whose nodes lie on axes.
    fn pattern(self, group: &Rotations) -> Option<Pattern> {
        let Rotations { ab, bc, ac, .. } = *group;
        let diamond = Pattern {
            cables: [ab, bc],
            strut: ac,
        };
        // Around a face by one edge, along the edge between faces, and back around the other face.
        let zigzag = |around: Rotor| Pattern {
            cables: [around, ac],
            strut: around * ac * around.reverse(),
        };
        match self {
            Solid::Icosahedron | Solid::Rhombicuboctahedron | Solid::Rhombicosidodecahedron => {
                Some(diamond)
            }
            Solid::TruncatedTetrahedron
            | Solid::TruncatedOctahedron
            | Solid::TruncatedIcosahedron => Some(zigzag(ab)),
            Solid::TruncatedCube | Solid::TruncatedDodecahedron => Some(zigzag(bc)),
            Solid::Cuboctahedron | Solid::Icosidodecahedron => None,
        }
    }
}

/// A structure on the edges of a solid, in balance.
///
/// ```
/// use ga_design::tensegrity::{Analysis, Polyhedron, Solid, Stability};
///
/// let structure = Polyhedron::of(Solid::TruncatedTetrahedron).structure()?;
/// let analysis = Analysis::of(&structure)?;
/// assert_eq!(analysis.stability, Stability::SuperStable);
/// # Ok::<(), ga_design::tensegrity::TensegrityError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polyhedron {
    /// The solid.
    pub solid: Solid,
    /// The length of a strut.
    pub strut: f64,
    /// The length of the second kind of cables over that of the first. In the diamond pattern the first
    /// kind goes around the faces of p corners, the second around those of q; in the zigzag pattern the
    /// first goes around the faces that truncation makes, the second joins them. Circuits have one kind,
    /// and only 1 is right.
    pub cable_ratio: f64,
    /// Which of two mirror images.
    pub hand: Hand,
}

impl Polyhedron {
    /// The structure on this solid with struts of length one and cables of equal length.
    #[must_use]
    pub const fn of(solid: Solid) -> Self {
        Self {
            solid,
            strut: 1.0,
            cable_ratio: 1.0,
            hand: Hand::Right,
        }
    }

    /// The structure, about the origin: its form is found such that it is in balance.
    ///
    /// # Errors
    /// [`TensegrityError`] if a length is not positive and finite, or there is no balance with this
    /// ratio of cables.
    pub fn structure(&self) -> Result<Structure, TensegrityError> {
        let strut = length("the length of a strut", self.strut)?;
        let ratio = length("the ratio of the cables", self.cable_ratio)?;
        let group = self.solid.rotations()?;
        let members = match self.solid.pattern(&group) {
            Some(pattern) => {
                let Balance { node, .. } = pattern.with_ratio(ratio)?;
                let to = |rotor: Rotor| rotor.apply(node.position());
                members(node.position(), to(pattern.strut), &pattern.cables.map(to))
            }
            None if ratio == 1.0 => circuit(self.solid, &group)?,
            None => {
                return Err(TensegrityError::NoSelfStress {
                    what: "in the circuit pattern all cables are of one kind, and their ratio is 1",
                });
            }
        };
        let mirror = DualPlane::at_distance(Vector3::new(1.0, 0.0, 0.0), 0.0);
        let hand = self.hand;
        generate(group.isometries(), &members)?.moved(|point| {
            let sized = Point::from(point.position() * strut);
            match hand {
                Hand::Right => sized,
                Hand::Left => mirror.apply(sized),
            }
        })
    }
}

fn members(node: Vector3, strut: Vector3, cables: &[Vector3]) -> Vec<GeneratingMember> {
    let node = Point::from(node);
    let cables = cables
        .iter()
        .map(|&to| GeneratingMember::cable(node, Point::from(to)));
    std::iter::once(GeneratingMember::strut(node, Point::from(strut)))
        .chain(cables)
        .collect()
}

/// The members of a circuit: nodes on the axes of the half turns, cables around the faces, and struts
/// that go twice as far around an axis at right angles to the node's.
fn circuit(solid: Solid, group: &Rotations) -> Result<Vec<GeneratingMember>, TensegrityError> {
    let none = TensegrityError::NoSelfStress {
        what: "the group has no axis at right angles to that of a half turn",
    };
    let node = group.ac.axis().ok_or(none)?;
    // The equators are hexagons in the one, decagons in the other: the circuits triangles and pentagons.
    let like = match solid {
        Solid::Icosidodecahedron => group.ab,
        _ => group.bc,
    };
    let around = group.across(like, node).ok_or(none)?;
    let place = around.apply(node);
    let scale = 1.0 / (place - node).norm();
    let cable = group.bc.apply(node);
    Ok(members(node * scale, place * scale, &[cable * scale]))
}
