//! Calculations of the teeth of hydromotors, and of the search for motors.

use super::{Calculation, Refusal, Results};
use epicyclic_formats::Span;
use epicyclic_formats::motor::MotorFile;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::Profile;
use epicyclic_hydromotor::profile::limits::{Limit, LimitKind};
use epicyclic_hydromotor::search::{MotorSearch, Requirements, Size};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Length, Pressure, Torque, Volume};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "hydromotor.teeth",
            "circles of the satellites, clearances of the flanks, limits of the teeth",
            teeth,
        ),
        Calculation::new(
            "hydromotor.search",
            "motors of a wanted displacement or torque that no other surpasses",
            searched,
        ),
    ]
}

/// A motor with its teeth.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TeethGiven {
    /// The motor, with the keys of a motor file.
    motor: MotorFile,
}

/// Positions of the rotor within a half-lobe at which clearances are measured; the least is refined between
/// them.
const STEPS: u32 = 90;

fn teeth(given: &TeethGiven) -> Result<Results, Refusal> {
    let (motor, _) = given.motor.motor()?;
    let form = given.motor.teeth.clone().unwrap_or_default().form();
    let profile = Profile::new(&motor, form)?;
    let [tip, root] = profile.satellite_radii();
    let clearances = profile.clearances(STEPS)?;
    let mut results = Results::default();
    results
        .quantity("satellite.tip_radius", tip)
        .quantity("satellite.root_radius", root)
        .quantity("clearance.stator", clearances.stator.clearance)
        .quantity("clearance.rotor", clearances.rotor.clearance)
        .quantity("clearance.neighbours", clearances.neighbours.0)
        .quantity("clearance.wheels", clearances.wheels)
        .answer("turns_freely", clearances.free());
    let limits = profile.limits();
    for limit in &limits {
        let name = format!("limit.{}.{}", limit_name(limit.kind), wheel_name(limit.wheel));
        results.answer(format!("{name}.holds"), limit.holds()).quantity(name, limit.value);
    }
    results.answer("all_limits_hold", limits.iter().all(Limit::holds));
    Ok(results)
}

fn limit_name(kind: LimitKind) -> &'static str {
    match kind {
        LimitKind::Undercut => "undercut",
        LimitKind::TipCusp => "tip_cusp",
        LimitKind::SatelliteRoot => "satellite_root",
        LimitKind::WheelRoot => "wheel_root",
        LimitKind::TipThickness => "tip_thickness",
        LimitKind::ContactPath => "contact_path",
        LimitKind::RootCurve => "root_curve",
        LimitKind::TipCurve => "tip_curve",
        LimitKind::Neighbours => "neighbours",
        LimitKind::Wheels => "wheels",
    }
}

fn wheel_name(wheel: Wheel) -> &'static str {
    match wheel {
        Wheel::Stator => "stator",
        Wheel::Rotor => "rotor",
        Wheel::Satellite => "satellite",
    }
}

/// The wanted motor, and the bounds of the search.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SearchGiven {
    /// Displacement a revolution; or give `torque`.
    #[serde(default)]
    displacement: Option<Quantity<Volume>>,
    /// Mean torque without losses, at `pressure`; or give `displacement`.
    #[serde(default)]
    torque: Option<Quantity<Torque>>,
    /// Pressure drop.
    #[serde(default)]
    pressure: Option<Quantity<Pressure>>,
    /// Modules to choose from. Default: the preferred ones.
    #[serde(default)]
    modules: Option<Vec<Quantity<Length>>>,
    /// Lobes of the stator, `5` or `4..7`.
    stator_lobes: Span<u32>,
    /// Teeth of the stator.
    stator_teeth: Span<u32>,
    /// Teeth of a satellite.
    satellite_teeth: Span<u32>,
    /// Greatest ripple. Default: any.
    #[serde(default)]
    ripple: Option<Number>,
}

fn searched(given: &SearchGiven) -> Result<Results, Refusal> {
    let mut requirements = match (given.displacement, given.torque, given.pressure) {
        (Some(displacement), None, pressure) => Requirements {
            pressure_drop: pressure.map(|pressure| pressure.0),
            ..Requirements::of_displacement(displacement.0)
        },
        (None, Some(torque), Some(pressure)) => Requirements::of_torque(torque.0, pressure.0)?,
        _ => {
            let message = "give displacement, or torque with pressure".to_owned();
            return Err(Refusal { name: "displacement-or-torque".into(), message });
        }
    };
    if let Some(modules) = &given.modules {
        requirements.size = Size::Modules(modules.iter().map(|module| module.0).collect());
    }
    let usual = Bounds::default();
    let closed = |span: Span<u32>, usual| {
        span.closed(usual).map_err(|error| Refusal { name: "range".into(), message: error.to_string() })
    };
    let bounds = Bounds {
        stator_lobes: closed(given.stator_lobes, usual.stator_lobes)?,
        stator_teeth: closed(given.stator_teeth, usual.stator_teeth)?,
        satellite_teeth: closed(given.satellite_teeth, usual.satellite_teeth)?,
    };
    let wanted = requirements.displacement;
    let mut search = MotorSearch::new(requirements);
    search.bounds = bounds;
    search.limits.ripple = given.ripple.map(Number::get);
    let found = search.front()?;
    let mut results = Results::default();
    results
        .count("sets", found.funnel.sets as i64)
        .count("without_family", found.funnel.without_family as i64)
        .count("designs", found.designs.len() as i64);
    let sizes = || found.designs.iter().flat_map(|design| &design.dimensions);
    let is_wanted = |volume: Volume| ((volume - wanted) / wanted).value.abs() < 1e-12;
    // Rounding alone may part the displacement of a size from the wanted one.
    results.answer("all_have_the_displacement", sizes().all(|size| is_wanted(size.displacement)));
    let surpassed = found.designs.iter().any(|one| {
        found.designs.iter().any(|other| {
            other.displacement_by_volume > one.displacement_by_volume
                && other.ripple < one.ripple
                && other.least_radius > one.least_radius
        })
    });
    results.answer("one_surpasses_another", surpassed);
    if let Some(design) = found.designs.first() {
        let numbers = design.numbers;
        results
            .text(
                "first.numbers",
                format!(
                    "{}x{} {}/{}/{}",
                    numbers.rotor_lobes(),
                    numbers.stator_lobes(),
                    numbers.stator_teeth(),
                    numbers.rotor_teeth(),
                    numbers.satellite_teeth()
                ),
            )
            .number("first.displacement_by_volume", design.displacement_by_volume)
            .number("first.ripple", design.ripple);
        if let Some(size) = design.dimensions.first() {
            results
                .quantity("first.module", size.module)
                .quantity("first.width", size.width)
                .quantity("first.outer_diameter", size.outer_diameter)
                .quantity("first.displacement", size.displacement);
            if let Some(torque) = size.torque {
                results.quantity("first.torque", torque);
            }
        }
    }
    Ok(results)
}
