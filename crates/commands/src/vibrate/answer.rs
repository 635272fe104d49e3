//! Vibration of the sets of a gearbox: natural frequencies and modes, excitation, resonances, and forces over
//! the speed.
//!
//! | module | is |
//! |---|---|
//! | [`records`] | modes, orders, resonances |
//! | `settled` | speeds and excitation from options or from the file |
//! | `prepared` | data of a set of a file |
//! | `assembly` | a set as bodies and springs |
//! | `orders` | orders of excitation of a set in a gear |
//! | `spacing` | places of the planets |
//! | `judged` | judgement of the gearbox with its resonances |
//! | `links` | a gearbox in a gear as links, sets and shafts |
//! | `torsional` | torsional model of all sets on the links of a gear, with its excitation |
//! | `coupled` | planar model of all sets on the links of a gear |
//! | [`train_records`] | records of the vibration of a whole gearbox |
//! | `shapes` | motion of the bodies in a mode |
//! | `branches` | natural frequencies over the speed, and their resonances |
//! | `response` | mesh forces caused by transmission errors, over the speed |
//!
//! Each set is calculated separately, in its plane, on its supports; of helical teeth the stiffness in this
//! plane. A member whose link is held in a gear does not rotate, or rotates against its tangential support.
//! Any other member can rotate freely. The flanks in contact are those that the torques of the gear load;
//! where none load a mesh, those at a positive torque on its first gear. Both directions of load have the
//! same frequencies, as mirror images.

mod assembly;
mod branches;
mod coupled;
mod judged;
mod links;
mod orders;
mod prepared;
pub mod records;
mod response;
mod settled;
mod shapes;
mod spacing;
mod torsional;
pub mod train_records;

use crate::analyze::answer::{analysis, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::basis::Basis;
use crate::shared::exciting::Exciting;
use crate::shared::fault::Named;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::strength::answer::missing::{MissingKeys, Purpose};
use crate::tolerance::{ROUNDED, rounded};
use crate::vibrate::options::Request;
use assembly::{Built, Case};
use branches::Branches;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_train::{self as train, Gear, LinkId, PlanetSet};
use epicyclic_units::Physical;
use epicyclic_vibration::{BodyId, GearSetParts, Group, Model, SpringId};
use links::{Train, TrainSet};
use prepared::{Of, Prepared};
use records::{
    Campbell, Mode, NotCalculated, Order, Reason, Resonance, Response, SetModes, Shares, Stiffnesses, What,
};
use response::Excited;
use schemars::JsonSchema;
use serde::Serialize;
use settled::Settled;
use std::ops::ControlFlow;
use train_records::{CoupledModes, TorsionalModes};

/// Natural frequencies and modes of the sets of a gearbox, torsional ones of the whole gearbox, and
/// excitation at given speeds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Vibration {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Modes of each set, once for all gears that hold the same members.
    pub sets: Vec<SetModes>,
    /// Orders of excitation; empty without speeds.
    pub orders: Vec<Order>,
    /// Resonances within the speeds, in increasing order in each gear; empty without speeds.
    pub resonances: Vec<Resonance>,
    /// Natural frequencies over the speeds; empty without speeds.
    pub campbell: Vec<Campbell>,
    /// Forces caused by transmission errors over the speeds; empty without transmission errors.
    pub responses: Vec<Response>,
    /// Torsional modes of the whole gearbox in each gear; empty if a single set is requested, or a set lacks
    /// data, which `not_calculated` names.
    pub torsional: Vec<TorsionalModes>,
    /// Modes of the whole gearbox in the plane in each gear; empty unless requested.
    pub coupled: Vec<CoupledModes>,
    /// Results that are not calculated, with the reasons.
    pub not_calculated: Vec<NotCalculated>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the vibration.
    pub warnings: Vec<Warning>,
}

impl Answer for Vibration {
    const NAME: &'static str = "vibrate";
}

/// Computes the vibration of the sets of a gearbox. The closure `goes_on` is called now and then, and may end
/// the calculation.
///
/// # Errors
/// - [`Error::NoGear`]; [`Error::NoSet`]; [`Error::MissingKeys`] or [`Error::NothingVibrates`] if no
///   set has enough data; errors of [`Settled::of`].
/// - [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn answer(
    subject: &Gearbox,
    request: &Request,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vibration, Error> {
    let found = vibrating(subject, request, goes_on)?;
    if found.sets.is_empty() && found.torsional.is_empty() {
        let file: GearboxFile = subject.document.read()?;
        let missing = MissingKeys::of(subject, &file, &Basis::default(), Purpose::Vibration)?;
        let lacks_keys = found.not_calculated.iter().any(|one| one.reason == Reason::KeysMissing);
        if let Some(refused) = missing.refused_of(request.set.as_deref()).filter(|_| lacks_keys) {
            return Err(refused);
        }
        let why = |one: &NotCalculated| {
            let gear = one.gear.as_ref().map_or_else(String::new, |gear| format!(" in gear {gear}"));
            format!("set {}{gear}: {}", one.set, one.why())
        };
        let modes = found.not_calculated.iter().filter(|one| one.what == What::Modes);
        return Err(Error::NothingVibrates { sets: modes.map(why).collect() });
    }
    Ok(found)
}

/// Vibration of a gearbox for a report; `None` if the file has no `vibration` of any set.
///
/// # Errors
/// Errors of [`answer`] except [`Error::NothingVibrates`]: the reasons why sets are not calculated are listed
/// instead.
pub(crate) fn chapter(
    subject: &Gearbox,
    exciting: &Exciting,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Option<Vibration>, Error> {
    if subject.document.value().get("transmissions").is_some() {
        return Ok(None);
    }
    let file: GearboxFile = subject.document.read()?;
    let of_compounds = file.compound_sets.iter().all(|set| set.vibration.is_none());
    if of_compounds && file.sets.iter().all(|set| set.vibration.is_none()) {
        return Ok(None);
    }
    let request = Request { exciting: exciting.clone(), ..Request::default() };
    vibrating(subject, &request, goes_on).map(Some)
}

fn vibrating(
    subject: &Gearbox,
    request: &Request,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vibration, Error> {
    let file: GearboxFile = subject.document.read()?;
    let gearbox = &subject.train;
    let settled = Settled::of(subject, &file, &request.exciting)?;
    subject.check_set(request.set.as_deref())?;
    if let Some(name) = &request.gear {
        analysis(gearbox, name)?;
    }
    let is_included = |gear: &&Gear| request.gear.as_ref().is_none_or(|name| name == gear.name());
    let gears: Vec<&Gear> = gearbox.gears().iter().filter(is_included).collect();
    let mut all = Vibration {
        gearbox: gearbox.name().to_owned(),
        sets: vec![],
        orders: vec![],
        resonances: vec![],
        campbell: vec![],
        responses: vec![],
        torsional: vec![],
        coupled: vec![],
        not_calculated: vec![],
        judgement: Judgement::default(),
        warnings: warnings::of_gearbox(subject),
    };
    let train = Train::new(subject, &file)?;
    let mut in_train: Vec<TrainSet<'_>> = vec![];
    for (place, set) in gearbox.sets().iter().enumerate() {
        if request.set.as_ref().is_some_and(|name| name != set.id()) {
            continue;
        }
        let Some(data) = file.set_data(set) else { continue };
        let mut without = |gear: Option<&str>, what, reason, missing| {
            let (set, gear) = (set.id().to_owned(), gear.map(str::to_owned));
            all.not_calculated.push(NotCalculated { set, gear, what, reason, missing });
        };
        let of = Of { subject, file: &file, data, set };
        let prepared = match of.prepared()? {
            Ok(prepared) => prepared,
            Err((reason, missing)) => {
                without(None, What::Modes, reason, missing);
                continue;
            }
        };
        of.check_supports(&prepared)?;
        for (case, names) in cases(&of, place, &gears, &prepared, |gear| {
            without(Some(gear), What::Modes, Reason::DoesNotRoll, vec![]);
        })? {
            let found = match Found::of(&of, &prepared, case)? {
                Ok(found) => found,
                Err(missing) => {
                    let before =
                        all.not_calculated.iter().any(|one| one.set == set.id() && one.missing == missing);
                    if !before {
                        let set = set.id().to_owned();
                        let (what, reason) = (What::Modes, Reason::KeysMissing);
                        all.not_calculated.push(NotCalculated { set, gear: None, what, reason, missing });
                    }
                    continue;
                }
            };
            if !settled.speeds.is_empty() {
                for gear in &names {
                    over_speeds(&of, &prepared, &found, (place, gear), (&settled, goes_on), &mut all)?;
                }
            }
            all.sets.push(found.told(&of, &prepared, names)?);
        }
        in_train.push(TrainSet { of, place, prepared });
    }
    if request.set.is_none() && !in_train.is_empty() {
        let lacks = |one: &&NotCalculated| one.what == What::Modes && one.gear.is_none();
        let is_left_out = |one: &&NotCalculated| in_train.iter().all(|own| own.of.set.id() != one.set);
        let lacking: Vec<NotCalculated> =
            all.not_calculated.iter().filter(lacks).filter(is_left_out).cloned().collect();
        // The whole gearbox needs every set.
        let models = [Some(What::Torsional), request.exciting.coupled.then_some(What::Coupled)];
        for what in models.into_iter().flatten() {
            all.not_calculated.extend(lacking.iter().map(|one| NotCalculated { what, ..one.clone() }));
        }
    }
    if in_train.len() == gearbox.sets().len() {
        for gear in gears {
            match torsional::modes(&train, gear, &in_train, &settled)? {
                Ok((modes, warning)) => {
                    all.torsional.push(modes);
                    all.warnings.extend(warning);
                }
                Err(missing) => all.not_calculated.push(missing),
            }
            if request.exciting.coupled {
                match coupled::modes(&train, gear, &in_train)? {
                    Ok(modes) => all.coupled.push(modes),
                    // A reason that applies to all gears is listed once.
                    Err(missing) if all.not_calculated.contains(&missing) => {}
                    Err(missing) => all.not_calculated.push(missing),
                }
            }
        }
    }
    all.judgement = judged::of(subject, request.set.as_deref(), &file, &all, !settled.speeds.is_empty());
    all.judgement.add_to(&mut all.warnings);
    Ok(all)
}

/// Orders, resonances and branches of a set in a gear.
fn over_speeds(
    of: &Of<'_>,
    prepared: &Prepared,
    found: &Found,
    (place, gear): (usize, &str),
    (settled, goes_on): (&Settled, &dyn Fn() -> ControlFlow<()>),
    all: &mut Vibration,
) -> Result<(), Error> {
    let set = of.set.id().to_owned();
    let analysis = analysis(&of.subject.train, gear)?;
    let members = &analysis.sets()[place].members;
    let without = |what, reason, missing| NotCalculated {
        set: set.clone(),
        gear: Some(gear.to_owned()),
        what,
        reason,
        missing,
    };
    let Some(members) = members.iter().copied().collect::<Option<Vec<f64>>>() else {
        all.not_calculated.push(without(What::Resonances, Reason::NoSpeeds, vec![]));
        return Ok(());
    };
    let carrier = members[of.set.centrals().len()];
    let first = members[0];
    if first == carrier {
        all.not_calculated.push(without(What::Resonances, Reason::DoesNotRoll, vec![]));
        return Ok(());
    }
    let speeds = &settled.speeds;
    let branches = match Branches::new(found, carrier, speeds, goes_on) {
        Ok(branches) => branches,
        Err(epicyclic_vibration::Error::Unbalanced { .. }) => {
            all.not_calculated.push(without(What::Resonances, Reason::Unbalanced, vec![]));
            return Ok(());
        }
        Err(error) => return Err(of.refused(&["vibration"], &error)),
    };
    if !prepared.teeth.is_empty() {
        let of_teeth = |harmonics| orders::all(of, prepared, gear, &members, (harmonics, settled.fastest()));
        if let Some(excitation) = &settled.excitation {
            let side = of.flanks(place, prepared, Some(gear))?.side.unwrap_or((first - carrier).signum());
            let seen: Vec<f64> = members.iter().map(|speed| speed * side).collect();
            let frame = if settled.gyroscopic { carrier * side } else { 0.0 };
            let excited =
                Excited { of, prepared, found, speeds: seen, frame, branches: &branches, excitation };
            let orders = of_teeth(excitation.harmonics());
            let unknown = orders.iter().filter(|one| one.order.harmonic == 1 && !one.meshes.is_empty());
            for one in unknown.filter(|one| !excited.knows_phases(one)) {
                let meshes = one.meshes.iter().map(|mesh| prepared.meshes[*mesh].name.clone()).collect();
                all.not_calculated.push(without(What::Forces, Reason::PhasesUnknown, meshes));
            }
            all.responses.extend(excited.response(&orders, speeds)?);
        }
        for phased in of_teeth(settled.harmonics) {
            let met = branches
                .resonances(found, &phased.order)
                .map_err(|error| of.refused(&["vibration"], &error))?;
            all.resonances.extend(met);
            all.orders.push(phased.order);
        }
    } else {
        all.not_calculated.push(without(What::Resonances, Reason::KeysMissing, vec!["teeth".to_owned()]));
    }
    let of_gear = |one: &Resonance| one.gear == gear && one.set == set;
    let first = all.resonances.iter().position(of_gear).unwrap_or(all.resonances.len());
    all.resonances[first..].sort_by(|a, b| a.input_speed_rad_s.total_cmp(&b.input_speed_rad_s));
    all.campbell.push(branches.told(&set, gear, carrier));
    Ok(())
}

impl Of<'_> {
    /// Refuses a tangential support of a member that no gear holds, because nothing would use it.
    fn check_supports(&self, prepared: &Prepared) -> Result<(), Error> {
        let gearbox = &self.subject.train;
        let gears = gearbox.gears().iter().map(Some).chain(gearbox.gears().is_empty().then_some(None));
        let held: Vec<Vec<bool>> = gears.filter_map(|gear| held_in(gearbox, self.set, gear)).collect();
        for (member, one) in prepared.members.iter().enumerate() {
            if prepared.is_elastic(member) && !held.iter().any(|held| held[member]) {
                let name = &one.name;
                let message = format!(
                    "a tangential support is what holds the {name} in gears in which a brake or the housing holds it; no gear does: leave it \
                     out, or hold the {name}"
                );
                let why = Named("support-unused", message);
                let keys = self.data.vibration.as_ref().map_or_else(Vec::new, |one| one.keys_of(name));
                return Err(self.refused(&[&keys[..], &["tangential_support"]].concat(), &why));
            }
        }
        Ok(())
    }

    /// Flanks that the torques in a gear load; of a mesh without load, those by which its first gear drives
    /// in the positive direction.
    fn flanks(&self, place: usize, prepared: &Prepared, gear: Option<&str>) -> Result<Flanks, Error> {
        let analysis = gear.map(|gear| analysis(&self.subject.train, gear)).transpose()?;
        let case = analysis.as_ref().and_then(|analysis| analysis.ideal());
        let torques = case.and_then(|case| case.members[place].clone());
        let loaded = torques.and_then(|torques| self.set.mesh_torques(&torques));
        let is_loaded = |torques: &[[f64; 2]]| torques.iter().any(|mesh| mesh[0].abs() > ROUNDED);
        // Without load: a torque on the first central gear, which the second balances.
        let usual = || {
            let mut torques = vec![0.0; self.set.centrals().len()];
            torques[0] = 1.0;
            torques[1] = -self.set.ratio_between(0, 1);
            self.set.mesh_torques(&torques)
        };
        let loaded = loaded.filter(|torques| is_loaded(torques));
        let is_known = loaded.is_some();
        let Some(torques) = loaded.or_else(usual) else {
            return Ok(Flanks { forward: vec![true; prepared.meshes.len()], side: None });
        };
        let first = |mesh: usize| {
            let gears = self.set.gears_of_mesh(mesh);
            // The torque of the mesh on the gear is against what drives it.
            let end = usize::from(gears[0] != prepared.meshes[mesh].gears[0].0);
            -torques[mesh][end]
        };
        let driving: Vec<f64> = (0..torques.len()).map(first).collect();
        let is_mirrored = driving.iter().find(|torque| torque.abs() > ROUNDED).is_some_and(|one| *one < 0.0);
        let is_forward = |torque: f64| if is_mirrored { torque <= ROUNDED } else { torque >= -ROUNDED };
        let forward = driving.into_iter().map(is_forward).collect();
        Ok(Flanks { forward, side: is_known.then_some(if is_mirrored { -1.0 } else { 1.0 }) })
    }
}

/// Loaded flanks of a set in a gear.
struct Flanks {
    /// Whether the first gear of each mesh drives in the positive direction, seen from the side from which
    /// that of the first loaded mesh does. A mirror image has the same frequencies.
    forward: Vec<bool>,
    /// 1 if this is the positive side of the axis, −1 if not; `None` if the torques are not known.
    side: Option<f64>,
}

/// Whether the members of a set are held in a gear, or by permanent connections alone; `None` if two of them
/// are joined otherwise.
fn held_in(gearbox: &train::Gearbox, set: &PlanetSet, gear: Option<&Gear>) -> Option<Vec<bool>> {
    let joined = joined(gearbox, gear, &[]);
    let roots: Vec<usize> = set.members().iter().map(|member| joined[member.index()]).collect();
    let held: Vec<bool> = roots.iter().map(|root| *root == LinkId::GROUND.index()).collect();
    let is_joined = |place: usize| !held[place] && roots[..place].contains(&roots[place]);
    (!(0..roots.len()).any(is_joined)).then_some(held)
}

/// Combinations of held members and loaded flanks of a set, with their gears. A gear is reported to `locked`
/// if it joins members, or holds several of them and none elastically.
fn cases(
    of: &Of<'_>,
    place: usize,
    gears: &[&Gear],
    prepared: &Prepared,
    mut locked: impl FnMut(&str),
) -> Result<Vec<(Case, Vec<String>)>, Error> {
    let gearbox = &of.subject.train;
    let mut all: Vec<(Case, Vec<String>)> = vec![];
    if gears.is_empty() {
        if let Some(held) = held_in(gearbox, of.set, None) {
            all.push((Case { held, forward: of.flanks(place, prepared, None)?.forward }, vec![]));
        }
        return Ok(all);
    }
    for gear in gears {
        let swings = |held: &Vec<bool>| {
            held.iter().filter(|held| **held).count() < 2
                || (0..held.len()).any(|member| held[member] && prepared.is_elastic(member))
        };
        let Some(held) = held_in(gearbox, of.set, Some(gear)).filter(swings) else {
            locked(gear.name());
            continue;
        };
        let case = Case { held, forward: of.flanks(place, prepared, Some(gear.name()))?.forward };
        let name = gear.name().to_owned();
        match all.iter_mut().find(|(same, _)| *same == case) {
            Some((_, names)) => names.push(name),
            None => all.push((case, vec![name])),
        }
    }
    Ok(all)
}

/// Representative of each link in a gear, by [`LinkId::index`]: the first of the links that turn as one piece
/// with it. Connections that are springs do not count.
fn joined(gearbox: &train::Gearbox, gear: Option<&Gear>, springs: &[[LinkId; 2]]) -> Vec<usize> {
    let mut roots: Vec<usize> = (0..gearbox.links().len()).collect();
    let engaged = gear.map_or(&[][..], Gear::engaged).iter();
    let engaged = engaged.map(|&place| gearbox.shift_elements()[place].links());
    let is_rigid = |tie: &&[LinkId; 2]| !springs.iter().any(|spring| links::is_same(**tie, *spring));
    let rigid = gearbox.permanent().iter().filter(is_rigid).copied();
    for [first, second] in rigid.chain(engaged) {
        let [one, other] = [first, second].map(|link| roots[link.index()]);
        let (low, high) = (one.min(other), one.max(other));
        roots.iter_mut().filter(|root| **root == high).for_each(|root| *root = low);
    }
    roots
}

/// Solved set in some gears.
struct Found {
    model: Model,
    parts: GearSetParts,
    groups: Vec<Group>,
    built: Built,
    held: Vec<bool>,
}

impl Found {
    fn of(of: &Of<'_>, prepared: &Prepared, case: Case) -> Result<Result<Self, Vec<String>>, Error> {
        let built = match prepared.built(&case) {
            Ok(built) => built,
            Err(missing) => return Ok(Err(missing)),
        };
        let refuse = |error| of.refused(&["vibration"], &error);
        let (model, parts) = built.set.planar().map_err(refuse)?;
        let groups = model.groups(&parts.members).map_err(refuse)?;
        Ok(Ok(Self { model, parts, groups, built, held: case.held }))
    }

    fn told(self, of: &Of<'_>, prepared: &Prepared, gears: Vec<String>) -> Result<SetModes, Error> {
        let copies = prepared.copies();
        let mode = |(index, group): (usize, &Group)| {
            let energy =
                self.model.modal_energy(group).map_err(|error| of.refused(&["vibration"], &error))?;
            let of_bodies = |bodies: &[BodyId]| {
                rounded(bodies.iter().map(|body| rounded(energy.kinetic_of(*body))).sum())
            };
            let of_springs = |springs: &[SpringId]| rounded(energy.strain_of(springs));
            let parts = &self.parts;
            let members = prepared.members.iter().zip(&parts.members);
            let members = members.map(|(one, body)| (key(&one.name), rounded(energy.kinetic_of(*body))));
            let kinds = prepared.planet_kinds.iter().zip(parts.planets.chunks(copies));
            let is_only = prepared.planet_kinds.len() == 1;
            let planets = kinds.map(|(kind, bodies)| {
                let name = if is_only { "planets".to_owned() } else { key(&kind.name) };
                (name, of_bodies(bodies))
            });
            let strain = || {
                let meshes = prepared.meshes.iter().enumerate().map(|(place, mesh)| {
                    let name = if of.set.is_pair() { "mesh".to_owned() } else { key(&mesh.name) + "_meshes" };
                    (name, of_springs(&prepared.of_mesh(&parts.meshes, place)))
                });
                let has_bearings = !parts.bearings.is_empty();
                let bearings = ("planet_bearings".to_owned(), of_springs(&parts.bearings.concat()));
                let supports = ("supports".to_owned(), of_springs(&parts.supports.concat()));
                Shares(meshes.chain(has_bearings.then_some(bearings)).chain([supports]).collect())
            };
            Ok(Mode {
                mode: number(index),
                kind: group.kind,
                multiplicity: group.multiplicity() as u32,
                frequency_hz: group.frequency.si(),
                kinetic: Shares(members.chain(planets).collect()),
                strain: (!group.is_zero()).then(strain),
                shape: shapes::of(&self, prepared, group),
            })
        };
        let modes: Result<Vec<Mode>, Error> = self.groups.iter().enumerate().map(mode).collect();
        let meshes = &self.built.springs[..prepared.meshes.len()];
        let pressure_angle = |mesh: usize| {
            meshes.get(mesh).filter(|_| prepared.is_simple()).and_then(|mesh| mesh.pressure_angle_rad)
        };
        let held = prepared.members.iter().zip(&self.held).filter(|(_, held)| **held);
        Ok(SetModes {
            set: of.set.id().to_owned(),
            gears,
            held: held.map(|(member, _)| member.name.clone()).collect(),
            planets: prepared.planets,
            planet_angles_rad: prepared.spacing.angles_rad.clone(),
            equally_spaced: prepared.spacing.is_equal,
            bodies: self.built.bodies,
            stiffness: Stiffnesses::of(&self.built.springs).filter(|_| prepared.is_simple()),
            sun_pressure_angle_rad: pressure_angle(0),
            ring_pressure_angle_rad: pressure_angle(1),
            springs: self.built.springs,
            modes: modes?,
        })
    }
}

/// Name of a part as a key of an answer.
fn key(name: &str) -> String {
    name.replace(' ', "_")
}

/// Number of a mode, from 1.
fn number(index: usize) -> u32 {
    u32::try_from(index + 1).unwrap_or(u32::MAX)
}
