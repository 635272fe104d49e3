//! Records shared by the answers about gearboxes.

use super::{engaged, moving};
use crate::shared::gearbox::Gearbox;
use crate::shared::records::Fraction;
use epicyclic_formats::gearbox::PublishedGear;
use epicyclic_train::one_way::{self, OneWay};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::power_flow::MeshPower;
use epicyclic_train::set::SetKind;
use epicyclic_train::{self as train, Analysis, Gear, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;

/// States of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// The input drives the output with a ratio and torques that follow from the tooth numbers.
    Driven,
    /// The input cannot turn.
    InputBlocked,
    /// The output cannot turn while the input can.
    OutputAtRest,
    /// Nothing connects the output to the input: neutral.
    OutputFree,
    /// Input and output depend on further speeds that must be given.
    Underdetermined,
    /// Input and output depend on further speeds, and the file gives these.
    SpeedsGiven,
    /// Speeds are determined; the sharing of torques depends on how tightly redundant parts hold.
    TorquesIndeterminate,
    /// The mesh losses hold the gear: no torque at the input moves a load at the output.
    SelfLocking,
}

impl State {
    fn of(state: &train::State) -> Self {
        match state {
            train::State::Driven => Self::Driven,
            train::State::InputBlocked { .. } => Self::InputBlocked,
            train::State::OutputAtRest { .. } => Self::OutputAtRest,
            train::State::OutputFree { .. } => Self::OutputFree,
            train::State::Underdetermined { .. } => Self::Underdetermined,
            train::State::TorquesIndeterminate { .. } => Self::TorquesIndeterminate,
            train::State::SelfLocking { .. } => Self::SelfLocking,
        }
    }
}

/// Redundant parts of a gear, whose torques depend on how tightly they hold.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Indeterminate {
    /// Names of the shift elements.
    pub shift_elements: Vec<String>,
    /// Names of the sets.
    pub sets: Vec<String>,
}

/// Directions in which the mesh losses hold a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SelfLocking {
    /// Not self-locking: moves when driven from either end.
    No,
    /// Self-locking when driven from the output.
    FromOutput,
    /// Self-locking when driven from the input.
    FromInput,
    /// Self-locking when driven from either end.
    BothWays,
}

impl SelfLocking {
    fn of(analysis: &Analysis<'_>) -> Option<Self> {
        let from_output = analysis.is_self_locking()?;
        Some(match (matches!(analysis.state(), train::State::SelfLocking { .. }), from_output) {
            (false, false) => Self::No,
            (false, true) => Self::FromOutput,
            (true, false) => Self::FromInput,
            (true, true) => Self::BothWays,
        })
    }
}

/// Published ratio with the computed one.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Published {
    /// Ratio as published.
    pub ratio: f64,
    /// Number of decimals of the published ratio.
    pub decimals: u32,
    /// Whether the ratio is published as output speed over input speed.
    pub output_over_input: bool,
    /// Whether the published ratio has not been checked in the source named.
    pub unverified: bool,
    /// Computed ratio in the published form; null if the gear has no ratio.
    pub computed: Option<f64>,
    /// Whether the published digits, rounded or truncated, match the computed ratio; null without a ratio.
    pub agrees: Option<bool>,
}

impl Published {
    fn of(published: &PublishedGear, ratio: Option<f64>) -> Self {
        Self {
            ratio: published.published_ratio.get(),
            decimals: published.printed_decimals,
            output_over_input: published.invert,
            unverified: published.unverified,
            computed: ratio.map(|ratio| if published.invert { 1.0 / ratio } else { ratio }),
            agrees: ratio.map(|ratio| published.stands_for(ratio)),
        }
    }
}

/// Engaged elements, state, ratio and efficiencies of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearFacts {
    /// Name of the gear.
    pub gear: String,
    /// Names of the engaged shift elements.
    pub engaged: Vec<String>,
    /// Link where power enters.
    pub input: String,
    /// Link where power leaves.
    pub output: String,
    /// State of the gear.
    pub state: State,
    /// Links that the state concerns: at rest, free, or without a known speed.
    pub state_links: Vec<String>,
    /// Number of speeds that must be given besides the input speed, if the gear is underdetermined; otherwise
    /// null.
    pub missing_speeds: Option<usize>,
    /// Redundant parts, if the torques are indeterminate; otherwise null.
    pub indeterminate: Option<Indeterminate>,
    /// Links whose speeds the file gives for this gear.
    pub links_with_given_speeds: Vec<String>,
    /// Ratio, input speed over output speed; null if none exists.
    pub ratio: Option<f64>,
    /// Exact ratio as a fraction; null unless the tooth numbers are known.
    pub exact_ratio: Option<Fraction>,
    /// Published ratio; null unless the gearbox is a published transmission.
    pub published: Option<Published>,
    /// Efficiency when driven from the input; null if the mesh losses hold the gear.
    pub efficiency: Option<f64>,
    /// Efficiency by Kreines' rule, from the ratio alone; null if it cannot be computed or is not positive.
    pub kreines_efficiency: Option<f64>,
    /// Efficiency when driven from the output; null if the mesh losses hold the gear or a one-way clutch
    /// overruns.
    pub back_driving_efficiency: Option<f64>,
    /// Directions in which the gear is self-locking; null if unknown.
    pub self_locking: Option<SelfLocking>,
}

impl GearFacts {
    pub(super) fn of(subject: &Gearbox, analysis: &Analysis<'_>) -> Self {
        let (gearbox, gear) = (&subject.train, analysis.gear());
        let inputs = subject.inputs(gear.name());
        let kreines = analysis.kreines().map(|kreines| kreines.efficiency);
        let (state_links, missing_speeds, indeterminate) = concerned(analysis.state());
        Self {
            gear: gear.name().to_owned(),
            engaged: engaged(gearbox, gear),
            input: gearbox.link_name(gear.input()).to_owned(),
            output: gearbox.link_name(gear.output()).to_owned(),
            state: match (State::of(analysis.state()), missing_speeds, inputs) {
                // The file gives the speeds of as many links as the gear keeps degrees of freedom.
                (State::Underdetermined, Some(missing), Some(inputs))
                    if inputs.speeds.len() == missing + 1 =>
                {
                    State::SpeedsGiven
                }
                (state, ..) => state,
            },
            state_links,
            missing_speeds,
            indeterminate,
            links_with_given_speeds: inputs
                .map_or_else(Vec::new, |inputs| inputs.speeds.keys().cloned().collect()),
            ratio: analysis.ratio(),
            exact_ratio: analysis.exact_ratio().map(Fraction::of),
            published: subject.published(gear.name()).map(|gear| Published::of(gear, analysis.ratio())),
            efficiency: moving(analysis.efficiency()),
            kreines_efficiency: moving(kreines),
            back_driving_efficiency: moving(analysis.back_driving_efficiency())
                .filter(|_| analysis.has_engine_braking() != Some(false)),
            self_locking: SelfLocking::of(analysis),
        }
    }
}

/// Links, number of missing speeds and redundant parts of a state.
pub(super) fn concerned(state: &train::State) -> (Vec<String>, Option<usize>, Option<Indeterminate>) {
    let missing = match state {
        train::State::Underdetermined { missing, .. } => Some(*missing),
        _ => None,
    };
    let indeterminate = match state {
        train::State::TorquesIndeterminate { shift_elements, sets, .. } => {
            Some(Indeterminate { shift_elements: shift_elements.clone(), sets: sets.clone() })
        }
        _ => None,
    };
    (state.links().to_vec(), missing, indeterminate)
}

pub(super) fn state(analysis: &Analysis<'_>) -> State {
    State::of(analysis.state())
}

/// Kinds of shift elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShiftElementKind {
    /// Brake, which holds a link at the housing.
    Brake,
    /// Clutch, which joins two links.
    Clutch,
    /// Brake that holds in one direction.
    OneWayBrake,
    /// Clutch that holds in one direction.
    OneWayClutch,
}

impl ShiftElementKind {
    pub(super) fn of(element: &train::ShiftElement) -> Self {
        match (element.is_brake(), element.is_one_way()) {
            (true, false) => Self::Brake,
            (false, false) => Self::Clutch,
            (true, true) => Self::OneWayBrake,
            (false, true) => Self::OneWayClutch,
        }
    }
}

/// Names of the two links that a shift element joins; `ground` is the housing.
pub(super) fn links_of(gearbox: &train::Gearbox, element: &train::ShiftElement) -> [String; 2] {
    element.links().map(|link| gearbox.link_name(link).to_owned())
}

/// Behaviour of a one-way clutch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Duty {
    /// Carries torque.
    Holds,
    /// Overruns, as the gear requires.
    Overruns,
    /// Carries no torque, at rest or with both links at the same speed.
    Idles,
    /// Would overrun under its torque, although the gear relies on it.
    WouldOverrun,
    /// Would hold, although the gear does not engage it.
    WouldHold,
}

impl Duty {
    fn of(duty: one_way::Duty) -> Option<Self> {
        match duty {
            one_way::Duty::Holds => Some(Self::Holds),
            one_way::Duty::Overruns => Some(Self::Overruns),
            one_way::Duty::Idles => Some(Self::Idles),
            one_way::Duty::WouldOverrun => Some(Self::WouldOverrun),
            one_way::Duty::WouldHold => Some(Self::WouldHold),
            one_way::Duty::Unknown => None,
        }
    }
}

/// Behaviour of a one-way clutch in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OneWayClutch {
    /// Name of the gear.
    pub gear: String,
    /// Name of the one-way clutch.
    pub clutch: String,
    /// Whether the gear counts the clutch as engaged.
    pub relied_on: bool,
    /// Behaviour when power enters at the input; null if unknown.
    pub drive: Option<Duty>,
    /// Behaviour when power enters at the output; null if unknown.
    pub coast: Option<Duty>,
    /// Whether the output can drive the input; null unless the gear relies on a one-way clutch.
    pub engine_braking: Option<bool>,
    /// Shift elements between the same links that hold in both directions. With one of them engaged too, the
    /// gear holds on coast.
    pub beside: Vec<String>,
}

/// Names of the shift elements between the links of a one-way clutch that hold in both directions.
pub(super) fn beside(gearbox: &train::Gearbox, clutch: usize) -> Vec<String> {
    let links = |element: &train::ShiftElement| {
        let [one, other] = element.links();
        [one.min(other), one.max(other)]
    };
    let own = gearbox.shift_elements().get(clutch).map(links);
    let all = gearbox.shift_elements().iter();
    let others = all.filter(|element| !element.is_one_way() && Some(links(element)) == own);
    others.map(|element| element.id().to_owned()).collect()
}

/// Behaviour of the one-way clutches in a gear.
pub(super) fn one_way_clutches(gearbox: &train::Gearbox, analysis: &Analysis<'_>) -> Vec<OneWayClutch> {
    let one = |one: OneWay| OneWayClutch {
        gear: analysis.gear().name().to_owned(),
        clutch: gearbox.shift_elements()[one.shift_element].id().to_owned(),
        relied_on: one.is_relied_on,
        drive: Duty::of(one.drive),
        coast: Duty::of(one.coast),
        engine_braking: analysis.has_engine_braking(),
        beside: beside(gearbox, one.shift_element),
    };
    analysis.one_way_clutches().into_iter().map(one).collect()
}

/// Kinds of planetary sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Sun, ring, and planets in mesh with both.
    Simple,
    /// Sun, ring, and two planets in mesh between them.
    DoublePlanet,
    /// Stepped planets between a sun and a ring.
    SteppedSunRing,
    /// Stepped planets between two suns.
    SteppedSuns,
    /// Stepped planets between two rings.
    SteppedRings,
    /// Two suns, each with its planets, the planets in mesh.
    MeshingSuns,
    /// Bevel gears.
    Bevel,
    /// Two external gears on fixed axes.
    ExternalPair,
    /// A pinion in a ring on fixed axes.
    InternalPair,
    /// Compound set, described gear by gear.
    Compound,
}

impl Kind {
    /// Whether the axes of the gears are fixed.
    pub(crate) const fn is_pair(self) -> bool {
        matches!(self, Self::ExternalPair | Self::InternalPair)
    }

    pub(crate) fn of(set: &PlanetSet) -> Self {
        match set.kind() {
            Some(SetKind::Simple) => Self::Simple,
            Some(SetKind::DoublePlanet) => Self::DoublePlanet,
            Some(SetKind::SteppedSunRing) => Self::SteppedSunRing,
            Some(SetKind::SteppedSuns) => Self::SteppedSuns,
            Some(SetKind::SteppedRings) => Self::SteppedRings,
            Some(SetKind::MeshingSuns) => Self::MeshingSuns,
            Some(SetKind::Bevel) => Self::Bevel,
            Some(SetKind::ExternalPair) => Self::ExternalPair,
            Some(SetKind::InternalPair) => Self::InternalPair,
            None => Self::Compound,
        }
    }
}

/// Name of a member of a set: a central gear, a planet shaft, or the carrier, which is the last.
pub(super) fn member_name(set: &PlanetSet, member: usize) -> String {
    if member == set.centrals().len() { "carrier".to_owned() } else { set.gear_name(GearOf::Central(member)) }
}

/// Name of a planet of a set, or its number if it has no name.
pub(crate) fn planet_name(set: &PlanetSet, planet: usize) -> String {
    match &set.planets()[planet].name {
        name if name.is_empty() => (planet + 1).to_string(),
        name => name.clone(),
    }
}

/// Mesh in the direction of its power.
pub(crate) struct MeshFigures {
    pub(crate) set: String,
    pub(crate) from: String,
    pub(crate) to: String,
    pub(crate) efficiency: f64,
    pub(crate) enters: Option<f64>,
    pub(crate) leaves: Option<f64>,
}

/// Lists the meshes of all sets; `power` returns the mesh powers of a set.
pub(crate) fn meshes(
    gearbox: &train::Gearbox,
    power: impl Fn(usize) -> Option<Vec<MeshPower>>,
) -> Vec<MeshFigures> {
    let mut all = vec![];
    for (place, set) in gearbox.sets().iter().enumerate() {
        let powers = power(place);
        for (at, mesh) in set.meshes().iter().enumerate() {
            let through = powers.as_ref().map(|powers| powers[at]);
            let [mut from, mut to] = mesh.gears;
            if through.is_some_and(|power| power.sense < 0) {
                std::mem::swap(&mut from, &mut to);
            }
            all.push(MeshFigures {
                set: set.id().to_owned(),
                from: set.gear_name(from),
                to: set.gear_name(to),
                efficiency: mesh.efficiency.get(),
                enters: through.map(|power| power.enters),
                leaves: through.map(|power| power.leaves),
            });
        }
    }
    all
}

/// Whether two gears engage the same elements between the same links.
pub(super) fn is_same(one: &Gear, other: &Gear) -> bool {
    one.engaged() == other.engaged() && one.input() == other.input() && one.output() == other.output()
}
