//! Animation of a turning motor: outlines, and the places of all parts at each angle of the rotor.
//!
//! While the rotor turns by one of its lobes, `2π/n`, each satellite moves to the place of the next one,
//! `2π/(N + n)` ahead; so does each chamber. The frames over one lobe, repeated, therefore show the motion of
//! the whole motor.

use super::Designed;
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::number::si;
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::chambers::Phase;
use epicyclic_hydromotor::satellites::{Point, Satellite};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;
use uom::si::f64::Angle;

/// Number of straight sides of each tooth, and of each wall of a chamber.
const SIDES: u32 = 24;

/// Animation of a turning motor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Moving {
    /// Whether the outlines have teeth; otherwise they are the pitch curves.
    pub has_teeth: bool,
    /// Outline of the stator in m.
    pub stator_m: Vec<[f64; 2]>,
    /// Outline of the rotor at angle 0, in m.
    pub rotor_m: Vec<[f64; 2]>,
    /// Outline of a satellite about its centre, in m.
    pub satellite_m: Vec<[f64; 2]>,
    /// Greatest diameter of the stator's pitch curve, in m.
    pub stator_diameter_m: f64,
    /// Rotor angle between two frames, in rad.
    pub step_rad: f64,
    /// Additional rotation of a satellite about its own axis after one round of the stator, in rad. The
    /// rotation jumps by this angle where the last satellite of a frame continues as the first.
    pub round_turn_rad: f64,
    /// Frames over one lobe of the rotor, without its end.
    pub frames: Vec<MovingFrame>,
}

impl Answer for Moving {
    const NAME: &'static str = "motor-moving";
}

/// Motor at one rotor angle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MovingFrame {
    /// Rotor angle in rad, counter-clockwise.
    pub rotor_rad: f64,
    /// Satellites at this angle.
    pub satellites: Vec<MovingSatellite>,
    /// Chambers at this angle.
    pub chambers: Vec<MovingChamber>,
}

/// Satellite at one rotor angle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MovingSatellite {
    /// Centre of the satellite in m.
    pub centre_m: [f64; 2],
    /// Rotation of the satellite about its own axis, in rad.
    pub turn_rad: f64,
}

/// Chamber at one rotor angle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MovingChamber {
    /// State of the chamber: filling, emptying, or changing over.
    pub state: Phase,
    /// Area of the chamber in m².
    pub area_m2: f64,
    /// Outline of the chamber in m.
    pub outline_m: Vec<[f64; 2]>,
}

/// Computes so many frames of a motor over one lobe of its rotor.
///
/// # Errors
/// [`Error::Motor`].
pub fn moving(designed: &Designed, frames: u32) -> Result<Moving, Error> {
    let motor = &designed.motor;
    let numbers = motor.numbers();
    let step_rad = TAU / f64::from(numbers.rotor_lobes()) / f64::from(frames.max(1));
    let profile = designed.profile.as_ref().ok();
    let outline = |wheel: Wheel, teeth: u32| -> Result<Vec<[f64; 2]>, Error> {
        match profile {
            Some(profile) => Ok(points(&profile.outline(wheel, SIDES * teeth)?.points)),
            None => pitch_curve(&designed.motor, wheel, SIDES * teeth),
        }
    };
    let frame = |index: u32| -> Result<MovingFrame, Error> {
        let rotor_rad = step_rad * f64::from(index);
        let rotation = Angle::from_si(rotor_rad);
        let all = motor.chambers(rotation)?;
        let satellites = motor.satellites(rotation)?.into_iter();
        let chambers = all.iter().map(|chamber| {
            Ok(MovingChamber {
                state: Phase::of(chamber, &all),
                area_m2: si(chamber.area),
                outline_m: points(&motor.chamber_outline(rotation, chamber.index, SIDES)?),
            })
        });
        Ok(MovingFrame {
            rotor_rad,
            satellites: satellites
                .map(|one| MovingSatellite { centre_m: point(&one.centre), turn_rad: si(one.rotation) })
                .collect(),
            chambers: chambers.collect::<Result<_, Error>>()?,
        })
    };
    Ok(Moving {
        has_teeth: profile.is_some(),
        stator_m: outline(Wheel::Stator, numbers.stator_teeth())?,
        rotor_m: outline(Wheel::Rotor, numbers.rotor_teeth())?,
        satellite_m: outline(Wheel::Satellite, numbers.satellite_teeth())?,
        stator_diameter_m: si(motor.envelope().stator_outer),
        step_rad,
        round_turn_rad: round_turn_rad(motor)?,
        frames: (0..frames.max(1)).map(frame).collect::<Result<_, _>>()?,
    })
}

/// Additional rotation after one round: one lobe on, the last satellite is at the place of the first one.
fn round_turn_rad(motor: &Motor) -> Result<f64, Error> {
    let lobe = Angle::from_si(TAU / f64::from(motor.numbers().rotor_lobes()));
    let (after, before) = (motor.satellites(lobe)?, motor.satellites(Angle::from_si(0.0))?);
    let turn = |one: Option<&Satellite>| one.map_or(0.0, |one| si(one.rotation));
    Ok(turn(after.last()) - turn(before.first()))
}

/// Points of a centrode; for a satellite those of its circle.
fn pitch_curve(motor: &Motor, wheel: Wheel, count: u32) -> Result<Vec<[f64; 2]>, Error> {
    let angles = (0..count).map(|index| TAU * f64::from(index) / f64::from(count));
    if wheel == Wheel::Satellite {
        let radius = si(motor.satellite_radius());
        return Ok(angles.map(|angle| [radius * libm::cos(angle), radius * libm::sin(angle)]).collect());
    }
    let curve = motor.centrode(wheel);
    let at = |angle: f64| -> Result<[f64; 2], Error> {
        let at = curve.at_polar_angle(Angle::from_si(angle))?;
        Ok([si(at.x), si(at.y)])
    };
    angles.map(at).collect()
}

fn point(at: &Point) -> [f64; 2] {
    [si(at.x), si(at.y)]
}

fn points(all: &[Point]) -> Vec<[f64; 2]> {
    all.iter().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_formats::Document;

    fn designed(file: &str) -> Designed {
        let document = Document::parse_one("m.yaml", file.as_bytes()).unwrap();
        super::super::of_file(&document).unwrap().1
    }

    const FILE: &str = "stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nl: 80 mm\n";

    #[test]
    fn a_chamber_has_the_area_of_its_outline() {
        let moving = moving(&designed(FILE), 7).unwrap();
        assert!(moving.has_teeth && moving.frames.len() == 7);
        for chamber in moving.frames.iter().flat_map(|frame| &frame.chambers) {
            let next = chamber.outline_m.iter().cycle().skip(1);
            let twice: f64 = chamber.outline_m.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
            // The outline has 24 straight sides per wall.
            assert!((0.5 * twice.abs() / chamber.area_m2 - 1.0).abs() < 5e-3, "{twice} {}", chamber.area_m2);
        }
    }

    #[test]
    fn after_one_lobe_of_the_rotor_each_satellite_stands_where_the_next_one_stood() {
        let designed = designed(FILE);
        let first = &moving(&designed, 4).unwrap().frames[0];
        let lobe = Angle::from_si(TAU / 3.0);
        let after = designed.motor.satellites(lobe).unwrap();
        let count = after.len();
        let round = moving(&designed, 1).unwrap().round_turn_rad;
        for (place, now) in after.iter().enumerate() {
            let next = &first.satellites[(place + 1) % count];
            let [x, y] = point(&now.centre);
            assert!(libm::hypot(x - next.centre_m[0], y - next.centre_m[1]) < 1e-12);
            let jump = if place + 1 == count { round } else { 0.0 };
            assert!((si(now.rotation) - next.turn_rad - jump).abs() < 1e-9, "{place}");
        }
        // Rolling once around in the ring of 55 teeth, plus the turn of the round itself.
        assert!((round + TAU * (55.0 / 10.0 - 1.0)).abs() < 1e-9, "{round}");
    }

    #[test]
    fn a_motor_without_teeth_shows_its_pitch_curves() {
        let mut designed = designed(FILE);
        designed.profile = Err(epicyclic_hydromotor::Error::NotFinite {
            quantity: epicyclic_hydromotor::quantity::Quantity::Rotation,
            value: f64::NAN,
            unit: "rad",
        });
        let moving = moving(&designed, 2).unwrap();
        assert!(!moving.has_teeth);
        let radius = si(designed.motor.satellite_radius());
        assert!(moving.satellite_m.iter().all(|[x, y]| (libm::hypot(*x, *y) - radius).abs() < 1e-12));
        let reach = moving.stator_m.iter().map(|[x, y]| libm::hypot(*x, *y)).fold(0.0, f64::max);
        assert!((2.0 * reach / moving.stator_diameter_m - 1.0).abs() < 1e-3);
    }
}
