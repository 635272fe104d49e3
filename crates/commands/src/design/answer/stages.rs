//! Stages in series for one ratio: splits, tooth numbers and sizes chosen together.

use super::arranged;
use super::assumed::{AssumedLoad, assumed};
use super::attempt::CLASSES;
use super::axes::{self, Axes};
use super::backlash::OutputBacklash;
use super::larger::Compared;
use super::limits::OrderLimits;
use super::making::warnings;
use super::masses::Masses;
use super::records::SizesStep;
use super::stage_kind::StageKind;
use super::stages_file::{document, efficiencies};
use super::stages_search::{searched, unusual};
use super::stages_wanted::WantedStages;
use super::trains::{Listed, TrainOfStages, TrainsOf, by_cost};
use super::ways_out::WayOutOfStages;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::basis::BasisKey;
use crate::shared::gearbox::{Choice, one};
use crate::size::answer as size;
use crate::size::options::Request as SizeRequest;
use epicyclic_strength::series::KnownSets;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::Torque;

/// Stages that are tried at most.
pub(crate) const MOST_STAGES: u32 = 4;

/// Stages in series for one ratio, with sufficient strength.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Stages {
    /// Required ratio, input speed over output speed; below 0 the rings turn with the slow shaft, and its
    /// carrier is held. A train whose fast stage is a pair may have the other sign.
    pub asked_ratio: f64,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Relative deviation within which trains were compared: a part of the tolerance, or all of it.
    pub searched_tolerance: f64,
    /// Reached ratio; null if no train holds.
    pub ratio: Option<f64>,
    /// Speed of the input in rad/s.
    pub input_speed_rad_s: f64,
    /// Required speed of the output in rad/s.
    pub asked_output_speed_rad_s: f64,
    /// Reached speed of the output in rad/s; null if no train holds.
    pub output_speed_rad_s: Option<f64>,
    /// Required torque on the output in N·m; null where the load of the input is given.
    pub asked_output_torque_n_m: Option<f64>,
    /// Torque on the output, with the losses of the meshes, in N·m; null if no train holds.
    pub output_torque_n_m: Option<f64>,
    /// Torque on the input in N·m; null if no train holds and that of the output is given.
    pub input_torque_n_m: Option<f64>,
    /// Power into the input in W; null if no train holds and the torque of the output is given.
    pub input_power_w: Option<f64>,
    /// Efficiency of the meshes of all stages; null if no train holds.
    pub efficiency: Option<f64>,
    /// Efficiency of the meshes when the output drives; null if no train holds, or if the losses hold it.
    pub back_driving_efficiency: Option<f64>,
    /// Backlash of the output; null if not asked for, or if no train holds.
    pub backlash: Option<OutputBacklash>,
    /// Sets of tooth numbers that stages were chosen from.
    pub sets: usize,
    /// Tooth numbers allowed.
    pub teeth: TeethRanges,
    /// Best trains of each number of stages.
    pub trains: Vec<TrainsOf>,
    /// Assumed values by key.
    pub basis: Vec<BasisKey>,
    /// Assumptions that are no keys of the file.
    pub assumed: Vec<BasisKey>,
    /// Limits of the whole gearbox, and what exceeds them.
    pub limits: OrderLimits,
    /// Masses of the whole and of its parts; null if no train holds.
    pub masses: Option<Masses>,
    /// Sizes of the train taken, with their strength over the duty; null if no train holds.
    pub sizes: Option<SizesStep>,
    /// Gearbox file with sizes; null if no train holds.
    pub file: Option<String>,
    /// Limits to relax if no train holds, each with the train that is then found. Null if there is a file.
    pub ways_out: Option<Vec<WayOutOfStages>>,
    /// Trains with smaller and smaller rings, each the best that its limit of the rings leaves; null if not asked
    /// for, or without a train.
    pub front: Option<Vec<WayOutOfStages>>,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

/// Least and greatest tooth numbers allowed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethRanges {
    /// Tooth numbers of the suns.
    pub sun: [u32; 2],
    /// Tooth numbers of the planets.
    pub planet: [u32; 2],
    /// Tooth numbers of the rings.
    pub ring: [u32; 2],
}

impl Answer for Stages {
    const NAME: &'static str = "design-stages";
}

impl Stages {
    /// The trains of which the best is taken; `None` if none holds.
    pub(crate) fn taken(&self) -> Option<&TrainsOf> {
        self.trains.iter().find(|trains| trains.taken)
    }
}

/// Designs stages in series without ways out and front; `most` trains of each number of stages are listed.
/// `known` is of orders that differ in limits of ratio, stages and rings alone: with the bearings of the
/// order, and with larger ones, which are taken where they pay ([`Compared`]). These sizes come back if they are
/// taken.
pub(super) fn attempted(
    wanted: &WantedStages,
    most: usize,
    known: &mut [KnownSets; 2],
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(Stages, Option<SizeRequest>), Error> {
    let each = wanted.kinds.iter().flat_map(|kind| {
        let axes = match (kind, wanted.axes) {
            // Each kind of trains with the bearings that pay for it: pairs have none.
            (StageKind::Simple, Axes::Either) => vec![Axes::Coaxial, Axes::Parallel],
            (StageKind::Simple, axes) => vec![axes],
            _ => vec![Axes::Coaxial],
        };
        axes.into_iter().map(move |axes| WantedStages { axes, kinds: vec![*kind], ..wanted.clone() })
    });
    let cost = |of: &Stages| of.taken().and_then(TrainsOf::cost);
    let better = |mut first: (Stages, Option<SizeRequest>), mut other: (Stages, Option<SizeRequest>)| {
        if cost(&other.0).is_some_and(|other| cost(&first.0).is_none_or(|first| other < first)) {
            std::mem::swap(&mut first, &mut other);
        }
        let others = other.0.trains.into_iter().map(|trains| TrainsOf { taken: false, ..trains });
        first.0.trains.extend(others);
        first.0.trains.sort_by_key(|trains| (trains.stages, trains.has_pair, trains.kind));
        first.0.sets = first.0.sets.max(other.0.sets);
        first.0.limits = first.0.limits.with(other.0.limits, first.0.file.is_some());
        first
    };
    let all: Result<Vec<_>, Error> =
        each.map(|wanted| attempted_of_kind(&wanted, most, known, goes_on)).collect();
    Ok(all?.into_iter().reduce(better).expect("there is a kind"))
}

/// Designs stages in series of one kind.
fn attempted_of_kind(
    wanted: &WantedStages,
    most: usize,
    [known, of_larger]: &mut [KnownSets; 2],
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(Stages, Option<SizeRequest>), Error> {
    let stages = attempted_with(wanted, most, known, goes_on)?;
    let compared = |of: &Stages| {
        let best = of.taken().and_then(|trains| trains.best.as_ref());
        Compared::new(best.map(|train| train.rules_missed), of.masses, &of.warnings)
    };
    let usual = compared(&stages);
    let Some(size) = wanted.size.larger().filter(|_| usual.is_open()) else { return Ok((stages, None)) };
    let with_larger = WantedStages { size: size.clone(), ..wanted.clone() };
    let other = attempted_with(&with_larger, most, of_larger, goes_on)?;
    if usual.gives_way_to(compared(&other)) {
        let limits = other.limits.with(stages.limits, other.file.is_some());
        return Ok((Stages { limits, ..other }, Some(size)));
    }
    Ok((stages, None))
}

/// Designs stages in series of one kind with the sizes of the order and no larger ones.
pub(super) fn attempted_with(
    wanted: &WantedStages,
    most: usize,
    known: &mut KnownSets,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Stages, Error> {
    // As for several speeds, accuracy is not traded for mass beyond a tenth of the tolerance, but for usual
    // practice, and for limits of the whole.
    let mut class: Option<Class> = None;
    let mut limits = wanted.limits;
    for part in CLASSES {
        let tolerance = part * wanted.tolerance;
        // Trains of a wider class have to keep to usual practice in more stages.
        let before = class.as_ref().filter(|class| class.made.is_some()).and_then(Class::unusual);
        if let (Some(before), StageKind::Simple) = (before, wanted.kind()) {
            let fewer = Some(before.saturating_sub(1));
            if unusual(&searched(wanted, (tolerance, fewer), 1, (&mut *known, goes_on))?.found).is_none() {
                continue;
            }
        }
        let own = Class::of(wanted, (tolerance, most), known, &mut limits, goes_on)?;
        let is_taken = own.made.is_some();
        let is_usual = is_taken && own.unusual() == Some(0);
        if before.is_none() || is_taken && own.unusual() < before {
            class = Some(own);
        }
        if wanted.tolerance == 0.0 || is_usual {
            break;
        }
    }
    let Class { within, listed, made } = class.expect("there are classes");
    let Listed { sets, trains, ended_early, .. } = listed;
    if made.is_some() {
        (limits.lightest_kg, limits.shortest_m) = (None, None);
    }
    let train = trains.iter().find(|trains| trains.taken).and_then(|trains| trains.best.clone());
    let (mut sizes, mut file, mut all_warnings) = (None, None, vec![]);
    let (mut efficiency, mut back_driving_efficiency, mut masses) = (None, None, None);
    let mut backlash = None;
    let mut torque = Some(wanted.torque).filter(|_| !wanted.is_of_output);
    if let Some(made) = made {
        [efficiency, back_driving_efficiency] = made.efficiencies;
        (torque, masses, all_warnings) = (Some(made.torque), made.masses, made.warnings);
        let kept = wanted.backlash.map(|asked| OutputBacklash::of(&made.file, asked)).transpose()?;
        (sizes, file) = (Some(made.sizes), Some(made.file));
        all_warnings.extend(limits.warning());
        if let Some((with_allowances, own)) = kept {
            all_warnings.extend(own.warning());
            (file, backlash) = (Some(with_allowances), Some(own));
        }
    }
    let of_set = BasisKey::of_number("efficiency", wanted.efficiency);
    let of_pair = BasisKey::of_number("efficiency of a pair", axes::efficiency_of_pair(wanted.efficiency));
    let of_pair = Some(of_pair).filter(|_| wanted.has_pair());
    let of_pair_assumed = (wanted.has_pair() && train.is_some()).then(|| BasisKey {
        key: "pair".to_owned(),
        value: "gears without bores; its shafts and their bearings, with the axial force of helical teeth, are left out"
            .to_owned(),
    });
    let load = AssumedLoad { spectrum: &wanted.spectrum, gears: 1, shares: &[], overload: wanted.overload };
    let ratio = train.as_ref().map(|train| train.ratio);
    let speed = if wanted.is_backward { -wanted.speed.si() } else { wanted.speed.si() };
    let ends = |range: &RangeInclusive<u32>| [*range.start(), *range.end()];
    let teeth = &wanted.teeth;
    Ok(Stages {
        asked_ratio: wanted.asked(),
        tolerance: wanted.tolerance,
        searched_tolerance: within,
        ratio,
        input_speed_rad_s: speed,
        asked_output_speed_rad_s: speed / wanted.asked(),
        output_speed_rad_s: ratio.map(|ratio| speed / ratio),
        asked_output_torque_n_m: wanted.is_of_output.then(|| wanted.torque.si() * wanted.asked().abs()),
        output_torque_n_m: ratio
            .zip(torque)
            .map(|(ratio, of)| of.si() * ratio.abs() * efficiency.unwrap_or(1.0)),
        input_torque_n_m: torque.map(Physical::si),
        input_power_w: torque.map(|of| (of * wanted.speed).si()),
        efficiency,
        back_driving_efficiency,
        backlash,
        sets,
        teeth: TeethRanges { sun: ends(&teeth.suns), planet: ends(&teeth.planets), ring: ends(&teeth.rings) },
        limits,
        masses,
        trains,
        basis: wanted.basis.told().into_iter().chain([of_set]).chain(of_pair).collect(),
        assumed: assumed(&wanted.basis, &wanted.size, &load)?
            .into_iter()
            .chain(of_pair_assumed)
            .chain(backlash.as_ref().map(OutputBacklash::assumed))
            .collect(),
        sizes,
        file,
        ways_out: None,
        front: None,
        warnings: all_warnings.into_iter().chain(cut_short(&ended_early)).collect(),
    })
}

/// A warning of searches of these numbers of stages, which ended before all trains were compared.
fn cut_short(ended_early: &[usize]) -> Option<Warning> {
    let cut: Vec<String> = ended_early.iter().map(usize::to_string).collect();
    (!cut.is_empty()).then(|| Warning {
        name: "search-ended",
        message: format!(
            "the search of {} stages ended before all trains were compared, and a better one may be among the others: \
             fewer teeth, such as --sun 17..30, or one number of --stages let it come to its end",
            cut.join(" and ")
        ),
    })
}

impl Listed {
    fn of(
        wanted: &WantedStages,
        (within, most): (f64, usize),
        known: &mut KnownSets,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        if wanted.kind() != StageKind::Simple {
            return arranged::listed(wanted, (within, most), goes_on);
        }
        let searched = searched(wanted, (within, None), most, (known, goes_on))?;
        let all = &searched.found.all;
        Ok(Self {
            sets: searched.found.sets,
            trains: all.iter().map(|trains| TrainsOf::of(wanted, trains)).collect(),
            ended_early: all.iter().filter(|of| !of.is_complete).map(|of| of.stages).collect(),
            prices: searched.prices,
            shortest: searched.shortest,
        })
    }
}

/// The best trains within a part of the tolerance, and the one taken.
struct Class {
    within: f64,
    listed: Listed,
    /// Sizes of the train taken; `None` if no train holds and keeps to the limits.
    made: Option<Made>,
}

impl Class {
    /// Searches trains, and takes the best that keeps to the limits of the whole; what exceeds them is noted.
    fn of(
        wanted: &WantedStages,
        (within, most): (f64, usize),
        known: &mut KnownSets,
        limits: &mut OrderLimits,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let mut listed = Listed::of(wanted, (within, most), known, goes_on)?;
        *limits = limits.with(OrderLimits { shortest_m: listed.shortest, ..*limits }, false);
        let trains = &mut listed.trains;
        let cost = |place: &usize| trains[*place].cost().unwrap_or_default();
        let mut places: Vec<usize> =
            (0..trains.len()).filter(|place| trains[*place].cost().is_some()).collect();
        places.sort_by(|one, other| by_cost(cost(one), cost(other)));
        let mut made = None;
        for place in places {
            let Some(train) = &trains[place].best else { continue };
            let own = Made::of(wanted, train, listed.prices[place], goes_on)?;
            if limits.allow(own.masses.as_ref(), &own.sizes) {
                (trains[place].taken, made) = (true, Some(own));
                break;
            }
        }
        Ok(Self { within, listed, made })
    }

    /// Stages beyond usual practice of the best train.
    fn unusual(&self) -> Option<u32> {
        let best = self.listed.trains.iter().filter_map(|trains| trains.best.as_ref());
        best.map(|train| train.unusual_stages).min()
    }
}

/// Sizes of a train, with its file.
struct Made {
    efficiencies: [Option<f64>; 2],
    /// Torque on the input.
    torque: Torque,
    sizes: SizesStep,
    masses: Option<Masses>,
    file: String,
    warnings: Vec<Warning>,
}

impl Made {
    fn of(
        wanted: &WantedStages,
        train: &TrainOfStages,
        length_price: f64,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let efficiencies = efficiencies(wanted, &train.teeth)?;
        let torque = wanted.input_torque(train.ratio, efficiencies[0]);
        let document = document(wanted, &train.teeth, torque)?;
        let request = SizeRequest { length_price, ..wanted.size.clone() };
        let size = size::answer(&one(&document, &Choice::default())?, &request, goes_on)?;
        let file = size::saved(&document, &size)?;
        let warnings = warnings(&size, Some(&file), &wanted.size)?;
        let sizes = SizesStep::of(size);
        let masses = Masses::of(&file, &sizes, (wanted.size.application, wanted.overload))?;
        Ok(Self { efficiencies, torque, sizes, masses, file, warnings })
    }
}
