//! Planar model of all sets of a gearbox in a gear, on common links and centres.
//!
//! Members that are permanently connected, or that name one link, are also one piece in the plane: one centre
//! with their total mass and support. If one of them has no `support`, the centre is held. Members on the
//! housing, members joined by a clutch, and the two ends of a shaft have their own centres; a shaft joins
//! them by its lateral stiffness.

use super::assembly::Case;
use super::links::{LaidShaft, Train, TrainSet};
use super::records::{NotCalculated, Reason, What};
use super::train_records::{
    CentreBody, CentreMember, CoupledKinetic, CoupledMode, CoupledModes, KineticPart, SetInMode, StrainPart,
    TorsionalStrain,
};
use super::{Prepared, joined, number};
use crate::error::Error;
use crate::tolerance::rounded;
use epicyclic_train::{Gear, LinkId};
use epicyclic_units::Physical;
use epicyclic_vibration::Kind;
use epicyclic_vibration::coupled::{Centre, CoupledParts, Placed, Shaft, planar};
use epicyclic_vibration::{BodyId, Group, ModalEnergy, Model, SpringId};
use uom::si::f64::Mass;

/// Modes of the whole gearbox in the plane in a gear, or the set that lacks data.
pub(super) fn modes(
    train: &Train<'_>,
    gear: &Gear,
    sets: &[TrainSet<'_>],
) -> Result<Result<CoupledModes, NotCalculated>, Error> {
    let is_round = |one: &TrainSet<'_>| one.prepared.planets > 2 && one.prepared.is_equally_spaced();
    // One set without rotational symmetry is allowed among symmetric ones, because its angle to them does not
    // matter.
    if let Some(one) = sets.iter().filter(|one| !is_round(one)).nth(1) {
        return Ok(Err(NotCalculated {
            set: one.of.set.id().to_owned(),
            gear: None,
            what: What::Coupled,
            reason: Reason::NoSymmetry,
            missing: vec![],
        }));
    }
    let built = |prepared: &Prepared, case: &Case| prepared.built(case).map(|built| built.set);
    let laid = match train.laid(gear, sets, What::Coupled, built)? {
        Ok(laid) => laid,
        Err(missing) => return Ok(Err(missing)),
    };
    let mut centres = Centres::of(train, sets);
    let shafts: Vec<Shaft> = laid.shafts.iter().map(|shaft| centres.shaft(shaft)).collect();
    let placed = std::iter::zip(sets, laid.sets).zip(&centres.of_sets);
    let placed: Vec<Placed> = placed
        .map(|((one, (set, links)), centres)| Placed {
            name: format!("{} ", one.of.set.id()),
            set,
            links,
            centres: centres.clone(),
        })
        .collect();
    let refuse = |error| train.refused(gear, &error);
    let (model, parts) = planar(&laid.bodies.links, &centres.centres, &placed, &shafts).map_err(refuse)?;
    let groups = model.groups(&parts.central()).map_err(refuse)?;
    let whole = Whole {
        model: &model,
        parts: &parts,
        sets,
        places: &placed,
        names: &laid.bodies.names,
        links: &laid.bodies.links,
        centres: &centres,
        shafts: &shafts,
    };
    let modes: Result<Vec<CoupledMode>, _> =
        groups.iter().enumerate().map(|(index, group)| whole.mode(index, group)).collect();
    let zeros = groups.iter().filter(|group| group.is_zero());
    Ok(Ok(CoupledModes {
        gear: gear.name().to_owned(),
        freedoms: zeros.map(|group| group.multiplicity() as u32).sum(),
        centres: centres.told(&placed),
        modes: modes.map_err(refuse)?,
    }))
}

/// Bodies that move in the plane as one piece.
struct Centres {
    centres: Vec<Centre>,
    /// Members of each centre: places of the set and of the member.
    members: Vec<Vec<(usize, usize)>>,
    ids: Vec<String>,
    /// Names of the members of each set.
    names: Vec<Vec<String>>,
    /// Centres of the members of each set.
    of_sets: Vec<Vec<usize>>,
    /// Representative of each link, by [`LinkId::index`]: the first of the links that move with it.
    roots: Vec<usize>,
    /// Centre of each representative.
    of_root: Vec<(usize, usize)>,
}

impl Centres {
    fn of(train: &Train<'_>, sets: &[TrainSet<'_>]) -> Self {
        let mut all = Self {
            centres: vec![],
            members: vec![],
            ids: sets.iter().map(|one| one.of.set.id().to_owned()).collect(),
            names: sets
                .iter()
                .map(|one| one.prepared.members.iter().map(|member| member.name.clone()).collect())
                .collect(),
            of_sets: vec![vec![]; sets.len()],
            roots: joined(&train.subject.train, None, &train.springs()),
            of_root: vec![],
        };
        for (set, one) in sets.iter().enumerate() {
            for (member, own) in one.prepared.members.iter().enumerate() {
                let root = all.roots[one.of.set.members()[member].index()];
                let place = match all.of_root.iter().find(|(own, _)| *own == root) {
                    Some((_, place)) => *place,
                    None => all.add(Some(root).filter(|root| *root != LinkId::GROUND.index())),
                };
                all.members[place].push((set, member));
                all.centres[place].held |= own.support.is_none();
                all.of_sets[set].push(place);
            }
        }
        for place in 0..all.centres.len() {
            all.centres[place].name = all.names_of(place).join("+");
        }
        all
    }

    /// Names of the members of a centre.
    fn names_of(&self, place: usize) -> Vec<String> {
        let members = self.members[place].iter();
        members.map(|(set, member)| format!("{} of {}", self.names[*set][*member], self.ids[*set])).collect()
    }

    fn add(&mut self, root: Option<usize>) -> usize {
        let place = self.centres.len();
        self.centres.push(Centre { name: String::new(), mass: Mass::default(), held: false });
        self.members.push(vec![]);
        self.of_root.extend(root.map(|root| (root, place)));
        place
    }

    /// Shaft between two centres; an end without a member of a set is at rest.
    fn shaft(&mut self, shaft: &LaidShaft<'_>) -> Shaft {
        let lateral = shaft.entry.lateral_stiffness.map(|stiffness| stiffness.0);
        let centres = lateral.map(|stiffness| {
            let ends = shaft.ends.map(|end| {
                let root = self.roots[end.index()];
                match self.of_root.iter().find(|(own, _)| *own == root) {
                    Some((_, place)) => *place,
                    None => {
                        let place = self.add(Some(root));
                        self.centres[place].held = true;
                        place
                    }
                }
            });
            (ends, stiffness.into())
        });
        Shaft { name: shaft.entry.id.clone(), links: shaft.between, centres }
    }

    fn told(&self, placed: &[Placed]) -> Vec<CentreBody> {
        let own = self.centres.iter().zip(&self.members).filter(|(_, members)| !members.is_empty());
        own.map(|(centre, members)| {
            let central = |(set, member): &(usize, usize)| &placed[*set].set.members[*member].central;
            let sum = |of: fn(&epicyclic_vibration::Central) -> f64| {
                (!centre.held).then(|| members.iter().map(|one| of(central(one))).sum())
            };
            CentreBody {
                members: members
                    .iter()
                    .map(|(set, member)| CentreMember {
                        set: self.ids[*set].clone(),
                        member: self.names[*set][*member].clone(),
                    })
                    .collect(),
                mass_kg: sum(|central| central.body.mass.si()),
                support_n_m: sum(|central| central.support.radial.value),
            }
        })
        .collect()
    }
}

/// Model with the names of its parts.
struct Whole<'a> {
    model: &'a Model,
    parts: &'a CoupledParts,
    sets: &'a [TrainSet<'a>],
    places: &'a [Placed],
    names: &'a [Vec<String>],
    links: &'a [epicyclic_vibration::train::Link],
    centres: &'a Centres,
    shafts: &'a [Shaft],
}

impl Whole<'_> {
    fn mode(&self, index: usize, group: &Group) -> Result<CoupledMode, epicyclic_vibration::Error> {
        let energy = self.model.modal_energy(group)?;
        let parts = self.parts;
        let sets = self.places.iter().enumerate().map(|(place, placed)| {
            let sum = |bodies: &[BodyId]| bodies.iter().map(|body| energy.kinetic_of(*body)).sum::<f64>();
            let planets = rounded(sum(&parts.sets[place].planets));
            let once = |all: &[usize], of: &[BodyId]| {
                let mut all = all.to_vec();
                all.sort_unstable();
                let apart = all.iter().enumerate().filter(|(at, one)| *at == 0 || all[at - 1] != **one);
                rounded(apart.map(|(_, one)| energy.kinetic_of(of[*one])).sum())
            };
            let (turns, moves) = (once(&placed.links, &parts.links), once(&placed.centres, &parts.centres));
            let kind = match (moves > 0.0, turns > 0.0) {
                (false, true) => Some(Kind::Rotational),
                (true, false) => Some(Kind::Translational),
                (true, true) => Some(Kind::Mixed),
                (false, false) => (planets > 0.0).then_some(Kind::Planet),
            };
            SetInMode { set: self.sets[place].of.set.id().to_owned(), kind }
        });
        Ok(CoupledMode {
            mode: number(index),
            kind: group.kind,
            multiplicity: group.multiplicity() as u32,
            frequency_hz: group.frequency.si(),
            sets: sets.collect(),
            kinetic: self.kinetic(&energy),
            strain: if group.is_zero() { vec![] } else { self.strain(&energy) },
        })
    }

    fn kinetic(&self, energy: &ModalEnergy) -> Vec<CoupledKinetic> {
        let mut all = vec![];
        let mut add = |part, of: Vec<String>, share: f64| {
            all.push(CoupledKinetic { part, of, share: rounded(share) });
        };
        for (place, body) in self.parts.links.iter().enumerate().filter(|(place, _)| !self.links[*place].held)
        {
            add(KineticPart::Rotation, self.names[place].clone(), energy.kinetic_of(*body));
        }
        for (place, (centre, body)) in self.centres.centres.iter().zip(&self.parts.centres).enumerate() {
            if !centre.held {
                add(KineticPart::Translation, self.centres.names_of(place), energy.kinetic_of(*body));
            }
        }
        let with_planets = self.sets.iter().zip(&self.parts.sets).filter(|(_, own)| !own.planets.is_empty());
        for (set, own) in with_planets {
            let share = own.planets.iter().map(|planet| energy.kinetic_of(*planet)).sum();
            add(KineticPart::Planets, vec![set.of.set.id().to_owned()], share);
        }
        all
    }

    fn strain(&self, energy: &ModalEnergy) -> Vec<TorsionalStrain> {
        let mut all = vec![];
        let parts = self.parts;
        let share = |springs: &[SpringId]| rounded(energy.strain_of(springs));
        let one = |part, of: &str, springs: &[SpringId]| {
            let of = of.to_owned();
            (!springs.is_empty()).then(|| TorsionalStrain { part, of, mesh: None, share: share(springs) })
        };
        for (set, own) in self.sets.iter().zip(&parts.sets) {
            all.extend(TorsionalStrain::of_meshes(set, &own.meshes, share));
            all.extend(one(StrainPart::PlanetBearings, set.of.set.id(), &own.bearings.concat()));
        }
        let mut add = |part, of: &str, springs: &[SpringId]| all.extend(one(part, of, springs));
        for (shaft, [torsion, bending]) in self.shafts.iter().zip(&parts.shafts) {
            add(StrainPart::Shaft, &shaft.name, torsion);
            add(StrainPart::Bending, &shaft.name, bending);
        }
        for (link, springs) in self.links.iter().zip(&parts.link_supports) {
            add(StrainPart::Support, &link.name, springs);
        }
        for (centre, springs) in self.centres.centres.iter().zip(&parts.centre_supports) {
            add(StrainPart::CentreSupport, &centre.name, springs);
        }
        all
    }
}
