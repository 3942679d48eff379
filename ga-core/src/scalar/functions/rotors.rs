//! The functions that exponentials and logarithms of rotors are made of, as functions of squares
//! and cosines: near the identity they need neither a root nor a quotient.

use super::exponential::half_exp;
use super::logarithm::ln;
use super::polynomial::polynomial;
use super::{constant, nearest_integer, parity};
use crate::Scalar;
use crate::scalar::elementary::Elementary;
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;

/// The arguments of C and S that their polynomials reach: from −π²/4 to 1.
const NEAR: [f64; 2] = [-2.4674, 1.0];

/// C(a) = cosh √a and S(a) = sinh √a/√a.
#[inline(always)]
pub fn cosh_sinhc<L: Lanes>(a: L) -> (L, L) {
    let argument = Argument::of(a);
    let square = argument.square;
    let cosh = L::ONE.plus_product(square, polynomial(square, L::Float::COSH));
    let sinhc = L::ONE.plus_product(square, polynomial(square, L::Float::SINHC));
    let (cosh, sinhc, _) = argument.completed(cosh, sinhc, L::ZERO);
    (cosh, sinhc)
}

/// C, S and S′ at a; the derivative of C is S/2.
#[inline(always)]
pub fn cosh_sinhc_slope<L: Lanes>(a: L) -> (L, L, L) {
    let argument = Argument::of(a);
    let square = argument.square;
    let sinhc = L::ONE.plus_product(square, polynomial(square, L::Float::SINHC));
    let slope = polynomial(square, L::Float::SINHC_SLOPE);
    // C = S + 2a S′.
    let cosh = sinhc.plus_product(square + square, slope);
    argument.completed(cosh, sinhc, slope)
}

/// An argument of C and S, reduced by half turns to where the polynomials reach.
struct Argument<L: Lanes> {
    given: L,
    /// The square of which C and S are taken.
    square: L,
    /// What is done with them where the argument is reduced: where, its root, that of the reduced
    /// one, and by how many half turns they differ.
    turned: Option<(L::Mask, L, L, L)>,
}

impl<L: Lanes> Argument<L> {
    #[inline(always)]
    fn of(given: L) -> Self {
        let turned = given.is_less(constant(NEAR[0]));
        if !L::any(turned) {
            return Argument {
                given,
                square: given,
                turned: None,
            };
        }
        let root = (-given).square_root();
        let half_turns = nearest_integer(root * constant(core::f64::consts::FRAC_1_PI));
        let near = half_turns.is_at_most(constant::<L>(0.5) * L::splat(L::Float::MOST_TURNS));
        let mut rest = root;
        for part in L::Float::HALF_PI {
            let part = L::splat(*part);
            rest = rest.minus_product(half_turns, part + part);
        }
        let mut half_turns = L::select(near, half_turns, L::ZERO);
        // Of larger angles hardly a digit is known; they are reduced by the library.
        if !L::all(near | !turned) {
            let (far, far_turns) = reduced_by_library(root);
            rest = L::select(near, rest, far);
            half_turns = L::select(near, half_turns, far_turns);
        }
        Argument {
            given,
            square: L::select(turned, -(rest * rest), given),
            turned: Some((turned, root, rest, half_turns)),
        }
    }

    /// C, S and S′ of the argument from those of the reduced one.
    #[inline(always)]
    fn completed(self, cosh: L, sinhc: L, slope: L) -> (L, L, L) {
        let (mut cosh, mut sinhc, mut slope) = (cosh, sinhc, slope);
        // S′ = (C − S)/(2a).
        let twice = self.given + self.given;
        if let Some((turned, root, rest, half_turns)) = self.turned {
            let odd = L::ZERO.is_less(parity(half_turns)) & turned;
            cosh = L::select(odd, -cosh, cosh);
            sinhc = L::select(odd, -sinhc, sinhc);
            sinhc = L::select(turned, sinhc * (rest / root), sinhc);
            slope = L::select(turned, (cosh - sinhc) / twice, slope);
        }
        let boost = constant::<L>(NEAR[1]).is_less(self.given);
        if L::any(boost) {
            let end = L::splat(L::Float::ENDLESS);
            let square = L::select((end * end).is_less(self.given), end * end, self.given);
            let root = square.square_root();
            let half = half_exp(root);
            let quarter = constant::<L>(0.25) / half;
            let (far_cosh, far_sinhc) = (half + quarter, (half - quarter) / root);
            cosh = L::select(boost, far_cosh, cosh);
            sinhc = L::select(boost, far_sinhc, sinhc);
            slope = L::select(boost, (far_cosh - far_sinhc) / twice, slope);
        }
        (cosh, sinhc, slope)
    }
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

/// The cosine up to which the polynomials of the logarithm reach.
const FARTHEST: f64 = 1.125;

/// The factor f(c) = θ/sin θ of c = cos θ for which `log(c + X) = f X`, given X² = c² − 1.
///
/// `None` where there is none in a lane: for c ≤ 0 with X² ≥ 0, where c² − X² is not even roughly
/// 1, and for what is not finite.
#[inline(always)]
pub fn log_factor<L: Lanes>(c: L, square: L) -> Option<L> {
    let arc = Arc::of(c, square)?;
    let factor = L::ONE.plus_product(arc.distance, polynomial(arc.distance, L::Float::ARC));
    Some(arc.completed(factor, L::ZERO)?.0)
}

/// The factor f(c) of the logarithm and its derivative along c² − X² = 1.
#[inline(always)]
pub fn log_factor_slope<L: Lanes>(c: L, square: L) -> Option<(L, L)> {
    let arc = Arc::of(c, square)?;
    let factor = L::ONE.plus_product(arc.distance, polynomial(arc.distance, L::Float::ARC));
    let slope = polynomial(arc.distance, L::Float::ARC_SLOPE);
    arc.completed(factor, slope)
}

/// A cosine and a square of one rotor.
struct Arc<L> {
    cosine: L,
    square: L,
    /// 1 − |c|.
    distance: L,
    /// By how much the square of the norm exceeds 1, halved: rounding.
    excess: L,
}

impl<L: Lanes> Arc<L> {
    #[inline(always)]
    fn of(cosine: L, square: L) -> Option<Self> {
        let half = constant::<L>(0.5);
        let squared = cosine * cosine;
        let excess = ((squared - square) - L::ONE) * half;
        let size = squared + square.magnitude();
        let unit = excess.magnitude().is_less(size * constant(0.25));
        let exists = unit & (square.is_less(L::ZERO) | L::ZERO.is_less(cosine));
        if !L::all(exists) {
            return None;
        }
        let distance = L::ONE - cosine.magnitude();
        Some(Arc {
            cosine,
            square,
            distance: distance.plus_product(cosine.magnitude(), excess),
            excess,
        })
    }

    /// f and f′ from those of |c| near the identity.
    #[inline(always)]
    fn completed(self, near: L, slope: L) -> Option<(L, L)> {
        let size = self.cosine.magnitude();
        // Over the norm, to first order.
        let mut factor = near.minus_product(near, self.excess);
        let mut slope = slope;
        let behind = self.cosine.is_less(L::ZERO);
        let boost = constant::<L>(FARTHEST).is_less(self.cosine);
        if !L::any(behind | boost) {
            return Some((factor, slope));
        }
        if L::any(behind) {
            // θ/sin θ = π/sin θ − (π − θ)/sin(π − θ).
            let sine = (-self.square).square_root();
            let other = L::PI / sine - factor;
            let quotient = (L::ONE.plus_product(size, other)) / self.square;
            factor = L::select(behind, other, factor);
            slope = L::select(behind, quotient, slope);
        }
        if L::any(boost) {
            let sinh = self.square.square_root();
            let far = ln(self.cosine + sinh) / sinh;
            let quotient = L::ONE.minus_product(size, far) / self.square;
            factor = L::select(boost, far, factor);
            slope = L::select(boost, quotient, slope);
        }
        let finite = factor.magnitude().is_at_most(L::splat(L::Float::LARGEST));
        L::all(finite).then_some((factor, slope))
    }
}
