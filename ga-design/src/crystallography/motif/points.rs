//! How shapes made of points are motifs: curves, struts, and whatever carries a label.

use ga_cga::Point;

use super::{Coincidence, Fingerprint, Motif, MotifError};
use crate::crystallography::Isometry;

/// A polyline, open or closed.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The points, each once.
    pub points: Vec<Point>,
    /// Whether the last is joined to the first.
    pub is_closed: bool,
}

/// A straight bar between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strut {
    /// Its ends.
    pub ends: [Point; 2],
}

/// A shape with a label, such as an atom: copies with different labels never coincide.
///
/// ```
/// use ga_cga::Point;
/// use ga_design::crystallography::{Coincidence, Isometry, Labelled, Motif, Placement};
///
/// let atom = Labelled { label: "Si", shape: Point::at(1.0, 0.0, 0.0) };
/// let mirror = Isometry::from(&Placement { reflections: vec![[1.0, 0.0, 0.0]], translation: [0.0; 3] });
/// let image = atom.moved(&mirror)?;
/// assert_eq!(image.shape, Point::at(-1.0, 0.0, 0.0));
/// assert!(!image.coincides(&atom, &Coincidence::default()));
/// # Ok::<(), ga_design::crystallography::MotifError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Labelled<L, X> {
    /// The label.
    pub label: L,
    /// The shape.
    pub shape: X,
}

impl<L: Clone + PartialEq, X: Motif> Motif for Labelled<L, X> {
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError> {
        Ok(Self {
            label: self.label.clone(),
            shape: self.shape.moved(by)?,
        })
    }

    fn coincides(&self, other: &Self, when: &Coincidence) -> bool {
        self.label == other.label && self.shape.coincides(&other.shape, when)
    }

    fn fingerprint(&self, when: &Coincidence) -> Fingerprint {
        self.shape.fingerprint(when)
    }
}

impl Motif for Strut {
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError> {
        Ok(Self {
            ends: self.ends.map(|end| by.apply(end)),
        })
    }

    fn coincides(&self, other: &Self, when: &Coincidence) -> bool {
        let [a, b] = self.ends;
        let near =
            |[c, d]: [Point; 2]| a.distance(c) <= when.distance && b.distance(d) <= when.distance;
        let [c, d] = other.ends;
        near([c, d]) || (!when.is_oriented && near([d, c]))
    }

    fn fingerprint(&self, when: &Coincidence) -> Fingerprint {
        middle(&self.ends, when)
    }
}

impl Motif for Curve {
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError> {
        Ok(Self {
            points: self.points.iter().map(|point| by.apply(*point)).collect(),
            is_closed: self.is_closed,
        })
    }

    fn coincides(&self, other: &Self, when: &Coincidence) -> bool {
        let count = self.points.len();
        if count != other.points.len() || self.is_closed != other.is_closed {
            return false;
        }
        let Some(first) = self.points.first() else {
            return true;
        };
        // A closed curve may start anywhere.
        let starts = if self.is_closed { 0..count } else { 0..1 };
        let same_from = |points: &[Point], start: usize| {
            let turned = points.iter().cycle().skip(start);
            let mut pairs = self.points.iter().zip(turned);
            pairs.all(|(one, other)| one.distance(*other) <= when.distance)
        };
        let same = |points: &[Point]| {
            starts.clone().any(|start| {
                let begins = points.get(start);
                begins.is_some_and(|point| point.distance(*first) <= when.distance)
                    && same_from(points, start)
            })
        };
        let backwards = || other.points.iter().rev().copied().collect::<Vec<_>>();
        same(&other.points) || (!when.is_oriented && same(&backwards()))
    }

    fn fingerprint(&self, when: &Coincidence) -> Fingerprint {
        middle(&self.points, when)
    }
}

/// The mean of points: it moves as far as they do.
pub(super) fn middle(points: &[Point], when: &Coincidence) -> Fingerprint {
    let count = points.len().max(1) as f64;
    let mut values = [0.0; 3];
    for point in points {
        for (value, coordinate) in values.iter_mut().zip(point.position().to_array()) {
            *value += coordinate / count;
        }
    }
    Fingerprint {
        values,
        tolerance: when.distance,
    }
}
