//! Sets of a solution with a common carrier and a common sun or ring.

use epicyclic_synthesis::Structure;
use epicyclic_synthesis::sharing::{Apart, Compound, Obstacle, Sharing};
use epicyclic_synthesis::structure::link_name;
use epicyclic_train::compound::CentralKind;
use schemars::JsonSchema;
use serde::Serialize;

/// Sets with a common carrier and a common sun or ring: a compound set, or sets with their own planets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SharedPlanets {
    /// Numbers of the sets, from 1.
    pub sets: Vec<usize>,
    /// Link of the common carrier.
    pub carrier: char,
    /// Links of suns that several of the sets have in common; in a compound set each is one gear.
    pub common_suns: Vec<char>,
    /// Links of rings that several of the sets have in common.
    pub common_rings: Vec<char>,
    /// Reason why the sets have their own planets and are rated separately; null for a compound set, which is
    /// rated as one.
    pub apart: Option<Obstacle>,
}

impl SharedPlanets {
    /// Lists such sets of a structure, compound sets first.
    pub(super) fn all(structure: &Structure, sharing: &Sharing) -> Vec<Self> {
        let compounds = sharing.compounds.iter().map(Self::of_compound);
        compounds.chain(sharing.apart.iter().map(|apart| Self::of_apart(structure, *apart))).collect()
    }

    fn of_compound(compound: &Compound) -> Self {
        let common = |kind| compound.common(kind).into_iter().map(link_name).collect();
        Self {
            sets: compound.sets.iter().map(|set| set + 1).collect(),
            carrier: link_name(compound.carrier()),
            common_suns: common(CentralKind::Sun),
            common_rings: common(CentralKind::Ring),
            apart: None,
        }
    }

    fn of_apart(structure: &Structure, apart: Apart) -> Self {
        let [one, other] = apart.sets.map(|set| structure.members(set));
        let common = |place: usize| {
            if one[place] == other[place] { vec![link_name(one[place])] } else { vec![] }
        };
        Self {
            sets: apart.sets.map(|set| set + 1).into(),
            carrier: link_name(one[2]),
            common_suns: common(0),
            common_rings: common(1),
            apart: Some(apart.why),
        }
    }
}
