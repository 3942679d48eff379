//! §2.5: the inner product, (2.71).

use ga_cga::{Multivector, Scalar};
use ga_core::Rational;

use super::euclidean::r3;
use super::samples::each;

/// A·B is the part ⟨AB⟩ of grade |b − a|, and 0 if either is a scalar.
#[test]
fn equation_2_71_the_inner_product_keeps_the_lowest_grade() {
    each(|samples| {
        let [a, b] = [(); 2].map(|()| Multivector::from([(); 32].map(|()| samples.whole(5))));
        let mut sum = Multivector::<Rational>::default();
        for j in 0..=5_u32 {
            for k in 0..=5_u32 {
                let (x, y) = (a.grade(j), b.grade(k));
                let expected = if j == 0 || k == 0 {
                    Multivector::default()
                } else {
                    (x * y).grade(j.abs_diff(k))
                };
                assert_eq!(x | y, expected, "grades {j} and {k}");
                sum += expected;
            }
        }
        assert_eq!(a | b, sum);
        let number = Scalar::new(samples.number::<Rational>());
        assert_eq!(Multivector::from(number) | a, Multivector::default());
        // Where both have a grade above 0, it is the contraction of the lower on the higher.
        let v: r3::Vector<Rational> = samples.element();
        let plane: r3::Bivector<Rational> = samples.element();
        assert_eq!(v | plane, v << plane);
        assert_eq!(plane | v, -(v | plane));
    });
}
