//! The tables of products and involutions, and the order and signs of blades.

use std::collections::BTreeSet;

use ga_core::{Blade, Involution, Product, reorder_sign};

#[test]
fn every_row_has_its_own_names() {
    let products = Product::ALL.map(|which| (which.method(), which.trait_name()));
    let involutions = Involution::ALL.map(|which| (which.method(), which.trait_name()));
    let rows: Vec<_> = products.into_iter().chain(involutions).collect();
    let methods: BTreeSet<_> = rows.iter().map(|(method, _)| method).collect();
    assert_eq!(methods.len(), rows.len());
    for (method, trait_name) in rows {
        let words = method.split('_');
        let camel: String = words
            .map(|word| word[..1].to_uppercase() + &word[1..])
            .collect();
        assert_eq!(camel, trait_name);
    }
    let operators: Vec<_> = Product::ALL
        .into_iter()
        .filter_map(Product::operator)
        .collect();
    assert_eq!(operators, ["*", "^", "<<", "|", "&"]);
    for doc in Product::ALL
        .map(Product::doc)
        .iter()
        .chain(&Involution::ALL.map(Involution::doc))
    {
        assert!(doc.ends_with('.'));
    }
}

/// Algorithm A.3 against sorting by exchanges of neighbours.
#[test]
fn reordering_counts_exchanges() {
    for a in 0..64_u32 {
        for b in 0..64_u32 {
            let (a_list, b_list) = (Blade::new(a).indices(), Blade::new(b).indices());
            let mut list: Vec<usize> = a_list.chain(b_list).collect();
            let mut sign = 1;
            for end in (0..list.len()).rev() {
                for index in 0..end {
                    if list[index] > list[index + 1] {
                        list.swap(index, index + 1);
                        sign = -sign;
                    }
                }
            }
            assert_eq!(reorder_sign(a, b), sign, "{a:b} {b:b}");
        }
    }
}

#[test]
fn blades() {
    assert_eq!(Blade::default(), Blade::SCALAR);
    assert_eq!(Blade::pseudoscalar(0), Blade::SCALAR);
    assert_eq!(Blade::pseudoscalar(32), Blade::pseudoscalar(31 + 100));
    let top = Blade::new(1 << 31);
    assert!(top.contains(31) && !top.contains(32) && !top.contains(usize::MAX));
    assert!(top.indices().eq([31]));
    assert!(Blade::new(0b1000) < Blade::new(0b0011));
    assert!(Blade::new(0b0101) < Blade::new(0b0110));
}
