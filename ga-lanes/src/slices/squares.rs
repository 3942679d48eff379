//! Registers as rows of squares: 128 bits for each square, of one struct each.

use core::arch::x86_64::*;

/// A register that holds a row of several squares side by side.
///
/// # Safety
/// Every function may be called only on a machine with the instructions of the register's target.
pub trait Rows: Copy {
    /// How many numbers 128 bits hold: the side of a square.
    const SIDE: usize;
    /// How many squares stand side by side.
    const SQUARES: usize;
    /// The rows that begin at these addresses.
    ///
    /// # Safety
    /// 128 bits can be read at each of the first `SQUARES` addresses, aligned or not.
    unsafe fn load(places: [*const u8; 2]) -> Self;
    /// Writes the row of one square.
    ///
    /// # Safety
    /// 128 bits can be written at the address, aligned or not.
    unsafe fn store(self, square: usize, place: *mut u8);
    /// Rows become columns in every square.
    unsafe fn transposed(rows: [Self; 4]) -> [Self; 4];
    /// Three rows of `SIDE` triples, one after the other, become three columns.
    unsafe fn of_triples(rows: [Self; 3]) -> [Self; 3];
    /// The inverse: three columns become triples, one after the other.
    unsafe fn to_triples(columns: [Self; 3]) -> [Self; 3];
}

macro_rules! rows {
    ($name:ident($register:ident) $side:literal $squares:literal
        load($places:ident) { $load:expr }
        store($self:ident, $square:ident) { $store:expr }
        transposed($($row:ident)*) { $transposed:expr }
        of_triples($($triple:ident)*) { $of_triples:expr }
        to_triples($($column:ident)*) { $to_triples:expr }
    ) => {
        /// Rows in this register.
        #[derive(Clone, Copy)]
        pub struct $name($register);

        impl Rows for $name {
            const SIDE: usize = $side;
            const SQUARES: usize = $squares;

            #[inline(always)]
            unsafe fn load($places: [*const u8; 2]) -> Self {
                // SAFETY: the caller promises the instructions and the addresses.
                $name(unsafe { $load })
            }

            #[inline(always)]
            unsafe fn store($self, $square: usize, place: *mut u8) {
                // SAFETY: the caller promises the instructions and the address.
                unsafe { _mm_storeu_ps(place.cast(), $store) };
            }

            #[inline(always)]
            unsafe fn transposed([$($row),*]: [Self; 4]) -> [Self; 4] {
                // SAFETY: the caller promises the instructions.
                let rows: [$register; 4] = unsafe { $transposed };
                rows.map($name)
            }

            #[inline(always)]
            unsafe fn of_triples([$($triple),*]: [Self; 3]) -> [Self; 3] {
                // SAFETY: the caller promises the instructions.
                let columns: [$register; 3] = unsafe { $of_triples };
                columns.map($name)
            }

            #[inline(always)]
            unsafe fn to_triples([$($column),*]: [Self; 3]) -> [Self; 3] {
                // SAFETY: the caller promises the instructions.
                let rows: [$register; 3] = unsafe { $to_triples };
                rows.map($name)
            }
        }
    };
}

/// Squares of four by four, in two steps: numbers alternate, then pairs do.
macro_rules! four_by_four {
    ($a:ident $b:ident $c:ident $d:ident $low:ident $high:ident $pairs:ident) => {{
        let (low, low_end) = ($low($a.0, $b.0), $low($c.0, $d.0));
        let (high, high_end) = ($high($a.0, $b.0), $high($c.0, $d.0));
        [
            $pairs::<0x44>(low, low_end),
            $pairs::<0xee>(low, low_end),
            $pairs::<0x44>(high, high_end),
            $pairs::<0xee>(high, high_end),
        ]
    }};
}

/// Squares of two by two.
macro_rules! two_by_two {
    ($a:ident $b:ident $c:ident $d:ident $low:ident $high:ident $to:ident $from:ident) => {{
        let (a, b) = ($to($a.0), $to($b.0));
        [$from($low(a, b)), $from($high(a, b)), $c.0, $d.0]
    }};
}

/// Four triples: x y z x, y z x y, z x y z.
macro_rules! of_four_triples {
    ($a:ident $b:ident $c:ident $shuffle:ident) => {{
        let xy = $shuffle::<0b10_01_11_10>($b.0, $c.0);
        let yz = $shuffle::<0b01_00_10_01>($a.0, $b.0);
        [
            $shuffle::<0b10_00_11_00>($a.0, xy),
            $shuffle::<0b11_01_10_00>(yz, xy),
            $shuffle::<0b11_00_11_01>(yz, $c.0),
        ]
    }};
}

/// Back.
macro_rules! to_four_triples {
    ($x:ident $y:ident $z:ident $shuffle:ident) => {{
        let xy = $shuffle::<0b10_00_10_00>($x.0, $y.0);
        let yz = $shuffle::<0b11_01_11_01>($y.0, $z.0);
        let zx = $shuffle::<0b11_01_10_00>($z.0, $x.0);
        [
            $shuffle::<0b10_00_10_00>(xy, zx),
            $shuffle::<0b11_01_10_00>(yz, xy),
            $shuffle::<0b11_01_11_01>(zx, yz),
        ]
    }};
}

/// Two triples: x y, z x, y z; the masks take the first of the one and the second of the other, and
/// the other way round.
macro_rules! of_two_triples {
    ($a:ident $b:ident $c:ident $shuffle:ident $straight:literal $crossed:literal $to:ident $from:ident) => {{
        let (a, b, c) = ($to($a.0), $to($b.0), $to($c.0));
        [
            $from($shuffle::<$straight>(a, b)),
            $from($shuffle::<$crossed>(a, c)),
            $from($shuffle::<$straight>(b, c)),
        ]
    }};
}

/// Back.
macro_rules! to_two_triples {
    ($x:ident $y:ident $z:ident $shuffle:ident $straight:literal $low:ident $high:ident $to:ident $from:ident) => {{
        let (x, y, z) = ($to($x.0), $to($y.0), $to($z.0));
        [
            $from($low(x, y)),
            $from($shuffle::<$straight>(z, x)),
            $from($high(y, z)),
        ]
    }};
}

/// Once or twice 128 bits from memory.
macro_rules! pieces {
    ($places:ident 1) => {
        _mm_loadu_ps($places[0].cast())
    };
    ($places:ident 2) => {
        _mm256_insertf128_ps::<1>(
            _mm256_castps128_ps256(pieces!($places 1)),
            _mm_loadu_ps($places[1].cast()),
        )
    };
}

/// 128 bits of twice as many.
macro_rules! piece {
    ($register:expr, $square:ident) => {
        match $square {
            0 => _mm256_castps256_ps128($register),
            _ => _mm256_extractf128_ps::<1>($register),
        }
    };
}

rows! { Singles4(__m128) 4 1
    load(places) { pieces!(places 1) }
    store(self, _square) { self.0 }
    transposed(a b c d) { four_by_four!(a b c d _mm_unpacklo_ps _mm_unpackhi_ps _mm_shuffle_ps) }
    of_triples(a b c) { of_four_triples!(a b c _mm_shuffle_ps) }
    to_triples(x y z) { to_four_triples!(x y z _mm_shuffle_ps) }
}

rows! { Singles8(__m256) 4 2
    load(places) { pieces!(places 2) }
    store(self, square) { piece!(self.0, square) }
    transposed(a b c d) {
        four_by_four!(a b c d _mm256_unpacklo_ps _mm256_unpackhi_ps _mm256_shuffle_ps)
    }
    of_triples(a b c) { of_four_triples!(a b c _mm256_shuffle_ps) }
    to_triples(x y z) { to_four_triples!(x y z _mm256_shuffle_ps) }
}

rows! { Doubles2(__m128) 2 1
    load(places) { pieces!(places 1) }
    store(self, _square) { self.0 }
    transposed(a b c d) {
        two_by_two!(a b c d _mm_unpacklo_pd _mm_unpackhi_pd _mm_castps_pd _mm_castpd_ps)
    }
    of_triples(a b c) {
        of_two_triples!(a b c _mm_shuffle_pd 0b10 0b01 _mm_castps_pd _mm_castpd_ps)
    }
    to_triples(x y z) {
        to_two_triples!(
            x y z _mm_shuffle_pd 0b10 _mm_unpacklo_pd _mm_unpackhi_pd _mm_castps_pd _mm_castpd_ps
        )
    }
}

rows! { Doubles4(__m256) 2 2
    load(places) { pieces!(places 2) }
    store(self, square) { piece!(self.0, square) }
    transposed(a b c d) {
        two_by_two!(a b c d _mm256_unpacklo_pd _mm256_unpackhi_pd _mm256_castps_pd _mm256_castpd_ps)
    }
    of_triples(a b c) {
        of_two_triples!(a b c _mm256_shuffle_pd 0b1010 0b0101 _mm256_castps_pd _mm256_castpd_ps)
    }
    to_triples(x y z) {
        to_two_triples!(
            x y z _mm256_shuffle_pd 0b1010 _mm256_unpacklo_pd _mm256_unpackhi_pd _mm256_castps_pd _mm256_castpd_ps
        )
    }
}
