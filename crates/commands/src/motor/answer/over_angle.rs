//! Flow and chambers over the rotor angle.

use super::Designed;
use crate::error::Error;
use crate::shared::number::si;
use epicyclic_hydromotor::flanks::{Mesh, SealingContact};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Angle, Length};

/// Number of steps over a lobe of the rotor.
const STEPS: u32 = 720;

/// Flow and chambers over one lobe of the rotor, both ends included.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverAngle {
    /// Rotor angles in rad.
    pub angles_rad: Vec<f64>,
    /// Flow of ideal ports per width and radian, in m²; equal to the torque per width and pressure.
    pub flow_per_width_m2: Vec<f64>,
    /// Flow per width and radian with the flanks as seals, in m²; null without teeth.
    pub flank_flow_per_width_m2: Option<Vec<f64>>,
    /// Mean flow per width and radian at the pitch points, equal to that of the volumes, in m².
    pub mean_flow_per_width_m2: f64,
    /// Area of each chamber at each angle, in m².
    pub chamber_areas_m2: Vec<Vec<f64>>,
}

/// Computes flow and chambers of a motor over the rotor angle.
///
/// # Errors
/// [`Error::Motor`].
pub fn over_angle(designed: &Designed) -> Result<OverAngle, Error> {
    let motor = &designed.motor;
    let lobe = std::f64::consts::TAU / f64::from(motor.numbers().rotor_lobes());
    let angles_rad: Vec<f64> = (0..=STEPS).map(|i| lobe * f64::from(i) / f64::from(STEPS)).collect();
    let mut flow_per_width_m2 = vec![];
    let mut chamber_areas_m2: Vec<Vec<f64>> = vec![];
    for angle in angles_rad.iter().map(|angle| Angle::from_si(*angle)) {
        flow_per_width_m2.push(si(motor.flow_per_width(angle)?));
        for (index, chamber) in motor.chambers(angle)?.iter().enumerate() {
            match chamber_areas_m2.get_mut(index) {
                Some(areas) => areas.push(si(chamber.area)),
                None => chamber_areas_m2.push(vec![si(chamber.area)]),
            }
        }
    }
    let at_flanks = designed.profile.as_ref().ok().map(|profile| {
        let angles: Vec<Angle> = angles_rad.iter().map(|angle| Angle::from_si(*angle)).collect();
        profile.flank_flows_per_width(SealingContact::default(), &angles)
    });
    let at_flanks = at_flanks.transpose()?.map(|flows| flows.into_iter().map(si).collect());
    let mean_flow_per_width_m2 = si(motor.ripple().mean);
    Ok(OverAngle {
        angles_rad,
        flow_per_width_m2,
        flank_flow_per_width_m2: at_flanks,
        mean_flow_per_width_m2,
        chamber_areas_m2,
    })
}

/// Chamber and satellite over a cycle, after which they are in the same state again.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverCycle {
    /// Phases in rad, from half a cycle before to half a cycle after 0, where the chamber is greatest and the
    /// satellite at a crest.
    pub phases_rad: Vec<f64>,
    /// Pressure in the chamber in Pa, with the ports as manufactured; null in a short circuit. Empty without
    /// ports, bulk modulus or pressure.
    pub chamber_pressures_pa: Vec<Option<f64>>,
    /// Contact stress of the satellite in Pa, at its pitch point with the stator; null while it is idle.
    /// Empty without pressure or teeth.
    pub stator_contact_pa: Vec<Option<f64>>,
    /// Contact stress of the satellite in Pa, at its pitch point with the rotor; null while it is idle. Empty
    /// without pressure or teeth.
    pub rotor_contact_pa: Vec<Option<f64>>,
}

/// Computes a chamber and a satellite of a motor over their cycle.
///
/// # Errors
/// [`Error::Motor`].
pub fn over_cycle(designed: &Designed) -> Result<OverCycle, Error> {
    let motor = &designed.motor;
    let [stator, rotor] = [motor.numbers().stator_lobes(), motor.numbers().rotor_lobes()].map(f64::from);
    let cycle = std::f64::consts::TAU * (1.0 / stator + 1.0 / rotor);
    let phases_rad: Vec<f64> = (0..=STEPS).map(|i| cycle * (f64::from(i) / f64::from(STEPS) - 0.5)).collect();
    let mut chamber_pressures_pa = vec![];
    if let (Some((plate, timing)), Some(drop), Some(modulus)) =
        (&designed.made.ports, designed.pressure, designed.made.bulk_modulus)
    {
        for phase in &phases_rad {
            let phase = Angle::from_si(*phase);
            let found = plate.chamber_pressure(timing, phase, drop, modulus, designed.made.dead_area)?;
            chamber_pressures_pa.push(found.map(si));
        }
    }
    let contact = |mesh: Mesh| {
        let mut all = vec![];
        if let (Some(drop), Ok(profile)) = (designed.pressure, &designed.profile) {
            let alpha = profile.form().pressure_angle;
            for phase in &phases_rad {
                let (phase, at_pitch_point) = (Angle::from_si(*phase), Length::default());
                let pressure =
                    motor.contact_pressure(alpha, mesh, phase, at_pitch_point, drop, designed.made.modulus);
                // The motor itself carries the warning about a force that the flanks cannot hold.
                let pressure = pressure.ok().map(si).filter(|pressure| *pressure > 0.0);
                all.push(pressure);
            }
        }
        all
    };
    let (stator_contact_pa, rotor_contact_pa) = (contact(Mesh::Stator), contact(Mesh::Rotor));
    Ok(OverCycle { phases_rad, chamber_pressures_pa, stator_contact_pa, rotor_contact_pa })
}
