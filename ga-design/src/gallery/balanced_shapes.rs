//! Spheres and a cylinder warped by point pairs that a group has made symmetric (3.9, figure 3.7).

use super::GalleryError;
use super::palette::{BLUE, ORANGE, TEAL, YELLOW, solid};
use crate::crystallography::Isometry;
use crate::export::{Scene, View};
use crate::mesh::{self, Ends, Mesh};
use crate::tensegrity::rotations::{dihedral, icosahedral, octahedral, tetrahedral};
use crate::warp::{Warp, Weighting};
use ga_cga::{Point, PointPair, Vector3};

/// A shape, the group and the pair that warp it.
struct Example {
    name: &'static str,
    color: [u8; 3],
    at: [f64; 3],
    is_cylinder: bool,
    group: fn() -> Result<Vec<Isometry>, GalleryError>,
    pair: PointPair,
    weighting: Weighting,
    amount: f64,
}

fn tangent(at: [f64; 3], along: [f64; 3]) -> PointPair {
    let [x, y, z] = at;
    PointPair::tangent(Point::at(x, y, z), Vector3::from(along))
}

fn examples() -> [Example; 6] {
    [
        Example {
            name: "tetrahedral",
            color: ORANGE,
            at: [-2.9, 0.0, 1.5],
            is_cylinder: false,
            group: || Ok(tetrahedral()?.isometries()),
            pair: tangent([0.9, 0.9, 0.9], [0.5, -0.5, 0.2]),
            weighting: Weighting::Near { reach: 0.6 },
            amount: 0.6,
        },
        Example {
            name: "gear",
            color: BLUE,
            at: [0.0, 0.0, 1.5],
            is_cylinder: true,
            group: || Ok(dihedral(8)?.isometries()),
            pair: tangent([1.0, 0.0, 0.0], [0.5, 0.5, 0.0]),
            weighting: Weighting::Near { reach: 0.3 },
            amount: 0.5,
        },
        Example {
            name: "cube",
            color: TEAL,
            at: [2.9, 0.0, 1.5],
            is_cylinder: false,
            group: || Ok(octahedral()?.isometries()),
            pair: tangent([1.0, 0.0, 0.2], [0.3, 0.5, 0.0]),
            weighting: Weighting::Near { reach: 0.5 },
            amount: 0.5,
        },
        Example {
            name: "fan",
            color: YELLOW,
            at: [-2.9, 0.0, -1.5],
            is_cylinder: true,
            group: || Ok(dihedral(5)?.isometries()),
            pair: tangent([1.0, 0.0, 0.6], [0.2, 0.5, 0.5]),
            weighting: Weighting::Near { reach: 0.5 },
            amount: 0.7,
        },
        Example {
            name: "icosahedral",
            color: BLUE,
            at: [0.0, 0.0, -1.5],
            is_cylinder: false,
            group: || Ok(icosahedral()?.isometries()),
            pair: tangent([1.0, 0.2, 0.1], [0.5, 0.3, 0.0]),
            weighting: Weighting::Near { reach: 0.3 },
            amount: 0.4,
        },
        Example {
            name: "far",
            color: ORANGE,
            at: [2.9, 0.0, -1.5],
            is_cylinder: false,
            group: || Ok(dihedral(3)?.isometries()),
            pair: tangent([1.0, 0.0, 0.5], [0.1, 0.3, 0.2]),
            weighting: Weighting::SquaredDistance,
            amount: 0.15,
        },
    ]
}

impl Example {
    fn warp(&self) -> Result<Warp, GalleryError> {
        Ok(Warp::generated(
            &(self.group)()?,
            &[self.pair],
            self.weighting,
            self.amount,
        )?)
    }

    fn mesh(&self) -> Result<Mesh, GalleryError> {
        let shape = if self.is_cylinder {
            let steps: u32 = 80;
            let line: Vec<[f64; 3]> = (0..=steps)
                .map(|i| [0.0, 0.0, 2.0 * f64::from(i) / f64::from(steps) - 1.0])
                .collect();
            mesh::tube(&line, Ends::Capped, 1.0, 192)?
        } else {
            mesh::icosphere(6)?
        };
        Ok(self.warp()?.mesh(&shape)?)
    }
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new("balanced-shapes", "Balanced shapes", "Spheres and cylinders.");
    for example in examples() {
        let mesh = example.mesh()?;
        let at = example.at;
        let positions = mesh.positions().iter();
        let moved = Mesh::new(
            positions.map(|p| std::array::from_fn(|i| p[i] + at[i])).collect(),
            mesh.normals().to_vec(),
            mesh.triangles().to_vec(),
        )?;
        let material = scene.add_material(solid(example.name, example.color)?);
        scene.add(example.name, moved, material)?;
    }
    scene.set_view(View {
        azimuth: -1.3,
        elevation: 0.3,
    })?;
    Ok(scene)
}
