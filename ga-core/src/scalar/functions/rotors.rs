//! The functions that exponentials and logarithms of rotors are made of, as functions of squares
//! and cosines: near the identity they need neither a root nor a quotient.

use super::exponential::half_exp;
use super::logarithm::ln;
use super::polynomial::by_fours;
use super::{constant, nearest_integer, parity};
use crate::scalar::elementary::Elementary;
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;
use crate::{Computation, Scalar};

/// The arguments of C and S that their polynomials reach: turns of a bivector by up to π, which is
/// a whole turn of what its exponential is applied to, and boosts by up to 1.
const NEAR: [f64; 2] = [-9.8696, 1.0];

/// C(a) = cosh √a and S(a) = sinh √a/√a.
#[inline(always)]
pub fn cosh_sinhc<L: Lanes>(a: L) -> (L, L) {
    let (cosh, sinhc, _) = cosh_sinhc_slope(a);
    (cosh, sinhc)
}

/// C, S and S′ at a; the derivative of C is S/2.
///
/// Within reach of the polynomials there is no root, no quotient, and no branch but the one that
/// asks for that.
#[inline(always)]
pub fn cosh_sinhc_slope<L: Lanes>(a: L) -> (L, L, L) {
    let reached = constant::<L>(NEAR[0]).is_at_most(a) & a.is_at_most(constant(NEAR[1]));
    match L::all(reached) {
        true => near(a),
        false => L::outlined(Far(a)),
    }
}

/// S = 1 + a P and S′ by polynomials, C = S + 2a S′.
#[inline(always)]
fn near<L: Lanes>(a: L) -> (L, L, L) {
    let sinhc = L::ONE.plus_product(a, by_fours(a, L::Float::SINHC));
    let slope = by_fours(a, L::Float::SINHC_SLOPE);
    (sinhc.plus_product(a + a, slope), sinhc, slope)
}

/// C, S and S′ where some lane is out of reach, or is not a number.
struct Far<L>(L);

impl<L: Lanes> Computation for Far<L> {
    type Output = (L, L, L);

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> (L, L, L) {
        let Far(a) = self;
        let turned = a.is_less(constant(NEAR[0]));
        let boost = constant::<L>(NEAR[1]).is_less(a);
        let (mut cosh, mut sinhc, mut slope) = match L::any(turned) {
            true => turned_further(a, turned),
            false => near(a),
        };
        if L::any(boost) {
            let end = L::splat(L::Float::ENDLESS);
            let square = L::select((end * end).is_less(a), end * end, a);
            let root = square.square_root();
            let half = half_exp(root);
            let quarter = constant::<L>(0.25) / half;
            let (far_cosh, far_sinhc) = (half + quarter, (half - quarter) / root);
            cosh = L::select(boost, far_cosh, cosh);
            sinhc = L::select(boost, far_sinhc, sinhc);
            slope = L::select(boost, (far_cosh - far_sinhc) / (a + a), slope);
        }
        (cosh, sinhc, slope)
    }
}

/// C, S and S′ where some lanes are turned by more than the polynomials reach.
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
fn turned_further<L: Lanes>(a: L, turned: L::Mask) -> (L, L, L) {
    let root = (-a).square_root();
    let (rest, half_turns) = without_half_turns(root, turned);
    let (cosh, sinhc, slope) = near(L::select(turned, -(rest * rest), a));
    let odd = L::ZERO.is_less(parity(half_turns)) & turned;
    let cosh = L::select(odd, -cosh, cosh);
    let sinhc = L::select(odd, -sinhc, sinhc);
    let sinhc = L::select(turned, sinhc * (rest / root), sinhc);
    let quotient = (cosh - sinhc) / (a + a);
    (cosh, sinhc, L::select(turned, quotient, slope))
}

/// An angle without its half turns, in [−π/2, π/2], and a number that is odd where they are odd.
#[inline(always)]
fn without_half_turns<L: Lanes>(angle: L, turned: L::Mask) -> (L, L) {
    let half_turns = nearest_integer(angle * constant(core::f64::consts::FRAC_1_PI));
    let reached = half_turns.is_at_most(constant::<L>(0.5) * L::splat(L::Float::MOST_TURNS));
    let mut rest = angle;
    for part in L::Float::HALF_PI {
        let part = L::splat(*part);
        rest = rest.minus_product(half_turns, part + part);
    }
    let half_turns = L::select(reached, half_turns, L::ZERO);
    if L::all(reached | !turned) {
        return (rest, half_turns);
    }
    // Of larger angles hardly a digit is known; they are reduced by the library.
    let (by_library, its_half_turns) = reduced_by_library(angle);
    (
        L::select(reached, rest, by_library),
        L::select(reached, half_turns, its_half_turns),
    )
}

/// The angle without its half turns, in [−π/2, π/2], and 1 where these are odd, lane by lane.
#[cold]
#[inline(never)]
fn reduced_by_library<L: Lanes>(angle: L) -> (L, L) {
    let opposite = |cos: L::Float| cos.is_less(L::Float::ZERO);
    let rest = angle.map(|angle| {
        let (sin, cos) = angle.sin_cos();
        match opposite(cos) {
            true => (-sin).atan2(-cos),
            false => sin.atan2(cos),
        }
    });
    let half_turns = angle.map(|angle| match opposite(angle.sin_cos().1) {
        true => L::Float::ONE,
        false => L::Float::ZERO,
    });
    (rest, half_turns)
}

/// The cosine up to which the polynomial of the logarithm reaches, from 0.
const FARTHEST: f64 = 1.125;

/// The factor f(c) = θ/sin θ of c = cos θ for which `log(c + X) = f X`, given X² = c² − 1.
///
/// `None` where there is none in a lane: for c ≤ 0 with X² ≥ 0, where c² − X² is not even roughly
/// 1, and for what is not finite.
#[inline(always)]
pub fn log_factor<L: Lanes>(c: L, square: L) -> Option<L> {
    let (factor, _) = factor_and_slope::<L, false>(c, square)?;
    Some(factor)
}

/// The factor f(c) of the logarithm and its derivative along c² − X² = 1.
#[inline(always)]
pub fn log_factor_slope<L: Lanes>(c: L, square: L) -> Option<(L, L)> {
    factor_and_slope::<L, true>(c, square)
}

/// The factor f(c), and its derivative if that is asked for.
#[inline(always)]
fn factor_and_slope<L: Lanes, const SLOPE: bool>(c: L, square: L) -> Option<(L, L)> {
    // By how much the square of the norm exceeds 1, halved: rounding.
    let excess = ((c * c - square) - L::ONE) * constant(0.5);
    let ahead = L::ZERO.is_at_most(c) & c.is_at_most(constant(FARTHEST));
    // Then X² is negative, or c far from zero.
    let is_unit = excess.magnitude().is_at_most(constant(0.125));
    if L::all(ahead & is_unit) {
        return Some(ahead_factor::<L, SLOPE>(c, excess));
    }
    let far = FarFactor::<L, SLOPE> {
        cosine: c,
        square,
        excess,
    };
    // The factor alone is short enough for loops over it to be vectorised, which no call may be in.
    match SLOPE {
        true => L::outlined(far),
        false => far.run(),
    }
}

/// f and f′ of a cosine in reach of the polynomial p: f = 1 + x p with x = 1 − c.
///
/// The slope (1 − c f)/X² is −x (1 − c p)/(x (1 + c)), of which x is left out. Over the norm, both
/// cosine and factor become smaller by the excess, to first order. With the slope that is done
/// last, because what it takes is known last.
#[inline(always)]
fn ahead_factor<L: Lanes, const SLOPE: bool>(cosine: L, excess: L) -> (L, L) {
    let distance = L::ONE - cosine;
    if !SLOPE {
        let distance = distance.plus_product(cosine, excess);
        let factor = L::ONE.plus_product(distance, by_fours(distance, L::Float::ARC));
        return (factor.minus_product(factor, excess), L::ZERO);
    }
    let share = L::ONE / (L::ONE + cosine);
    let value = by_fours(distance, L::Float::ARC);
    let slope = L::ONE.minus_product(cosine, value) * -share;
    let factor = L::ONE.plus_product(distance, value);
    let change = factor.plus_product(cosine, slope);
    (factor.minus_product(change, excess), slope)
}

/// The same where some lane is behind a quarter of a turn, a boost, no versor, or not a number.
struct FarFactor<L, const SLOPE: bool> {
    cosine: L,
    square: L,
    excess: L,
}

impl<L: Lanes, const SLOPE: bool> Computation for FarFactor<L, SLOPE> {
    type Output = Option<(L, L)>;

    #[inline(always)]
    fn run(self) -> Option<(L, L)> {
        let FarFactor {
            cosine,
            square,
            excess,
        } = self;
        let size = cosine * cosine + square.magnitude();
        let is_unit = excess.magnitude().is_less(size * constant(0.25));
        let exists = is_unit & (square.is_less(L::ZERO) | L::ZERO.is_less(cosine));
        if !L::all(exists) {
            return None;
        }
        let size = cosine.magnitude();
        let (mut factor, mut slope) = ahead_factor::<L, SLOPE>(size, excess);
        let behind = cosine.is_less(L::ZERO);
        if L::any(behind) {
            // θ/sin θ = π/sin θ − (π − θ)/sin(π − θ).
            let sine = (-square).square_root();
            let other = L::PI / sine - factor;
            let quotient = (L::ONE.plus_product(size, other)) / square;
            factor = L::select(behind, other, factor);
            slope = L::select(behind, quotient, slope);
        }
        let boost = constant::<L>(FARTHEST).is_less(cosine);
        if L::any(boost) {
            let sinh = square.square_root();
            let far = ln(cosine + sinh) / sinh;
            let quotient = L::ONE.minus_product(size, far) / square;
            factor = L::select(boost, far, factor);
            slope = L::select(boost, quotient, slope);
        }
        let finite = factor.magnitude().is_at_most(L::splat(L::Float::LARGEST));
        match L::all(finite) {
            true => Some((factor, slope)),
            false => None,
        }
    }
}
