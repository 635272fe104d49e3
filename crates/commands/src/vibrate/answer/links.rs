//! Links of a gearbox in a gear: the bodies that turn as one piece, with the sets and shafts on them.
//!
//! Links that turn as one piece in the gear are one inertia: those joined by permanent connections or engaged
//! shift elements. A connection that the file gives as a shaft does not join them. A member that is held is a
//! separate body: held rigidly, or on its tangential support.

use super::assembly::Case;
use super::records::{NotCalculated, Reason, What};
use super::{Of, Prepared, joined};
use crate::error::Error;
use crate::shared::fault::{Named, in_usual_units, refused};
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, ShaftEntry, VibrationOfGearbox};
use epicyclic_train::{Gear, LinkId};
use epicyclic_units::Physical;
use epicyclic_vibration::GearSet;
use epicyclic_vibration::train::Link;
use uom::si::f64::{MomentOfInertia, Torque};

/// Data of a file for the whole gearbox.
pub(super) struct Train<'a> {
    pub(super) subject: &'a Gearbox,
    file: Option<&'a VibrationOfGearbox>,
    /// Links at the ends of each shaft.
    shafts: Vec<(&'a ShaftEntry, [LinkId; 2])>,
}

/// Set of the train.
pub(super) struct TrainSet<'a> {
    pub(super) of: Of<'a>,
    /// Place of the set in the gearbox.
    pub(super) place: usize,
    pub(super) prepared: Prepared,
}

impl<'a> Train<'a> {
    /// Checks shafts and inertias of links.
    pub(super) fn new(subject: &'a Gearbox, file: &'a GearboxFile) -> Result<Self, Error> {
        let gearbox = &subject.train;
        let at = |name, keys: &[&str], index: Option<usize>, message: String| {
            let path = keys.iter().fold(Path::root().key("vibration"), |path, key| path.key(*key));
            let path = index.map_or(path.clone(), |index| path.index(index));
            refused(&subject.document, &path, &[], &Named(name, message))
        };
        let link = |name: &str, index: Option<usize>, keys: &[&str]| {
            gearbox.link(name).filter(|link| *link != LinkId::GROUND).ok_or_else(|| {
                let all: Vec<&str> = gearbox.link_ids().skip(1).map(|link| gearbox.link_name(link)).collect();
                at(
                    "no-link",
                    keys,
                    index,
                    format!("no link is called `{name}`: there are {}", all.join(", ")),
                )
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
                return Err(at("no-tie", &["shafts"], Some(index), message));
            }
            if shaft.stiffness.0.si() <= 0.0 {
                let message = format!("shaft `{}`: its stiffness must be above 0", shaft.id);
                return Err(at("not-positive", &["shafts"], Some(index), message));
            }
            if shaft.lateral_stiffness.is_some_and(|stiffness| stiffness.0.si() < 0.0) {
                let message = format!("shaft `{}`: its lateral stiffness must not be below 0", shaft.id);
                return Err(at("negative", &["shafts"], Some(index), message));
            }
            shafts.push((shaft, ends));
        }
        for (name, inertia) in entry.into_iter().flat_map(|entry| &entry.link_inertias) {
            link(name, None, &["link_inertias"])?;
            if inertia.0.si() < 0.0 {
                let message = format!("the inertia of `{name}` must not be below 0");
                return Err(at("negative", &["link_inertias", name], None, message));
            }
        }
        Ok(Self { subject, file: entry, shafts })
    }

    /// Links, sets and shafts in a gear, each set with its held members; or the set that lacks data.
    pub(super) fn laid<'s>(
        &'s self,
        gear: &Gear,
        sets: &[TrainSet<'_>],
        what: What,
        built: impl Fn(&Prepared, &Case) -> Result<GearSet, Vec<String>>,
    ) -> Result<Result<Laid<'s>, NotCalculated>, Error> {
        let gearbox = &self.subject.train;
        let roots = joined(gearbox, Some(gear), &self.springs());
        let housing = LinkId::GROUND.index();
        let mut laid = Laid { bodies: Bodies::default(), sets: vec![], shafts: vec![], roots: vec![] };
        let bodies = &mut laid.bodies;
        for one in sets {
            let links = one.of.set.members();
            let held: Vec<bool> = links.iter().map(|link| roots[link.index()] == housing).collect();
            let forward = one.of.flanks(one.place, &one.prepared, Some(gear.name()))?.forward;
            let case = Case { held, forward };
            let set = match built(&one.prepared, &case) {
                Ok(set) => set,
                Err(missing) => {
                    return Ok(Err(NotCalculated {
                        set: one.of.set.id().to_owned(),
                        gear: Some(gear.name().to_owned()),
                        what,
                        reason: Reason::KeysMissing,
                        missing,
                    }));
                }
            };
            let members = one.prepared.members.iter().enumerate();
            let places = members.map(|(member, own)| {
                if case.held[member] {
                    bodies.alone(one.of.set.id(), &own.name, one.prepared.support(member))
                } else {
                    bodies.joined(roots[links[member].index()], gearbox, &roots)
                }
            });
            laid.sets.push((set, places.collect()));
        }
        for (shaft, ends) in &self.shafts {
            let stiffness = Torque::from_si(shaft.stiffness.0.si());
            let places = ends.map(|end| roots[end.index()]);
            let between = if places.contains(&housing) {
                // A shaft between a link and a held one acts as a support of that link.
                if let Some(root) = places.into_iter().find(|root| *root != housing) {
                    let place = bodies.joined(root, gearbox, &roots);
                    bodies.links[place].support += stiffness;
                }
                None
            } else {
                Some((places.map(|root| bodies.joined(root, gearbox, &roots)), stiffness))
            };
            laid.shafts.push(LaidShaft { entry: shaft, ends: *ends, between });
        }
        for (name, inertia) in self.file.into_iter().flat_map(|file| &file.link_inertias) {
            let Some(link) = gearbox.link(name).filter(|link| roots[link.index()] != housing) else {
                continue;
            };
            let place = bodies.joined(roots[link.index()], gearbox, &roots);
            bodies.links[place].inertia += inertia.0;
        }
        laid.roots = roots;
        Ok(Ok(laid))
    }

    /// Connections that are springs.
    pub(super) fn springs(&self) -> Vec<[LinkId; 2]> {
        self.shafts.iter().map(|(_, ends)| *ends).collect()
    }

    /// Error of the model in a gear.
    pub(super) fn refused(&self, gear: &Gear, error: &epicyclic_vibration::Error) -> Error {
        let message = format!("gear {}: {}", gear.name(), in_usual_units(error));
        refused(&self.subject.document, &Path::root(), &["vibration"], &Named(error.name(), message))
    }
}

/// Gearbox in a gear.
pub(super) struct Laid<'a> {
    pub(super) bodies: Bodies,
    /// Sets with the places of their members among the bodies.
    pub(super) sets: Vec<(GearSet, Vec<usize>)>,
    /// Shafts in the order of the file.
    pub(super) shafts: Vec<LaidShaft<'a>>,
    /// The representative of the body that each link is part of.
    pub(super) roots: Vec<usize>,
}

/// Shaft in a gear.
pub(super) struct LaidShaft<'a> {
    pub(super) entry: &'a ShaftEntry,
    pub(super) ends: [LinkId; 2],
    /// Places of the bodies with the torsional stiffness; `None` if one end is held.
    pub(super) between: Option<([usize; 2], Torque)>,
}

/// Links of the model, with the names of the gearbox's links in each.
#[derive(Default)]
pub(super) struct Bodies {
    pub(super) links: Vec<Link>,
    pub(super) names: Vec<Vec<String>>,
    /// Places of the bodies by the representative of their links.
    pub(super) of_root: Vec<(usize, usize)>,
}

/// Whether two connections join the same links.
pub(super) fn is_same(one: [LinkId; 2], other: [LinkId; 2]) -> bool {
    one == other || one == [other[1], other[0]]
}

impl Bodies {
    /// Place of the body that consists of the links with this representative.
    fn joined(&mut self, root: usize, gearbox: &epicyclic_train::Gearbox, roots: &[usize]) -> usize {
        if let Some((_, place)) = self.of_root.iter().find(|(own, _)| *own == root) {
            return *place;
        }
        let own = gearbox.link_ids().filter(|link| roots[link.index()] == root);
        let names: Vec<String> = own.map(|link| gearbox.link_name(link).to_owned()).collect();
        self.of_root.push((root, self.links.len()));
        self.add(names, Torque::default(), false)
    }

    /// Place of a member that is held, on its support or rigidly.
    fn alone(&mut self, set: &str, member: &str, support: Option<Torque>) -> usize {
        self.add(vec![format!("{member} of {set}")], support.unwrap_or_default(), support.is_none())
    }

    fn add(&mut self, names: Vec<String>, support: Torque, held: bool) -> usize {
        let inertia = MomentOfInertia::default();
        self.links.push(Link { name: names.join("+"), inertia, support, held });
        self.names.push(names);
        self.links.len() - 1
    }
}
