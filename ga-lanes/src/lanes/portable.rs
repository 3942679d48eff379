//! Lanes for every machine: what the compiler was told the target has, by way of `wide`.

use wide::{f32x4, f64x2};

use super::{Lanes, sealed};

macro_rules! portable {
    ($lanes:ident, $float:ident, $count:literal) => {
        impl sealed::Lanes for $lanes {}

        impl Lanes<$float> for $lanes {
            const COUNT: usize = $count;
            type Array = [$float; $count];

            #[inline(always)]
            fn splat(value: $float) -> Self {
                $lanes::new([value; $count])
            }

            #[inline(always)]
            fn load(array: &Self::Array) -> Self {
                $lanes::new(*array)
            }

            #[inline(always)]
            fn store(self, array: &mut Self::Array) {
                *array = self.to_array();
            }

            #[inline(always)]
            fn array(lane: impl FnMut(usize) -> $float) -> Self::Array {
                core::array::from_fn(lane)
            }

            #[inline(always)]
            fn arrays(numbers: &[$float]) -> &[Self::Array] {
                numbers.as_chunks().0
            }

            #[inline(always)]
            fn arrays_mut(numbers: &mut [$float]) -> &mut [Self::Array] {
                numbers.as_chunks_mut().0
            }
        }
    };
}

portable!(f32x4, f32, 4);
portable!(f64x2, f64, 2);
