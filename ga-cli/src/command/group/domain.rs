//! Decides what is told of the fundamental domain of a group, and how it is drawn: in glass, its edges
//! as rods.

use super::motif::{Outline, Part};
use super::scene::Placed;
use crate::failure::Failure;
use ga_cga::{Point, Vector3};
use ga_design::crystallography::{
    Cell, FundamentalDomain, FundamentalDomainError, Isometry, Operation,
};
use ga_design::mesh::{self, Ends, Mesh, MeshError};
use serde::Serialize;

/// The colour of the glass and of its edges.
const GLASS: [u8; 3] = [96, 178, 168];
const EDGE: [u8; 3] = [42, 110, 104];

/// How much of what is behind it the glass hides.
const OPACITY: f64 = 0.28;

/// The radius of the rods over the cube root of the volume.
const ROD: f64 = 0.012;

/// Corners nearer than this part of the cube root of the volume are one.
const SAME: f64 = 1e-7;

/// A part of space that the group repeats to fill all of it, as JSON tells it.
#[derive(Debug, Serialize)]
pub struct Domain {
    /// The point in it that all of it is nearer to than to any image, in fractions of the edges.
    pub seed: [f64; 3],
    /// In cubic ångström: that of the cell over the number of its operations.
    pub volume: f64,
    /// The faces.
    pub faces: Vec<Face>,
    /// The corners.
    pub vertices: Vec<Vertex>,
}

/// A face of a domain, in the plane of the points x with normal · x = distance.
#[derive(Debug, Serialize)]
pub struct Face {
    /// Outward, of length 1.
    pub normal: [f64; 3],
    /// From the origin, in ångström.
    pub distance: f64,
    /// Its corners by their places in the list, from 0, anticlockwise seen from outside.
    pub vertices: Vec<usize>,
    /// The operation that makes the neighbour on the other side,
    pub operation: String,
    /// and the edges by which it is moved after that.
    pub cell: [i32; 3],
}

/// A corner of a domain.
#[derive(Debug, Serialize)]
pub struct Vertex {
    /// In fractions of the edges.
    pub fract: [f64; 3],
    /// In ångström.
    pub cart: [f64; 3],
}

/// The domain about a point in fractions of the edges; about another one if that is on a symmetry element.
pub fn find(
    operations: &[Operation],
    cell: &Cell,
    about: [f64; 3],
) -> Result<FundamentalDomain, Failure> {
    let found = match FundamentalDomain::about(operations, cell, about) {
        Err(FundamentalDomainError::Special(_)) => FundamentalDomain::of(operations, cell),
        found => found,
    };
    found.map_err(|reason| Failure::Usage(format!("--domain: {reason}")))
}

/// What is told of it.
pub fn described(domain: &FundamentalDomain, operations: &[Operation], cell: &Cell) -> Domain {
    let mut corners = Corners::of(domain);
    let faces = domain.faces().iter().map(|face| Face {
        normal: face.plane.normal().to_array(),
        // A plane of unit weight has a distance.
        distance: face.plane.distance_from_origin().unwrap_or_default(),
        vertices: face.corners.iter().map(|at| corners.index(*at)).collect(),
        operation: operations
            .get(face.operation)
            .map_or_else(String::new, ToString::to_string),
        cell: face.cell,
    });
    let faces = faces.collect();
    let vertices = corners.found.iter().map(|corner| {
        let cart = corner.to_array();
        Vertex {
            fract: cell.fractional(cart),
            cart,
        }
    });
    Domain {
        seed: cell.fractional(domain.seed().position().to_array()),
        volume: domain.volume(),
        faces,
        vertices: vertices.collect(),
    }
}

/// The glass and the rods along its edges.
pub fn parts(domain: &FundamentalDomain) -> Result<[Placed; 2], MeshError> {
    let edges = edges(domain);
    let radius = ROD * domain.volume().cbrt();
    let rods: Result<Vec<Mesh>, MeshError> = edges
        .iter()
        .map(|ends| mesh::tube(ends, Ends::Capped, radius, 10))
        .collect();
    let lines = edges.into_iter().map(|ends| Outline {
        points: ends.to_vec(),
        is_area: false,
    });
    let part = |name: &str, mesh, lines, colour, opacity| Placed {
        part: Part {
            name: name.to_owned(),
            mesh,
            lines,
            colour: Some(colour),
            opacity,
            centre: None,
        },
        isometries: vec![Isometry::identity()],
    };
    Ok([
        part("domain", domain.mesh()?, Vec::new(), GLASS, OPACITY),
        part(
            "domain edges",
            Mesh::joined(&rods?)?,
            lines.collect(),
            EDGE,
            1.0,
        ),
    ])
}

/// The edges, each once.
fn edges(domain: &FundamentalDomain) -> Vec<[[f64; 3]; 2]> {
    let mut corners = Corners::of(domain);
    let mut pairs = std::collections::BTreeSet::new();
    for face in domain.faces() {
        let around: Vec<usize> = face.corners.iter().map(|at| corners.index(*at)).collect();
        let next = around.iter().cycle().skip(1);
        for (from, to) in around.iter().zip(next).filter(|(from, to)| from != to) {
            pairs.insert([*from.min(to), *from.max(to)]);
        }
    }
    let at = |index: usize| Some(corners.found.get(index)?.to_array());
    let ends = |[from, to]: [usize; 2]| Some([at(from)?, at(to)?]);
    pairs.into_iter().filter_map(ends).collect()
}

/// The corners of a domain, each once though several faces have it.
struct Corners {
    found: Vec<Vector3>,
    reach: f64,
}

impl Corners {
    fn of(domain: &FundamentalDomain) -> Self {
        Self {
            found: Vec::new(),
            reach: SAME * domain.volume().cbrt(),
        }
    }

    /// The place of a corner in the list, at the end of which it is put if it is new.
    fn index(&mut self, corner: Point) -> usize {
        let place = corner.position();
        let mut known = self.found.iter();
        known
            .position(|other| (*other - place).norm() < self.reach)
            .unwrap_or_else(|| {
                self.found.push(place);
                self.found.len() - 1
            })
    }
}
