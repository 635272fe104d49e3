//! Strength of the meshes of a design: each is rated once for the rims that weaken it.

use super::Requirement;
use super::task::{Body, Governing, Layout, MeshLoads, Task};
use crate::Error;
use crate::factor::Symbol;
use crate::mesh::{Gear, Mesh, Method};
use crate::rating::overload;
use crate::spectrum::{GearDuty, Stresses, Worn, on_flank, rate_duty};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_units::Physical;
use std::collections::HashMap;
use uom::si::f64::Length;

/// Rim over tooth height below which a rim weakens the root
/// ([`rim_factor_external`](crate::root::factors::rim_factor_external)).
const THICK_RIM: f64 = 1.2;

/// A mesh over the duty and against the overloads.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rated {
    /// `None` of a mesh that the duty does not load.
    pub(super) over_duty: Option<[GearDuty<Worn>; 2]>,
    pub(super) overload: Option<Governing>,
    pub(super) governing: Option<Governing>,
}

/// Teeth that were rated; `None` outside what the standard holds for.
pub(super) type Teeth = Option<Rated>;

/// Layout and face widths of a design.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) layout: usize,
    /// Index of the face width of each family.
    pub(super) widths: &'a [usize],
}

/// Ratings of the meshes of all designs.
pub(super) struct Ratings<'a> {
    task: &'a Task,
    layouts: &'a [Layout],
    /// By layout, mesh, index of the face width and rims of planets that weaken roots, in bits.
    known: HashMap<(usize, usize, usize, [u64; 2]), Teeth>,
    /// How many were made.
    pub(super) made: u64,
}

/// Rim of a planet's gear under a bore, in m.
pub(super) fn rim_of(task: &Task, layout: &Layout, gear: usize, bore: f64) -> f64 {
    (layout.gears[gear].root_diameter() * layout.module(task, gear).si() - bore) / 2.0
}

impl<'a> Ratings<'a> {
    pub(super) fn new(task: &'a Task, layouts: &'a [Layout]) -> Self {
        Self { task, layouts, known: HashMap::new(), made: 0 }
    }

    /// Least safety of the teeth of a kind of planets over a bore whose rim weakens them; `None` outside
    /// what the standard holds for.
    pub(super) fn roots(
        &mut self,
        one: Place<'_>,
        planet: usize,
        bore: f64,
    ) -> Result<Option<Option<Governing>>, Error> {
        let task = self.task;
        let mut all = vec![];
        for mesh in 0..task.meshes.len() {
            let is_own = |gear: &usize| task.gears[*gear].body == Body::Planet(planet);
            if !task.meshes[mesh].gears.iter().any(is_own) {
                continue;
            }
            match self.thin(one, mesh, |of| if of == planet { bore } else { 0.0 })? {
                None => {}
                Some(None) => return Ok(None),
                Some(Some(rated)) => all.extend(rated.governing),
            }
        }
        Ok(Some(Governing::least(all)))
    }

    /// The least safety of flanks and roots that several meshes load on one side, whose damages add up;
    /// `None` without such gears.
    pub(super) fn together(&self, one: Place<'_>, bores: &[f64]) -> Result<Option<Governing>, Error> {
        let task = self.task;
        let loads = &self.layouts[one.layout].loads;
        let mut all = vec![];
        for gear in 0..task.gears.len() {
            let ends = task
                .meshes
                .iter()
                .enumerate()
                .filter_map(|(mesh, of)| Some((mesh, of.gears.iter().position(|end| *end == gear)?)));
            let ends: Vec<(usize, usize)> = ends.collect();
            for flank in [1.0, -1.0] {
                let is_on = |signs: &[f64; 2], end: usize| signs[end] * flank > 0.0;
                let on =
                    ends.iter().filter(|(mesh, end)| loads[*mesh].flanks.iter().any(|of| is_on(of, *end)));
                let on: Vec<&(usize, usize)> = on.collect();
                if on.len() < 2 {
                    continue;
                }
                let mut sum = GearDuty { contact: Stresses::default(), root: Stresses::default() };
                for (mesh, end) in &on {
                    let own = &loads[*mesh];
                    let steps = own.steps.iter().zip(&own.flanks).map(|(step, of)| (*step, is_on(of, *end)));
                    let (rated, method) = self.mesh(one, *mesh, self.rims(one, *mesh, |kind| bores[kind]));
                    let of = on_flank((&rated, &method), steps, task.life, own.contacts, *end)?;
                    if let Some(of) = of {
                        sum.contact.join(of.contact);
                        sum.root.join(of.root);
                    }
                }
                let of = |requirement, stresses: &Stresses, required| Governing {
                    requirement,
                    mesh: Some(on[0].0),
                    gear,
                    value: stresses.worn(task.life).safety,
                    required,
                };
                all.push(of(Requirement::Flank, &sum.contact, task.required_contact));
                all.push(of(Requirement::Root, &sum.root, task.required_root));
            }
        }
        Ok(Governing::least(all))
    }

    /// Rating of a mesh with planets of these bores; `None` if no rim is so thin that it weakens a root.
    pub(super) fn thin(
        &mut self,
        one: Place<'_>,
        mesh: usize,
        bore: impl Fn(usize) -> f64,
    ) -> Result<Option<Teeth>, Error> {
        let rims = self.rims(one, mesh, bore);
        if rims.iter().all(Option::is_none) {
            return Ok(None);
        }
        self.rate(one, mesh, rims).map(Some)
    }

    /// Rims of the gears of a mesh that are so thin that they weaken a root, with planets of these bores.
    fn rims(&self, one: Place<'_>, mesh: usize, bore: impl Fn(usize) -> f64) -> [Option<Length>; 2] {
        let task = self.task;
        let own = &self.layouts[one.layout];
        let rim = |gear: usize| {
            let Body::Planet(planet) = task.gears[gear].body else { return None };
            let bore = bore(planet);
            let rim = rim_of(task, own, gear, bore);
            let height = height(&own.gears[gear]) * own.module(task, gear).si();
            (bore > 0.0 && rim / height < THICK_RIM).then(|| Length::from_si(rim))
        };
        task.meshes[mesh].gears.map(rim)
    }

    /// A mesh of a design and its method, with the rims of planets that weaken their roots.
    pub(super) fn mesh(&self, one: Place<'_>, mesh: usize, rims: [Option<Length>; 2]) -> (Mesh, Method) {
        let task = self.task;
        let own = &self.layouts[one.layout];
        let ends = task.meshes[mesh].gears;
        let family = task.gears[ends[0]].family;
        let gear = |end: usize| {
            let sized = &task.gears[ends[end]];
            let rim = match (sized.body, own.gears[ends[end]].kind()) {
                (_, GearKind::Internal) => Some(task.ring_rim(ends[end], own.modules[family])),
                (Body::Planet(_), _) => rims[end],
                (Body::Central, _) => sized.gear.rim,
            };
            Gear { rim, ..sized.gear }
        };
        let mesh_of = Mesh {
            pair: own.pairs[mesh],
            module: own.modules[family],
            face_width: task.face_widths[family][one.widths[family]],
            gears: [gear(0), gear(1)],
            viscosity: task.viscosity,
        };
        let mut method = Method { planets: Some(own.planets), ..task.meshes[mesh].method };
        if let Some(factor) = task.face_load(own, family, mesh_of.face_width.si()) {
            method.given = method.given.with(Symbol::FaceContact, factor);
        }
        (mesh_of, method)
    }

    /// Rating of a mesh, with the rims of planets that weaken their roots; each is made once.
    pub(super) fn rate(
        &mut self,
        one: Place<'_>,
        mesh: usize,
        rims: [Option<Length>; 2],
    ) -> Result<Teeth, Error> {
        let task = self.task;
        let own = &self.layouts[one.layout];
        let ends = task.meshes[mesh].gears;
        let family = task.gears[ends[0]].family;
        let bits = rims.map(|rim| rim.map_or(0, |rim| rim.si().to_bits()));
        let key = (one.layout, mesh, one.widths[family], bits);
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let (rated, method) = self.mesh(one, mesh, rims);
        self.made += 1;
        let teeth = match task.rated(mesh, &rated, &own.loads[mesh], &method) {
            Ok(rated) => Some(rated),
            Err(error) if error.is_beyond_standard() => None,
            Err(error) => return Err(error),
        };
        self.known.insert(key, teeth);
        Ok(teeth)
    }
}

/// Tooth height, in modules.
fn height(gear: &InvoluteGear) -> f64 {
    (gear.tip_diameter() - gear.root_diameter()) / 2.0
}

impl Task {
    fn rated(&self, mesh: usize, of: &Mesh, loads: &MeshLoads, method: &Method) -> Result<Rated, Error> {
        let over_duty = match rate_duty(of, &loads.steps, self.life, loads.contacts, method) {
            Ok(rating) => Some(rating.whole()?),
            Err(Error::IdleDuty) => None,
            Err(error) => return Err(error),
        };
        let ends = self.meshes[mesh].gears;
        let governing = |requirement, side: usize, value, required| Governing {
            requirement,
            mesh: Some(mesh),
            gear: ends[side],
            value,
            required,
        };
        let mut all = vec![];
        for (side, gear) in over_duty.iter().flatten().enumerate() {
            all.push(governing(Requirement::Flank, side, gear.contact.safety, self.required_contact));
            all.push(governing(Requirement::Root, side, gear.root.safety, self.required_root));
        }
        let mut overloads = vec![];
        for against in loads.overloads.iter().filter(|one| one.torque.si() != 0.0) {
            let rating = overload(of, against.torque, method)?;
            for (side, gear) in rating.gears.into_iter().enumerate() {
                let flank = Requirement::OverloadFlank;
                overloads.push(governing(flank, side, gear.contact?, against.required_contact));
                let root = Requirement::OverloadRoot;
                overloads.push(governing(root, side, gear.root?, against.required_root));
            }
        }
        let overload = Governing::least(overloads);
        Ok(Rated { over_duty, overload, governing: Governing::least(all.into_iter().chain(overload)) })
    }
}
