//! Principal logarithms of even versors in up to five dimensions.

use super::exponential::exponential_parts;
use super::normalise::{Commutators, OverNorm};
use super::parts::{Bivectors, Fourvectors, Parts, combined, copied, finite, outer_square, turned};
use super::separation::{Separation, Turn, TurnFunctions, Values, nearness};
use super::study::Study;
use crate::ops::Element;
use crate::{Computation, Real};

/// The principal logarithm of a versor over its norm: the bivector B = f(c) A with
/// `R = c + A`, c = ⟨R⟩ + ⟨R⟩₄ a Study number and f(cosh z) = z / sinh z.
///
/// Its turns are |θ₁| + |θ₂| ≤ π. `None` where no real logarithm exists, where it is not unique
/// (R = −1), and for what is no versor. `commutators` are of
/// the parts of R.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn logarithm<T, X, A, Q>(
    versor: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(versor);
    match parts.is_unit(&commutators) {
        true => of_unit_parts(parts),
        false => {
            let (unit, _) = T::outlined(OverNorm(parts, &commutators))?;
            of_unit_parts(unit)
        }
    }
}

/// The logarithm of a versor that is promised to be a unit one.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn logarithm_of_unit<T, X, A, Q>(versor: X) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    of_unit_parts(Parts::<T, A, Q>::of(versor))
}

#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
fn of_unit_parts<T, A, Q>(unit: Parts<T, A, Q>) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let logarithm = Separation::of(unit).evaluate::<LogarithmFactor>()?;
    if !unit.is_plain() {
        let back = T::outlined(LeadsBack {
            unit,
            logarithm: logarithm.bivector,
        });
        back.then_some(())?;
    }
    finite(logarithm.bivector)
}

/// The factor f, and as g too, which is not asked for.
struct LogarithmFactor;

impl<T: Real> TurnFunctions<T> for LogarithmFactor {
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn together(above: Study<T>) -> Values<Study<T>> {
        let factor = Study::log_factor(above.scaled(T::from_ratio(1, 2)).sqrt());
        Values {
            even: factor,
            factor,
        }
    }

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn apart(turn: Turn<T>) -> Option<Values<T>> {
        let factor = turn.cosine.log_factor(turn.square)?;
        Some(Values {
            even: factor,
            factor,
        })
    }
}

/// Asks whether a logarithm leads back to its versor.
struct LeadsBack<T, A, Q> {
    unit: Parts<T, A, Q>,
    logarithm: A,
}

impl<T, A, Q> Computation for LeadsBack<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    type Output = bool;

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> bool {
        self.unit.is_near(exponential_parts(self.logarithm))
    }
}

/// The logarithm of a versor whose four-vector part squares to zero, as that of a motor does:
/// there f(c + V) = f(c) + f′(c) V.
#[inline(always)]
pub fn motor_logarithm<T, X, A, Q>(
    versor: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(versor);
    let unit = match parts.is_unit(&commutators) {
        true => parts,
        false => T::outlined(OverNorm(parts.copied(), &commutators))?
            .0
            .copied(),
    };
    motor_of_unit_parts(unit)
}

/// f(c) and f′(c) of a unit motor with this scalar and this square of its bivector, whose other
/// coefficients have squares that add up to `size`; `None` where
/// [`motor_logarithm_apart`] has to be asked: behind a third of a turn, of what is not a unit
/// versor, and where the logarithm could overflow.
#[inline(always)]
pub fn motor_factor<T: Real>(scalar: T, square: T, size: T) -> Option<(T, T)> {
    let far_from_the_edge = T::from_ratio(-1, 2).all_le(scalar);
    match far_from_the_edge && far_below_overflow(size) {
        true => scalar.log_factor_slope(square),
        false => None,
    }
}

/// Whether a logarithm is finite because the squares of the coefficients are small enough: away
/// from the edge, the factor and its slope are small numbers.
#[inline(always)]
fn far_below_overflow<T: Real>(size: T) -> bool {
    (size * T::from_integer(1024)).is_finite()
}

/// The logarithm of a versor that is promised to be a unit one, and whose four-vector part
/// squares to zero, in a function of its own.
#[inline(always)]
pub fn motor_logarithm_apart<T, X, A, Q>(versor: X) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(copied(versor));
    T::outlined(MotorOfUnitParts(parts)).map(copied)
}

/// Takes the logarithm of a unit motor.
struct MotorOfUnitParts<T, A, Q>(Parts<T, A, Q>);

impl<T, A, Q> Computation for MotorOfUnitParts<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    type Output = Option<A>;

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> Option<A> {
        motor_of_unit_parts(self.0)
    }
}

/// f(c + V) A = f A + f′ V A.
#[inline(always)]
fn motor_of_unit_parts<T, A, Q>(unit: Parts<T, A, Q>) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let square = unit.bivector.scalar_product(unit.bivector);
    let far = T::from_ratio(-1, 2).all_le(unit.scalar);
    if !(far || T::ZERO.all_le(nearness(unit.scalar, square))) {
        return T::outlined(MotorNearTheEdge(unit.copied())).map(copied);
    }
    let (factor, slope) = unit.scalar.log_factor_slope(square)?;
    let logarithm = scaled_and_turned(unit.bivector, unit.fourth, factor, slope);
    match far_below_overflow(unit.size()) {
        true => Some(logarithm),
        false => finite(logarithm),
    }
}

/// f A + f′ V A. The slope times the four-vector, which has fewer coefficients than the bivector.
#[inline(always)]
fn scaled_and_turned<T, A, Q>(bivector: A, fourth: Q, factor: T, slope: T) -> A
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let turned = turned(fourth.geometric(slope), bivector);
    A::from_fn(|i| bivector.at(i) * factor + turned.at(i))
}

/// The same where lanes may be near −1.
struct MotorNearTheEdge<T, A, Q>(Parts<T, A, Q>);

impl<T, A, Q> Computation for MotorNearTheEdge<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    type Output = Option<A>;

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> Option<A> {
        let Separation {
            cosine,
            bivector,
            fourth,
            turned: image,
            near,
            ..
        } = Separation::of(self.0);
        let (factor, slope) = cosine
            .scalar
            .log_factor_slope(bivector.scalar_product(bivector))?;
        let near_the_edge = combined(bivector, factor, image, slope);
        // Lanes far from it have the value that they have among their like.
        let far = scaled_and_turned(bivector, fourth, factor, slope);
        let logarithm = A::from_fn(|i| near.select_le(T::ZERO, near_the_edge.at(i), far.at(i)));
        // The two terms are large and nearly cancel in the part that B∧B = 2f V knows.
        let square = logarithm.scalar_product(logarithm);
        let missing = fourth.geometric(factor + factor) - outer_square(logarithm);
        let share = near.select_le(T::ZERO, T::from_ratio(1, 2) / square, T::ZERO);
        let turned = turned(missing, logarithm);
        finite(combined(logarithm, T::ONE, turned, share))
    }
}
