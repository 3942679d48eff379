//! Which instruction of x86-64-v3 and of x86-64-v4 does what.

use core::arch::x86_64::*;
use core::mem::transmute;

use ga_core::Computation;

use super::instructions::Instructions;
use crate::target::{V3, V4};

macro_rules! instructions {
    (
        $target:ident $float:ident $bits:ident $register:ident $mask:ident $count:literal $bias:literal
        $(fn $method:ident($($argument:ident: $type:ty),*) $(-> $result:ty)? { $body:expr })*
    ) => {
        impl Instructions<$target> for $float {
            type Register = $register;
            type Outcome = $mask;
            type Array = [$float; $count];
            const COUNT: usize = $count;
            const BIAS: $float = $bias;
            const ZEROS: $register = constant!($register, $float, $count, 0.0);
            const ONES: $register = constant!($register, $float, $count, 1.0);
            const HALVES: $register = constant!($register, $float, $count, 0.5);
            const PIS: $register = constant!($register, $float, $count, core::$float::consts::PI);
            const EPSILONS: $register = constant!($register, $float, $count, $float::EPSILON);
            const SIGNS: $register = constant!($register, $float, $count, -0.0);
            const MAGNITUDES: $register = constant!($register, $bits, $count, $bits::MAX >> 1);
            const MANTISSAS: $register = constant!(
                $register,
                $bits,
                $count,
                (1 << ($float::MANTISSA_DIGITS - 1)) - 1
            );

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

            #[inline(always)]
            unsafe fn outlined<K: Computation>(computation: K) -> K::Output {
                // SAFETY: the caller promises that the machine has the target's instructions.
                unsafe { $target::outlined(computation) }
            }

            $(
                #[inline(always)]
                unsafe fn $method($($argument: $type),*) $(-> $result)? {
                    #[allow(unused_unsafe, reason = "masks of AVX-512 are integers")]
                    // SAFETY: the caller promises that the machine has the target's instructions;
                    // pointers come from references to as many numbers as a register holds.
                    unsafe { $body }
                }
            )*
        }
    };
}

macro_rules! constant {
    ($register:ident, $number:ident, $count:literal, $value:expr) => {
        // SAFETY: register and array are equally long, and every bit pattern is a register.
        unsafe { transmute::<[$number; $count], $register>([$value; $count]) }
    };
}

impl V3 {
    /// A computation in a function of its own that has the instructions of the target.
    #[inline(never)]
    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt")]
    fn outlined<K: Computation>(computation: K) -> K::Output {
        computation.run()
    }
}

impl V4 {
    /// A computation in a function of its own that has the instructions of the target.
    #[inline(never)]
    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt")]
    #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
    fn outlined<K: Computation>(computation: K) -> K::Output {
        computation.run()
    }
}

instructions! { V3 f32 u32 __m256 __m256 8 127.0
    fn same(value: f32) -> __m256 { _mm256_set1_ps(value) }
    fn load(array: &[f32; 8]) -> __m256 { _mm256_loadu_ps(array.as_ptr()) }
    fn store(array: &mut [f32; 8], a: __m256) { _mm256_storeu_ps(array.as_mut_ptr(), a) }
    fn sum(a: __m256, b: __m256) -> __m256 { _mm256_add_ps(a, b) }
    fn difference(a: __m256, b: __m256) -> __m256 { _mm256_sub_ps(a, b) }
    fn product(a: __m256, b: __m256) -> __m256 { _mm256_mul_ps(a, b) }
    fn ratio(a: __m256, b: __m256) -> __m256 { _mm256_div_ps(a, b) }
    fn product_plus(a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fmadd_ps(a, b, c) }
    fn minus_product_plus(a: __m256, b: __m256, c: __m256) -> __m256 { _mm256_fnmadd_ps(a, b, c) }
    fn root(a: __m256) -> __m256 { _mm256_sqrt_ps(a) }
    fn and(a: __m256, b: __m256) -> __m256 { _mm256_and_ps(a, b) }
    fn or(a: __m256, b: __m256) -> __m256 { _mm256_or_ps(a, b) }
    fn xor(a: __m256, b: __m256) -> __m256 { _mm256_xor_ps(a, b) }
    fn shift_up(a: __m256) -> __m256 {
        _mm256_castsi256_ps(_mm256_slli_epi32::<23>(_mm256_castps_si256(a)))
    }
    fn shift_down(a: __m256) -> __m256 {
        _mm256_castsi256_ps(_mm256_srli_epi32::<23>(_mm256_castps_si256(a)))
    }
    fn less(a: __m256, b: __m256) -> __m256 { _mm256_cmp_ps::<_CMP_LT_OQ>(a, b) }
    fn at_most(a: __m256, b: __m256) -> __m256 { _mm256_cmp_ps::<_CMP_LE_OQ>(a, b) }
    fn mask_and(a: __m256, b: __m256) -> __m256 { _mm256_and_ps(a, b) }
    fn mask_or(a: __m256, b: __m256) -> __m256 { _mm256_or_ps(a, b) }
    fn mask_not(a: __m256) -> __m256 { _mm256_xor_ps(a, constant!(__m256, u32, 8, u32::MAX)) }
    fn bits(a: __m256) -> u32 { _mm256_movemask_ps(a) as u32 }
    fn choose(mask: __m256, then: __m256, otherwise: __m256) -> __m256 {
        _mm256_blendv_ps(otherwise, then, mask)
    }
}

instructions! { V3 f64 u64 __m256d __m256d 4 1023.0
    fn same(value: f64) -> __m256d { _mm256_set1_pd(value) }
    fn load(array: &[f64; 4]) -> __m256d { _mm256_loadu_pd(array.as_ptr()) }
    fn store(array: &mut [f64; 4], a: __m256d) { _mm256_storeu_pd(array.as_mut_ptr(), a) }
    fn sum(a: __m256d, b: __m256d) -> __m256d { _mm256_add_pd(a, b) }
    fn difference(a: __m256d, b: __m256d) -> __m256d { _mm256_sub_pd(a, b) }
    fn product(a: __m256d, b: __m256d) -> __m256d { _mm256_mul_pd(a, b) }
    fn ratio(a: __m256d, b: __m256d) -> __m256d { _mm256_div_pd(a, b) }
    fn product_plus(a: __m256d, b: __m256d, c: __m256d) -> __m256d { _mm256_fmadd_pd(a, b, c) }
    fn minus_product_plus(a: __m256d, b: __m256d, c: __m256d) -> __m256d { _mm256_fnmadd_pd(a, b, c) }
    fn root(a: __m256d) -> __m256d { _mm256_sqrt_pd(a) }
    fn and(a: __m256d, b: __m256d) -> __m256d { _mm256_and_pd(a, b) }
    fn or(a: __m256d, b: __m256d) -> __m256d { _mm256_or_pd(a, b) }
    fn xor(a: __m256d, b: __m256d) -> __m256d { _mm256_xor_pd(a, b) }
    fn shift_up(a: __m256d) -> __m256d {
        _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(a)))
    }
    fn shift_down(a: __m256d) -> __m256d {
        _mm256_castsi256_pd(_mm256_srli_epi64::<52>(_mm256_castpd_si256(a)))
    }
    fn less(a: __m256d, b: __m256d) -> __m256d { _mm256_cmp_pd::<_CMP_LT_OQ>(a, b) }
    fn at_most(a: __m256d, b: __m256d) -> __m256d { _mm256_cmp_pd::<_CMP_LE_OQ>(a, b) }
    fn mask_and(a: __m256d, b: __m256d) -> __m256d { _mm256_and_pd(a, b) }
    fn mask_or(a: __m256d, b: __m256d) -> __m256d { _mm256_or_pd(a, b) }
    fn mask_not(a: __m256d) -> __m256d { _mm256_xor_pd(a, constant!(__m256d, u64, 4, u64::MAX)) }
    fn bits(a: __m256d) -> u32 { _mm256_movemask_pd(a) as u32 }
    fn choose(mask: __m256d, then: __m256d, otherwise: __m256d) -> __m256d {
        _mm256_blendv_pd(otherwise, then, mask)
    }
}

instructions! { V4 f32 u32 __m512 __mmask16 16 127.0
    fn same(value: f32) -> __m512 { _mm512_set1_ps(value) }
    fn load(array: &[f32; 16]) -> __m512 { _mm512_loadu_ps(array.as_ptr()) }
    fn store(array: &mut [f32; 16], a: __m512) { _mm512_storeu_ps(array.as_mut_ptr(), a) }
    fn sum(a: __m512, b: __m512) -> __m512 { _mm512_add_ps(a, b) }
    fn difference(a: __m512, b: __m512) -> __m512 { _mm512_sub_ps(a, b) }
    fn product(a: __m512, b: __m512) -> __m512 { _mm512_mul_ps(a, b) }
    fn ratio(a: __m512, b: __m512) -> __m512 { _mm512_div_ps(a, b) }
    fn product_plus(a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fmadd_ps(a, b, c) }
    fn minus_product_plus(a: __m512, b: __m512, c: __m512) -> __m512 { _mm512_fnmadd_ps(a, b, c) }
    fn root(a: __m512) -> __m512 { _mm512_sqrt_ps(a) }
    fn and(a: __m512, b: __m512) -> __m512 { _mm512_and_ps(a, b) }
    fn or(a: __m512, b: __m512) -> __m512 { _mm512_or_ps(a, b) }
    fn xor(a: __m512, b: __m512) -> __m512 { _mm512_xor_ps(a, b) }
    fn shift_up(a: __m512) -> __m512 {
        _mm512_castsi512_ps(_mm512_slli_epi32::<23>(_mm512_castps_si512(a)))
    }
    fn shift_down(a: __m512) -> __m512 {
        _mm512_castsi512_ps(_mm512_srli_epi32::<23>(_mm512_castps_si512(a)))
    }
    fn less(a: __m512, b: __m512) -> __mmask16 { _mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b) }
    fn at_most(a: __m512, b: __m512) -> __mmask16 { _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b) }
    fn mask_and(a: __mmask16, b: __mmask16) -> __mmask16 { a & b }
    fn mask_or(a: __mmask16, b: __mmask16) -> __mmask16 { a | b }
    fn mask_not(a: __mmask16) -> __mmask16 { !a }
    fn bits(a: __mmask16) -> u32 { u32::from(a) }
    fn choose(mask: __mmask16, then: __m512, otherwise: __m512) -> __m512 {
        _mm512_mask_blend_ps(mask, otherwise, then)
    }
}

instructions! { V4 f64 u64 __m512d __mmask8 8 1023.0
    fn same(value: f64) -> __m512d { _mm512_set1_pd(value) }
    fn load(array: &[f64; 8]) -> __m512d { _mm512_loadu_pd(array.as_ptr()) }
    fn store(array: &mut [f64; 8], a: __m512d) { _mm512_storeu_pd(array.as_mut_ptr(), a) }
    fn sum(a: __m512d, b: __m512d) -> __m512d { _mm512_add_pd(a, b) }
    fn difference(a: __m512d, b: __m512d) -> __m512d { _mm512_sub_pd(a, b) }
    fn product(a: __m512d, b: __m512d) -> __m512d { _mm512_mul_pd(a, b) }
    fn ratio(a: __m512d, b: __m512d) -> __m512d { _mm512_div_pd(a, b) }
    fn product_plus(a: __m512d, b: __m512d, c: __m512d) -> __m512d { _mm512_fmadd_pd(a, b, c) }
    fn minus_product_plus(a: __m512d, b: __m512d, c: __m512d) -> __m512d { _mm512_fnmadd_pd(a, b, c) }
    fn root(a: __m512d) -> __m512d { _mm512_sqrt_pd(a) }
    fn and(a: __m512d, b: __m512d) -> __m512d { _mm512_and_pd(a, b) }
    fn or(a: __m512d, b: __m512d) -> __m512d { _mm512_or_pd(a, b) }
    fn xor(a: __m512d, b: __m512d) -> __m512d { _mm512_xor_pd(a, b) }
    fn shift_up(a: __m512d) -> __m512d {
        _mm512_castsi512_pd(_mm512_slli_epi64::<52>(_mm512_castpd_si512(a)))
    }
    fn shift_down(a: __m512d) -> __m512d {
        _mm512_castsi512_pd(_mm512_srli_epi64::<52>(_mm512_castpd_si512(a)))
    }
    fn less(a: __m512d, b: __m512d) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b) }
    fn at_most(a: __m512d, b: __m512d) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) }
    fn mask_and(a: __mmask8, b: __mmask8) -> __mmask8 { a & b }
    fn mask_or(a: __mmask8, b: __mmask8) -> __mmask8 { a | b }
    fn mask_not(a: __mmask8) -> __mmask8 { !a }
    fn bits(a: __mmask8) -> u32 { u32::from(a) }
    fn choose(mask: __mmask8, then: __m512d, otherwise: __m512d) -> __m512d {
        _mm512_mask_blend_pd(mask, otherwise, then)
    }
}
