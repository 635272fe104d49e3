//! Planetary hydromotor with non-circular gears: geometry that closes, working data, teeth.

pub(crate) mod bodies;
pub(crate) mod centrodes;
pub(crate) mod design;
pub(crate) mod faults;
pub(crate) mod flanks;
pub(crate) mod made;
pub(crate) mod moving;
pub(crate) mod over_angle;
pub(crate) mod practice;
pub(crate) mod saved;
pub(crate) mod shape;
pub(crate) mod teeth;

pub use bodies::{Chamber, Satellite};
pub use centrodes::{CentrodePoint, Centrodes, MOST_POINTS, centrodes};
pub use design::{Chosen, Designed, Question, design, of_file};
pub use flanks::{
    AllowedPressure, ContactStresses, FlankForces, Flanks, ForceAt, GoverningLimit, RootStresses,
};
pub(crate) use flanks::{contact_stresses, greatest_contact};
pub use made::losses::{Efficiency, EfficiencyMap, Friction, Gap, Leakage, Losses};
pub use made::ports::{ChamberExtreme, ClosedStretch, MadePorts, OpenTo, Port, PortState, Throttling};
pub use made::{Groups, Made};
pub(crate) use made::{Inputs, Point, steel};
pub use moving::{Moving, MovingChamber, MovingFrame, MovingSatellite, moving};
pub use over_angle::{OverAngle, OverCycle, over_angle, over_cycle};
pub use shape::{Arcs, CosineLaw, HarmonicRange, Interval, Rotor};
pub use teeth::{Between, Clearance, ToothLimit};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::{maybe_si, plain, si};
use bodies::{chambers, satellites};
use epicyclic_hydromotor::checks::{self, Subject, ToothHeights};
use epicyclic_hydromotor::ports::{IDEAL_PART, PortPlate};
use epicyclic_hydromotor::{self as hydromotor, MotorNumbers};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Force, Length};

/// Hydromotor. Angles are counter-clockwise from the x axis, which passes through a crest of the stator.
/// Torque and flow are theoretical, without leakage and friction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Motor {
    /// Numbers of lobes and teeth, and the module.
    pub numbers: Numbers,
    /// Two arcs of the stator; null for a rotor by the cosine law.
    pub arcs: Option<Arcs>,
    /// Cosine law of the rotor; null for a stator of two arcs.
    pub cosine_law: Option<CosineLaw>,
    /// Deviation of arcs from the rotor's exact curve.
    pub rotor: Rotor,
    /// Displacement, torque and flow.
    pub work: Work,
    /// Flanks under load: sealing, forces, stresses; null without teeth.
    pub flanks: Option<Flanks>,
    /// Ideal ports in the cover.
    pub ports: Ports,
    /// Ports as manufactured; null if none are described.
    pub made_ports: Option<MadePorts>,
    /// Leakage, friction, efficiencies; null if neither gaps nor friction are given.
    pub losses: Option<Losses>,
    /// Size of the centrodes.
    pub size: Size,
    /// Checks of curvatures and distances of the centrodes against satellites and tooth heights.
    pub checks: Vec<Check>,
    /// Limits of the teeth; null if the tooth form gives none for this motor.
    pub tooth_limits: Option<Vec<ToothLimit>>,
    /// Clearances of the teeth over a revolution, with satellites in the middle of their backlash; null
    /// without teeth.
    pub clearances: Option<Vec<Clearance>>,
    /// Rotor angle from the position in which a crest of the rotor faces a crest of the stator, in rad.
    pub angle_rad: f64,
    /// Chambers at that angle.
    pub chambers: Vec<Chamber>,
    /// Satellites at that angle.
    pub satellites: Vec<Satellite>,
    /// Judgement of the motor by rules of practice, with the checks of centrodes and teeth.
    pub judgement: Judgement,
    /// Warnings: misses of the judgement, the worst first, then failed checks and missing parts.
    pub warnings: Vec<Warning>,
}

/// Numbers of lobes and teeth, and the module.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Numbers {
    /// Number of lobes of the stator, `N`.
    pub stator_lobes: u32,
    /// Number of lobes of the rotor, `n`.
    pub rotor_lobes: u32,
    /// Maximum difference of the numbers of lobes, stator minus rotor.
    pub most_lobe_difference: u32,
    /// Ratio of the numbers of lobes, `N/n`.
    pub lobe_ratio: f64,
    /// Tooth number of the stator, `Z₃`.
    pub stator_teeth: u32,
    /// Tooth number of the rotor, `Z₁`.
    pub rotor_teeth: u32,
    /// Tooth number of a satellite, `Z_s`.
    pub satellite_teeth: u32,
    /// Exclusive upper limit for the tooth number of a satellite, `(Z₃ − Z₁)/2`.
    pub satellite_teeth_below: f64,
    /// Number of teeth per lobe, equal for stator and rotor.
    pub teeth_per_lobe: u32,
    /// Number of satellites and of chambers, `N + n`.
    pub satellites: u32,
    /// Greatest common divisor of `N` and `n`.
    pub common_divisor: u32,
    /// Whether the bearings of the wheels are unloaded: the common divisor is above 1.
    pub bearing_reactions_vanish: bool,
    /// Number of pulses of flow and torque per revolution of the rotor.
    pub pulses_per_revolution: u32,
    /// Module `m`, in m.
    pub module_m: f64,
    /// Pitch radius of a satellite, `r = m·Z_s/2`, in m.
    pub satellite_radius_m: f64,
}

/// Displacement, torque and flow without losses. Least and greatest values are for satellites that seal at
/// the pitch points.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Work {
    /// Least area of a chamber in m².
    pub least_chamber_m2: f64,
    /// Greatest area of a chamber in m².
    pub greatest_chamber_m2: f64,
    /// Displacement per revolution and width, in m².
    pub displacement_per_width_m2: f64,
    /// Ripple of flow and torque, `(Q_max − Q_min)/Q_mean`, if satellites seal at the pitch points;
    /// `flanks.ripple` is the ripple at the flanks.
    pub ripple: f64,
    /// Width of the wheels in m; null, like all values that depend on it, if none is given.
    pub width_m: Option<f64>,
    /// Displacement per revolution in m³; null without a width.
    pub displacement_m3: Option<f64>,
    /// Pressure drop, high minus low, in Pa; null if none is given.
    pub pressure_pa: Option<f64>,
    /// Mean torque in N·m; null without width and pressure.
    pub torque_n_m: Option<f64>,
    /// Least torque in N·m; null without width and pressure.
    pub least_torque_n_m: Option<f64>,
    /// Greatest torque in N·m; null without width and pressure.
    pub greatest_torque_n_m: Option<f64>,
    /// Greatest force on a satellite, `Δp·b·2r`, in N; null without width and pressure.
    pub greatest_satellite_force_n: Option<f64>,
    /// Speed of the rotor in rad/s; null if none is given.
    pub speed_rad_s: Option<f64>,
    /// Mean flow in m³/s; null without width and speed.
    pub flow_m3_s: Option<f64>,
    /// Least flow in m³/s; null without width and speed.
    pub least_flow_m3_s: Option<f64>,
    /// Greatest flow in m³/s; null without width and speed.
    pub greatest_flow_m3_s: Option<f64>,
    /// Power in W; null without width, pressure and speed.
    pub power_w: Option<f64>,
}

/// Ideal ports in the cover, each opened and closed by a passing satellite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Ports {
    /// Number of ports at each pressure.
    pub ports_of_each: u32,
    /// Radius of the port centres in m.
    pub centre_radius_m: Option<f64>,
    /// Angle of the first high-pressure port from a crest of the stator, in rad.
    pub high_angle_rad: Option<f64>,
    /// Angle of the first low-pressure port from a crest of the stator, in rad.
    pub low_angle_rad: Option<f64>,
    /// Diameter of the largest round hole that a satellite covers, in m; null if it covers none.
    pub greatest_diameter_m: Option<f64>,
    /// Rotation of the rotor during which a port is covered, in rad.
    pub covered_rad: f64,
    /// Rotation of the rotor during which a port is open, in rad.
    pub open_rad: f64,
}

/// Size of the centrodes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Greatest diameter of the stator's centrode, in m.
    pub stator_outer_m: f64,
    /// Least diameter of the stator's centrode, in m.
    pub stator_inner_m: f64,
    /// Greatest diameter of the rotor's centrode, in m.
    pub rotor_outer_m: f64,
    /// Least diameter of the rotor's centrode, in m.
    pub rotor_inner_m: f64,
    /// Least distance between the centres of neighbouring satellites, in m.
    pub least_neighbour_distance_m: f64,
    /// Displacement per volume of the cylinder around the stator's centrode.
    pub displacement_by_volume: f64,
}

/// Check of the centrodes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Check {
    /// Quantity that is checked.
    pub check: Subject,
    /// Value of the quantity in m.
    pub value_m: f64,
    /// Limit that the value must exceed, in m.
    pub limit_m: f64,
    /// Result of the check.
    pub verdict: Verdict,
}

/// Results of the comparison of a value with its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Within the limit.
    Holds,
    /// Within the limit, with a margin of less than a tenth of the limit.
    Near,
    /// Beyond the limit.
    Fails,
}

impl Verdict {
    fn of(holds: bool, margin: Length, bound: Length) -> Self {
        if !holds {
            Self::Fails
        } else if margin < 0.1 * bound.abs() {
            Self::Near
        } else {
            Self::Holds
        }
    }
}

impl Answer for Motor {
    const NAME: &'static str = "motor";
}

/// Computes all results for a motor.
///
/// # Errors
/// [`Error::Motor`] for an impossible width, pressure, speed or angle.
pub fn answer(designed: &Designed) -> Result<Motor, Error> {
    let motor = &designed.motor;
    let mut warnings = vec![];
    let checks = checks(designed)?;
    let (tooth_limits, clearances) = match &designed.profile {
        Ok(profile) => (Some(teeth::limits(profile)), Some(teeth::clearances(profile)?)),
        Err(error) => {
            let message = format!("no teeth of this form on this motor: {error}");
            warnings.push(Warning { name: "no-teeth", message });
            (None, None)
        }
    };
    let arcs = match &designed.family {
        Some(family) => {
            motor.arcs().map(|arcs| Arcs::of(motor, arcs, family, designed.chosen)).transpose()?
        }
        None => None,
    };
    let flanks = match designed.profile.as_ref().map(|profile| Flanks::of(designed, profile)) {
        Ok(Ok(flanks)) => Some(flanks),
        Ok(Err(Error::Motor(why @ hydromotor::Error::CannotHold { .. }))) => {
            warnings.push(Warning { name: "cannot-hold", message: why.to_string() });
            None
        }
        Ok(Err(why)) => return Err(why),
        Err(_) => None,
    };
    let made = &designed.made;
    warnings.extend(made.port_warnings());
    if made.ports.is_none()
        && let Err(why) = PortPlate::of_ideal_holes(motor, IDEAL_PART).and_then(|plate| plate.timing())
    {
        let message = format!("no ideal ports: {why}");
        warnings.push(Warning { name: "no-ideal-ports", message });
    }
    let work = Work::of(designed)?;
    let found = Motor {
        numbers: Numbers::of(motor.numbers(), motor.module()),
        arcs,
        cosine_law: motor.harmonic_law().map(|law| CosineLaw::of(motor, &law)),
        rotor: Rotor::of(motor),
        work,
        flanks,
        ports: Ports::of(motor),
        made_ports: made.port_figures.clone(),
        losses: made.losses.clone(),
        size: Size::of(motor),
        checks,
        tooth_limits,
        clearances,
        angle_rad: si(designed.angle),
        chambers: chambers(designed)?,
        satellites: satellites(designed)?,
        judgement: Judgement::default(),
        warnings: vec![],
    };
    let judgement = practice::judgement(&found, made, designed.pressure);
    let of_checks = found.checks.iter().filter_map(|one| Some((one.check.name(), one.miss()?)));
    let of_limits = found.tooth_limits.iter().flatten();
    let of_limits = of_limits.filter_map(|one| Some((one.limit.name(), one.miss()?)));
    let failed = of_checks.chain(of_limits).map(|(name, message)| Warning { name, message });
    let warnings = judgement.warnings(&[]).chain(failed).chain(warnings).collect();
    Ok(Motor { judgement, warnings, ..found })
}

impl Numbers {
    /// Record of the numbers and the module of a motor.
    #[must_use]
    pub fn of(numbers: MotorNumbers, module: Length) -> Self {
        Self {
            stator_lobes: numbers.stator_lobes(),
            rotor_lobes: numbers.rotor_lobes(),
            most_lobe_difference: hydromotor::numbers::MOST_LOBE_DIFFERENCE,
            lobe_ratio: numbers.lobe_ratio(),
            stator_teeth: numbers.stator_teeth(),
            rotor_teeth: numbers.rotor_teeth(),
            satellite_teeth: numbers.satellite_teeth(),
            satellite_teeth_below: f64::from(numbers.stator_teeth() - numbers.rotor_teeth()) / 2.0,
            teeth_per_lobe: numbers.teeth_per_lobe(),
            satellites: numbers.satellites(),
            common_divisor: numbers.common_divisor(),
            bearing_reactions_vanish: numbers.bearing_reactions_vanish(),
            pulses_per_revolution: numbers.pulses_per_revolution(),
            module_m: si(module),
            satellite_radius_m: si(0.5 * f64::from(numbers.satellite_teeth()) * module),
        }
    }
}

impl Work {
    fn of(designed: &Designed) -> Result<Self, Error> {
        let Designed { motor, width, .. } = designed;
        let ripple = motor.ripple();
        let [least, greatest] = motor.chamber_extremes();
        let [low, high] = [ripple.least, ripple.greatest].map(|flow| (flow / ripple.mean).si());
        let pressure = width.and(designed.pressure);
        let speed = width.and(designed.speed);
        let (width, satellite) = (*width, 2.0 * motor.satellite_radius());
        let torque = width.zip(pressure).map(|(width, pressure)| motor.theoretical_torque(width, pressure));
        let torque = torque.transpose()?;
        let force = width.zip(pressure).map(|(width, pressure)| Force::from(pressure * (width * satellite)));
        let flow = width.zip(speed).map(|(width, speed)| motor.mean_flow(width, speed)).transpose()?;
        let power = width.zip(pressure).zip(speed);
        let power = power.map(|((width, pressure), speed)| motor.theoretical_power(width, pressure, speed));
        let power = power.transpose()?;
        Ok(Self {
            least_chamber_m2: si(least),
            greatest_chamber_m2: si(greatest),
            displacement_per_width_m2: si(motor.displacement_per_width()),
            ripple: plain(ripple.delta),
            width_m: maybe_si(width),
            displacement_m3: maybe_si(width.map(|width| motor.displacement(width)).transpose()?),
            pressure_pa: maybe_si(pressure),
            torque_n_m: maybe_si(torque),
            least_torque_n_m: maybe_si(torque.map(|torque| torque * low)),
            greatest_torque_n_m: maybe_si(torque.map(|torque| torque * high)),
            greatest_satellite_force_n: maybe_si(force),
            speed_rad_s: maybe_si(speed),
            flow_m3_s: maybe_si(flow),
            least_flow_m3_s: maybe_si(flow.map(|flow| flow * low)),
            greatest_flow_m3_s: maybe_si(flow.map(|flow| flow * high)),
            power_w: maybe_si(power),
        })
    }
}

impl Ports {
    fn of(motor: &hydromotor::Motor) -> Self {
        let ports = motor.ports();
        let high = ports.high.first();
        let hole = high.map(|port| port.greatest_diameter).filter(|hole| *hole > Length::default());
        Self {
            ports_of_each: motor.numbers().stator_lobes(),
            centre_radius_m: high.map(|port| si(port.centre_radius)),
            high_angle_rad: high.map(|port| si(port.angle)),
            low_angle_rad: ports.low.first().map(|port| si(port.angle)),
            greatest_diameter_m: maybe_si(hole),
            covered_rad: si(ports.covered),
            open_rad: si(ports.open),
        }
    }
}

impl Size {
    fn of(motor: &hydromotor::Motor) -> Self {
        let envelope = motor.envelope();
        let (distance, _) = motor.least_neighbour_distance();
        Self {
            stator_outer_m: si(envelope.stator_outer),
            stator_inner_m: si(envelope.stator_inner),
            rotor_outer_m: si(envelope.rotor_outer),
            rotor_inner_m: si(envelope.rotor_inner),
            least_neighbour_distance_m: si(distance),
            displacement_by_volume: plain(envelope.displacement_by_volume),
        }
    }
}

fn checks(designed: &Designed) -> Result<Vec<Check>, Error> {
    // The tip of a satellite's tooth is h_a + x above its pitch circle; the roots of the wheels are h_a + c +
    // x beyond their centrodes.
    let addendum = designed.form.addendum + designed.form.shift;
    let heights = ToothHeights { addendum, dedendum: addendum + designed.form.clearance };
    let record = |check: checks::Check| Check {
        check: check.subject,
        value_m: si(check.value),
        limit_m: si(check.limit),
        verdict: Verdict::of(check.holds(), check.value - check.limit, check.limit),
    };
    Ok(designed.motor.checks(heights)?.into_iter().map(record).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::to_json;
    use epicyclic_hydromotor::MotorNumbers;
    use epicyclic_hydromotor::place::Place;
    use epicyclic_hydromotor::profile::ToothForm;
    use uom::si::f64::{Angle, AngularVelocity, Pressure};
    use uom::si::length::millimeter;
    use uom::si::pressure::megapascal;

    fn question() -> Question {
        let mm = Length::new::<millimeter>;
        Question {
            numbers: MotorNumbers::new(5, 3, 55, 10).unwrap(),
            module: mm(2.0),
            place: Place::TroughDistance(mm(80.0)),
            form: ToothForm::default(),
            width: Some(mm(50.0)),
            pressure: Some(Pressure::new::<megapascal>(20.0)),
            speed: None,
            angle: Angle::default(),
            made: Groups::default(),
        }
    }

    #[test]
    fn torque_is_displacement_times_pressure_over_a_turn() {
        let motor = answer(&design(&question()).unwrap()).unwrap();
        let work = &motor.work;
        let torque = work.displacement_m3.unwrap() * 20e6 / std::f64::consts::TAU;
        assert!((work.torque_n_m.unwrap() / torque - 1.0).abs() < 1e-12);
        assert_eq!((work.flow_m3_s, work.power_w), (None, None));
        // A satellite of r = 10 mm between the pressures: 20 MPa · 50 mm · 20 mm.
        assert!((work.greatest_satellite_force_n.unwrap() - 20_000.0).abs() < 1e-6);
        assert_eq!((motor.numbers.rotor_teeth, motor.chambers.len(), motor.satellites.len()), (33, 8, 8));
        assert!(!to_json(&motor).unwrap().contains("-0.0,"), "zero has no sign");
    }

    #[test]
    fn what_a_motor_cannot_be_given_is_told_apart() {
        let with = |change: fn(&mut Question)| {
            let mut question = question();
            change(&mut question);
            design(&question).unwrap_err()
        };
        assert!(matches!(with(|q| q.pressure = Some(Pressure::default())), Error::PressureDrop));
        assert!(matches!(with(|q| q.speed = Some(AngularVelocity::default())), Error::RotorSpeed));
        assert!(matches!(with(|q| q.place = Place::Part(2.0)), Error::Motor(_)));
        let motor = design(&question()).unwrap().motor;
        assert!(matches!(centrodes(&motor, 0), Err(Error::CentrodePoints { points: 0, .. })));
        assert_eq!(centrodes(&motor, 2).unwrap().points.len(), 2 * 2 * (5 + 3));
    }

    #[test]
    fn the_mean_of_the_flow_over_a_lobe_is_that_of_the_ripple() {
        let over_angle = over_angle(&design(&question()).unwrap()).unwrap();
        let flow = &over_angle.flow_per_width_m2[1..];
        let mean = flow.iter().sum::<f64>() / flow.len() as f64;
        assert!((mean / over_angle.mean_flow_per_width_m2 - 1.0).abs() < 1e-4, "{mean}");
        assert_eq!(over_angle.chamber_areas_m2.len(), 8);
        assert!(over_angle.chamber_areas_m2.iter().all(|areas| areas.len() == over_angle.angles_rad.len()));
    }
}
