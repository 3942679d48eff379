//! Names that are used once are taken back where that costs nothing, and sums begin with what is
//! added.

use super::cube::{Cube, Name, Term};
use super::network::{Meaning, Network};

/// Takes names back and turns signs.
pub fn tidy(network: &mut Network) {
    while let Some((name, place)) = superfluous(network) {
        put_back(network, name, place);
    }
    turn_signs(network);
}

/// The sums that are not outputs, by number.
fn named_sums(network: &Network) -> Vec<(Name, usize)> {
    (1..=network.names() as Name)
        .filter_map(|name| match network.meaning(name) {
            Meaning::Sum(place) if !network.outputs.contains(&place) => Some((name, place)),
            _ => None,
        })
        .collect()
}

/// A named sum that is a copy of one value, or is used once, alone or as a product that has room
/// for its factors.
fn superfluous(network: &Network) -> Option<(Name, usize)> {
    let mut uses = vec![(0, Cube::ONE); network.names() + 1];
    for term in network.sums.iter().flatten() {
        for name in term.cube.names() {
            let (count, cube) = &mut uses[usize::from(name)];
            *count += 1;
            *cube = term.cube;
        }
    }
    named_sums(network).into_iter().find(|(name, place)| {
        let (count, user) = uses[usize::from(*name)];
        match network.sums[*place].as_slice() {
            [] => false,
            [single] => {
                let plain = !single.cube.names().any(|n| network.is_constant(n));
                let copied = single.cube.degree() == 1;
                // A product of three is written as one; beyond that names are easier to read.
                let room = single.cube.degree() + user.degree() <= 4;
                plain && count > 0 && (copied || (count == 1 && room))
            }
            _ => count == 1 && user.degree() == 1,
        }
    })
}

/// Writes a named sum where its name stands.
fn put_back(network: &mut Network, name: Name, place: usize) {
    let definition = std::mem::take(&mut network.sums[place]);
    for sum in &mut network.sums {
        let mut added = Vec::new();
        sum.retain(|term| {
            let power = term.cube.power(name);
            let mut products = vec![*term];
            for _ in 0..power {
                products = products
                    .iter()
                    .flat_map(|product| {
                        definition.iter().map(|part| Term {
                            cube: product.cube.over(Cube::of(name)).times(part.cube),
                            negative: product.negative != part.negative,
                        })
                    })
                    .collect();
            }
            if power > 0 {
                added.extend(products);
            }
            power == 0
        });
        sum.extend(added);
    }
}

/// Turns the sign of every named sum that has only subtracted terms.
fn turn_signs(network: &mut Network) {
    for (name, place) in named_sums(network) {
        let sum = &mut network.sums[place];
        if !sum.iter().all(|term| term.negative) {
            continue;
        }
        for term in sum.iter_mut() {
            term.negative = false;
        }
        for term in network.sums.iter_mut().flatten() {
            term.negative ^= term.cube.power(name) % 2 == 1;
        }
    }
}
