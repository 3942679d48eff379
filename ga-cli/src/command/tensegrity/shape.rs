//! Decides which structures can be asked for, with which parameters.

use crate::angle::angle;
use clap::{Subcommand, ValueEnum, value_parser};
use ga_design::tensegrity::{
    BALANCED_RATIO, Hand, Octahedron, Polyhedron, Prism, Solid, Structure, TensegrityError, Tower,
};

/// The structures that can be made.
#[derive(Debug, Subcommand)]
pub enum Shape {
    /// The expanded octahedron: 6 struts along the axes, 24 cables.
    Octahedron(OctahedronArguments),
    /// A prism: two polygons of cables, turned against each other and held apart by struts.
    Prism(PrismArguments),
    /// A tower of prisms that stand in each other without a strut touching another.
    Tower(TowerArguments),
    /// Diamond pattern: 6 struts, 24 cables; with equal cables the expanded octahedron.
    Icosahedron(PolyhedronArguments),
    /// Diamond pattern: 12 struts, 48 cables.
    Rhombicuboctahedron(PolyhedronArguments),
    /// Diamond pattern: 30 struts, 120 cables.
    Rhombicosidodecahedron(PolyhedronArguments),
    /// Zigzag pattern: 6 struts, 18 cables.
    TruncatedTetrahedron(PolyhedronArguments),
    /// Zigzag pattern: 12 struts, 36 cables.
    TruncatedCube(PolyhedronArguments),
    /// Zigzag pattern: 12 struts, 36 cables.
    TruncatedOctahedron(PolyhedronArguments),
    /// Zigzag pattern: 30 struts, 90 cables.
    TruncatedDodecahedron(PolyhedronArguments),
    /// Zigzag pattern: 30 struts, 90 cables.
    TruncatedIcosahedron(PolyhedronArguments),
    /// Circuit pattern: 12 struts in four triangles, 24 cables.
    Cuboctahedron(CircuitArguments),
    /// Circuit pattern: 30 struts in six pentagons, 60 cables.
    Icosidodecahedron(CircuitArguments),
}

/// How an expanded octahedron is.
#[derive(Debug, clap::Args)]
pub struct OctahedronArguments {
    /// The length of a cable over that of a strut, up to 0.7071068: at every ratio but the least, which
    /// is the default, there is no self-stress.
    #[arg(long, value_name = "RATIO", default_value_t = BALANCED_RATIO, value_parser = positive)]
    ratio: f64,
    /// The length of a strut.
    #[arg(long, value_name = "LENGTH", default_value_t = 1.0, value_parser = positive)]
    strut_length: f64,
}

/// How a prism is.
#[derive(Debug, clap::Args)]
pub struct PrismArguments {
    /// The number of struts.
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = value_parser!(u16).range(3..=60))]
    struts: u16,
    /// The angle by which the top is turned along the side cables, in radians or as in 30deg; by default
    /// 90deg − 180deg/N, where it is in balance.
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    twist: Option<f64>,
    /// The radius of the circles through the nodes.
    #[arg(long, value_name = "LENGTH", default_value_t = 1.0, value_parser = positive)]
    radius: f64,
    /// The height from base to top.
    #[arg(long, value_name = "LENGTH", default_value_t = 2.0, value_parser = positive)]
    height: f64,
    /// Which way it turns.
    #[arg(long, value_enum, default_value_t = Turn::Right)]
    hand: Turn,
}

/// How a tower is.
#[derive(Debug, clap::Args)]
pub struct TowerArguments {
    /// The number of struts of a stage.
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = value_parser!(u16).range(3..=20))]
    struts: u16,
    /// The number of stages; a tower has at most 240 nodes.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = value_parser!(u16).range(2..=40))]
    stages: u16,
    /// The angle by which the heads of a stage are turned against its feet along the side cables, in
    /// radians or as in 45deg; more than that of a prism, by default by 45deg/N. The more, the deeper
    /// stand the stages in each other.
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    twist: Option<f64>,
    /// The radius of the circles through the nodes.
    #[arg(long, value_name = "LENGTH", default_value_t = 1.0, value_parser = positive)]
    radius: f64,
    /// The height of a stage.
    #[arg(long, value_name = "LENGTH", default_value_t = 3.0, value_parser = positive)]
    height: f64,
    /// Which way the stages turn.
    #[arg(long, value_enum, default_value_t = Turn::Right)]
    hand: Turn,
}

/// How a structure of two kinds of cables on the edges of a solid is.
#[derive(Debug, clap::Args)]
pub struct PolyhedronArguments {
    /// The length of the second kind of cables over that of the first. In the diamond pattern they go
    /// around the one and the other faces, in the zigzag pattern the first go around faces and the
    /// second from face to face.
    #[arg(long, value_name = "RATIO", default_value_t = 1.0, value_parser = positive)]
    cable_ratio: f64,
    #[command(flatten)]
    circuit: CircuitArguments,
}

/// How a structure on the edges of a solid is.
#[derive(Debug, clap::Args)]
pub struct CircuitArguments {
    /// The length of a strut.
    #[arg(long, value_name = "LENGTH", default_value_t = 1.0, value_parser = positive)]
    strut_length: f64,
    /// Which of the two mirror images.
    #[arg(long, value_enum, default_value_t = Turn::Right)]
    hand: Turn,
}

/// Which way a structure turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Turn {
    /// Like a right-handed screw.
    Right,
    /// The mirror image.
    Left,
}

impl From<Turn> for Hand {
    fn from(turn: Turn) -> Self {
        match turn {
            Turn::Right => Hand::Right,
            Turn::Left => Hand::Left,
        }
    }
}

impl Shape {
    /// The structure.
    pub fn structure(&self) -> Result<Structure, TensegrityError> {
        match self {
            Shape::Octahedron(asked) => Octahedron {
                strut: asked.strut_length,
                ratio: asked.ratio,
            }
            .structure(),
            Shape::Prism(asked) => Prism {
                struts: asked.struts.into(),
                radius: asked.radius,
                height: asked.height,
                twist: asked.twist,
                hand: asked.hand.into(),
            }
            .structure(),
            Shape::Tower(asked) => Tower {
                struts: asked.struts.into(),
                stages: asked.stages.into(),
                radius: asked.radius,
                height: asked.height,
                twist: asked.twist,
                hand: asked.hand.into(),
            }
            .structure(),
            Shape::Cuboctahedron(asked) => polyhedron(Solid::Cuboctahedron, asked, 1.0),
            Shape::Icosidodecahedron(asked) => polyhedron(Solid::Icosidodecahedron, asked, 1.0),
            Shape::Icosahedron(asked) => two_kinds(Solid::Icosahedron, asked),
            Shape::Rhombicuboctahedron(asked) => two_kinds(Solid::Rhombicuboctahedron, asked),
            Shape::Rhombicosidodecahedron(asked) => two_kinds(Solid::Rhombicosidodecahedron, asked),
            Shape::TruncatedTetrahedron(asked) => two_kinds(Solid::TruncatedTetrahedron, asked),
            Shape::TruncatedCube(asked) => two_kinds(Solid::TruncatedCube, asked),
            Shape::TruncatedOctahedron(asked) => two_kinds(Solid::TruncatedOctahedron, asked),
            Shape::TruncatedDodecahedron(asked) => two_kinds(Solid::TruncatedDodecahedron, asked),
            Shape::TruncatedIcosahedron(asked) => two_kinds(Solid::TruncatedIcosahedron, asked),
        }
    }

    /// What it is called.
    pub fn title(&self) -> String {
        let solid = |solid: Solid| solid.name().replace('-', " ");
        match self {
            Shape::Octahedron(_) => "expanded octahedron".to_owned(),
            Shape::Prism(asked) => format!("prism of {} struts", asked.struts),
            Shape::Tower(asked) => {
                format!(
                    "tower of {} stages of {} struts",
                    asked.stages, asked.struts
                )
            }
            Shape::Icosahedron(_) => solid(Solid::Icosahedron),
            Shape::Rhombicuboctahedron(_) => solid(Solid::Rhombicuboctahedron),
            Shape::Rhombicosidodecahedron(_) => solid(Solid::Rhombicosidodecahedron),
            Shape::TruncatedTetrahedron(_) => solid(Solid::TruncatedTetrahedron),
            Shape::TruncatedCube(_) => solid(Solid::TruncatedCube),
            Shape::TruncatedOctahedron(_) => solid(Solid::TruncatedOctahedron),
            Shape::TruncatedDodecahedron(_) => solid(Solid::TruncatedDodecahedron),
            Shape::TruncatedIcosahedron(_) => solid(Solid::TruncatedIcosahedron),
            Shape::Cuboctahedron(_) => solid(Solid::Cuboctahedron),
            Shape::Icosidodecahedron(_) => solid(Solid::Icosidodecahedron),
        }
    }
}

fn two_kinds(solid: Solid, asked: &PolyhedronArguments) -> Result<Structure, TensegrityError> {
    polyhedron(solid, &asked.circuit, asked.cable_ratio)
}

fn polyhedron(
    solid: Solid,
    asked: &CircuitArguments,
    cable_ratio: f64,
) -> Result<Structure, TensegrityError> {
    Polyhedron {
        solid,
        strut: asked.strut_length,
        cable_ratio,
        hand: asked.hand.into(),
    }
    .structure()
}

/// A positive number.
fn positive(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "it is no number".to_owned())?;
    if (1e-12..=1e12).contains(&value) {
        Ok(value)
    } else {
        Err("it must be from 1e-12 to 1e12".to_owned())
    }
}
