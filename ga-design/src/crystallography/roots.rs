//! Which three root vectors two numbers p and q stand for (3.1–3.8), and which p and q have none.

use std::f64::consts::PI;

use ga_cga::Vector3;

/// The largest p or q accepted; a dihedral group of this p has four times as many elements.
pub const LARGEST_ANGLE_NUMBER: u32 = 1000;

/// A radicand that is smaller in size is zero: the smallest that is not, of (2, 1000), is 1e-5.
const FLAT: f64 = 1e-9;

/// The roots **a**, **b**, **c**: unit vectors at the angles π/p (**a** to **b**), π/q (**b** to
/// **c**) and π/2 (**c** to **a**), so that `(ab)^p = (bc)^q = (ca)² = −1` (3.1).
///
/// **a** = e₁ and **c** = e₃ (the dissertation prints e₂), and (3.6–3.8) come down to
/// **b** = (cos π/p, √(1 − cos²π/p − cos²π/q), cos π/q), which also holds for p = 1, where the
/// printed form divides by sin π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roots {
    /// Along e₁.
    pub a: Vector3,
    /// At π/p from **a** and π/q from **c**, with a component along e₂ that is not negative.
    pub b: Vector3,
    /// Along e₃.
    pub c: Vector3,
    p: u32,
    q: u32,
}

/// Why p and q have no roots, or roots of no finite group.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RootsError {
    /// A number that is no divisor of the half turn.
    #[error(
        "{name} = {value} is no root angle: π/{name} needs a whole number from 1 to \
         {LARGEST_ANGLE_NUMBER}"
    )]
    Number {
        /// `p` or `q`.
        name: char,
        /// The value given.
        value: u32,
    },
    /// The two angles together are smaller than the right angle that they must span.
    #[error(
        "p = {p}, q = {q} do not close: from a to b is π/{p}, from b to c π/{q}, together less \
         than the right angle from a to c (1 − cos²π/p − cos²π/q = {radicand:.4} is negative); \
         1/p + 1/q must exceed 1/2"
    )]
    Open {
        /// The first number.
        p: u32,
        /// The second number.
        q: u32,
        /// 1 − cos²π/p − cos²π/q.
        radicand: f64,
    },
    /// The three roots lie in one plane.
    #[error(
        "p = {p}, q = {q} is the limit 1/p + 1/q = 1/2: the roots fall into one plane and the \
         group of these angles is no point group but an infinite one, a tiling of the plane"
    )]
    Planar {
        /// The first number.
        p: u32,
        /// The second number.
        q: u32,
    },
}

impl Roots {
    /// The roots of p and q.
    ///
    /// ```
    /// use ga_design::crystallography::Roots;
    ///
    /// let cube = Roots::new(4, 3)?;
    /// let half = 0.5_f64;
    /// assert!((cube.b - ga_cga::Vector3::new(half.sqrt(), half, half)).norm() < 1e-15);
    /// let error = Roots::new(4, 5).unwrap_err();
    /// assert!(error.to_string().contains("1/p + 1/q must exceed 1/2"));
    /// # Ok::<(), ga_design::crystallography::RootsError>(())
    /// ```
    ///
    /// # Errors
    /// [`RootsError`]: a number out of range; angles too small to span the right angle, such as
    /// 4, 5; the planar limits 4, 4 and 6, 3 and 3, 6.
    pub fn new(p: u32, q: u32) -> Result<Self, RootsError> {
        for (name, value) in [('p', p), ('q', q)] {
            if !(1..=LARGEST_ANGLE_NUMBER).contains(&value) {
                return Err(RootsError::Number { name, value });
            }
        }
        let (to_a, to_c) = (cosine(p), cosine(q));
        let radicand = 1.0 - to_a * to_a - to_c * to_c;
        if radicand < -FLAT {
            return Err(RootsError::Open { p, q, radicand });
        }
        // Where b is opposite to a, or to c, it spans no angle, and nothing has collapsed.
        let opposite = p == 1 || q == 1;
        if radicand <= FLAT && !opposite {
            return Err(RootsError::Planar { p, q });
        }
        let aside = if opposite { 0.0 } else { radicand.sqrt() };
        Ok(Self {
            a: Vector3::new(1.0, 0.0, 0.0),
            b: Vector3::new(to_a, aside, to_c),
            c: Vector3::new(0.0, 0.0, 1.0),
            p,
            q,
        })
    }

    /// The number p of the angle π/p from **a** to **b**.
    pub fn p(&self) -> u32 {
        self.p
    }

    /// The number q of the angle π/q from **b** to **c**.
    pub fn q(&self) -> u32 {
        self.q
    }

    /// The roots in their order: **a**, **b**, **c**.
    pub fn vectors(&self) -> [Vector3; 3] {
        [self.a, self.b, self.c]
    }
}

/// cos π/n, exact where it is 0, ±1 or ½.
fn cosine(n: u32) -> f64 {
    match n {
        1 => -1.0,
        2 => 0.0,
        3 => 0.5,
        _ => (PI / f64::from(n)).cos(),
    }
}
