//! How the six cell parameters become lengths in space: Cartesian frame, metric and volume.

/// The shortest and longest edge accepted, in ångström.
pub const EDGE_RANGE: (f64, f64) = (1e-3, 1e6);

/// A unit cell by its six parameters: edges in ångström, angles in degrees.
///
/// The Cartesian frame is the usual one: `a` along +x, `b` in the xy plane towards +y, `c` with a
/// positive z component (right-handed).
///
/// ```
/// use ga_design::crystallography::Cell;
///
/// let quartz = Cell::new([4.916, 4.916, 5.4054], [90.0, 90.0, 120.0])?;
/// assert!((quartz.volume() - 113.13).abs() < 0.01);
/// # Ok::<(), ga_design::crystallography::CellError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    edges: [f64; 3],
    angles: [f64; 3],
    basis: [[f64; 3]; 3],
    inverse: [[f64; 3]; 3],
}

/// Why six numbers are no unit cell.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CellError {
    /// An edge is not a usable length.
    #[error("cell edge {name} is {value}; it must lie between 0.001 and 1000000 ångström")]
    Edge {
        /// `a`, `b` or `c`.
        name: char,
        /// The value given.
        value: f64,
    },
    /// An angle is not between 0° and 180°.
    #[error("cell angle {name} is {value}; it must lie between 0 and 180 degrees")]
    Angle {
        /// `alpha`, `beta` or `gamma`.
        name: &'static str,
        /// The value given.
        value: f64,
    },
    /// The three angles cannot meet in one corner, or only in a flat one.
    #[error(
        "no cell has the angles {alpha}, {beta}, {gamma}: each must be smaller than the sum of the \
         other two, and all three together smaller than 360 degrees"
    )]
    Flat {
        /// Between `b` and `c`, in degrees.
        alpha: f64,
        /// Between `c` and `a`, in degrees.
        beta: f64,
        /// Between `a` and `b`, in degrees.
        gamma: f64,
    },
}

impl Cell {
    /// The cell with edges `a, b, c` (ångström) and angles `alpha, beta, gamma` (degrees).
    pub fn new(edges: [f64; 3], angles: [f64; 3]) -> Result<Self, CellError> {
        for (name, value) in ['a', 'b', 'c'].into_iter().zip(edges) {
            if !(value >= EDGE_RANGE.0 && value <= EDGE_RANGE.1) {
                return Err(CellError::Edge { name, value });
            }
        }
        for (name, value) in ["alpha", "beta", "gamma"].into_iter().zip(angles) {
            if !(value > 0.0 && value < 180.0) {
                return Err(CellError::Angle { name, value });
            }
        }
        let [a, b, c] = edges;
        let [ca, cb, cg] = angles.map(cosine);
        let sine = (1.0 - cg * cg).max(0.0).sqrt();
        let tilt = (ca - cb * cg) / sine;
        let height = 1.0 - cb * cb - tilt * tilt;
        // A height of 1e-3 of the edge is far below any lattice; what is flatter is a mistake.
        if sine.is_nan() || height.is_nan() || sine < 1e-3 || height < 1e-6 {
            let [alpha, beta, gamma] = angles;
            return Err(CellError::Flat { alpha, beta, gamma });
        }
        let height = height.sqrt();
        let basis = [
            [a, b * cg, c * cb],
            [0.0, b * sine, c * tilt],
            [0.0, 0.0, c * height],
        ];
        Ok(Self {
            edges,
            angles,
            basis,
            inverse: upper_inverse(&basis),
        })
    }

    /// The edges `a, b, c` in ångström.
    pub fn edges(&self) -> [f64; 3] {
        self.edges
    }

    /// The angles `alpha, beta, gamma` in degrees.
    pub fn angles(&self) -> [f64; 3] {
        self.angles
    }

    /// The matrix from fractional to Cartesian coordinates, row by row: its columns are the edge
    /// vectors. It is upper triangular.
    pub fn basis(&self) -> [[f64; 3]; 3] {
        self.basis
    }

    /// The edge vectors `a, b, c` in Cartesian coordinates, in ångström.
    pub fn edge_vectors(&self) -> [[f64; 3]; 3] {
        let m = &self.basis;
        [0, 1, 2].map(|j| [m[0][j], m[1][j], m[2][j]])
    }

    /// The Cartesian position of a point given in fractions of the edges, in ångström.
    pub fn cartesian(&self, fractional: [f64; 3]) -> [f64; 3] {
        image(&self.basis, fractional)
    }

    /// The fractions of the edges at a Cartesian position.
    pub fn fractional(&self, cartesian: [f64; 3]) -> [f64; 3] {
        image(&self.inverse, cartesian)
    }

    /// The volume in cubic ångström.
    pub fn volume(&self) -> f64 {
        self.basis[0][0] * self.basis[1][1] * self.basis[2][2]
    }

    /// The metric tensor: the scalar products of the edge vectors, in square ångström.
    pub fn metric(&self) -> [[f64; 3]; 3] {
        let vectors = self.edge_vectors();
        vectors.map(|u| vectors.map(|v| dot(u, v)))
    }

    /// The distances between opposite faces (across `a`, `b`, `c`) in ångström.
    pub fn face_distances(&self) -> [f64; 3] {
        self.inverse.map(|row| 1.0 / dot(row, row).sqrt())
    }
}

/// The cosine of an angle in degrees, exact for the angles of the seven systems.
fn cosine(degrees: f64) -> f64 {
    if degrees == 90.0 {
        0.0
    } else if degrees == 120.0 {
        -0.5
    } else if degrees == 60.0 {
        0.5
    } else {
        degrees.to_radians().cos()
    }
}

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

pub(super) fn image(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| dot(row, v))
}

/// The inverse of an upper triangular matrix with a diagonal that is not zero.
pub(super) fn upper_inverse(m: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let (x, y, z) = (1.0 / m[0][0], 1.0 / m[1][1], 1.0 / m[2][2]);
    let xy = -m[0][1] * x * y;
    let yz = -m[1][2] * y * z;
    let xz = (m[0][1] * m[1][2] * y - m[0][2]) * x * z;
    [[x, xy, xz], [0.0, y, yz], [0.0, 0.0, z]]
}
