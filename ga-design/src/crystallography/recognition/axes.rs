//! Which edges along the symmetry directions a group in a primitive cell may have.
//!
//! Each candidate is a matrix whose columns are the edges, in primitive coordinates, right-handed.
//! There are several where the metric alone does not tell: which edge is a, which of two senses.

use super::super::direction::{self, Direction};
use super::super::operation::Operation;
use super::super::smith::SmithForm;
use super::super::symbols::CrystalSystem;
use super::{Matrix, determinant};

type Vector = [i128; 3];

/// The edges to try, likeliest first.
pub fn candidates(primitive: &[Operation], system: CrystalSystem) -> Option<Vec<Matrix>> {
    match system {
        CrystalSystem::Triclinic => Some(vec![columns([[1, 0, 0], [0, 1, 0], [0, 0, 1]])]),
        CrystalSystem::Monoclinic => monoclinic(primitive),
        CrystalSystem::Orthorhombic => orthorhombic(primitive),
        CrystalSystem::Tetragonal => about_one_axis(primitive, 4),
        CrystalSystem::Trigonal | CrystalSystem::Hexagonal => about_one_axis(primitive, 3),
        CrystalSystem::Cubic => cubic(primitive),
    }
}

/// b along the axis; a and c a basis of the lattice across it, in all the ways that differ modulo
/// twice that lattice, which is all that centring and glide can tell.
fn monoclinic(primitive: &[Operation]) -> Option<Vec<Matrix>> {
    let turn = of_order(primitive, 2)?;
    let b = direction::axis(turn)?.map(i128::from);
    let plane = plane_across(turn, 2)?;
    let mut all = Vec::new();
    let small = [1, 0, -1];
    for (i, j) in pairs(&small) {
        for (k, l) in pairs(&small) {
            if (i * l - j * k) != 1 && (i * l - j * k) != -1 {
                continue;
            }
            let a = combined(&plane, i, j);
            let c = combined(&plane, k, l);
            all.push(right_handed([a, b, c], 1));
        }
    }
    Some(all)
}

/// The three axes in every order.
fn orthorhombic(primitive: &[Operation]) -> Option<Vec<Matrix>> {
    let axes = axes_of_order(primitive, 2);
    let [u, v, w] = axes.as_slice() else {
        return None;
    };
    let orders = [
        [u, v, w],
        [v, w, u],
        [w, u, v],
        [v, u, w],
        [u, w, v],
        [w, v, u],
    ];
    let wide = |order: [&Direction; 3]| order.map(|axis| axis.map(i128::from));
    Some(
        orders
            .into_iter()
            .map(|order| right_handed(wide(order), 2))
            .collect(),
    )
}

/// c along the axis, a a shortest vector across it, b its image under the rotation.
fn about_one_axis(primitive: &[Operation], order: i32) -> Option<Vec<Matrix>> {
    let turn = of_order(primitive, order)?;
    let c = direction::axis(turn)?.map(i128::from);
    let rotation = direction::proper(turn).map(|row| row.map(i128::from));
    let [mut a, mut other] = plane_across(turn, order)?;
    // The signed area of x and its image is a definite quadratic form, which the rotation keeps:
    // its reduction finds a vector that generates the plane together with its image.
    let pair = |x: &Vector, y: &Vector| {
        let image = super::times(&rotation, y);
        determinant(&columns([*x, image, c])) + {
            let image = super::times(&rotation, x);
            determinant(&columns([*y, image, c]))
        }
    };
    loop {
        let square = pair(&a, &a);
        if square == 0 {
            return None;
        }
        // The nearest whole number to the quotient of the two values.
        let (double, size) = (2 * pair(&a, &other) * square.signum(), square.abs());
        let steps = (double + size).div_euclid(2 * size);
        other = [0, 1, 2].map(|i| other[i] - steps * a[i]);
        if pair(&other, &other).abs() >= size {
            break;
        }
        std::mem::swap(&mut a, &mut other);
    }
    let b = super::times(&rotation, &a);
    let minus = |v: Vector| v.map(|value| -value);
    // Turned by half a turn about c, and over about a diagonal.
    let senses = [
        [a, b, c],
        [minus(a), minus(b), c],
        [b, a, minus(c)],
        [minus(b), minus(a), minus(c)],
    ];
    Some(
        senses
            .into_iter()
            .map(|edges| right_handed(edges, 2))
            .collect(),
    )
}

/// Axes of order four, or of order two where there are none, carried into one another by a
/// threefold rotation; and the same turned by 90°.
fn cubic(primitive: &[Operation]) -> Option<Vec<Matrix>> {
    let order = if of_order(primitive, 4).is_some() {
        4
    } else {
        2
    };
    let axes = axes_of_order(primitive, order);
    let turn = direction::proper(of_order(primitive, 3)?);
    let first = *axes.first()?;
    let second = direction::image(&turn, first);
    let third = direction::image(&turn, second);
    let [a, b, c] = [first, second, third].map(|axis| axis.map(i128::from));
    let minus = |v: Vector| v.map(|value| -value);
    let upright = if determinant(&columns([a, b, c])) > 0 {
        [a, b, c]
    } else {
        [a, c, b]
    };
    let [a, b, c] = upright;
    Some(vec![columns([a, b, c]), columns([minus(b), a, c])])
}

fn of_order(primitive: &[Operation], order: i32) -> Option<&Operation> {
    primitive
        .iter()
        .find(|operation| direction::order(operation) == order)
}

/// The different axes of one order.
fn axes_of_order(primitive: &[Operation], order: i32) -> Vec<Direction> {
    let mut axes: Vec<Direction> = primitive
        .iter()
        .filter(|operation| direction::order(operation) == order)
        .filter_map(direction::axis)
        .collect();
    axes.sort_unstable();
    axes.dedup();
    axes
}

/// A basis of the lattice vectors that a rotation turns within a plane: those that the sum of its
/// powers carries to zero.
fn plane_across(turn: &Operation, order: i32) -> Option<[Vector; 2]> {
    let rotation = direction::proper(turn).map(|row| row.map(i128::from));
    let mut power = columns([[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    let mut sum = [[0; 3]; 3];
    for _ in 0..order {
        for (total, row) in sum.iter_mut().zip(power) {
            for (value, part) in total.iter_mut().zip(row) {
                *value += part;
            }
        }
        power = super::product(&power, &rotation);
    }
    match SmithForm::of(&sum)?.kernel().as_slice() {
        [u, v] => Some([*u, *v]),
        _ => None,
    }
}

fn pairs(values: &[i128]) -> impl Iterator<Item = (i128, i128)> + '_ {
    values
        .iter()
        .flat_map(|one| values.iter().map(|other| (*one, *other)))
}

fn combined(plane: &[Vector; 2], i: i128, j: i128) -> Vector {
    let [u, v] = plane;
    [0, 1, 2].map(|at| i * u[at] + j * v[at])
}

/// The matrix with these columns, one of them turned round if it were left-handed.
fn right_handed(mut edges: [Vector; 3], to_turn: usize) -> Matrix {
    if determinant(&columns(edges)) < 0
        && let Some(edge) = edges.get_mut(to_turn)
    {
        *edge = edge.map(|value| -value);
    }
    columns(edges)
}

fn columns(edges: [Vector; 3]) -> Matrix {
    [0, 1, 2].map(|i| edges.map(|edge| edge[i]))
}
