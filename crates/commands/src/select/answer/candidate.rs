//! Mechanism with its figures, and the verdicts of the criteria.

use super::duty::Duty;
use super::required::{Objective, finite};
use crate::error::Error;
use crate::shared::catalogue::{SetLinks, SetSpeeds};
use crate::shared::number::{plain, si};
use crate::tolerance::ROUNDED;
use epicyclic_schemes::catalogue::{Reach as RatioReach, Scheme};
use epicyclic_schemes::catalogue::{SchemeElement, SchemeGear};
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::Family;
use epicyclic_schemes::structures::Role;
use epicyclic_selection::drawing::{DRAWN_K, drawable_direct_clutches};
use epicyclic_selection::{self as selection, Evidence, Mechanism, NotDrawable, Requirements};
use epicyclic_train::{Gearbox, InputLoad, Operation};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Torque};

/// Mechanism with its figures and verdicts. Speeds without a unit are relative to the input speed, torques to
/// the input torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Candidate {
    /// Number of the candidate among all candidates, from 1.
    pub no: u32,
    /// Name of the scheme in the source; null if it has none.
    pub scheme: Option<&'static str>,
    /// Name of the structure, by the links of sun, ring and carrier of each set.
    pub structure: String,
    /// Reason why the source has or lacks the structure; null for a single set.
    pub source: Option<InSource>,
    /// Whether the candidate meets every required criterion.
    pub accepted: bool,
    /// Whether the candidate is non-dominated: no other is better in one objective and worse in none.
    pub non_dominated: bool,
    /// Objective by which the candidate is behind the first; null for the first, for its equals, and for
    /// rejected ones.
    pub behind_by: Option<Objective>,
    /// Whether the output turns in mixed directions: backward in a braked gear, forward in direct drive.
    pub mixed_directions: bool,
    /// Sets of the candidate.
    pub sets: Vec<Set>,
    /// Values of the objectives.
    pub objectives: Objectives,
    /// Braked gears of the candidate.
    pub gears: Vec<BrakedGear>,
    /// Options for the direct-drive clutch, the least torque first.
    pub direct_drive_clutches: Vec<DirectDriveClutch>,
    /// Engaged shift element of each gear, the slowest output first.
    pub engagement_table: Vec<Engagement>,
    /// Verdicts of the criteria.
    pub criteria: Vec<Verdict>,
    /// Results for each gear at the given speed and load of the input; empty if neither is given.
    pub operation: Vec<GearOperation>,
}

/// Set of a candidate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Links of the members.
    pub links: SetLinks,
    /// Ring-to-sun ratio k.
    pub k: f64,
}

/// Reason why the source has or lacks a structure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct InSource {
    /// Kind of the reason.
    pub standing: InSourceStanding,
    /// Ratios of gear 1 over the range of k; null unless they are the reason.
    pub ratio_1: Option<Reach>,
    /// Ratios of gear 2 over the range of k; null unless they are the reason.
    pub ratio_2: Option<Reach>,
    /// Structure that results from exchanging D and B; null unless this is the reason.
    pub reversed_of: Option<String>,
}

/// Kinds of reasons why the source has or lacks a structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InSourceStanding {
    /// The source lists the structure.
    Listed,
    /// Built by the source's rule, but gear 2 never reduces the speed in the direction of gear 1.
    OutOfReach,
    /// Built by the source's rule and suitable, yet not listed.
    Missed,
    /// Built by the source's rule after exchanging D and B.
    Reversed,
    /// Outside the rule: set 2 ties T2, not T1, to D and B, and works independently.
    Parallel,
    /// Outside the rule: no set has both D and B, so that the sets work in series.
    Serial,
}

/// Ratios that a gear has over a range of k.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Reach {
    /// Shape of the range of ratios.
    pub kind: ReachKind,
    /// Least ratio; for a range through infinity the greatest below the gap.
    pub from: f64,
    /// Greatest ratio; for a range through infinity the least above the gap.
    pub to: f64,
}

/// Shapes of the range of ratios over a range of k.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReachKind {
    /// Values between two limits of equal sign.
    Between,
    /// Values between two limits, with 0 among them.
    ThroughZero,
    /// Values outside two limits.
    ThroughInfinity,
}

/// Objectives by which candidates are compared.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Objectives {
    /// Least efficiency of a braked gear; 0 if one is self-locking.
    pub efficiency: f64,
    /// Largest speed of a link, or planet speed relative to the carrier; relative to the input speed.
    pub speed_of_input: f64,
    /// Distance of ln k from the preferred range, summed over the sets.
    pub ring_to_sun_distance: f64,
    /// Largest relative error of a ratio.
    pub ratio_error: f64,
    /// Largest circulating power of a gear relative to the entering power.
    pub circulating_of_entering: f64,
    /// Relative size of the largest ring.
    pub size: f64,
    /// Pitch diameter of the largest ring in m; null without a torque and a load factor.
    pub ring_diameter_m: Option<f64>,
}

/// Braked gear of a candidate.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BrakedGear {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Required ratio.
    pub wanted_ratio: f64,
    /// Ratio of the gear, input speed over output speed.
    pub ratio: f64,
    /// Efficiency of the gear; null if it is self-locking.
    pub efficiency: Option<f64>,
    /// Circulating power relative to the entering power; null if the gear is self-locking.
    pub circulating_of_entering: Option<f64>,
    /// Torque of the brake on its link with losses, relative to the input torque; null if the gear is
    /// self-locking.
    pub brake_torque_of_input: Option<f64>,
    /// Speeds in each set, relative to the input speed.
    pub sets: Vec<SetSpeeds>,
}

/// Option for the direct-drive clutch.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DirectDriveClutch {
    /// Names of the two links that the clutch joins.
    pub links: [Role; 2],
    /// Torque on the first link in direct drive, relative to the input torque.
    pub torque_of_input: f64,
    /// Slip of the open clutch in each braked gear relative to the input speed: first link minus second.
    pub slips_of_input: Vec<f64>,
    /// Whether the clutch can be drawn with the rest.
    pub drawable: bool,
    /// Whether the clutch is chosen: the one of least torque that can be drawn and slips within the limit.
    pub chosen: bool,
}

/// Line of the engagement table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Engagement {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Ratio of the gear, input speed over output speed.
    pub ratio: f64,
    /// Shift element that is engaged in the gear.
    pub engaged: SchemeElement,
    /// Whether the output turns backward.
    pub reverses: bool,
}

/// Verdict of a criterion on a candidate.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Verdict {
    /// Name of the criterion.
    pub criterion: Criterion,
    /// Whether the criterion is met.
    pub met: bool,
    /// Whether a candidate that does not meet the criterion is rejected.
    pub required: bool,
    /// Worst value found; 1 or 0 for yes or no. Null if none exists.
    pub value: Option<f64>,
    /// Least value that meets the criterion.
    pub least: f64,
    /// Greatest value that meets the criterion; null if there is no limit.
    pub greatest: Option<f64>,
    /// Gear with the worst value; null if the value is not one of a gear.
    pub gear: Option<SchemeGear>,
    /// Number of the set with the worst value; null if the value is not one of a set or its planets.
    pub set: Option<u32>,
    /// Link with the worst value; null if the value is not one of a link.
    pub link: Option<Role>,
    /// Explanation of the elements that cannot be drawn together; null if the scheme is drawable, and for
    /// other criteria.
    pub crossing: Option<String>,
}

/// Criteria by which a candidate is judged.
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
    /// Equal direction of rotation of the output in all gears.
    SameDirection,
    /// Drawable with nested shafts, no link across another.
    Drawable,
}

/// Results for a gear at the given speed and load of the input.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearOperation {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Output speed in rad/s; null without the input speed.
    pub output_speed_rad_s: Option<f64>,
    /// Torque on the input in N·m; null without a load.
    pub input_torque_n_m: Option<f64>,
    /// Torque on the output in N·m; null without a load.
    pub output_torque_n_m: Option<f64>,
    /// Torque of K1 on its link in N·m; null without a load.
    pub k1_torque_n_m: Option<f64>,
    /// Torque of K2 on its link in N·m; null without a load, and for a single set.
    pub k2_torque_n_m: Option<f64>,
    /// Torque of the direct-drive clutch on its first link in N·m; null without a load.
    pub direct_drive_clutch_torque_n_m: Option<f64>,
    /// Entering power in W; null without a load and the input speed.
    pub entering_w: Option<f64>,
    /// Leaving power in W; null without a load and the input speed.
    pub leaving_w: Option<f64>,
    /// Power lost in the meshes in W; null without a load and the input speed.
    pub loss_w: Option<f64>,
    /// Circulating power in W; null without a load and the input speed.
    pub circulating_w: Option<f64>,
    /// Torques on the members of each set; empty without a load.
    pub sets: Vec<SetTorques>,
}

/// Torques on the members of a set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetTorques {
    /// Torque on the sun in N·m; null if the set carries no torque.
    pub sun_torque_n_m: Option<f64>,
    /// Torque on the ring in N·m; null if the set carries no torque.
    pub ring_torque_n_m: Option<f64>,
    /// Torque on the carrier in N·m; null if the set carries no torque.
    pub carrier_torque_n_m: Option<f64>,
}

/// Candidate with its number among all candidates.
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
            gear: gear.gear,
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
            links: clutch.pair,
            torque_of_input: plain(clutch.torque),
            slips_of_input: clutch.slip.iter().take(one.gears.len()).copied().map(plain).collect(),
            drawable: drawable.contains(&clutch.pair),
            chosen: place == one.direct_clutch,
        };
    one.direct_clutches.iter().enumerate().map(clutch).collect()
}

fn engagement_table(one: &selection::Candidate) -> Vec<Engagement> {
    let line = |line: selection::Engagement| {
        let gear = line.gear;
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
            // The enum is non-exhaustive in its crate, so a match needs this arm.
            _ => Self::Drawable,
        }
    }
}

/// Place of the worst value of a criterion.
#[derive(Default)]
struct Place {
    gear: Option<SchemeGear>,
    set: Option<u32>,
    link: Option<Role>,
    crossing: Option<String>,
}

impl Place {
    fn of(mechanism: Mechanism, evidence: &Evidence) -> Self {
        let set_of = |set: usize| u32::try_from(set + 1).ok();
        match *evidence {
            Evidence::Gear(gear) => Self { gear: Some(gear), ..Self::default() },
            Evidence::Set(set) => Self { set: set_of(set), ..Self::default() },
            Evidence::Link { role, gear } => Self { gear: Some(gear), link: Some(role), ..Self::default() },
            Evidence::Planet { set, gear } => Self { gear: Some(gear), set: set_of(set), ..Self::default() },
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

/// Explanation of the elements that cannot be drawn together.
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
        let gear = line.gear;
        let analysis = gearbox.analyze(gear.name())?;
        // Torques do not depend on the speed; powers are given only if it is known.
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
            k1_torque_n_m: element(SchemeElement::FirstBrake),
            k2_torque_n_m: element(SchemeElement::SecondBrake),
            direct_drive_clutch_torque_n_m: element(SchemeElement::DirectClutch),
            entering_w: powered.map(|at| si(at.entering)),
            leaving_w: powered.map(|at| si(at.entering - at.loss)),
            loss_w: powered.map(|at| if at.loss.abs() < at.entering * ROUNDED { 0.0 } else { si(at.loss) }),
            circulating_w: powered.zip(circulating).map(|(at, share)| si(at.entering * share)),
            sets: at.map_or_else(Vec::new, |at| at.members.iter().map(SetTorques::of).collect()),
        });
    }
    Ok(found)
}

/// Torque of a shift element; `None` if the mechanism lacks it or there is no load.
fn shift_element(gearbox: &Gearbox, at: Option<&Operation>, element: SchemeElement) -> Option<Torque> {
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
