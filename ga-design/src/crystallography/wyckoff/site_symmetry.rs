//! How a site-symmetry group is named: the oriented symbols of *International Tables* A, 2.1.3.12.
//!
//! A symbol has one place per class of equivalent symmetry directions of the crystal system. In a
//! place stand the symmetry elements along these directions, one for each that the site group
//! itself does not carry into another, and a dot where there are none: `.3m`, `m.2m`, `2/m..`.

use super::super::direction::{Direction, axis, image, order, signless};
use super::super::operation::Operation;
use super::super::symbols::CrystalSystem;
use super::super::symmetry_directions::symmetry_directions;

/// The oriented symbol of a finite group of operations that share a fixed point, on conventional
/// axes; `None` when one of them lies along no symmetry direction of the system.
pub fn symbol(group: &[Operation], system: CrystalSystem, rhombohedral: bool) -> Option<String> {
    let matrices: Vec<[[i32; 3]; 3]> = group.iter().map(Operation::rotation).collect();
    let mut elements: Vec<(Direction, Along)> = Vec::new();
    for operation in group {
        let Some(direction) = axis(operation) else {
            continue;
        };
        let at = match elements.iter().position(|(known, _)| *known == direction) {
            Some(at) => at,
            None => {
                elements.push((direction, Along::default()));
                elements.len() - 1
            }
        };
        if let Some((_, along)) = elements.get_mut(at) {
            along.add(operation);
        }
    }
    let centric = matrices.contains(&[[-1, 0, 0], [0, -1, 0], [0, 0, -1]]);
    if elements.is_empty() {
        return Some(if centric { "-1" } else { "1" }.to_owned());
    }
    let several = elements.len() > 1;
    let cubic_site = elements
        .iter()
        .filter(|(_, along)| along.order == 3)
        .count()
        > 1;
    let mut text = String::new();
    let mut placed = 0;
    let all = symmetry_directions(system);
    let classes = match system {
        CrystalSystem::Trigonal if rhombohedral => all.get(..2).unwrap_or(all),
        _ => all,
    };
    for class in classes {
        let mut inequivalent: Vec<(Direction, String)> = Vec::new();
        for (direction, along) in &elements {
            if !class.iter().any(|known| signless(*known) == *direction) {
                continue;
            }
            placed += 1;
            let mut images = matrices.iter().map(|w| signless(image(w, *direction)));
            if images.any(|image| inequivalent.iter().any(|(known, _)| *known == image)) {
                continue;
            }
            inequivalent.push((*direction, along.symbol(several, cubic_site)));
        }
        // Tables write `4/mm.m` and `-4m.2`, in cubic groups `mm2..` and in others `m2m.`.
        inequivalent.sort_by_key(|(_, element)| match element.as_str() {
            "m" if system == CrystalSystem::Cubic => 1,
            "m" => 3,
            "2" => 2,
            _ => 0,
        });
        if inequivalent.is_empty() && system != CrystalSystem::Monoclinic {
            text.push('.');
        }
        text.extend(inequivalent.into_iter().map(|(_, element)| element));
    }
    (placed == elements.len()).then_some(text)
}

/// What there is along one direction.
#[derive(Clone, Copy, Debug, Default)]
struct Along {
    /// The highest order of a rotation.
    order: i32,
    mirror: bool,
    /// The highest order of a rotoinversion other than a mirror.
    barred: i32,
}

impl Along {
    fn add(&mut self, operation: &Operation) {
        let sign = operation.determinant();
        let order = order(operation);
        match (sign, order) {
            (1, _) => self.order = self.order.max(order),
            (_, 2) => self.mirror = true,
            _ => self.barred = self.barred.max(order),
        }
    }

    fn symbol(self, several: bool, cubic_site: bool) -> String {
        match (self.order, self.mirror, self.barred) {
            (2, true, 0) if several => String::from("m"),
            (4, true, _) if cubic_site => String::from("m"),
            (0 | 1, true, _) => String::from("m"),
            (3, true, 6) => String::from("-6"),
            (order, true, _) => format!("{order}/m"),
            (order, false, 0) => order.to_string(),
            (_, false, barred) => format!("-{barred}"),
        }
    }
}
