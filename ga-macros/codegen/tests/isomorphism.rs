//! Products through matrices against the dense multivectors of ga-core, exactly, in every
//! signature of five to eight dimensions and in bases with pairs of null vectors.

use ga_codegen::isomorphism::{Parity, Signed, Tables, tables};
use ga_core::dense::Algebra;
use ga_core::matrix::{Isomorphism, Term};
use ga_core::{Metric, Rational};

/// Pairs of parities whose products have different tables.
const PAIRS: [(Parity, Parity); 9] = {
    use Parity::{Both, Even, Odd};
    [
        (Both, Both),
        (Even, Even),
        (Even, Odd),
        (Odd, Even),
        (Odd, Odd),
        (Both, Even),
        (Both, Odd),
        (Even, Both),
        (Odd, Both),
    ]
};

/// A table of blades as a table of their bitmasks.
fn bytes(blades: impl Iterator<Item = (usize, bool)>) -> Vec<u8> {
    let entry = |(position, negative): (usize, bool)| {
        let position = u16::try_from(position).expect("a few blades");
        (position | u16::from(negative) << 15).to_le_bytes()
    };
    blades.flat_map(entry).collect()
}

/// The product of coefficients by bitmask.
fn through<const N: usize, const HEIGHT: usize, const WIDTH: usize, const UNITS: usize>(
    tables: &Tables,
    a: &[f64],
    b: &[f64],
) -> Vec<f64> {
    let places = |blades: &[Signed]| {
        let blades = blades.iter();
        bytes(blades.map(|blade| (blade.mask as usize, blade.negative)))
    };
    let operands: Vec<[Vec<u8>; 2]> = tables
        .terms
        .iter()
        .map(|term| [places(&term.left), places(&term.right)])
        .collect();
    let terms: Vec<Term<'_>> = tables
        .terms
        .iter()
        .zip(&operands)
        .map(|(term, [left, right])| Term {
            part: term.part,
            left,
            right,
        })
        .collect();
    let result = bytes((0..N as u32).map(|mask| tables.entry(mask, false)));
    let isomorphism = Isomorphism::<'_, HEIGHT, WIDTH, UNITS> {
        pairs: tables.pairs,
        terms: &terms,
        result: &result,
    };
    let [a, b] = [a, b].map(|x| <[f64; N]>::try_from(x).expect("as many as blades"));
    let mut product: [f64; N] = isomorphism.product(0.5, &a, &b);
    for (mask, value) in (0..).zip(&mut product) {
        if !tables.result.iter().any(|blade| blade.mask == mask) {
            *value = 0.0;
        }
    }
    product.to_vec()
}

/// The same for matrices of a size known at run time.
fn product(tables: &Tables, a: &[f64], b: &[f64]) -> Vec<f64> {
    macro_rules! of_size {
        ($($size:literal { $($height:literal $width:literal $units:literal),* })*) => {
            match (a.len(), tables.height, tables.width, tables.units) {
                $($(($size, $height, $width, $units) => {
                    through::<$size, $height, $width, $units>(tables, a, b)
                })*)*
                size => panic!("matrices of size {size:?} in no list"),
            }
        };
    }
    of_size! {
        32 { 2 4 2, 2 4 4, 2 8 4, 4 4 1, 4 8 2, 4 8 4, 8 4 1 }
        64 { 2 4 2, 2 4 4, 2 8 4, 4 4 1, 4 8 2, 4 8 4, 4 16 4, 8 4 1, 8 8 1 }
        128 {
            2 8 4, 4 4 1, 4 8 2, 4 8 4, 4 16 4, 8 4 1, 8 8 1, 8 16 2, 8 16 4, 16 8 1
        }
        256 {
            4 8 2, 4 8 4, 4 16 4, 8 4 1, 8 8 1, 8 16 2, 8 16 4, 8 32 4, 16 8 1, 16 16 1
        }
    }
}

/// Small integers that are the same in every run.
struct Samples(u64);

impl Samples {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 20) as f64 % 7.0 - 3.0
    }

    /// Coefficients by bitmask, zero for blades of the other parity.
    fn of(&mut self, parity: Parity, count: usize) -> Vec<f64> {
        let has = |mask: usize| match parity {
            Parity::Both => true,
            Parity::Even => mask.count_ones().is_multiple_of(2),
            Parity::Odd => mask.count_ones() % 2 == 1,
        };
        (0..count)
            .map(|mask| if has(mask) { self.next() } else { 0.0 })
            .collect()
    }
}

/// Compares all products of a metric; how many go through matrices.
fn compare(name: &str, metric: &Metric, pairs: &[(Parity, Parity)]) -> usize {
    let algebra = Algebra::<i64>::integral(metric).expect("integers");
    let mut samples = Samples(metric.dimension() as u64 * 977 + 1);
    let mut compared = 0;
    for &(left, right) in pairs {
        let Some(tables) = tables(metric, left, right) else {
            continue;
        };
        let count = 1 << metric.dimension();
        let (a, b) = (samples.of(left, count), samples.of(right, count));
        let dense = |x: &[f64]| {
            let integers = x.iter().map(|x| *x as i64).collect();
            algebra
                .from_coefficients(integers)
                .expect("as many as blades")
        };
        let expected = dense(&a).geometric(&dense(&b)).expect("one algebra");
        let expected: Vec<f64> = expected.coefficients().iter().map(|x| *x as f64).collect();
        assert_eq!(
            product(&tables, &a, &b),
            expected,
            "{name} {left:?} {right:?}"
        );
        compared += 1;
    }
    compared
}

fn signatures(dimension: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..=dimension).flat_map(move |p| (0..=dimension - p).map(move |q| (p, q, dimension - p - q)))
}

fn in_dimension(dimension: usize, pairs: &[(Parity, Parity)]) {
    for (p, q, r) in signatures(dimension) {
        let metric = Metric::from_signature(p, q, r).expect("few vectors");
        let compared = compare(&format!("R{p}_{q}_{r}"), &metric, pairs);
        // All products without vectors of square zero; with up to two, those that are not tiny.
        let fewest = match (r, dimension) {
            (0, _) | (1, 6..) | (2, 7..) => pairs.len(),
            (1, _) | (2, 6) => 1,
            _ => 0,
        };
        assert!(compared >= fewest, "R{p}_{q}_{r}: {compared}");
        assert!(r <= 2 || compared == 0, "R{p}_{q}_{r}: {compared}");
    }
}

#[test]
fn every_signature_of_five_dimensions() {
    in_dimension(5, &PAIRS);
}

#[test]
fn every_signature_of_six_dimensions() {
    in_dimension(6, &PAIRS);
}

#[test]
fn every_signature_of_seven_dimensions() {
    in_dimension(7, &PAIRS[..5]);
}

#[test]
fn every_signature_of_eight_dimensions() {
    in_dimension(8, &PAIRS[..2]);
}

/// A basis with so many pairs of null vectors, interleaved with the others.
fn with_null_pairs((p, q, r): (usize, usize, usize), count: usize, product: i128) -> Metric {
    let dimension = p + q + r;
    let mut gram = vec![vec![Rational::ZERO; dimension]; dimension];
    let mut squares = [(p - count, 1), (q - count, -1), (r, 0)]
        .into_iter()
        .flat_map(|(count, square)| std::iter::repeat_n(square, count));
    for pair in 0..count {
        // One within the other: v1 meets the last vector, v2 the one before it.
        let (u, v) = (pair, dimension - 1 - pair);
        gram[u][v] = Rational::from_integer(product);
        gram[v][u] = gram[u][v];
    }
    for (index, row) in gram.iter_mut().enumerate().skip(count) {
        row[index] += squares
            .next()
            .map_or(Rational::ZERO, Rational::from_integer);
    }
    let names = (1..=dimension).map(|number| format!("v{number}"));
    Metric::new(names, gram).expect("a metric")
}

#[test]
fn bases_with_pairs_of_null_vectors() {
    for dimension in 5..=7 {
        let pairs = if dimension == 7 { &PAIRS[..2] } else { &PAIRS };
        for (p, q, r) in signatures(dimension) {
            for count in 1..=p.min(q) {
                for product in [1, -1] {
                    let metric = with_null_pairs((p, q, r), count, product);
                    assert_eq!(metric.signature(), (p, q, r));
                    let name = format!("R{p}_{q}_{r} with {count} pairs");
                    let compared = compare(&name, &metric, pairs);
                    assert!(compared > 0 || r > 0, "{name}");
                }
            }
        }
    }
}

/// The conformal model of four-dimensional space, and with all vectors in null pairs, where no
/// vector is left to make the even part an algebra of its own.
#[test]
fn eight_dimensions_with_pairs_of_null_vectors() {
    assert_eq!(
        compare("one", &with_null_pairs((5, 3, 0), 1, -1), &PAIRS),
        9
    );
    assert_eq!(compare("all", &with_null_pairs((4, 4, 0), 4, 1), &PAIRS), 1);
}

/// What each algebra is isomorphic to, by the classification of Clifford algebras.
#[test]
fn matrices_are_those_of_the_classification() {
    let name = |p, q, parity| {
        let metric = Metric::from_signature(p, q, 0).expect("few vectors");
        tables(&metric, parity, parity).map(|tables| tables.name())
    };
    let all = |p, q| name(p, q, Parity::Both).expect("matrices");
    let even = |p, q| name(p, q, Parity::Even).expect("matrices");
    assert_eq!(all(4, 1), "4×4 complex matrices");
    assert_eq!(all(3, 2), "2 products of 4×4 real matrices");
    assert_eq!(all(5, 0), "2 products of 2×2 quaternion matrices");
    assert_eq!(all(6, 0), "4×4 quaternion matrices");
    assert_eq!(all(3, 3), "8×8 real matrices");
    assert_eq!(all(2, 4), "4×4 quaternion matrices");
    assert_eq!(all(4, 2), "8×8 real matrices");
    assert_eq!(all(7, 0), "8×8 complex matrices");
    assert_eq!(all(8, 0), "16×16 real matrices");
    assert_eq!(all(4, 4), "16×16 real matrices");
    assert_eq!(even(4, 1), "2×2 quaternion matrices");
    assert_eq!(even(3, 2), "4×4 real matrices");
    assert_eq!(even(6, 0), "4×4 complex matrices");
    assert_eq!(even(3, 3), "2 products of 4×4 real matrices");
}

/// Metrics that are no blocks of vectors of square ±1 or 0 and pairs of null vectors.
#[test]
fn other_metrics_have_none() {
    let diagonal = |squares: [i128; 5]| {
        let mut gram = vec![vec![Rational::ZERO; 5]; 5];
        for (index, square) in squares.into_iter().enumerate() {
            gram[index][index] = Rational::from_integer(square);
        }
        gram
    };
    let none = |gram| {
        let metric = Metric::new((1..=5).map(|n| format!("e{n}")), gram).expect("a metric");
        PAIRS.iter().all(|(a, b)| tables(&metric, *a, *b).is_none())
    };
    assert!(none(diagonal([1, 1, 1, 1, 2])));
    let mut half = diagonal([1, 1, 1, 1, 1]);
    half[0][0] = Rational::new(1, 2);
    assert!(none(half));
    let mut oblique = diagonal([1, 1, 1, 1, 0]);
    oblique[3][4] = Rational::ONE;
    oblique[4][3] = Rational::ONE;
    assert!(none(oblique));
    let mut scaled = diagonal([1, 1, 1, 0, 0]);
    scaled[3][4] = Rational::from_integer(2);
    scaled[4][3] = Rational::from_integer(2);
    assert!(none(scaled));
    let mut three = diagonal([1, 1, 0, 0, 0]);
    for (i, j) in [(2, 3), (3, 4)] {
        three[i][j] = Rational::ONE;
        three[j][i] = Rational::ONE;
    }
    assert!(none(three));
    assert!(none(diagonal([0, 0, 0, 0, 0])));
}
