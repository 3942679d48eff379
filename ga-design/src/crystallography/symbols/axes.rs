//! Which setting the unique axis and the choice of cell stand for, as written after the number of a
//! monoclinic group: `14:b2`.

use super::SpaceGroup;

impl SpaceGroup {
    /// The setting of a monoclinic group with this unique axis and choice of cell (*International
    /// Tables* A, 2.1.3.15): `b`, or `b1`, `b2`, `b3`, `c1` …, and `-b1` … for the other orientation of
    /// the axes, where the group has one. Without a cell the first is meant.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// let symbol = |axes| SpaceGroup::with_axes(14, axes).map(|group| group.symbol);
    /// assert_eq!(symbol("b2"), Some("P 1 21/n 1"));
    /// assert_eq!(symbol("c"), Some("P 1 1 21/a"));
    /// assert_eq!(symbol("b4"), None);
    /// ```
    pub fn with_axes(number: u32, axes: &str) -> Option<&'static Self> {
        let folded = axes.trim().to_ascii_lowercase();
        let turned = folded.strip_prefix('-');
        let mut rest = turned.unwrap_or(&folded).chars();
        let place = match rest.next()? {
            'a' => 1,
            'b' => 2,
            'c' => 3,
            _ => return None,
        };
        let cell = match (rest.next(), rest.next()) {
            (None, None) => 0,
            (Some(digit @ '1'..='3'), None) => digit.to_digit(10)? as usize - 1,
            _ => return None,
        };
        // With cells to choose from there are three; where an axis can be turned, three more.
        let (cells, can_turn) = match number {
            3 | 4 | 6 | 10 | 11 => (1, false),
            5 | 7 | 8 | 12 | 13 | 14 => (3, false),
            9 | 15 => (3, true),
            _ => return None,
        };
        if cell >= cells || (turned.is_some() && !can_turn) {
            return None;
        }
        let along = Self::table().iter().filter(|group| {
            let words: Vec<&str> = group.symbol.split(' ').collect();
            group.number == number && words.get(place).is_some_and(|word| *word != "1")
        });
        // The table has them in the order of International Tables, before all others.
        along.into_iter().nth(match turned {
            Some(_) => cells + cell,
            None => cell,
        })
    }
}
