//! Struts that do not touch, held apart by cables: the expanded octahedron and its variations (figure
//! 3.9), a prism and a tower of one group (figure 3.10), and solids on which it is done.

use super::GalleryError;
use crate::export::{Scene, View};
use crate::tensegrity::scene::Look;
use crate::tensegrity::{Octahedron, Polyhedron, Prism, Solid, Structure, Tower};
use ga_cga::{Motor, Rotor, Translator, Vector3};

/// Variations of the expanded octahedron: the ratio of the two kinds of cables.
const CABLE_RATIOS: [f64; 2] = [0.62, 1.6];

/// The solids that are shown, and where.
const SOLIDS: [(Solid, [f64; 2]); 6] = [
    (Solid::TruncatedTetrahedron, [-1.2, 0.62]),
    (Solid::Cuboctahedron, [0.0, 0.62]),
    (Solid::TruncatedOctahedron, [1.2, 0.62]),
    (Solid::Rhombicuboctahedron, [-1.2, -0.62]),
    (Solid::Icosidodecahedron, [0.0, -0.62]),
    (Solid::TruncatedIcosahedron, [1.2, -0.62]),
];

/// The structure moved by this vector, after a turn about z.
fn standing(structure: &Structure, turn: f64, at: [f64; 3]) -> Result<Structure, GalleryError> {
    let rotor = Rotor::about_axis(Vector3::new(0.0, 0.0, 1.0), turn);
    let rotor = rotor.ok_or(GalleryError::Degenerate {
        what: "a turn about z",
    })?;
    let motor = Motor::rigid(rotor, Translator::by(Vector3::from(at)));
    Ok(structure.moved(|point| motor.apply(point))?)
}

/// Structures side by side.
fn shown(mut scene: Scene, structures: &[Structure], view: View) -> Result<Scene, GalleryError> {
    let look = Look::new(&mut scene)?;
    for structure in structures {
        look.draw(&mut scene, structure)?;
    }
    scene.set_view(view)?;
    Ok(scene)
}

pub(super) fn octahedron() -> Result<Scene, GalleryError> {
    let scene = Scene::new(
        "expanded-octahedron",
        "Expanded octahedron",
        "Six struts, none of which touches another, and twenty-four cables: one strut and two cables, blue \
         and violet, carried by the twelve rotations of the tetrahedron. It is in balance only if a cable \
         is √(3/8) of a strut, and then it is so stiff that no other form has struts as long and cables \
         as short.",
    );
    shown(
        scene,
        &[Octahedron::default().structure()?],
        View {
            azimuth: -0.62,
            elevation: 0.3,
        },
    )
}

pub(super) fn variations() -> Result<Scene, GalleryError> {
    let scene = Scene::new(
        "octahedron-variations",
        "Variations of an octahedron",
        "The same group and the same joints with the generating strut turned: on the left the violet \
         cables are shorter than the blue ones, on the right longer. Each form is found from the \
         condition that the forces on a single node cancel, and all of them are super-stable.",
    );
    let [short, long] = CABLE_RATIOS.map(|cable_ratio| {
        let varied = Polyhedron {
            cable_ratio,
            ..Polyhedron::of(Solid::Icosahedron)
        };
        varied.structure()
    });
    let structures = [
        standing(&short?, 0.0, [-1.25, 0.0, 0.0])?,
        Octahedron::default().structure()?,
        standing(&long?, 0.0, [1.25, 0.0, 0.0])?,
    ];
    shown(
        scene,
        &structures,
        View {
            azimuth: -1.32,
            elevation: 0.32,
        },
    )
}

pub(super) fn tower() -> Result<Scene, GalleryError> {
    let scene = Scene::new(
        "tensegrity-tower",
        "Tower of struts and cables",
        "Left: three struts and the rotations of the point group 3̄2̄ make a prism, whose top is turned by \
         30° against its base. Right: stages that repeat up the axis, each standing between the heads of \
         the one below without a strut touching another. How deep they stand is found: only at one depth \
         the whole is in balance.",
    );
    let prism = Prism {
        height: 2.4,
        ..Prism::default()
    };
    let tower = Tower {
        stages: 4,
        height: 2.4,
        ..Tower::default()
    };
    let (prism, tower) = (prism.structure()?, tower.structure()?);
    let floor = |structure: &Structure| {
        let heights = structure
            .nodes()
            .iter()
            .map(|node| node.position().to_array()[2]);
        -heights.fold(f64::INFINITY, f64::min)
    };
    let structures = [
        standing(&prism, 0.3, [-1.75, 0.0, floor(&prism)])?,
        standing(&tower, 0.0, [1.35, 0.0, floor(&tower)])?,
    ];
    shown(
        scene,
        &structures,
        View {
            azimuth: -1.25,
            elevation: 0.2,
        },
    )
}

pub(super) fn solids() -> Result<Scene, GalleryError> {
    let scene = Scene::new(
        "tensegrity-solids",
        "Solids in tension",
        "From the rotations of the tetrahedron, the cube and the icosahedron: struts across the edges of \
         Archimedean solids, in the patterns that Pugh calls zigzag (truncated tetrahedron, octahedron, \
         icosahedron), circuit (cuboctahedron, icosidodecahedron) and diamond (rhombicuboctahedron). Every \
         cable is pulled, every strut pressed, and all six are super-stable.",
    );
    let structures = SOLIDS.map(|(solid, [x, z])| {
        let structure = Polyhedron::of(solid).structure()?;
        let size = structure.nodes().iter().map(|node| node.position().norm());
        let size = size.fold(0.0, f64::max);
        let scaled = structure.moved(|point| (point.position() * (0.5 / size)).into())?;
        standing(&scaled, 0.2, [x, 0.0, z])
    });
    let structures = structures.into_iter().collect::<Result<Vec<_>, _>>()?;
    shown(
        scene,
        &structures,
        View {
            azimuth: -1.45,
            elevation: 0.16,
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tensegrity::{Analysis, Hand, Stability};

    #[test]
    fn the_shown_variations_are_super_stable() -> Result<(), GalleryError> {
        for cable_ratio in CABLE_RATIOS {
            for hand in [Hand::Right, Hand::Left] {
                let varied = Polyhedron {
                    cable_ratio,
                    hand,
                    ..Polyhedron::of(Solid::Icosahedron)
                };
                let analysis = Analysis::of(&varied.structure()?)?;
                assert_eq!(analysis.stability, Stability::SuperStable, "{cable_ratio}");
            }
        }
        Ok(())
    }

    #[test]
    fn the_shown_solids_are_super_stable() -> Result<(), GalleryError> {
        for (solid, _) in SOLIDS {
            let analysis = Analysis::of(&Polyhedron::of(solid).structure()?)?;
            assert_eq!(
                analysis.stability,
                Stability::SuperStable,
                "{}",
                solid.name()
            );
        }
        Ok(())
    }

    #[test]
    fn prism_and_tower_stand_on_one_floor() -> Result<(), GalleryError> {
        let scene = tower()?;
        let balls = scene
            .nodes()
            .iter()
            .filter(|node| node.name.starts_with("node"));
        let heights: Vec<f64> = balls.map(|ball| ball.placement.translation()[2]).collect();
        let on_the_floor = heights.iter().filter(|height| height.abs() < 1e-12).count();
        assert_eq!((heights.len(), on_the_floor), (6 + 24, 6));
        Ok(())
    }
}
