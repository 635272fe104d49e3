//! Layouts of a simple set or a pair: the gears at every centre distance of the space, and their loads.

use super::search::search;
use super::task::{
    Body, Design, Layout, MeshLoads, Pin, PlanetStep, SizedGear, SizedMesh, SizedPlanet, StaticDemand, Task,
};
use super::{Found, Objective, Space, Tried};
use crate::checks::{not_negative, positive};
use crate::factor::{Side, Symbol};
use crate::load::load_sharing;
use crate::mesh::{Gear, Method};
use crate::planets::{axial_forces, loads};
use crate::spectrum::{Step, check_shares};
use crate::tolerance::{EDGE, WHOLE};
use crate::{Error, Quantity};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Check, is_clear};
use epicyclic_gears::involute::family::{Aim, Family, natural_centre_distance};
use epicyclic_gears::involute::profile::Profiles;
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::involute::shifts::StatedDistance;
use epicyclic_gears::involute::tree::{Chosen, MeshTree, NoShifts};
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_judge as judge;
use epicyclic_numerics::threads::map_while;
use epicyclic_units::Physical;
use std::ops::ControlFlow;
use std::sync::Arc;
use uom::si::f64::{Angle, AngularVelocity, Force, KinematicViscosity, Length, Mass, Time, Torque};

/// A step of the duty as the set feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetStep {
    /// Share of the time.
    pub share: f64,
    /// Torque on the sun, without losses; its sign does not matter.
    pub sun_torque: Torque,
    /// Speed of the sun relative to the carrier; its sign does not matter.
    pub sun_speed: AngularVelocity,
    /// Speed of the carrier.
    pub carrier_speed: AngularVelocity,
}

impl SetStep {
    /// Takes the least torque, turns and carrier speed of both, and the greatest speed: no flank, root or bearing
    /// of one of them bears more. Fewer turns at more speed take a smaller share of the time.
    pub(crate) fn lower(&mut self, other: &Self) {
        let turns = |of: &Self| of.share * of.sun_speed.si().abs();
        let turns = turns(self).min(turns(other));
        self.sun_torque = self.sun_torque.abs().min(other.sun_torque.abs());
        self.sun_speed = self.sun_speed.abs().max(other.sun_speed.abs());
        self.carrier_speed = self.carrier_speed.abs().min(other.carrier_speed.abs());
        let speed = self.sun_speed.si();
        self.share = if speed > 0.0 { turns / speed } else { self.share.min(other.share) };
    }
}

/// A duty with the rest of the time at rest.
pub(crate) fn with_rest(mut duty: Vec<SetStep>) -> Vec<SetStep> {
    let rest = 1.0 - duty.iter().map(|step| step.share).sum::<f64>();
    if rest > WHOLE {
        let (sun_torque, still) = (Torque::default(), AngularVelocity::default());
        duty.push(SetStep { share: rest, sun_torque, sun_speed: still, carrier_speed: still });
    }
    duty
}

/// The greatest torque of the life, and what is required against it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetOverload {
    /// Torque on the sun, without losses; its sign does not matter. A torque of 0 sets no requirement.
    pub sun_torque: Torque,
    /// Required static safety of the flanks.
    pub required_contact: f64,
    /// Required static safety of the roots.
    pub required_root: f64,
}

/// Shifts and tip alterations of sun, planets and ring that are held, in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldShifts {
    /// Profile shift coefficients.
    pub profile: [f64; 3],
    /// Tip alterations; where none are given the tips of the ring are shortened to stay out of the fillets of
    /// the planets.
    pub tips: Option<[f64; 3]>,
}

/// Teeth of a set whose layouts the search makes itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetTeeth {
    /// Sun, planets and ring of a simple set.
    Simple([ToothCount; 3]),
    /// First and second gear of an external pair on fixed axes.
    Pair([ToothCount; 2]),
}

impl SetTeeth {
    /// The gears in the order of the meshes.
    #[must_use]
    pub fn gears(&self) -> &[ToothCount] {
        match self {
            Self::Simple(teeth) => teeth,
            Self::Pair(teeth) => teeth,
        }
    }

    /// Whether the axes of the gears are fixed.
    #[must_use]
    pub const fn is_pair(&self) -> bool {
        matches!(self, Self::Pair(_))
    }

    /// Speed of the sun over that of the carrier with the ring held, `1 + z_r/z_s`; of a pair `z_2/z_1`, by
    /// amount.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        match self {
            Self::Simple([sun, _, ring]) => 1.0 + ring.as_f64() / sun.as_f64(),
            Self::Pair([first, second]) => second.as_f64() / first.as_f64(),
        }
    }
}

/// A set to size.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    /// Teeth of the gears. A pair takes what is said of sun, planets and the first mesh for its two gears and
    /// its mesh; it has no planets, one in [`Space::planets`], and no bearings.
    pub teeth: SetTeeth,
    /// Basic racks and tools of sun, planets and ring.
    pub profiles: Profiles,
    /// Aim that picks the shifts.
    pub aim: Aim,
    /// Shifts that are kept in place of an aim.
    pub held_shifts: Option<HeldShifts>,
    /// Limits for the checks of the geometry.
    pub limits: Limits,
    /// Sun, planets and ring. A rim of the ring is kept; planets have at least theirs.
    pub gears: [Gear; 3],
    /// Methods for both meshes; `K_γ` by the number of planets where it is not given.
    pub methods: [Method; 2],
    /// Viscosity of the oil at 40 °C.
    pub viscosity: KinematicViscosity,
    /// Viscosity of the oil in the bearings, as [`Task::working_viscosity`].
    pub working_viscosity: Option<KinematicViscosity>,
    /// The duty.
    pub duty: Vec<SetStep>,
    /// The overloads.
    pub overloads: Vec<SetOverload>,
    /// Required life of teeth and bearings.
    pub life: Time,
    /// Required safety of the flanks.
    pub required_contact: f64,
    /// Required safety of the roots.
    pub required_root: f64,
    /// Least rim of the planets between root circle and bore, in modules.
    pub planet_rim: f64,
    /// Rim of the ring outside its root circle, in modules.
    pub ring_rim: f64,
    /// Bore of the planets if no bearing is selected.
    pub planet_bore: Option<Length>,
    /// Mass of a planet for the force on its bearing, in place of that of its shape.
    pub planet_mass: Option<Mass>,
    /// Rolling elements and bearings of the planets on their pins.
    pub planet_pin: Pin,
    /// The least angle between neighbouring planets at given angles; `None` if they must be at equal angles.
    pub least_planet_angle: Option<Angle>,
    /// Objective that is minimized.
    pub objective: Objective,
    /// Whether the given `K_Hβ` grows with the face width, as [`Task::widens_face_load`].
    pub widens_face_load: bool,
    /// Limits of usual practice, as [`Task::practice`].
    pub practice: Option<judge::Limits>,
    /// The space.
    pub space: Space,
}

/// The best `most` designs of the space, unless `goes_on`, which is called now and then, breaks.
///
/// # Errors
/// [`Error::NothingToSearch`] for a space without modules, planets or centre distances;
/// [`Error::SpaceTooLarge`]; those of [`natural_centre_distance`] and [`search`].
pub fn size(task: &Sizing, most: usize, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Found, Error> {
    task.space.check()?;
    task.limits.check()?;
    task.profiles.check()?;
    check_shares(task.duty.iter().map(|step| step.share))?;
    for one in &task.overloads {
        positive(Quantity::RequiredSafety, one.required_contact, "")?;
        positive(Quantity::RequiredSafety, one.required_root, "")?;
    }
    let modules_mm = sorted(&task.space.modules);
    let widths_mm = sorted(&task.space.face_widths);
    check_extent(task, &modules_mm, widths_mm.len())?;
    let general = task.general(widths_mm.into_iter().map(Length::from_mm).collect());
    let (layouts, tried) = layouts(task, &modules_mm, &general, goes_on)?;
    if layouts.is_empty() && tried.left_out.total() == 0 {
        return Err(Error::NothingToSearch { quantity: Quantity::CentreDistance });
    }
    search(&general, &layouts, tried, most, goes_on)
}

impl Sizing {
    /// The set as the search sees it: one family, meshes of sun and planets, of planets and ring.
    pub(super) fn general(&self, face_widths: Vec<Length>) -> Task {
        let is_pair = self.teeth.is_pair();
        let gears = self.teeth.gears().len();
        let body = |place: usize| if place == 1 && !is_pair { Body::Planet(0) } else { Body::Central };
        let gear = |place: usize| SizedGear { gear: self.gears[place], body: body(place), family: 0 };
        let planet = SizedPlanet {
            bearings: Arc::clone(&self.space.bearings),
            is_tilted: self.is_helical(),
            bore: self.planet_bore,
            mass: self.planet_mass,
            sharing: None,
            pin: self.planet_pin,
        };
        Task {
            gears: (0..gears).map(gear).collect(),
            meshes: (0..gears - 1)
                .map(|mesh| SizedMesh { gears: [mesh, mesh + 1], method: self.methods[mesh] })
                .collect(),
            planets: if is_pair { vec![] } else { vec![planet] },
            has_one_bearing: false,
            face_widths: vec![face_widths],
            width_ratio: self.space.width_ratio,
            largest_ring: self.space.largest_ring,
            length_price: self.space.length_price,
            viscosity: self.viscosity,
            working_viscosity: self.working_viscosity,
            life: self.life,
            required_contact: self.required_contact,
            required_root: self.required_root,
            planet_rim: self.planet_rim,
            ring_rim: self.ring_rim,
            objective: self.objective,
            least_planet_angle: self.least_planet_angle,
            has_stated_shifts: self.held_shifts.is_some(),
            widens_face_load: self.widens_face_load,
            asks_nearest: true,
            practice: self.practice.clone(),
        }
    }

    /// Whether so many planets of such teeth have equal angles, or those that are given.
    pub(crate) fn assembles(&self, teeth: SetTeeth, planets: u32) -> bool {
        match teeth {
            SetTeeth::Simple([sun, _, ring]) => {
                self.least_planet_angle.is_some()
                    || PlanetSpacing::least_unequal(sun, ring, planets).is_equal()
            }
            SetTeeth::Pair(_) => true,
        }
    }

    pub(crate) fn is_helical(&self) -> bool {
        self.profiles.shared().helix_angle.si() != 0.0
    }

    /// Loads of the meshes, and `K_γ` of the bearings.
    pub(super) fn loads(&self, planets: u32) -> Result<(Arc<[MeshLoads]>, f64), Error> {
        let gears = self.teeth.gears();
        let teeth = [gears[0], gears[1]];
        let none = || MeshLoads { steps: vec![], flanks: vec![], contacts: [1.0; 2], overloads: vec![] };
        let mut both = vec![none(); gears.len() - 1];
        for step in &self.duty {
            let felt = loads(step.sun_torque, step.sun_speed, planets, teeth, self.life)?;
            // A planet passes the torque on, from one flank to the other.
            let torque = step.sun_torque.si();
            let sign = if torque == 0.0 { 0.0 } else { torque.signum() };
            for (own, load) in both.iter_mut().zip(felt) {
                own.flanks.push([sign, -sign]);
                own.steps.push(Step { share: step.share, torque: load.torque, speed: load.speed });
                own.contacts = load.contacts;
            }
        }
        for one in self.overloads.iter().filter(|one| one.sun_torque.si() != 0.0) {
            let felt = loads(one.sun_torque, AngularVelocity::default(), planets, teeth, self.life)?;
            for (own, load) in both.iter_mut().zip(felt) {
                let SetOverload { required_contact, required_root, .. } = *one;
                own.overloads.push(StaticDemand { torque: load.torque, required_contact, required_root });
            }
        }
        let given = self.methods[0].given.of(Side::First, Symbol::LoadSharing);
        let sharing = given.map_or_else(|| load_sharing(planets, self.methods[0].floating), Ok)?;
        Ok((both.into(), sharing))
    }

    /// Forces on the bearing of a planet, by the formulas of the [module](super).
    fn bearing_loads(&self, planets: u32, radius: Length, pairs: &[Pair]) -> Vec<Vec<PlanetStep>> {
        let (SetTeeth::Simple(teeth), [outer, inner]) = (self.teeth, pairs) else { return vec![] };
        let [sun, planet, ring] = teeth.map(ToothCount::as_f64);
        let each = f64::from(planets) * radius.si() * sun;
        let module = radius / outer.centre_distance();
        let lever = f64::from(planets) * module * outer.gears()[0].reference_diameter() / 2.0;
        let meshes = [outer, inner];
        let [outer, inner] = meshes.map(|pair| libm::tan(pair.working_angle_rad()));
        let step = |step: &SetStep| {
            let torque = step.sun_torque.si().abs();
            let [first, second] = [sun + planet, ring - planet].map(|teeth| torque * teeth / each);
            // The planet passes the force at its reference cylinder on from sun to ring.
            let axial = axial_forces(meshes, module, [step.sun_torque.abs() / lever; 2]);
            PlanetStep {
                share: step.share,
                tangential: Force::from_si(first + second),
                radial: Force::from_si(first * outer - second * inner),
                moment: [Torque::default(), axial.tilting_moment],
                of_widths: vec![],
                carrier_speed: step.carrier_speed,
                speed: step.sun_speed.abs() * (sun / planet),
            }
        };
        let still = AngularVelocity::default();
        let loading = self.overloads.iter().filter(|one| one.sun_torque.si() != 0.0);
        let overload = |one: &SetOverload| {
            let SetOverload { sun_torque, .. } = *one;
            step(&SetStep { share: 0.0, sun_torque, sun_speed: still, carrier_speed: still })
        };
        vec![self.duty.iter().map(step).chain(loading.map(overload)).collect()]
    }

    /// Layouts with one module and number of planets, whose gears are those of this set whatever its loads.
    pub(crate) fn geometries(&self, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Vec<Layout>, Error> {
        let modules_mm = sorted(&self.space.modules);
        Ok(layouts(self, &modules_mm, &self.general(self.space.face_widths.clone()), goes_on)?.0)
    }

    /// The best design of layouts that have the gears of this set, under its own loads.
    pub(crate) fn best_of(
        &self,
        geometries: &[Layout],
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Design>, Error> {
        let Some(first) = geometries.first() else { return Ok(None) };
        let (loads, _) = self.loads(first.planets)?;
        let loaded = |own: &Layout| Layout {
            loads: Arc::clone(&loads),
            bearing_loads: self.bearing_loads(own.planets, own.radii[0], &own.pairs),
            ..own.clone()
        };
        let layouts: Vec<Layout> = geometries.iter().map(loaded).collect();
        let task = self.general(self.space.face_widths.clone());
        Ok(search(&task, &layouts, Tried::default(), 1, goes_on)?.found.into_iter().next())
    }
}

/// Lengths in mm, ascending and each once.
fn sorted(lengths: &[Length]) -> Vec<f64> {
    let mut all: Vec<f64> = lengths.iter().map(|length| length.mm()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

impl Space {
    /// Refuses a space of nothing.
    ///
    /// # Errors
    /// [`Error::NothingToSearch`] without modules, face widths or planets; [`Error::NotPositive`] and
    /// [`Error::Negative`] for a quantity.
    pub fn check(&self) -> Result<(), Error> {
        for (quantity, lengths) in
            [(Quantity::Module, &self.modules), (Quantity::FaceWidth, &self.face_widths)]
        {
            if lengths.is_empty() {
                return Err(Error::NothingToSearch { quantity });
            }
            for length in lengths {
                positive(quantity, length.mm(), "mm")?;
            }
        }
        if self.planets.is_empty() {
            return Err(Error::NothingToSearch { quantity: Quantity::Planets });
        }
        positive(Quantity::CentreDistanceStep, self.centre_distance_step.mm(), "mm")?;
        not_negative(Quantity::CentreDistanceReach, self.reach, "modules")?;
        if let Some(ratio) = self.width_ratio {
            positive(Quantity::WidthRatio, ratio, "")?;
        }
        if let Some(ring) = self.largest_ring {
            positive(Quantity::LargestRing, ring.mm(), "mm")?;
        }
        Ok(())
    }
}

/// The centre distances of a module, in modules.
fn centres(task: &Sizing, natural: f64, module_mm: f64) -> Vec<f64> {
    let step = task.space.centre_distance_step.mm() / module_mm;
    let first = ((natural - task.space.reach) / step - EDGE).ceil() as i64;
    let last = ((natural + task.space.reach) / step + EDGE).floor() as i64;
    (first..=last).map(|count| count as f64 * step).collect()
}

/// Centre distances with face widths that are searched at most: a search then ends within minutes.
const MOST: u32 = 300_000;

/// Refuses a space of more centre distances and face widths than a search holds.
pub(super) fn check_extent(task: &Sizing, modules_mm: &[f64], widths: usize) -> Result<(), Error> {
    let step_mm = task.space.centre_distance_step.mm();
    let of_module = |module_mm: &f64| match task.held_shifts {
        Some(_) => 1.0,
        None => (2.0 * task.space.reach * module_mm / step_mm).max(1.0),
    };
    let centres: f64 = modules_mm.iter().map(of_module).sum();
    let count = centres * (task.space.planets.len() * widths) as f64;
    if count <= f64::from(MOST) { Ok(()) } else { Err(Error::SpaceTooLarge { count, most: MOST }) }
}

/// The set with shifts that are held; `None` where they leave no gears or have a fault.
fn held(task: &Sizing, planets: u32) -> Option<Result<PlanetSet, Check>> {
    let (Some(shifts), SetTeeth::Simple([sun, planet, ring])) = (task.held_shifts, task.teeth) else {
        return None;
    };
    let Profiles(profiles) = task.profiles;
    let tips = shifts.tips.unwrap_or_default();
    let gear = |kind, teeth, place: usize| {
        InvoluteGear::new(kind, teeth, profiles[place], shifts.profile[place])?
            .with_tip_alteration(tips[place])
    };
    let set = || {
        let sun = gear(GearKind::External, sun, 0)?;
        let planet = gear(GearKind::External, planet, 1)?;
        let ring = gear(GearKind::Internal, ring, 2)?;
        let centre = Pair::without_backlash(sun, planet)?.centre_distance();
        let set = PlanetSet::new([sun, planet, ring], planets, centre)?;
        if shifts.tips.is_some() { Ok(set) } else { set.with_clear_ring_tips() }
    };
    let set = set().ok()?;
    // A search chooses shifts at a limit less its rounding; stated in a file they have another rounding.
    let fault = set.faults(&task.limits).into_iter().find(|fault| !fault.nearly_holds());
    Some(fault.map_or(Ok(set), Err))
}

/// Whether planets at stated angles touch: the set itself knows them as near to equal angles as they
/// assemble.
fn do_touch(task: &Sizing, set: &PlanetSet) -> bool {
    let planet =
        TipCircle { centre_radius: set.centre_distance(), tip_radius: set.gears()[1].tip_diameter() / 2.0 };
    task.least_planet_angle
        .is_some_and(|angle| !is_clear(planet.gap(planet, angle.si()), task.limits.planet_gap))
}

/// Gears and meshes at a centre distance, in modules.
struct Made {
    gears: Vec<InvoluteGear>,
    pairs: Vec<Pair>,
    centre: f64,
    is_aim_met: bool,
    do_touch: bool,
}

impl Made {
    fn of_set(task: &Sizing, set: &PlanetSet, is_aim_met: bool) -> Self {
        Self {
            gears: set.gears().into_iter().copied().collect(),
            pairs: vec![*set.sun_mesh(), *set.ring_mesh()],
            centre: set.centre_distance(),
            is_aim_met,
            do_touch: do_touch(task, set),
        }
    }
}

/// The gears at a centre distance, or with the shifts that are held; otherwise the check that fails, if there
/// are gears at all.
fn made(task: &Sizing, planets: u32, centre: Option<f64>) -> Result<Made, Option<Check<String>>> {
    let named = |fault: Check| fault.at(fault.place.to_string());
    match (task.teeth, centre) {
        (SetTeeth::Simple(teeth), Some(centre)) => {
            let chosen = Family::new(teeth, planets, task.profiles, centre)
                .and_then(|family| family.choose(task.aim, &task.limits));
            let chosen = chosen.map_err(|error| match error {
                epicyclic_gears::Error::NoShifts { fault, .. } => Some(named(fault)),
                _ => None,
            })?;
            Ok(Made::of_set(task, &chosen.set, chosen.limited_by.is_none()))
        }
        (SetTeeth::Pair(teeth), Some(distance)) => {
            let Profiles(profiles) = task.profiles;
            let gear = |place: usize| {
                InvoluteGear::searched(GearKind::External, teeth[place], profiles[place]).map_err(|_| None)
            };
            let tree =
                MeshTree::new(vec![gear(0)?, gear(1)?], vec![StatedDistance { gears: [0, 1], distance }])
                    .map_err(|_| None)?;
            let chosen = tree.choose(task.aim, &task.limits).map_err(|why| match why {
                NoShifts::Fault(fault) => Some(fault.at("the pair".to_owned())),
                NoShifts::Refused(_) => None,
            })?;
            let Chosen { gears, pairs, is_aim_met } = chosen;
            Ok(Made { gears, pairs, centre: distance, is_aim_met, do_touch: false })
        }
        (_, None) => match held(task, planets) {
            Some(Ok(set)) => Ok(Made::of_set(task, &set, true)),
            Some(Err(fault)) => Err(Some(named(fault))),
            None => Err(None),
        },
    }
}

/// The gears at every centre distance of the space, and how many were left out.
pub(super) fn layouts(
    task: &Sizing,
    modules_mm: &[f64],
    general: &Task,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(Vec<Layout>, Tried), Error> {
    let natural = match task.teeth {
        SetTeeth::Simple(teeth) => natural_centre_distance(teeth, *task.profiles.shared())?,
        SetTeeth::Pair(teeth) => {
            let sum: f64 = teeth.into_iter().map(ToothCount::as_f64).sum();
            sum / (2.0 * libm::cos(task.profiles.shared().helix_angle.si()))
        }
    };
    let designs = general.designs_of_layout();
    let (mut all, mut tried) = (vec![], Tried::default());
    for &planets in &task.space.planets {
        let shared = match task.loads(planets) {
            Ok(shared) => Some(shared),
            // More planets than the table of load sharing has.
            Err(Error::MissingFactor { symbol: Symbol::LoadSharing, .. }) if task.space.planets.len() > 1 => {
                None
            }
            Err(error) => return Err(error),
        };
        let is_placed = task.assembles(task.teeth, planets);
        for &module_mm in modules_mm {
            let module = Length::from_mm(module_mm);
            let wanted: Vec<Option<f64>> = match task.held_shifts {
                Some(_) => vec![None],
                None => centres(task, natural, module_mm).into_iter().map(Some).collect(),
            };
            let Some((loads, sharing)) = &shared else {
                tried.left_out.not_calculable += wanted.len() as u64 * designs;
                continue;
            };
            if !is_placed {
                tried.left_out.spacing += wanted.len() as u64 * designs;
                continue;
            }
            let all_made = map_while(&wanted, goes_on, |centre| made(task, planets, *centre));
            tried.geometries += wanted.len() as u64;
            for made in all_made.ok_or(Error::Cancelled)? {
                match made {
                    Ok(made) if made.do_touch => tried.left_out.planets_touch += designs,
                    Ok(Made { gears, pairs, centre, is_aim_met, .. }) => {
                        let radius = module * centre;
                        let bearing_loads = task.bearing_loads(planets, radius, &pairs);
                        all.push(Layout {
                            planets,
                            modules: vec![module],
                            gears: gears.into(),
                            pairs: pairs.into(),
                            radii: vec![radius],
                            is_aim_met,
                            loads: Arc::clone(loads),
                            sharing: *sharing,
                            bearing_loads,
                        });
                    }
                    Err(Some(fault)) => tried.leave_out(&fault, designs),
                    Err(None) => tried.left_out.geometry += designs,
                }
            }
        }
    }
    Ok((all, tried))
}
