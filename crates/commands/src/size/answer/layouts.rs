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
//! Planets of several kinds, as in a Ravigneaux set, have the radius in the middle of the range of each kind. Shifts are those of
//! [`MeshTree::choose`](epicyclic_gears::involute::tree::MeshTree::choose).

use crate::error::Error;
use crate::size::options::Request;
use crate::strength::answer::duty::WorkedStep;
use crate::strength::answer::load::SetLoad;
use crate::strength::answer::overload::Peak;
use crate::strength::answer::prepared::SetToSize;
use crate::strength::answer::records::Reason;
use crate::tolerance::EDGE;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Check, Rule, Severity};
use epicyclic_gears::involute::checks::{Limits, gear_checks, mesh_checks};
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::shifts::StatedDistance;
use epicyclic_gears::involute::tree::MeshTree;
use epicyclic_gears::involute::{InvoluteGear, Profile};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::rack::BasicRack;
use epicyclic_strength as strength;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::load::load_sharing;
use epicyclic_strength::sizing::{Layout, MeshLoads, PlanetStep, Space, StaticDemand, Task, Tried};
use epicyclic_strength::spectrum::Step;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_bearings::{MeshSize, PlanetSize, SetSize};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{Shifts, ToothShape, ToothedSet};
use epicyclic_units::Physical;
use std::ops::ControlFlow;
use std::sync::Arc;
use uom::si::f64::{Angle, AngularVelocity, Length, Torque};

/// Backlash in modules that meshes of one planet may have with stated shifts: as if printed with few
/// decimals.
const CLOSED: f64 = 0.01;

/// Layouts that a search holds at most; it then ends within minutes.
const MOST: u32 = 100_000;

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

/// Modules of the families, and radii of the kinds of planets; without radii the shifts are stated.
struct Place {
    modules: Vec<Length>,
    radii: Option<Vec<Length>>,
}

/// Why a place makes no layout.
enum Unmade {
    Geometry,
    PlanetsTouch,
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
        if places.is_empty() {
            return Ok(Err(Reason::NoCommonRadius));
        }
        let count = (places.len() * counts.len()) as f64 * designs as f64;
        if count > f64::from(MOST) * 10.0 {
            return Err(strength::Error::SpaceTooLarge { count, most: MOST * 10 }.into());
        }
        let (mut all, mut tried) = (vec![], Tried::default());
        for planets in counts {
            let counted = set.reshaped((!set.is_pair()).then_some(planets), set.tooth_shape().clone());
            if !set.is_pair() && counted.planet_fit(self.rack).assembles == Some(false) {
                tried.left_out.spacing += places.len() as u64 * designs;
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
                    tried.left_out.not_calculable += places.len() as u64 * designs;
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            for place in &places {
                if goes_on().is_break() {
                    return Err(strength::Error::Cancelled.into());
                }
                tried.geometries += 1;
                match self.made(&counted, place) {
                    Ok((shaped, toothed, is_aim_met)) => {
                        let Some(bearing_loads) = self.bearing_loads(&shaped, &toothed)? else {
                            return Ok(Err(Reason::NoTorquesFollow));
                        };
                        let gear = |gear: &GearOf| toothed.gear(*gear).copied();
                        let gears: Option<Vec<InvoluteGear>> = self.set.data.of.iter().map(gear).collect();
                        let radius = |radius: &Option<f64>| Length::from_si(radius.unwrap_or_default());
                        all.push(Layout {
                            planets,
                            modules: place.modules.clone(),
                            gears: gears.unwrap_or_default(),
                            pairs: toothed.meshes.iter().map(|mesh| mesh.pair).collect(),
                            radii: toothed.radii.iter().map(radius).collect(),
                            is_aim_met,
                            loads: Arc::clone(&loads),
                            sharing,
                            bearing_loads,
                        });
                    }
                    Err(Unmade::Geometry) => tried.left_out.geometry += designs,
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

    /// Combinations of modules, with the radii that each allows.
    fn places(&self) -> Vec<Place> {
        let stated = |family: usize| {
            let mut own = (0..self.families.ends.len()).filter(|mesh| self.families.of_mesh(*mesh) == family);
            own.find_map(|mesh| self.set.data.modules[mesh])
        };
        let modules: Vec<Vec<Length>> = (0..self.families.count)
            .map(|family| stated(family).map_or_else(|| self.space.modules.clone(), |module| vec![module]))
            .collect();
        let has_shifts = self.set.set.tooth_shape().shifts.is_some();
        let mut all = vec![];
        for modules in combinations(&modules) {
            if has_shifts {
                all.push(Place { modules, radii: None });
                continue;
            }
            let radii = combinations(&self.radii(&modules));
            all.extend(radii.into_iter().map(|radii| Place { modules: modules.clone(), radii: Some(radii) }));
        }
        all
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
            if axes > 1 {
                return if low <= high { vec![Length::from_si(low.midpoint(high))] } else { vec![] };
            }
            let step = self.space.centre_distance_step.si();
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
        let (shaped, is_aim_met) = match &place.radii {
            None => (set.clone(), true),
            Some(radii) => {
                let (shape, is_aim_met) = self.chosen(place, radii, &limits).ok_or(Unmade::Geometry)?;
                (set.reshaped(set.planet_count(), shape), is_aim_met)
            }
        };
        let toothed = shaped.toothed(self.rack, &modules).map_err(|_| Unmade::Geometry)?;
        let is_closed = toothed.meshes.iter().all(|mesh| mesh.pair.backlash().abs() <= CLOSED);
        if !is_closed || has_fault(&toothed, &limits) {
            return Err(Unmade::Geometry);
        }
        if !shaped.is_pair() && self.do_touch(&shaped, &toothed, &modules, limits.planet_gap) {
            return Err(Unmade::PlanetsTouch);
        }
        Ok((shaped, toothed, is_aim_met))
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
                    is_own && planets > 1 && circle.gap(circle, angle) <= gap
                })
            })
        };
        toothed.radii.iter().enumerate().any(is_near) || set.planets_clear(self.rack, modules) == Some(false)
    }

    /// The teeth with the shifts that the aim picks at these radii, and whether it is met.
    fn chosen(&self, place: &Place, radii: &[Length], limits: &Limits) -> Option<(ToothShape, bool)> {
        let gears = self.set.data.of.len();
        let tied: Vec<(usize, usize)> =
            (0..self.families.ends.len()).filter_map(|mesh| Some((mesh, self.axis(mesh)?))).collect();
        let (groups, count) = joined(gears, tied.iter().map(|(mesh, _)| self.families.ends[*mesh]));
        let (mut profile, mut tips, mut is_aim_met) = (vec![0.0; gears], vec![0.0; gears], true);
        let mut shape = self.set.set.tooth_shape().clone();
        shape.cutting.resize(gears, Cutting::default());
        for group in 0..count {
            let own: Vec<usize> = (0..gears).filter(|gear| groups[*gear] == group).collect();
            let at = |gear: usize| own.iter().position(|one| *one == gear).unwrap_or_default();
            let mut meshes = vec![];
            for (mesh, axis) in tied.iter().filter(|(mesh, _)| groups[self.families.ends[*mesh][0]] == group)
            {
                let module = place.modules[self.families.of_mesh(*mesh)];
                let distance = radii[*axis].si() / module.si();
                meshes.push(StatedDistance { gears: self.families.ends[*mesh].map(at), distance });
            }
            let made = own.iter().map(|gear| self.searched(*gear)).collect::<Option<Vec<_>>>()?;
            let chosen = MeshTree::new(made, meshes).ok()?.choose(self.request.aim, limits).ok()?;
            is_aim_met &= chosen.is_aim_met;
            for (gear, chosen) in own.iter().zip(&chosen.gears) {
                (profile[*gear], tips[*gear]) = (chosen.shift(), chosen.tip_alteration());
                // The tool as it cut the gear: its addendum is no longer open.
                shape.cutting[*gear].tool = Some(*chosen.tool());
            }
        }
        shape.shifts = Some(Shifts { profile, tips: Some(tips) });
        Some((shape, is_aim_met))
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

    /// Loads of the bearings of each kind of planets; `None` where they do not follow.
    fn bearing_loads(
        &self,
        set: &PlanetSet,
        toothed: &ToothedSet,
    ) -> Result<Option<Vec<Vec<PlanetStep>>>, Error> {
        let behind = |(size, is_behind): (MeshSize, &bool)| MeshSize { is_behind: *is_behind, ..size };
        let planet = |radius: &Option<f64>| PlanetSize {
            carrier_radius: radius.map(Length::from_si),
            ..PlanetSize::default()
        };
        let size = SetSize {
            meshes: set
                .mesh_sizes(toothed, true)
                .into_iter()
                .zip(&self.set.data.is_behind)
                .map(behind)
                .collect(),
            planets: toothed.radii.iter().map(planet).collect(),
            // Of planets in mesh, as for the bearings of the file.
            pressure_angle: self.rack.pressure_angle,
            ..SetSize::default()
        };
        let still = AngularVelocity::default();
        let mut all = vec![];
        for bearing in set.bearings(self.set.place, &size)? {
            let mut own = vec![];
            for WorkedStep(entry, worked) in self.steps {
                let mut step = PlanetStep {
                    share: entry.share.0.si(),
                    tangential: Default::default(),
                    radial: Default::default(),
                    carrier_speed: still,
                    speed: still,
                };
                if let Some(worked) = worked {
                    let torques = worked.member_torques(self.set.place);
                    let forces = bearing.forces(torques.as_deref(), Some(still))?;
                    let turning = worked.analysis.sets()[self.set.place].planets[bearing.planet];
                    let (Some(tangential), Some(radial), Some(turning)) =
                        (forces.tangential, forces.radial, turning)
                    else {
                        return Ok(None);
                    };
                    let carrier = worked.analysis.speed(set.carrier()).unwrap_or_default();
                    let relative = crate::tolerance::rounded(turning.relative);
                    (step.tangential, step.radial) = (tangential, radial);
                    step.carrier_speed = entry.speed.0 * carrier;
                    step.speed = (entry.speed.0 * relative).abs();
                }
                own.push(step);
            }
            all.push(own);
        }
        Ok(Some(all))
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

/// Whether any check of the gears and meshes fails, remarks and backlash apart.
fn has_fault(toothed: &ToothedSet, limits: &Limits) -> bool {
    let mut has = false;
    let mut see = |check: Check<()>| {
        let counts = check.rule.severity() > Severity::Remark || limits.radial_assembly;
        let counts = counts && check.rule != Rule::Backlash;
        has |= counts && !check.holds();
    };
    for mesh in &toothed.meshes {
        for gear in mesh.pair.gears() {
            gear_checks(&(), gear, limits, &mut see);
        }
        mesh_checks(&(), &[(), ()], &mesh.pair, limits, &mut see);
    }
    has
}
