//! Which smaller cell a centred one holds, and how rhombohedral and hexagonal axes become each
//! other.

use ga_cga::Vector3;

use super::{CellParameters, Centring};

impl Centring {
    /// The edges of a primitive cell of the lattice that centred edges span: half or third
    /// diagonals, right-handed if the edges are. For R they are the rhombohedral axes.
    ///
    /// ```
    /// use ga_cga::Vector3;
    /// use ga_design::crystallography::Centring;
    ///
    /// let cube = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]].map(Vector3::from);
    /// let [a, _, _] = Centring::F.primitive_edges(cube);
    /// assert_eq!(a, Vector3::new(0.0, 2.0, 2.0));
    /// ```
    pub fn primitive_edges(self, edges: [Vector3; 3]) -> [Vector3; 3] {
        let [a, b, c] = edges;
        match self {
            Self::P => edges,
            Self::A => [a, (b + c) / 2.0, (c - b) / 2.0],
            Self::B => [(a - c) / 2.0, b, (a + c) / 2.0],
            Self::C => [(a + b) / 2.0, (b - a) / 2.0, c],
            Self::I => [(b + c - a) / 2.0, (c + a - b) / 2.0, (a + b - c) / 2.0],
            Self::F => [(b + c) / 2.0, (c + a) / 2.0, (a + b) / 2.0],
            Self::R => [
                (a * 2.0 + b + c) / 3.0,
                (b + c - a) / 3.0,
                (c - a - b * 2.0) / 3.0,
            ],
        }
    }
}

impl CellParameters {
    /// The cell of the same rhombohedral lattice on hexagonal axes, obverse and three times as
    /// large: **a** = **a**ᵣ − **b**ᵣ, **b** = **b**ᵣ − **c**ᵣ, **c** = **a**ᵣ + **b**ᵣ + **c**ᵣ.
    /// Cells of other shapes stay as they are; parameters of no cell give `None`.
    pub fn on_hexagonal_axes(self) -> Option<Self> {
        let Self::Rhombohedral { .. } = self else {
            return self.cell().ok().map(|_| self);
        };
        let [a, b, c] = self.cell().ok()?.edge_vectors().map(Vector3::from);
        Some(Self::Hexagonal {
            a: (a - b).norm(),
            c: (a + b + c).norm(),
        })
    }

    /// The primitive cell of the R-centred lattice with this hexagonal cell. Cells of other
    /// shapes stay as they are; parameters of no cell give `None`.
    ///
    /// ```
    /// use ga_design::crystallography::CellParameters;
    ///
    /// let calcite = CellParameters::Hexagonal { a: 4.9896, c: 17.061 };
    /// let Some(CellParameters::Rhombohedral { a, alpha }) = calcite.on_rhombohedral_axes() else {
    ///     panic!("a rhombohedron")
    /// };
    /// assert!((a - 6.375).abs() < 1e-3 && (alpha - 46.08).abs() < 0.01);
    /// ```
    pub fn on_rhombohedral_axes(self) -> Option<Self> {
        let Self::Hexagonal { .. } = self else {
            return self.cell().ok().map(|_| self);
        };
        let edges = self.cell().ok()?.edge_vectors().map(Vector3::from);
        let [a, b, _] = Centring::R.primitive_edges(edges);
        let length = a.norm();
        let cosine = a.scalar_product(b) / (length * length);
        Some(Self::Rhombohedral {
            a: length,
            alpha: cosine.clamp(-1.0, 1.0).acos().to_degrees(),
        })
    }
}
