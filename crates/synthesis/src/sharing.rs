//! Sets that share planets: halves of one compound set, such as a Ravigneaux set.
//!
//! Two sets with one carrier link and a common sun link or ring link can share gears. They have this sun or
//! ring as one gear, and the planet in mesh with it as one planet. The mesh of the two then exists once.
//!
//! ```text
//! planets    simple set  p          double-planet set  g (with the sun), f (with the ring)
//! a ring in common    p = f    f₁ = f₂        a sun in common    p = g    g₁ = g₂
//! ```
//!
//! Two simple sets would give one planet two centre distances: it would need steps. So would three gears;
//! such sets keep planets of their own.
//!
//! # Room
//! With common gears of equal teeth the `k` give the proportions of all central gears, and
//! `z_p = (z_b − z_a)/2` the planet of a simple set. This planet has to leave room for the rest: it would run
//! into the sun of a double-planet set with the same ring unless that sun is the smaller one. The conditions
//! are those of [`epicyclic_gears::double_planet`], with the largest ring at [`MOST_TEETH`], three planets of
//! each kind and no planet below [`LEAST_TEETH`]. A set that does not fit there fits with no smaller ring.
//! Profile shift, and whether all teeth are whole numbers, are left to the tooth numbers.

use crate::names::{real_k, solver_name};
use crate::set_teeth::SetTeeth;
use crate::structure::{Link, Members, Structure};
use epicyclic_gears::ToothCount;
use epicyclic_gears::double_planet::{DoublePlanetNumbers, Pair};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::plain::DoublePlanetMeshes;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_train::compound::{CentralKind, CompoundSpec, PlanetSpec};
use std::ops::RangeInclusive;

/// Teeth of the largest ring of sets that share planets, while teeth are not chosen.
pub const MOST_TEETH: u32 = 200;

/// The fewest teeth of a planet, while teeth are not chosen.
pub const LEAST_TEETH: u32 = 12;

/// Planets of each kind, while teeth are not chosen.
const PLANETS: u32 = 3;

/// Sets of a structure that share planets.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sharing {
    /// The compound sets, by the first of their sets.
    pub compounds: Vec<Compound>,
    /// Pairs of sets that have a carrier and a sun or ring in common, but planets of their own.
    pub apart: Vec<Apart>,
}

/// Sets that share planets.
#[derive(Debug, Clone, PartialEq)]
pub struct Compound {
    /// The places of the sets, ascending.
    pub sets: Vec<usize>,
    /// Members of each of these sets: sun, ring, carrier.
    members: Vec<Members>,
    /// Planets of each of these sets from the sun to the ring, by their numbers in the compound set.
    planets: Vec<Vec<usize>>,
}

/// Two sets with a carrier and a sun or ring in common, and planets of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Apart {
    /// The places of the sets.
    pub sets: [usize; 2],
    /// Obstacle to a common planet.
    pub why: Obstacle,
}

/// Reason why two sets share no planet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "WhyApart"))]
pub enum Obstacle {
    /// The common planet would need steps: the sets would give it two centre distances.
    Steps,
    /// The common planet leaves no room for other gears.
    Room,
}

/// The end of a set at which its planet is shared: its sun or its ring.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Sun,
    Ring,
}

impl Sharing {
    /// The sets of a structure that share planets at these ring-to-sun ratios, of double-planet sets `k′`.
    /// Pairs of sets are joined in their order, where planets allow it.
    #[must_use]
    pub fn of(structure: &Structure, k: &[f64]) -> Self {
        let sets = structure.sets().len();
        let mut compounds: Vec<Compound> = (0..sets).map(|set| Compound::of_set(structure, set)).collect();
        let mut apart = Vec::new();
        for second in 0..sets {
            for first in 0..second {
                let Some(end) = common(structure.members(first), structure.members(second)) else { continue };
                let of = |set: usize| compounds.iter().position(|one| one.sets.contains(&set));
                let (Some(one), Some(other)) = (of(first), of(second)) else { continue };
                if one == other {
                    continue;
                }
                let joined = compounds[one].joined(&compounds[other], [first, second], end);
                match joined.fault(structure, k) {
                    None => {
                        compounds[one] = joined;
                        compounds.remove(other);
                    }
                    Some(why) => apart.push(Apart { sets: [first, second], why }),
                }
            }
        }
        compounds.retain(|compound| compound.sets.len() > 1);
        compounds.sort_by_key(|compound| compound.sets[0]);
        Self { compounds, apart }
    }

    /// The compound set that a set is part of.
    #[must_use]
    pub fn compound_of(&self, set: usize) -> Option<&Compound> {
        self.compounds.iter().find(|compound| compound.sets.contains(&set))
    }
}

/// Common member of two sets on one carrier: sun or ring.
fn common(one: Members, other: Members) -> Option<End> {
    let [sun, ring, carrier] = [0, 1, 2].map(|place| one[place] == other[place]);
    match (carrier, sun, ring) {
        (true, true, _) => Some(End::Sun),
        (true, _, true) => Some(End::Ring),
        _ => None,
    }
}

impl Compound {
    fn of_set(structure: &Structure, set: usize) -> Self {
        let planets = if structure.is_double_planet(set) { vec![0, 1] } else { vec![0] };
        Self { sets: vec![set], members: vec![structure.members(set)], planets: vec![planets] }
    }

    /// The compound of two with the planets of these sets at one end as one.
    fn joined(&self, other: &Self, [first, second]: [usize; 2], end: End) -> Self {
        let count = self.planet_count();
        let mut all: Vec<(usize, Members, Vec<usize>)> = Vec::new();
        for (of, from) in [(self, 0), (other, count)] {
            for ((set, members), planets) in of.sets.iter().zip(&of.members).zip(&of.planets) {
                all.push((*set, *members, planets.iter().map(|planet| planet + from).collect()));
            }
        }
        let planet_of = |set: usize| {
            let (.., planets) = all.iter().find(|(place, ..)| *place == set)?;
            match end {
                End::Sun => planets.first().copied(),
                End::Ring => planets.last().copied(),
            }
        };
        if let (Some(kept), Some(gone)) = (planet_of(first), planet_of(second)) {
            for planet in all.iter_mut().flat_map(|(.., planets)| planets) {
                *planet = match *planet {
                    same if same == gone => kept,
                    later if later > gone => later - 1,
                    earlier => earlier,
                };
            }
        }
        all.sort_by_key(|(set, ..)| *set);
        let (mut sets, mut members, mut planets) = (vec![], vec![], vec![]);
        for (set, of, own) in all {
            sets.push(set);
            members.push(of);
            planets.push(own);
        }
        Self { sets, members, planets }
    }

    fn planet_count(&self) -> usize {
        self.planets.iter().flatten().max().map_or(0, |most| most + 1)
    }

    /// Reason why the sets cannot share planets at these `k`.
    fn fault(&self, structure: &Structure, k: &[f64]) -> Option<Obstacle> {
        let is_simple = |own: &&Vec<usize>| own.len() == 1;
        let mut simple: Vec<usize> = self.planets.iter().filter(is_simple).flatten().copied().collect();
        simple.sort_unstable();
        if simple.windows(2).any(|pair| pair[0] == pair[1]) {
            return Some(Obstacle::Steps);
        }
        let gears = self.proportions(&|set| real_k(structure, set, k[set]));
        let largest = gears.iter().map(|[_, ring]| *ring).fold(0.0, f64::max);
        let scale = f64::from(MOST_TEETH) / largest;
        let gears: Vec<[f64; 2]> = gears.iter().map(|of| of.map(|teeth| scale * teeth)).collect();
        let bounds = Bounds { planet: LEAST_TEETH..=MOST_TEETH, ..Bounds::default() };
        self.fill(&gears, PLANETS, &bounds, &mut |_| true).is_none().then_some(Obstacle::Room)
    }

    /// Teeth of sun and ring of each set in proportion, the first sun's 1.
    fn proportions(&self, k: &dyn Fn(usize) -> f64) -> Vec<[f64; 2]> {
        let mut known: Vec<Option<[f64; 2]>> = vec![None; self.sets.len()];
        known[0] = Some([1.0, k(self.sets[0])]);
        for _ in 1..self.sets.len() {
            for place in 0..self.sets.len() {
                let k = k(self.sets[place]);
                let of = |other: usize| {
                    let [sun, ring] = known[other]?;
                    Some(match common(self.members[place], self.members[other])? {
                        End::Sun => [sun, sun * k],
                        End::Ring => [ring / k, ring],
                    })
                };
                known[place] = known[place].or_else(|| (0..known.len()).find_map(of));
            }
        }
        known.into_iter().map(Option::unwrap_or_default).collect()
    }

    /// Teeth of all planets with which this number of each, at equal angles, fits suns and rings with these
    /// teeth. Those of simple sets follow from equal centre distances. The others are as large as gears that
    /// can turn allow, the earlier ones preferred.
    fn fill(
        &self,
        gears: &[[f64; 2]],
        pairs: u32,
        bounds: &Bounds,
        do_turn: &mut dyn FnMut(&[f64]) -> bool,
    ) -> Option<Vec<f64>> {
        let mut teeth: Vec<Option<f64>> = vec![None; self.planet_count()];
        for (own, [sun, ring]) in self.planets.iter().zip(gears) {
            if let [planet] = own[..] {
                teeth[planet] = Some((ring - sun) / 2.0);
            }
        }
        self.fill_from(&mut teeth, gears, pairs, bounds, do_turn)
            .then(|| teeth.into_iter().flatten().collect())
    }

    fn fill_from(
        &self,
        teeth: &mut [Option<f64>],
        gears: &[[f64; 2]],
        pairs: u32,
        bounds: &Bounds,
        do_turn: &mut dyn FnMut(&[f64]) -> bool,
    ) -> bool {
        let fits = |own: &[usize], [sun, ring]: [f64; 2]| {
            let [inner, outer] = own else { return true };
            let (Some(inner), Some(outer)) = (teeth[*inner], teeth[*outer]) else { return true };
            Pair::of([sun, inner, outer, ring], &bounds.rack)
                .is_some_and(|pair| pair.fits([sun, ring], pairs, &bounds.rack, bounds.tip_gap))
        };
        if !self.planets.iter().zip(gears).all(|(own, gears)| fits(own, *gears)) {
            return false;
        }
        let Some(next) = teeth.iter().position(Option::is_none) else {
            let all: Vec<f64> = teeth.iter().copied().flatten().collect();
            return do_turn(&all);
        };
        // Planets of a double-planet set have fewer teeth than half the difference of its ring and sun.
        let most = self.planets.iter().zip(gears).filter(|(own, _)| own.contains(&next));
        let most = most.map(|(_, [sun, ring])| (ring - sun) / 2.0).fold(f64::INFINITY, f64::min);
        let most = (most as u32).min(*bounds.planet.end());
        for count in (*bounds.planet.start()..=most).rev() {
            teeth[next] = Some(f64::from(count));
            if self.fill_from(teeth, gears, pairs, bounds, do_turn) {
                return true;
            }
        }
        teeth[next] = None;
        false
    }

    /// Whether the chosen of some sets, the first ones of a structure, have equal teeth where they have a
    /// gear in common.
    pub(crate) fn agree(&self, chosen: &[&SetTeeth]) -> bool {
        let known = || self.sets.iter().enumerate().filter(|(_, set)| **set < chosen.len());
        known().all(|(place, set)| {
            known().all(|(other_place, other)| match common(self.members[place], self.members[other_place]) {
                // Sets that touch through a third have a gear in common, too: a link is one gear.
                Some(End::Sun) => chosen[*set].sun() == chosen[*other].sun(),
                Some(End::Ring) => chosen[*set].ring() == chosen[*other].ring(),
                None => true,
            })
        })
    }

    /// The teeth of its sets, in their order, with common planets for these suns and rings: as many of each
    /// planet as there is room for, and such whose teeth can be cut and turned together.
    pub(crate) fn with_planets(&self, chosen: &[&SetTeeth], bounds: &Bounds) -> Option<Vec<SetTeeth>> {
        let of: Vec<&SetTeeth> = self.sets.iter().map(|set| chosen[*set]).collect();
        let gears: Vec<[f64; 2]> = of.iter().map(|set| [set.sun().as_f64(), set.ring().as_f64()]).collect();
        let is_even = |set: &&SetTeeth| match set {
            // Compound sets have no profile shift.
            SetTeeth::Simple(of) => of.ring_offset() == 0,
            SetTeeth::DoublePlanet(_) => true,
        };
        if !of.iter().all(is_even) {
            return None;
        }
        let most = |set: &&SetTeeth| match set {
            SetTeeth::Simple(of) => of.planets,
            SetTeeth::DoublePlanet(of) => of.pairs,
        };
        // A common planet may leave fewer pairs room than the planets of a set's own, never more.
        let most = of.iter().map(most).min()?;
        let mut meshes = DoublePlanetMeshes::new(&bounds.rack);
        let count: RangeInclusive<u32> = *bounds.planets.start()..=most.min(*bounds.planets.end());
        count.rev().find_map(|count| {
            let assembles = |set: &&SetTeeth| {
                let (sun, ring) = (set.sun().get(), set.ring().get());
                let teeth = if set.is_double_planet() { ring.abs_diff(sun) } else { ring + sun };
                teeth.is_multiple_of(count)
            };
            if !of.iter().all(assembles) {
                return None;
            }
            let planet = |planets: &[f64], number: usize| ToothCount::new(planets[number] as u32).ok();
            let set = |planets: &[f64], own: &[usize], set: &SetTeeth| match (own, set) {
                ([_], SetTeeth::Simple(of)) => {
                    Some(SetTeeth::Simple(epicyclic_gears::synthesis::ToothNumbers { planets: count, ..*of }))
                }
                ([inner, outer], SetTeeth::DoublePlanet(of)) => {
                    let (inner, outer) = (planet(planets, *inner)?, planet(planets, *outer)?);
                    Some(SetTeeth::DoublePlanet(DoublePlanetNumbers { inner, outer, pairs: count, ..*of }))
                }
                _ => None,
            };
            let sets = |planets: &[f64]| -> Option<Vec<SetTeeth>> {
                self.planets.iter().zip(&of).map(|(own, of)| set(planets, own, of)).collect()
            };
            // Simple sets are chosen from those that turn.
            let mut does_turn = |set: &SetTeeth| match set {
                SetTeeth::Simple(_) => true,
                SetTeeth::DoublePlanet(of) => {
                    meshes.miss([of.sun, of.inner, of.outer, of.ring]).is_ok_and(|miss| miss.is_none())
                }
            };
            let mut do_turn =
                |planets: &[f64]| sets(planets).is_some_and(|sets| sets.iter().all(&mut does_turn));
            sets(&self.fill(&gears, count, bounds, &mut do_turn)?)
        })
    }

    /// The carrier's link.
    #[must_use]
    pub fn carrier(&self) -> Link {
        self.members[0][2]
    }

    /// Suns or rings that several of its sets have in common.
    #[must_use]
    pub fn common(&self, kind: CentralKind) -> Vec<Link> {
        let place = usize::from(kind == CentralKind::Ring);
        let mut links: Vec<Link> = self.members.iter().map(|members| members[place]).collect();
        links.sort_unstable();
        let mut common: Vec<Link> =
            links.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
        common.dedup();
        common
    }

    /// Name of the compound set in a gearbox of the solver: the numbers of its sets, `2+3`.
    #[must_use]
    pub fn name(&self) -> String {
        let numbers: Vec<String> = self.sets.iter().map(|set| (set + 1).to_string()).collect();
        numbers.join("+")
    }

    /// Names of the planets: `long` for those that several sets have, `short` for the others, with numbers if
    /// there are several.
    fn names(&self) -> Vec<String> {
        let is_shared = |planet: usize| self.planets.iter().filter(|own| own.contains(&planet)).count() > 1;
        let count = self.planet_count();
        let name = |planet: usize| {
            let alike: Vec<usize> =
                (0..count).filter(|other| is_shared(*other) == is_shared(planet)).collect();
            let word = if is_shared(planet) { "long" } else { "short" };
            match alike.iter().position(|other| *other == planet) {
                Some(place) if alike.len() > 1 => format!("{word}{}", place + 1),
                _ => word.to_owned(),
            }
        };
        (0..count).map(name).collect()
    }

    /// The compound set of the solver at these `k`, of double-planet sets `k′`, each of its meshes with this
    /// efficiency.
    #[must_use]
    pub(crate) fn spec(&self, structure: &Structure, k: &[f64], each: MeshEfficiency) -> CompoundSpec {
        let gears = self.proportions(&|set| real_k(structure, set, k[set]));
        let mut spec = CompoundSpec::new(&self.name(), &solver_name(self.carrier())).proportional();
        let names = self.names();
        for name in &names {
            spec = spec.planet(name, &[]);
        }
        for ((members, teeth), own) in self.members.iter().zip(gears).zip(&self.planets) {
            let [sun, ring] = [members[0], members[1]].map(solver_name);
            let kinds = [(CentralKind::Sun, &sun), (CentralKind::Ring, &ring)];
            for ((kind, link), teeth) in kinds.into_iter().zip(teeth) {
                if !spec.centrals.iter().any(|one| one.kind == kind && one.link == **link) {
                    spec = spec.central(kind, link, teeth);
                }
            }
            let between = own.iter().map(|planet| &names[*planet]);
            let chain: Vec<&String> = [&sun].into_iter().chain(between).chain([&ring]).collect();
            for pair in chain.windows(2) {
                let is_known = |mesh: &epicyclic_train::compound::MeshSpec| {
                    mesh.between.iter().all(|gear| pair.contains(&gear))
                };
                if !spec.meshes.iter().any(is_known) {
                    spec = spec.mesh(pair[0], pair[1], each);
                }
            }
        }
        spec
    }

    /// The compound set of the solver with the teeth of these sets, of all of the structure, in place of
    /// proportions.
    #[must_use]
    pub fn put_into(&self, spec: CompoundSpec, teeth: &[SetTeeth]) -> CompoundSpec {
        let mut spec = CompoundSpec { proportional: false, ..spec };
        let mut planets: Vec<u32> = vec![0; self.planet_count()];
        for ((members, own), set) in self.members.iter().zip(&self.planets).zip(&self.sets) {
            let of = &teeth[*set];
            let [sun, ring] = [members[0], members[1]].map(solver_name);
            for central in &mut spec.centrals {
                match central.kind {
                    CentralKind::Sun if central.link == sun => central.teeth = of.sun().as_f64(),
                    CentralKind::Ring if central.link == ring => central.teeth = of.ring().as_f64(),
                    _ => {}
                }
            }
            match (own.as_slice(), of) {
                ([planet], SetTeeth::Simple(of)) => {
                    planets[*planet] = of.planet.get();
                    spec.planet_count = Some(of.planets);
                }
                ([inner, outer], SetTeeth::DoublePlanet(of)) => {
                    (planets[*inner], planets[*outer]) = (of.inner.get(), of.outer.get());
                    spec.planet_count = Some(of.pairs);
                }
                _ => {}
            }
        }
        let names = self.names().into_iter().zip(planets);
        spec.planets = names.map(|(name, teeth)| PlanetSpec { name, teeth: vec![teeth] }).collect();
        spec
    }
}
