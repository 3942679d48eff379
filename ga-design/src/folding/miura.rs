//! The Miura pattern, folded corner after corner by spheres (figures 2.18, 2.19).

use super::{FoldError, FoldMode, Meeting, Vertex};
use ga_cga::{Point, Translator, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// The largest number of panels in a row.
const MOST: usize = 200;

/// A Miura pattern of equal parallelograms: straight creases one way, zigzags the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miura {
    straight: f64,
    zigzag: f64,
    angle: f64,
    panels: [usize; 2],
}

/// A folded sheet: its corners in rows along the zigzags.
#[derive(Debug, Clone, PartialEq)]
pub struct FoldedSheet {
    rows: Vec<Vec<Point>>,
}

impl Miura {
    /// The pattern with edges of these lengths along the straight creases and the zigzags, the
    /// acute angle between them in radians, and a number of panels along the straight creases and
    /// along the zigzags, each at least two.
    ///
    /// # Errors
    /// [`FoldError`] if a length is not positive, the angle not between 0 and π/2, or a number of
    /// panels not from 2 to 200.
    pub fn new(
        straight: f64,
        zigzag: f64,
        angle: f64,
        panels: [usize; 2],
    ) -> Result<Self, FoldError> {
        for (what, value) in [("the straight edge", straight), ("the zigzag edge", zigzag)] {
            if !value.is_finite() || value <= 0.0 {
                return Err(FoldError::Length { what, value });
            }
        }
        let acute = angle > 0.0 && angle < FRAC_PI_2;
        if !acute {
            return Err(FoldError::Angle {
                what: "the angle of the parallelograms",
                value: angle,
                range: "between 0 and π/2",
            });
        }
        if let Some(value) = panels.into_iter().find(|n| !(2..=MOST).contains(n)) {
            return Err(FoldError::Count {
                what: "the number of panels",
                value,
                least: 2,
                most: MOST,
            });
        }
        Ok(Miura {
            straight,
            zigzag,
            angle,
            panels,
        })
    }

    /// The sheet before folding.
    #[must_use]
    pub fn flat(&self) -> FoldedSheet {
        let (sin, cos) = self.angle.sin_cos();
        let across = Vector3::new(self.zigzag * sin, 0.0, 0.0);
        let along = Vector3::new(0.0, self.straight, 0.0);
        let slant = Vector3::new(0.0, self.zigzag * cos, 0.0);
        let [rows, columns] = self.panels;
        let corner = |row: usize, column: usize| {
            let odd = (column % 2) as f64;
            Point::from(along * row as f64 + across * column as f64 + slant * odd)
        };
        let row = |row| (0..=columns).map(|column| corner(row, column)).collect();
        FoldedSheet {
            rows: (0..=rows).map(row).collect(),
        }
    }

    /// The sheet with its panels at an angle θ in radians, from 0 to below π/2, to the plane in
    /// which it folds up: the zigzags fold by 2θ.
    ///
    /// One vertex is folded by its driven crease. From it the others follow: across a vertex with
    /// three known creases the fourth corner is where three spheres meet, and the last corner of a
    /// panel of which three are known is that of the parallelogram.
    ///
    /// # Errors
    /// [`FoldError::Angle`] if the angle is out of range.
    pub fn fold(&self, angle: f64) -> Result<FoldedSheet, FoldError> {
        let inside = (0.0..FRAC_PI_2).contains(&angle);
        if !inside {
            return Err(FoldError::Angle {
                what: "the inclination of the panels",
                value: angle,
                range: "from 0 to below π/2",
            });
        }
        let flat = self.flat();
        if angle == 0.0 {
            return Ok(flat);
        }
        let mut folding = Folding {
            flat: &flat,
            placed: flat.rows.iter().map(|row| vec![None; row.len()]).collect(),
        };
        folding.start(self, angle)?;
        let [rows, columns] = self.panels;
        // Along both middle lines vertex follows vertex; the panels between are closed one by one,
        // which adds rounding errors up and does not multiply them.
        for column in 3..=columns {
            folding.cross([1, column], [0, 1])?;
            for row in [0, 2] {
                folding.close(
                    [row, column],
                    [[1, column], [row, column - 1], [1, column - 1]],
                )?;
            }
        }
        for row in 3..=rows {
            folding.cross([row, 1], [1, 0])?;
            folding.close([row, 0], [[row, 1], [row - 1, 0], [row - 1, 1]])?;
            for column in 2..=columns {
                let others = [[row, column - 1], [row - 1, column], [row - 1, column - 1]];
                folding.close([row, column], others)?;
            }
        }
        let rows = folding.placed.into_iter();
        let rows = rows.map(|row| row.into_iter().collect::<Option<Vec<Point>>>());
        let rows = rows.collect::<Option<Vec<_>>>().ok_or(APART)?;
        Ok(FoldedSheet { rows })
    }
}

/// A sheet in the making: where each corner was, and where it is as far as that is known.
struct Folding<'a> {
    flat: &'a FoldedSheet,
    placed: Vec<Vec<Option<Point>>>,
}

impl Folding<'_> {
    /// Places the nine corners about the vertex in row 1 and column 1.
    fn start(&mut self, pattern: &Miura, angle: f64) -> Result<(), FoldError> {
        // At an odd column the zigzags lean back, so that the sectors beside the straight crease
        // behind are the acute ones.
        let (acute, obtuse) = (pattern.angle, PI - pattern.angle);
        let vertex = Vertex::new([acute, obtuse, obtuse, acute])?;
        let corners = vertex.fold(2.0 * angle, FoldMode::Alike)?.corners();
        let edges = [
            pattern.straight,
            pattern.zigzag,
            pattern.straight,
            pattern.zigzag,
        ];
        let [behind, right, ahead, left] =
            std::array::from_fn(|i| Point::from(corners[i].position() * edges[i]));
        let middle = Point::from(Vector3::default());
        let known = [
            ([1, 1], middle),
            ([0, 1], behind),
            ([1, 2], right),
            ([2, 1], ahead),
            ([1, 0], left),
        ];
        for (place, corner) in known {
            self.set(place, corner);
        }
        for row in [0, 2] {
            for column in [0, 2] {
                self.close([row, column], [[1, column], [row, 1], [1, 1]])?;
            }
        }
        Ok(())
    }

    /// Places the corner across a vertex, one step from it in rows or columns, whose three other
    /// neighbours are known: where the spheres about the vertex and its neighbours aside meet.
    fn cross(
        &mut self,
        [row, column]: [usize; 2],
        [down, right]: [usize; 2],
    ) -> Result<(), FoldError> {
        let [vertex, behind] = [1, 2].map(|n| [row - n * down, column - n * right]);
        let aside = [
            [vertex[0] - right, vertex[1] - down],
            [vertex[0] + right, vertex[1] + down],
        ];
        let meeting = self.meeting([row, column], [vertex, aside[0], aside[1]])?;
        let behind = self.get(behind)?;
        // The two places are mirror images. Along a row the wrong one is where the corner behind
        // is; along a straight crease the folds alternate, and the wrong one goes on climbing.
        let sign = if right == 1 { 1.0 } else { -1.0 };
        let corner = meeting.with_most(|corner| sign * corner.distance(behind));
        self.set([row, column], corner.ok_or(APART)?);
        Ok(())
    }

    /// Places the last corner of a panel: the translation from the corner opposite to it to the
    /// one neighbour takes the other neighbour there. The spheres about the three would touch
    /// there, and a root at a double place would cost half of the digits.
    fn close(
        &mut self,
        place: [usize; 2],
        [one, other, opposite]: [[usize; 2]; 3],
    ) -> Result<(), FoldError> {
        let edge = Translator::between(self.get(opposite)?, self.get(one)?);
        let corner = edge.apply(self.get(other)?);
        self.set(place, corner);
        Ok(())
    }

    /// Where the spheres about three corners meet, through a fourth on the flat paper.
    fn meeting(&self, place: [usize; 2], others: [[usize; 2]; 3]) -> Result<Meeting, FoldError> {
        let flat = |place: [usize; 2]| self.flat.corner(place).ok_or(APART);
        let [a, b, c] = others;
        let centers = [self.get(a)?, self.get(b)?, self.get(c)?];
        let before = [flat(a)?, flat(b)?, flat(c)?];
        Ok(Meeting::of_moved(before, flat(place)?, centers))
    }

    fn get(&self, [row, column]: [usize; 2]) -> Result<Point, FoldError> {
        let corner = self.placed.get(row).and_then(|row| row.get(column));
        corner.copied().flatten().ok_or(APART)
    }

    fn set(&mut self, [row, column]: [usize; 2], corner: Point) {
        if let Some(place) = self.placed.get_mut(row).and_then(|row| row.get_mut(column)) {
            *place = Some(corner);
        }
    }
}

/// That the corner in question has no place.
const APART: FoldError = FoldError::Apart {
    corner: "a corner of the sheet",
};

impl FoldedSheet {
    /// The corners in rows along the zigzags.
    #[must_use]
    pub fn rows(&self) -> &[Vec<Point>] {
        &self.rows
    }

    /// The corner in this row and column.
    #[must_use]
    pub fn corner(&self, [row, column]: [usize; 2]) -> Option<Point> {
        self.rows.get(row)?.get(column).copied()
    }

    /// The panels, each by its corners in order round.
    pub fn panels(&self) -> impl Iterator<Item = [Point; 4]> + '_ {
        self.rows.windows(2).flat_map(|pair| {
            let [near, far] = [&pair[0], &pair[1]];
            near.windows(2)
                .zip(far.windows(2))
                .map(|(near, far)| [near[0], near[1], far[1], far[0]])
        })
    }
}
