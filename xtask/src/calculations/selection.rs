//! Calculations of the choice of a gearbox: structures, selection, drawing.

use super::{Calculation, Refusal, Results};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout as drawability;
use epicyclic_layout::{Options, Verdict};
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::catalogue::ThreeSpeed;
use epicyclic_schemes::direct_drive::{direct_clutch_options, direct_clutch_options_of_set};
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::{Family, Role, Structure};
use epicyclic_selection::size::{Rating, relative_ring_diameter};
use epicyclic_selection::{Candidate, Limits, Mechanism, Requirements, Selection, Space, select};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::Velocity;

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new("schemes.select", "gearboxes for given speeds, judged and compared", selected),
        Calculation::new(
            "schemes.compare",
            "whether one gearbox of two sets is better than another, each for its ratios",
            compared,
        ),
        Calculation::new(
            "schemes.structures",
            "all two-row structures, and why a source has them",
            structures,
        ),
        Calculation::new("schemes.limits", "the limits by which gearboxes are judged", limits),
        Calculation::new(
            "schemes.size_over_k",
            "size of a set for one torque of its carrier, over the range of k",
            size_over_k,
        ),
        Calculation::new(
            "schemes.brake_torques",
            "brake torques of all structures for two ratios, with and without losses",
            brake_torques,
        ),
        Calculation::new(
            "schemes.direct_clutches",
            "torque and slip of every option for the direct-drive clutch",
            direct_clutches,
        ),
        Calculation::new("schemes.drawable", "which of the listed schemes can be drawn", drawable),
    ]
}

/// Wanted speeds or ratios, and what to choose among.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SelectGiven {
    /// Output speeds, rising; or give `ratios`.
    #[serde(default)]
    speeds: Option<Vec<Quantity<Velocity>>>,
    /// Ratios of the braked gears; or give `speeds`.
    #[serde(default)]
    ratios: Option<Vec<Number>>,
    /// Efficiency of each row under a resting carrier, 0.9702 unless given.
    #[serde(default)]
    efficiency: Option<Number>,
    /// Whether to choose among all two-row structures instead of the source's schemes.
    #[serde(default)]
    all_structures: bool,
    /// Name of a scheme or structure whose numbers are asked.
    #[serde(default)]
    candidate: Option<String>,
}

/// Name of a mechanism: the source's if it has one.
fn name(mechanism: Mechanism) -> String {
    mechanism.scheme().map_or_else(|| mechanism.to_string(), |scheme| scheme.to_string())
}

fn selected(given: &SelectGiven) -> Result<Results, Refusal> {
    let series = match (&given.speeds, &given.ratios) {
        (Some(speeds), None) => {
            RatioSeries::of_speeds(&speeds.iter().map(|speed| speed.0).collect::<Vec<_>>(), 1)?
        }
        (None, Some(ratios)) => {
            RatioSeries::of_braked_gears(&ratios.iter().map(|i| i.get()).collect::<Vec<_>>())?
        }
        _ => {
            let message = "give either speeds or ratios".into();
            return Err(Refusal { name: "speeds-or-ratios".into(), message });
        }
    };
    let mut requirements = Requirements::new(series);
    if let Some(eta) = given.efficiency {
        requirements.eta0 = MeshEfficiency::new(eta.get())?;
    }
    let space = if given.all_structures { Space::All } else { Space::Catalogue };
    let found = select(&requirements, &space)?;
    let accepted: Vec<String> =
        found.best.iter().map(|&place| name(found.accepted[place].mechanism)).collect();
    let mut results = Results::default();
    results
        .count("accepted", found.accepted.len() as i64)
        .count("rejected", found.rejected.len() as i64)
        .count("unreachable", found.unreachable.len() as i64)
        .count("reachable", (found.accepted.len() + found.rejected.len()) as i64)
        .count("considered", (found.accepted.len() + found.rejected.len() + found.unreachable.len()) as i64)
        .text("best", accepted.first().map_or("none", String::as_str));
    if !given.all_structures {
        results.text("accepted_schemes", accepted.join(", "));
    }
    if requirements.series.braked().len() == 2 {
        results.count("unlisted_above_98_per_cent", unlisted_above(&found, 0.98) as i64);
    }
    if let Some(wanted) = &given.candidate {
        let all = found.accepted.iter().chain(&found.rejected);
        let unknown = || Refusal {
            name: "no-such-candidate".into(),
            message: format!("{wanted} is not among the candidates for these ratios"),
        };
        numbers(all.into_iter().find(|c| name(c.mechanism) == *wanted).ok_or_else(unknown)?, &mut results);
    }
    Ok(results)
}

/// How many of the 36 candidates outside the source's eleven, both rows at work, have positive ratios and
/// this efficiency in both gears, whatever else there is to object to.
fn unlisted_above(found: &Selection, efficiency: f64) -> usize {
    let all = found.accepted.iter().chain(&found.rejected);
    let mut structures: Vec<Structure> = all
        .filter_map(|candidate| {
            let Mechanism::TwoSets(structure) = candidate.mechanism else { return None };
            let fits = structure.scheme().is_none()
                && structure.family() != Family::Parallel
                && candidate.k.iter().all(|k| (1.3..=10.0).contains(k))
                && candidate
                    .gears
                    .iter()
                    .all(|gear| gear.ratio > 0.0 && gear.efficiency.is_some_and(|eta| eta > efficiency));
            fits.then_some(structure)
        })
        .collect();
    structures.sort_unstable();
    structures.dedup();
    structures.len()
}

fn numbers(candidate: &Candidate, results: &mut Results) {
    for (row, k) in candidate.k.iter().enumerate() {
        results.number(format!("k{}", row + 1), *k);
    }
    for gear in &candidate.gears {
        results.number(format!("ratio.{}", gear.gear.name()), gear.ratio);
        if let Some(eta) = gear.efficiency {
            results.number(format!("efficiency.{}", gear.gear.name()), eta);
        }
        if let Some(torque) = gear.brake_torque {
            results.number(format!("brake_torque.{}", gear.gear.name()), torque);
        }
        results.number(format!("ideal_brake_torque.{}", gear.gear.name()), gear.ideal_brake_torque);
    }
    if let Some(clutch) = candidate.direct_clutches.first() {
        results.text("least_lock", clutch.pair.map(Role::symbol).join(" "));
    }
    let objections: Vec<String> =
        candidate.objections().map(|verdict| verdict.criterion.to_string()).collect();
    results
        .number("largest_speed", candidate.objectives.speed)
        .text("objections", if objections.is_empty() { "none".into() } else { objections.join(", ") })
        .answer("accepted_candidate", candidate.is_accepted());
}

/// A gearbox of two sets, and the ratios that it is to have.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ComparedGiven {
    /// Name of its scheme or structure.
    candidate: String,
    /// Ratios of its braked gears.
    ratios: Vec<Number>,
}

/// Two gearboxes for one machine.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CompareGiven {
    /// The gearbox that may be better.
    first: ComparedGiven,
    /// The gearbox that it is held against.
    second: ComparedGiven,
    /// Efficiency of each row under a resting carrier, 0.9702 unless given.
    #[serde(default)]
    efficiency: Option<Number>,
}

impl ComparedGiven {
    fn candidate(&self, efficiency: Option<Number>) -> Result<Candidate, Refusal> {
        let ratios: Vec<f64> = self.ratios.iter().map(|ratio| ratio.get()).collect();
        let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&ratios)?);
        if let Some(eta) = efficiency {
            requirements.eta0 = MeshEfficiency::new(eta.get())?;
        }
        let found = select(&requirements, &Space::All)?;
        let all = found.accepted.into_iter().chain(found.rejected);
        all.into_iter().find(|candidate| name(candidate.mechanism) == self.candidate).ok_or_else(|| Refusal {
            name: "no-such-candidate".into(),
            message: format!("{} is not among the candidates for these ratios", self.candidate),
        })
    }
}

/// Members that the two sets share, as places of sun, ring and carrier.
fn shared_members(mechanism: Mechanism) -> Vec<[usize; 2]> {
    let Mechanism::TwoSets(structure) = mechanism else { return vec![] };
    let [first, second] = structure.sets();
    let mut shared = vec![];
    for (place, role) in first.iter().enumerate() {
        shared.extend(second.iter().position(|other| other == role).map(|other| [place, other]));
    }
    shared
}

fn compared(given: &CompareGiven) -> Result<Results, Refusal> {
    let [first, second] =
        [given.first.candidate(given.efficiency)?, given.second.candidate(given.efficiency)?];
    let mut results = Results::default();
    for (name, candidate) in [("first", &first), ("second", &second)] {
        results
            .answer(format!("{name}.keeps_all_limits"), candidate.is_accepted())
            .number(format!("{name}.largest_speed"), candidate.objectives.speed)
            .number(format!("{name}.least_efficiency"), candidate.objectives.efficiency)
            .answer(format!("{name}.turns_one_way"), !candidate.mixes_directions());
    }
    let lower_speeds = first.objectives.speed < second.objectives.speed;
    let higher_efficiency = first.objectives.efficiency > second.objectives.efficiency;
    // What the limits leave open is decided by speeds and efficiency where both say the same.
    let better = match (first.is_accepted(), second.is_accepted()) {
        (true, false) => true,
        (false, true) => false,
        _ => lower_speeds && higher_efficiency,
    };
    let (one, mut other) = (shared_members(first.mechanism), shared_members(second.mechanism));
    let is_same = one == other || {
        other.iter_mut().for_each(|pair| pair.reverse());
        other.sort_unstable();
        one == other
    };
    results
        .answer("first_has_lower_speeds", lower_speeds)
        .answer("first_has_higher_efficiency", higher_efficiency)
        .answer("sets_are_joined_alike", is_same)
        .answer("first_is_better", better);
    Ok(results)
}

/// The range of row parameters within which a structure's use is judged.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct StructuresGiven {
    /// Least and greatest row parameter.
    k: [Number; 2],
}

fn structures(given: &StructuresGiven) -> Result<Results, Refusal> {
    let [low, high] = given.k.map(Number::get);
    if !(low > 1.0 && low <= high) {
        return Err(Refusal {
            name: "row-parameter-range".into(),
            message: format!("k from {low} to {high}: above 1, the smaller first"),
        });
    }
    let all = Structure::all();
    let count = |holds: &dyn Fn(&Standing) -> bool| {
        all.iter().filter(|structure| holds(&Standing::of(**structure, &(low..=high)))).count() as i64
    };
    let mut drawable = 0;
    for structure in &all {
        let gearbox = structure.gearbox([2.5, 2.5], MeshEfficiency::IDEAL, [Role::D, Role::B])?;
        drawable += i64::from(drawability::is_drawable(&gearbox));
    }
    let mut results = Results::default();
    results
        .count("structures", all.len() as i64)
        .count("listed", count(&|standing| matches!(standing, Standing::Listed(_))))
        .count("missed", count(&|standing| standing.is_missed()))
        .count(
            "out_of_reach",
            count(&|standing| matches!(standing, Standing::Unlisted { .. }) && !standing.is_missed()),
        )
        .count("reversed", count(&|standing| matches!(standing, Standing::Reversed { .. })))
        .count("outside_the_rule", count(&|standing| matches!(standing, Standing::OutsideRule { .. })))
        .count("drawable", drawable);
    Ok(results)
}

/// No inputs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LimitsGiven {}

fn limits(_: &LimitsGiven) -> Result<Results, Refusal> {
    // Of any ratios: the limits do not depend on them.
    let requirements = Requirements::new(RatioSeries::of_braked_gears(&[2.0])?);
    let Limits { ring_to_sun, preferred, efficiency, link_speed, planet_speed, clutch_slip, .. } =
        requirements.limits;
    let mut results = Results::default();
    results
        .number("ratio_error", requirements.tolerance)
        .number("k.from", *ring_to_sun.start())
        .number("k.to", *ring_to_sun.end())
        .number("preferred_k.from", *preferred.start())
        .number("preferred_k.to", *preferred.end())
        .number("efficiency", efficiency)
        .number("link_speed", link_speed)
        .number("planet_speed", planet_speed)
        .number("clutch_slip", clutch_slip);
    Ok(results)
}

/// The range of `k`, and the interval in which the smallest set is said to lie.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SizeOverKGiven {
    /// Least and greatest `k`.
    k: [Number; 2],
    /// Ends of the interval.
    best: [Number; 2],
}

fn size_over_k(given: &SizeOverKGiven) -> Result<Results, Refusal> {
    const STEPS: u32 = 870;
    let ([low, high], [from, to]) = (given.k.map(Number::get), given.best.map(Number::get));
    if !(low > 1.0 && low < high) {
        return Err(Refusal {
            name: "row-parameter-range".into(),
            message: format!("k from {low} to {high}: above 1, the smaller first"),
        });
    }
    let rating = Rating::default();
    // The sun carries 1/(1 + k) of the carrier's torque.
    let ring = |k: f64| relative_ring_diameter(k, 1.0 / (1.0 + k), rating.planets, &rating);
    // The face width goes with the smaller of sun and planet.
    let volume = |k: f64| ring(k) * ring(k) * ring(k) / k * ((k - 1.0) / 2.0).min(1.0);
    let ks: Vec<f64> = (0..=STEPS).map(|i| low + (high - low) * f64::from(i) / f64::from(STEPS)).collect();
    let least = |size: &dyn Fn(f64) -> f64| {
        ks.iter().copied().min_by(|one, other| size(*one).total_cmp(&size(*other))).unwrap_or(low)
    };
    let (by_ring, by_volume) = (least(&ring), least(&volume));
    let grows = |ks: &mut dyn Iterator<Item = &f64>| {
        let sizes: Vec<f64> = ks.map(|k| ring(*k)).collect();
        sizes.windows(2).all(|pair| pair[0] < pair[1])
    };
    let above = grows(&mut ks.iter().filter(|k| **k >= by_ring));
    let below = grows(&mut ks.iter().rev().filter(|k| **k <= by_ring));
    let mut results = Results::default();
    results
        .number("least_ring_at", by_ring)
        .answer("least_ring_within", (from - 1e-9..=to + 1e-9).contains(&by_ring))
        .answer("ring_grows_to_both_ends", above && below)
        .number("least_volume_at", by_volume);
    for (name, k) in [("from", from), ("to", to), ("low", low), ("high", high)] {
        results.number(format!("ring_over_least.{name}"), ring(k) / ring(by_ring));
        results.number(format!("volume_over_least.{name}"), volume(k) / volume(by_volume));
    }
    Ok(results)
}

/// Ratios of the braked gears.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BrakedRatiosGiven {
    /// One or two ratios.
    ratios: Vec<Number>,
}

fn brake_torques(given: &BrakedRatiosGiven) -> Result<Results, Refusal> {
    let ratios: Vec<f64> = given.ratios.iter().map(|ratio| ratio.get()).collect();
    let found = select(&Requirements::new(RatioSeries::of_braked_gears(&ratios)?), &Space::All)?;
    let candidates = || found.accepted.iter().chain(&found.rejected);
    let mut results = Results::default();
    results.count("gearboxes", candidates().count() as i64);
    let (mut same_without, mut same_with) = (true, true);
    for wanted in ratios {
        let gears = candidates().flat_map(|candidate| &candidate.gears);
        let gears: Vec<_> = gears.filter(|gear| (gear.ratio / wanted - 1.0).abs() < 1e-9).collect();
        let ends = |torques: &mut dyn Iterator<Item = f64>| {
            torques.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], torque| {
                [least.min(torque), most.max(torque)]
            })
        };
        let without = ends(&mut gears.iter().map(|gear| gear.ideal_brake_torque));
        let with = ends(&mut gears.iter().filter_map(|gear| gear.brake_torque));
        same_without &= without[1] - without[0] < 1e-9;
        same_with &= with[1] - with[0] < 1e-9;
        results
            .number(format!("{wanted}.without_losses"), without[0])
            .number(format!("{wanted}.least_with_losses"), with[0])
            .number(format!("{wanted}.greatest_with_losses"), with[1]);
    }
    results.answer("same_without_losses", same_without).answer("same_with_losses", same_with);
    Ok(results)
}

fn direct_clutches(given: &BrakedRatiosGiven) -> Result<Results, Refusal> {
    let options = match *given.ratios.iter().map(|ratio| ratio.get()).collect::<Vec<_>>() {
        [ratio] => direct_clutch_options_of_set(ratio),
        [first, second] => direct_clutch_options([first, second]),
        _ => {
            let message = format!("{} ratios: one or two", given.ratios.len());
            return Err(Refusal { name: "ratio-count".into(), message });
        }
    };
    let torques = || options.iter().map(|option| option.torque.abs());
    let mut results = Results::default();
    for option in &options {
        let pair = option.pair.map(Role::symbol).join(" ");
        results.number(format!("torque.{pair}"), option.torque);
        for (place, slip) in option.slip.iter().take(given.ratios.len()).enumerate() {
            results.number(format!("slip.{pair}.{}", place + 1), *slip);
        }
    }
    results
        .answer("some_below_the_input", torques().any(|torque| torque < 1.0 - 1e-9))
        .answer("some_above_the_input", torques().any(|torque| torque > 1.0 + 1e-9));
    Ok(results)
}

/// No inputs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DrawableGiven {}

fn drawable(_: &DrawableGiven) -> Result<Results, Refusal> {
    let mut results = Results::default();
    for scheme in ThreeSpeed::ALL {
        let gearbox = scheme.structure().gearbox([2.5, 2.5], MeshEfficiency::IDEAL, [Role::D, Role::B])?;
        let drawn = match drawability::draw(&gearbox, Options::default()) {
            Verdict::Drawable(layout) => {
                assert!(layout.crossings().is_empty(), "a drawing with crossings is no drawing");
                true
            }
            Verdict::SelfCrossing(_) => false,
        };
        results.answer(scheme.name(), drawn);
    }
    Ok(results)
}
