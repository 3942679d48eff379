//! Functions of one's own on every element of a batch, or of two.

use ga_core::{Element, LengthMismatch};

use super::{common, fill, nothing, replace};
use crate::batch::Batch;
use crate::number::Number;
use crate::operand::Operand;
use crate::operation::{Map, Mapping, ZipMap, Zipping};

/// Functions of one's own.
impl<X, F> Batch<X>
where
    F: Number,
    X: Element<Number = F> + Send + Sync,
{
    /// A function of every element.
    ///
    /// ```
    /// use ga_lanes::{Batch, Lanes, Map};
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    /// use r3::Vector;
    ///
    /// /// The mirror image in the plane through the origin and across a vector, moved by it.
    /// struct Glide(Vector<f32>);
    ///
    /// impl Map<Vector<f32>> for Glide {
    ///     type Output = Vector<f32>;
    ///
    ///     #[inline(always)]
    ///     fn call<L: Lanes<f32>>(&self, x: Vector<L>) -> Vector<L> {
    ///         let normal = self.0.map(L::splat);
    ///         normal.apply(x) + normal
    ///     }
    /// }
    ///
    /// let batch = Batch::from_slice(&[Vector::new(1.0_f32, 2.0, 0.0); 5]);
    /// let images = batch.map(&Glide(Vector::new(2.0, 0.0, 0.0)));
    /// assert_eq!(images.get(4), Some(Vector::new(1.0, 2.0, 0.0)));
    /// ```
    pub fn map<K: Map<X>>(&self, function: &K) -> Batch<K::Output> {
        let mut out = Batch::new();
        self.map_into(function, &mut out);
        out
    }

    /// A function of every element, to a batch that exists, which takes the length.
    pub fn map_into<K: Map<X>>(&self, function: &K, out: &mut Batch<K::Output>) {
        fill(nothing::<F>(), self, &Mapping(function), self.len(), out);
    }

    /// Replaces every element by the value of a function.
    pub fn map_in_place<K: Map<X, Output = X>>(&mut self, function: &K) {
        replace(nothing::<F>(), &Mapping(function), self);
    }

    /// A function of the elements at the same place of two batches.
    ///
    /// ```
    /// use ga_lanes::{Batch, Lanes, ZipMap};
    /// # ga_macros::define_algebra! { crate = ga_core; R3 }
    /// use r3::Vector;
    ///
    /// /// The squared distance of two positions.
    /// struct SquaredDistance;
    ///
    /// impl ZipMap<Vector<f64>, Vector<f64>> for SquaredDistance {
    ///     type Output = f64;
    ///
    ///     #[inline(always)]
    ///     fn call<L: Lanes<f64>>(&self, x: Vector<L>, y: Vector<L>) -> L {
    ///         (x - y).norm_squared()
    ///     }
    /// }
    ///
    /// let a: Batch<_> = (0..9).map(|n| Vector::new(n as f64, 0.0, 0.0)).collect();
    /// let b: Batch<_> = (0..9).map(|n| Vector::new(0.0, n as f64, 0.0)).collect();
    /// assert_eq!(a.zip_map(&b, &SquaredDistance)?.get(8), Some(128.0));
    /// # Ok::<(), ga_lanes::LengthMismatch>(())
    /// ```
    ///
    /// # Errors
    /// [`LengthMismatch`] where the other batch has another length.
    pub fn zip_map<B, K>(&self, b: B, function: &K) -> Result<Batch<K::Output>, LengthMismatch>
    where
        B: Operand<Element: Element<Number = F>>,
        K: ZipMap<X, B::Element>,
    {
        let mut out = Batch::new();
        self.zip_map_into(b, function, &mut out)?;
        Ok(out)
    }

    /// A function of the elements at the same place of two batches, to a batch that exists, which
    /// takes the length.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the other batch has another length.
    pub fn zip_map_into<B, K>(
        &self,
        b: B,
        function: &K,
        out: &mut Batch<K::Output>,
    ) -> Result<(), LengthMismatch>
    where
        B: Operand<Element: Element<Number = F>>,
        K: ZipMap<X, B::Element>,
    {
        let len = common(self, &b)?;
        fill(self, b, &Zipping(function), len, out);
        Ok(())
    }
}
