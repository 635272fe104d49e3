//! Satellites that fit given lobes, stator teeth and a module, each with the motor in the middle of its
//! family.

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::Verdict;
use crate::motor::answer::design::profile;
use crate::motor::answer::practice;
use crate::motor::answer::shape::Interval;
use crate::motor::answer::teeth::limits;
use crate::motor::forms::answer::Form;
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::{plain, si};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::profile::limits::LimitKind;
use epicyclic_hydromotor::quantity::FamilyFault;
use epicyclic_hydromotor::{Error as MotorError, Motor, MotorNumbers};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Maximum tooth number of a stator for this list, because each satellite needs a motor with all its teeth.
const MOST_STATOR_TEETH: u32 = 240;

/// Satellites that fit a stator and a rotor, each with the motor of two arcs in the middle of its family.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorSatellites {
    /// Number of lobes of the stator, `N`.
    pub stator_lobes: u32,
    /// Number of lobes of the rotor, `n`.
    pub rotor_lobes: u32,
    /// Tooth number of the stator, `Z₃`.
    pub stator_teeth: u32,
    /// Tooth number of the rotor, `Z₁`.
    pub rotor_teeth: u32,
    /// Number of satellites and of chambers, `N + n`.
    pub satellites: u32,
    /// Module `m`, in m.
    pub module_m: f64,
    /// Exclusive upper limit for the tooth number of a satellite, `(Z₃ − Z₁)/2`.
    pub satellite_teeth_below: f64,
    /// Tooth form for which limits are checked.
    pub form: Form,
    /// Motors by increasing tooth number of a satellite.
    pub motors: Vec<SatelliteMotor>,
    /// Tooth numbers of satellites below the upper limit with which there is no such motor.
    pub without: Vec<SatellitesWithout>,
    /// Recommended tooth number of a satellite: of the motors whose teeth are within their limits, the one of
    /// greatest displacement. Null if none exists.
    pub next_satellite_teeth: Option<u32>,
    /// Judgement of the motors by rules of practice, as far as they follow from the numbers.
    pub judgement: Judgement,
    /// Warning if no motor is found, or none whose teeth are within their limits.
    pub warnings: Vec<Warning>,
}

/// Motor in the middle of the family of a satellite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SatelliteMotor {
    /// Tooth number of a satellite, `Z_s`.
    pub satellite_teeth: u32,
    /// Ranges of the distance `l` for which a motor closes.
    pub family: Vec<Interval>,
    /// Distance of the centre of arc 1 from the axis, in m.
    pub l_m: f64,
    /// Distance of the centre of arc 2 from the axis, in m.
    pub a_m: f64,
    /// Least area of a chamber in m².
    pub least_chamber_m2: f64,
    /// Displacement per revolution and width, in m².
    pub displacement_per_width_m2: f64,
    /// Ripple of flow and torque if satellites seal at the pitch points.
    pub ripple: f64,
    /// Limits that the teeth exceed; null if no teeth can be made.
    pub broken_limits: Option<Vec<BrokenLimit>>,
    /// Reason why there are no teeth; null if there are teeth.
    pub without_teeth: Option<String>,
}

/// Limit that teeth exceed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BrokenLimit {
    /// Wheel whose teeth exceed the limit.
    pub wheel: Wheel,
    /// Kind of the limit.
    pub limit: LimitKind,
}

/// Range of tooth numbers of satellites with which there is no motor, for one reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SatellitesWithout {
    /// Least tooth number of the range.
    pub from: u32,
    /// Greatest tooth number of the range.
    pub to: u32,
    /// Reason why there is no motor.
    pub reason: NoMotor,
}

/// Reasons why there is no motor with a satellite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoMotor {
    /// No motor closes: where the arcs at the troughs vanish, the satellite does not fit into the crests.
    CrestRadius,
    /// No motor closes: where the arcs at the troughs vanish, the rotor already has cusps.
    RotorCusp,
    /// No motor closes: the stator's flank is more than radial for every `l`.
    RadialFlank,
    /// In the middle of the family the rotor reaches into the stator.
    RotorInStator,
    /// In the middle of the family the least chamber has no area.
    NoChamber,
}

impl NoMotor {
    /// Reason for the refusal of a motor; refusals that are not about the satellite remain errors.
    fn of(refusal: MotorError) -> Result<Self, MotorError> {
        match refusal {
            MotorError::NoFamily { why: FamilyFault::CrestRadius } => Ok(Self::CrestRadius),
            MotorError::NoFamily { why: FamilyFault::RotorCusp } => Ok(Self::RotorCusp),
            MotorError::NoFamily { why: FamilyFault::RadialFlank } => Ok(Self::RadialFlank),
            MotorError::RotorInStator { .. } => Ok(Self::RotorInStator),
            MotorError::NoChamber { .. } => Ok(Self::NoChamber),
            other => Err(other),
        }
    }

    /// Reason in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::CrestRadius => "none closes: satellite too large for the crests",
            Self::RotorCusp => "none closes: the rotor has cusps",
            Self::RadialFlank => "none closes: the flanks are more than radial",
            Self::RotorInStator => "in the middle of the family the rotor reaches into the stator",
            Self::NoChamber => "in the middle of the family the least chamber has no area",
        }
    }
}

impl Answer for MotorSatellites {
    const NAME: &'static str = "motor-satellites";
}

/// Lists the satellites that fit a stator and a rotor; `numbers` has the smallest satellite.
///
/// # Errors
/// [`Error::TooManyToList`] for a stator with too many teeth; [`Error::Motor`] for an impossible module or
/// tooth form.
pub fn satellites_of(
    numbers: MotorNumbers,
    module: Length,
    form: ToothForm,
) -> Result<MotorSatellites, Error> {
    let (stator, teeth) = (numbers.stator_lobes(), numbers.stator_teeth());
    if teeth > MOST_STATOR_TEETH {
        return Err(Error::TooManyToList { teeth, most: MOST_STATOR_TEETH });
    }
    let bounds = Bounds {
        stator_lobes: stator..=stator,
        stator_teeth: teeth..=teeth,
        satellite_teeth: numbers.satellite_teeth()..=teeth,
    };
    let (mut motors, mut without) = (vec![], Vec::<SatellitesWithout>::new());
    let all = bounds.all()?.into_iter();
    for numbers in all.filter(|one| one.rotor_lobes() == numbers.rotor_lobes()) {
        // The family ends at limits of arcs and curvatures; its middle is far from both ends.
        let motor = Family::new(numbers, module).and_then(|family| {
            let l = family.at_part(0.5)?.trough_distance();
            Ok((Motor::of_two_arcs(numbers, module, l)?, family))
        });
        match motor {
            Ok((motor, family)) => motors.push(SatelliteMotor::of(&motor, &family, form)?),
            Err(refusal) => {
                let (teeth, reason) = (numbers.satellite_teeth(), NoMotor::of(refusal)?);
                match without.last_mut().filter(|last| last.reason == reason && last.to + 1 == teeth) {
                    Some(last) => last.to = teeth,
                    None => without.push(SatellitesWithout { from: teeth, to: teeth, reason }),
                }
            }
        }
    }
    let next = motors.iter().filter(|motor| motor.broken_limits.as_ref().is_some_and(Vec::is_empty));
    let next = next.max_by(|a, b| a.displacement_per_width_m2.total_cmp(&b.displacement_per_width_m2));
    let (name, message) = if motors.is_empty() {
        ("no-motor", "no satellite gives a motor of two arcs in the middle of its family")
    } else {
        (
            "teeth-break-limits",
            "with no satellite do the teeth of this form keep their limits; try another form",
        )
    };
    let warning = Warning { name, message: message.to_owned() };
    Ok(MotorSatellites {
        stator_lobes: stator,
        rotor_lobes: numbers.rotor_lobes(),
        stator_teeth: teeth,
        rotor_teeth: numbers.rotor_teeth(),
        satellites: numbers.satellites(),
        module_m: si(module),
        satellite_teeth_below: f64::from(teeth - numbers.rotor_teeth()) / 2.0,
        form: Form::of(&form),
        next_satellite_teeth: next.map(|motor| motor.satellite_teeth),
        judgement: judgement(&motors),
        warnings: next.is_none().then_some(warning).into_iter().collect(),
        motors,
        without,
    })
}

fn judgement(motors: &[SatelliteMotor]) -> Judgement {
    let judged = motors.iter().map(|motor| practice::Searched {
        name: format!("Z_s {}", motor.satellite_teeth),
        least_chamber_m2: Some(motor.least_chamber_m2),
        ripple: motor.ripple,
        borne: None,
    });
    practice::of_designs(None, &judged.collect::<Vec<_>>())
}

impl SatelliteMotor {
    fn of(motor: &Motor, family: &Family, form: ToothForm) -> Result<Self, Error> {
        let [least, _] = motor.chamber_extremes();
        let arcs = motor.arcs().ok_or(Error::NoArcs)?;
        let (broken_limits, without_teeth) = match profile(motor, form)? {
            Ok(profile) => {
                let limits = limits(&profile);
                let broken = limits.iter().filter(|limit| limit.verdict == Verdict::Fails);
                let broken = broken.map(|limit| BrokenLimit { wheel: limit.wheel, limit: limit.limit });
                (Some(broken.collect()), None)
            }
            Err(why) => (None, Some(why.to_string())),
        };
        Ok(Self {
            satellite_teeth: motor.numbers().satellite_teeth(),
            family: Interval::all(family),
            l_m: si(arcs.trough_distance()),
            a_m: si(arcs.crest_distance()),
            least_chamber_m2: si(least),
            displacement_per_width_m2: si(motor.displacement_per_width()),
            ripple: plain(motor.ripple().delta),
            broken_limits,
            without_teeth,
        })
    }
}
