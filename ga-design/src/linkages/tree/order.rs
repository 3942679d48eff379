//! Whether bodies and joints make a tree, and on which joint each body hangs.

use std::collections::HashMap;

use urdf_rs::Robot;

use super::TreeError;

/// For each body the number of the joint that it hangs on; none for the root.
pub fn parents(robot: &Robot) -> Result<Vec<Option<usize>>, TreeError> {
    if robot.links.is_empty() {
        let robot = robot.name.clone();
        return Err(TreeError::Empty { robot });
    }
    let places = places(
        robot,
        "link",
        robot.links.iter().map(|link| link.name.as_str()),
    )?;
    self::places(
        robot,
        "joint",
        robot.joints.iter().map(|joint| joint.name.as_str()),
    )?;
    let place = |joint: &urdf_rs::Joint, name: &str| {
        let missing = || TreeError::MissingLink {
            joint: joint.name.clone(),
            link: name.to_owned(),
            links: listed(robot.links.iter().map(|link| link.name.as_str())),
        };
        places.get(name).copied().ok_or_else(missing)
    };
    let mut parents: Vec<Option<usize>> = vec![None; robot.links.len()];
    let mut above = vec![None; robot.links.len()];
    for (number, joint) in robot.joints.iter().enumerate() {
        let parent = place(joint, &joint.parent.link)?;
        let child = place(joint, &joint.child.link)?;
        let (Some(slot), Some(above)) = (parents.get_mut(child), above.get_mut(child)) else {
            continue;
        };
        if let Some(first) = slot.and_then(|first: usize| robot.joints.get(first)) {
            return Err(TreeError::TwoParents {
                link: joint.child.link.clone(),
                joints: [first.name.clone(), joint.name.clone()],
            });
        }
        *slot = Some(number);
        *above = Some(parent);
    }
    for start in 0..robot.links.len() {
        no_cycle(robot, &parents, &above, start)?;
    }
    let free = robot
        .links
        .iter()
        .zip(&parents)
        .filter(|(_, parent)| parent.is_none());
    let roots: Vec<&str> = free.map(|(link, _)| link.name.as_str()).collect();
    match roots.len() {
        1 => Ok(parents),
        _ => Err(TreeError::Roots {
            roots: listed(roots.into_iter()),
        }),
    }
}

/// Goes up from a body until the root.
fn no_cycle(
    robot: &Robot,
    parents: &[Option<usize>],
    above: &[Option<usize>],
    start: usize,
) -> Result<(), TreeError> {
    let mut way = Vec::new();
    let mut body = start;
    while let Some(parent) = above.get(body).copied().flatten() {
        let joint = parents.get(body).copied().flatten();
        way.extend(joint.and_then(|joint| robot.joints.get(joint)));
        body = parent;
        if body == start {
            return Err(TreeError::Cycle {
                link: robot
                    .links
                    .get(start)
                    .map_or(String::new(), |link| link.name.clone()),
                way: listed(way.iter().map(|joint| joint.name.as_str())),
            });
        }
        // A circle further up is found from there.
        if way.len() > robot.links.len() {
            break;
        }
    }
    Ok(())
}

/// Where each name stands.
fn places<'a>(
    robot: &Robot,
    kind: &'static str,
    names: impl Iterator<Item = &'a str>,
) -> Result<HashMap<&'a str, usize>, TreeError> {
    let mut places = HashMap::new();
    for (place, name) in names.enumerate() {
        if places.insert(name, place).is_some() {
            return Err(TreeError::Twice {
                robot: robot.name.clone(),
                kind,
                name: name.to_owned(),
            });
        }
    }
    Ok(places)
}

/// Names for a message, not more than it can hold.
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    const MOST: usize = 12;
    let names: Vec<&str> = names.collect();
    match names.get(..MOST) {
        Some(first) if names.len() > MOST => {
            format!("{} and {} more", first.join(", "), names.len() - MOST)
        }
        _ => names.join(", "),
    }
}
