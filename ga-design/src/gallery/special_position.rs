//! A bar in general and in special position under the point group 3̅3̅ (figure 3.8): twelve copies, six that
//! span an icosahedron, three that span an octahedron.

use super::GalleryError;
use super::motif::ball;
use super::palette::{BLUE, ORANGE, TEAL, solid};
use crate::crystallography::{
    Coincidence, Isometry, MotifCopy, Motion, Pattern, PointGroup, Strut,
};
use crate::export::{Scene, View};
use crate::mesh::{self, Mesh};
use ga_cga::{Bivector3, Motor, Point, Rotor, Vector3};

/// The golden ratio.
const GOLDEN: f64 = 1.618_033_988_749_895;

/// The distance between the groups.
const SPACING: f64 = 4.3;

/// A bar by the coordinates of its ends along the three half-turn axes of the group.
struct Bar {
    name: &'static str,
    ends: [[f64; 3]; 2],
    color: [u8; 3],
    /// The length of the edges that are drawn between ends, 0 for none.
    edge: f64,
}

/// In general position, along an axis, through the centre.
const BARS: [Bar; 3] = [
    Bar {
        name: "general",
        ends: [[-0.56, -0.51, 1.11], [1.51, -0.15, 1.0]],
        color: ORANGE,
        edge: 0.0,
    },
    Bar {
        name: "special",
        ends: [[-GOLDEN, 0.0, 1.0], [GOLDEN, 0.0, 1.0]],
        color: BLUE,
        edge: 2.0,
    },
    Bar {
        name: "collapsed",
        ends: [[-GOLDEN, 0.0, 0.0], [GOLDEN, 0.0, 0.0]],
        color: TEAL,
        edge: GOLDEN * std::f64::consts::SQRT_2,
    },
];

/// The half-turn axes of the group, three at right angles.
fn axes(group: &PointGroup) -> Result<[Vector3; 3], GalleryError> {
    let half_turns = group
        .transformations()
        .iter()
        .filter_map(|t| match t.motion() {
            Motion::Screw { axis, angle, .. } if angle > 3.0 => Some(axis),
            _ => None,
        });
    let axes: Vec<Vector3> = half_turns.collect();
    let [u, v, w] = <[Vector3; 3]>::try_from(axes).map_err(|_| GalleryError::Degenerate {
        what: "the half turns of the figure",
    })?;
    // As a right-handed frame.
    let hand = (u ^ v ^ w).e123;
    Ok([u, v, w * hand.signum()])
}

/// The turn that brings the half-turn axes of the group upright: to x, y and z.
fn upright(group: &PointGroup) -> Result<Isometry, GalleryError> {
    let turned = || {
        let [u, v, _] = axes(group).ok()?;
        let (x, y) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
        let first = Rotor::between_in(u, x, Bivector3::new(1.0, 0.0, 0.0))?;
        // About x, so that x stays.
        let second = Rotor::between_in(first.apply(v), y, Bivector3::new(0.0, 0.0, 1.0))?;
        Some(Isometry::from(Motor::from(second * first)))
    };
    turned().ok_or(GalleryError::Degenerate {
        what: "the half turns of the figure",
    })
}

/// The different copies of a bar.
fn copies(group: &PointGroup, bar: &Bar) -> Result<Vec<MotifCopy<Strut>>, GalleryError> {
    let [u, v, w] = axes(group)?;
    let strut = Strut {
        ends: bar.ends.map(|[x, y, z]| Point::from(u * x + v * y + w * z)),
    };
    let pattern = Pattern::of_isometries(group.transformations().to_vec());
    Ok(pattern.distinct(&strut, &Coincidence::default())?)
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "special-position",
        "General and special position",
        "A bar under the twelve rotations of the point group 3̅3̅ (23). In general position (left) all twelve \
         copies differ; along a half-turn axis (middle) they fall together two by two, and the six that \
         remain span an icosahedron; through the centre (right) four by four, and the three span an \
         octahedron, of which the icosahedron is the expanded form.",
    );
    let group = PointGroup::from_geometric("b(3)b(3)")?;
    let upright = upright(&group)?;
    let pale = scene.add_material(solid("edges", [190, 197, 207])?);
    for (number, bar) in BARS.iter().enumerate() {
        let along = Vector3::new(SPACING * (number as f64 - 1.0), 0.0, 0.0);
        let centre = Isometry::translation(along).after(&upright);
        let material = scene.add_material(solid(bar.name, bar.color)?);
        let mut ends: Vec<Point> = Vec::new();
        let mut parts = Vec::new();
        for copy in copies(&group, bar)? {
            let [from, to] = copy.shape.ends.map(|end| centre.apply(end));
            let [a, b] = [from, to].map(|end| end.position().to_array());
            parts.push(mesh::cylinder(a, b, 0.085, 20)?);
            parts.push(ball(a, 0.15)?);
            parts.push(ball(b, 0.15)?);
            ends.extend([from, to]);
        }
        scene.add(bar.name, Mesh::joined(&parts)?, material)?;
        let edges = edges(&ends, bar.edge)?;
        if !edges.is_empty() {
            scene.add(&format!("edges, {}", bar.name), Mesh::joined(&edges)?, pale)?;
        }
    }
    scene.set_view(View {
        azimuth: -1.38,
        elevation: 0.3,
    })?;
    Ok(scene)
}

/// Thin rods between all ends that are this far from each other.
fn edges(ends: &[Point], length: f64) -> Result<Vec<Mesh>, GalleryError> {
    let mut rods = Vec::new();
    for (i, one) in ends.iter().enumerate() {
        for other in ends.iter().skip(i + 1) {
            if length > 0.0 && (one.distance(*other) - length).abs() < 1e-9 {
                let [a, b] = [one, other].map(|end| end.position().to_array());
                rods.push(mesh::cylinder(a, b, 0.03, 12)?);
            }
        }
    }
    Ok(rods)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_fall_together_one_two_and_four_at_a_time() -> Result<(), GalleryError> {
        let group = PointGroup::from_geometric("b(3)b(3)")?;
        // Edges of the icosahedron and of the octahedron: 30 and 12.
        for (bar, (count, together, rods)) in BARS.iter().zip([(12, 1, 0), (6, 2, 30), (3, 4, 12)])
        {
            let copies = copies(&group, bar)?;
            assert_eq!(copies.len(), count, "{}", bar.name);
            assert!(
                copies.iter().all(|copy| copy.coincident == together),
                "{}",
                bar.name
            );
            let ends: Vec<_> = copies.iter().flat_map(|copy| copy.shape.ends).collect();
            assert_eq!(edges(&ends, bar.edge)?.len(), rods, "{}", bar.name);
        }
        Ok(())
    }
}
