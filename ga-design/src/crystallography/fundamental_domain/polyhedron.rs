//! How a convex polyhedron is cut by planes, each face keeping its plane and where that came from.

use ga_cga::{DualPlane, Point, Vector3};

/// Corners nearer to a plane than this part of the first cube's size are on it: above rounding, and so
/// small that no volume notices.
const ON_PLANE: f64 = 1e-12;

/// A convex polyhedron around a point; every face has a source.
pub(super) struct Polyhedron<S> {
    centre: Point,
    size: f64,
    faces: Vec<Face<S>>,
}

struct Face<S> {
    plane: DualPlane,
    corners: Vec<Point>,
    source: S,
}

impl<S: Default> Polyhedron<S> {
    /// The cube about a point with edges of twice the size, parallel to the axes.
    pub(super) fn cube(centre: Point, size: f64) -> Self {
        let at = centre.position();
        let axes = [
            Vector3::new(size, 0.0, 0.0),
            Vector3::new(0.0, size, 0.0),
            Vector3::new(0.0, 0.0, size),
        ];
        let faces = (0..6).filter_map(|number: usize| {
            let sign = if number < 3 { 1.0 } else { -1.0 };
            let along = [0, 1, 2].map(|i| axes[(number + i) % 3]);
            // In this order anticlockwise seen from outside on the positive sides; turned on the others.
            let around = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let corner = |(u, v): (f64, f64)| {
                Point::from(at + along[0] * sign + along[1] * (u * sign) + along[2] * v)
            };
            Some(Face {
                plane: DualPlane::through(corner((0.0, 0.0)), along[0] * sign)?,
                corners: around.map(corner).to_vec(),
                source: S::default(),
            })
        });
        Self {
            centre,
            size,
            faces: faces.collect(),
        }
    }
}

impl<S> Polyhedron<S> {
    /// The distance of the farthest corner from the centre.
    pub(super) fn radius(&self) -> f64 {
        let distances = self.corners().map(|corner| corner.distance(self.centre));
        distances.fold(0.0, f64::max)
    }

    /// The corners, each once for every face that it belongs to.
    pub(super) fn corners(&self) -> impl Iterator<Item = Point> + '_ {
        self.faces
            .iter()
            .flat_map(|face| face.corners.iter().copied())
    }

    /// Cuts off what is on the side of a unit plane that its normal points to.
    pub(super) fn cut(&mut self, plane: DualPlane, source: S) {
        let tolerance = ON_PLANE * self.size;
        let height = |corner: &Point| (plane | *corner).s;
        let heights = self.corners().map(|corner| height(&corner));
        if heights.fold(f64::NEG_INFINITY, f64::max) <= tolerance {
            return;
        }
        let mut rim: Vec<Point> = Vec::new();
        for face in &mut self.faces {
            let next = face.corners.iter().cycle().skip(1);
            let mut kept = Vec::with_capacity(face.corners.len() + 1);
            for (here, there) in face.corners.iter().zip(next) {
                let (low, high) = (height(here), height(there));
                if low <= tolerance {
                    kept.push(*here);
                    if low >= -tolerance {
                        rim.push(*here);
                    }
                }
                let crosses = low.min(high) < -tolerance && low.max(high) > tolerance;
                if crosses {
                    let step = there.position() - here.position();
                    let crossing = Point::from(here.position() + step * (low / (low - high)));
                    kept.push(crossing);
                    rim.push(crossing);
                }
            }
            face.corners = kept;
        }
        self.faces.retain(|face| face.corners.len() > 2);
        let corners = around(distinct(rim, 10.0 * tolerance), plane);
        if corners.len() > 2 {
            self.faces.push(Face {
                plane,
                corners,
                source,
            });
        }
    }

    /// The volume: that of the tetrahedra from the centre to the triangles of the faces.
    pub(super) fn volume(&self) -> f64 {
        let mut sum = 0.0;
        for face in &self.faces {
            let spokes = face
                .corners
                .iter()
                .map(|p| p.position() - self.centre.position());
            let spokes: Vec<Vector3> = spokes.collect();
            if let [first, rest @ ..] = spokes.as_slice() {
                for pair in rest.windows(2) {
                    if let [second, third] = pair {
                        sum += (*first ^ *second ^ *third).e123 / 6.0;
                    }
                }
            }
        }
        sum
    }

    /// The faces: plane, corners and source.
    pub(super) fn into_faces(self) -> Vec<(DualPlane, Vec<Point>, S)> {
        let faces = self.faces.into_iter();
        faces
            .map(|face| (face.plane, face.corners, face.source))
            .collect()
    }
}

/// The points without those that are nearer than the tolerance to one before.
fn distinct(points: Vec<Point>, tolerance: f64) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for point in points {
        if kept.iter().all(|other| other.distance(point) > tolerance) {
            kept.push(point);
        }
    }
    kept
}

/// Points of a plane in order around their mean, anticlockwise seen against the normal.
fn around(mut points: Vec<Point>, plane: DualPlane) -> Vec<Point> {
    let Some(first) = points.first().copied() else {
        return points;
    };
    let sum = points
        .iter()
        .fold(Vector3::default(), |sum, p| sum + p.position());
    let mean = sum / points.len() as f64;
    let u = first.position() - mean;
    // A quarter turn on in the plane: u ⌋ B with the plane's bivector.
    let v: Vector3 = u.left_contract(plane.normal().orthogonal_plane());
    let angle = |point: &Point| {
        let spoke = point.position() - mean;
        spoke.scalar_product(v).atan2(spoke.scalar_product(u))
    };
    points.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    points
}
