//! Operations that some elements have no value of: those, and no others, have none.

use ga_core::Element;
use ga_lanes::{Batch, Partial};

use super::plane;
use super::r3;
use super::samples::{LENGTHS, assert_same_element, elements, on_every_target};

fn assert_agree<X>(partial: &Partial<X>, expected: &[Option<X>], operation: &str)
where
    X: Element<Number: ga_lanes::Number + Into<f64>> + std::fmt::Debug,
{
    assert_eq!(partial.len(), expected.len());
    assert_eq!(partial.is_empty(), expected.is_empty());
    assert_eq!(partial.get(expected.len()), None);
    for (index, (value, other)) in partial.iter().zip(expected).enumerate() {
        assert_eq!(value, partial.get(index));
        assert_eq!(
            partial.exists()[index],
            other.is_some(),
            "{operation} at {index}"
        );
        if let (Some(value), Some(other)) = (value, other) {
            assert_same_element(&value, other, operation);
        }
    }
}

macro_rules! attempts {
    ($float:ident: $($algebra:ident $A:ident: $($method:ident)*;)*) => {{$(
        for len in LENGTHS {
            for spoilt in [None, Some(0), Some(1), Some(5), Some(16)] {
                let mut a = elements::<$algebra::$A<$float>>(len, 12);
                if let Some(element) = spoilt.and_then(|index| a.get_mut(index)) {
                    *element = Element::from_fn(|_| 0.0);
                }
                if let Some(element) = spoilt.and_then(|index| a.get_mut(2 * index + 1)) {
                    *element = Element::from_fn(|_| $float::NAN);
                }
                let batch = Batch::from_slice(&a);
                $({
                    let each: Vec<_> = a.iter().map(|a| a.$method()).collect();
                    assert_agree(&batch.$method(), &each, stringify!($method));
                })*
            }
        }
    )*}};
}

#[test]
fn values_exist_where_those_of_single_elements_do() {
    on_every_target(|| {
        attempts! { f32:
            r3 Even: inverse normalized;
            r3 Vector: inverse normalized;
            plane Pair: inverse normalized;
            plane Motor: inverse normalized;
        }
        attempts! { f64:
            r3 Even: inverse normalized renormalized;
            r3 Vector: inverse normalized;
            plane Pair: inverse normalized;
            plane Motor: inverse normalized;
        }
    });
}

#[test]
fn a_rotor_without_a_logarithm_leaves_its_neighbours_theirs() {
    on_every_target(|| {
        for without in 0..20 {
            let mut rotors: Vec<_> = elements::<r3::Bivector<f64>>(20, 13)
                .into_iter()
                .map(|plane| (plane * 0.5).exp())
                .collect();
            rotors[without] = r3::Even::from_fn(|position| if position == 0 { -1.0 } else { 0.0 });
            let batch = Batch::from_slice(&rotors);
            let (logarithms, roots) = (batch.log(), batch.sqrt());
            for (index, rotor) in rotors.iter().enumerate() {
                assert_eq!(logarithms.get(index).is_some(), index != without);
                assert_eq!(roots.get(index).is_some(), index != without);
                let back = logarithms.get(index).map(|log| log.exp() - *rotor);
                assert!(back.is_none_or(|rest| rest.norm() < 1e-12), "{rotor}");
                let back = roots.get(index).map(|root| root * root - *rotor);
                assert!(back.is_none_or(|rest| rest.norm() < 1e-12), "{rotor}");
            }
            assert_eq!(logarithms.all().err(), Some(without));
            assert_eq!(
                roots.or_zeros().get(without),
                Some(r3::Even::from_fn(|_| 0.0))
            );
        }
    });
}

#[test]
fn logarithms_of_general_versors_agree_with_single_ones() {
    on_every_target(|| {
        let mut versors: Vec<_> = elements::<plane::Pair<f64>>(37, 14)
            .into_iter()
            .map(|pair| (pair * 0.4).exp())
            .collect();
        versors[11] = plane::Even::from_fn(|_| 0.0);
        let logarithms = Batch::from_slice(&versors).log();
        for (index, versor) in versors.iter().enumerate() {
            let (own, alone) = (logarithms.get(index), versor.log());
            assert_eq!(own.is_some(), alone.is_some());
            if let (Some(own), Some(alone)) = (own, alone) {
                let positions = 0..plane::Pair::<f64>::BLADES.len();
                let distance = positions.map(|i| (own.at(i) - alone.at(i)).abs());
                assert!(distance.fold(0.0, f64::max) < 1e-12, "{own} and {alone}");
            }
        }
    });
}
