//! What an element is in the conformal model: an axis the line and dual line in Cartesian space, a plane
//! the dual plane that reflects in it, a centre the point.

use ga_cga::{DualLine, DualPlane, Line, Point, Vector3};

use super::extent::float;
use super::{Axis, InversionCentre, LatticeLine, LatticePlane, ReflectionPlane};
use crate::crystallography::{Cell, Motion};

impl Motion {
    /// The axis of a screw, rotation or rotoinversion as the dual line of weight 1 that generates it,
    /// anticlockwise seen against its direction; `None` for other motions.
    ///
    /// It is the line in the logarithm of the motor, −½ (θ λ + …), whose other part, the pitch, commutes
    /// with it.
    ///
    /// ```
    /// use ga_cga::{DualLine, Motor, Point, Vector3};
    /// use ga_design::crystallography::Isometry;
    ///
    /// let axis = DualLine::along(Point::at(1.0, 2.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
    /// let screw = Isometry::from(Motor::screw(axis, 1.0, 0.5).unwrap());
    /// let found = screw.motion().axis().unwrap();
    /// assert!((found - axis).to_array().iter().all(|part| part.abs() < 1e-12));
    /// ```
    pub fn axis(&self) -> Option<DualLine> {
        match *self {
            Motion::Screw { through, axis, .. } => Some(DualLine::along(through, axis)),
            Motion::RotoInversion { center, axis, .. } => Some(DualLine::along(center, axis?)),
            Motion::Identity | Motion::Translation { .. } | Motion::Glide { .. } => None,
        }
    }

    /// The plane of a reflection or glide, as the versor that reflects in it; `None` for other motions.
    pub fn plane(&self) -> Option<DualPlane> {
        match *self {
            Motion::Glide { plane, .. } => Some(plane),
            _ => None,
        }
    }

    /// The point that an inversion or rotoinversion leaves in place; `None` for other motions.
    pub fn center(&self) -> Option<Point> {
        match *self {
            Motion::RotoInversion { center, .. } => Some(center),
            _ => None,
        }
    }
}

impl LatticeLine {
    /// The line in the Cartesian frame of a cell (ångström), of weight 1; the translate of it that goes
    /// through [`LatticeLine::point`].
    ///
    /// ```
    /// use ga_cga::Vector3;
    /// use ga_design::crystallography::{Cell, symmetry_elements::LatticeLine};
    ///
    /// let cell = Cell::new([5.0, 5.0, 8.0], [90.0, 90.0, 120.0])?;
    /// let axis = LatticeLine::through([0, 0, 1], [0.into(); 3]).unwrap().line(&cell);
    /// assert_eq!(axis.direction(), Vector3::new(0.0, 0.0, 1.0));
    /// # Ok::<(), ga_design::crystallography::CellError>(())
    /// ```
    pub fn line(&self, cell: &Cell) -> Line {
        let along = Vector3::from(cell.cartesian(self.direction().map(|index| index as f64)));
        let [x, y, z] = cell.cartesian(self.point().map(float));
        let unit = along / along.norm();
        Line::along(Point::at(x, y, z), unit)
    }
}

impl LatticePlane {
    /// The plane in the Cartesian frame of a cell (ångström), its normal along the reciprocal vector
    /// `(hkl)*` and of length 1; the translate of it that goes through [`LatticePlane::point`].
    pub fn dual_plane(&self, cell: &Cell) -> DualPlane {
        let form = |x: [f64; 3]| {
            let terms = self.normal().into_iter().zip(cell.fractional(x));
            terms.map(|(index, part)| index as f64 * part).sum::<f64>()
        };
        // A form h·x is the scalar product with the vector of its values on a Cartesian frame.
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let normal = Vector3::from(axes.map(form));
        let length = normal.norm();
        DualPlane::at_distance(normal / length, float(self.offset()) / length)
    }
}

impl Axis {
    /// The dual line that generates the rotations about the axis and applied as a versor is the half
    /// turn about it, in the Cartesian frame of a cell (ångström).
    pub fn dual_line(&self, cell: &Cell) -> DualLine {
        self.line().line(cell).dual()
    }
}

impl ReflectionPlane {
    /// The plane as the versor that reflects in it, in the Cartesian frame of a cell (ångström).
    pub fn dual_plane(&self, cell: &Cell) -> DualPlane {
        self.place().dual_plane(cell)
    }
}

impl InversionCentre {
    /// The point in the Cartesian frame of a cell (ångström).
    pub fn conformal_point(&self, cell: &Cell) -> Point {
        let [x, y, z] = cell.cartesian(self.point().map(float));
        Point::at(x, y, z)
    }
}
