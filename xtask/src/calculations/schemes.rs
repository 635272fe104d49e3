//! Calculations of gearboxes and of the machines they serve.

use super::formulas::{GRID, evaluate, printed_formula, printed_quotient};
use super::{Calculation, Refusal, Results};
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::{Fraction, Mode, RingToSunRatio};
use epicyclic_schemes::catalogue::{Reach, RingToSunRange, Role, Scheme, simple_set};
use epicyclic_schemes::connection::{self, Connection, Shaft};
use epicyclic_schemes::machines::{self, Table};
use epicyclic_schemes::ratio_series::{PrintedSeries, RatioSeries};
use epicyclic_schemes::standing::{Standing, Use};
use epicyclic_schemes::{cutting, rotor};
use epicyclic_train::mobility;
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;
use uom::si::f64::{Acceleration, Angle, AngularVelocity, Force, Length, Velocity};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "schemes.gear",
            "state, ratio, speeds and efficiency of one gear of a gearbox",
            gear,
        ),
        Calculation::new("schemes.gear_ratios", "state and ratio of every gear of a gearbox", gear_ratios),
        Calculation::new("schemes.scheme", "a scheme of the catalogue: parameters, ratios, speeds", scheme),
        Calculation::new("schemes.scheme_range", "ratios of a scheme over a range of k", scheme_range),
        Calculation::new(
            "schemes.printed_formula",
            "whether a printed formula of a scheme equals the solver, and the catalogue, over k and η₀",
            printed_formula,
        ),
        Calculation::new(
            "schemes.printed_quotient",
            "quotient of two printed figures, and whether it lies within a printed range",
            printed_quotient,
        ),
        Calculation::new("schemes.row_range", "the six ratios of a row over a range of k", row_range),
        Calculation::new(
            "schemes.printed_relation",
            "whether a printed relation of speeds holds in a row, and the sum of its factors",
            printed_relation,
        ),
        Calculation::new("schemes.closing", "closing ratio and power of a pair of ratios", connection_of),
        Calculation::new("schemes.superposition", "ratio of a closed differential", superposition),
        Calculation::new("schemes.candidates", "the 36 ways to close a second row, sorted", connections),
        Calculation::new(
            "schemes.ratio_series",
            "ratios of 2 to 4 speeds beside a printed series",
            ratio_series,
        ),
        Calculation::new("schemes.mobility", "mobility of a plane mechanism", mobility_of),
        Calculation::new(
            "schemes.machines",
            "a table of machines beside the recommended speeds",
            machine_table,
        ),
        Calculation::new("schemes.recommended_speeds", "number of speeds for a range", recommended),
        Calculation::new("schemes.cutting_chain", "speed of a chain cutter", cutting_chain),
        Calculation::new("schemes.cutting_drum", "speed of a drum or auger cutter", cutting_drum),
        Calculation::new(
            "schemes.cutting_adjusted",
            "speed and feed of a cutter in other rock",
            cutting_adjusted,
        ),
        Calculation::new("schemes.rotor", "speeds of a bucket wheel", rotor_speeds),
        Calculation::new("schemes.discharge", "least speed of a bucket wheel from free flight", discharge),
    ]
}

/// A gearbox and which of its gears.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct GearGiven {
    /// The gearbox.
    gearbox: GearboxFile,
    /// Name of the gear.
    gear: String,
}

fn gear(given: &GearGiven) -> Result<Results, Refusal> {
    let gearbox = given.gearbox.gearbox()?;
    let found = gearbox.analyze(&given.gear)?;
    let mut results = Results::default();
    results.text("state", found.state().name());
    if !found.state().links().is_empty() {
        results.text("state_links", found.state().links().join(", "));
    }
    let Some(ratio) = found.ratio() else { return Ok(results) };
    results.number("ratio", ratio);
    if let Some(exact) = found.exact_ratio() {
        results.text("exact_ratio", fraction(exact));
    }
    for (name, speed) in gearbox.links().iter().zip(found.speeds()).skip(1) {
        if let Some(speed) = speed {
            results.number(format!("speed.{name}"), *speed);
        }
    }
    let fastest = found.speeds().iter().flatten().fold(0.0_f64, |fastest, speed| fastest.max(speed.abs()));
    results.answer("links_within_2", fastest <= 2.0);
    for (row, motion) in gearbox.sets().iter().zip(found.sets()) {
        for (place, planet) in motion.planets.iter().enumerate() {
            let Some(planet) = planet else { continue };
            let name = format!("planet.{}.{}", row.id(), place + 1);
            results.number(format!("{name}.relative"), planet.relative);
            if let Some(speed) = planet.speed {
                results.number(name, speed);
            }
        }
    }
    if let Some(ideal) = found.ideal() {
        results.number("circulating_power", ideal.power.circulating);
    }
    if let Some(efficiency) = found.efficiency() {
        results.number("efficiency", efficiency);
    }
    Ok(results)
}

fn fraction(exact: Fraction) -> String {
    if *exact.denom() == 1 { exact.numer().to_string() } else { exact.to_string() }
}

/// A gearbox.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct GearRatiosGiven {
    /// The gearbox.
    gearbox: GearboxFile,
}

fn gear_ratios(given: &GearRatiosGiven) -> Result<Results, Refusal> {
    let gearbox = given.gearbox.gearbox()?;
    let mut results = Results::default();
    let mut slowest: Option<(&str, f64)> = None;
    for gear in gearbox.gears() {
        let (name, found) = (gear.name(), gearbox.analyze_gear(gear)?);
        results.text(format!("state.{name}"), found.state().name());
        if let Some(ratio) = found.ratio() {
            if slowest.is_none_or(|(_, least)| ratio.abs() > least) {
                slowest = Some((name, ratio.abs()));
            }
            results.number(format!("ratio.{name}"), ratio).number(format!("inverse.{name}"), 1.0 / ratio);
        }
        if let Some(exact) = found.exact_ratio() {
            results.text(format!("exact.{name}"), fraction(exact));
        }
    }
    if let Some(slowest) = slowest {
        results.text("slowest", slowest.0);
    }
    let of_gearbox = gearbox.warnings().iter().map(ToString::to_string);
    let teeth = gearbox.tooth_checks(&BasicRack::default()).into_iter();
    for (place, warning) in of_gearbox.chain(teeth.map(|warning| warning.to_string())).enumerate() {
        results.text(format!("warning.{}", place + 1), warning);
    }
    Ok(results)
}

fn parameter(k: Number) -> Result<RingToSunRatio, Refusal> {
    Ok(RingToSunRatio::new(k.get())?)
}

/// A scheme and its parameters, or the ratios they shall give.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SchemeGiven {
    /// `I`, `II`, `III`, `I-1` … `III-3`.
    scheme: String,
    /// Parameter of row 1.
    #[serde(default)]
    k1: Option<Number>,
    /// Parameter of row 2.
    #[serde(default)]
    k2: Option<Number>,
    /// Ratio of gear 1, in place of `k1`.
    #[serde(default)]
    ratio1: Option<Number>,
    /// Ratio of gear 2, in place of `k2`.
    #[serde(default)]
    ratio2: Option<Number>,
    /// Efficiency `η₀` of a row under a resting carrier.
    efficiency: Number,
}

fn scheme(given: &SchemeGiven) -> Result<Results, Refusal> {
    let one_way = |what: &str| Refusal {
        name: "row-known-in-one-way".into(),
        message: format!("row {what}: give exactly one of k{what} and ratio{what}"),
    };
    let eta0 = MeshEfficiency::new(given.efficiency.get())?;
    let scheme: Scheme = given.scheme.parse()?;
    let first = scheme.first_stage();
    let k1 = match (given.k1, given.ratio1) {
        (Some(k), None) => parameter(k)?,
        (None, Some(ratio)) => first.ring_to_sun_ratio(ratio.get())?,
        _ => return Err(one_way("1")),
    };
    let mut results = Results::default();
    results.number("k1", k1.get());
    let gearbox = match scheme {
        Scheme::Two(scheme) => scheme.gearbox(k1, eta0)?,
        Scheme::Three(scheme) => {
            let k2 = match (given.k2, given.ratio2) {
                (Some(k), None) => parameter(k)?,
                (None, Some(ratio)) => scheme.second_ring_to_sun_ratio(k1, ratio.get())?,
                _ => return Err(one_way("2")),
            };
            results.number("k2", k2.get());
            results.number("closed_form.ratio.2", scheme.ratio(k1, k2));
            results.number("closed_form.efficiency.2", scheme.efficiency(k1, k2, eta0));
            scheme.gearbox(k1, k2, eta0)?
        }
    };
    let within = |range: RingToSunRange| {
        gearbox
            .sets()
            .iter()
            .all(|set| RingToSunRatio::new(-set.basic_ratio().get()).is_ok_and(|k| range.contains(k)))
    };
    results
        .answer("k_within_1.7_to_7", within(RingToSunRange::USED))
        .answer("k_within_1.3_to_10", within(RingToSunRange::RECOMMENDED));
    let mut fastest_planet: f64 = 0.0;
    let mut fastest_link: f64 = 0.0;
    for gear in gearbox.gears().iter().filter(|gear| gear.name() != "direct") {
        let (name, found) = (gear.name(), gearbox.analyze_gear(gear)?);
        if let (Some(ratio), Some(efficiency)) = (found.ratio(), found.efficiency()) {
            results.number(format!("ratio.{name}"), ratio);
            results.number(format!("efficiency.{name}"), efficiency);
        }
        for (row, motion) in found.sets().iter().enumerate() {
            for (member, speed) in ["a", "b", "H"].into_iter().zip(&motion.members) {
                let Some(speed) = *speed else { continue };
                fastest_link = fastest_link.max(speed.abs());
                results.number(format!("{name}.{member}{}", row + 1), speed);
            }
            for planet in motion.planets.iter().flatten() {
                fastest_planet = fastest_planet.max(planet.relative.abs());
                results.number(format!("{name}.g{}.relative", row + 1), planet.relative);
                if let Some(speed) = planet.speed {
                    results.number(format!("{name}.g{}", row + 1), speed);
                }
            }
        }
    }
    results.number("fastest_link", fastest_link).number("fastest_relative_planet", fastest_planet);
    results.answer("links_within_2", fastest_link <= 2.0).answer("planets_within_2", fastest_planet <= 2.0);
    Ok(results)
}

/// A scheme and a range of row parameters.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SchemeRangeGiven {
    /// `I`, `II`, `III`, `I-1` … `III-3`.
    scheme: String,
    /// Range of every `k`.
    k: RangeGiven,
}

/// A range of row parameters.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RangeGiven {
    /// The least `k`.
    low: Number,
    /// The greatest.
    high: Number,
}

fn parameter_range(given: RangeGiven) -> Result<RingToSunRange, Refusal> {
    Ok(RingToSunRange::new(given.low.get(), given.high.get())?)
}

fn scheme_range(given: &SchemeRangeGiven) -> Result<Results, Refusal> {
    let range = parameter_range(given.k)?;
    let scheme: Scheme = given.scheme.parse()?;
    let (ends, rows) = (scheme.ratio_range(range), scheme.sets());
    let [smallest, largest] = [ends[0].abs().min(ends[1].abs()), ends[0].abs().max(ends[1].abs())];
    let mut results = Results::default();
    for (place, links) in rows.into_iter().enumerate() {
        results.text(format!("row.{}", place + 1), links.map(Role::symbol).join(" "));
    }
    results.number("smallest", smallest).number("largest", largest);
    results.text("sense", if ends[0] > 0.0 { "same" } else { "opposite" });
    Ok(results)
}

/// A range of row parameters.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RowRangeGiven {
    /// Range of `k`.
    k: RangeGiven,
}

fn row_range(given: &RowRangeGiven) -> Result<Results, Refusal> {
    let range = parameter_range(given.k)?;
    let mut results = Results::default();
    for mode in Mode::ALL {
        let [from, to] = simple_set::ratio_range(mode, range);
        results.number(format!("{mode}.from"), from).number(format!("{mode}.to"), to);
    }
    Ok(results)
}

/// A printed relation `Σ factor·ω = 0` between the speeds of a row, its factors in `k`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PrintedRelationGiven {
    /// Factor of `ω_a`, `0` unless given.
    #[serde(default)]
    a: Option<String>,
    /// Factor of `ω_b`.
    #[serde(default)]
    b: Option<String>,
    /// Factor of `ω_H`.
    #[serde(default)]
    carrier: Option<String>,
    /// Factor of `ω_g`.
    #[serde(default)]
    planet: Option<String>,
}

fn printed_relation(given: &PrintedRelationGiven) -> Result<Results, Refusal> {
    let formulas = [&given.a, &given.b, &given.carrier, &given.planet];
    let (mut sum, mut is_listed): (f64, bool) = (0.0, true);
    for k in GRID {
        let mut factors = [0.0; 4];
        for (factor, formula) in factors.iter_mut().zip(formulas) {
            if let Some(formula) = formula {
                *factor = evaluate(formula, &[("k", k)])?;
            }
        }
        let close = |relation: &[f64; 4]| {
            relation.iter().zip(factors).all(|(right, printed)| (right - printed).abs() < 1e-12 * k)
        };
        is_listed &= simple_set::speed_relations(RingToSunRatio::new(k)?).iter().any(close);
        sum = sum.max(factors.iter().sum::<f64>().abs());
    }
    let mut results = Results::default();
    results.answer("holds", is_listed).number("sum", if sum < 1e-12 { 0.0 } else { sum });
    Ok(results)
}

/// A shaft of a scheme.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
enum ShaftGiven {
    D,
    B,
}

impl From<ShaftGiven> for Shaft {
    fn from(shaft: ShaftGiven) -> Self {
        match shaft {
            ShaftGiven::D => Self::Driving,
            ShaftGiven::B => Self::Driven,
        }
    }
}

/// Ratios of gears 1 and 2, and the shaft to which row 2 ties T₁.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ConnectionGiven {
    /// The shaft.
    onto: ShaftGiven,
    /// Ratio of gear 1.
    ratio1: Number,
    /// Ratio of gear 2.
    ratio2: Number,
}

fn connection_of(given: &ConnectionGiven) -> Result<Results, Refusal> {
    let (shaft, first, second) = (given.onto.into(), given.ratio1.get(), given.ratio2.get());
    let needed = connection::connection_ratio(shaft, first, second)?;
    let mut results = Results::default();
    results
        .number("closing_ratio", needed)
        .number("ratio2_again", connection::second_ratio(shaft, first, needed)?)
        .number("circulating_power", connection::circulating_power(shaft, first, second));
    let mut modes = 0;
    for mode in Mode::ALL {
        if let Ok(k) = simple_set::ring_to_sun_ratio(mode, needed) {
            results.number(format!("k2.{mode}"), k.get());
            modes += 1;
        }
    }
    results.count("modes", modes);
    Ok(results)
}

/// A differential A, Б, C with A and Б tied to one shaft I.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SuperpositionGiven {
    /// Ratio from C to A with Б at rest.
    from_a: Number,
    /// Ratio of the gear from A to I.
    a_tie: Number,
    /// Ratio of the gear from Б to I.
    b_tie: Number,
}

fn superposition(given: &SuperpositionGiven) -> Result<Results, Refusal> {
    let (from_a, a, b) = (given.from_a.get(), given.a_tie.get(), given.b_tie.get());
    let mut results = Results::default();
    results
        .number("ratio", connection::superposed_ratio(from_a, a, b))
        .number("with_b_at_rest", from_a * a)
        .number("with_a_at_rest", (1.0 - from_a) * b);
    Ok(results)
}

fn connections(given: &RowRangeGiven) -> Result<Results, Refusal> {
    let range = parameter_range(given.k)?;
    let all = Connection::all();
    let count = |wanted: &dyn Fn(&Connection) -> bool| all.iter().filter(|c| wanted(c)).count() as i64;
    let mut results = Results::default();
    results
        .count("candidates", count(&|_| true))
        .count("split_power", count(&|c| c.splits_power()))
        .count("listed", count(&|c| c.listed().is_some()))
        .count(
            "same_sign_and_slow",
            count(&|c| match c.standing(range) {
                Standing::Unlisted { usage, .. } => usage == Use::Slows,
                standing => matches!(standing, Standing::Listed(_)),
            }),
        )
        .count("missed", count(&|c| usage(c.standing(range)) == Some(Use::Slows)))
        .count("missed_for_some", count(&|c| usage(c.standing(range)) == Some(Use::SlowsAtSome)));
    for connection in all {
        let ratios = match connection.reach(range) {
            Reach::Between { least, greatest } => format!("{least:.3} to {greatest:.3}"),
            Reach::ThroughZero { least, greatest } => format!("{least:.3} through 0 to {greatest:.3}"),
            Reach::ThroughInfinity { below, above } => format!("below {below:.3} and above {above:.3}"),
        };
        let standing = match connection.standing(range) {
            Standing::Listed(scheme) => format!("scheme {scheme}"),
            Standing::Unlisted { usage, splits_power, .. } => {
                let power = if splits_power { "power splits" } else { "power circulates" };
                let usage = match usage {
                    Use::Slows => "slows down with the sign of gear 1",
                    Use::SlowsAtSome => "slows down with the sign of gear 1 at some k",
                    Use::OnlySpeedsUp => "only speeds up",
                    Use::Reverses => "reverses gear 1",
                    Use::ChangesSign => "changes its sign within the range",
                };
                format!("not listed: {power}; {usage}")
            }
            Standing::Reversed { .. } | Standing::OutsideRule { .. } => {
                unreachable!("the 36 are built by the rule")
            }
        };
        results.text(format!("{connection}"), format!("{ratios}, {standing}"));
    }
    Ok(results)
}

fn usage(standing: Standing) -> Option<Use> {
    match standing {
        Standing::Unlisted { usage, .. } => Some(usage),
        _ => None,
    }
}

/// Speeds of a machine, slowest first, and a printed series of ratios for as many.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RatioSeriesGiven {
    /// The speeds.
    speeds: Vec<Quantity<Velocity>>,
    /// Number of the printed series, which determines the place of direct drive: `(2.13)`.
    series: String,
}

fn ratio_series(given: &RatioSeriesGiven) -> Result<Results, Refusal> {
    let speeds: Vec<Velocity> = given.speeds.iter().map(|speed| speed.0).collect();
    let printed = PrintedSeries::numbered(&given.series).ok_or_else(|| Refusal {
        name: "unknown-series".into(),
        message: format!("no series {}: (2.10) to (2.21) and (2.33) to (2.35)", given.series),
    })?;
    let series = RatioSeries::of_speeds(&speeds, printed.direct().min(speeds.len().max(1)))?;
    let mut results = Results::default();
    results.number("d", series.speed_range());
    let q = (speeds[speeds.len() - 1] / speeds[speeds.len() - 2]).value;
    results.number("q", q);
    for (place, ratio) in series.ratios().iter().enumerate() {
        results.number(format!("ratio.{}", place + 1), *ratio);
    }
    for (place, ratio) in printed.members(q, series.speed_range()).iter().enumerate() {
        results.number(format!("printed.{}", place + 1), *ratio);
    }
    results.answer("printed_serves", printed.serves(&speeds, 1e-9)?);
    Ok(results)
}

/// Links and pairs of a plane mechanism.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MobilityGiven {
    /// Moving links, `n`.
    moving_links: u32,
    /// Bearings, `P₅`.
    lower_pairs: u32,
    /// Meshes, `P₄`.
    higher_pairs: u32,
}

fn mobility_of(given: &MobilityGiven) -> Result<Results, Refusal> {
    let mut results = Results::default();
    results.count("mobility", mobility::mobility(given.moving_links, given.lower_pairs, given.higher_pairs));
    Ok(results)
}

/// Table of machines.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MachinesGiven {
    /// `"1.1"` or `"1.2"`.
    table: String,
}

fn machine_table(given: &MachinesGiven) -> Result<Results, Refusal> {
    let table = Table::numbered(&given.table).ok_or_else(|| Refusal {
        name: "unknown-table".into(),
        message: format!("no table {}: 1.1 or 1.2", given.table),
    })?;
    let listed: Vec<_> = machines::machines().iter().filter(|machine| machine.table == table).collect();
    // Also of conveyors, for which the table is not drawn up: what it would give is compared with what they
    // have.
    let recommended = |machine: &machines::Machine| {
        machines::recommended_speeds(machine.speed_range).map(|found| found.speeds)
    };
    let mut results = Results::default();
    for machine in &listed {
        if let Some(steps) = machine.steps {
            results.count(format!("{}.steps", machine.name), steps);
        }
        results.number(format!("{}.range", machine.name), machine.speed_range);
        results.count(format!("{}.recommended", machine.name), recommended(machine)?);
    }
    let ranges = || listed.iter().map(|machine| machine.speed_range);
    let is_as_recommended = |machine: &&&machines::Machine| {
        machine.steps.zip(recommended(machine).ok()).map(|(steps, recommended)| steps == recommended)
    };
    let as_recommended = |wanted| listed.iter().filter(|m| is_as_recommended(m) == wanted).count() as i64;
    results
        .count("most_steps", listed.iter().filter_map(|machine| machine.steps).max().unwrap_or(0))
        .count("least_steps", listed.iter().filter_map(|machine| machine.steps).min().unwrap_or(0))
        .number("least_range", ranges().fold(f64::INFINITY, f64::min))
        .number("greatest_range", ranges().fold(0.0, f64::max))
        .count("as_recommended", as_recommended(Some(true)))
        .count("otherwise", as_recommended(Some(false)))
        .count("stepless", as_recommended(None));
    Ok(results)
}

/// A range of speeds.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RecommendedGiven {
    /// `d`, the fastest speed over the slowest.
    range: Number,
}

fn recommended(given: &RecommendedGiven) -> Result<Results, Refusal> {
    let recommendation = machines::recommended_speeds(given.range.get())?;
    let mut results = Results::default();
    results.count("speeds", recommendation.speeds).answer("printed", recommendation.printed);
    Ok(results)
}

/// A chain cutter.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CuttingChainGiven {
    /// Mean spacing of picks in a line.
    pick_spacing: Quantity<Length>,
    /// Feed.
    feed: Quantity<Velocity>,
    /// Mean thickness of the chip.
    mean_chip: Quantity<Length>,
}

fn cutting_chain(given: &CuttingChainGiven) -> Result<Results, Refusal> {
    let speed = cutting::chain_speed(given.pick_spacing.0, given.feed.0, given.mean_chip.0)?;
    let mut results = Results::default();
    // The source's own factor, with m, m/min and cm.
    let factor = speed * given.mean_chip.0 * 100.0 / (given.pick_spacing.0 * given.feed.0 * 60.0);
    results.quantity("speed", speed).number("factor", factor.value);
    Ok(results)
}

/// A drum or auger cutter.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CuttingDrumGiven {
    /// Diameter over the picks.
    diameter: Quantity<Length>,
    /// Feed.
    feed: Quantity<Velocity>,
    /// Greatest thickness of the chip.
    greatest_chip: Quantity<Length>,
    /// Picks in a line.
    picks_per_line: u32,
}

fn cutting_drum(given: &CuttingDrumGiven) -> Result<Results, Refusal> {
    let (diameter, feed, chip) = (given.diameter.0, given.feed.0, given.greatest_chip.0);
    let speed = cutting::drum_speed(diameter, feed, chip, given.picks_per_line)?;
    let factor = speed * chip * 100.0 * f64::from(given.picks_per_line) / (diameter * feed * 60.0);
    let mut results = Results::default();
    results
        .quantity("speed", speed)
        .number("factor", factor.value)
        .number("factor_by_geometry", 100.0 * std::f64::consts::PI / 60.0);
    Ok(results)
}

/// A cutter in two kinds of rock.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CuttingAdjustedGiven {
    /// Cutting speed.
    speed: Quantity<Velocity>,
    /// Feed.
    feed: Quantity<Velocity>,
    /// Mean cutting force.
    force: Quantity<Force>,
    /// Mean cutting force in the other rock.
    other_force: Quantity<Force>,
}

fn cutting_adjusted(given: &CuttingAdjustedGiven) -> Result<Results, Refusal> {
    let speed = cutting::speed_at_force(given.speed.0, given.force.0, given.other_force.0)?;
    let feed = cutting::matching_feed(given.feed.0, given.speed.0, speed)?;
    let mut results = Results::default();
    results
        .quantity("speed", speed)
        .quantity("feed", feed)
        .number("speed_times_force", ((speed * given.other_force.0) / (given.speed.0 * given.force.0)).value)
        .number("feed_to_speed", ((feed / speed) / (given.feed.0 / given.speed.0)).value);
    Ok(results)
}

/// A bucket wheel.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RotorGiven {
    /// Cutting radius of the boom.
    boom_radius: Quantity<Length>,
    /// Least slewing speed.
    slewing: Quantity<AngularVelocity>,
    /// Width of the chip.
    chip_width: Quantity<Length>,
    /// Number of buckets.
    buckets: u32,
    /// Slewing angle of the boom.
    boom_angle: Quantity<Angle>,
    /// Radius of the wheel.
    wheel_radius: Quantity<Length>,
    /// Discharge parameter Ω.
    discharge: Number,
}

fn rotor_speeds(given: &RotorGiven) -> Result<Results, Refusal> {
    let optimal = rotor::optimal_speed(
        given.boom_radius.0,
        given.slewing.0,
        given.chip_width.0,
        given.buckets,
        given.boom_angle.0,
    )?;
    let greatest = rotor::greatest_speed(optimal)?;
    let gravity: Acceleration = rotor::standard_gravity();
    let least = rotor::least_speed(given.discharge.get(), gravity, given.wheel_radius.0)?;
    // The boom slews faster by 1/cos φ, and the wheel turns from one bucket to the next.
    let slewing = given.slewing.0.value / libm::cos(given.boom_angle.0.value);
    let between_buckets_s = TAU / f64::from(given.buckets) / optimal.value;
    let mut results = Results::default();
    results
        .quantity("optimal", optimal)
        .quantity("advance_between_buckets", given.boom_radius.0 * (slewing * between_buckets_s))
        .quantity("greatest", greatest)
        .number("greatest_equation", (greatest.value - optimal.value) * greatest.value * 4.0)
        .quantity("least", least)
        .number(
            "centrifugal_to_gravity",
            least.value * least.value * given.wheel_radius.0.value / gravity.value,
        )
        .number("range", rotor::speed_range(greatest, least)?);
    let formula =
        greatest.value * (given.wheel_radius.0.value / (given.discharge.get() * gravity.value)).sqrt();
    results.answer("range_by_formula", (rotor::speed_range(greatest, least)? / formula - 1.0).abs() < 1e-12);
    Ok(results)
}

/// Where a particle leaves its bucket, and where the chute begins.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DischargeGiven {
    /// Angle of release, `τ₁`.
    release: Quantity<Angle>,
    /// Angle of the chute with the boom level, `τ*`.
    chute: Quantity<Angle>,
    /// Elevation of the boom, which turns the chute with it.
    #[serde(default)]
    elevation: Option<Quantity<Angle>>,
    /// Radius of the chute's edge over the wheel's, `ε_p`.
    radius_ratio: Number,
}

fn discharge(given: &DischargeGiven) -> Result<Results, Refusal> {
    let chute = given.elevation.map_or(given.chute.0, |elevation| given.chute.0 + elevation.0);
    let (release, epsilon) = (given.release.0, given.radius_ratio.get());
    let omega = rotor::discharge(release, chute, epsilon)?;
    // Fly it: wheel of radius 1, g = 1, so that the speed is √Ω.
    let (tau1, tau, speed) = (release.value, chute.value, omega.sqrt());
    let time = (libm::cos(tau1) - epsilon * libm::cos(tau)) / (speed * libm::sin(tau1));
    let height = libm::sin(tau1) + speed * libm::cos(tau1) * time - time * time / 2.0;
    let mut results = Results::default();
    results
        .number("discharge", omega)
        .answer("flies_there", (height - epsilon * libm::sin(tau)).abs() < 1e-12 * (1.0 + time * time));
    Ok(results)
}
