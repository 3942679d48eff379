//! Paths from versor to versor (2.4.5.2).

use super::law::apart;
use crate::random::{Random, size};
use ga_cga::interpolate::{Connect, NoPath, VersorPath, Way};
use ga_cga::{
    Dilator, DualLine, Even, Motor, Odd, Point, PointPair, Rotor, Translator, Transversor, Vector3,
};
use std::f64::consts::PI;

/// A path starts and ends where it should, goes evenly, and its parts compose.
macro_rules! laws {
    ($random:ident $path:expr; $from:ident $to:ident) => {{
        let path = $path;
        let p = $random.point();
        let image = |versor| p.image_under(versor).expect("no point is sent to infinity");
        let tolerance = |point: Point| 1e-9 * (1.0 + point.position().norm());
        let start = image($from);
        assert!(image(path.at(0.0)).distance(start) < tolerance(start));
        let end = image($to);
        assert!(image(path.at(1.0)).distance(end) < tolerance(end));
        // It is the target with its norm, up to the sign, which says nothing.
        let off = apart(path.at(1.0), $to).min(apart(-path.at(1.0), $to));
        assert!(off < 1e-8, "{off}");
        assert!(apart(path.at(0.0), $from) < 1e-12);
        // What takes a third of the way takes the first third to the second.
        let step = path.at(1.0 / 3.0) * $from.inverse().expect("a versor");
        let second = step * path.at(1.0 / 3.0);
        let expected = image(path.at(2.0 / 3.0));
        assert!(image(second).distance(expected) < tolerance(expected));
    }};
}

#[test]
fn paths_between_motors_and_rotors() {
    let mut random = Random::new(71);
    for _ in 0..5_000 {
        let (a, b) = (random.motor() * 3.0, random.motor() * -0.5);
        let (c, d) = (random.rotor(), random.rotor());
        for way in [Way::Short, Way::Long] {
            laws! { random a.versor_path_to(b, way).expect("not opposite"); a b }
            laws! { random c.versor_path_to(d, way).expect("not opposite"); c d }
        }
        // The ways differ by a whole turn.
        let angle = |path: VersorPath<Rotor>| 2.0 * path.generator().norm();
        let [short, long] = [Way::Short, Way::Long]
            .map(|way| angle(c.versor_path_to(d, way).expect("not opposite")));
        assert!(short <= PI + 1e-12 && (short + long - 2.0 * PI).abs() < 1e-12);
    }
}

/// Half of a rigid way is a rigid way: what moves about a screw keeps its distance from it.
#[test]
fn motors_go_along_their_screw() {
    let mut random = Random::new(72);
    for _ in 0..1000 {
        let (axis, start) = (random.direction(), random.motor());
        let [x, y, z] = axis.to_array();
        let line = DualLine::new(z, -y, x, 0.0, 0.0, 0.0);
        let (angle, rise) = (3.0 * random.number(), random.number());
        let end = Motor::screw(line, angle, rise).expect("a line") * start;
        for (way, whole) in [
            (Way::Short, angle),
            (Way::Long, angle - 2.0 * PI * angle.signum()),
        ] {
            let path = start.versor_path_to(end, way).expect("not opposite");
            for i in 0..=4 {
                let t = f64::from(i) / 4.0;
                let expected = Motor::screw(line, t * whole, t * rise).expect("a line") * start;
                let p = random.point();
                let off = path.at(t).apply(p).distance(expected.apply(p));
                assert!(off < 1e-11, "{off}");
            }
        }
    }
}

#[test]
fn what_does_not_turn_has_one_way() {
    let mut random = Random::new(73);
    for _ in 0..1000 {
        let (a, b) = (random.translator(), random.translator());
        let path = a.versor_path_to(b, Way::Short).expect("a translation");
        let middle = path.at(0.25).vector();
        assert!((middle - (a.vector() * 0.75 + b.vector() * 0.25)).norm() < 1e-14);
        assert_eq!(a.versor_path_to(b, Way::Long), Err(NoPath::DoesNotTurn));

        let bends = [random.vector(), random.vector()].map(Transversor::by);
        let path = bends[0].versor_path_to(bends[1], Way::Short);
        let middle = path.expect("a transversion").at(0.5).vector();
        assert!((middle * 2.0 - bends[0].vector() - bends[1].vector()).norm() < 1e-14);
    }
}

/// Factors go evenly as powers, and never from positive to negative.
#[test]
fn scalings_go_by_powers() {
    let scaling = |factor: f64| Dilator::scaling(factor).expect("not zero");
    let path = scaling(2.0).versor_path_to(scaling(32.0), Way::Short);
    let middle = path.expect("both positive").at(0.5).factor();
    assert!((middle.expect("a factor") - 8.0).abs() < 1e-13);
    let path = scaling(-2.0).versor_path_to(scaling(-32.0), Way::Short);
    let middle = path.expect("both negative").at(0.5).factor();
    assert!((middle.expect("a factor") + 8.0).abs() < 1e-13);
    let mirrored = scaling(1.0).versor_path_to(scaling(-1.0), Way::Short);
    assert_eq!(mirrored, Err(NoPath::Reversed));
    let long = scaling(1.0).versor_path_to(scaling(2.0), Way::Long);
    assert_eq!(long, Err(NoPath::DoesNotTurn));
}

#[test]
fn paths_between_general_versors() {
    let mut random = Random::new(74);
    let mut gone = 0;
    for _ in 0..3_000 {
        let mut versor = || {
            let factor = 1.5 + random.number();
            let scaling = Dilator::scaling(factor).expect("positive");
            let bend = Transversor::by(random.vector() * 0.1);
            Even::similarity(scaling, random.rotor(), random.translator()) * bend
        };
        let (a, b) = (versor(), versor());
        for way in [Way::Short, Way::Long] {
            if let Ok(path) = a.versor_path_to(b, way) {
                gone += 1;
                laws! { random path; a b }
            }
        }
    }
    assert!(gone > 4_000, "{gone}");
}

/// Opposite rotations are joined by no single way, and equal versors by none that is long.
#[test]
fn ways_that_are_not_unique_are_refused() {
    let half_turn = |axis: Vector3| Rotor::about_axis(axis, PI).expect("an axis");
    let x = half_turn(Vector3::new(1.0, 0.0, 0.0));
    assert_eq!(x.versor_path_to(x, Way::Long), Err(NoPath::DoesNotTurn));
    let still = x.versor_path_to(x, Way::Short).expect("the identity");
    assert!(size(still.at(0.7) - x) < 1e-15);
    let null = Even::<f64>::default();
    assert_eq!(null.versor_path_to(null, Way::Short), Err(NoPath::Null));
    assert_eq!(
        Motor::<f64>::default().versor_path_to(Motor::identity(), Way::Short),
        Err(NoPath::Null)
    );
    let here = Translator::<f64>::identity();
    assert_eq!(
        here.versor_path_to(here, Way::Short).map(|p| p.at(3.0)),
        Ok(here)
    );
}

/// Odd versors, which have no logarithm of their own: reflections, glides, inversions, both ways.
#[test]
fn paths_between_odd_versors() {
    let mut random = Random::new(75);
    let (mut gone, mut refused) = (0, 0);
    for _ in 0..2_000 {
        let (a, b): (Odd, Odd) = (
            random.motor() * random.plane() * 2.0,
            random.motor() * random.plane() * -0.3,
        );
        for way in [Way::Short, Way::Long] {
            laws! { random a.versor_path_to(b, way).expect("rigid"); a b }
        }
        let (a, b): (Odd, Odd) = (a * random.even(), b * random.even());
        for way in [Way::Short, Way::Long] {
            match a.versor_path_to(b, way) {
                Ok(path) => {
                    gone += 1;
                    let off = apart(path.at(1.0), b).min(apart(-path.at(1.0), b));
                    assert!(off < 1e-6, "{off}");
                }
                Err(NoPath::Reversed | NoPath::DoesNotTurn) => (),
                Err(NoPath::ManyWays | NoPath::Imprecise) => refused += 1,
                Err(reason) => panic!("{reason} from {a} to {b}"),
            }
        }
    }
    // Some of these stretch so much that their ratio is known to few places.
    assert!(gone > 1_500 && refused < 40, "{gone} {refused}");
    let mirror: Odd = random.plane() * Motor::identity();
    let still = mirror
        .versor_path_to(mirror, Way::Short)
        .expect("nothing to do");
    assert!(apart(still.at(0.3), mirror) < 1e-14);
    let long = mirror.versor_path_to(mirror, Way::Long);
    assert_eq!(long, Err(NoPath::DoesNotTurn));
}

/// Simple rotors about a pair, real and imaginary: half the way is half the generator.
#[test]
fn simple_rotors_go_along_their_pair() {
    let mut random = Random::new(76);
    for _ in 0..1_000 {
        let square = if random.number() < 0.0 { -1.0 } else { 1.0 };
        let pair = PointPair::about(random.point(), square, random.direction());
        let (start, size) = (random.number(), 0.7 * random.number());
        let [from, to] = [start, start + size].map(|size| (pair * size).exp());
        let path = from.versor_path_to(to * 2.0, Way::Short).expect("simple");
        let expected = (pair * (start + size / 2.0)).exp() * 2.0_f64.sqrt();
        assert!(apart(path.at(0.5), expected) < 1e-9);
        // About an imaginary pair it turns, and can go the other way round.
        let long = from.versor_path_to(to, Way::Long);
        match square < 0.0 {
            true => {
                let whole = long.expect("a turn").generator();
                let turn = PI / (pair.norm_squared().abs().sqrt());
                let expected = pair * (size - turn * size.signum());
                assert!(apart(whole, expected) < 1e-8);
            }
            false => assert_eq!(long, Err(NoPath::DoesNotTurn)),
        }
    }
}

/// All of it in single precision.
#[test]
fn versors_in_single_precision() {
    let mut random = Random::new(77);
    for _ in 0..1_000 {
        let single = |motor: Motor| Motor::<f32>::from(motor.to_array().map(|c| c as f32));
        let (a, b) = (single(random.motor()), single(random.motor() * 4.0));
        for way in [Way::Short, Way::Long] {
            let path = a.versor_path_to(b, way).expect("not opposite");
            let off = apart(path.at(1.0), b).min(apart(-path.at(1.0), b));
            assert!(off < 1e-4, "{off}");
            let half: Motor<f32> = path.at(0.5) * a.inverse().expect("a motor");
            assert!(apart(half * path.at(0.5), path.at(1.0)) < 1e-4);
        }
    }
}
