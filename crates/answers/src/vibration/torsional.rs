//! The torsional model of the whole gearbox in a gear: links as inertias, all sets on them, shafts as springs.
//!
//! What turns as one piece in the gear is one inertia: links that ties and engaged shift elements join, but not by a tie that the file gives as a
//! shaft. A member that is held stands alone: rigidly, or on its tangential support.

use super::records::{
    NotCalculated, Reason, StrainPart, TorsionalKinetic, TorsionalMode, TorsionalModes, TorsionalStrain, What,
};
use super::{Of, Prepared, joined, number};
use crate::Error;
use crate::gearbox::Subject;
use crate::strength::place::refused;
use crate::tolerance::rounded;
use epicyclic_formats::gearbox::{GearboxFile, ShaftEntry, VibrationOfGearbox};
use epicyclic_formats::{Path, Physical};
use epicyclic_train::{Gear, LinkId, PlanetSet};
use epicyclic_vibration::train::{Link, Placed, Shaft, TrainParts, torsional};
use epicyclic_vibration::{BodyId, Group, Model, PlanetarySet, SpringId};
use uom::si::f64::{MomentOfInertia, Torque};

/// What a file says of the torsional model.
pub(super) struct Train<'a> {
    subject: &'a Subject<'a>,
    file: Option<&'a VibrationOfGearbox>,
    /// Places of the links of each shaft.
    shafts: Vec<(&'a ShaftEntry, [LinkId; 2])>,
}

/// A set of the train.
pub(super) struct TrainSet<'a> {
    pub(super) of: Of<'a>,
    pub(super) set: &'a PlanetSet,
    pub(super) prepared: Prepared,
}

/// Links of the model with the names of those of the gearbox in each.
#[derive(Default)]
struct Bodies {
    links: Vec<Link>,
    names: Vec<Vec<String>>,
    /// Places by the root of what turns as one piece.
    of_root: Vec<(usize, usize)>,
}

impl<'a> Train<'a> {
    /// Checks shafts and inertias of links.
    pub(super) fn new(subject: &'a Subject<'a>, file: &'a GearboxFile) -> Result<Self, Error> {
        let gearbox = &subject.gearbox;
        let at = |keys: &[&str], index: Option<usize>, message: String| {
            let path = keys.iter().fold(Path::root().key("vibration"), |path, key| path.key(*key));
            let path = index.map_or(path.clone(), |index| path.index(index));
            refused(subject.document, &path, &[], &message)
        };
        let link = |name: &str, index: Option<usize>, keys: &[&str]| {
            gearbox.link(name).filter(|link| *link != LinkId::GROUND).ok_or_else(|| {
                let all: Vec<&str> = gearbox.link_ids().skip(1).map(|link| gearbox.link_name(link)).collect();
                at(keys, index, format!("no link is called `{name}`: there are {}", all.join(", ")))
            })
        };
        let entry = file.vibration.as_ref();
        let mut shafts = vec![];
        for (index, shaft) in entry.into_iter().flat_map(|entry| &entry.shafts).enumerate() {
            let mut ends = [LinkId::GROUND; 2];
            for (end, name) in ends.iter_mut().zip(&shaft.between) {
                *end = link(name, Some(index), &["shafts"])?;
            }
            let is_tied = gearbox.permanent().iter().any(|tie| is_same(*tie, ends));
            if !is_tied {
                let [first, second] = &shaft.between;
                let message = format!("shaft `{}`: `ties` do not join `{first}` and `{second}`", shaft.id);
                return Err(at(&["shafts"], Some(index), message));
            }
            if shaft.stiffness.0.si() <= 0.0 {
                let message = format!("shaft `{}`: its stiffness must be above 0", shaft.id);
                return Err(at(&["shafts"], Some(index), message));
            }
            shafts.push((shaft, ends));
        }
        for (name, inertia) in entry.into_iter().flat_map(|entry| &entry.link_inertias) {
            link(name, None, &["link_inertias"])?;
            if inertia.0.si() < 0.0 {
                let message = format!("the inertia of `{name}` must not be below 0");
                return Err(at(&["link_inertias", name], None, message));
            }
        }
        Ok(Self { subject, file: entry, shafts })
    }

    /// The torsional modes in a gear, or which set lacks what.
    pub(super) fn modes(
        &self,
        gear: &Gear,
        sets: &[TrainSet<'_>],
    ) -> Result<Result<TorsionalModes, NotCalculated>, Error> {
        let gearbox = &self.subject.gearbox;
        let ends: Vec<[LinkId; 2]> = self.shafts.iter().map(|(_, ends)| *ends).collect();
        let roots = joined(gearbox, Some(gear), &ends);
        let housing = LinkId::GROUND.index();
        let mut bodies = Bodies::default();
        let mut built: Vec<(PlanetarySet, [usize; 3])> = vec![];
        for one in sets {
            let links = [0, 1, 2].map(|member| one.set.members()[member]);
            let held = links.map(|link| roots[link.index()] == housing);
            let set = match one.prepared.torsional(held) {
                Ok(set) => set,
                Err(missing) => {
                    return Ok(Err(NotCalculated {
                        set: one.of.entry.id.clone(),
                        gear: Some(gear.name().to_owned()),
                        what: What::Torsional,
                        reason: Reason::KeysMissing,
                        missing,
                    }));
                }
            };
            let mut places = [0; 3];
            for (member, place) in places.iter_mut().enumerate() {
                *place = if held[member] {
                    bodies.alone(&one.of.entry.id, member, one.prepared.support(member))
                } else {
                    bodies.joined(roots[links[member].index()], gearbox, &roots)
                };
            }
            built.push((set, places));
        }
        let mut shafts = vec![];
        for (shaft, ends) in &self.shafts {
            let places = ends.map(|end| (end, roots[end.index()]));
            if places.iter().any(|(_, root)| *root == housing) {
                // A shaft between a link and one that is held.
                let support = Torque::from_si(shaft.stiffness.0.si());
                if let Some((_, root)) = places.iter().find(|(_, root)| *root != housing) {
                    let place = bodies.joined(*root, gearbox, &roots);
                    bodies.links[place].support += support;
                }
                continue;
            }
            shafts.push(Shaft {
                name: shaft.id.clone(),
                links: places.map(|(_, root)| bodies.joined(root, gearbox, &roots)),
                stiffness: Torque::from_si(shaft.stiffness.0.si()),
            });
        }
        for (name, inertia) in self.file.into_iter().flat_map(|file| &file.link_inertias) {
            let Some(link) = gearbox.link(name).filter(|link| roots[link.index()] != housing) else {
                continue;
            };
            let place = bodies.joined(roots[link.index()], gearbox, &roots);
            bodies.links[place].inertia += inertia.0;
        }
        let placed: Vec<Placed<'_>> = sets
            .iter()
            .zip(&built)
            .map(|(one, (set, links))| Placed { name: format!("{} ", one.of.entry.id), set, links: *links })
            .collect();
        let refuse = |error: epicyclic_vibration::Error| {
            refused(
                self.subject.document,
                &Path::root(),
                &["vibration"],
                &format!("gear {}: {error}", gear.name()),
            )
        };
        let (model, parts) = torsional(&bodies.links, &placed, &shafts).map_err(refuse)?;
        let groups = model.groups(&parts.links).map_err(refuse)?;
        let modes: Result<Vec<TorsionalMode>, _> = groups
            .iter()
            .enumerate()
            .map(|(index, group)| mode(index, group, &model, &parts, &bodies, sets, &shafts))
            .collect();
        let modes = modes.map_err(refuse)?;
        Ok(Ok(TorsionalModes {
            gear: gear.name().to_owned(),
            freedoms: groups
                .iter()
                .filter(|group| group.is_zero())
                .map(|group| group.multiplicity() as u32)
                .sum(),
            modes,
        }))
    }
}

/// Whether two ties join the same links.
pub(super) fn is_same(one: [LinkId; 2], other: [LinkId; 2]) -> bool {
    one == other || one == [other[1], other[0]]
}

impl Bodies {
    /// The place of what turns as one piece.
    fn joined(&mut self, root: usize, gearbox: &epicyclic_train::Gearbox, roots: &[usize]) -> usize {
        if let Some((_, place)) = self.of_root.iter().find(|(own, _)| *own == root) {
            return *place;
        }
        let own = gearbox.link_ids().filter(|link| roots[link.index()] == root);
        let names: Vec<String> = own.map(|link| gearbox.link_name(link).to_owned()).collect();
        self.of_root.push((root, self.links.len()));
        self.add(names, Torque::default(), false)
    }

    /// The place of a member that is held, on its support or rigidly.
    fn alone(&mut self, set: &str, member: usize, support: Option<Torque>) -> usize {
        let name = ["sun", "ring", "carrier"][member];
        self.add(vec![format!("{name} of {set}")], support.unwrap_or_default(), support.is_none())
    }

    fn add(&mut self, names: Vec<String>, support: Torque, held: bool) -> usize {
        let inertia = MomentOfInertia::default();
        self.links.push(Link { name: names.join("+"), inertia, support, held });
        self.names.push(names);
        self.links.len() - 1
    }
}

fn mode(
    index: usize,
    group: &Group,
    model: &Model,
    parts: &TrainParts,
    bodies: &Bodies,
    sets: &[TrainSet<'_>],
    shafts: &[Shaft],
) -> Result<TorsionalMode, epicyclic_vibration::Error> {
    let energy = model.modal_energy(group)?;
    let of_body = |body: &BodyId| {
        let own = energy.kinetic.iter().filter(|share| share.body == *body);
        own.map(|share| share.rotation).sum::<f64>()
    };
    let of_springs = |springs: &[SpringId]| {
        let own = energy.strain.iter().filter(|share| springs.contains(&share.spring));
        rounded(own.map(|share| share.share).sum())
    };
    let links = parts.links.iter().zip(&bodies.names).zip(&bodies.links).filter(|(_, link)| !link.held);
    let mut kinetic: Vec<TorsionalKinetic> = links
        .map(|((body, names), _)| TorsionalKinetic {
            links: names.clone(),
            planets_of: None,
            share: rounded(of_body(body)),
        })
        .collect();
    kinetic.extend(parts.planets.iter().zip(sets).map(|(planets, set)| TorsionalKinetic {
        links: vec![],
        planets_of: Some(set.of.entry.id.clone()),
        share: rounded(planets.iter().map(of_body).sum()),
    }));
    let mut strain: Vec<TorsionalStrain> = vec![];
    if !group.is_zero() {
        let mut add = |part, of: String, springs: &[SpringId]| {
            strain.push(TorsionalStrain { part, of, share: of_springs(springs) });
        };
        for (place, set) in sets.iter().enumerate() {
            add(StrainPart::SunMeshes, set.of.entry.id.clone(), &parts.sun_meshes[place]);
            add(StrainPart::RingMeshes, set.of.entry.id.clone(), &parts.ring_meshes[place]);
        }
        for (shaft, spring) in shafts.iter().zip(&parts.shafts) {
            add(StrainPart::Shaft, shaft.name.clone(), &[*spring]);
        }
        for (link, springs) in bodies.links.iter().zip(&parts.supports).filter(|(_, own)| !own.is_empty()) {
            add(StrainPart::Support, link.name.clone(), springs);
        }
    }
    Ok(TorsionalMode {
        mode: number(index),
        multiplicity: group.multiplicity() as u32,
        frequency_hz: group.frequency.si(),
        kinetic,
        strain,
    })
}
