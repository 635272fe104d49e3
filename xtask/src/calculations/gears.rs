//! Calculations of one gear set.

use super::{Calculation, Refusal, Results};
use epicyclic_gears::bearing::{self, Series, Verification};
use epicyclic_gears::efficiency::{MeshEfficiency, efficiency};
use epicyclic_gears::geometry::{GearKind, ToothedGear, centre_distance};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::{BasicRatio, Member, Mode, RingToSunRatio};
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::{Bounds, Placement};
use epicyclic_gears::{ToothCount, shaft, willis};
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Torque};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new("gears.row", "stationary ratio of a row and its ratios in all six modes", row),
        Calculation::new(
            "gears.tooth_conditions",
            "coaxiality, neighbours and assembly of a tooth set",
            tooth_conditions,
        ),
        Calculation::new(
            "gears.planets_over_k",
            "planets of sets with one sun and one module, over the ring's teeth",
            planets_over_k,
        ),
        Calculation::new(
            "gears.tooth_synthesis",
            "every tooth set for a wanted ratio, the most exact first",
            tooth_synthesis,
        ),
        Calculation::new("gears.efficiency", "efficiency of a row from that of its meshes", row_efficiency),
        Calculation::new("gears.speeds", "speeds of a row's members and planets from any two", speeds),
        Calculation::new("gears.wheel", "diameters of a wheel", wheel),
        Calculation::new("gears.centre_distance", "centre distance of two wheels in mesh", wheel_pair),
        Calculation::new("gears.shaft", "shaft diameter by reduced torsional stress", shaft_diameter),
        Calculation::new("gears.bearing", "dimensions of a deep-groove ball bearing", bearing_of),
    ]
}

/// The value of π that a source calculates with; what it computes from the true one is scaled.
pub(super) fn pi_factor(pi: Option<Number>) -> f64 {
    pi.map_or(1.0, |pi| pi.get() / PI)
}

/// A mode of a row: driving and driven member; the third one rests.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ModeGiven {
    /// The driving member.
    input: MemberGiven,
    /// The driven member.
    output: MemberGiven,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum MemberGiven {
    Sun,
    Ring,
    Carrier,
}

impl From<MemberGiven> for Member {
    fn from(given: MemberGiven) -> Self {
        match given {
            MemberGiven::Sun => Self::Sun,
            MemberGiven::Ring => Self::Ring,
            MemberGiven::Carrier => Self::Carrier,
        }
    }
}

impl TryFrom<ModeGiven> for Mode {
    type Error = Refusal;

    fn try_from(given: ModeGiven) -> Result<Self, Refusal> {
        Ok(Self::new(given.input.into(), given.output.into())?)
    }
}

/// A row, known in one of four ways.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RowGiven {
    /// Row parameter `k = z_b/z_a` of a simple row.
    #[serde(default)]
    k: Option<Number>,
    /// Teeth of sun and ring of a simple row.
    #[serde(default)]
    teeth: Option<SunAndRing>,
    /// Stationary ratio `i₀`.
    #[serde(default)]
    basic_ratio: Option<Number>,
    /// The ratio it has in a mode.
    #[serde(default)]
    ratio: Option<RatioInMode>,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SunAndRing {
    /// Teeth of the sun, `z_a`.
    sun: u32,
    /// Teeth of the ring, `z_b`.
    ring: u32,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RatioInMode {
    /// The ratio `ω_in/ω_out`.
    value: Number,
    /// The mode in which the row has it.
    mode: ModeGiven,
}

impl TryFrom<RowGiven> for BasicRatio {
    type Error = Refusal;

    fn try_from(given: RowGiven) -> Result<Self, Refusal> {
        match (given.k, given.teeth, given.basic_ratio, given.ratio) {
            (Some(k), None, None, None) => Ok(RingToSunRatio::new(k.get())?.into()),
            (None, Some(teeth), None, None) => {
                Ok(Self::simple(ToothCount::new(teeth.sun)?, ToothCount::new(teeth.ring)?))
            }
            (None, None, Some(i0), None) => Ok(Self::new(i0.get())?),
            (None, None, None, Some(ratio)) => {
                Ok(Self::with_ratio(ratio.value.get(), ratio.mode.try_into()?)?)
            }
            _ => Err(Refusal {
                name: "row-known-in-one-way".into(),
                message: "give exactly one of k, teeth, basic_ratio and ratio".into(),
            }),
        }
    }
}

fn row(given: &RowGiven) -> Result<Results, Refusal> {
    let row = BasicRatio::try_from(*given)?;
    let mut results = Results::default();
    results.number("basic_ratio", row.get());
    if let Ok(k) = RingToSunRatio::new(-row.get()) {
        results.number("ring_to_sun_ratio", k.get()).number("planet_to_sun", k.planet_to_sun());
    }
    for mode in Mode::ALL {
        results.number(format!("ratio.{mode}"), row.ratio(mode)?);
    }
    Ok(results)
}

/// A tooth set to be checked.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ToothConditionsGiven {
    /// Teeth of the sun.
    sun: u32,
    /// Teeth of a planet.
    planet: u32,
    /// Teeth of the ring.
    ring: u32,
    /// Number of planets.
    planets: u32,
    /// Addendum coefficient `h_a*`, 1 unless given.
    #[serde(default)]
    addendum: Option<Number>,
}

fn tooth_conditions(given: &ToothConditionsGiven) -> Result<Results, Refusal> {
    let [sun, planet, ring] = [given.sun, given.planet, given.ring].map(ToothCount::new);
    let (sun, planet, ring) = (sun?, planet?, ring?);
    let neighbours = TipCircle::of_planet(sun, planet, &rack(given.addendum, None));
    let row = BasicRatio::simple(sun, ring);
    let spacing = PlanetSpacing::least_unequal(sun, ring, given.planets);
    let coaxiality = i64::from(sun.get()) + 2 * i64::from(planet.get()) - i64::from(ring.get());
    let mut results = Results::default();
    results
        .number("basic_ratio", row.get())
        .number("ratio", row.ratio(Mode::SUN_TO_CARRIER)?)
        .count("coaxiality_difference", coaxiality)
        .count("most_planets", neighbours.most(0.0))
        .number("slots_per_planet", spacing.slots() as f64 / f64::from(given.planets.max(1)))
        .answer("assembles_equally_spaced", spacing.is_equal())
        .quantity("planet_angle", Angle::from_si(TAU / f64::from(given.planets.max(1))))
        .quantity("smallest_planet_angle", spacing.smallest_gap());
    if let Some(limit) = neighbours.number_limit(0.0) {
        results.number("neighbour_limit", limit);
    }
    Ok(results)
}

/// Sets with the same sun, in order of their rings.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PlanetsOverKGiven {
    /// Teeth of the sun.
    sun: u32,
    /// Teeth of each ring, rising; with those of the sun even.
    rings: Vec<u32>,
}

fn planets_over_k(given: &PlanetsOverKGiven) -> Result<Results, Refusal> {
    let sun = ToothCount::new(given.sun)?;
    let mut results = Results::default();
    let (mut sizes, mut most) = (vec![], vec![]);
    for &ring in &given.rings {
        let planet = ToothCount::new(ring.saturating_sub(given.sun) / 2)?;
        let k = RingToSunRatio::new(f64::from(ring) / f64::from(given.sun))?;
        sizes.push(k.planet_to_sun());
        most.push(TipCircle::of_planet(sun, planet, &rack(None, None)).most(0.0));
        let (size, most) = (sizes[sizes.len() - 1], most[most.len() - 1]);
        results.number(format!("planet_to_sun.{ring}"), size).count(format!("most_planets.{ring}"), most);
    }
    let falls = most.windows(2).all(|pair| pair[0] >= pair[1]) && most.first() > most.last();
    results
        .answer("planets_grow", sizes.windows(2).all(|pair| pair[0] < pair[1]))
        .answer("fewer_planets_fit", falls);
    Ok(results)
}

/// Required ratio, with the bounds of the search for tooth numbers.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ToothSynthesisGiven {
    /// The wanted ratio, from the sun to the carrier with the ring at rest.
    ratio: Number,
    /// Relative tolerance of the ratio, 0 unless given.
    #[serde(default)]
    tolerance: Option<Number>,
    /// Least and greatest teeth of the sun, 12 to 200 unless given.
    #[serde(default)]
    sun: Option<[u32; 2]>,
    /// Least and greatest teeth of the planet, 12 to 200 unless given.
    #[serde(default)]
    planet: Option<[u32; 2]>,
    /// Least and greatest teeth of the ring, 12 to 200 unless given.
    #[serde(default)]
    ring: Option<[u32; 2]>,
    /// Least and greatest number of planets, 3 to 8 unless given.
    #[serde(default)]
    planets: Option<[u32; 2]>,
    /// Whether planets may sit unevenly where they do not assemble evenly.
    #[serde(default)]
    unequal_spacing: bool,
}

fn tooth_synthesis(given: &ToothSynthesisGiven) -> Result<Results, Refusal> {
    let defaults = Bounds::default();
    let range =
        |given: Option<[u32; 2]>, default: RangeInclusive<u32>| given.map_or(default, |[from, to]| from..=to);
    let bounds = Bounds {
        sun: range(given.sun, defaults.sun),
        planet: range(given.planet, defaults.planet),
        ring: range(given.ring, defaults.ring),
        planets: range(given.planets, defaults.planets),
        placement: if given.unequal_spacing { Placement::LeastUnequal } else { Placement::Equal },
        ..Bounds::default()
    };
    let mode = Mode::SUN_TO_CARRIER;
    let found = bounds.for_ratio(given.ratio.get(), mode, given.tolerance.map_or(0.0, Number::get))?;
    let best = &found[0];
    let mut results = Results::default();
    results
        .count("found", found.len() as i64)
        .count("sun", best.teeth.sun.get())
        .count("planet", best.teeth.planet.get())
        .count("ring", best.teeth.ring.get())
        .count("planets", best.teeth.planets)
        .text("exact_ratio", best.exact_ratio)
        // A deviation within the rounding of the required ratio does not count.
        .answer("deviates", best.ratio_error.abs() > 1e-12)
        .number("ratio_error", best.ratio_error);
    Ok(results)
}

/// A row, the efficiencies of its meshes, and how it is used.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EfficiencyGiven {
    /// The row.
    row: RowGiven,
    /// Efficiencies of the meshes that the power passes one after the other.
    meshes: Vec<Number>,
    /// Driving and driven member.
    mode: ModeGiven,
}

fn row_efficiency(given: &EfficiencyGiven) -> Result<Results, Refusal> {
    let row = BasicRatio::try_from(given.row)?;
    let mode = Mode::try_from(given.mode)?;
    let meshes =
        given.meshes.iter().map(|eta| MeshEfficiency::new(eta.get())).collect::<Result<Vec<_>, _>>()?;
    let eta0 = MeshEfficiency::of_meshes(&meshes);
    let efficiency = efficiency(row, eta0, mode)?;
    let mut results = Results::default();
    results
        .number("basic_efficiency", eta0.get())
        .number("stationary_loss", eta0.loss())
        .number("efficiency", efficiency);
    if eta0.loss() > 0.0 {
        // How much of the stationary loss the mode pays: |1/U − 1| from the sun to the carrier.
        results.number("loss_share", (1.0 - efficiency) / eta0.loss());
    }
    Ok(results)
}

/// A row and two of its speeds.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SpeedsGiven {
    /// The row.
    row: RowGiven,
    /// Speed of the sun.
    #[serde(default)]
    sun: Option<Quantity<AngularVelocity>>,
    /// Speed of the ring.
    #[serde(default)]
    ring: Option<Quantity<AngularVelocity>>,
    /// Speed of the carrier.
    #[serde(default)]
    carrier: Option<Quantity<AngularVelocity>>,
    /// Planet to sun, `z_g/z_a`; of a simple row `(k − 1)/2` unless given.
    #[serde(default)]
    planet_to_sun: Option<Number>,
    /// The value of π that the source takes for `ω = π·n/30`.
    #[serde(default)]
    pi: Option<Number>,
}

fn speeds(given: &SpeedsGiven) -> Result<Results, Refusal> {
    let row = BasicRatio::try_from(given.row)?;
    let known = |speed: Option<Quantity<AngularVelocity>>| speed.map(|speed| speed.0);
    let speeds = willis::speeds(row, known(given.sun), known(given.ring), known(given.carrier))?;
    let scale = pi_factor(given.pi);
    let mut results = Results::default();
    results
        .quantity("sun", speeds.sun * scale)
        .quantity("ring", speeds.ring * scale)
        .quantity("carrier", speeds.carrier * scale)
        .answer("carrier_faster_than_sun", speeds.carrier.abs() > speeds.sun.abs());
    let planet_to_sun = match given.planet_to_sun {
        Some(ratio) => Some(ratio.get()),
        None => RingToSunRatio::new(-row.get()).ok().map(RingToSunRatio::planet_to_sun),
    };
    if let Some(ratio) = planet_to_sun {
        let planet = willis::planet_speed(ratio, speeds.sun, speeds.carrier)?;
        results
            .quantity("planet", planet.absolute * scale)
            .quantity("planet_relative", planet.relative * scale);
    }
    Ok(results)
}

#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum GearKindGiven {
    #[default]
    External,
    Internal,
}

impl From<GearKindGiven> for GearKind {
    fn from(given: GearKindGiven) -> Self {
        match given {
            GearKindGiven::External => Self::External,
            GearKindGiven::Internal => Self::Internal,
        }
    }
}

/// A wheel.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct WheelGiven {
    /// Module.
    module: Quantity<Length>,
    /// Number of teeth.
    teeth: u32,
    /// External unless given.
    #[serde(default)]
    gear_kind: GearKindGiven,
    /// Addendum coefficient `h_a*`, 1 unless given.
    #[serde(default)]
    addendum: Option<Number>,
    /// Clearance coefficient `c*`, 0.25 unless given.
    #[serde(default)]
    clearance: Option<Number>,
}

pub(super) fn rack(addendum: Option<Number>, clearance: Option<Number>) -> BasicRack {
    let default = BasicRack::default();
    BasicRack {
        addendum: addendum.map_or(default.addendum, Number::get),
        clearance: clearance.map_or(default.clearance, Number::get),
        ..default
    }
}

fn wheel(given: &WheelGiven) -> Result<Results, Refusal> {
    let rack = rack(given.addendum, given.clearance);
    let wheel =
        ToothedGear::new(given.gear_kind.into(), given.module.0, ToothCount::new(given.teeth)?, rack)?;
    let mut results = Results::default();
    results
        .quantity("pitch_diameter", wheel.pitch_diameter())
        .quantity("tip_diameter", wheel.tip_diameter())
        .quantity("root_diameter", wheel.root_diameter())
        .quantity("base_diameter", wheel.base_diameter());
    Ok(results)
}

/// Two wheels in mesh.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct WheelPairGiven {
    /// Module of both.
    module: Quantity<Length>,
    /// Teeth of the first, external wheel.
    first: u32,
    /// Teeth of the second wheel.
    second: u32,
    /// ToothShape of the second wheel, external unless given.
    #[serde(default)]
    second_kind: GearKindGiven,
}

fn wheel_pair(given: &WheelPairGiven) -> Result<Results, Refusal> {
    let wheel = |gear_kind: GearKind, teeth: u32| {
        ToothedGear::new(gear_kind, given.module.0, ToothCount::new(teeth)?, BasicRack::default())
    };
    let first = wheel(GearKind::External, given.first)?;
    let second = wheel(given.second_kind.into(), given.second)?;
    let mut results = Results::default();
    results.quantity("centre_distance", centre_distance(&first, &second)?);
    Ok(results)
}

/// A shaft under torsion.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ShaftGiven {
    /// Torque of the shaft.
    torque: Quantity<Torque>,
    /// Allowable, reduced torsional stress.
    allowable_stress: Quantity<Pressure>,
    /// A diameter whose stress is asked too.
    #[serde(default)]
    given_diameter: Option<Quantity<Length>>,
}

fn shaft_diameter(given: &ShaftGiven) -> Result<Results, Refusal> {
    let needed = shaft::diameter(given.torque.0, given.allowable_stress.0)?;
    let mut results = Results::default();
    results
        .quantity("diameter", needed)
        .quantity("standard_diameter", shaft::standard_diameter(needed)?)
        .quantity("bearing_bore", bearing::smallest_for_shaft(Series::Medium300, needed)?.bore);
    if let Some(diameter) = given.given_diameter {
        results.quantity("stress", shaft::torsional_stress(given.torque.0, diameter.0)?);
    }
    Ok(results)
}

/// A bearing by its designation.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BearingGiven {
    /// Designation such as `"310"`.
    designation: String,
}

fn bearing_of(given: &BearingGiven) -> Result<Results, Refusal> {
    let bearing = bearing::by_designation(&given.designation)?;
    let mut results = Results::default();
    results
        .quantity("bore", bearing.bore)
        .quantity("outside_diameter", bearing.outside_diameter)
        .quantity("width", bearing.width)
        .answer("confirmed_by_catalogue", bearing.verification == Verification::Confirmed);
    Ok(results)
}
