//! The point of a circle that is nearest to another set of points: closed forms for planes and
//! spheres, bounded search for what can have several near minima.

use ga_core::Real;

use super::locus::{Locus, Unit, axes};
use crate::cga3::{Bivector3, Vector3};
use crate::classify::range;

/// How many arcs a search starts with, and how many it keeps at the most.
const ARCS: usize = 48;
const KEPT: usize = 12;

/// A circle with a direction that its angles count from.
#[derive(Clone, Copy)]
pub(super) struct Turn<T> {
    center: Vector3<T>,
    radius: T,
    /// Two directions of length 1 in its plane, at right angles and in its sense.
    axes: [Vector3<T>; 2],
}

impl<T: Real> Turn<T> {
    pub(super) fn new(center: Vector3<T>, radius: T, plane: Bivector3<T>) -> Self {
        let (first, second) = axes(plane);
        Turn {
            center,
            radius,
            axes: [first, second],
        }
    }

    /// The same circle with its angles counted from the part of a direction in its plane.
    fn counted_from(self, direction: Vector3<T>) -> Self {
        let plane = self.axes[0] ^ self.axes[1];
        let within: Vector3<T> = direction.project(plane);
        let first = within.unit().unwrap_or(self.axes[0]);
        Turn {
            axes: [first, first.left_contract(plane)],
            ..self
        }
    }

    fn at(self, (sin, cos): (T, T)) -> Vector3<T> {
        self.center + (self.axes[0] * cos + self.axes[1] * sin) * self.radius
    }

    fn ends(self) -> [Vector3<T>; 2] {
        let along = self.axes[0] * self.radius;
        [self.center - along, self.center + along]
    }

    /// The point nearest to a plane. Heights above it are h + k cos φ, with φ counted from the
    /// steepest direction: the lowest and the highest point are opposite to each other.
    pub(super) fn nearest_to_plane(self, place: Vector3<T>, normal: Vector3<T>) -> Vector3<T> {
        let turn = self.counted_from(normal);
        let ends = turn.ends();
        let [low, high] = ends.map(|x| normal.scalar_product(x - place));
        if T::ZERO.all_le(low) {
            ends[0]
        } else if high.all_le(T::ZERO) {
            ends[1]
        } else {
            turn.at(crossing(-low, high))
        }
    }

    /// The point nearest to a sphere. Squared distances from its centre are m + k cos φ, with φ
    /// counted from the direction away from it.
    pub(super) fn nearest_to_sphere(self, center: Vector3<T>, radius: T) -> Vector3<T> {
        let turn = self.counted_from(self.center - center);
        let ends = turn.ends();
        let [near, far] = ends.map(|x| range::length(x - center));
        if radius.all_le(near) {
            ends[0]
        } else if far.all_le(radius) {
            ends[1]
        } else {
            let off = |distance: T| (radius - distance) * (radius + distance);
            turn.at(crossing(off(near), -off(far)))
        }
    }

    /// The point nearest to any set, by branch and bound.
    ///
    /// The distance changes by no more than the arc that is walked, so an arc is left out if the
    /// distance at its middle exceeds the least one found by more than half its length. The others
    /// are quartered until none of them promises a lesser distance, going by its slope. Around a
    /// smooth minimum more and more pass that test, and those that promise the least are kept:
    /// to lose another minimum, the curvature there would have to be more than the square of their
    /// number times as large.
    pub(super) fn nearest_to(self, other: Locus<T>) -> Vector3<T> {
        let half = T::from_ratio(1, 2);
        let mut length = T::PI * T::from_ratio(2, ARCS as i64);
        let mut best = self.arc(other, T::ZERO, length);
        let mut arcs = Lowest::new();
        for index in 0..ARCS as i64 {
            let arc = self.arc(other, length * T::from_integer(index), length);
            best = best.nearer(arc);
            arcs.offer(arc);
        }
        while !length.all_le(T::EPSILON) {
            let rounding = (best.distance + self.radius) * T::EPSILON;
            if arcs
                .iter()
                .all(|arc| (best.distance - arc.promise).all_le(rounding))
            {
                break;
            }
            let bound = best.distance + self.radius * length * half;
            let quarter = length * T::from_ratio(1, 4);
            let mut quarters = Lowest::new();
            for arc in arcs.iter().filter(|arc| arc.distance.all_le(bound)) {
                for halves in [-3, -1, 1, 3] {
                    let middle = arc.middle + quarter * half * T::from_integer(halves);
                    let part = self.arc(other, middle, quarter);
                    best = best.nearer(part);
                    quarters.offer(part);
                }
            }
            (arcs, length) = (quarters, quarter);
        }
        self.at(best.middle.sin_cos())
    }

    fn arc(self, other: Locus<T>, middle: T, length: T) -> Arc<T> {
        let (sin, cos) = middle.sin_cos();
        let x = self.at((sin, cos));
        let gap = x - other.nearest(x);
        let distance = range::length(gap);
        // The cosine between the way from the nearest point to x and that along the circle, which
        // the rounding of the positions leaves open where the two points are close together.
        let along = self.axes[1] * cos - self.axes[0] * sin;
        let rounding = (range::length(x) + self.radius) * T::EPSILON * T::from_integer(16);
        let cosine = (gap.scalar_product(along).abs() + rounding) / distance;
        let slope = cosine.select_le(T::ONE, cosine, T::ONE);
        let fall = slope * self.radius * length * T::from_ratio(1, 2);
        Arc {
            middle,
            distance,
            promise: distance - fall,
        }
    }
}

/// Sine and cosine of the angle at which a quantity q = m + k cos φ is zero, from how far it is
/// below at φ = π and above at φ = 0: those are in the ratio of 1 + cos φ and 1 − cos φ.
fn crossing<T: Real>(below: T, above: T) -> (T, T) {
    let sum = below + above;
    let sin = (below.sqrt() * above.sqrt() / sum) * T::from_integer(2);
    (sin, (below - above) / sum)
}

/// An arc of a circle, and its distance from another set.
#[derive(Clone, Copy, Default)]
struct Arc<T> {
    /// The angle at its middle.
    middle: T,
    /// The distance there.
    distance: T,
    /// The least distance on the arc, if it keeps its slope.
    promise: T,
}

impl<T: Real> Arc<T> {
    fn nearer(self, other: Self) -> Self {
        if other.distance.all_le(self.distance) {
            other
        } else {
            self
        }
    }
}

/// The arcs that promise the least distances, in order.
struct Lowest<T> {
    arcs: [Arc<T>; KEPT],
    count: usize,
}

impl<T: Real> Lowest<T> {
    fn new() -> Self {
        Lowest {
            arcs: [Arc::default(); KEPT],
            count: 0,
        }
    }

    /// Takes an arc in, in place of the one that promises least where all places are taken.
    fn offer(&mut self, arc: Arc<T>) {
        let place = self
            .iter()
            .position(|other| arc.promise.all_le(other.promise))
            .unwrap_or(self.count);
        if place < KEPT {
            self.count = (self.count + 1).min(KEPT);
            self.arcs[place..self.count].rotate_right(1);
            self.arcs[place] = arc;
        }
    }

    fn iter(&self) -> impl Iterator<Item = &Arc<T>> {
        self.arcs.iter().take(self.count)
    }
}
