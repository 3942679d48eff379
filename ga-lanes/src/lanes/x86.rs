//! Which instruction of x86-64-v3 and of x86-64-v4 does what.

use core::arch::x86_64::*;
use core::mem::transmute;

use super::vector::Instructions;
use crate::target::{V3, V4};

macro_rules! instructions {
    (
        $target:ident $float:ident $register:ident $count:literal
        $(fn $method:ident($($argument:ident: $type:ty),*) $(-> $result:ty)? { $body:expr })*
    ) => {
        impl Instructions<$target> for $float {
            type Register = $register;
            type Array = [$float; $count];
            const COUNT: usize = $count;
            const ZEROS: $register = constant!($register, $float, $count, 0.0);
            const ONES: $register = constant!($register, $float, $count, 1.0);
            const PIS: $register = constant!($register, $float, $count, core::$float::consts::PI);
            const EPSILONS: $register = constant!($register, $float, $count, $float::EPSILON);

            #[inline(always)]
            fn arrays(numbers: &[$float]) -> &[[$float; $count]] {
                numbers.as_chunks().0
            }

            #[inline(always)]
            fn arrays_mut(numbers: &mut [$float]) -> &mut [[$float; $count]] {
                numbers.as_chunks_mut().0
            }

            #[inline(always)]
            fn array(lane: impl FnMut(usize) -> $float) -> [$float; $count] {
                core::array::from_fn(lane)
            }

            $(
                #[inline(always)]
                unsafe fn $method($($argument: $type),*) $(-> $result)? {
                    // SAFETY: the caller promises that the machine has the target's instructions;
                    // pointers come from references to as many numbers as a register holds.
                    unsafe { $body }
                }
            )*
        }
    };
}

macro_rules! constant {
    ($register:ident, $float:ident, $count:literal, $value:expr) => {
        // SAFETY: register and array are both as many numbers, and every bit pattern is one.
        unsafe { transmute::<[$float; $count], $register>([$value; $count]) }
    };
}

instructions! { V3 f32 __m256 8
    fn splat(value: f32) -> __m256 { _mm256_set1_ps(value) }
    fn load(array: &[f32; 8]) -> __m256 { _mm256_loadu_ps(array.as_ptr()) }
    fn store(array: &mut [f32; 8], a: __m256) { _mm256_storeu_ps(array.as_mut_ptr(), a) }
    fn sum(a: __m256, b: __m256) -> __m256 { _mm256_add_ps(a, b) }
    fn difference(a: __m256, b: __m256) -> __m256 { _mm256_sub_ps(a, b) }
    fn product(a: __m256, b: __m256) -> __m256 { _mm256_mul_ps(a, b) }
    fn ratio(a: __m256, b: __m256) -> __m256 { _mm256_div_ps(a, b) }
    fn product_plus(a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fmadd_ps(a, b, c) }
    fn minus_product_plus(a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fnmadd_ps(a, b, c) }
    fn negative(a: __m256) -> __m256 { _mm256_xor_ps(a, _mm256_set1_ps(-0.0)) }
    fn magnitude(a: __m256) -> __m256 { _mm256_andnot_ps(_mm256_set1_ps(-0.0), a) }
    fn root(a: __m256) -> __m256 { _mm256_sqrt_ps(a) }
    fn choose_le(a: __m256, b: __m256, then: __m256, otherwise: __m256) -> __m256 {
        _mm256_blendv_ps(otherwise, then, _mm256_cmp_ps::<_CMP_LE_OQ>(a, b))
    }
    fn are_le(a: __m256, b: __m256) -> bool {
        _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) == 0xff
    }
}

instructions! { V3 f64 __m256d 4
    fn splat(value: f64) -> __m256d { _mm256_set1_pd(value) }
    fn load(array: &[f64; 4]) -> __m256d { _mm256_loadu_pd(array.as_ptr()) }
    fn store(array: &mut [f64; 4], a: __m256d) { _mm256_storeu_pd(array.as_mut_ptr(), a) }
    fn sum(a: __m256d, b: __m256d) -> __m256d { _mm256_add_pd(a, b) }
    fn difference(a: __m256d, b: __m256d) -> __m256d { _mm256_sub_pd(a, b) }
    fn product(a: __m256d, b: __m256d) -> __m256d { _mm256_mul_pd(a, b) }
    fn ratio(a: __m256d, b: __m256d) -> __m256d { _mm256_div_pd(a, b) }
    fn product_plus(a: __m256d, b: __m256d, c: __m256d) -> __m256d { _mm256_fmadd_pd(a, b, c) }
    fn minus_product_plus(a: __m256d, b: __m256d, c: __m256d) -> __m256d { _mm256_fnmadd_pd(a, b, c) }
    fn negative(a: __m256d) -> __m256d { _mm256_xor_pd(a, _mm256_set1_pd(-0.0)) }
    fn magnitude(a: __m256d) -> __m256d { _mm256_andnot_pd(_mm256_set1_pd(-0.0), a) }
    fn root(a: __m256d) -> __m256d { _mm256_sqrt_pd(a) }
    fn choose_le(a: __m256d, b: __m256d, then: __m256d, otherwise: __m256d) -> __m256d {
        _mm256_blendv_pd(otherwise, then, _mm256_cmp_pd::<_CMP_LE_OQ>(a, b))
    }
    fn are_le(a: __m256d, b: __m256d) -> bool {
        _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) == 0xf
    }
}

instructions! { V4 f32 __m512 16
    fn splat(value: f32) -> __m512 { _mm512_set1_ps(value) }
    fn load(array: &[f32; 16]) -> __m512 { _mm512_loadu_ps(array.as_ptr()) }
    fn store(array: &mut [f32; 16], a: __m512) { _mm512_storeu_ps(array.as_mut_ptr(), a) }
    fn sum(a: __m512, b: __m512) -> __m512 { _mm512_add_ps(a, b) }
    fn difference(a: __m512, b: __m512) -> __m512 { _mm512_sub_ps(a, b) }
    fn product(a: __m512, b: __m512) -> __m512 { _mm512_mul_ps(a, b) }
    fn ratio(a: __m512, b: __m512) -> __m512 { _mm512_div_ps(a, b) }
    fn product_plus(a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fmadd_ps(a, b, c) }
    fn minus_product_plus(a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fnmadd_ps(a, b, c) }
    fn negative(a: __m512) -> __m512 { _mm512_xor_ps(a, _mm512_set1_ps(-0.0)) }
    fn magnitude(a: __m512) -> __m512 { _mm512_abs_ps(a) }
    fn root(a: __m512) -> __m512 { _mm512_sqrt_ps(a) }
    fn choose_le(a: __m512, b: __m512, then: __m512, otherwise: __m512) -> __m512 {
        _mm512_mask_blend_ps(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b), otherwise, then)
    }
    fn are_le(a: __m512, b: __m512) -> bool {
        _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b) == 0xffff
    }
}

instructions! { V4 f64 __m512d 8
    fn splat(value: f64) -> __m512d { _mm512_set1_pd(value) }
    fn load(array: &[f64; 8]) -> __m512d { _mm512_loadu_pd(array.as_ptr()) }
    fn store(array: &mut [f64; 8], a: __m512d) { _mm512_storeu_pd(array.as_mut_ptr(), a) }
    fn sum(a: __m512d, b: __m512d) -> __m512d { _mm512_add_pd(a, b) }
    fn difference(a: __m512d, b: __m512d) -> __m512d { _mm512_sub_pd(a, b) }
    fn product(a: __m512d, b: __m512d) -> __m512d { _mm512_mul_pd(a, b) }
    fn ratio(a: __m512d, b: __m512d) -> __m512d { _mm512_div_pd(a, b) }
    fn product_plus(a: __m512d, b: __m512d, c: __m512d) -> __m512d { _mm512_fmadd_pd(a, b, c) }
    fn minus_product_plus(a: __m512d, b: __m512d, c: __m512d) -> __m512d { _mm512_fnmadd_pd(a, b, c) }
    fn negative(a: __m512d) -> __m512d { _mm512_xor_pd(a, _mm512_set1_pd(-0.0)) }
    fn magnitude(a: __m512d) -> __m512d { _mm512_abs_pd(a) }
    fn root(a: __m512d) -> __m512d { _mm512_sqrt_pd(a) }
    fn choose_le(a: __m512d, b: __m512d, then: __m512d, otherwise: __m512d) -> __m512d {
        _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b), otherwise, then)
    }
    fn are_le(a: __m512d, b: __m512d) -> bool {
        _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) == 0xff
    }
}
