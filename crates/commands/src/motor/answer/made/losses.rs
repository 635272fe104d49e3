//! Leaks and friction of a motor, and its efficiencies over speed and pressure.

use super::{Inputs, LossInputs, Point};
use crate::error::Error;
use crate::shared::number::{plain, si};
use crate::tolerance::beside_zero;
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::efficiency::OperatingPoint;
use epicyclic_hydromotor::flanks::SealingContact;
use epicyclic_hydromotor::leakage::{GapFlow, Regime};
use epicyclic_hydromotor::ports::PortPlate;
use epicyclic_hydromotor::profile::Profile;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Pressure};

/// Parts of the speed and of the pressure given, at which the map stands.
const PARTS: u32 = 20;

/// Losses by models of gaps and friction from what is given of them; nothing is measured.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Losses {
    /// Through the gaps at the end faces; null without gaps, oil, width and pressure.
    pub leakage: Option<Leakage>,
    /// Of the flanks; null without friction, width and pressure.
    pub friction: Option<Friction>,
    /// At the speed and pressure given, with all losses; null where something is missing.
    pub at_point: Option<Efficiency>,
    /// Over twentieths of the speed and of the pressure given; null with it.
    pub map: Option<EfficiencyMap>,
    /// What is missing for the efficiencies, by its key.
    pub missing: Vec<String>,
}

/// Leaks through gaps.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Leakage {
    /// Gap at a face of a satellite, warm.
    pub satellite_gap_m: f64,
    /// Gap at a face of the rotor, warm.
    pub rotor_gap_m: f64,
    /// At one satellite that parts the pressures, both faces.
    pub satellite: Gap,
    /// How many do.
    pub loaded_satellites: u32,
    /// At the rotor, both faces.
    pub rotor: Gap,
    /// All together.
    pub flow_m3_s: f64,
}

/// The flow through the gaps of a wheel.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gap {
    /// The flow.
    pub flow_m3_s: f64,
    /// Its Reynolds number.
    pub reynolds: f64,
    /// Whether the law of turbulent flow that was given holds, and not the laminar one.
    pub is_turbulent: bool,
}

/// Friction of the flanks. Of two values the first is with the greatest coefficient.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Friction {
    /// Coefficients, the greatest first.
    pub coefficients: [f64; 2],
    /// Mean torque that it takes.
    pub torque_n_m: [f64; 2],
    /// The same over the mean torque without losses.
    pub share: [f64; 2],
    /// Least torque at the start, at the worst angle, with the contacts where they are there; null without
    /// teeth.
    pub starting_torque_n_m: Option<[f64; 2]>,
    /// The same without friction.
    pub starting_torque_without_n_m: Option<f64>,
    /// That angle.
    pub worst_at_rad: Option<f64>,
}

/// The motor at a speed and a pressure. Of two values the first is with the greatest friction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Efficiency {
    /// Speed.
    pub speed_rad_s: f64,
    /// Pressure drop.
    pub pressure_pa: f64,
    /// What flows in.
    pub inlet_flow_m3_s: f64,
    /// Of it through gaps.
    pub leakage_m3_s: f64,
    /// Of it to compress the oil; 0 without a bulk modulus.
    pub charge_m3_s: f64,
    /// Torque of the shaft.
    pub torque_n_m: [f64; 2],
    /// Friction of the flanks.
    pub flank_friction_n_m: [f64; 2],
    /// Drag of the gaps.
    pub gap_drag_n_m: f64,
    /// Power that the ports take; 0 without their discharge coefficient.
    pub throttling_w: f64,
    /// Volumetric efficiency.
    pub volumetric: f64,
    /// Mechanical efficiency; below 0 where the losses are more than the torque.
    pub mechanical: [f64; 2],
    /// Total efficiency.
    pub total: [f64; 2],
}

/// Efficiencies over speed and pressure; a row for each pressure with a value for each speed, of two with the
/// greatest friction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EfficiencyMap {
    /// Speeds.
    pub speeds_rad_s: Vec<f64>,
    /// Pressure drops.
    pub pressures_pa: Vec<f64>,
    /// Volumetric efficiencies.
    pub volumetric: Vec<Vec<f64>>,
    /// Mechanical efficiencies.
    pub mechanical: Vec<Vec<f64>>,
    /// Total efficiencies.
    pub total: Vec<Vec<f64>>,
    /// Total efficiencies with the least friction.
    pub total_with_least_friction: Vec<Vec<f64>>,
}

impl Losses {
    pub(crate) fn of(
        motor: &Motor,
        plate: Option<&PortPlate>,
        inputs: &Inputs,
        point: Point,
    ) -> Result<Option<Self>, Error> {
        if inputs.gaps.is_none() && inputs.friction.is_none() {
            return Ok(None);
        }
        let fluid = inputs.fluid();
        let leakage = match (inputs.gaps, &fluid, point.width, point.pressure) {
            (Some(gaps), Ok(fluid), Some(_), Some(drop)) => {
                let found = motor.end_leakage(gaps, *fluid, drop)?;
                Some(Leakage {
                    satellite_gap_m: si(gaps.satellite),
                    rotor_gap_m: si(gaps.rotor),
                    satellite: Gap::of(found.satellite),
                    loaded_satellites: found.loaded_satellites,
                    rotor: Gap::of(found.rotor),
                    flow_m3_s: si(found.total),
                })
            }
            _ => None,
        };
        let friction = match (inputs.friction, point.width, point.pressure) {
            (Some(range), Some(width), Some(drop)) => {
                let alpha = point.form.pressure_angle;
                let [low, high] = motor.mean_friction_torque(alpha, width, drop, range)?;
                let profile = Profile::new(motor, point.form).ok();
                let start = profile
                    .map(|profile| profile.starting_torque(SealingContact::default(), width, drop, range))
                    .transpose()?;
                let whole = si(motor.theoretical_torque(width, drop)?);
                let [least, most] = range.ends();
                Some(Friction {
                    coefficients: [most, least],
                    torque_n_m: [si(high), si(low)],
                    share: [si(high) / whole, si(low) / whole],
                    starting_torque_n_m: start.map(|start| start.range.map(si)),
                    starting_torque_without_n_m: start.map(|start| si(start.frictionless)),
                    worst_at_rad: start.map(|start| beside_zero(start.rotation)),
                })
            }
            _ => None,
        };
        let mut missing: Vec<String> = vec![];
        let mut lacks = |is_missing: bool, key: &str| {
            if is_missing {
                missing.push(key.to_owned());
            }
        };
        lacks(inputs.gaps.is_none(), "gaps");
        for key in fluid.as_ref().err().into_iter().flatten() {
            lacks(true, key);
        }
        lacks(inputs.friction.is_none(), "friction");
        lacks(point.width.is_none(), "width");
        lacks(point.pressure.is_none(), "pressure");
        lacks(point.speed.is_none(), "speed");
        let (mut at_point, mut map) = (None, None);
        if let (Some(gaps), Ok(fluid), Some(friction), Some(width), Some(drop), Some(speed)) =
            (inputs.gaps, fluid, inputs.friction, point.width, point.pressure, point.speed)
        {
            let inputs = LossInputs {
                pressure_angle: point.form.pressure_angle,
                width,
                gaps,
                bore_radius: inputs.bore_radius,
                fluid,
                bulk_modulus: inputs.bulk_modulus,
                dead_area: inputs.dead_area,
                friction,
                ports: plate.zip(inputs.discharge),
            };
            at_point = Some(Efficiency::of(&motor.operating_point(inputs, speed, drop)?));
            map = Some(EfficiencyMap::of(motor, inputs, speed, drop)?);
        }
        Ok(Some(Self { leakage, friction, at_point, map, missing }))
    }
}

impl Gap {
    fn of(flow: GapFlow) -> Self {
        Self {
            flow_m3_s: si(flow.flow),
            reynolds: plain(flow.reynolds),
            is_turbulent: flow.regime == Regime::Turbulent,
        }
    }
}

impl Efficiency {
    fn of(point: &OperatingPoint) -> Self {
        Self {
            speed_rad_s: si(point.speed),
            pressure_pa: si(point.pressure_drop),
            inlet_flow_m3_s: si(point.inlet_flow),
            leakage_m3_s: si(point.leakage.total),
            charge_m3_s: si(point.charge),
            torque_n_m: point.torque.map(si),
            flank_friction_n_m: point.flank_friction.map(si),
            gap_drag_n_m: si(point.gap_drag),
            throttling_w: si(point.throttling),
            volumetric: point.volumetric,
            mechanical: point.mechanical,
            total: point.total,
        }
    }
}

impl EfficiencyMap {
    fn of(
        motor: &Motor,
        inputs: LossInputs<'_>,
        speed: AngularVelocity,
        drop: Pressure,
    ) -> Result<Self, Error> {
        let part = |place: u32| f64::from(place) / f64::from(PARTS);
        let speeds: Vec<AngularVelocity> = (1..=PARTS).map(|place| speed * part(place)).collect();
        let drops: Vec<Pressure> = (1..=PARTS).map(|place| drop * part(place)).collect();
        let map = motor.efficiency_map(inputs, &speeds, &drops)?;
        let rows = |of: fn(&OperatingPoint) -> f64| -> Vec<Vec<f64>> {
            map.rows.iter().map(|row| row.iter().map(of).collect()).collect()
        };
        Ok(Self {
            speeds_rad_s: speeds.into_iter().map(si).collect(),
            pressures_pa: drops.into_iter().map(si).collect(),
            volumetric: rows(|point| point.volumetric),
            mechanical: rows(|point| point.mechanical[0]),
            total: rows(|point| point.total[0]),
            total_with_least_friction: rows(|point| point.total[1]),
        })
    }
}
