//! The three involutions, one table row each: a sign that depends on the grade alone.

/// A sign change by grade that undoes itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Involution {
    /// The order of all vector factors reversed (2.22).
    Reverse,
    /// Every vector factor negated (2.23).
    Involute,
    /// Both at once (2.24).
    Conjugate,
}

/// Everything that distinguishes an involution from the others.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The involution.
    pub involution: Involution,
    /// The name of the method.
    pub method: &'static str,
    /// The name of the trait that holds the method.
    pub trait_name: &'static str,
    /// Its meaning in one sentence.
    pub doc: &'static str,
    /// The signs of grades 0, 1, 2, 3, which repeat with period four.
    pub signs: [i32; 4],
}

/// The involutions, each at the position of its variant. The exponents of (2.22) and (2.24)
/// are halved against the print: k(k−1)/2 and k(k+1)/2.
pub const TABLE: [Row; 3] = [
    Row {
        involution: Involution::Reverse,
        method: "reverse",
        trait_name: "Reverse",
        doc: "The reverse: all vector factors in opposite order, sign (−1)^{k(k−1)/2} on grade k.",
        signs: [1, 1, -1, -1],
    },
    Row {
        involution: Involution::Involute,
        method: "involute",
        trait_name: "Involute",
        doc: "The grade involution: all vectors negated, sign (−1)^k on grade k.",
        signs: [1, -1, 1, -1],
    },
    Row {
        involution: Involution::Conjugate,
        method: "conjugate",
        trait_name: "Conjugate",
        doc: "The Clifford conjugate: reverse and involution at once, sign (−1)^{k(k+1)/2} on grade k.",
        signs: [1, -1, -1, 1],
    },
];

impl Involution {
    /// Every involution, in the order of the table.
    pub const ALL: [Involution; TABLE.len()] = {
        let mut all = [Involution::Reverse; TABLE.len()];
        let mut index = 0;
        while index < TABLE.len() {
            all[index] = TABLE[index].involution;
            assert!(all[index] as usize == index, "the table is out of order");
            index += 1;
        }
        all
    };

    /// The row of the table.
    pub const fn row(self) -> &'static Row {
        const ROWS: &[Row; TABLE.len()] = &TABLE;
        &ROWS[self as usize]
    }

    /// The factor, 1 or −1, on blades of this grade.
    ///
    /// ```
    /// use ga_core::Involution;
    ///
    /// assert_eq!(Involution::Reverse.sign(2), -1);
    /// assert_eq!(Involution::Conjugate.sign(3), 1);
    /// ```
    pub const fn sign(self, grade: u32) -> i32 {
        self.row().signs[(grade % 4) as usize]
    }

    /// The name of the method, such as `reverse`.
    pub const fn method(self) -> &'static str {
        self.row().method
    }

    /// The name of the trait, such as `Reverse`.
    pub const fn trait_name(self) -> &'static str {
        self.row().trait_name
    }

    /// The meaning in one sentence.
    pub const fn doc(self) -> &'static str {
        self.row().doc
    }
}
