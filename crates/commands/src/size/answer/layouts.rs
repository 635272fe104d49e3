//! Layouts of a set of any kind: modules of its families of gears, numbers and radii of planets, and the
//! shifts that an aim picks there.
//!
//! # Space
//! A family without a stated module has each of the search. With stated shifts a layout is one combination of
//! modules with which all meshes of a planet close on one radius. Otherwise the radius of the planets, of a
//! pair its centre distance, runs over the multiples of the step that are within the reach of every mesh:
//!
//! ```text
//! |R/m_j − (z_1 ± z_2)/(2·cos β)| ≤ reach        of each mesh j with a central gear
//! ```
//!
//! Planets of several kinds, as in a Ravigneaux set, have a radius of their own each, and a layout is one
//! combination of them. Shifts are those of
//! [`MeshTree::choose`](epicyclic_gears::involute::tree::MeshTree::choose). Gears that only a mesh of two
//! planets joins are chosen apart: the distance of that mesh is free, and the planets stand at the angle that
//! their shifts give.

mod bearing_loads;

use crate::error::Error;
use crate::size::options::Request;
use crate::strength::answer::duty::WorkedStep;
use crate::strength::answer::load::SetLoad;
use crate::strength::answer::overload::Peak;
use crate::strength::answer::prepared::SetToSize;
use crate::strength::answer::records::Reason;
use crate::tolerance::EDGE;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Check, Rule, Severity, is_clear};
use epicyclic_gears::involute::checks::{Limits, gear_checks, mesh_checks};
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::shifts::StatedDistance;
use epicyclic_gears::involute::tree::{MeshTree, NoShifts, Place as Object};
use epicyclic_gears::involute::{InvoluteGear, Profile};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::rack::BasicRack;
use epicyclic_strength as strength;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::load::load_sharing;
use epicyclic_strength::sizing::{Layout, MeshLoads, Space, StaticDemand, Task, Tried};
use epicyclic_strength::spectrum::Step;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{Shifts, ToothShape, ToothedSet};
use epicyclic_units::Physical;
use std::collections::HashMap;
use std::ops::ControlFlow;
use std::sync::Arc;
use uom::si::f64::{Angle, AngularVelocity, Length, Torque};

/// Backlash in modules that meshes of one planet may have with stated shifts: as if printed with few
/// decimals.
const CLOSED: f64 = 0.01;

/// Layouts that a search holds at most; it then ends within minutes.
const MOST: u32 = 100_000;

/// Designs for each of these layouts that a search may have. Where nothing holds, a million takes about five seconds.
const DESIGNS: u32 = 100;

/// Step of the radii of several kinds of planets in modules, unless one is asked for.
const COARSE: f64 = 0.25;

/// Gears of a set by families, and their meshes.
pub(super) struct Families {
    /// Family of each gear.
    pub(super) of: Vec<usize>,
    /// Gears of each mesh, in the order of the pair.
    pub(super) ends: Vec<[usize; 2]>,
    pub(super) count: usize,
}

impl Families {
    pub(super) fn of(set: &SetToSize<'_>) -> Self {
        let ends: Vec<[usize; 2]> = (0..set.set.meshes().len())
            .map(|mesh| set.set.gears_of_mesh(mesh).map(|gear| set.data.place(gear)))
            .collect();
        let (of, count) = joined(set.data.of.len(), ends.iter().copied());
        Self { of, ends, count }
    }

    /// Family of a mesh.
    pub(super) fn of_mesh(&self, mesh: usize) -> usize {
        self.of[self.ends[mesh][0]]
    }
}

/// Groups of things that pairs join: the group of each, and their number.
fn joined(count: usize, pairs: impl Iterator<Item = [usize; 2]>) -> (Vec<usize>, usize) {
    let mut of: Vec<usize> = (0..count).collect();
    for [one, other] in pairs {
        let (low, high) = (of[one].min(of[other]), of[one].max(of[other]));
        of.iter_mut().filter(|group| **group == high).for_each(|group| *group = low);
    }
    let mut groups = of.clone();
    groups.sort_unstable();
    groups.dedup();
    let place = |group: &usize| groups.iter().position(|one| one == group).unwrap_or_default();
    (of.iter().map(place).collect(), groups.len())
}

/// Data for the layouts of a set.
pub(super) struct Making<'a> {
    pub(super) set: &'a SetToSize<'a>,
    pub(super) families: &'a Families,
    pub(super) rack: &'a BasicRack,
    pub(super) space: &'a Space,
    pub(super) request: &'a Request,
    pub(super) steps: &'a [WorkedStep<'a>],
    pub(super) peaks: &'a [Peak<'a>],
}

/// Modules of the families, with the teeth that the aim picks at radii of the planets and whether it is met;
/// without these the shifts are stated.
struct Place {
    modules: Vec<Length>,
    chosen: Option<(ToothShape, bool)>,
}

/// Gears that meshes join whose distance the radius of a planet states.
struct Group {
    gears: Vec<usize>,
    /// The meshes, each with its axis.
    meshes: Vec<(usize, usize)>,
}

/// Shifts and tips of some of the gears, the tools that cut them, and whether the aim is met.
#[derive(Clone)]
struct Chosen {
    gears: Vec<(usize, InvoluteGear)>,
    is_aim_met: bool,
}

/// Gears of a group, or what is in their way, by the bits of the radii of its planets.
type Known = HashMap<Vec<u64>, Result<Chosen, Option<Fault>>>;

/// Why a place makes no layout.
enum Unmade {
    /// The first check that fails; `None` where the gears cannot mesh at all.
    Geometry(Option<Fault>),
    PlanetsTouch,
}

/// Check that fails, with the gears of the set in words.
type Fault = Check<String>;

/// Combinations of modules and radii.
#[derive(Default)]
struct Places {
    /// Combinations whose shifts have no fault.
    good: Vec<Place>,
    /// The faults of the others.
    bad: Vec<Option<Fault>>,
}

impl Places {
    fn len(&self) -> u64 {
        (self.good.len() + self.bad.len()) as u64
    }
}

impl Making<'_> {
    /// The layouts, and what was left out, or why there are none.
    pub(super) fn layouts(
        &self,
        task: &Task,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Result<(Vec<Layout>, Tried), Reason>, Error> {
        let set = self.set.set;
        let designs: u64 = task.face_widths.iter().map(|widths| widths.len() as u64).product();
        let places = self.places();
        let counts = match set.planet_count() {
            _ if set.is_pair() => vec![1],
            Some(planets) => vec![planets],
            None => self.space.planets.clone(),
        };
        if places.len() == 0 {
            return Ok(Err(Reason::NoCommonRadius));
        }
        let count = places.len() as f64 * counts.len() as f64 * designs as f64;
        if count > f64::from(MOST) * f64::from(DESIGNS) {
            return Err(strength::Error::SpaceTooLarge { count, most: MOST * DESIGNS }.into());
        }
        let (mut all, mut tried) = (vec![], Tried::default());
        for planets in counts {
            let counted = set.reshaped((!set.is_pair()).then_some(planets), set.tooth_shape().clone());
            if !set.is_pair() && counted.planet_fit(self.rack).assembles == Some(false) {
                tried.left_out.spacing += places.len() * designs;
                continue;
            }
            let Some(loads) = self.loads(&counted) else { return Ok(Err(Reason::NoTorquesFollow)) };
            let loads: Arc<[MeshLoads]> = loads.into();
            let given = self.set.methods[0].given.of(Side::First, Symbol::LoadSharing);
            let sharing = match given.map_or_else(|| load_sharing(planets, self.set.methods[0].floating), Ok)
            {
                Ok(sharing) => sharing,
                // More planets than the table of load sharing has.
                Err(_) if set.planet_count().is_none() => {
                    tried.left_out.not_calculable += places.len() * designs;
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            tried.geometries += places.len();
            // Whatever the number of planets.
            places.bad.iter().for_each(|fault| leave_out(&mut tried, fault.as_ref(), designs));
            for place in &places.good {
                if goes_on().is_break() {
                    return Err(strength::Error::Cancelled.into());
                }
                match self.made(&counted, place) {
                    Ok((shaped, toothed, is_aim_met)) => {
                        let Some(bearing_loads) = self.bearing_loads(&shaped, &toothed)? else {
                            return Ok(Err(Reason::NoTorquesFollow));
                        };
                        let gear = |gear: &GearOf| toothed.gear(*gear).copied();
                        let gears: Option<Arc<[InvoluteGear]>> = self.set.data.of.iter().map(gear).collect();
                        let radius = |radius: &Option<f64>| Length::from_si(radius.unwrap_or_default());
                        all.push(Layout {
                            planets,
                            modules: place.modules.clone(),
                            gears: gears.unwrap_or_else(|| [].into()),
                            pairs: toothed.meshes.iter().map(|mesh| mesh.pair).collect(),
                            radii: toothed.radii.iter().map(radius).collect(),
                            is_aim_met,
                            loads: Arc::clone(&loads),
                            sharing,
                            bearing_loads,
                        });
                    }
                    Err(Unmade::Geometry(fault)) => leave_out(&mut tried, fault.as_ref(), designs),
                    Err(Unmade::PlanetsTouch) => tried.left_out.planets_touch += designs,
                }
            }
        }
        Ok(Ok((all, tried)))
    }

    /// Axis whose distance a mesh has: the planet of its planet gear, or that of a pair; `None` of two
    /// planets, whose distance is free.
    fn axis(&self, mesh: usize) -> Option<usize> {
        match self.families.ends[mesh].map(|gear| self.set.data.of[gear]) {
            [GearOf::Central(_), GearOf::Planet(planet, _)]
            | [GearOf::Planet(planet, _), GearOf::Central(_)] => Some(planet),
            [GearOf::Central(_), GearOf::Central(_)] => Some(0),
            [GearOf::Planet(..), GearOf::Planet(..)] => None,
        }
    }

    fn helix_angle(&self, mesh: usize) -> Angle {
        self.set.set.tooth_shape().helix_angle(mesh)
    }

    /// Distance of the reference circles of a mesh, in modules.
    fn reference_distance(&self, mesh: usize) -> f64 {
        let [one, other] = self.families.ends[mesh];
        let teeth = [one, other].map(|gear| self.set.teeth[gear].as_f64());
        let is_ring = self.set.set.gear_kind(self.set.data.of[other]) == Some(GearKind::Internal);
        let sum = if is_ring { teeth[1] - teeth[0] } else { teeth[0] + teeth[1] };
        sum / (2.0 * libm::cos(self.helix_angle(mesh).si()))
    }

    /// Combinations of modules and radii, with the shifts of each.
    fn places(&self) -> Places {
        let stated = |family: usize| {
            let mut own = (0..self.families.ends.len()).filter(|mesh| self.families.of_mesh(*mesh) == family);
            own.find_map(|mesh| self.set.data.modules[mesh])
        };
        let modules: Vec<Vec<Length>> = (0..self.families.count)
            .map(|family| stated(family).map_or_else(|| self.space.modules.clone(), |module| vec![module]))
            .collect();
        if self.set.set.tooth_shape().shifts.is_some() {
            let stated = |modules| Place { modules, chosen: None };
            return Places { good: combinations(&modules).into_iter().map(stated).collect(), bad: vec![] };
        }
        let groups = self.groups();
        let mut places = Places::default();
        for modules in combinations(&modules) {
            // Each group once at the radii of its own planets: combinations of several kinds repeat them.
            let mut known: Vec<Known> = vec![HashMap::new(); groups.len()];
            for radii in combinations(&self.radii(&modules)) {
                let of_group = |(group, known): (&Group, &mut Known)| {
                    let own = group.meshes.iter().map(|(_, axis)| radii[*axis].si().to_bits()).collect();
                    known.entry(own).or_insert_with(|| self.chosen(&modules, &radii, group)).clone()
                };
                let chosen: Result<Vec<Chosen>, _> = groups.iter().zip(&mut known).map(of_group).collect();
                match chosen {
                    Ok(chosen) => places.good.push(self.place(&modules, &chosen)),
                    Err(fault) => places.bad.push(fault),
                }
            }
        }
        places
    }

    /// Gears that meshes with a central gear join.
    fn groups(&self) -> Vec<Group> {
        let tied: Vec<(usize, usize)> =
            (0..self.families.ends.len()).filter_map(|mesh| Some((mesh, self.axis(mesh)?))).collect();
        let ends = |mesh: usize| self.families.ends[mesh];
        let (of, count) = joined(self.set.data.of.len(), tied.iter().map(|(mesh, _)| ends(*mesh)));
        let group = |group: usize| Group {
            gears: (0..of.len()).filter(|gear| of[*gear] == group).collect(),
            meshes: tied.iter().copied().filter(|(mesh, _)| of[ends(*mesh)[0]] == group).collect(),
        };
        (0..count).map(group).collect()
    }

    /// Radii of each kind of planets that modules allow.
    fn radii(&self, modules: &[Length]) -> Vec<Vec<Length>> {
        let axes = self.set.set.planets().len().max(1);
        let of_axis = |axis: usize| {
            let meshes = (0..self.families.ends.len()).filter(|mesh| self.axis(*mesh) == Some(axis));
            let reach = |mesh: usize| {
                let module = modules[self.families.of_mesh(mesh)].si();
                let reference = self.reference_distance(mesh);
                [reference - self.space.reach, reference + self.space.reach].map(|end| end * module)
            };
            let [low, high] = meshes.map(reach).fold([0.0, f64::INFINITY], |[low, high], [one, other]| {
                [f64::max(low, one), f64::min(high, other)]
            });
            let planet = self.set.data.planets.get(axis);
            if let Some(stated) = planet.and_then(|planet| planet.carrier_radius) {
                return if (low..=high).contains(&stated.si()) { vec![stated] } else { vec![] };
            }
            let mut step = self.space.centre_distance_step.si();
            // Every radius of one kind of planets meets every one of the others.
            if axes > 1 && self.request.centre_distance_step.is_none() {
                let finest = modules.iter().map(|module| module.si()).fold(f64::INFINITY, f64::min);
                step *= (finest * COARSE / step).ceil();
            }
            let ends = [(low / step - EDGE).ceil(), (high / step + EDGE).floor()];
            let most = ends[0] + f64::from(MOST);
            (ends[0] as i64..=ends[1].min(most) as i64)
                .map(|count| Length::from_si(count as f64 * step))
                .collect()
        };
        (0..axes).map(of_axis).collect()
    }

    /// The gears at a place without faults, and whether the aim of their shifts is met.
    fn made(&self, set: &PlanetSet, place: &Place) -> Result<(PlanetSet, ToothedSet, bool), Unmade> {
        let limits = self.request.limits();
        let modules: Vec<Option<f64>> = (0..self.families.ends.len())
            .map(|mesh| Some(place.modules[self.families.of_mesh(mesh)].si()))
            .collect();
        let (shaped, is_aim_met) = match &place.chosen {
            None => (set.clone(), true),
            Some((shape, is_aim_met)) => (set.reshaped(set.planet_count(), shape.clone()), *is_aim_met),
        };
        let toothed = shaped.toothed(self.rack, &modules).map_err(|_| Unmade::Geometry(None))?;
        let is_closed = toothed.meshes.iter().all(|mesh| mesh.pair.backlash().abs() <= CLOSED);
        let fault = self.first_fault(&toothed, &limits);
        if !is_closed || fault.is_some() {
            return Err(Unmade::Geometry(fault));
        }
        if !shaped.is_pair() && self.do_touch(&shaped, &toothed, &modules, limits.planet_gap) {
            return Err(Unmade::PlanetsTouch);
        }
        Ok((shaped, toothed, is_aim_met))
    }

    /// The first check of the gears and meshes that fails, remarks and backlash apart.
    fn first_fault(&self, toothed: &ToothedSet, limits: &Limits) -> Option<Fault> {
        let mut first = None;
        let mut see = |check: Check<Object>| {
            let counts = check.rule.severity() > Severity::Remark || limits.radial_assembly;
            let counts = counts && check.rule != Rule::Backlash && !check.holds();
            if counts && first.is_none() {
                first = Some(check);
            }
        };
        let every = Group {
            gears: (0..self.set.data.of.len()).collect(),
            meshes: (0..toothed.meshes.len()).map(|mesh| (mesh, 0)).collect(),
        };
        for (place, mesh) in toothed.meshes.iter().enumerate() {
            let ends = self.families.ends[place];
            for (gear, of) in mesh.pair.gears().iter().zip(ends) {
                gear_checks(&Object::Gear(of), gear, limits, &mut see);
            }
            let tips = ends.map(|gear| Object::Tips(gear, place));
            mesh_checks(&Object::Mesh(place), &tips, &mesh.pair, limits, &mut see);
        }
        first.map(|check| self.named(&check, &every))
    }

    /// Whether planets of any kind touch each other, or alike ones are nearer than the gap in modules.
    fn do_touch(&self, set: &PlanetSet, toothed: &ToothedSet, modules: &[Option<f64>], gap: f64) -> bool {
        let planets = set.planet_count().unwrap_or(1);
        let equal = std::f64::consts::TAU / f64::from(planets);
        let angle = set.least_planet_angle().map_or(equal, Physical::si);
        let is_near = |(planet, radius): (usize, &Option<f64>)| {
            toothed.meshes.iter().any(|mesh| {
                mesh.gears.iter().zip(mesh.pair.gears()).any(|(of, gear)| {
                    let is_own = matches!(of, GearOf::Planet(own, _) if *own == planet);
                    let centre_radius = radius.unwrap_or_default() / mesh.module;
                    let circle = TipCircle { centre_radius, tip_radius: gear.tip_diameter() / 2.0 };
                    is_own && planets > 1 && !is_clear(circle.gap(circle, angle), gap)
                })
            })
        };
        toothed.radii.iter().enumerate().any(is_near) || set.planets_clear(self.rack, modules) == Some(false)
    }

    /// Shifts that the aim picks for gears that the meshes join, at radii of the planets.
    fn chosen(&self, modules: &[Length], radii: &[Length], group: &Group) -> Result<Chosen, Option<Fault>> {
        let own = &group.gears;
        let at = |gear: usize| own.iter().position(|one| *one == gear).unwrap_or_default();
        let stated = |(mesh, axis): &(usize, usize)| {
            let distance = radii[*axis].si() / modules[self.families.of_mesh(*mesh)].si();
            StatedDistance { gears: self.families.ends[*mesh].map(at), distance }
        };
        let made = own.iter().map(|gear| self.searched(*gear)).collect::<Option<Vec<_>>>().ok_or(None)?;
        let tree = MeshTree::new(made, group.meshes.iter().map(stated).collect()).map_err(|_| None)?;
        let chosen = tree.choose(self.request.aim, &self.request.limits()).map_err(|why| match why {
            NoShifts::Fault(fault) => Some(self.named(&fault, group)),
            NoShifts::Refused(_) => None,
        })?;
        let gears = own.iter().copied().zip(chosen.gears).collect();
        Ok(Chosen { gears, is_aim_met: chosen.is_aim_met })
    }

    /// A fault with the gears in words, and why a tool does not cut one.
    fn named(&self, fault: &Check<Object>, group: &Group) -> Fault {
        let name = |gear: usize| self.set.set.gear_name(self.set.data.of[gear]);
        let gear = |gear: usize| name(group.gears[gear]);
        let mesh = |mesh: usize| self.families.ends[group.meshes[mesh].0].map(name).join("–");
        fault.at(match fault.place {
            Object::Gear(one) if fault.rule == Rule::Tool => {
                let why = self.searched(group.gears[one]).and_then(|gear| gear.tool_fault());
                format!("the {}{}", gear(one), why.map(|why| format!(": {why}")).unwrap_or_default())
            }
            Object::Gear(one) => format!("the {}", gear(one)),
            Object::Mesh(one) => format!("the {} mesh", mesh(one)),
            Object::Tips(of, one) => format!("the tips of the {}, {} mesh,", gear(of), mesh(one)),
        })
    }

    /// The teeth of all groups of gears.
    fn place(&self, modules: &[Length], groups: &[Chosen]) -> Place {
        let gears = self.set.data.of.len();
        let (mut profile, mut tips) = (vec![0.0; gears], vec![0.0; gears]);
        let mut shape = self.set.set.tooth_shape().clone();
        shape.cutting.resize(gears, Cutting::default());
        for (gear, chosen) in groups.iter().flat_map(|group| &group.gears) {
            (profile[*gear], tips[*gear]) = (chosen.shift(), chosen.tip_alteration());
            // The tool as it cut the gear: its addendum is no longer open.
            shape.cutting[*gear].tool = Some(*chosen.tool());
        }
        shape.shifts = Some(Shifts { profile, tips: Some(tips) });
        let is_aim_met = groups.iter().all(|group| group.is_aim_met);
        Place { modules: modules.to_vec(), chosen: Some((shape, is_aim_met)) }
    }

    /// A gear before its shift is known.
    fn searched(&self, gear: usize) -> Option<InvoluteGear> {
        let shape = self.set.set.tooth_shape();
        let mesh = self.families.ends.iter().position(|ends| ends.contains(&gear))?;
        let profile = Profile { helix_angle: self.helix_angle(mesh), ..Profile::of_rack(*self.rack) };
        let profile = shape.cutting.get(gear).map_or(profile, |cutting| cutting.of(profile));
        let kind = self.set.set.gear_kind(self.set.data.of[gear])?;
        InvoluteGear::searched(kind, self.set.teeth[gear], profile).ok()
    }

    /// Loads of the meshes of a set with this number of planets; `None` where they do not follow.
    fn loads(&self, set: &PlanetSet) -> Option<Vec<MeshLoads>> {
        let idle = |mesh: usize| {
            let contacts = set.mesh_loads(&vec![0.0; set.centrals().len()])?[mesh].contacts;
            Some(MeshLoads { steps: vec![], flanks: vec![], contacts, overloads: vec![] })
        };
        let mut all: Vec<MeshLoads> = (0..set.meshes().len()).map(idle).collect::<Option<_>>()?;
        for WorkedStep(entry, worked) in self.steps {
            let load = worked.as_ref().map(|worked| SetLoad::of(self.set.place, worked, Some(entry.speed.0)));
            let felt = match load {
                Some(Err(Reason::NoTorquesFollow)) => return None,
                Some(Ok(load)) => Some((load.of_meshes(set), load.speed)),
                None | Some(Err(_)) => None,
            };
            for (mesh, own) in all.iter_mut().enumerate() {
                let (torque, speed) = felt.as_ref().map_or((0.0, 0.0), |(loads, speed)| {
                    (loads[mesh].torques[0].abs(), (speed.si() * loads[mesh].speeds[0]).abs())
                });
                let torques = felt.as_ref().map_or([0.0; 2], |(loads, _)| loads[mesh].torques);
                own.flanks.push(torques.map(|one| if one == 0.0 { 0.0 } else { one.signum() }));
                own.steps.push(Step {
                    share: entry.share.0.si(),
                    torque: Torque::from_si(torque),
                    speed: AngularVelocity::from_si(speed),
                });
            }
        }
        for peak in self.peaks {
            let load = match SetLoad::of(self.set.place, &peak.worked, None) {
                Err(Reason::NoTorquesFollow) => return None,
                Err(_) => continue,
                Ok(load) => load.of_meshes(set),
            };
            for (own, load) in all.iter_mut().zip(&load).filter(|(_, load)| load.torques[0] != 0.0) {
                own.overloads.push(StaticDemand {
                    torque: Torque::from_si(load.torques[0].abs()),
                    required_contact: peak.required.flank,
                    required_root: peak.required.root,
                });
            }
        }
        Some(all)
    }
}

/// Every choice of one from each.
fn combinations<T: Clone>(of: &[Vec<T>]) -> Vec<Vec<T>> {
    let mut all = vec![vec![]];
    for own in of {
        all = all
            .iter()
            .flat_map(|first: &Vec<T>| {
                own.iter().map(move |one| first.iter().cloned().chain([one.clone()]).collect())
            })
            .collect();
    }
    all
}

/// Leaves out designs whose gears have a fault.
fn leave_out(tried: &mut Tried, fault: Option<&Fault>, designs: u64) {
    match fault {
        Some(fault) => tried.leave_out(fault, designs),
        None => tried.left_out.geometry += designs,
    }
}
