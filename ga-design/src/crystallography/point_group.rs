//! How a point group grows from its roots (Algorithm 3.1), and what is known of it: products,
//! inverses, orders of elements, classes, hand and centre.

mod classes;
mod generator;
mod symbol;
mod table;

pub use generator::Word;
pub use symbol::{Bars, PointSymbol, PointSymbolError};
pub use table::{CrystalClass, UnknownPointGroup};

use ga_cga::{Point, Vector3};

use super::lattice::reciprocal;
use super::roots::{Roots, RootsError};
use super::{Isometry, Movable};

/// Images of the seed that are nearer than this are one: those of different transformations are
/// at least some thousandths apart.
const SAME: f64 = 1e-6;

/// One instruction of the operation sequence (Algorithm 3.1): apply the generator to the result
/// of that number; its result is the next. Result 0 is the input itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    /// The generator; [`Word::kind`] and [`Word::index`] are its encoding {type, index}.
    pub word: Word,
    /// The number of the result that it is applied to.
    pub input: usize,
}

impl Step {
    /// The instruction as numbers, {type, index, input} of the algorithm.
    pub fn encoding(self) -> (u8, u8, usize) {
        (self.word.kind(), self.word.index(), self.input)
    }
}

/// A finite group of rotations and reflections about the origin, generated from roots.
///
/// ```
/// use ga_cga::{Circle, Point};
/// use ga_design::crystallography::PointGroup;
///
/// let icosahedral = PointGroup::from_geometric("b(5)b(3)")?;
/// assert_eq!(icosahedral.order(), 60);
/// // Every transformation is a versor and acts on any element, here on a circle.
/// let circle = Point::at(1.0, 0.2, 3.0) ^ Point::at(2.0, 0.0, 3.0) ^ Point::at(1.0, 1.0, 3.5);
/// let circles: Vec<Circle> = icosahedral.apply(circle);
/// assert_eq!(circles.len(), 60);
/// # Ok::<(), ga_design::crystallography::PointSymbolError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointGroup {
    symbol: PointSymbol,
    roots: Roots,
    generators: Vec<(Word, Isometry)>,
    sequence: Vec<Step>,
    transformations: Vec<Isometry>,
    /// A point that no transformation but the identity leaves in place.
    seed: Point,
    /// Where each transformation takes the seed.
    images: Vec<Vector3>,
}

impl PointGroup {
    /// The group that a geometric symbol stands for.
    ///
    /// # Errors
    /// None for a symbol that was made by [`PointSymbol::new`] or parsed.
    pub fn new(symbol: PointSymbol) -> Result<Self, RootsError> {
        let roots = symbol.roots()?;
        let vectors = roots.vectors();
        let generators: Vec<(Word, Isometry)> = symbol
            .generators()
            .iter()
            .filter_map(|word| Some((*word, word.isometry(&vectors)?)))
            .collect();
        let seed = Point::from(in_the_chamber(&roots));
        let mut group = Self {
            symbol,
            roots,
            generators,
            sequence: Vec::new(),
            transformations: vec![Isometry::identity()],
            seed,
            images: vec![seed.position()],
        };
        group.grow();
        Ok(group)
    }

    /// The group of a geometric symbol such as `43`, `b(4)2` or `b(22)`.
    ///
    /// # Errors
    /// [`PointSymbolError`] when the text is no symbol or its numbers have no roots.
    pub fn from_geometric(symbol: &str) -> Result<Self, PointSymbolError> {
        Ok(Self::new(symbol.parse()?)?)
    }

    /// The crystallographic group of an International (Hermann–Mauguin) symbol such as `-4 2 m`
    /// or `m-3m`.
    ///
    /// # Errors
    /// [`UnknownPointGroup`] with the nearest known symbols.
    pub fn from_international(symbol: &str) -> Result<Self, UnknownPointGroup> {
        CrystalClass::from_international(symbol).map(CrystalClass::group)
    }

    /// The crystallographic group of a Schoenflies symbol such as `D2d` or `O_h`.
    ///
    /// # Errors
    /// [`UnknownPointGroup`] with the nearest known symbols.
    pub fn from_schoenflies(symbol: &str) -> Result<Self, UnknownPointGroup> {
        CrystalClass::from_schoenflies(symbol).map(CrystalClass::group)
    }

    /// Algorithm 3.1: every generator on every result so far, as long as there are new ones.
    fn grow(&mut self) {
        let mut input = 0;
        while let Some(known) = self.transformations.get(input).copied() {
            for at in 0..self.generators.len() {
                let (word, generator) = self.generators[at];
                let next = generator.after(&known);
                let image = next.apply(self.seed).position();
                if self.at_image(image).is_none() {
                    self.sequence.push(Step { word, input });
                    self.transformations.push(next);
                    self.images.push(image);
                }
            }
            input += 1;
        }
    }

    /// The geometric symbol.
    pub fn symbol(&self) -> PointSymbol {
        self.symbol
    }

    /// The roots.
    pub fn roots(&self) -> &Roots {
        &self.roots
    }

    /// The number of transformations.
    pub fn order(&self) -> usize {
        self.transformations.len()
    }

    /// The generators (Table 3.2) with their versors.
    pub fn generators(&self) -> &[(Word, Isometry)] {
        &self.generators
    }

    /// The instructions that make all results from an input; one fewer than there are
    /// transformations, because the input is the first result.
    pub fn sequence(&self) -> &[Step] {
        &self.sequence
    }

    /// The full set of absolute transformations, the identity first, in the order of the sequence.
    pub fn transformations(&self) -> &[Isometry] {
        &self.transformations
    }

    /// The images of an element of any kind under all transformations, its own first.
    pub fn apply<X: Movable>(&self, element: X) -> Vec<X> {
        let images = self.transformations.iter().map(|t| t.apply(element));
        images.collect()
    }

    /// The same images, made one from another by the instructions of the sequence.
    pub fn apply_sequence<X: Movable>(&self, element: X) -> Vec<X> {
        let mut results = vec![element];
        for step in &self.sequence {
            let generator = self.generators.iter().find(|(word, _)| *word == step.word);
            let input = results.get(step.input).copied();
            if let (Some((_, generator)), Some(input)) = (generator, input) {
                results.push(generator.apply(input));
            }
        }
        results
    }

    /// The number of a transformation in the group, or `None` if it is not of the group.
    pub fn position(&self, isometry: &Isometry) -> Option<usize> {
        let found = self.at_image(isometry.apply(self.seed).position())?;
        let same = self.transformations.get(found)?.is_same(isometry, SAME);
        same.then_some(found)
    }

    fn at_image(&self, image: Vector3) -> Option<usize> {
        self.images
            .iter()
            .position(|known| (*known - image).norm() < SAME)
    }
}

/// A unit vector inside the region that the mirrors of the roots bound, which no transformation
/// but the identity maps to itself: on the positive side of **a** and **c** and, since angles
/// between the walls' outer normals are obtuse, on the negative one of **b**.
fn in_the_chamber(roots: &Roots) -> Vector3 {
    // Unequal distances, so that no symmetry of the region itself leaves it in place either.
    let (from_a, from_b, from_c) = (1.0, 1.1, 1.2);
    let [a, b, c] = roots.vectors();
    let inside = match reciprocal([a, b, c]) {
        Some([to_a, to_b, to_c]) => to_a * from_a - to_b * from_b + to_c * from_c,
        // With p = 1 or q = 1 there are two mirrors, at right angles, and e₂ lies in both.
        None => a * from_a + c * from_c + Vector3::new(0.0, from_b, 0.0),
    };
    inside.normalized().unwrap_or(a)
}
