//! Flow and chambers over the angle of the rotor.

use crate::Error;
use crate::number::si;
use epicyclic_formats::Physical as _;
use epicyclic_hydromotor::Motor;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Angle;

/// Steps through a lobe of the rotor.
const STEPS: u32 = 720;

/// Flow and chambers through one lobe of the rotor, both ends included.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverAngle {
    /// Angles of the rotor.
    pub angles_rad: Vec<f64>,
    /// Flow of ideal ports over width, a radian, at each angle; torque over width and pressure is the same.
    pub flow_per_width_m2: Vec<f64>,
    /// Its mean.
    pub mean_flow_per_width_m2: f64,
    /// Area of each chamber at each angle.
    pub chamber_areas_m2: Vec<Vec<f64>>,
}

/// Flow and chambers of a motor.
///
/// # Errors
/// [`Error::Motor`].
pub fn over_angle(motor: &Motor) -> Result<OverAngle, Error> {
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
    let mean_flow_per_width_m2 = si(motor.ripple().mean);
    Ok(OverAngle { angles_rad, flow_per_width_m2, mean_flow_per_width_m2, chamber_areas_m2 })
}
