//! What stands next in a symbol: the characters that count, each with its column.

/// A symbol being read from left to right.
pub struct SymbolReader {
    rest: Vec<(usize, char)>,
    at: usize,
}

impl SymbolReader {
    /// Begins at the first character that counts; columns are those of the whole text, from 1.
    pub fn new(text: &str, counts: impl Fn(char) -> bool) -> Self {
        let columns = (1..).zip(text.chars());
        Self {
            rest: columns.filter(|(_, c)| counts(*c)).collect(),
            at: 0,
        }
    }

    /// The next character with its column.
    pub fn peek(&self) -> Option<(usize, char)> {
        self.rest.get(self.at).copied()
    }

    /// Passes over the next character if it is wanted, and whether it is.
    pub fn take(&mut self, wanted: impl Fn(char) -> bool) -> bool {
        self.next_of(|c| wanted(c).then_some(())).is_some()
    }

    /// What the next character means, which is passed over if it means something.
    pub fn next_of<T>(&mut self, meaning: impl Fn(char) -> Option<T>) -> Option<T> {
        let found = self.peek().and_then(|(_, c)| meaning(c));
        self.at += usize::from(found.is_some());
        found
    }

    /// The number that the next digits write, if there are any; the largest there is where they write
    /// a larger one, which nobody accepts.
    pub fn digits(&mut self) -> Option<u32> {
        let mut value: Option<u32> = None;
        while let Some(digit) = self.next_of(|c| c.to_digit(10)) {
            let sum = value.unwrap_or(0).saturating_mul(10).saturating_add(digit);
            value = Some(sum);
        }
        value
    }
}
