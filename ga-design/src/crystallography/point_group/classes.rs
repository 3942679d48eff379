//! What the multiplication of a point group tells: products, inverses, orders, conjugacy classes,
//! hand, centre and crystal class.

use super::super::Isometry;
use super::PointGroup;
use super::table::CrystalClass;

/// What tells the crystallographic point groups apart: for each kind of transformation — its hand,
/// its order, whether it is the inversion — how many there are, sorted.
pub(super) type Census = Vec<((bool, usize, bool), usize)>;

impl PointGroup {
    /// The number of the transformation that is `second` after `first`; `None` only for numbers
    /// that are not below the order.
    pub fn product(&self, second: usize, first: usize) -> Option<usize> {
        let transformations = self.transformations();
        let product = transformations
            .get(second)?
            .after(transformations.get(first)?);
        self.position(&product)
    }

    /// The number of the transformation that undoes another.
    pub fn inverse(&self, number: usize) -> Option<usize> {
        self.position(&self.transformations().get(number)?.inverse())
    }

    /// How often a transformation must follow itself to move nothing: 1 for the identity.
    pub fn order_of(&self, number: usize) -> Option<usize> {
        let mut power = number;
        for order in 1..=self.order() {
            if power == 0 {
                return Some(order);
            }
            power = self.product(power, number)?;
        }
        None
    }

    /// The conjugacy classes as lists of numbers, each in increasing order, that of the identity
    /// first: `{g x g⁻¹}` for all `g` of the group.
    ///
    /// ```
    /// use ga_design::crystallography::PointGroup;
    ///
    /// let sizes: Vec<usize> = PointGroup::from_schoenflies("Td")?
    ///     .conjugacy_classes()
    ///     .iter()
    ///     .map(Vec::len)
    ///     .collect();
    /// assert_eq!(sizes.iter().sum::<usize>(), 24);
    /// assert_eq!(sizes.len(), 5);
    /// # Ok::<(), ga_design::crystallography::UnknownPointGroup>(())
    /// ```
    pub fn conjugacy_classes(&self) -> Vec<Vec<usize>> {
        let mut classes: Vec<Vec<usize>> = Vec::new();
        let mut classed = vec![false; self.order()];
        for number in 0..self.order() {
            if classed[number] {
                continue;
            }
            // Conjugation by the generators alone reaches the whole class.
            let mut class = vec![number];
            classed[number] = true;
            let mut next = 0;
            while let Some(member) = class.get(next).copied() {
                for (_, generator) in self.generators() {
                    let conjugate = self.transformations()[member].moved_by(generator);
                    if let Some(found) = self.position(&conjugate)
                        && !classed[found]
                    {
                        classed[found] = true;
                        class.push(found);
                    }
                }
                next += 1;
            }
            class.sort_unstable();
            classes.push(class);
        }
        classes
    }

    /// Whether all transformations are rotations, so that the group keeps a hand: the eleven
    /// enantiomorphic crystal classes and their like.
    pub fn is_chiral(&self) -> bool {
        self.transformations().iter().all(Isometry::is_proper)
    }

    /// Whether the inversion in the centre is among the transformations.
    pub fn is_centrosymmetric(&self) -> bool {
        self.position(&Isometry::inversion()).is_some()
    }

    /// The crystal class, one of the 32, that this group is, or `None` for one that no lattice
    /// has.
    pub fn crystal_class(&self) -> Option<&'static CrystalClass> {
        CrystalClass::with_census(&self.census())
    }

    /// How many transformations of each kind there are.
    pub(super) fn census(&self) -> Census {
        let inversion = self.position(&Isometry::inversion());
        let mut kinds: Vec<(bool, usize, bool)> = self
            .transformations()
            .iter()
            .enumerate()
            .map(|(number, isometry)| {
                let order = self.order_of(number).unwrap_or_default();
                (isometry.is_proper(), order, Some(number) == inversion)
            })
            .collect();
        kinds.sort_unstable();
        kinds
            .chunk_by(|one, other| one == other)
            .filter_map(|same| same.first().map(|kind| (*kind, same.len())))
            .collect()
    }
}
