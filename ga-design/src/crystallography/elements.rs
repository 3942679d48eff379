//! Which chemical elements there are, how they are named in files, how large and of which colour
//! they are drawn.
//!
//! The table is `data/elements.tsv`. Covalent radii: B. Cordero et al., *Dalton Trans.* (2008)
//! 2832–2838 (up to curium; carbon sp³, manganese, iron and cobalt low spin). Masses: IUPAC
//! standard atomic weights 2016 (of the longest-lived isotope where there is none). Colours: the
//! scheme of the program Jmol, which extends the CPK colours.

use std::sync::LazyLock;

const TABLE: &str = include_str!("../../data/elements.tsv");

/// The radius of elements that have no measured one, in ångström.
const UNMEASURED_RADIUS: f64 = 1.50;

/// A chemical element, or the unknown one (`X`, number 0).
///
/// ```
/// use ga_design::crystallography::Element;
///
/// assert_eq!(Element::from_type_symbol("Si4+").map(|e| e.symbol()), Some("Si"));
/// assert_eq!(Element::from_label("O12A").map(|e| e.symbol()), Some("O"));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Element(u8);

/// Words for what is drawn or refined like an atom and is none: dummies, vacancies, centroids,
/// unassigned peaks.
fn is_no_atom(letters: &str) -> bool {
    let words = ["du", "dum", "dummy", "vac", "cg", "cent", "cnt", "unk", "q"];
    words.iter().any(|word| letters.eq_ignore_ascii_case(word))
}

struct Row {
    symbol: &'static str,
    name: &'static str,
    mass: f64,
    radius: Option<f64>,
    colour: [u8; 3],
}

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| TABLE.lines().filter_map(row).collect());

const UNKNOWN: Row = Row {
    symbol: "X",
    name: "unknown",
    mass: 0.0,
    radius: None,
    colour: [0xff, 0x14, 0x93],
};

impl Element {
    /// The element that stands for what cannot be named.
    pub const UNKNOWN: Self = Self(0);

    /// The element with an atomic number from 1 to 118.
    pub fn from_number(number: u8) -> Option<Self> {
        (1..=118).contains(&number).then_some(Self(number))
    }

    /// The element with exactly this symbol, case aside; `D` and `T` are hydrogen.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        if matches!(symbol, "D" | "T" | "d" | "t") {
            return Some(Self(1));
        }
        let at = ROWS
            .iter()
            .position(|row| row.symbol.eq_ignore_ascii_case(symbol))?;
        u8::try_from(at + 1).ok().map(Self)
    }

    /// The element of a type symbol such as `Si4+`, `O2-`, `CA`, `Fe(III)`: the longest symbol of
    /// one or two letters at its beginning that is followed by no further small letter.
    ///
    /// The scattering factors `Cval` and `Siva` of valence states count as their elements, `Wat` as
    /// the oxygen of water.
    pub fn from_type_symbol(text: &str) -> Option<Self> {
        let text = text.trim();
        let letters: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
        match letters.as_str() {
            water if water.starts_with("Wat") => return Self::from_symbol("O"),
            "Cval" => return Self::from_symbol("C"),
            "Siva" | "Sival" => return Self::from_symbol("Si"),
            _ if is_no_atom(&letters) => return None,
            _ => {}
        }
        let next_is_small = |at: usize| {
            letters
                .chars()
                .nth(at)
                .is_some_and(|c| c.is_ascii_lowercase())
        };
        let two = letters
            .get(..2)
            .filter(|_| !next_is_small(2))
            .and_then(Self::from_symbol);
        two.or_else(|| {
            letters
                .get(..1)
                .filter(|_| !next_is_small(1))
                .and_then(Self::from_symbol)
        })
    }

    /// The element at the beginning of an atom label such as `Si1`, `O12A`, `CL2`, `H_a`.
    ///
    /// A label begins with the symbol of its element; what follows is free. Habits of mineralogists
    /// are known: `Oh` and `Ow` are the oxygens of hydroxyl and water, `Wat` and `H2O` are water,
    /// shown as its oxygen, and `T` is a tetrahedral site of unnamed element.
    pub fn from_label(label: &str) -> Option<Self> {
        Self::from_label_among(label, &[])
    }

    /// As [`Element::from_label`], where it is known which elements the substance has: `OII` is
    /// oxygen and `Pda1` palladium in a formula that has them, and `HO1` is hydrogen rather than
    /// holmium.
    ///
    /// ```
    /// use ga_design::crystallography::Element;
    ///
    /// let known = ["H", "O", "Pd"].map(|symbol| Element::from_symbol(symbol).unwrap_or_default());
    /// let found = |label| Element::from_label_among(label, &known).map(Element::symbol);
    /// assert_eq!(found("HO1"), Some("H"));
    /// assert_eq!(found("Pda1"), Some("Pd"));
    /// assert_eq!(found("Fe1"), Some("Fe"));
    /// ```
    pub fn from_label_among(label: &str, known: &[Self]) -> Option<Self> {
        let label = label.trim();
        let letters: String = label
            .chars()
            .take_while(char::is_ascii_alphabetic)
            .collect();
        if letters == "T" || is_no_atom(&letters) {
            return None;
        }
        let is_water = letters.starts_with("Wat") || label.starts_with("H2O");
        if is_water || letters == "Oh" || letters == "Ow" {
            return Self::from_symbol("O");
        }
        let heads = [letters.get(..2), letters.get(..1)];
        let mut heads = heads.into_iter().flatten().filter_map(Self::from_symbol);
        heads
            .find(|element| known.contains(element))
            .or_else(|| Self::from_type_symbol(label))
    }

    /// The atomic number; 0 for [`Element::UNKNOWN`].
    pub fn number(self) -> u8 {
        self.0
    }

    /// The symbol, such as `Si`; `X` for [`Element::UNKNOWN`].
    pub fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// The English name, such as `Silicon`.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The atomic weight in daltons; 0 for [`Element::UNKNOWN`].
    pub fn mass(self) -> f64 {
        self.row().mass
    }

    /// The covalent radius in ångström; 1.5 where none is published.
    pub fn covalent_radius(self) -> f64 {
        self.row().radius.unwrap_or(UNMEASURED_RADIUS)
    }

    /// The colour to draw it in: red, green, blue from 0 to 255 (sRGB).
    pub fn colour(self) -> [u8; 3] {
        self.row().colour
    }

    fn row(self) -> &'static Row {
        let at = usize::from(self.0).checked_sub(1);
        at.and_then(|at| ROWS.get(at)).unwrap_or(&UNKNOWN)
    }
}

/// A row of the table; `None` for its heading.
fn row(line: &'static str) -> Option<Row> {
    let mut fields = line.split('\t');
    let _number: u8 = fields.next()?.parse().ok()?;
    let symbol = fields.next()?;
    let name = fields.next()?;
    let mass = fields.next()?.parse().ok()?;
    let radius = fields.next()?.parse().ok();
    let colour = u32::from_str_radix(fields.next()?.strip_prefix('#')?, 16).ok()?;
    let [_, red, green, blue] = colour.to_be_bytes();
    Some(Row {
        symbol,
        name,
        mass,
        radius,
        colour: [red, green, blue],
    })
}
