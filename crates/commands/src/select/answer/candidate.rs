//! A mechanism with its figures, and what the criteria say of it.

use super::duty::Duty;
use super::required::{Objective, finite};
use crate::error::Error;
use crate::shared::catalogue::{GearName, Link, SetLinks, SetSpeeds, ShiftElement};
use crate::shared::number::{plain, si};
use crate::tolerance::ROUNDED;
use epicyclic_schemes::catalogue::{Reach as RatioReach, Scheme};
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::Family;
use epicyclic_selection::drawing::{DRAWN_K, drawable_direct_clutches};
use epicyclic_selection::{self as selection, Evidence, Mechanism, NotDrawable, Requirements};
use epicyclic_train::{Gearbox, InputLoad, Operation};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Torque};

/// A mechanism measured and judged; speeds and torques without a unit are multiples of the input's.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Candidate {
    /// Its place among all candidates, from 1.
    pub no: u32,
    /// The source's name of the scheme; `null` where it has none.
    pub scheme: Option<&'static str>,
    /// Name of the structure, by the links of sun, ring and carrier of each set.
    pub structure: String,
    /// Why the source has the structure, or lacks it; `null` of a single set.
    pub source: Option<InSource>,
    /// Whether it meets every required criterion.
    pub accepted: bool,
    /// Whether it is non-dominated: no other is better in one objective and worse in none.
    pub non_dominated: bool,
    /// The objective that puts it behind the first; `null` of the first, of its equals, and of the rejected.
    pub behind_by: Option<Objective>,
    /// Whether the output turns in mixed directions: backward in a braked gear, forward in direct drive.
    pub mixed_directions: bool,
    /// Its sets.
    pub sets: Vec<Set>,
    /// What it is compared by.
    pub objectives: Objectives,
    /// Its braked gears.
    pub gears: Vec<BrakedGear>,
    /// Every option for the direct-drive clutch, the least torque first.
    pub direct_drive_clutches: Vec<DirectDriveClutch>,
    /// Which shift element is engaged in each gear, the slowest output first.
    pub engagement_table: Vec<Engagement>,
    /// What the criteria say.
    pub criteria: Vec<Verdict>,
    /// Its gears at the speed and load of the input; empty where neither is given.
    pub operation: Vec<GearOperation>,
}

/// A set of a candidate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Links of its members.
    pub links: SetLinks,
    /// Ring-to-sun ratio.
    pub k: f64,
}

/// Why the source has a structure, or lacks it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InSource {
    /// The reason.
    pub standing: InSourceStanding,
    /// What gear 1 gives over the range of k, where that is the reason.
    pub ratio_1: Option<Reach>,
    /// What gear 2 gives over the range of k, where that is the reason.
    pub ratio_2: Option<Reach>,
    /// The structure that it is with D and B exchanged, where that is the reason.
    pub reversed_of: Option<String>,
}

/// A reason for which the source has a structure, or lacks it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InSourceStanding {
    /// The source has it.
    Listed,
    /// Built by the source's rule, but gear 2 never slows in the direction of gear 1.
    OutOfReach,
    /// Built by the source's rule and fit for its purpose, yet not listed.
    Missed,
    /// Built by the source's rule once D and B change places.
    Reversed,
    /// Outside the rule: set 2 ties T2, not T1, to D and B, and works alone.
    Parallel,
    /// Outside the rule: no set has both D and B, the sets work in series.
    Serial,
}

/// The ratios that a gear gives over a range of k.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Reach {
    /// How the ratio runs.
    pub kind: ReachKind,
    /// The least ratio; through infinity the greatest below the gap.
    pub from: f64,
    /// The greatest ratio; through infinity the least above the gap.
    pub to: f64,
}

/// How a ratio runs over a range of k.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReachKind {
    /// It takes every value between two of one sign.
    Between,
    /// It takes every value between two, 0 among them.
    ThroughZero,
    /// It takes every value outside two.
    ThroughInfinity,
}

/// What candidates are compared by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Objectives {
    /// The least efficiency of a braked gear; 0 where one is self-locking.
    pub efficiency: f64,
    /// The largest speed of a link, or of a planet relative to its carrier.
    pub speed_of_input: f64,
    /// Distance of ln k from the preferred range, summed over the sets.
    pub ring_to_sun_distance: f64,
    /// The largest error of a ratio, as a share of it.
    pub ratio_error: f64,
    /// Circulating power of the gear where it is largest, over what enters.
    pub circulating_of_entering: f64,
    /// Size of the largest ring, relative.
    pub size: f64,
    /// Pitch diameter of the largest ring; `null` without a torque and a load factor.
    pub ring_diameter_m: Option<f64>,
}

/// A braked gear of a candidate.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BrakedGear {
    /// Which gear.
    pub gear: GearName,
    /// The ratio wanted.
    pub wanted_ratio: f64,
    /// The ratio it has, input speed over output speed.
    pub ratio: f64,
    /// Its efficiency; `null` where it is self-locking.
    pub efficiency: Option<f64>,
    /// Circulating power over what enters; `null` where the gear is self-locking.
    pub circulating_of_entering: Option<f64>,
    /// Torque of the brake on its link, with losses; `null` where the gear is self-locking.
    pub brake_torque_of_input: Option<f64>,
    /// Speeds in each set.
    pub sets: Vec<SetSpeeds>,
}

/// An option for the direct-drive clutch.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DirectDriveClutch {
    /// The two links that it joins.
    pub links: [Link; 2],
    /// Its torque in direct drive, on the first link.
    pub torque_of_input: f64,
    /// Slip of the open clutch in each braked gear, first link less second.
    pub slips_of_input: Vec<f64>,
    /// Whether it can be drawn with the rest.
    pub drawable: bool,
    /// Whether it is the one chosen: the least torque of those that can be drawn and slip within the limit.
    pub chosen: bool,
}

/// A line of the engagement table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Engagement {
    /// Which gear.
    pub gear: GearName,
    /// Its ratio.
    pub ratio: f64,
    /// The one shift element engaged in it.
    pub engaged: ShiftElement,
    /// Whether the output turns backward.
    pub reverses: bool,
}

/// What a criterion says of a candidate.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Verdict {
    /// Which criterion.
    pub criterion: Criterion,
    /// Whether it is met.
    pub met: bool,
    /// Whether a candidate that does not meet it is rejected.
    pub required: bool,
    /// The worst value found; 1 or 0 of a yes or no; `null` where there is none.
    pub value: Option<f64>,
    /// The least value that meets it.
    pub least: f64,
    /// The greatest value that meets it; `null` where there is no limit.
    pub greatest: Option<f64>,
    /// The gear of the worst value, where it is one of a gear.
    pub gear: Option<GearName>,
    /// The set of the worst value, where it is one of a set or of its planets.
    pub set: Option<u32>,
    /// The link of the worst value, where it is one of a link.
    pub link: Option<Link>,
    /// What cannot be drawn together, for people; `null` where the scheme is drawable, and of other criteria.
    pub crossing: Option<String>,
}

/// What a candidate is judged by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Criterion {
    /// Errors of the ratios.
    RatioError,
    /// Ring-to-sun ratios.
    RingToSunRatio,
    /// Efficiencies of the braked gears.
    Efficiency,
    /// Speeds of the links.
    LinkSpeed,
    /// Speeds of the planets relative to their carriers.
    PlanetSpeed,
    /// Slip of the open direct-drive clutch.
    ClutchSlip,
    /// Circulating power in the braked gears.
    Circulation,
    /// The same direction of rotation of the output in all gears.
    SameDirection,
    /// Drawable with nested shafts, no link across another.
    Drawable,
}

/// A gear at the speed and load of the input.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearOperation {
    /// Which gear.
    pub gear: GearName,
    /// Speed of the output; `null` without the input's speed.
    pub output_speed_rad_s: Option<f64>,
    /// Torque on the gearbox at the input; `null` without a load.
    pub input_torque_n_m: Option<f64>,
    /// Torque on the gearbox at the output; `null` without a load.
    pub output_torque_n_m: Option<f64>,
    /// Torque of K1 on its link; `null` without a load.
    pub k1_torque_n_m: Option<f64>,
    /// Torque of K2 on its link; `null` without a load, and of a single set.
    pub k2_torque_n_m: Option<f64>,
    /// Torque of the direct-drive clutch on its first link; `null` without a load.
    pub direct_drive_clutch_torque_n_m: Option<f64>,
    /// Power that enters; `null` without a load and the input's speed.
    pub entering_w: Option<f64>,
    /// Power that leaves.
    pub leaving_w: Option<f64>,
    /// Power lost in the meshes.
    pub loss_w: Option<f64>,
    /// Circulating power.
    pub circulating_w: Option<f64>,
    /// Torques on the members of each set; empty without a load.
    pub sets: Vec<SetTorques>,
}

/// Torques on the members of a set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetTorques {
    /// On the sun.
    pub sun_torque_n_m: Option<f64>,
    /// On the ring.
    pub ring_torque_n_m: Option<f64>,
    /// On the carrier.
    pub carrier_torque_n_m: Option<f64>,
}

/// A candidate with its place among all.
pub(super) struct Ranked<'a> {
    pub(super) no: u32,
    pub(super) candidate: &'a selection::Candidate,
    pub(super) non_dominated: bool,
}

impl Candidate {
    pub(super) fn of(
        ranked: &Ranked<'_>,
        behind_by: Option<Objective>,
        requirements: &Requirements,
        duty: &Duty,
    ) -> Result<Self, Error> {
        let &Ranked { no, candidate: one, non_dominated } = ranked;
        let sets = one.mechanism.sets().into_iter().map(SetLinks::of);
        Ok(Self {
            no,
            scheme: one.mechanism.scheme().map(Scheme::name),
            structure: one.mechanism.to_string(),
            source: InSource::of(one.mechanism, requirements),
            accepted: one.is_accepted(),
            non_dominated,
            behind_by,
            mixed_directions: one.mixes_directions(),
            sets: sets.zip(&one.k).map(|(links, &k)| Set { links, k }).collect(),
            objectives: Objectives::of(&one.objectives, requirements),
            gears: one.gears.iter().map(|gear| BrakedGear::of(one.mechanism, gear)).collect(),
            direct_drive_clutches: direct_drive_clutches(one),
            engagement_table: engagement_table(one),
            criteria: one.verdicts.iter().map(|verdict| Verdict::of(one.mechanism, verdict)).collect(),
            operation: operation(one, requirements, duty)?,
        })
    }
}

impl Objectives {
    fn of(objectives: &selection::Objectives, requirements: &Requirements) -> Self {
        Self {
            efficiency: objectives.efficiency,
            speed_of_input: objectives.speed,
            ring_to_sun_distance: objectives.ring_to_sun,
            ratio_error: objectives.ratio_error,
            circulating_of_entering: objectives.circulation.unwrap_or_default(),
            size: objectives.size,
            ring_diameter_m: requirements.rating.unit().map(|unit| unit.si() * objectives.size),
        }
    }
}

impl InSource {
    fn of(mechanism: Mechanism, requirements: &Requirements) -> Option<Self> {
        let Mechanism::TwoSets(structure) = mechanism else { return None };
        let (ratio_1, ratio_2, reversed_of) = (None, None, None);
        let only = |standing| Self { standing, ratio_1, ratio_2, reversed_of };
        Some(match Standing::of(structure, &requirements.limits.ring_to_sun) {
            Standing::Listed(_) => only(InSourceStanding::Listed),
            standing @ Standing::Unlisted { first, second, .. } if standing.is_missed() => Self {
                ratio_1: Some(Reach::of(first)),
                ratio_2: Some(Reach::of(second)),
                ..only(InSourceStanding::Missed)
            },
            Standing::Unlisted { second, .. } => {
                Self { ratio_2: Some(Reach::of(second)), ..only(InSourceStanding::OutOfReach) }
            }
            Standing::Reversed { of } => {
                Self { reversed_of: Some(of.to_string()), ..only(InSourceStanding::Reversed) }
            }
            Standing::OutsideRule { family: Family::Parallel } => only(InSourceStanding::Parallel),
            Standing::OutsideRule { .. } => only(InSourceStanding::Serial),
        })
    }
}

impl Reach {
    fn of(reach: RatioReach) -> Self {
        let (kind, from, to) = match reach {
            RatioReach::Between { least, greatest } => (ReachKind::Between, least, greatest),
            RatioReach::ThroughZero { least, greatest } => (ReachKind::ThroughZero, least, greatest),
            RatioReach::ThroughInfinity { below, above } => (ReachKind::ThroughInfinity, below, above),
        };
        Self { kind, from: plain(from), to: plain(to) }
    }
}

impl BrakedGear {
    fn of(mechanism: Mechanism, gear: &selection::GearReport) -> Self {
        let speed = |role| gear.links.iter().find(|(link, _)| *link == role).map(|(_, speed)| *speed);
        let sets = mechanism.sets().into_iter().enumerate();
        Self {
            gear: GearName::of(gear.gear),
            wanted_ratio: gear.wanted,
            ratio: gear.ratio,
            efficiency: gear.efficiency,
            circulating_of_entering: gear.circulation,
            brake_torque_of_input: gear.brake_torque.map(plain),
            sets: sets
                .map(|(set, roles)| SetSpeeds::of(roles.map(speed), gear.planets.get(set).copied()))
                .collect(),
        }
    }
}

fn direct_drive_clutches(one: &selection::Candidate) -> Vec<DirectDriveClutch> {
    let drawable = drawable_direct_clutches(one.mechanism).unwrap_or_default();
    let clutch =
        |(place, clutch): (usize, &epicyclic_schemes::direct_drive::DirectClutch)| DirectDriveClutch {
            links: clutch.pair.map(Link::of),
            torque_of_input: plain(clutch.torque),
            slips_of_input: clutch.slip.iter().take(one.gears.len()).copied().map(plain).collect(),
            drawable: drawable.contains(&clutch.pair),
            chosen: place == one.direct_clutch,
        };
    one.direct_clutches.iter().enumerate().map(clutch).collect()
}

fn engagement_table(one: &selection::Candidate) -> Vec<Engagement> {
    let line = |line: selection::Engagement| {
        let gear = GearName::of(line.gear);
        Engagement { gear, ratio: line.ratio, engaged: gear.engaged(), reverses: line.reverses }
    };
    one.engagement_table().into_iter().map(line).collect()
}

impl Verdict {
    fn of(mechanism: Mechanism, verdict: &selection::Verdict) -> Self {
        let place = Place::of(mechanism, &verdict.evidence);
        Self {
            criterion: Criterion::of(verdict.criterion),
            met: verdict.met,
            required: verdict.required,
            value: finite(verdict.value).map(plain),
            least: verdict.limits[0],
            greatest: finite(verdict.limits[1]),
            gear: place.gear,
            set: place.set,
            link: place.link,
            crossing: place.crossing,
        }
    }
}

impl Criterion {
    pub(super) fn of(criterion: selection::Criterion) -> Self {
        match criterion {
            selection::Criterion::Ratio => Self::RatioError,
            selection::Criterion::RingToSun => Self::RingToSunRatio,
            selection::Criterion::Efficiency => Self::Efficiency,
            selection::Criterion::LinkSpeed => Self::LinkSpeed,
            selection::Criterion::PlanetSpeed => Self::PlanetSpeed,
            selection::Criterion::ClutchSlip => Self::ClutchSlip,
            selection::Criterion::Circulation => Self::Circulation,
            selection::Criterion::SameDirection => Self::SameDirection,
            // The criteria are not exhaustive for other crates.
            _ => Self::Drawable,
        }
    }
}

/// Where the worst value of a criterion is.
#[derive(Default)]
struct Place {
    gear: Option<GearName>,
    set: Option<u32>,
    link: Option<Link>,
    crossing: Option<String>,
}

impl Place {
    fn of(mechanism: Mechanism, evidence: &Evidence) -> Self {
        let gear_of = |gear| Some(GearName::of(gear));
        let set_of = |set: usize| u32::try_from(set + 1).ok();
        match *evidence {
            Evidence::Gear(gear) => Self { gear: gear_of(gear), ..Self::default() },
            Evidence::Set(set) => Self { set: set_of(set), ..Self::default() },
            Evidence::Link { role, gear } => {
                Self { gear: gear_of(gear), link: Some(Link::of(role)), ..Self::default() }
            }
            Evidence::Planet { set, gear } => {
                Self { gear: gear_of(gear), set: set_of(set), ..Self::default() }
            }
            Evidence::NotDrawable(ref why) => {
                Self { crossing: Some(crossing(mechanism, why)), ..Self::default() }
            }
            Evidence::DirectClutch(_)
            | Evidence::NoDirectClutch
            | Evidence::AllForward
            | Evidence::Backward(_)
            | Evidence::Drawable { .. } => Self::default(),
        }
    }
}

/// What cannot be drawn together.
fn crossing(mechanism: Mechanism, why: &NotDrawable) -> String {
    match why {
        NotDrawable::Gearbox(error) => error.to_string(),
        NotDrawable::SelfCrossing(witness) => match mechanism.without_direct_clutch(DRAWN_K) {
            Ok(gearbox) => witness.describe(&gearbox),
            Err(error) => error.to_string(),
        },
        NotDrawable::NoDirectClutch => "no direct-drive clutch can be drawn with the rest".to_owned(),
    }
}

fn operation(
    one: &selection::Candidate,
    requirements: &Requirements,
    duty: &Duty,
) -> Result<Vec<GearOperation>, Error> {
    let (speed, torque) = (duty.input_speed, duty.torque()?);
    if speed.is_none() && torque.is_none() {
        return Ok(vec![]);
    }
    let gearbox = one.gearbox(requirements)?;
    let mut found = vec![];
    for line in one.engagement_table() {
        let gear = GearName::of(line.gear);
        let analysis = gearbox.analyze(gear.name())?;
        // Torques do not depend on the speed; powers are told only where it is known.
        let turning = speed.unwrap_or(AngularVelocity::from_si(1.0));
        let at = match torque.map(|torque| analysis.at(turning, InputLoad::Torque(torque))) {
            None | Some(Err(epicyclic_train::Error::NotDriven { .. })) => None,
            Some(operation) => Some(operation?),
        };
        let at = at.as_ref();
        let powered = at.filter(|_| speed.is_some());
        let circulating = analysis.driving().map(|case| case.power.circulating);
        let element = |element| shift_element(&gearbox, at, element).map(si);
        found.push(GearOperation {
            gear,
            output_speed_rad_s: speed.map(|speed| (speed / line.ratio).si()),
            input_torque_n_m: at.map(|at| si(at.input)),
            output_torque_n_m: at.map(|at| si(at.output)),
            k1_torque_n_m: element(ShiftElement::K1),
            k2_torque_n_m: element(ShiftElement::K2),
            direct_drive_clutch_torque_n_m: element(ShiftElement::L),
            entering_w: powered.map(|at| si(at.entering)),
            leaving_w: powered.map(|at| si(at.entering - at.loss)),
            loss_w: powered.map(|at| if at.loss.abs() < at.entering * ROUNDED { 0.0 } else { si(at.loss) }),
            circulating_w: powered.zip(circulating).map(|(at, share)| si(at.entering * share)),
            sets: at.map_or_else(Vec::new, |at| at.members.iter().map(SetTorques::of).collect()),
        });
    }
    Ok(found)
}

/// Torque of a shift element; none of one that the mechanism lacks.
fn shift_element(gearbox: &Gearbox, at: Option<&Operation>, element: ShiftElement) -> Option<Torque> {
    let place = gearbox.shift_elements().iter().position(|one| one.id() == element.name())?;
    at?.shift_elements[place]
}

impl SetTorques {
    fn of(torques: &Option<Vec<Torque>>) -> Self {
        let on = |member: usize| {
            torques.as_ref().and_then(|torques| torques.get(member)).map(|torque| si(*torque))
        };
        Self { sun_torque_n_m: on(0), ring_torque_n_m: on(1), carrier_torque_n_m: on(2) }
    }
}
