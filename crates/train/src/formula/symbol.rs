//! Symbols of a formula and their meaning.

use super::subscript;
use crate::compound::CentralKind;
use crate::planet_set::{Description, GearOf};
use crate::{Gearbox, LinkId};
use epicyclic_gears::simple_set::Fraction;

/// The size of a basic ratio, `k = |i₀|`, of one equation of a set.
#[derive(Debug, Clone, PartialEq)]
pub struct Symbol {
    number: usize,
    set: usize,
    is_pair: bool,
    centrals: [usize; 2],
    links: [LinkId; 3],
    is_negative: bool,
    teeth: [Vec<GearOf>; 2],
    value: f64,
    exact: Option<Fraction>,
}

impl Symbol {
    /// Makes the symbol of an equation of a gearbox.
    pub(super) fn of(gearbox: &Gearbox, equation: usize) -> Self {
        let one = &gearbox.equations[equation];
        let set = &gearbox.sets[one.set];
        let (root, central) = (set.tree.root, one.central);
        let (mut above, mut below) = (vec![], vec![]);
        // Of (ω_root − ω_H)/(ω_central − ω_H), mesh by mesh from the root.
        for mesh in set.path(root, central) {
            let [near, far] = set.meshes()[mesh].gears;
            below.push(near);
            above.push(far);
        }
        above.retain(|gear| {
            let common = below.iter().position(|other| other == gear);
            if let Some(place) = common {
                below.remove(place);
            }
            common.is_none()
        });
        let [r, c, h] = one.links;
        let (size, exact) =
            (one.ratio.abs(), one.exact.map(|exact| if exact < 0.into() { -exact } else { exact }));
        // From the root: of a short description, whose root is its first gear, and from a sun to a ring, so
        // that k is z_ring/z_sun. Else a compound set's root is the ring that the other gears are related to.
        let kind = |place: usize| set.centrals()[place].kind;
        let from_root = matches!(set.description(), Description::Short(_))
            || (kind(root), kind(central)) == (CentralKind::Sun, CentralKind::Ring);
        Self {
            number: equation + 1,
            set: one.set,
            is_pair: set.is_pair(),
            centrals: if from_root { [root, central] } else { [central, root] },
            links: if from_root { [r, c, h] } else { [c, r, h] },
            is_negative: one.ratio < 0.0,
            teeth: if from_root { [above, below] } else { [below, above] },
            value: if from_root { size } else { 1.0 / size },
            exact: if from_root { exact } else { exact.map(|exact| exact.recip()) },
        }
    }

    /// `k₁`; of a pair on fixed axes `u₁`.
    #[must_use]
    pub fn name(&self) -> String {
        subscript(if self.is_pair { 'u' } else { 'k' }, self.number)
    }

    /// Place of the symbol's equation among those of the gearbox.
    #[must_use]
    pub fn equation(&self) -> usize {
        self.number - 1
    }

    /// Place of its set in the gearbox.
    #[must_use]
    pub fn set(&self) -> usize {
        self.set
    }

    /// Places in the set of the central gears 1 and 2 of `i₀ = (ω_1 − ω_H)/(ω_2 − ω_H)`.
    #[must_use]
    pub fn centrals(&self) -> [usize; 2] {
        self.centrals
    }

    /// Links of central gear 1, central gear 2 and the carrier.
    #[must_use]
    pub fn links(&self) -> [LinkId; 3] {
        self.links
    }

    /// Whether `i₀ = −k`; else `i₀ = +k`.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.is_negative
    }

    /// Gears whose teeth multiply `k`, and gears whose teeth divide it.
    #[must_use]
    pub fn teeth(&self) -> [&[GearOf]; 2] {
        let [above, below] = &self.teeth;
        [above, below]
    }

    /// Value of the symbol.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value
    }

    /// Value of the symbol as a fraction of tooth counts, if they are known.
    #[must_use]
    pub fn exact(&self) -> Option<Fraction> {
        self.exact
    }
}
