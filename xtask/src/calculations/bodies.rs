//! Calculations of the bodies of a gear set: volumes, masses and inertias of wheels and carriers.

use super::gears::{pi_factor, rack};
use super::{Calculation, Refusal, Results};
use epicyclic_gears::ToothCount;
use epicyclic_gears::carrier::{Arm, Carrier, Hole, Hub};
use epicyclic_gears::geometry::{GearKind, ToothedGear};
use epicyclic_gears::mass::{FormulaEight, GearBody, published_gear_inertia};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Area, Length, Mass, MassDensity, MomentOfInertia, Volume};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new("gears.wheel_mass", "volumes, mass and inertia of an external wheel", wheel_mass),
        Calculation::new(
            "gears.published_wheel_inertia",
            "inertia of a wheel by formula (8) of excavator-dynamics, in both readings",
            wheel_inertia_by_formula_8,
        ),
        Calculation::new("gears.carrier_arm", "length of a carrier's arm", carrier_arm),
        Calculation::new("gears.carrier", "mass, centroid and inertia of a carrier", carrier),
    ]
}

/// An external wheel with a bore.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct WheelMassGiven {
    /// Module.
    module: Quantity<Length>,
    /// Number of teeth.
    teeth: u32,
    /// Addendum coefficient `h_a*`, 1 unless given.
    #[serde(default)]
    addendum: Option<Number>,
    /// Clearance coefficient `c*`, 0.25 unless given.
    #[serde(default)]
    clearance: Option<Number>,
    /// Face width.
    face_width: Quantity<Length>,
    /// Diameter of the bore.
    bore: Quantity<Length>,
    /// Density.
    density: Quantity<MassDensity>,
    /// The value of π that the source takes.
    #[serde(default)]
    pi: Option<Number>,
}

fn wheel_mass(given: &WheelMassGiven) -> Result<Results, Refusal> {
    let rack = rack(given.addendum, given.clearance);
    let wheel = ToothedGear::new(GearKind::External, given.module.0, ToothCount::new(given.teeth)?, rack)?;
    let body = GearBody::external(&wheel, given.face_width.0, given.bore.0, given.density.0)?;
    // Volume, mass and inertia of a body of revolution are all proportional to π.
    let scale = pi_factor(given.pi);
    let mut results = Results::default();
    results
        .quantity("tooth_zone_volume", body.tooth_zone.volume * scale)
        .quantity("body_volume", body.body.volume * scale)
        .quantity("volume", body.total().volume * scale)
        .quantity("mass", body.total().mass * scale)
        .quantity("inertia", body.total().polar_inertia * scale);
    Ok(results)
}

/// A wheel's mass and the circles of formula (8).
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct FormulaEightGiven {
    /// Mass of the wheel.
    mass: Quantity<Mass>,
    /// Tip diameter.
    tip_diameter: Quantity<Length>,
    /// Root diameter.
    root_diameter: Quantity<Length>,
    /// Diameter of the bore.
    bore: Quantity<Length>,
}

fn wheel_inertia_by_formula_8(given: &FormulaEightGiven) -> Result<Results, Refusal> {
    let by = |reading| -> Result<MomentOfInertia, Refusal> {
        let (tip, root, bore) = (given.tip_diameter.0, given.root_diameter.0, given.bore.0);
        Ok(published_gear_inertia(reading, given.mass.0, tip, root, bore)?)
    };
    let mut results = Results::default();
    results
        .quantity("likely_reading", by(FormulaEight::Likely)?)
        .quantity("literal_reading", by(FormulaEight::Literal)?);
    Ok(results)
}

/// Where a carrier's arm begins and ends.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CarrierArmGiven {
    /// Radius of the planets' centres.
    planet_radius: Quantity<Length>,
    /// How far it reaches beyond them.
    beyond: Quantity<Length>,
    /// Outer radius of the hub.
    hub_radius: Quantity<Length>,
}

fn carrier_arm(given: &CarrierArmGiven) -> Result<Results, Refusal> {
    let length = Arm::length_from_hub(given.planet_radius.0, given.beyond.0, given.hub_radius.0);
    let mut results = Results::default();
    results.quantity("length", length);
    Ok(results)
}

/// A carrier of flat arms with holes, and a hub ring.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CarrierGiven {
    /// Number of arms.
    arms: u32,
    /// The plate of an arm.
    arm: ArmGiven,
    /// The ring about the axis.
    hub: HubGiven,
    /// Density.
    density: Quantity<MassDensity>,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArmGiven {
    /// Length along the radius, from the hub's outside.
    length: Quantity<Length>,
    /// Width across.
    width: Quantity<Length>,
    /// Thickness.
    thickness: Quantity<Length>,
    /// Radius of its hole.
    hole_radius: Quantity<Length>,
    /// Distance of the hole's centre from the outer end.
    hole_from_outer_end: Quantity<Length>,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HubGiven {
    /// Outer radius.
    outer_radius: Quantity<Length>,
    /// Inner radius.
    inner_radius: Quantity<Length>,
    /// Width along the axis.
    width: Quantity<Length>,
    /// The value of π that the source takes for the hub.
    #[serde(default)]
    pi: Option<Number>,
}

fn carrier(given: &CarrierGiven) -> Result<Results, Refusal> {
    let hole = Hole { radius: given.arm.hole_radius.0, from_outer_end: given.arm.hole_from_outer_end.0 };
    let arm = Arm {
        length: given.arm.length.0,
        width: given.arm.width.0,
        thickness: given.arm.thickness.0,
        hole: Some(hole),
    };
    let hub = Hub {
        outer_radius: given.hub.outer_radius.0,
        inner_radius: given.hub.inner_radius.0,
        width: given.hub.width.0,
    };
    let carrier = Carrier::new(given.arms, arm, hub, given.density.0)?;
    let scale = pi_factor(given.hub.pi);
    let plate: Area = arm.length * arm.width;
    let net: Volume = carrier.arm().volume;
    let published = carrier.published_inertia();
    let mut results = Results::default();
    results
        .quantity("plate_area", plate)
        .quantity("hole_area", plate - net / arm.thickness)
        .quantity("arm_area", net / arm.thickness)
        .quantity("arm_volume", net)
        .quantity("arm_mass", carrier.arm().mass)
        .quantity("hub_volume", carrier.hub().volume * scale)
        .quantity("hub_mass", carrier.hub().mass * scale)
        .quantity("mass", carrier.arms().mass + carrier.hub().mass * scale)
        .quantity("arm_centroid_from_outer_end", carrier.arm_centroid_from_outer_end())
        .quantity("arms_inertia", carrier.arms().polar_inertia)
        .quantity("hub_inertia", carrier.hub().polar_inertia * scale)
        .quantity("inertia", carrier.arms().polar_inertia + carrier.hub().polar_inertia * scale)
        .quantity("published_way.arms_inertia", published.arms)
        .quantity("published_way.hub_inertia", published.hub * scale)
        .quantity("published_way.inertia", published.arms + published.hub * scale);
    Ok(results)
}
