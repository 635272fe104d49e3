//! Vibration of the simple sets of a gearbox: natural frequencies and modes, excitation, resonances, and
//! forces over the speed.
//!
//! | module | is |
//! |---|---|
//! | [`records`] | modes, orders, resonances |
//! | `settled` | speeds and excitation from options or from the file |
//! | `prepared` | a set of a file as bodies and springs |
//! | `orders` | orders of excitation of a set in a gear |
//! | `spacing` | places of the planets |
//! | `links` | a gearbox in a gear as links, sets and shafts |
//! | `torsional` | torsional model of all sets on the links of a gear, with its excitation |
//! | `coupled` | planar model of all sets on the links of a gear |
//! | [`train_records`] | records of the vibration of a whole gearbox |
//! | `shapes` | motion of the bodies in a mode |
//! | `branches` | natural frequencies over the speed, and their resonances |
//! | `response` | mesh forces caused by transmission errors, over the speed |
//!
//! Each set is calculated separately, in its plane, on its supports; sets with helical teeth are left out. A
//! member whose link is held in a gear does not rotate, or rotates against its tangential support. Any other
//! member can rotate freely.

mod branches;
mod coupled;
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
use crate::shared::exciting::Exciting;
use crate::shared::fault::Named;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::simple_sets;
use crate::tolerance::rounded;
use crate::vibrate::options::Request;
use branches::Branches;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_pictures::modes::Part;
use epicyclic_train::{self as train, Gear, LinkId, PlanetSet};
use epicyclic_units::Physical;
use epicyclic_vibration::{Group, Model, SetParts, SpringId};
use links::{Train, TrainSet};
use prepared::{Of, Prepared};
use records::{
    Campbell, KineticShares, Mode, NotCalculated, Order, Reason, Resonance, Response, SetModes, StrainShares,
    What,
};
use response::Excited;
use schemars::JsonSchema;
use serde::Serialize;
use settled::Settled;
use std::ops::ControlFlow;
use train_records::{CoupledModes, TorsionalModes};

/// Natural frequencies and modes of the simple sets of a gearbox, torsional ones of the whole gearbox, and
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
    /// data.
    pub torsional: Vec<TorsionalModes>,
    /// Modes of the whole gearbox in the plane in each gear; empty unless requested.
    pub coupled: Vec<CoupledModes>,
    /// Results that are not calculated, with the reasons.
    pub not_calculated: Vec<NotCalculated>,
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
/// - [`Error::NoGear`]; [`Error::NoSet`]; [`Error::NothingVibrates`] if no set has enough data; errors of
///   [`Settled::of`].
/// - [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn answer(
    subject: &Gearbox,
    request: &Request,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vibration, Error> {
    let found = vibrating(subject, request, goes_on)?;
    if found.sets.is_empty() && found.torsional.is_empty() {
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
    if file.sets.iter().all(|set| set.vibration.is_none()) {
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
        warnings: warnings::of_gearbox(subject),
    };
    let train = Train::new(subject, &file)?;
    let mut in_train: Vec<TrainSet<'_>> = vec![];
    for (place, (set, simple)) in simple_sets(subject, &file).enumerate() {
        if request.set.as_ref().is_some_and(|name| name != set.id()) {
            continue;
        }
        let mut without = |gear: Option<&str>, what, reason, missing| {
            let (set, gear) = (set.id().to_owned(), gear.map(str::to_owned));
            all.not_calculated.push(NotCalculated { set, gear, what, reason, missing });
        };
        let Some((path, entry, spec)) = simple else {
            without(None, What::Modes, Reason::NotSimple, vec![]);
            continue;
        };
        if spec.is_helical() {
            without(None, What::Modes, Reason::Helical, vec![]);
            continue;
        }
        let of = Of { subject, file: &file, path, entry, spec, set };
        let prepared = match of.prepared()? {
            Ok(prepared) => prepared,
            Err(missing) => {
                without(None, What::Modes, Reason::KeysMissing, missing);
                continue;
            }
        };
        if prepared.teeth.is_some() && prepared.spacing.places.is_empty() {
            without(None, What::Modes, Reason::UnequalPlanets, vec![]);
            continue;
        }
        of.check_supports(&prepared)?;
        let is_elastic = |member| prepared.is_elastic(member);
        for (held, names) in holdings(gearbox, set, &gears, is_elastic, |gear| {
            without(Some(gear), What::Modes, Reason::DoesNotRoll, vec![]);
        }) {
            let found = match Found::of(&of, &prepared, held)? {
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
            all.sets.push(found.told(&of, &prepared, held, names)?);
        }
        in_train.push(TrainSet { of, set, prepared });
    }
    if in_train.len() == gearbox.sets().len() {
        for gear in gears {
            match torsional::modes(&train, gear, &in_train, &settled)? {
                Ok(modes) => all.torsional.push(modes),
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
    let set = of.entry.id.clone();
    let analysis = analysis(&of.subject.train, gear)?;
    let members = &analysis.sets()[place].members;
    let without = |reason, missing| NotCalculated {
        set: set.clone(),
        gear: Some(gear.to_owned()),
        what: What::Resonances,
        reason,
        missing,
    };
    let [Some(sun), Some(ring), Some(carrier)] = members[..] else {
        all.not_calculated.push(without(Reason::NoSpeeds, vec![]));
        return Ok(());
    };
    if sun == carrier {
        all.not_calculated.push(without(Reason::DoesNotRoll, vec![]));
        return Ok(());
    }
    let speeds = &settled.speeds;
    let branches = match Branches::new(found, carrier, speeds, goes_on) {
        Ok(branches) => branches,
        Err(epicyclic_vibration::Error::Unbalanced { .. }) => {
            all.not_calculated.push(without(Reason::Unbalanced, vec![]));
            return Ok(());
        }
        Err(error) => return Err(of.refused(&["vibration"], &error)),
    };
    if let Some(teeth) = prepared.teeth {
        let (planets, is_equal) = (prepared.planets, prepared.is_equally_spaced());
        let of_teeth =
            |harmonics| orders::all(&set, gear, teeth, planets, is_equal, [sun, ring, carrier], harmonics);
        if let Some(excitation) = &settled.excitation {
            let torque = analysis.ideal().and_then(|case| case.members[place].as_ref()?.first().copied());
            let torque = torque.filter(|torque| *torque != 0.0).unwrap_or(sun - carrier);
            let sun_drives = torque * (sun - carrier) >= 0.0;
            let frame = if settled.gyroscopic { carrier * torque.signum() } else { 0.0 };
            let excited =
                Excited { of, prepared, found, teeth, sun_drives, frame, branches: &branches, excitation };
            all.responses.extend(excited.response(&of_teeth(excitation.harmonics()), speeds)?);
        }
        let orders = of_teeth(settled.harmonics);
        for order in &orders {
            let met =
                branches.resonances(found, order).map_err(|error| of.refused(&["vibration"], &error))?;
            all.resonances.extend(met);
        }
        all.orders.extend(orders);
    } else {
        all.not_calculated.push(without(Reason::KeysMissing, vec!["teeth".to_owned()]));
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
        let held: Vec<[bool; 3]> = gears.filter_map(|gear| held_in(gearbox, self.set, gear)).collect();
        for (member, name) in ["sun", "ring", "carrier"].into_iter().enumerate() {
            if prepared.is_elastic(member) && !held.iter().any(|held| held[member]) {
                let message = format!(
                    "a tangential support is what holds the {name} in gears in which a brake or the housing holds it; no gear does: leave it \
                     out, or hold the {name}"
                );
                let why = Named("support-unused", message);
                return Err(self.refused(&["vibration", name, "tangential_support"], &why));
            }
        }
        Ok(())
    }
}

/// Whether sun, ring and carrier of a set are held in a gear, or by permanent connections alone; `None` if
/// two of them are joined otherwise.
fn held_in(gearbox: &train::Gearbox, set: &PlanetSet, gear: Option<&Gear>) -> Option<[bool; 3]> {
    let joined = joined(gearbox, gear, &[]);
    let roots = [0, 1, 2].map(|member| joined[set.members()[member].index()]);
    let held = roots.map(|root| root == LinkId::GROUND.index());
    let are_one = |one: usize, other: usize| roots[one] == roots[other] && !held[one];
    (!are_one(0, 1) && !are_one(1, 2) && !are_one(0, 2)).then_some(held)
}

/// Combinations of held members of a set, with their gears. A gear is reported to `locked` if it joins
/// members, or holds several of them and none elastically.
fn holdings(
    gearbox: &train::Gearbox,
    set: &PlanetSet,
    gears: &[&Gear],
    is_elastic: impl Fn(usize) -> bool,
    mut locked: impl FnMut(&str),
) -> Vec<([bool; 3], Vec<String>)> {
    let mut all: Vec<([bool; 3], Vec<String>)> = vec![];
    if gears.is_empty() {
        return held_in(gearbox, set, None).into_iter().map(|held| (held, vec![])).collect();
    }
    for gear in gears {
        let swings = |held: &[bool; 3]| {
            held.iter().filter(|held| **held).count() < 2
                || (0..3).any(|member| held[member] && is_elastic(member))
        };
        let Some(held) = held_in(gearbox, set, Some(gear)).filter(swings) else {
            locked(gear.name());
            continue;
        };
        let name = gear.name().to_owned();
        match all.iter_mut().find(|(same, _)| *same == held) {
            Some((_, names)) => names.push(name),
            None => all.push((held, vec![name])),
        }
    }
    all
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
    parts: SetParts,
    groups: Vec<Group>,
    built: prepared::Built,
}

impl Found {
    /// Base radius of the sun in m.
    fn sun_radius_m(&self) -> f64 {
        let sun = self.built.bodies.iter().find(|body| body.body == Part::Sun);
        sun.map_or(0.0, |sun| sun.radius_m)
    }

    fn of(of: &Of<'_>, prepared: &Prepared, held: [bool; 3]) -> Result<Result<Self, Vec<String>>, Error> {
        let built = match prepared.built(held) {
            Ok(built) => built,
            Err(missing) => return Ok(Err(missing)),
        };
        let refuse = |error| of.refused(&["vibration"], &error);
        let (model, parts) = built.set.planar().map_err(refuse)?;
        let groups = model.groups(&parts.central()).map_err(refuse)?;
        Ok(Ok(Self { model, parts, groups, built }))
    }

    fn told(
        self,
        of: &Of<'_>,
        prepared: &Prepared,
        held: [bool; 3],
        gears: Vec<String>,
    ) -> Result<SetModes, Error> {
        let mode = |(index, group): (usize, &Group)| {
            let energy =
                self.model.modal_energy(group).map_err(|error| of.refused(&["vibration"], &error))?;
            let of_body = |body| rounded(energy.kinetic_of(body));
            let of_springs = |springs: &[SpringId]| rounded(energy.strain_of(springs));
            let parts = &self.parts;
            let strain = || StrainShares {
                sun_meshes: of_springs(&parts.sun_meshes),
                ring_meshes: of_springs(&parts.ring_meshes),
                planet_bearings: of_springs(&parts.bearings.concat()),
                supports: of_springs(&parts.supports.concat()),
            };
            Ok(Mode {
                mode: number(index),
                kind: group.kind,
                multiplicity: group.multiplicity() as u32,
                frequency_hz: group.frequency.si(),
                kinetic: KineticShares {
                    sun: of_body(parts.sun),
                    ring: of_body(parts.ring),
                    carrier: of_body(parts.carrier),
                    planets: rounded(parts.planets.iter().map(|planet| of_body(*planet)).sum()),
                },
                strain: (!group.is_zero()).then(strain),
                shape: shapes::of(&self, group),
            })
        };
        let modes: Result<Vec<Mode>, Error> = self.groups.iter().enumerate().map(mode).collect();
        let names = [Part::Sun, Part::Ring, Part::Carrier];
        Ok(SetModes {
            set: of.entry.id.clone(),
            gears,
            held: names.into_iter().zip(held).filter(|(_, held)| *held).map(|(name, _)| name).collect(),
            planets: prepared.planets,
            planet_angles_rad: prepared.spacing.angles_rad.clone(),
            equally_spaced: prepared.spacing.is_equal,
            bodies: self.built.bodies,
            stiffness: self.built.stiffness,
            sun_pressure_angle_rad: self.built.set.sun_pressure_angle.si(),
            ring_pressure_angle_rad: self.built.set.ring_pressure_angle.si(),
            modes: modes?,
        })
    }
}

/// Number of a mode, from 1.
fn number(index: usize) -> u32 {
    u32::try_from(index + 1).unwrap_or(u32::MAX)
}
