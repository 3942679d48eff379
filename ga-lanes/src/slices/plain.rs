//! When the elements of a slice are nothing but their coefficients, one after the other.

use ga_core::Element;

/// The most coefficients that are asked for; longer elements take the slow way.
pub const MOST_COLUMNS: usize = 16;

/// Repeats a condition for each position.
macro_rules! everywhere {
    ($position:ident => $condition:expr) => {
        everywhere! { @ $position => $condition; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 }
    };
    (@ $position:ident => $condition:expr; $($literal:literal)*) => {
        $({
            let $position = $literal;
            $condition
        })&&*
    };
}

/// Whether elements of a type are as long as their coefficients, of which there are some.
const fn fits<X: Element>() -> bool {
    let columns = X::BLADES.len();
    0 < columns
        && columns <= MOST_COLUMNS
        && size_of::<X>() == columns * size_of::<X::Number>()
        && align_of::<X>() >= align_of::<X::Number>()
}

/// Whether an element stores its coefficients one after the other and nothing else. Decided by the
/// addresses, which the compiler knows of generated types: nothing is left of it.
#[inline(always)]
fn is_plain<X: Element>(element: &X) -> bool {
    let first = core::ptr::from_ref(element).cast::<X::Number>();
    fits::<X>()
        && everywhere! { position =>
            position >= X::BLADES.len() || match element.place(position) {
                Some(place) => core::ptr::eq(place, first.wrapping_add(position)),
                None => false,
            }
        }
}

/// The same of where coefficients are written.
#[inline(always)]
fn is_plain_mut<X: Element>(element: &mut X) -> bool {
    let first = core::ptr::from_mut(element).cast::<X::Number>();
    fits::<X>()
        && everywhere! { position =>
            position >= X::BLADES.len() || match element.place_mut(position) {
                Some(place) => core::ptr::eq(place, first.wrapping_add(position)),
                None => false,
            }
        }
}

/// The coefficients of elements one after the other, if they stand in memory like that.
#[inline(always)]
pub fn numbers<X: Element>(elements: &[X]) -> Option<&[X::Number]> {
    let plain = fits::<X>() && elements.iter().all(is_plain);
    let count = elements.len() * X::BLADES.len();
    // SAFETY: every element has given references to numbers at each of these addresses, which fill
    // it, and they are borrowed as long as it is.
    plain.then(|| unsafe { core::slice::from_raw_parts(elements.as_ptr().cast(), count) })
}

/// The coefficients of elements one after the other, to be written.
#[inline(always)]
pub fn numbers_mut<X: Element>(elements: &mut [X]) -> Option<&mut [X::Number]> {
    let plain = fits::<X>() && elements.iter_mut().all(is_plain_mut);
    let count = elements.len() * X::BLADES.len();
    // SAFETY: every element has given references to numbers at each of these addresses, through
    // which any number may be written; they fill it and are borrowed as long as it is.
    plain.then(|| unsafe { core::slice::from_raw_parts_mut(elements.as_mut_ptr().cast(), count) })
}
