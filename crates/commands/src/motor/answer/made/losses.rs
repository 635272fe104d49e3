//! Leakage and friction of a motor, and its efficiencies over speed and pressure.

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

/// Number of steps of the map, up to the given speed and up to the given pressure.
const PARTS: u32 = 20;

/// Losses by models of gaps and friction; nothing is measured.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Losses {
    /// Leakage through the gaps at the end faces; null without gaps, oil, width and pressure.
    pub leakage: Option<Leakage>,
    /// Friction of the flanks; null without friction, width and pressure.
    pub friction: Option<Friction>,
    /// Efficiencies at the given speed and pressure, with all losses; null if a value is missing.
    pub at_point: Option<Efficiency>,
    /// Efficiencies in steps of a twentieth of the given speed and pressure; null if a value is missing.
    pub map: Option<EfficiencyMap>,
    /// Keys of the values that are missing for the efficiencies.
    pub missing: Vec<String>,
}

/// Leakage through gaps.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Leakage {
    /// Axial gap at a face of a satellite at operating temperature, in m.
    pub satellite_gap_m: f64,
    /// Axial gap at a face of the rotor at operating temperature, in m.
    pub rotor_gap_m: f64,
    /// Leakage at both faces of one satellite that separates the pressures.
    pub satellite: Gap,
    /// Number of satellites that separate the pressures.
    pub loaded_satellites: u32,
    /// Leakage at both faces of the rotor.
    pub rotor: Gap,
    /// Total leakage in m³/s.
    pub flow_m3_s: f64,
}

/// Flow through the gaps of a wheel.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gap {
    /// Flow in m³/s.
    pub flow_m3_s: f64,
    /// Reynolds number of the flow.
    pub reynolds: f64,
    /// Whether the flow is turbulent, so that the given law of turbulent flow applies instead of the laminar
    /// one.
    pub is_turbulent: bool,
}

/// Friction of the flanks. The first of two values is with the greatest coefficient.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Friction {
    /// Coefficients of friction, the greatest first.
    pub coefficients: [f64; 2],
    /// Mean friction torque in N·m.
    pub torque_n_m: [f64; 2],
    /// Mean friction torque over the mean torque without losses.
    pub share: [f64; 2],
    /// Least torque at the start in N·m, at the worst angle, with the contacts at their places there; null
    /// without teeth.
    pub starting_torque_n_m: Option<[f64; 2]>,
    /// Least torque at the start without friction, in N·m; null without teeth.
    pub starting_torque_without_n_m: Option<f64>,
    /// Rotor angle of the least starting torque, in rad; null without teeth.
    pub worst_at_rad: Option<f64>,
}

/// Efficiencies of the motor at a speed and a pressure. The first of two values is with the greatest
/// friction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Efficiency {
    /// Rotor speed in rad/s.
    pub speed_rad_s: f64,
    /// Pressure drop in Pa.
    pub pressure_pa: f64,
    /// Inlet flow in m³/s.
    pub inlet_flow_m3_s: f64,
    /// Leakage through gaps in m³/s, a part of the inlet flow.
    pub leakage_m3_s: f64,
    /// Flow that compresses the oil in m³/s, a part of the inlet flow; 0 without a bulk modulus.
    pub charge_m3_s: f64,
    /// Torque of the shaft in N·m.
    pub torque_n_m: [f64; 2],
    /// Friction torque of the flanks in N·m.
    pub flank_friction_n_m: [f64; 2],
    /// Drag torque of the gaps in N·m.
    pub gap_drag_n_m: f64,
    /// Power lost by throttling in the ports, in W; 0 without a discharge coefficient.
    pub throttling_w: f64,
    /// Volumetric efficiency.
    pub volumetric: f64,
    /// Mechanical efficiency; below 0 if the losses exceed the torque.
    pub mechanical: [f64; 2],
    /// Total efficiency.
    pub total: [f64; 2],
}

/// Efficiencies over speed and pressure: a row for each pressure with a value for each speed. Of two values
/// the one with the greatest friction is given.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EfficiencyMap {
    /// Rotor speeds in rad/s.
    pub speeds_rad_s: Vec<f64>,
    /// Pressure drops in Pa.
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
                    // The worst case comes first, as in all pairs of this answer.
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
        // All keys are checked, so that one message lists everything that is missing.
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
        // The map begins at the first step, because no efficiency is defined at speed or pressure 0.
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
