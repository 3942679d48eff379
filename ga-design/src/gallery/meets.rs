//! What spheres and planes have in common is their outer product: a circle, a point, a point pair
//! (figures 2.10–2.12), and the round subspaces of one sphere (figure 2.13, equation 2.59).

use super::GalleryError;
use super::motif::{ball, ring, shell};
use super::palette::{BLUE, ORANGE, SLATE, TEAL, YELLOW, glass, solid};
use crate::export::{MaterialId, Scene, View};
use crate::folding::Meeting;
use crate::mesh;
use ga_cga::{Bivector3, Circle, DualPlane, DualSphere, Point, PointPair, Vector3};

/// Where the stations are on the floor.
const STATIONS: [[f64; 2]; 5] = [
    [-3.0, 1.5],
    [0.0, 1.5],
    [3.0, 1.5],
    [-1.7, -1.7],
    [1.7, -1.7],
];

/// A sphere of a station, moved to its place in the row.
fn sphere(station: usize, [x, y, z]: [f64; 3], radius: f64) -> DualSphere {
    let [right, back] = STATIONS.get(station).copied().unwrap_or_default();
    DualSphere::with_radius(Vector3::new(x + right, y + back, z), radius)
}

/// A sphere and the level plane that cuts it.
fn cut() -> (DualSphere, DualPlane) {
    let plane = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.45);
    (sphere(0, [0.0, 0.0, 0.0], 1.15), plane)
}

/// Two spheres that cross.
fn crossing() -> [DualSphere; 2] {
    [
        sphere(1, [-0.45, -0.2, 0.0], 1.0),
        sphere(1, [0.55, 0.2, 0.2], 0.8),
    ]
}

/// Two spheres that touch.
fn touching() -> [DualSphere; 2] {
    [
        sphere(2, [-0.5, 0.0, 0.0], 0.9),
        sphere(2, [0.94, 0.0, 0.42], 0.6),
    ]
}

/// Three spheres that have two points in common.
fn triple() -> [DualSphere; 3] {
    [
        sphere(3, [-0.5, -0.3, 0.0], 0.95),
        sphere(3, [0.55, -0.25, 0.1], 0.9),
        sphere(3, [0.0, 0.55, -0.05], 0.85),
    ]
}

/// A sphere whose antipodal points and equator are asked for.
fn whole() -> DualSphere {
    sphere(4, [0.0, 0.0, 0.0], 1.15)
}

/// The direction of the antipodal points.
fn direction() -> Vector3 {
    Vector3::new(0.35, -0.4, 0.85)
}

/// The two points in which a sphere meets the line through its centre in a direction: (2.59) for the
/// imaginary sphere of the same size, which gives the real pair.
fn antipodes(sphere: DualSphere, direction: Vector3) -> PointPair {
    let [x, y, z] = direction.to_array();
    let free = ga_cga::DirectionVector::new(x, y, z);
    let mate = imaginary(sphere);
    mate ^ mate.left_contract(free)
}

/// The circle in which a sphere meets the plane through its centre along a bivector (2.59).
fn equator(sphere: DualSphere, plane: Bivector3) -> Circle {
    let free = ga_cga::DirectionBivector::from(plane.to_array());
    let mate = imaginary(sphere);
    mate ^ mate.left_contract(-free)
}

/// The imaginary sphere with the centre and size of a real one, σ + r² n_∞.
fn imaginary(sphere: DualSphere) -> DualSphere {
    let square = sphere.radius_squared().unwrap_or_default();
    sphere + DualSphere::infinity() * square
}

/// The points of a pair, the ends of its orientation.
fn ends(pair: PointPair) -> Option<[Point; 2]> {
    // The dual of a pair is a circle, as three spheres have it in common.
    Meeting::of_pair(pair).both()
}

fn dots(
    scene: &mut Scene,
    name: &str,
    points: &[Point],
    material: MaterialId,
) -> Result<(), GalleryError> {
    for point in points {
        scene.add(name, ball(point.position().to_array(), 0.085)?, material)?;
    }
    Ok(())
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "meets",
        "What spheres have in common",
        "The outer product of dual spheres and planes is what they have in common, in orange: a circle of \
         a sphere and a plane, a circle of two spheres, one point where they touch, two points of three \
         spheres. In the last sphere a direction finds its antipodal points, and its plane the equator.",
    );
    let colors = [BLUE, TEAL, YELLOW];
    let mut sheets = Vec::new();
    for color in colors {
        sheets.push(scene.add_material(glass("sphere", color, 0.24)?));
    }
    let orange = scene.add_material(solid("common", ORANGE)?);
    let missing = |what| GalleryError::Degenerate { what };

    let (round, plane) = cut();
    let [pair, touch] = [crossing(), touching()];
    let groups: [&[DualSphere]; 5] = [&[round], &pair, &touch, &triple(), &[whole()]];
    for group in groups {
        for (&sphere, &material) in group.iter().zip(&sheets) {
            scene.add("sphere", shell(sphere)?, material)?;
        }
    }
    let [right, back] = STATIONS[0];
    let floor = mesh::parallelogram([right, back, plane.ni], [1.45, 0.0, 0.0], [0.0, 1.45, 0.0])?;
    let pane = scene.add_material(glass("plane", [120, 160, 196], 0.4)?);
    scene.add("plane", floor, pane)?;
    scene.add(
        "sphere and plane",
        ring((round ^ plane).undual(), 0.032)?,
        orange,
    )?;
    let [a, b] = pair;
    scene.add("two spheres", ring((a ^ b).undual(), 0.032)?, orange)?;
    let [a, b] = touch;
    let tangent = touch_point(a, b).ok_or(missing("the point where spheres touch"))?;
    dots(&mut scene, "touching spheres", &[tangent], orange)?;
    let points = Meeting::of(triple()).both();
    let points = points.ok_or(missing("the points of three spheres"))?;
    dots(&mut scene, "three spheres", &points, orange)?;
    let points = ends(antipodes(whole(), direction()));
    let points = points.ok_or(missing("the antipodal points"))?;
    dots(&mut scene, "antipodal points", &points, orange)?;
    let level = direction() * ga_cga::Trivector3::new(1.0);
    scene.add("equator", ring(equator(whole(), level), 0.032)?, orange)?;
    let slate = scene.add_material(solid("direction", SLATE)?);
    let arrow = points.map(|point| point.position().to_array());
    let [from, to] = if arrow[0][2] < arrow[1][2] {
        arrow
    } else {
        [arrow[1], arrow[0]]
    };
    scene.add("direction", mesh::cylinder(from, to, 0.022, 16)?, slate)?;
    scene.set_view(View {
        azimuth: -1.5,
        elevation: 0.55,
    })?;
    Ok(scene)
}

/// The point where two spheres touch: the centre of the circle of radius zero that they share.
fn touch_point(a: DualSphere, b: DualSphere) -> Option<Point> {
    let circle: Circle = (a ^ b).undual();
    circle
        .left_contract(circle ^ DualSphere::infinity())
        .center()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(sphere: DualSphere, point: Point) -> f64 {
        sphere.scalar_product(point).abs()
    }

    #[test]
    fn what_is_drawn_is_on_all_of_them() {
        for point in Meeting::of(triple()).both().unwrap_or_default() {
            assert!(triple().into_iter().all(|sphere| on(sphere, point) < 1e-13));
        }
        let [a, b] = touching();
        let point = touch_point(a, b).unwrap_or_default();
        assert!(on(a, point) < 1e-13 && on(b, point) < 1e-13);
    }

    #[test]
    fn antipodal_points_and_equator_are_on_the_sphere() {
        let sphere = whole();
        let center = sphere.center().unwrap_or_default().position();
        let points = ends(antipodes(sphere, direction())).unwrap_or_default();
        let [a, b] = points.map(|point| {
            assert!(on(sphere, point) < 1e-13);
            point.position() - center
        });
        assert!((a + b).norm() < 1e-13 && (a ^ direction()).norm() < 1e-13);
        let circle = equator(sphere, direction() * ga_cga::Trivector3::new(1.0));
        let around = circle.left_contract(circle ^ DualSphere::infinity());
        let square = around.radius_squared().unwrap_or(f64::NAN);
        assert!((square - 1.15 * 1.15).abs() < 1e-12, "{square}");
    }
}
