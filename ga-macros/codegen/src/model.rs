//! What a checked call means: a metric, named blades, and types as lists of slots.

use ga_core::{Metric, Product, Rational};
use proc_macro2::Ident;
use syn::{Attribute, Path, Visibility};

/// The highest dimension in which the types of every grade, `Even`, `Odd` and `Multivector` exist.
pub const COMPLETE_LIMIT: usize = 8;
/// The highest dimension in which types can be declared.
pub const DECLARED_LIMIT: usize = 12;
/// The largest number of blades of one type.
pub const FIELD_LIMIT: usize = 256;

/// A checked algebra.
pub struct Model {
    /// Where generated code finds ga-core.
    pub core: Path,
    /// Attributes of the module.
    pub attributes: Vec<Attribute>,
    /// Visibility of the module.
    pub visibility: Visibility,
    /// Name of the module.
    pub name: Ident,
    /// The signature `Rp_q_r`.
    pub signature: String,
    /// The metric with its basis names.
    pub metric: Metric,
    /// The declared types, then those that are always there.
    pub types: Vec<Type>,
    /// The products to generate.
    pub products: Vec<Product>,
    /// Whether versor application is generated.
    pub apply: bool,
}

/// A type: which coefficients it stores, in which order and orientation.
#[derive(Clone)]
pub struct Type {
    /// Attributes of the struct.
    pub attributes: Vec<Attribute>,
    /// Name of the struct.
    pub name: Ident,
    /// Whether its values are unit versors by declaration.
    pub unit: bool,
    /// Whether its values square to 0 by declaration.
    pub null: bool,
    /// Its coefficients in the order of declaration.
    pub slots: Vec<Slot>,
}

/// One coefficient of a type.
#[derive(Clone, PartialEq)]
pub struct Slot {
    /// The blade as a bitmask of basis vectors.
    pub mask: u32,
    /// −1 where the blade is spelled in an odd permutation of the basis order, `e31`.
    pub sign: i32,
    /// The name of the field, `e12`; `s` for the scalar.
    pub field: String,
    /// A value fixed at compile time, in the orientation as spelled.
    pub fixed: Option<Rational>,
}

impl Model {
    /// The number of basis vectors.
    pub fn dimension(&self) -> usize {
        self.metric.dimension()
    }

    /// The index of the type of this name.
    pub fn type_named(&self, name: &str) -> Option<usize> {
        self.types.iter().position(|t| t.name == name)
    }

    /// Whether the types `Even`, `Odd` and `Multivector` exist.
    pub fn is_complete(&self) -> bool {
        self.dimension() <= COMPLETE_LIMIT
    }
}

impl Type {
    /// The name as text.
    pub fn text(&self) -> String {
        self.name.to_string()
    }

    /// The coefficients that are stored, with their positions.
    pub fn fields(&self) -> impl Iterator<Item = &Slot> + Clone {
        self.slots.iter().filter(|slot| slot.fixed.is_none())
    }

    /// How many coefficients are stored.
    pub fn field_count(&self) -> usize {
        self.fields().count()
    }

    /// Whether any coefficient is fixed at compile time.
    pub fn has_fixed(&self) -> bool {
        self.slots.iter().any(|slot| slot.fixed.is_some())
    }

    /// Whether only some of the elements with its blades are values of the type, so that sums and
    /// multiples are of another one.
    pub fn is_constrained(&self) -> bool {
        self.null || self.has_fixed()
    }

    /// Whether any coefficient is fixed at a value that is no integer.
    pub fn has_fractions(&self) -> bool {
        self.slots
            .iter()
            .any(|slot| slot.fixed.is_some_and(|value| !value.is_integer()))
    }

    /// The slot of a blade.
    pub fn slot(&self, mask: u32) -> Option<&Slot> {
        self.slots.iter().find(|slot| slot.mask == mask)
    }

    /// The grades that occur, as a bit set.
    pub fn grades(&self) -> u32 {
        self.slots
            .iter()
            .fold(0, |set, slot| set | 1 << slot.mask.count_ones())
    }

    /// `Some(true)` if all blades are even, `Some(false)` if all are odd, `None` if mixed.
    pub fn parity(&self) -> Option<bool> {
        const EVEN: u32 = 0x5555_5555;
        match (self.grades() & EVEN, self.grades() & !EVEN) {
            (_, 0) => Some(true),
            (0, _) => Some(false),
            _ => None,
        }
    }
}

/// The name of the type of one grade in a preset.
pub fn grade_name(grade: usize) -> &'static str {
    const NAMES: [&str; 9] = [
        "Scalar",
        "Vector",
        "Bivector",
        "Trivector",
        "Quadvector",
        "Pentavector",
        "Hexavector",
        "Heptavector",
        "Octavector",
    ];
    NAMES[grade]
}
