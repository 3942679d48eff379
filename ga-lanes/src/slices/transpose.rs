//! How a block of structs becomes lanes and lanes a block of structs: by transposing squares of 128
//! bits.
//!
//! A square takes as many coefficients as 128 bits hold, of as many structs; the squares of the
//! other structs of the block stand beside it in the same registers. Coefficients that fill no
//! square take the first ones of the next struct with them.

use ga_core::{Element, Scalar};

use super::plain;
#[cfg(target_arch = "x86_64")]
use super::plain::MOST_COLUMNS;
#[cfg(target_arch = "x86_64")]
use super::squares::{Doubles2, Doubles4, Rows, Singles4, Singles8};
use crate::lanes::Lanes;
use crate::number::Number;

/// Repeats statements for each index below a bound that is known at compile time. A loop would be
/// unrolled too late, and a closure be left apart from the function of the target.
#[cfg(target_arch = "x86_64")]
macro_rules! repeat {
    ($index:ident < $count:expr => $body:expr) => {
        repeat! { @ $index < $count => $body; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 }
    };
    (@ $index:ident < $count:expr => $body:expr; $($literal:literal)*) => {$(
        if const { $literal < $count } {
            let $index = $literal;
            $body
        }
    )*};
}

/// Calls a function with the rows that the lanes are on their target.
#[cfg(target_arch = "x86_64")]
macro_rules! by_target {
    ($number:ty, $lanes:ty, $function:ident::<$first:ident>($($argument:expr),*)) => {
        match const { (size_of::<$number>(), <$lanes>::COUNT) } {
            (4, 4) => $function::<$first, $lanes, Singles4>($($argument),*),
            (4, 8) => $function::<$first, $lanes, Singles8>($($argument),*),
            (8, 2) => $function::<$first, $lanes, Doubles2>($($argument),*),
            (8, 4) => $function::<$first, $lanes, Doubles4>($($argument),*),
            _ => None,
        }
    };
}

/// The elements of a block of as many as there are lanes.
#[inline(always)]
pub fn gathered<X, L>(block: &[X]) -> X::Over<L>
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
{
    #[cfg(target_arch = "x86_64")]
    if let Some(numbers) = plain::numbers(block)
        && let Some(elements) = by_target!(X::Number, L, transposed_in::<X>(numbers))
    {
        return elements;
    }
    X::Over::<L>::from_fn(|position| {
        let mut array = L::array(|_| X::Number::ZERO);
        for (number, element) in array.as_mut().iter_mut().zip(block) {
            *number = element.at(position);
        }
        L::load(&array)
    })
}

/// Writes elements to a block of as many as there are lanes.
#[inline(always)]
pub fn scatter<Z, L>(value: Z::Over<L>, block: &mut [Z])
where
    Z: Element<Number: Number>,
    L: Lanes<Z::Number>,
{
    #[cfg(target_arch = "x86_64")]
    if let Some(numbers) = plain::numbers_mut(block)
        && by_target!(Z::Number, L, transposed_out::<Z>(value, numbers)).is_some()
    {
        return;
    }
    for (lane, element) in block.iter_mut().enumerate() {
        *element = Z::from_fn(|position| {
            let mut array = L::array(|_| Z::Number::ZERO);
            value.at(position).store(&mut array);
            array.as_ref()[lane]
        });
    }
}

/// How many squares the coefficients of an element take.
#[cfg(target_arch = "x86_64")]
const fn squares<X: Element, R: Rows>() -> usize {
    X::BLADES.len().div_ceil(R::SIDE)
}

/// The elements with these coefficients; `None` where there are not as many as lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn transposed_in<X, L, R>(numbers: &[X::Number]) -> Option<X::Over<L>>
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
    R: Rows,
{
    let columns = X::BLADES.len();
    if !fits::<X, L, R>(numbers.len()) {
        return None;
    }
    if const { X::BLADES.len() == 3 } {
        return triples_in::<X, L, R>(numbers);
    }
    // The last coefficients of the last element, behind which there is nothing.
    let last = numbers.len() - columns % R::SIDE;
    let mut end = [X::Number::ZERO; 4];
    for (place, number) in end.iter_mut().zip(&numbers[last..]) {
        *place = *number;
    }
    let mut lanes = [L::ZERO; MOST_COLUMNS];
    repeat! { square < squares::<X, R>() => {
        let place = |height: usize, beside: usize| {
            let index = (beside * R::SIDE + height) * columns + square * R::SIDE;
            match numbers.get(index..index + R::SIDE) {
                Some(numbers) => numbers.as_ptr().cast::<u8>(),
                None => end.as_ptr().cast::<u8>(),
            }
        };
        let row = |height: usize| {
            let places = [place(height, 0), place(height, 1)];
            // SAFETY: lanes `L` are there, so the machine has their target, of which the rows are;
            // each address is that of `SIDE` numbers.
            unsafe { R::load(places) }
        };
        let last = R::SIDE - 1;
        let rows = [row(0), row(1), row(last - 1), row(last)];
        // SAFETY: as above.
        let rows = unsafe { R::transposed(rows) };
        for (lanes, row) in lanes[square * R::SIDE..].iter_mut().zip(&rows[..R::SIDE]) {
            // SAFETY: `fits` has compared the sizes.
            *lanes = unsafe { lanes_of::<X::Number, L, R>(*row) };
        }
    }}
    Some(X::Over::<L>::from_fn(|position| {
        lanes.get(position).copied().unwrap_or(L::ZERO)
    }))
}

/// Whether there is a number for every coefficient of every lane, and rows hold as many as lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn fits<X, L, R>(numbers: usize) -> bool
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
    R: Rows,
{
    let columns = X::BLADES.len();
    1 < columns
        && columns <= MOST_COLUMNS
        && numbers == columns * L::COUNT
        && L::COUNT == R::SIDE * R::SQUARES
        && size_of::<R>() == size_of::<L::Array>()
}

/// Writes the coefficients of elements; `None`, without having done so, where there is not place
/// for as many as lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn transposed_out<Z, L, R>(value: Z::Over<L>, numbers: &mut [Z::Number]) -> Option<()>
where
    Z: Element<Number: Number>,
    L: Lanes<Z::Number>,
    R: Rows,
{
    let columns = Z::BLADES.len();
    if !fits::<Z, L, R>(numbers.len()) {
        return None;
    }
    if const { Z::BLADES.len() == 3 } {
        return triples_out::<Z, L, R>(value, numbers);
    }
    // SAFETY: `fits` has compared the sizes.
    let row_of = |position: usize| unsafe { row_of::<Z::Number, L, R>(value.at(position)) };
    let mut rows = [[row_of(0); 4]; MOST_COLUMNS];
    repeat! { square < squares::<Z, R>() => {
        let first = square * R::SIDE;
        let columns = [row_of(first), row_of(first + 1), row_of(first + 2), row_of(first + 3)];
        // SAFETY: lanes `L` are there, so the machine has their target, of which the rows are.
        rows[square] = unsafe { R::transposed(columns) };
    }}
    let last = numbers.len() - columns % R::SIDE;
    let mut end = [Z::Number::ZERO; 4];
    // Element by element, because a square that is not filled writes over the next element.
    repeat! { lane < L::COUNT => {
        let (beside, height) = (lane / R::SIDE, lane % R::SIDE);
        repeat! { square < squares::<Z, R>() => {
            let index = lane * columns + square * R::SIDE;
            let place = match numbers.get_mut(index..index + R::SIDE) {
                Some(numbers) => numbers.as_mut_ptr().cast::<u8>(),
                None => end.as_mut_ptr().cast::<u8>(),
            };
            // SAFETY: as above, and the address is that of `SIDE` numbers.
            unsafe { rows[square][height].store(beside, place) };
        }}
    }}
    for (place, number) in numbers[last..].iter_mut().zip(end) {
        *place = number;
    }
    Some(())
}

/// The numbers of a row as lanes.
///
/// # Safety
/// A row is as long as the lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
unsafe fn lanes_of<F: Number, L: Lanes<F>, R: Rows>(row: R) -> L {
    // SAFETY: rows and arrays are numbers, and of one length, as the caller promises.
    L::load(&unsafe { core::mem::transmute_copy::<R, L::Array>(&row) })
}

/// The numbers of lanes as a row.
///
/// # Safety
/// A row is as long as the lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
unsafe fn row_of<F: Number, L: Lanes<F>, R: Rows>(lanes: L) -> R {
    let mut array = L::array(|_| F::ZERO);
    lanes.store(&mut array);
    // SAFETY: as above.
    unsafe { core::mem::transmute_copy::<L::Array, R>(&array) }
}

/// Where the rows of triples begin: in each of the squares, after as many triples as stand in the
/// ones before it.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn start_of_triples<R: Rows>(row: usize, beside: usize) -> usize {
    (beside * 3 + row) * R::SIDE
}

/// [`transposed_in`] of three coefficients, of which nothing is left over.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn triples_in<X, L, R>(numbers: &[X::Number]) -> Option<X::Over<L>>
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
    R: Rows,
{
    let place = |row: usize, beside: usize| {
        let start = start_of_triples::<R>(row, beside % R::SQUARES);
        let numbers = numbers.get(start..start + R::SIDE)?;
        Some(numbers.as_ptr().cast::<u8>())
    };
    // SAFETY: lanes `L` are there, so the machine has their target, of which the rows are; each
    // address is that of `SIDE` numbers, and `fits` has compared the sizes.
    let [x, y, z] = unsafe {
        R::of_triples([
            R::load([place(0, 0)?, place(0, 1)?]),
            R::load([place(1, 0)?, place(1, 1)?]),
            R::load([place(2, 0)?, place(2, 1)?]),
        ])
        .map(|row| lanes_of::<X::Number, L, R>(row))
    };
    let lanes = [x, y, z];
    Some(X::Over::<L>::from_fn(|position| {
        lanes.get(position).copied().unwrap_or(L::ZERO)
    }))
}

/// [`transposed_out`] of three coefficients.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn triples_out<Z, L, R>(value: Z::Over<L>, numbers: &mut [Z::Number]) -> Option<()>
where
    Z: Element<Number: Number>,
    L: Lanes<Z::Number>,
    R: Rows,
{
    // SAFETY: lanes `L` are there, so the machine has their target, of which the rows are, and
    // `fits` has compared the sizes.
    let rows = unsafe {
        R::to_triples([
            row_of::<Z::Number, L, R>(value.at(0)),
            row_of::<Z::Number, L, R>(value.at(1)),
            row_of::<Z::Number, L, R>(value.at(2)),
        ])
    };
    repeat! { beside < R::SQUARES => {
        for (row, numbers_of_row) in rows.iter().enumerate() {
            let start = start_of_triples::<R>(row, beside);
            let place = numbers.get_mut(start..start + R::SIDE)?.as_mut_ptr();
            // SAFETY: as above, and the address is that of `SIDE` numbers.
            unsafe { numbers_of_row.store(beside, place.cast()) };
        }
    }}
    Some(())
}
