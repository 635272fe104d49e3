//! Ports as manufactured: opening and closing angles, pressure in closed chambers, throttling in the
//! openings.

use super::{Inputs, Point};
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::number::{maybe_si, si};
use epicyclic_hydromotor::ports::throttling::Through;
use epicyclic_hydromotor::ports::timing::{self, Stretch, Timing};
use epicyclic_hydromotor::ports::trapped::Trapped;
use epicyclic_hydromotor::ports::{PortPlate, PortShape};
use epicyclic_hydromotor::quantity::PortSide;
use epicyclic_units::Physical as _;
use epicyclic_units::format;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Angle;

/// Ports as manufactured. Phases are those of a chamber, 0 at its greatest area.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MadePorts {
    /// High-pressure port of the first crest.
    pub high: Port,
    /// Low-pressure port of the first crest.
    pub low: Port,
    /// Least distance between a high-pressure and a low-pressure port, in m.
    pub land_m: f64,
    /// Rotation of the rotor in rad after which a chamber is in the same state again.
    pub cycle_rad: f64,
    /// Openings of a chamber in the order of its phase.
    pub states: Vec<PortState>,
    /// Parts of the cycle in which a chamber is closed.
    pub closed: Vec<ClosedStretch>,
    /// Chamber at its least and at its greatest area.
    pub extremes: [ChamberExtreme; 2],
    /// Oil that the chambers take per revolution to reach the high pressure, in m³; null without bulk
    /// modulus, width and pressure.
    pub charge_m3: Option<f64>,
    /// Oil for compression over the displacement; null without bulk modulus, width and pressure.
    pub charge_share: Option<f64>,
    /// Throttling by the high-pressure and the low-pressure ports; empty without discharge coefficient,
    /// density, width and speed.
    pub throttling: Vec<Throttling>,
}

/// Port: a hole or a kidney.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Port {
    /// Polar angle of the port's middle from the crest, in rad.
    pub angle_rad: f64,
    /// Diameter of a hole in m; null for a kidney.
    pub diameter_m: Option<f64>,
    /// Distance of a hole's centre from the axis, in m; null for a kidney.
    pub pitch_radius_m: Option<f64>,
    /// Inner radius of a kidney in m; null for a hole.
    pub inner_radius_m: Option<f64>,
    /// Outer radius of a kidney in m; null for a hole.
    pub outer_radius_m: Option<f64>,
    /// Angle from end to end of a kidney, in rad; null for a hole.
    pub span_rad: Option<f64>,
    /// Corner radius of a kidney in m; null for a hole.
    pub corner_radius_m: Option<f64>,
    /// Area of the port in m².
    pub area_m2: f64,
    /// Widest opening of a chamber to this port and its neighbours of the same pressure, in m².
    pub widest_opening_m2: f64,
}

/// Part of a chamber's cycle with one state of opening.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PortState {
    /// Pressure to which the chamber is open.
    pub open_to: OpenTo,
    /// Phase at the beginning in rad, 0 at the greatest area.
    pub from_rad: f64,
    /// Phase at the end in rad, 0 at the greatest area.
    pub to_rad: f64,
}

/// Pressures to which a chamber is open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OpenTo {
    /// High pressure.
    High,
    /// Low pressure.
    Low,
    /// High and low pressure: a short circuit.
    Both,
    /// Neither pressure: closed.
    Neither,
}

/// Part of a cycle in which a chamber is closed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ClosedStretch {
    /// Phase at which the chamber closes, in rad, 0 at the greatest area.
    pub from_rad: f64,
    /// Phase at which the chamber opens, in rad, 0 at the greatest area.
    pub to_rad: f64,
    /// Extreme of the chamber's area within this part; null if none exists.
    pub extreme: Option<timing::AtExtreme>,
    /// Closed angle before the extreme, in rad.
    pub before_rad: f64,
    /// Closed angle after the extreme, in rad.
    pub after_rad: f64,
    /// Greatest change of pressure since the chamber closed, in Pa, negative for a decrease; null without a
    /// bulk modulus.
    pub change_pa: Option<f64>,
}

/// Chamber at an extreme of its area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ChamberExtreme {
    /// Area of the chamber in m².
    pub area_m2: f64,
    /// Second derivative of the area with respect to the rotor angle, in m².
    pub bend_m2: f64,
    /// Closed angle before the extreme in which the chamber reaches the high pressure by compression alone,
    /// in rad; null without bulk modulus and pressure.
    pub precompression_rad: Option<f64>,
}

/// Throttling of the flow by the ports of one pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Throttling {
    /// Pressure of the ports: high or low.
    pub ports: OpenTo,
    /// Smallest sum of the openings in m².
    pub smallest_opening_m2: f64,
    /// Pressure drop at the smallest opening, in Pa.
    pub drop_pa: f64,
    /// Greatest pressure drop over a revolution, in Pa.
    pub greatest_drop_pa: f64,
    /// Mean power loss in W.
    pub power_w: f64,
}

impl MadePorts {
    pub(crate) fn of(
        plate: &PortPlate,
        timing: &Timing,
        inputs: &Inputs,
        point: Point,
    ) -> Result<Self, Error> {
        let motor = plate.motor();
        let trapped = inputs.bulk_modulus.map(|modulus| plate.trapped(timing, modulus, inputs.dead_area));
        let trapped = trapped.transpose()?;
        let extremes = motor.extremes_of_chambers();
        // Incompressible oil neither needs a charge nor a closed angle to reach the pressure.
        let compression = inputs.bulk_modulus.zip(point.pressure);
        let extreme = |one: &epicyclic_hydromotor::ports::trapped::Extreme| {
            let angle =
                compression.map(|(modulus, drop)| one.precompression_angle(drop, modulus, inputs.dead_area));
            Ok::<_, Error>(ChamberExtreme {
                area_m2: si(one.area),
                bend_m2: si(one.bend),
                precompression_rad: maybe_si(angle.transpose()?),
            })
        };
        let charge = match (compression, point.width) {
            (Some((modulus, drop)), Some(width)) => {
                let charge = motor.dead_volume_charge(width, drop, modulus, inputs.dead_area)?;
                Some((si(charge), si(charge) / si(motor.displacement(width)?)))
            }
            _ => None,
        };
        let throttling = match (inputs.discharge, inputs.density, point.width, point.speed) {
            (Some(discharge), Some(density), Some(width), Some(speed)) => {
                let through = Through { width, speed, density, discharge };
                let of = |side, ports| Throttling::of(plate, side, ports, through);
                vec![of(PortSide::High, OpenTo::High)?, of(PortSide::Low, OpenTo::Low)?]
            }
            _ => vec![],
        };
        let of_side = |side: PortSide, place: usize| {
            Port::of(plate.shape(side), si(plate.port_area(side)), si(timing.widest[place].area))
        };
        Ok(Self {
            high: of_side(PortSide::High, 0),
            low: of_side(PortSide::Low, 1),
            land_m: si(plate.land()),
            cycle_rad: si(timing.cycle),
            states: states(timing),
            closed: closed(timing, trapped.as_deref()),
            extremes: [extreme(&extremes[0])?, extreme(&extremes[1])?],
            charge_m3: charge.map(|(volume, _)| volume),
            charge_share: charge.map(|(_, share)| share),
            throttling,
        })
    }

    /// Warnings about faults of the ports that the manufacturer has to correct.
    pub(in crate::motor::answer) fn warnings(&self) -> Vec<Warning> {
        let degrees = |rad: f64| format::quantity(Angle::from_si(rad), 4);
        let short = self.states.iter().filter(|state| state.open_to == OpenTo::Both);
        short
            .map(|state| Warning {
                name: "short-circuit",
                message: format!(
                    "a chamber is open to both pressures while its phase goes from {} to {}, 0 where it is greatest: make the ports smaller, or move them away from each other",
                    degrees(state.from_rad),
                    degrees(state.to_rad)
                ),
            })
            .collect()
    }
}

impl Port {
    fn of(shape: PortShape, area_m2: f64, widest_opening_m2: f64) -> Self {
        let none = Self {
            angle_rad: 0.0,
            diameter_m: None,
            pitch_radius_m: None,
            inner_radius_m: None,
            outer_radius_m: None,
            span_rad: None,
            corner_radius_m: None,
            area_m2,
            widest_opening_m2,
        };
        match shape {
            PortShape::Hole { diameter, pitch_radius, angle } => Self {
                angle_rad: si(angle),
                diameter_m: Some(si(diameter)),
                pitch_radius_m: Some(si(pitch_radius)),
                ..none
            },
            PortShape::Kidney { inner_radius, outer_radius, angle, span, corner } => Self {
                angle_rad: si(angle),
                inner_radius_m: Some(si(inner_radius)),
                outer_radius_m: Some(si(outer_radius)),
                span_rad: Some(si(span)),
                corner_radius_m: Some(si(corner)),
                ..none
            },
        }
    }
}

impl Throttling {
    fn of(plate: &PortPlate, side: PortSide, ports: OpenTo, through: Through) -> Result<Self, Error> {
        let found = plate.throttling(side, through)?;
        Ok(Self {
            ports,
            smallest_opening_m2: si(found.smallest_opening),
            drop_pa: si(found.drop),
            greatest_drop_pa: si(found.greatest_drop),
            power_w: si(found.power),
        })
    }
}

/// Lists the states of opening in the order of the phase.
fn states(timing: &Timing) -> Vec<PortState> {
    let state = |open_to| {
        move |stretch: &Stretch| PortState { open_to, from_rad: si(stretch.from), to_rad: si(stretch.to) }
    };
    let mut all: Vec<PortState> = timing.high.iter().map(state(OpenTo::High)).collect();
    all.extend(timing.low.iter().map(state(OpenTo::Low)));
    all.extend(timing.short_circuits.iter().map(state(OpenTo::Both)));
    all.extend(timing.closed.iter().map(|one| state(OpenTo::Neither)(&one.stretch)));
    // The four kinds were collected separately; by phase they form the cycle of a chamber.
    all.sort_by(|one, other| one.from_rad.total_cmp(&other.from_rad));
    all
}

fn closed(timing: &Timing, trapped: Option<&[Trapped]>) -> Vec<ClosedStretch> {
    let record = |(place, one): (usize, &timing::Closed)| ClosedStretch {
        from_rad: si(one.stretch.from),
        to_rad: si(one.stretch.to),
        extreme: one.extreme,
        before_rad: si(one.before),
        after_rad: si(one.after),
        change_pa: maybe_si(trapped.and_then(|all| all.get(place)).map(|one| one.change)),
    };
    timing.closed.iter().enumerate().map(record).collect()
}
