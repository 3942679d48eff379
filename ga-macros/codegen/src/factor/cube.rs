//! Products of named values as the optimiser sees them: a few numbers in order.

/// The number of a variable, a constant or an intermediate value, from 1 to [`LARGEST`].
pub type Name = u16;

/// The largest number that has room in a product.
pub const LARGEST: Name = (1 << BITS) - 1;

/// How many bits a number has: six of them are a product, the four variables of a monomial and a
/// constant.
const BITS: u32 = 10;

/// A product of named values: their numbers in descending order from the lowest bits on, then
/// zeros.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Cube(u64);

impl Cube {
    /// The empty product.
    pub const ONE: Cube = Cube(0);

    /// One value.
    pub fn of(name: Name) -> Cube {
        Cube(u64::from(name))
    }

    /// The product with one more value.
    pub fn with(self, name: Name) -> Cube {
        let name = u64::from(name);
        let mut place = 0;
        while self.0 >> place & u64::from(LARGEST) > name {
            place += BITS;
        }
        let low = self.0 & ((1 << place) - 1);
        let high = self.0 >> place;
        Cube(low | name << place | high << (place + BITS))
    }

    /// The values in order.
    pub fn names(self) -> impl Iterator<Item = Name> {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            let name = rest as Name & LARGEST;
            rest >>= BITS;
            (name != 0).then_some(name)
        })
    }

    /// The number of values.
    pub fn degree(self) -> usize {
        (u64::BITS - self.0.leading_zeros()).div_ceil(BITS) as usize
    }

    /// The product of two products.
    pub fn times(self, other: Cube) -> Cube {
        other.names().fold(self, Cube::with)
    }

    /// What is left of two products without the factors that both have, and these.
    pub fn apart(self, other: Cube) -> [Cube; 3] {
        let (mut a, mut b) = (self.0, other.0);
        let mut parts = [0; 3];
        let mut places = [0; 3];
        while a | b != 0 {
            let mask = u64::from(LARGEST);
            let (x, y) = (a & mask, b & mask);
            let part = match x.cmp(&y) {
                std::cmp::Ordering::Greater => 0,
                std::cmp::Ordering::Less => 1,
                std::cmp::Ordering::Equal => 2,
            };
            parts[part] |= x.max(y) << places[part];
            places[part] += BITS;
            if part != 1 {
                a >>= BITS;
            }
            if part != 0 {
                b >>= BITS;
            }
        }
        parts.map(Cube)
    }

    /// The product without factors that it has.
    pub fn over(self, divisor: Cube) -> Cube {
        self.apart(divisor)[0]
    }

    /// How often a value occurs.
    pub fn power(self, name: Name) -> usize {
        self.names().filter(|known| *known == name).count()
    }
}

/// A product with its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// The factors.
    pub cube: Cube,
    /// Whether it is subtracted.
    pub negative: bool,
}

/// A sum of different products.
pub type Sum = Vec<Term>;
