//! Where one type stores the coefficients of another: found when a program is compiled, so that
//! nothing is searched when it runs.

use core::marker::PhantomData;

use crate::ops::Element;
use crate::{Blade, Field};

/// Up to how many coefficients the places are looked up; those beyond are searched.
const MOST: usize = 64;

/// Where the coefficient of a blade comes from.
#[derive(Clone, Copy)]
pub enum Place {
    /// It is not stored, and zero.
    Nowhere,
    /// A stored coefficient, and whether the spelling of the blade negates it.
    Stored(usize, bool),
    /// A constant: sign, numerator and denominator.
    Fixed(i8, i64, i64),
}

impl Place {
    /// Where `X` has the coefficient of a blade in increasing order.
    pub const fn of<X: Element>(blade: Blade) -> Place {
        let mut i = 0;
        while i < X::FIXED.len() {
            let (fixed, sign, numerator, denominator) = X::FIXED[i];
            if fixed.mask() == blade.mask() {
                return Place::Fixed(sign, numerator, denominator);
            }
            i += 1;
        }
        let mut i = 0;
        while i < X::BLADES.len() {
            let (stored, sign) = X::BLADES[i];
            if stored.mask() == blade.mask() {
                return Place::Stored(i, sign < 0);
            }
            i += 1;
        }
        Place::Nowhere
    }

    /// The coefficient that an element has there.
    #[inline(always)]
    pub fn read<X: Element<Number: Field>>(self, x: &X) -> X::Number {
        match self {
            Place::Nowhere => <X::Number as crate::Scalar>::ZERO,
            Place::Stored(position, false) => x.at(position),
            Place::Stored(position, true) => -x.at(position),
            Place::Fixed(sign, numerator, denominator) => {
                super::signed(sign, X::Number::from_ratio(numerator, denominator))
            }
        }
    }
}

/// The places in `Wide` of what `Narrow` stores.
pub struct Places<Wide, Narrow>(PhantomData<(Wide, Narrow)>);

impl<Wide: Element, Narrow: Element> Places<Wide, Narrow> {
    const TABLE: [Place; MOST] = {
        let mut table = [Place::Nowhere; MOST];
        let mut i = 0;
        while i < Narrow::BLADES.len() && i < MOST {
            table[i] = Place::of::<Wide>(Narrow::BLADES[i].0);
            i += 1;
        }
        table
    };

    /// Where the stored coefficient at a position of `Narrow` comes from.
    #[inline(always)]
    pub fn at(position: usize) -> Place {
        match Self::TABLE.get(position) {
            Some(place) => *place,
            None => Place::of::<Wide>(Narrow::BLADES[position].0),
        }
    }
}
