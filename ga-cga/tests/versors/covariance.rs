//! Covariance (figure 1.1): R\[a ∧ b\] = R\[a\] ∧ R\[b\] for every type, every versor does what
//! the same versor of a wider type does, and the inverse undoes it.

use crate::random::{Random, size};
use ga_cga::*;
use ga_core::ops::{Apply, Element, Wedge};

/// Asserts that two elements are equal up to rounding, against a size.
fn close<A, B>(a: A, b: B, scale: f64)
where
    Multivector: From<A> + From<B>,
{
    let (a, b) = (Multivector::from(a), Multivector::from(b));
    assert!(size(a - b) <= 1e-11 * scale, "{a} is not {b}");
}

/// How much an even or odd versor magnifies, so that errors have a measure.
fn magnification<V>(versor: V) -> f64
where
    Multivector: From<V>,
{
    let versor = Multivector::from(versor);
    let square = (versor * versor.reverse()).s.abs();
    (size(versor) * size(versor) / square).powi(3).max(1.0)
}

fn law<V, A, B, C>(random: &mut Random, versor: V)
where
    V: Apply<A> + Apply<B> + Apply<C> + Copy,
    A: Element<Number = f64> + Wedge<B, Output = C>,
    B: Element<Number = f64>,
    C: Copy,
    <V as Apply<A>>::Output: Wedge<<V as Apply<B>>::Output>,
    Multivector: From<V>
        + From<C>
        + From<<V as Apply<C>>::Output>
        + From<<<V as Apply<A>>::Output as Wedge<<V as Apply<B>>::Output>>::Output>,
{
    let (a, b): (A, B) = (random.element(), random.element());
    let product = a.wedge(b);
    let whole = versor.apply(product);
    let parts = versor.apply(a).wedge(versor.apply(b));
    close(whole, parts, magnification(versor));
}

/// The pairs of types whose outer product is not zero, by grades 1 + 1, 1 + 2, 2 + 2, 1 + 3.
macro_rules! pairs {
    ($random:ident $versor:ident: $($A:ident { $($B:ident)* })*) => {
        $($(law::<_, $A, $B, _>($random, $versor);)*)*
    };
}

fn all_pairs<V>(random: &mut Random, versor: V)
where
    V: Copy + Into<Even>,
{
    let versor: Even = versor.into();
    pairs! { random versor:
        Vector3 {
            Vector3 Point DualSphere DualPlane Bivector3 PointPair FlatPoint DirectionVector
            TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector TangentBivector
            Sphere Plane DirectionTrivector TangentTrivector
        }
        Point {
            Vector3 Point DualSphere DualPlane Bivector3 PointPair FlatPoint DirectionVector
            TangentVector DualLine Trivector3 Circle Line DirectionBivector
            TangentBivector Sphere Plane DirectionTrivector
        }
        DualSphere {
            Vector3 Point DualSphere DualPlane Bivector3 PointPair FlatPoint DirectionVector
            TangentVector DualLine Trivector3 Circle Line DirectionBivector
            TangentBivector Sphere Plane DirectionTrivector
        }
        DualPlane {
            Vector3 Point DualSphere DualPlane Bivector3 PointPair FlatPoint DirectionVector
            TangentVector DualLine MinkowskiPlane Trivector3 Circle Line DirectionBivector
            TangentBivector Sphere Plane TangentTrivector
        }
        Bivector3 { PointPair FlatPoint DirectionVector TangentVector MinkowskiPlane Circle Line }
        PointPair { PointPair FlatPoint DualLine Circle Trivector3 }
        FlatPoint { Bivector3 TangentVector DualLine Circle }
        DualLine { DualLine TangentVector MinkowskiPlane Circle }
    }
}

/// Figure 1.1 for general versors, which all others are converted to.
#[test]
fn the_image_of_a_product_is_the_product_of_the_images() {
    let mut random = Random::new(41);
    for _ in 0..300 {
        let versor = random.even();
        if magnification(versor) < 1e6 {
            all_pairs(&mut random, versor);
        }
        let motor = random.motor();
        all_pairs(&mut random, motor);
    }
}

/// Figure 1.1 over 10⁵ elements of each kind: motors and general versors in turn.
macro_rules! at_length {
    ($($test:ident: $($A:ident $B:ident),*;)*) => {$(
        #[test]
        fn $test() {
            let mut random = Random::new(45);
            let mut done = 0;
            while done < 100_000 {
                if done % 2 == 0 {
                    let motor = random.motor();
                    $(law::<_, $A, $B, _>(&mut random, motor);)*
                } else {
                    let versor = random.even();
                    if magnification(versor) >= 1e6 {
                        continue;
                    }
                    $(law::<_, $A, $B, _>(&mut random, versor);)*
                }
                done += 1;
            }
        }
    )*};
}

at_length! {
    covariance_of_rounds_and_tangents:
        Vector3 PointPair, Point Circle, DualSphere Sphere, DualLine TangentVector,
        Vector3 TangentBivector, DualPlane TangentTrivector;
    covariance_of_flats_and_directions:
        DualPlane Line, Bivector3 FlatPoint, Point Plane, Vector3 MinkowskiPlane,
        DualPlane DirectionVector, DualSphere DirectionBivector, DualSphere DirectionTrivector,
        Point Trivector3;
}

fn law_of_points<V>(random: &mut Random, versor: V)
where
    V: Copy + Apply<Point> + Apply<PointPair, Output = PointPair> + Apply<Circle, Output = Circle>,
    V: Apply<Sphere, Output = Sphere>,
    DualSphere: From<<V as Apply<Point>>::Output>,
    Multivector: From<V>,
{
    let points: [Point; 4] = core::array::from_fn(|_| random.point());
    let [a, b, c, d] = points;
    let [va, vb, vc, vd] = points.map(|p| DualSphere::from(versor.apply(p)));
    let scale = magnification(versor);
    close::<PointPair, PointPair>(versor.apply(a ^ b), va ^ vb, 1e2 * scale);
    close::<Circle, Circle>(versor.apply(a ^ b ^ c), va ^ vb ^ vc, 1e3 * scale);
    let sphere = versor.apply(a ^ b ^ c ^ d);
    close::<Sphere, Sphere>(sphere, va ^ vb ^ vc ^ vd, 1e4 * scale);
}

/// Figure 1.1 for each kind of versor and the rounds through points, over many elements.
#[test]
fn rounds_through_points_are_carried_by_their_points() {
    let mut random = Random::new(42);
    for _ in 0..20_000 {
        let (rotor, shift, motor) = (random.rotor(), random.translator(), random.motor());
        law_of_points(&mut random, rotor);
        law_of_points(&mut random, shift);
        law_of_points(&mut random, motor);
        let factor = 2.0_f64.powf(random.number());
        let dilator = Dilator::scaling(factor).expect("positive");
        law_of_points(&mut random, dilator);
        let bend = Transversor::by(random.vector());
        law_of_points(&mut random, bend);
        let plane = random.plane();
        law_of_points(&mut random, plane);
        let sphere = random.sphere();
        law_of_points(&mut random, sphere);
    }
}

/// A versor of a narrow type does what the same versor does as `Even` or `Odd`.
macro_rules! same_as_general {
    ($random:ident $Wide:ident $versor:expr; $($X:ident)*) => {{
        let versor = $versor;
        let scale = magnification(versor);
        $({
            let x: $X = $random.element();
            close(versor.apply(x), $Wide::from(versor).apply(x), scale);
        })*
    }};
}

macro_rules! every_operand {
    ($random:ident $Wide:ident $versor:expr) => {
        same_as_general! { $random $Wide $versor;
            Vector3 Bivector3 Trivector3 Point DualSphere DualPlane PointPair FlatPoint
            DirectionVector TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector
            TangentBivector Sphere Plane DirectionTrivector TangentTrivector Pseudoscalar Scalar
        }
    };
}

#[test]
fn narrow_versors_do_what_general_ones_do() {
    let mut random = Random::new(43);
    for _ in 0..300 {
        every_operand! { random Even random.rotor() }
        every_operand! { random Even random.translator() }
        every_operand! { random Even random.motor() }
        every_operand! { random Even Dilator::scaling(1.0 + 0.9 * random.number()).unwrap() }
        every_operand! { random Even Transversor::by(random.vector()) }
        every_operand! { random Odd random.plane() }
        every_operand! { random Odd random.sphere() }
        every_operand! { random Odd random.point() ^ random.point() ^ random.point() }
        every_operand! { random Even random.point() ^ random.point() }
    }
}

/// The inverse takes everything back: 10⁵ elements of each kind.
macro_rules! there_and_back {
    ($($test:ident $rounds:literal $versor:expr;)*) => {$(
        #[test]
        fn $test() {
            let mut random = Random::new(44);
            let make: fn(&mut Random) -> _ = $versor;
            for _ in 0..$rounds {
                let versor = make(&mut random);
                let back = versor.inverse().expect("a versor");
                let scale = magnification(versor);
                there_and_back! { @operands random versor back scale;
                    Vector3 Bivector3 Trivector3 Point DualSphere DualPlane PointPair FlatPoint
                    DirectionVector TangentVector DualLine MinkowskiPlane Circle Line
                    DirectionBivector TangentBivector Sphere Plane DirectionTrivector
                    TangentTrivector
                }
            }
        }
    )*};
    (@operands $random:ident $versor:ident $back:ident $scale:ident; $($X:ident)*) => {$({
        let x: $X = $random.element();
        close($back.apply($versor.apply(x)), x, $scale);
    })*};
}

there_and_back! {
    motors_are_undone 100_000 |random| random.motor();
    inversions_are_undone 100_000 |random| random.sphere();
    general_versors_are_undone 100_000 |random| random.even();
}
